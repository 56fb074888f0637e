// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Statistics of the largest sphere around each voxel that looks like one normal population.
 *
 * Section 4.3 of Zhou, Schott and Hansen (2012), after Haidacher et al. (2010). Spheres S_1, S_2,
 * ... grow by shells (TFCSphereShells.h). S_1 is accepted as it is; S_k replaces S_(k-1) if
 * - the samples of S_k pass D'Agostino's K-squared test (TFCNormality.h; not asked of fewer than
 * 8),
 * - and those of S_(k-1) and of the shell S_k \ S_(k-1) Welch's test (TFCWelch.h),
 * both at level alpha. Growth stops at the first failure or at the largest radius. Results are the
 * moments of the last accepted sphere and its radius k h. Samples outside of the lattice and NaN
 * take no part; a NaN voxel gets NaN.
 *
 * Sixteen consecutive voxels of a row grow side by side until the last one stops
 * (TFCSphereTests.h). The sums are those of differences from the mean of S_1. Groups whose spheres
 * lie inside of a lattice without NaN read it where it is; others read a padded copy of their
 * surroundings. Both add in the same order: the results have the same bits, however the lattice is
 * cut into pieces.
 *
 * Cost: about eight operations per sample and voxel, while the sphere grows.
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
   * where the volume does. `masked` must be true if it may hold NaN. Values are multiplied by
   * `scale`, a power of two, before they are raised to powers, and results divided by it.
   */
  GrowingSpheres(const SphereShells& shells, const SphereTests& tests, const Index size[3],
    const Index begin[3], const Index end[3], bool masked, float scale)
    : Tests(tests)
    , Ends(shells.Ends)
    , Step(shells.Step)
    , Masked(masked)
    , Scale(scale)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Size[a] = size[a];
      this->Begin[a] = begin[a];
      this->End[a] = end[a];
      this->Reach[a] = shells.Reach[a];
    }
    this->BlockSize[0] = BlockWidth + 2 * this->Reach[0];
    this->BlockSize[1] = TileRows + 2 * this->Reach[1];
    this->BlockSize[2] = 1 + 2 * this->Reach[2];
    for (const auto& o : shells.Offsets)
    {
      this->LatticeOffsets.push_back((o[2] * size[1] + o[1]) * size[0] + o[0]);
      this->BlockOffsets.push_back((o[2] * this->BlockSize[1] + o[1]) * this->BlockSize[0] + o[0]);
    }
    for (Index k = 1; k < static_cast<Index>(this->Ends.size()); ++k)
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
   * Rows of `TileRows` adjacent rows in one slice: the unit of work.
   */
  Index GetNumberOfTiles() const
  {
    return this->GetTilesPerSlice() * (this->End[2] - this->Begin[2]);
  }

  /**
   * Bytes that a Workspace takes.
   */
  double GetWorkspaceBytes() const { return 4. * static_cast<double>(this->GetBlockLength()); }

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
    const Index z = this->Begin[2] + tile / this->GetTilesPerSlice();
    const Index y0 = this->Begin[1] + tile % this->GetTilesPerSlice() * TileRows;
    const Index y1 = std::min(y0 + TileRows, this->End[1]);
    // The groups [direct0, direct1) of the tile are surrounded by samples of the lattice.
    const Index groups = (this->End[0] - this->Begin[0] + Lanes - 1) / Lanes;
    Index direct0 = groups, direct1 = groups;
    if (this->Scale == 1.f && this->IsInside(1, y0, y1) && this->IsInside(2, z, z + 1))
    {
      const Index before = std::max<Index>(0, this->Reach[0] - this->Begin[0]);
      const Index last = std::min(this->End[0], this->Size[0] - this->Reach[0]) - this->Begin[0];
      direct0 = std::min(groups, (before + Lanes - 1) / Lanes);
      direct1 = std::max(direct0, last > 0 ? last / Lanes : 0);
    }
    this->ComputeCopied(volume, 0, direct0, y0, y1, z, outputs, work);
    for (Index y = y0; y < y1; ++y)
    {
      const float* row = volume + (z * this->Size[1] + y) * this->Size[0];
      for (Index group = direct0; group < direct1; ++group)
      {
        const float* p = row + this->Begin[0] + group * Lanes;
        if (this->Masked)
        {
          this->ComputeGroup<true>(p, this->LatticeOffsets.data(), group, y, z, outputs);
        }
        else
        {
          this->ComputeGroup<false>(p, this->LatticeOffsets.data(), group, y, z, outputs);
        }
      }
    }
    this->ComputeCopied(volume, direct1, groups, y0, y1, z, outputs, work);
  }

