// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCSphereSlices.h"
#include "KernelVolumes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_volumes;

namespace
{
/**
 * Sums of powers of value - shift.
 */
std::array<double, 5> SumPowers(const std::vector<float>& values, double shift)
{
  std::array<double, 5> sums{};
  for (const float value : values)
  {
    for (int power = 0; power < 5 && value == value; ++power)
    {
      sums[power] += std::pow(value - shift, power);
    }
  }
  return sums;
}

void ExpectSums(const tfc::PowerSums& sums, int lane, const std::vector<float>& values,
  double shift)
{
  const auto expected = SumPowers(values, shift);
  EXPECT_EQ(sums.Count[lane], expected[0]);
  // Rounding is in proportion to the sums of absolute values, which those of even powers bound.
  const double size[] = { std::sqrt(expected[0] * expected[2]), expected[2],
    std::sqrt(expected[2] * expected[4]), expected[4] };
  for (int power = 0; power < 4; ++power)
  {
    EXPECT_NEAR(sums.Sum[power][lane], expected[power + 1], 1e-5 * size[power] + 1e-30);
  }
}
}

TEST(SphereSlices, DiscsAndSpheresHoldTheirSamples)
{
  // Every size of every batch, around one group with room on all sides.
  const Size n{ 46, 31, 31 };
  const tfc::Index row = n[0], slice = n[0] * n[1], middle = 15;
  const double spacings[][3] = { { 1., 1., 1. }, { 1., 1.4, 2.1 }, { 1.7, 1., 0.6 } };
  for (const double invalid : { 0., 0.5, 0.99 })
  {
    const auto volume = MakeNoise(n, 17, invalid);
    const float* p = volume.data() + middle * slice + middle * row + middle;
    for (const auto& spacing : spacings)
    {
      const double step = *std::min_element(spacing, spacing + 3);
      const auto shells = tfc::SphereShells::Make(n.data(), spacing, 10. * step);
      for (tfc::Index first = 1; first <= 10; first += 3)
      {
        const tfc::Index last = std::min<tfc::Index>(first + 2, 10);
        const tfc::SphereSlices slices(shells, first, last, row);
        ASSERT_EQ(slices.GetSize(), last - first + 1);
        std::vector<tfc::PowerSums> discs(slices.GetNumberOfDiscs());
        std::array<tfc::PowerSums, tfc::SphereSlices::MostSizes> spheres{};
        alignas(64) float shift[tfc::Lanes], center[tfc::Lanes];
        std::fill(shift, shift + tfc::Lanes, 0.25f);
        for (tfc::Index dz = -slices.GetReach()[2]; dz <= slices.GetReach()[2]; ++dz)
        {
          // Half of the slices as a column does where a nearer voxel needs larger discs.
          const tfc::Index distance = std::abs(dz);
          const tfc::Index asked = dz < 0 ? 0 : distance;
          if (invalid > 0.)
          {
            slices.SumDiscs<true>(p + dz * slice, asked, discs.data(), center);
          }
          else
          {
            slices.SumDiscs<false>(p + dz * slice, asked, discs.data(), center);
          }
          slices.AddDiscs(discs.data(), center, distance, shift, spheres.data());
        }
        for (tfc::Index k = first; k <= last; ++k)
        {
          for (int lane = 0; lane < tfc::Lanes; ++lane)
          {
            std::vector<float> values;
            for (tfc::Index i = 0; i < shells.Ends[k]; ++i)
            {
              const auto& o = shells.Offsets[i];
              values.push_back(p[lane + o[0] + o[1] * row + o[2] * slice]);
            }
            ExpectSums(spheres[k - first], lane, values, 0.25);
          }
        }
      }
    }
  }
}

TEST(SphereSlices, SumsDoNotDependOnWhoElseAsks)
{
  // As far as discs reach, their bits are those of larger requests.
  const Size n{ 40, 21, 1 };
  const auto volume = MakeNoise(n, 5, 0.3);
  const double spacing[3] = { 1., 1., 1. };
  const Size whole{ 40, 21, 21 };
  const auto shells = tfc::SphereShells::Make(whole.data(), spacing, 10.);
  const tfc::SphereSlices slices(shells, 7, 10, n[0]);
  const float* p = volume.data() + 10 * n[0] + 10;
  alignas(64) float center[tfc::Lanes], other[tfc::Lanes];
  std::vector<tfc::PowerSums> all(slices.GetNumberOfDiscs());
  slices.SumDiscs<true>(p, 0, all.data(), center);
  for (tfc::Index distance = 0; distance <= 10; ++distance)
  {
    std::vector<tfc::PowerSums> discs(slices.GetNumberOfDiscs());
    slices.SumDiscs<true>(p, distance, discs.data(), other);
    size_t compared = 0;
    for (size_t d = 0; d < discs.size(); ++d)
    {
      for (int lane = 0; lane < tfc::Lanes; ++lane)
      {
        // Without a valid sample in the smaller disc there is no sum.
        if (discs[d].Count[lane] > 0.f)
        {
          ++compared;
          EXPECT_EQ(other[lane], center[lane]);
          EXPECT_EQ(discs[d].Count[lane], all[d].Count[lane]);
          for (int power = 0; power < 4; ++power)
          {
            EXPECT_EQ(discs[d].Sum[power][lane], all[d].Sum[power][lane]);
          }
        }
      }
    }
    EXPECT_GT(compared, 0u);
  }
}

TEST(SphereSlices, OutliersCostNoDigitsElsewhere)
{
  // An outlier beside a disc, or in the centre of a slice with no other sample of the sphere.
  const double spacing[3] = { 1., 1., 1. };
  const Size n{ 40, 21, 21 };
  auto volume = MakeNoise(n, 6);
  for (float& v : volume)
  {
    v = 300.f + 0.01f * v;
  }
  volume[(10 * n[1] + 10) * n[0] + 26] = 1e6f;
  const auto shells = tfc::SphereShells::Make(n.data(), spacing, 7.);
  const tfc::SphereSlices slices(shells, 4, 7, n[0]);
  const float* p = volume.data() + (10 * n[1] + 10) * n[0] + 10;
  std::vector<tfc::PowerSums> discs(slices.GetNumberOfDiscs());
  std::array<tfc::PowerSums, 4> spheres{};
  alignas(64) float shift[tfc::Lanes], center[tfc::Lanes];
  std::fill(shift, shift + tfc::Lanes, 300.f);
  for (tfc::Index dz = -7; dz <= 7; ++dz)
  {
    slices.SumDiscs<false>(p + dz * n[0] * n[1], std::abs(dz), discs.data(), center);
    slices.AddDiscs(discs.data(), center, std::abs(dz), shift, spheres.data());
  }
  for (int lane = 0; lane < 9; ++lane)
  {
    std::vector<float> values;
    for (const auto& o : shells.Offsets)
    {
      values.push_back(p[lane + o[0] + (o[2] * n[1] + o[1]) * n[0]]);
    }
    ExpectSums(spheres[3], lane, values, 300.);
  }
}
