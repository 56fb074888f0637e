// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lattice points of a sphere, sorted by the step of its growth at which they enter.
 *
 * S_k = { o : |o * spacing| <= k h } for k = 1, 2, ... while k h <= radius. The step h is the
 * smallest spacing among the axes with more than one sample (1 on a lattice counted in voxels).
 * Shell k holds S_k without S_(k-1); shell 1 is the whole of S_1, centre included. Offsets that no
 * voxel of the volume can have inside of it, as along an axis with one sample, are left out.
 *
 * On a cubic lattice S_k has 7, 33, 123, 257, 515, 925, 1419, 2109, 3071, 4169 points.
 * Memory: 12 bytes a point.
 */

#ifndef TFCSphereShells_h
#define TFCSphereShells_h

#include "TFCGradient.h"

#include <array>
#include <vector>

namespace tfc
{
struct SphereShells
{
  double Step = 1.;                        ///< h
  Index NumberOfShells = 0;                ///< largest k; 0 when the radius is below the step
  Index Reach[3] = {};                     ///< largest offset along each axis
  std::vector<std::array<int, 3>> Offsets; ///< x, y, z; by shell, then z, y, x
  std::vector<Index> Ends;                 ///< Ends[k]: number of offsets in S_k; Ends[0] is 0

  /**
   * Sets all but the points.
   */
  SphereShells(const Index wholeSize[3], const double spacing[3], double radius)
    : SphereShells(wholeSize, spacing, radius, false)
  {
  }

  static SphereShells Make(const Index wholeSize[3], const double spacing[3], double radius)
  {
    return SphereShells(wholeSize, spacing, radius, true);
  }

  /**
   * About how many points there are at most.
   */
  double EstimateSize() const
  {
    double box = 1.;
    for (const Index reach : this->Reach)
    {
      box *= 2. * static_cast<double>(reach) + 1.;
    }
    return box;
  }

private:
  SphereShells(const Index wholeSize[3], const double spacing[3], double radius, bool points)
  {
    double smallest = std::numeric_limits<double>::max();
    for (int a = 0; a < 3; ++a)
    {
      smallest = wholeSize[a] > 1 ? std::min(smallest, spacing[a]) : smallest;
    }
    this->Step = smallest < std::numeric_limits<double>::max()
      ? smallest
      : std::min(spacing[0], std::min(spacing[1], spacing[2]));
    // Spacings are products of rounded numbers: a point on the sphere belongs to it.
    constexpr double slack = 1. + 1e-9;
    // The bound keeps absurd radii within integers: no volume has so many samples along an axis.
    this->NumberOfShells =
      static_cast<Index>(std::min(std::floor(radius / this->Step * slack), 1e9));
    const double largest = static_cast<double>(this->NumberOfShells) * this->Step * slack;
    for (int a = 0; a < 3; ++a)
    {
      this->Reach[a] =
        static_cast<Index>(std::min(largest / spacing[a], static_cast<double>(wholeSize[a] - 1)));
    }
    if (points)
    {
      this->AddPoints(spacing, slack);
    }
  }

  void AddPoints(const double spacing[3], double slack)
  {
    this->Ends.assign(static_cast<size_t>(this->NumberOfShells) + 1, 0);
    const auto forEach = [&](auto&& use)
    {
      for (Index z = -this->Reach[2]; z <= this->Reach[2]; ++z)
      {
        for (Index y = -this->Reach[1]; y <= this->Reach[1]; ++y)
        {
          for (Index x = -this->Reach[0]; x <= this->Reach[0]; ++x)
          {
            const double dx = x * spacing[0], dy = y * spacing[1], dz = z * spacing[2];
            const double length = std::sqrt(dx * dx + dy * dy + dz * dz) / this->Step;
            const Index shell = std::max<Index>(1, static_cast<Index>(std::ceil(length / slack)));
            if (shell <= this->NumberOfShells)
            {
              use(static_cast<size_t>(shell),
                { static_cast<int>(x), static_cast<int>(y), static_cast<int>(z) });
            }
          }
        }
      }
    };
    using Offset = std::array<int, 3>;
    forEach([&](size_t shell, const Offset&) { ++this->Ends[shell]; });
    for (size_t k = 1; k < this->Ends.size(); ++k)
    {
      this->Ends[k] += this->Ends[k - 1];
    }
    this->Offsets.resize(static_cast<size_t>(this->Ends.back()));
    std::vector<Index> next = this->Ends;
    forEach([&](size_t shell, const Offset& offset)
      { this->Offsets[static_cast<size_t>(next[shell - 1]++)] = offset; });
  }
};
}

#endif
