// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sums over whole spheres of several sizes, with slices that the voxels of a column share.
 *
 * A sphere S_k around (x, y, z) cuts the slice z + dz in a disc around (x, y). The discs of all
 * sizes k and distances |dz| are nested: a slice is added up once, ring by ring from the centre,
 * and each disc is part of every sphere of the column that cuts it there. Spheres 7 to 10 of a
 * column take 317 samples and 72 discs a voxel that way, instead of the 3244 samples of their
 * shells.
 *
 * A disc's sums are about a sample of its own, the one at (x, y); when that is missing, the first
 * of its samples from the centre. So their rounding errors are in proportion to the sums, as those
 * of a direct summation. Neither that value nor the order of additions depends on the column's
 * other voxels: a sphere's sums have the same bits in every column that contains its voxel.
 */

#ifndef TFCSphereSlices_h
#define TFCSphereSlices_h

#include "TFCPowerSums.h"
#include "TFCSphereShells.h"

#include <cstdint>

namespace tfc
{
class SphereSlices
{
public:
  static constexpr Index MostSizes = 4; ///< spheres that share their slices

  /**
   * For the spheres S_first to S_last; `width` is the length of a row in memory.
   */
  SphereSlices(const SphereShells& shells, Index first, Index last, Index width)
    : First(first)
    , Size(last - first + 1)
  {
    struct Point
    {
      Index Nearness;
      int X, Y;
    };
    const auto& offsets = shells.Offsets;
    for (Index i = 0; i < shells.Ends[last]; ++i)
    {
      for (int a = 0; a < 3; ++a)
      {
        this->Reach[a] = std::max<Index>(this->Reach[a], offsets[i][a]);
      }
    }
    const Index row = 2 * this->Reach[0] + 1;
    std::vector<Point> points(row * (2 * this->Reach[1] + 1));
    const Index distances = this->Reach[2] + 1;
    std::vector<Index> counts(distances * this->Size, 0); // points in the disc of size and distance
    for (Index k = 1; k <= last; ++k)
    {
      const Index level = std::max<Index>(k - first, 0);
      for (Index i = shells.Ends[k - 1]; i < shells.Ends[k]; ++i)
      {
        const auto& o = offsets[i];
        if (o[2] >= 0)
        {
          // The smaller the distance from the axis, the more discs have the point.
          Point& point = points[(o[1] + this->Reach[1]) * row + o[0] + this->Reach[0]];
          point.Nearness += this->Size - level;
          point.X = o[0];
          point.Y = o[1];
          for (Index l = level; l < this->Size; ++l)
          {
            ++counts[l * distances + o[2]];
          }
        }
      }
    }
    std::stable_sort(points.begin(), points.end(),
      [](const Point& a, const Point& b) { return a.Nearness > b.Nearness; });
    for (const Point& point : points)
    {
      if (point.Nearness > 0)
      {
        this->Offsets.push_back(point.Y * width + point.X);
      }
    }
    this->Ends = counts;
    std::sort(this->Ends.begin(), this->Ends.end());
    this->Ends.erase(std::unique(this->Ends.begin(), this->Ends.end()), this->Ends.end());
    if (this->Ends.front() == 0)
    {
      this->Ends.erase(this->Ends.begin());
    }
    for (const Index count : counts)
    {
      // -1: none.
      this->Discs.push_back(
        std::upper_bound(this->Ends.begin(), this->Ends.end(), count) - this->Ends.begin() - 1);
    }
  }

  Index GetFirst() const { return this->First; }
  Index GetSize() const { return this->Size; }
  const Index* GetReach() const { return this->Reach; }
  Index GetNumberOfDiscs() const { return static_cast<Index>(this->Ends.size()); }

  /**
   * Sums of the discs around p[i], as far as spheres at `distance` slices and more need them, about
   * center[i], which is set. `Gaps` must be true if there may be NaN.
   */
  template <bool Gaps>
  void SumDiscs(const float* p, Index distance, PowerSums* discs, float* __restrict center) const
  {
    const Index* offsets = this->Offsets.data();
    const Index last = this->Discs[(this->Size - 1) * (this->Reach[2] + 1) + distance];
    for (int i = 0; i < Lanes; ++i)
    {
      center[i] = p[i];
    }
    if constexpr (Gaps)
    {
      FindCenters(p, offsets, this->Ends[last], center);
    }
    PowerSums sums{};
    Index begin = 0;
    for (Index disc = 0; disc <= last; ++disc)
    {
      const Index end = this->Ends[disc];
      AddPowers<Gaps>(p, offsets + begin, end - begin, center, sums);
      if constexpr (!Gaps)
      {
        std::fill(sums.Count, sums.Count + Lanes, static_cast<float>(end));
      }
      discs[disc] = sums;
      begin = end;
    }
  }

  /**
   * Adds the discs at `distance` to the sums of spheres First, First + 1, ... about shift[i].
   */
  void AddDiscs(const PowerSums* discs, const float* center, Index distance, const float* shift,
    PowerSums* spheres) const
  {
    for (Index k = 0; k < this->Size; ++k)
    {
      const Index disc = this->Discs[k * (this->Reach[2] + 1) + distance];
      if (disc >= 0)
      {
        AddShifted(discs[disc], center, shift, spheres[k]);
      }
    }
  }

private:
  static void FindCenters(const float* p, const Index* offsets, Index count,
    float* __restrict center)
  {
    std::int32_t missing = 1;
    for (Index o = 0; o < count && missing; ++o)
    {
      const float* __restrict q = p + offsets[o];
      missing = 0;
      for (int i = 0; i < Lanes; ++i)
      {
        center[i] = center[i] == center[i] ? center[i] : q[i];
        missing |= center[i] != center[i];
      }
    }
    for (int i = 0; i < Lanes; ++i)
    {
      center[i] = center[i] == center[i] ? center[i] : 0.f;
    }
  }

  Index First, Size;
  Index Reach[3] = {};
  std::vector<Index> Offsets; // in a slice, nearest first
  std::vector<Index> Ends;    // of the discs in Offsets
  std::vector<Index> Discs;   // [size, distance]: disc, or -1 if the sphere does not reach so far
};
}

#endif
