// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Statistics of the largest sphere around each voxel that looks like one normal population.
 *
 * Section 4.3 of Zhou, Schott and Hansen (2012), after Haidacher et al. (2010). Spheres S_1, S_2,
 * ... grow by shells (TFCSphereShells.h). S_1 is accepted as it is; S_k replaces S_(k-1) if
 * - the samples of S_k, unless fewer than 8, pass D'Agostino's K-squared test (TFCNormality.h),
 * - and those of S_(k-1) and of the shell S_k \ S_(k-1) pass Welch's test (TFCWelch.h),
 *
 * both at level alpha. Growth stops at the first failure or at the largest radius. Results are the
 * moments of the last accepted sphere and its radius k h. Samples outside of the lattice and NaN
 * take no part; a NaN voxel gets NaN.
 *
 * Voxels come in groups of sixteen of a row (TFCSphereGrowth.h), and groups in columns along z. The
 * first three spheres, where most growth ends, are summed up shell by shell. Then all voxels of a
 * column that still grow get the sums of the next four spheres at once, from slices that they share
 * (TFCSphereSlices.h); and so on. A box of voxels at a time reads a padded copy of its
 * surroundings: it stays in the cache, whatever the size of a row. Groups whose spheres are
 * complete skip the test for NaN, and add in the same order as others, and no sum depends on other
 * voxels' growth: the results have the same bits, however the lattice is cut into pieces.
 *
 * Cost: 123 samples for the first three spheres; then for each four spheres up to S_k, in a column
 * that still grows, the pi k^2 samples of a disc and as many as 8 k additions of discs a voxel.
 * That is about 450 samples and 140 discs for k = 10, of a sphere of 4169. A voxel that grows on
 * alone in its column costs as much as its spheres have samples. Twice that where samples may be
 * missing.
 */

#ifndef TFCGrowingSpheres_h
#define TFCGrowingSpheres_h

#include "TFCSphereGrowth.h"
#include "TFCSphereSlices.h"

#include <memory>

namespace tfc
{
class GrowingSpheres
{
public:
  /**
   * Spheres that are summed up shell by shell.
   */
  static constexpr Index Direct = 3;

  /**
   * For the samples [begin, end) of a lattice that holds Reach samples more on each side or ends
   * where the volume does. Values are multiplied by `scale`, a power of two, before they are raised
   * to powers, and results divided by it. With another `direct` than the default, the other way of
   * summing begins at another sphere: results agree but for rounding.
   */
  GrowingSpheres(const SphereShells& shells, const SphereTests& tests, const Index size[3],
    const Index begin[3], const Index end[3], float scale, Index direct = Direct)
    : Box(shells, begin, end)
    , Growth(shells, tests, std::min(direct, shells.NumberOfShells), this->Box.Block[0],
        this->Box.Block[0] * this->Box.Block[1])
    , Scale(scale)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Size[a] = size[a];
      this->Begin[a] = begin[a];
      this->End[a] = end[a];
      this->Reach[a] = shells.Reach[a];
      this->Tiles[a] = (end[a] - begin[a] + this->Box.Tile[a] - 1) / this->Box.Tile[a];
    }
    for (Index k = direct + 1; k <= shells.NumberOfShells; k += SphereSlices::MostSizes)
    {
      const Index last = std::min(k + SphereSlices::MostSizes - 1, shells.NumberOfShells);
      this->Slices.emplace_back(shells, k, last, this->Box.Block[0]);
    }
  }

  /**
   * Number of the units of work, boxes of at most 64 x 8 x 64 samples.
   */
  Index GetNumberOfTiles() const { return this->Tiles[0] * this->Tiles[1] * this->Tiles[2]; }

  /**
   * About how long a tile takes at most, in seconds.
   */
  static double EstimateSeconds(const SphereShells& shells, const Index begin[3],
    const Index end[3])
  {
    const Boxes box(shells, begin, end);
    return static_cast<double>(box.Tile[1]) * box.SecondsPerRow;
  }

  /**
   * Bytes of a thread's workspace.
   */
  static double EstimateBytes(const SphereShells& shells, const Index begin[3], const Index end[3])
  {
    const Boxes box(shells, begin, end);
    double block = sizeof(float);
    for (const Index length : box.Block)
    {
      block *= static_cast<double>(length);
    }
    const double discs = static_cast<double>(SphereSlices::MostSizes * (shells.Reach[2] + 1));
    return block + static_cast<double>(sizeof(Spheres) + sizeof(SphereGroup)) * box.Tile[2] +
      discs * sizeof(PowerSums);
  }

  using Spheres = std::array<PowerSums, SphereSlices::MostSizes>;

  /**
   * A padded copy and the state of a column of groups; of one thread.
   */
  struct Workspace
  {
    std::unique_ptr<float[]> Block;
    std::vector<SphereGroup> Groups;
    std::vector<Spheres> Sums;
    std::vector<PowerSums> Discs;
  };

  /**
   * The statistics of one tile into outputs[SphereStatistic], each null or the first of the samples
   * [begin, end).
   */
  void ComputeTile(const float* volume, Index tile, float* const* outputs, Workspace& work) const
  {
    this->Prepare(work);
    const Index index[3] = { tile % this->Tiles[0], tile / this->Tiles[0] % this->Tiles[1],
      tile / (this->Tiles[0] * this->Tiles[1]) };
    Index first[3], last[3];
    for (int a = 0; a < 3; ++a)
    {
      first[a] = this->Begin[a] + index[a] * this->Box.Tile[a];
      last[a] = std::min(first[a] + this->Box.Tile[a], this->End[a]);
    }
    const bool complete = this->Copy(volume, first, work.Block.get());
    const float* corner = work.Block.get() + this->Reach[0] +
      (this->Reach[2] * this->Box.Block[1] + this->Reach[1]) * this->Box.Block[0];
    for (Index x = first[0]; x < last[0]; x += Lanes)
    {
      for (Index y = first[1]; y < last[1]; ++y)
      {
        const Column column{ corner + (y - first[1]) * this->Box.Block[0] + x - first[0], x, y,
          first[2], last[2] - first[2], complete };
        this->ComputeColumn(column, work);
        this->Store(column, work.Groups.data(), outputs);
      }
    }
  }