private:
  static constexpr Index TileRows = 8, BlockWidth = 64;

  struct Full
  {
    SphereTests::LaneConstants Constants;
    alignas(64) float ShellCounts[Lanes];
    alignas(64) float Counts[Lanes];
  };

  Index GetTilesPerSlice() const
  {
    return (this->End[1] - this->Begin[1] + TileRows - 1) / TileRows;
  }

  Index GetBlockLength() const
  {
    return this->BlockSize[0] * this->BlockSize[1] * this->BlockSize[2];
  }

  bool IsInside(int axis, Index first, Index last) const
  {
    return first >= this->Reach[axis] && last <= this->Size[axis] - this->Reach[axis];
  }

  /**
   * The groups [group0, group1) of a tile by way of copies that are padded with NaN.
   */
  void ComputeCopied(const float* volume, Index group0, Index group1, Index y0, Index y1, Index z,
    float* const* outputs, Workspace& work) const
  {
    constexpr Index blockGroups = BlockWidth / Lanes;
    for (Index first = group0; first < group1; first += blockGroups)
    {
      if (!work.Block)
      {
        work.Block.reset(new float[static_cast<size_t>(this->GetBlockLength())]);
      }
      const Index last = std::min(first + blockGroups, group1);
      this->Copy(volume, this->Begin[0] + first * Lanes, (last - first) * Lanes, y0, z,
        work.Block.get());
      for (Index y = y0; y < y1; ++y)
      {
        const float* row = work.Block.get() + this->Reach[0] +
          (this->Reach[2] * this->BlockSize[1] + y - y0 + this->Reach[1]) * this->BlockSize[0];
        for (Index group = first; group < last; ++group)
        {
          this->ComputeGroup<true>(row + (group - first) * Lanes, this->BlockOffsets.data(), group,
            y, z, outputs);
        }
      }
    }
  }

  void Copy(const float* volume, Index x0, Index width, Index y0, Index z, float* block) const
  {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Index from = x0 - this->Reach[0], count = width + 2 * this->Reach[0];
    // Parts of a row before, inside and after the lattice.
    const Index inside0 = std::min(std::max<Index>(-from, 0), count);
    const Index inside1 = std::min(std::max(this->Size[0] - from, inside0), count);
    for (Index dz = 0; dz < this->BlockSize[2]; ++dz)
    {
      for (Index dy = 0; dy < this->BlockSize[1]; ++dy, block += this->BlockSize[0])
      {
        const Index atZ = z - this->Reach[2] + dz, atY = y0 - this->Reach[1] + dy;
        if (atZ < 0 || atZ >= this->Size[2] || atY < 0 || atY >= this->Size[1])
        {
          std::fill(block, block + count, nan);
          continue;
        }
        const float* in = volume + (atZ * this->Size[1] + atY) * this->Size[0] + from;
        std::fill(block, block + inside0, nan);
        for (Index x = inside0; x < inside1; ++x)
        {
          block[x] = in[x] * this->Scale;
        }
        std::fill(block + inside1, block + count, nan);
      }
    }
  }

  /**
   * The spheres around p[0] to p[15], stored as far as they are samples of the output.
   */
  template <bool MayHaveNaN>
  void ComputeGroup(const float* p, const Index* offsets, Index group, Index y, Index z,
    float* const* outputs) const
  {
    PowerSums sums;
    alignas(64) float shift[Lanes], radius[Lanes];
    this->Grow<MayHaveNaN>(p, offsets, sums, shift, radius);

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
      // A NaN voxel has a NaN shift, which spreads to all results.
      const double invalid = shift[i] * 0.;
      results[SphereMean][i] = static_cast<float>((shift[i] + mean) * inverseScale);
      results[SphereDeviation][i] =
        static_cast<float>(std::sqrt(variance) * inverseScale + invalid);
      results[SphereRadius][i] = static_cast<float>(radius[i] * this->Step + invalid);
      results[SphereSkewness][i] =
        static_cast<float>((varies ? m3 / (divisor * std::sqrt(divisor)) : 0.) + invalid);
      results[SphereKurtosis][i] =
        static_cast<float>((varies ? m4 / (divisor * divisor) : 3.) + invalid);
    }
    const Index width = this->End[0] - this->Begin[0];
    const Index start =
      ((z - this->Begin[2]) * (this->End[1] - this->Begin[1]) + y - this->Begin[1]) * width +
      group * Lanes;
    const Index count = std::min<Index>(Lanes, width - group * Lanes);
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
  void Grow(const float* p, const Index* offsets, PowerSums& accepted, float* __restrict shift,
    float* __restrict radius) const
  {
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
  std::vector<Index> Ends, LatticeOffsets, BlockOffsets;
  std::vector<Full> FullSpheres; // [k - 1]: what S_k and its shell have inside the volume
  double Step;
  bool Masked;
  float Scale;
  Index Size[3], Begin[3], End[3], Reach[3], BlockSize[3];
};
}

#endif
