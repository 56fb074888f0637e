// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The growth of the spheres around 16 voxels of a row, side by side until the last stops.
 *
 * The rules are those of TFCGrowingSpheres.h. The first spheres are summed up shell by shell, the
 * others come as sums of whole spheres (TFCSphereSlices.h); a shell is then the difference of two.
 * All sums are those of differences from the mean of S_1.
 */

#ifndef TFCSphereGrowth_h
#define TFCSphereGrowth_h

#include "TFCSphereShells.h"
#include "TFCSphereTests.h"

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
 * What is known of 16 voxels.
 */
struct SphereGroup
{
  PowerSums Accepted;              ///< of the largest accepted spheres
  alignas(64) float Shift[Lanes];  ///< what the differences are from; NaN for a voxel without value
  alignas(64) float Radius[Lanes]; ///< of the accepted spheres, in steps
  alignas(64) std::int32_t Alive[Lanes]; ///< whether the next sphere may be accepted
  bool AnyAlive;
};

class SphereGrowth
{
public:
  /**
   * S_1 to S_direct are to be summed up shell by shell, in rows of rowLength and slices of
   * sliceLength samples.
   */
  SphereGrowth(const SphereShells& shells, const SphereTests& tests, Index direct, Index rowLength,
    Index sliceLength)
    : Tests(tests)
    , Ends(shells.Ends)
    , Direct(direct)
    , Step(shells.Step)
  {
    for (Index i = 0; i < this->Ends[static_cast<size_t>(direct)]; ++i)
    {
      const auto& o = shells.Offsets[static_cast<size_t>(i)];
      this->Offsets.push_back(o[2] * sliceLength + o[1] * rowLength + o[0]);
      for (int a = 0; a < 3; ++a)
      {
        this->Reach[a] = std::max<Index>(this->Reach[a], o[static_cast<size_t>(a)]);
      }
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
   * Largest offset along each axis of the samples that Begin() looks at.
   */
  const Index* GetReach() const { return this->Reach; }

  /**
   * Grows the spheres around p[0] to p[15] as far as they are summed up shell by shell.
   * `MayHaveNaN` must be true if samples may be missing.
   */
  template <bool MayHaveNaN>
  void Begin(const float* p, SphereGroup& group) const
  {
    const Index* offsets = this->Offsets.data();
    PowerSums shell{}, total;
    float* __restrict shift = group.Shift;
    for (int i = 0; i < Lanes; ++i)
    {
      shift[i] = p[i];
      group.Radius[i] = 0.f;
      group.Alive[i] = p[i] == p[i];
    }
    group.Accepted = shell;
    group.AnyAlive = true;
    // About an outlier the powers would lose digits: go on from the mean of S_1.
    AddPowers<MayHaveNaN>(p, offsets, this->Ends[1], shift, shell);
    for (int i = 0; i < Lanes; ++i)
    {
      const float n = MayHaveNaN ? shell.Count[i] : static_cast<float>(this->Ends[1]);
      shift[i] += shell.Sum[0][i] / n;
    }
    for (Index k = 1; k <= this->Direct && group.AnyAlive; ++k)
    {
      const Index first = this->Ends[static_cast<size_t>(k - 1)];
      const Index last = this->Ends[static_cast<size_t>(k)];
      const Full& full = this->FullSpheres[static_cast<size_t>(k - 1)];
      shell = PowerSums{};
      AddPowers<MayHaveNaN>(p, offsets + first, last - first, shift, shell);
      for (int i = 0; i < Lanes; ++i)
      {
        shell.Count[i] = MayHaveNaN ? shell.Count[i] : full.ShellCounts[i];
        total.Count[i] = group.Accepted.Count[i] + shell.Count[i];
      }
      for (int s = 0; s < 4; ++s)
      {
        for (int i = 0; i < Lanes; ++i)
        {
          total.Sum[s][i] = group.Accepted.Sum[s][i] + shell.Sum[s][i];
        }
      }
      this->Judge<MayHaveNaN>(k, shell, total, group);
    }
  }

  /**
   * Goes on with spheres[0] = S_first and so on, `count` of them, as sums about group.Shift.
   */
  template <bool MayHaveNaN>
  void GoOn(Index first, Index count, const PowerSums* spheres, SphereGroup& group) const
  {
    PowerSums shell;
    for (Index j = 0; j < count && group.AnyAlive; ++j)
    {
      const PowerSums& total = spheres[j];
      for (int i = 0; i < Lanes; ++i)
      {
        shell.Count[i] = total.Count[i] - group.Accepted.Count[i];
      }
      for (int s = 0; s < 4; ++s)
      {
        for (int i = 0; i < Lanes; ++i)
        {
          shell.Sum[s][i] = total.Sum[s][i] - group.Accepted.Sum[s][i];
        }
      }
      this->Judge<MayHaveNaN>(first + j, shell, total, group);
    }
  }

  /**
   * The statistics of the accepted spheres, of values that were multiplied by `scale`.
   */
  void GetStatistics(const SphereGroup& group, float scale, float (*results)[Lanes]) const
  {
    const PowerSums& sums = group.Accepted;
    const double inverseScale = 1. / static_cast<double>(scale);
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
      results[SphereMean][i] = static_cast<float>((group.Shift[i] + mean) * inverseScale);
      results[SphereDeviation][i] = static_cast<float>(std::sqrt(variance) * inverseScale);
      results[SphereRadius][i] = static_cast<float>(group.Radius[i] * this->Step);
      results[SphereSkewness][i] =
        static_cast<float>(varies ? m3 / (divisor * std::sqrt(divisor)) : 0.);
      results[SphereKurtosis][i] = static_cast<float>(varies ? m4 / (divisor * divisor) : 3.);
    }
    // Always the same NaN: what arithmetic makes of one differs between instruction sets.
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int s = 0; s < NumberOfSphereStatistics; ++s)
    {
      for (int i = 0; i < Lanes; ++i)
      {
        results[s][i] = group.Shift[i] == group.Shift[i] ? results[s][i] : nan;
      }
    }
  }

private:
  struct Full
  {
    SphereTests::LaneConstants Constants;
    alignas(64) float ShellCounts[Lanes];
    alignas(64) float Counts[Lanes];
  };