private:
  /**
   * The sizes of a tile and of its padded copy.
   */
  struct Boxes
  {
    Index Tile[3] = { 64, 8, 64 }, Block[3];
    double SecondsPerRow; // 64 columns at most

    Boxes(const SphereShells& shells, const Index begin[3], const Index end[3])
    {
      // About 1.5 ns per sample of a group. All slices of all sizes, as if none were skipped.
      const double height = static_cast<double>(std::min(this->Tile[2], end[2] - begin[2]));
      const double radius = static_cast<double>(shells.NumberOfShells);
      const double disc = 4. * static_cast<double>((shells.Reach[0] + 1) * (shells.Reach[1] + 1));
      const double slices = height + 2. * static_cast<double>(shells.Reach[2]);
      const double times = radius / static_cast<double>(SphereSlices::MostSizes) + 1.;
      this->SecondsPerRow = 6e-9 *
        (times * slices * disc / 3. +
          height * (200. + 6. * radius * static_cast<double>(shells.Reach[2] + 1)));
      // Not longer than a user waits for after an abort.
      this->Tile[1] = static_cast<Index>(std::clamp(0.1 / this->SecondsPerRow, 1., 8.));
      for (int a = 0; a < 3; ++a)
      {
        // Along x groups are complete.
        this->Tile[a] =
          a > 0 ? std::max<Index>(1, std::min(this->Tile[a], end[a] - begin[a])) : this->Tile[a];
        this->Block[a] = this->Tile[a] + 2 * shells.Reach[a];
      }
    }
  };

  /**
   * Groups at (x, y, z) to (x, y, z + count - 1).
   */
  struct Column
  {
    const float* Samples; // the first lane of the first group, in the padded copy
    Index X, Y, Z, Count;
    bool Complete; // there is no NaN in the lattice nearby
  };

  void Prepare(Workspace& work) const
  {
    if (!work.Block)
    {
      const auto height = static_cast<size_t>(this->Box.Tile[2]);
      work.Block.reset(new float[static_cast<size_t>(
        this->Box.Block[0] * this->Box.Block[1] * this->Box.Block[2])]);
      work.Groups.resize(height);
      Index discs = 0;
      for (const SphereSlices& slices : this->Slices)
      {
        discs = std::max(discs, slices.GetNumberOfDiscs());
      }
      work.Discs.resize(static_cast<size_t>(discs));
      work.Sums.resize(discs ? height : 0);
    }
  }

  /**
   * Whether everything within `reach` of a column lies in the lattice: in its slices, and of the
   * group `z` of it also in others.
   */
  bool IsInside(const Column& column, const Index* reach) const
  {
    return column.X >= reach[0] && column.X + Lanes <= this->Size[0] - reach[0] &&
      column.Y >= reach[1] && column.Y < this->Size[1] - reach[1];
  }
  bool IsInside(const Column& column, const Index* reach, Index z) const
  {
    return this->IsInside(column, reach) && column.Z + z >= reach[2] &&
      column.Z + z < this->Size[2] - reach[2];
  }

  /**
   * The surroundings of the tile that begins at `first`, scaled, NaN outside of the lattice.
   * Returns whether there is no NaN inside of it.
   */
  bool Copy(const float* volume, const Index first[3], float* block) const
  {
    const float nan = std::numeric_limits<float>::quiet_NaN(), scale = this->Scale;
    std::int32_t gaps = 0;
    const Index from[3] = { first[0] - this->Reach[0], first[1] - this->Reach[1],
      first[2] - this->Reach[2] };
    // Parts of a row before, inside and after the lattice.
    const Index width = this->Box.Block[0];
    const Index inside0 = std::min(std::max<Index>(-from[0], 0), width);
    const Index inside1 = std::min(std::max(this->Size[0] - from[0], inside0), width);
    for (Index z = from[2]; z < from[2] + this->Box.Block[2]; ++z)
    {
      for (Index y = from[1]; y < from[1] + this->Box.Block[1]; ++y, block += width)
      {
        if (z < 0 || z >= this->Size[2] || y < 0 || y >= this->Size[1])
        {
          std::fill(block, block + width, nan);
          continue;
        }
        const float* in = volume + (z * this->Size[1] + y) * this->Size[0] + from[0];
        std::fill(block, block + inside0, nan);
        for (Index x = inside0; x < inside1; ++x)
        {
          block[x] = in[x] * scale;
          gaps |= in[x] != in[x];
        }
        std::fill(block + inside1, block + width, nan);
      }
    }
    return gaps == 0;
  }

  /**
   * The spheres of a column into work.Groups.
   */
  void ComputeColumn(const Column& column, Workspace& work) const
  {
    const Index slice = this->Box.Block[0] * this->Box.Block[1];
    SphereGroup* groups = work.Groups.data();
    bool alive = false;
    for (Index z = 0; z < column.Count; ++z)
    {
      const float* p = column.Samples + z * slice;
      if (column.Complete && this->IsInside(column, this->Growth.GetReach(), z))
      {
        this->Growth.Begin<false>(p, groups[z]);
      }
      else
      {
        this->Growth.Begin<true>(p, groups[z]);
      }
      alive |= groups[z].AnyAlive;
    }
    for (size_t s = 0; s < this->Slices.size() && alive; ++s)
    {
      const SphereSlices& slices = this->Slices[s];
      const Index* reach = slices.GetReach();
      if (column.Complete && this->IsInside(column, reach))
      {
        this->AddSlices<false>(slices, column, work);
      }
      else
      {
        this->AddSlices<true>(slices, column, work);
      }
      alive = false;
      for (Index z = 0; z < column.Count; ++z)
      {
        if (groups[z].AnyAlive)
        {
          const PowerSums* sums = work.Sums[static_cast<size_t>(z)].data();
          if (column.Complete && this->IsInside(column, reach, z))
          {
            this->Growth.GoOn<false>(slices.GetFirst(), slices.GetSize(), sums, groups[z]);
          }
          else
          {
            this->Growth.GoOn<true>(slices.GetFirst(), slices.GetSize(), sums, groups[z]);
          }
          alive |= groups[z].AnyAlive;
        }
      }
    }
  }

  /**
   * The sums of the spheres of all groups of a column that still grow.
   */
  template <bool Gaps>
  void AddSlices(const SphereSlices& slices, const Column& column, Workspace& work) const
  {
    const SphereGroup* groups = work.Groups.data();
    const Index count = column.Count, reach = slices.GetReach()[2];
    for (Index z = 0; z < count; ++z)
    {
      if (groups[z].AnyAlive)
      {
        work.Sums[static_cast<size_t>(z)] = {};
      }
    }
    alignas(64) float center[Lanes];
    const Index end = std::min(count + reach, this->Size[2] - column.Z);
    for (Index slice = std::max(-reach, -column.Z); slice < end; ++slice)
    {
      const Index low = std::max<Index>(slice - reach, 0);
      const Index high = std::min(slice + reach + 1, count);
      Index nearest = reach + 1;
      for (Index z = low; z < high; ++z)
      {
        nearest = groups[z].AnyAlive ? std::min(nearest, std::abs(z - slice)) : nearest;
      }
      if (nearest > reach)
      {
        continue;
      }
      const float* p = column.Samples + slice * this->Box.Block[0] * this->Box.Block[1];
      slices.SumDiscs<Gaps>(p, nearest, work.Discs.data(), center);
      for (Index z = low; z < high; ++z)
      {
        if (groups[z].AnyAlive)
        {
          slices.AddDiscs(work.Discs.data(), center, std::abs(z - slice), groups[z].Shift,
            work.Sums[static_cast<size_t>(z)].data());
        }
      }
    }
  }

  /**
   * Writes the statistics of a column as far as they are samples of the output.
   */
  void Store(const Column& column, const SphereGroup* groups, float* const* outputs) const
  {
    const Index width = this->End[0] - this->Begin[0], height = this->End[1] - this->Begin[1];
    const Index count = std::min<Index>(Lanes, this->End[0] - column.X);
    Index start = ((column.Z - this->Begin[2]) * height + column.Y - this->Begin[1]) * width +
      column.X - this->Begin[0];
    for (Index z = 0; z < column.Count; ++z, start += width * height)
    {
      alignas(64) float results[NumberOfSphereStatistics][Lanes];
      this->Growth.GetStatistics(groups[z], this->Scale, results);
      for (int s = 0; s < NumberOfSphereStatistics; ++s)
      {
        if (outputs[s])
        {
          std::copy(results[s], results[s] + count, outputs[s] + start);
        }
      }
    }
  }

  Boxes Box;
  SphereGrowth Growth;
  std::vector<SphereSlices> Slices; // of the spheres beyond the direct ones
  float Scale;
  Index Size[3], Begin[3], End[3], Reach[3], Tiles[3];
};
}

#endif
