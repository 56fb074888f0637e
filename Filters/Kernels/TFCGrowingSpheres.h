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
 * Sixteen consecutive voxels of a row grow side by side until the last one stops
 * (TFCSphereTests.h). The sums are those of differences from the mean of S_1. A box of voxels at a
 * time reads a padded copy of its surroundings: it stays in the cache, whatever the size of a row.
 * Groups whose spheres are complete skip the test for NaN, and add in the same order as others: the
 * results have the same bits, however the lattice is cut into pieces.
 *
 * Cost: about eight operations per sample and voxel while the sphere grows, twice that where
 * samples may be missing.
 */

#ifndef TFCGrowingSpheres_h
#define TFCGrowingSpheres_h

#include "TFCSphereShells.h"
#include "TFCSphereTests.h"

#include <memory>

namespace tfc
{
/**
 * Statistics of the spheres of a group, or pointers to those of all voxels.
 */
enum SphereStatistic
{
  SphereMean,
  SphereDeviation, ///< divides by n - 1; 0 for one sample
  SphereRadius,
  SphereSkewness, ///< m3 / m2^1.5; 0 where all samples are equal
  SphereKurtosis, ///< m4 / m2^2, 3 for a normal distribution and where all samples are equal
  NumberOfSphereStatistics
};

/**
 * Adds the powers of p[offsets[o] + i] - shift[i] for `count` offsets to the sums of lane i.
 * `Masked` must be true if there may be NaN.
 */
template <bool Masked>
inline void AddPowers(const float* p, const Index* offsets, Index count,
  const float* __restrict shift, PowerSums& sums)
{
  float* __restrict n = sums.Count;
  float* __restrict s1 = sums.Sum[0];
  float* __restrict s2 = sums.Sum[1];
  float* __restrict s3 = sums.Sum[2];
  float* __restrict s4 = sums.Sum[3];
  const auto term = [](float value, float center)
  { return Masked && value != value ? 0.f : value - center; };
  const auto valid = [](float value) { return value == value ? 1.f : 0.f; };
  Index o = 0;
  // Eight samples at a time: the sums are loaded and stored once, and added up pairwise.
  for (; o + 8 <= count; o += 8)
  {
    const float* __restrict q0 = p + offsets[o];
    const float* __restrict q1 = p + offsets[o + 1];
    const float* __restrict q2 = p + offsets[o + 2];
    const float* __restrict q3 = p + offsets[o + 3];
    const float* __restrict q4 = p + offsets[o + 4];
    const float* __restrict q5 = p + offsets[o + 5];
    const float* __restrict q6 = p + offsets[o + 6];
    const float* __restrict q7 = p + offsets[o + 7];
    for (int i = 0; i < Lanes; ++i)
    {
      const float c = shift[i];
      const float a = term(q0[i], c), b = term(q1[i], c), d = term(q2[i], c), e = term(q3[i], c);
      const float f = term(q4[i], c), g = term(q5[i], c), h = term(q6[i], c), j = term(q7[i], c);
      const float aa = a * a, bb = b * b, dd = d * d, ee = e * e;
      const float ff = f * f, gg = g * g, hh = h * h, jj = j * j;
      s1[i] += ((a + b) + (d + e)) + ((f + g) + (h + j));
      s2[i] += ((aa + bb) + (dd + ee)) + ((ff + gg) + (hh + jj));
      s3[i] += ((aa * a + bb * b) + (dd * d + ee * e)) + ((ff * f + gg * g) + (hh * h + jj * j));
      s4[i] +=
        ((aa * aa + bb * bb) + (dd * dd + ee * ee)) + ((ff * ff + gg * gg) + (hh * hh + jj * jj));
      if constexpr (Masked)
      {
        n[i] += ((valid(q0[i]) + valid(q1[i])) + (valid(q2[i]) + valid(q3[i]))) +
          ((valid(q4[i]) + valid(q5[i])) + (valid(q6[i]) + valid(q7[i])));
      }
    }
  }
  for (; o < count; ++o)
  {
    const float* __restrict q = p + offsets[o];
    for (int i = 0; i < Lanes; ++i)
    {
      const float a = term(q[i], shift[i]), aa = a * a;
      s1[i] += a;
      s2[i] += aa;
      s3[i] += aa * a;
      s4[i] += aa * aa;
      if constexpr (Masked)
      {
        n[i] += valid(q[i]);
      }
    }
  }
}

class GrowingSpheres
{
public:
  /**
   * For the samples [begin, end) of a lattice that holds Reach samples more on each side or ends
   * where the volume does. Values are multiplied by `scale`, a power of two, before they are raised
   * to powers, and results divided by it.
   */
  GrowingSpheres(const SphereShells& shells, const SphereTests& tests, const Index size[3],
    const Index begin[3], const Index end[3], float scale)
    : Tests(tests)
    , Ends(shells.Ends)
    , Step(shells.Step)
    , Scale(scale)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Size[a] = size[a];
      this->Begin[a] = begin[a];
      this->End[a] = end[a];
      this->Reach[a] = shells.Reach[a];
      this->BlockSize[a] = TileSize[a] + 2 * shells.Reach[a];
      this->Tiles[a] = (end[a] - begin[a] + TileSize[a] - 1) / TileSize[a];
    }
    for (const auto& o : shells.Offsets)
    {
      this->Offsets.push_back((o[2] * this->BlockSize[1] + o[1]) * this->BlockSize[0] + o[0]);
    }
    for (size_t k = 1; k < this->Ends.size(); ++k)
    {
      Full full;
      for (int i = 0; i < Lanes; ++i)
      {
        full.ShellCounts[i] = static_cast<float>(this->Ends[k] - this->Ends[k - 1]);
        full.Counts[i] = static_cast<float>(this->Ends[k]);
      }
      tests.Look(full.Counts, full.Constants);
      this->FullSpheres.push_back(full);
    }
  }

  /**
   * Number of the units of work, boxes of 64 x 8 x 4 samples.
   */
  Index GetNumberOfTiles() const { return this->Tiles[0] * this->Tiles[1] * this->Tiles[2]; }

  /**
   * The padded copy; of one thread.
   */
  struct Workspace
  {
    std::unique_ptr<float[]> Block;
  };

  /**
   * The statistics of one tile into outputs[SphereStatistic], each null or the first of the samples
   * [begin, end).
   */
  void ComputeTile(const float* volume, Index tile, float* const* outputs, Workspace& work) const
  {
    if (!work.Block)
    {
      work.Block.reset(new float[static_cast<size_t>(
        this->BlockSize[0] * this->BlockSize[1] * this->BlockSize[2])]);
    }
    const Index index[3] = { tile % this->Tiles[0], tile / this->Tiles[0] % this->Tiles[1],
      tile / (this->Tiles[0] * this->Tiles[1]) };
    Index first[3], last[3];
    for (int a = 0; a < 3; ++a)
    {
      first[a] = this->Begin[a] + index[a] * TileSize[a];
      last[a] = std::min(first[a] + TileSize[a], this->End[a]);
    }
    const bool complete = this->Copy(volume, first, work.Block.get());
    for (Index z = first[2]; z < last[2]; ++z)
    {
      for (Index y = first[1]; y < last[1]; ++y)
      {
        const bool rowInside = complete && this->IsInside(1, y, 1) && this->IsInside(2, z, 1);
        const float* row = work.Block.get() + this->Reach[0] +
          ((z - first[2] + this->Reach[2]) * this->BlockSize[1] + y - first[1] + this->Reach[1]) *
            this->BlockSize[0];
        for (Index x = first[0]; x < last[0]; x += Lanes)
        {
          const float* p = row + x - first[0];
          if (rowInside && this->IsInside(0, x, Lanes))
          {
            this->ComputeGroup<false>(p, x, y, z, outputs);
          }
          else
          {
            this->ComputeGroup<true>(p, x, y, z, outputs);
          }
        }
      }
    }
  }