  /**
   * Accepts S_k = `total`, which adds `shell` to the accepted sphere, in the lanes that pass.
   */
  template <bool MayHaveNaN>
  void Judge(Index k, const PowerSums& shell, const PowerSums& total, SphereGroup& group) const
  {
    alignas(64) std::int32_t passed[Lanes];
    std::copy(group.Alive, group.Alive + Lanes, passed);
    PowerSums& accepted = group.Accepted;
    if (k > 1)
    {
      SphereTests::LaneConstants constants;
      const auto* sizes = &this->FullSpheres[static_cast<size_t>(k - 1)].Constants;
      if (MayHaveNaN)
      {
        this->Tests.Look(total.Count, constants);
        sizes = &constants;
      }
      this->Tests.TestNormality(total, *sizes, passed);
      this->Tests.TestSimilarity(accepted, shell, passed);
    }
    std::int32_t any = 0;
    for (int i = 0; i < Lanes; ++i)
    {
      accepted.Count[i] = passed[i] ? total.Count[i] : accepted.Count[i];
      group.Radius[i] = passed[i] ? static_cast<float>(k) : group.Radius[i];
      group.Alive[i] = passed[i];
      any |= passed[i];
    }
    for (int s = 0; s < 4; ++s)
    {
      for (int i = 0; i < Lanes; ++i)
      {
        accepted.Sum[s][i] = passed[i] ? total.Sum[s][i] : accepted.Sum[s][i];
      }
    }
    group.AnyAlive = any != 0;
  }

  const SphereTests& Tests;
  std::vector<Index> Ends;       // as in SphereShells
  std::vector<Index> Offsets;    // as in SphereShells, in memory
  std::vector<Full> FullSpheres; // [k - 1]: constants of a sphere without gaps and of its shell
  Index Direct;
  double Step;
  Index Reach[3] = {};
};
}

#endif
