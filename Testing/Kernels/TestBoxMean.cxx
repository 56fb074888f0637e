// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCBoxMean.h"
#include "KernelVolumes.h"

#include <gtest/gtest.h>

using namespace testing_volumes;

namespace
{
/**
 * In-volume means of the block [begin, end) by the kernel, in tiles of `tile` rows.
 */
std::vector<double> Compute(const std::vector<float>& volume, const Size& n, const Size& begin,
  const Size& end, tfc::Index radius, bool masked, tfc::Index tile = 3)
{
  const tfc::Index radii[3] = { radius, radius, radius };
  const tfc::BoxSum box(n.data(), begin.data(), end.data(), radii);
  std::vector<float> sums(box.GetTemporarySize()), validity(box.GetTemporarySize());
  tfc::BoxSum::Workspace work;
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    if (masked)
    {
      box.SumSlice<tfc::BoxTerm::ValidValue>(volume.data(), z, sums.data(), work);
      box.SumSlice<tfc::BoxTerm::Validity>(volume.data(), z, validity.data(), work);
    }
    else
    {
      box.SumSlice<tfc::BoxTerm::Value>(volume.data(), z, sums.data(), work);
    }
  }
  const Size size{ end[0] - begin[0], end[1] - begin[1], end[2] - begin[2] };
  std::vector<double> out(size[0] * size[1] * size[2]);
  for (tfc::Index y0 = 0; y0 < size[1]; y0 += tile)
  {
    box.SumColumns(sums.data(), masked ? validity.data() : nullptr, y0,
      std::min(y0 + tile, size[1]), work,
      [&](tfc::Index y, tfc::Index z, const double* rowSums, const double* rowCounts)
      {
        double* row = out.data() + ((z - begin[2]) * size[1] + y - begin[1]) * size[0];
        for (tfc::Index x = 0; x < size[0]; ++x)
        {
          const double count = masked ? rowCounts[x]
                                      : static_cast<double>(box.CountAlong(0, x + begin[0]) *
                                          box.CountAlong(1, y) * box.CountAlong(2, z));
          row[x] = rowSums[x] / count;
        }
      });
  }
  return out;
}

std::vector<double> Compute(const std::vector<float>& volume, const Size& n, tfc::Index radius,
  bool masked)
{
  return Compute(volume, n, { 0, 0, 0 }, n, radius, masked);
}

/**
 * Mean of the valid samples of the box by its definition; NaN where there is none.
 */
double Reference(const std::vector<float>& volume, const Size& n, const Size& at, tfc::Index radius)
{
  double sum = 0.;
  int count = 0;
  const auto low = [&](int a) { return std::max<tfc::Index>(at[a] - radius, 0); };
  const auto high = [&](int a) { return std::min(at[a] + radius, n[a] - 1); };
  for (tfc::Index z = low(2); z <= high(2); ++z)
  {
    for (tfc::Index y = low(1); y <= high(1); ++y)
    {
      for (tfc::Index x = low(0); x <= high(0); ++x)
      {
        const float v = At(volume, n, x, y, z);
        sum += std::isnan(v) ? 0. : v;
        count += std::isnan(v) ? 0 : 1;
      }
    }
  }
  return count ? sum / count : NaN;
}
}

TEST(BoxMean, MatchesDefinitionOnNoise)
{
  for (const Size& n : GetSizes())
  {
    for (const tfc::Index radius : { 0, 1, 2, 3, 5, 8, 40, 1 << 30 })
    {
      for (const double invalid : { 0., 0.3, 0.95 })
      {
        const auto volume = MakeNoise(n, 5, invalid);
        const auto masked = Compute(volume, n, radius, true);
        const auto plain = Compute(volume, n, radius, false);
        size_t i = 0;
        for (tfc::Index z = 0; z < n[2]; ++z)
        {
          for (tfc::Index y = 0; y < n[1]; ++y)
          {
            for (tfc::Index x = 0; x < n[0]; ++x, ++i)
            {
              const double expected = Reference(volume, n, { x, y, z }, radius);
              if (std::isnan(expected))
              {
                EXPECT_TRUE(std::isnan(masked[i]));
                continue;
              }
              EXPECT_NEAR(masked[i], expected, 3e-6);
              if (invalid == 0.)
              {
                EXPECT_NEAR(plain[i], expected, 3e-6);
              }
            }
          }
        }
      }
    }
  }
}

TEST(BoxMean, PartOfTheVolumeIsThatPartOfTheResult)
{
  const Size n{ 14, 11, 9 };
  const auto volume = MakeNoise(n, 29, 0.1);
  for (const tfc::Index radius : { 1, 4, 20 })
  {
    const auto whole = Compute(volume, n, radius, true);
    const Size begin{ 3, 2, 4 }, end{ 13, 9, 8 };
    const auto part = Compute(volume, n, begin, end, radius, true, 2);
    size_t i = 0;
    for (tfc::Index z = begin[2]; z < end[2]; ++z)
    {
      for (tfc::Index y = begin[1]; y < end[1]; ++y)
      {
        for (tfc::Index x = begin[0]; x < end[0]; ++x, ++i)
        {
          EXPECT_NEAR(part[i], whole[(z * n[1] + y) * n[0] + x], 3e-6);
        }
      }
    }
  }
}

TEST(BoxMean, LinearRampKeepsItsValueInside)
{
  // The mean of a linear function over a symmetric box is the value at its centre; at a border it
  // is the value at the centre of the part inside.
  const Size n{ 64, 20, 20 };
  const auto volume = Make(n, [](auto x, auto, auto) { return 0.25 * x; });
  const auto mean = Compute(volume, n, 6, false);
  for (tfc::Index x = 0; x < n[0]; ++x)
  {
    const double first = std::max<tfc::Index>(x - 6, 0), last = std::min<tfc::Index>(x + 6, 63);
    EXPECT_NEAR(mean[(10 * n[1] + 10) * n[0] + x], 0.25 * 0.5 * (first + last), 1e-5);
  }
}

TEST(BoxMean, RunningSumsForgetLargeValues)
{
  // One huge sample passes through the running sums; what follows must not keep its rounding error.
  const Size n{ 300, 3, 3 };
  const auto volume =
    Make(n, [](auto x, auto y, auto z) { return x == 20 && y == 1 && z == 1 ? 1e6 : 1.; });
  const auto mean = Compute(volume, n, 2, false);
  EXPECT_NEAR(mean[(1 * 3 + 1) * 300 + 200], 1., 1e-7);
}
