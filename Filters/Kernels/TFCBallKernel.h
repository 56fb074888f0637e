// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Weights of a ball of lattice points, and their sum inside a lattice.
 *
 * The ball holds the offsets o with |(o_x h_x, o_y h_y, o_z h_z)| <= R, h the distance of the
 * samples. Weight as a function of q = |.| / R:
 *   constant  1
 *   linear    1 - q / (1 + e), with e = one h_min / R, so that the outermost sample counts
 *   gaussian  exp(-2 q^2), a standard deviation of R / 2
 *
 * Weights are even along each axis, so that an octant says everything. Offsets that no pair of
 * samples of the lattice has are left out: a radius beyond the lattice changes nothing.
 *
 * Memory: 16 bytes per offset of the octant.
 */

#ifndef TFCBallKernel_h
#define TFCBallKernel_h

#include "TFCGradient.h"
#include "TFCVector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tfc
{
enum class DistanceWeight
{
  Constant,
  Linear,
  Gaussian
};

class BallKernel
{
public:
  /**
   * Ball of radius `radius` > 0 for a lattice of `size` samples at distances `spacing` > 0.
   */
  BallKernel(const Index size[3], const double spacing[3], double radius, DistanceWeight weight)
  {
    double smallest = spacing[0];
    for (int a = 0; a < 3; ++a)
    {
      smallest = std::min(smallest, spacing[a]);
      // The tolerance lets a radius of 3 spacings reach the third neighbour whatever 3 h rounds to.
      const double reach = std::floor(radius / spacing[a] * (1. + 1e-9));
      this->Reach[a] = static_cast<Index>(std::min(reach, static_cast<double>(size[a] - 1)));
      this->Size[a] = size[a];
    }
    const Index nx = this->Reach[0] + 1, ny = this->Reach[1] + 1, nz = this->Reach[2] + 1;
    this->Weights.resize(static_cast<size_t>(nx * ny * nz));
    this->Cumulated.resize(this->Weights.size());
    const double largest = (1. + 1e-9) * (1. + 1e-9) * radius * radius;
    for (Index z = 0, i = 0; z < nz; ++z)
    {
      for (Index y = 0; y < ny; ++y)
      {
        const double dy = static_cast<double>(y) * spacing[1];
        const double dz = static_cast<double>(z) * spacing[2];
        for (Index x = 0; x < nx; ++x, ++i)
        {
          const double dx = static_cast<double>(x) * spacing[0];
          const double square = dx * dx + dy * dy + dz * dz;
          double w = square <= largest ? 1. : 0.;
          if (weight == DistanceWeight::Linear)
          {
            w *= std::max(0., 1. - std::sqrt(square) / (radius + smallest));
          }
          else if (weight == DistanceWeight::Gaussian)
          {
            w *= std::exp(-2. * square / (radius * radius));
          }
          this->Weights[i] = w;
          // The planes through the centre are shared by two octants.
          this->Cumulated[i] = w * (x ? 1. : .5) * (y ? 1. : .5) * (z ? 1. : .5);
        }
      }
    }
    this->Cumulate(1, nx, nx * ny * nz);
    this->Cumulate(nx, ny, nx * ny * nz);
    this->Cumulate(nx * ny, nz, nx * ny * nz);
  }

  ///@{
  /**
   * Largest offset along an axis.
   */
  Index GetReach(int axis) const { return this->Reach[axis]; }
  const Index* GetReach() const { return this->Reach; }
  ///@}

  /**
   * For each sample [x0, x1) of row (y, z) of the lattice: the sum of the weights of the part of
   * the ball around it that lies in the lattice. `profile` is scratch.
   */
  template <typename Real>
  void SumRow(Index y, Index z, Index x0, Index x1, std::vector<Real>& profile, Real* sums) const
  {
    const Index nx = this->Reach[0] + 1, last = this->Size[0] - 1;
    const auto side = [this, nx](Index dy, Index dz)
    { return this->Cumulated.data() + (dz * (this->Reach[1] + 1) + dy) * nx; };
    const double* a = side(this->Low(1, y), this->Low(2, z));
    const double* b = side(this->High(1, y), this->Low(2, z));
    const double* c = side(this->Low(1, y), this->High(2, z));
    const double* d = side(this->High(1, y), this->High(2, z));
    // The sum on one side of a sample, by the number of samples there are: from the reach on it
    // stays.
    profile.resize(static_cast<size_t>(nx));
    Real* __restrict profiles = profile.data();
    for (Index x = 0; x < nx; ++x)
    {
      profiles[x] = static_cast<Real>((a[x] + b[x]) + (c[x] + d[x]));
    }
    const Real whole = profiles[nx - 1];
    const Index low = std::clamp(nx - 1, x0, x1), high = std::clamp(last - nx + 1, x0, x1);
    Real* __restrict to = sums;
    for (Index x = x0; x < low; ++x)
    {
      to[x - x0] = profiles[x];
    }
    std::fill(to + (low - x0), to + (x1 - x0), whole);
    for (Index x = x0; x < high; ++x)
    {
      to[x - x0] += whole;
    }
    for (Index x = high; x < x1; ++x)
    {
      to[x - x0] += profiles[last - x];
    }
  }

  /**
   * Weight of the offset (x, y, z), 0 <= x <= GetReach(0) and so on.
   */
  double GetWeight(Index x, Index y, Index z) const
  {
    return this->Weights[(z * (this->Reach[1] + 1) + y) * (this->Reach[0] + 1) + x];
  }

private:
  Index Low(int axis, Index i) const { return std::min(i, this->Reach[axis]); }
  Index High(int axis, Index i) const
  {
    return std::min(this->Size[axis] - 1 - i, this->Reach[axis]);
  }

  /// Running sums along the axis with the given stride and length.
  void Cumulate(Index stride, Index length, Index total)
  {
    for (Index line = 0; line < total; line += stride * length)
    {
      for (Index i = line + stride; i < line + stride * length; ++i)
      {
        this->Cumulated[i] += this->Cumulated[i - stride];
      }
    }
  }

  Index Size[3], Reach[3];
  std::vector<double> Weights;   // of the octant of offsets >= 0
  std::vector<double> Cumulated; // sums from the centre to an offset, each axis counting 0 half
};
}

#endif