private:
  static constexpr Index TileSize[3] = { 64, 8, 4 };

  struct Full
  {
    SphereTests::LaneConstants Constants;
    alignas(64) float ShellCounts[Lanes];
    alignas(64) float Counts[Lanes];
  };

  /**
   * Whether the spheres of the samples [first, first + count) along an axis lie in the lattice.
   */
  bool IsInside(int axis, Index first, Index count) const
  {
    return first >= this->Reach[axis] && first + count <= this->Size[axis] - this->Reach[axis];
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
    const Index width = this->BlockSize[0];
    const Index inside0 = std::min(std::max<Index>(-from[0], 0), width);
    const Index inside1 = std::min(std::max(this->Size[0] - from[0], inside0), width);
    for (Index z = from[2]; z < from[2] + this->BlockSize[2]; ++z)
    {
      for (Index y = from[1]; y < from[1] + this->BlockSize[1]; ++y, block += width)
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
   * The spheres around p[0] to p[15], stored as far as they are samples of the output.
   */
  template <bool MayHaveNaN>
  void ComputeGroup(const float* p, Index x, Index y, Index z, float* const* outputs) const
  {
    PowerSums sums;
    alignas(64) float shift[Lanes], radius[Lanes];
    this->Grow<MayHaveNaN>(p, sums, shift, radius);

    alignas(64) float results[NumberOfSphereStatistics][Lanes];
    const double inverseScale = 1. / static_cast<double>(this->Scale);
    for (int i = 0; i < Lanes; ++i)
    {
      const double n = sums.Count[i], inverse = 1. / n, mean = sums.Sum[0][i] * inverse;
      const double e2 = sums.Sum[1][i] * inverse, e3 = sums.Sum[2][i] * inverse;
      const double e4 = sums.Sum[3][i] * inverse, square = mean * mean;
      const double m2 = e2 - square;
      const double m3 = e3 - mean * (3. * e2 - 2. * square);
      const double m4 = e4 - mean * (4. * e3 - mean * (6. * e2 - 3. * square));
      const bool varies = m2 > 0.;
      const double divisor = varies ? m2 : 1.;
      const double variance = (varies & (n > 1.)) ? m2 * n / (n > 1. ? n - 1. : 1.) : 0.;
      results[SphereMean][i] = static_cast<float>((shift[i] + mean) * inverseScale);
      results[SphereDeviation][i] = static_cast<float>(std::sqrt(variance) * inverseScale);
      results[SphereRadius][i] = static_cast<float>(radius[i] * this->Step);
      results[SphereSkewness][i] =
        static_cast<float>(varies ? m3 / (divisor * std::sqrt(divisor)) : 0.);
      results[SphereKurtosis][i] = static_cast<float>(varies ? m4 / (divisor * divisor) : 3.);
    }
    if constexpr (MayHaveNaN)
    {
      // Always the same NaN: what arithmetic makes of one differs between instruction sets.
      const float nan = std::numeric_limits<float>::quiet_NaN();
      for (auto& statistic : results)
      {
        for (int i = 0; i < Lanes; ++i)
        {
          statistic[i] = shift[i] == shift[i] ? statistic[i] : nan;
        }
      }
    }
    const Index width = this->End[0] - this->Begin[0], height = this->End[1] - this->Begin[1];
    const Index start =
      ((z - this->Begin[2]) * height + y - this->Begin[1]) * width + x - this->Begin[0];
    const Index count = std::min<Index>(Lanes, this->End[0] - x);
    for (int s = 0; s < NumberOfSphereStatistics; ++s)
    {
      if (outputs[s])
      {
        std::copy(results[s], results[s] + count, outputs[s] + start);
      }
    }
  }

  /**
   * The sums of the accepted spheres, about `shift`, and their radii in steps.
   */
  template <bool MayHaveNaN>
  void Grow(const float* p, PowerSums& accepted, float* __restrict shift,
    float* __restrict radius) const
  {
    const Index* offsets = this->Offsets.data();
    alignas(64) std::int32_t alive[Lanes], passed[Lanes];
    PowerSums shell, total;
    SphereTests::LaneConstants constants;
    for (int i = 0; i < Lanes; ++i)
    {
      shift[i] = p[i];
      radius[i] = 0.f;
      alive[i] = p[i] == p[i];
    }
    accepted = shell = PowerSums{};
    // About an outlier the powers would lose digits: go on from the mean of S_1.
    AddPowers<MayHaveNaN>(p, offsets, this->Ends[1], shift, shell);
    for (int i = 0; i < Lanes; ++i)
    {
      const float n = MayHaveNaN ? shell.Count[i] : static_cast<float>(this->Ends[1]);
      shift[i] += shell.Sum[0][i] / n;
    }
    const Index steps = static_cast<Index>(this->FullSpheres.size());
    for (Index k = 1; k <= steps; ++k)
    {
      const Full& full = this->FullSpheres[static_cast<size_t>(k - 1)];
      shell = PowerSums{};
      const Index first = this->Ends[k - 1];
      AddPowers<MayHaveNaN>(p, offsets + first, this->Ends[k] - first, shift, shell);
      for (int i = 0; i < Lanes; ++i)
      {
        shell.Count[i] = MayHaveNaN ? shell.Count[i] : full.ShellCounts[i];
        total.Count[i] = accepted.Count[i] + shell.Count[i];
        passed[i] = alive[i];
      }
      for (int s = 0; s < 4; ++s)
      {
        for (int i = 0; i < Lanes; ++i)
        {
          total.Sum[s][i] = accepted.Sum[s][i] + shell.Sum[s][i];
        }
      }
      if (k > 1)
      {
        const SphereTests::LaneConstants* sizes = MayHaveNaN ? &constants : &full.Constants;
        if (MayHaveNaN)
        {
          this->Tests.Look(total.Count, constants);
        }
        this->Tests.TestNormality(total, *sizes, passed);
        this->Tests.TestSimilarity(accepted, shell, passed);
      }
      std::int32_t any = 0;
      for (int i = 0; i < Lanes; ++i)
      {
        accepted.Count[i] = passed[i] ? total.Count[i] : accepted.Count[i];
        radius[i] = passed[i] ? static_cast<float>(k) : radius[i];
        alive[i] = passed[i];
        any |= passed[i];
      }
      for (int s = 0; s < 4; ++s)
      {
        for (int i = 0; i < Lanes; ++i)
        {
          accepted.Sum[s][i] = passed[i] ? total.Sum[s][i] : accepted.Sum[s][i];
        }
      }
      if (!any)
      {
        break;
      }
    }
  }

  const SphereTests& Tests;
  std::vector<Index> Ends, Offsets; // as in SphereShells, in the block
  std::vector<Full> FullSpheres;    // [k - 1]: constants of a sphere without gaps and of its shell
  double Step;
  float Scale;
  Index Size[3], Begin[3], End[3], Reach[3];
  Index BlockSize[3], Tiles[3];
};
}

#endif
