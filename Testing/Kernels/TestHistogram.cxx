// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCHistogram.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
std::vector<std::int64_t> Compute(const std::vector<double>& values, const tfc::Binning& binning)
{
  tfc::Histogram histogram(binning);
  histogram.Add(values.data(), static_cast<tfc::Index>(values.size()));
  std::vector<std::int64_t> counts(binning.Bins, 0);
  histogram.AddTo(counts.data());
  return counts;
}
}

TEST(Histogram, EqualBinsWithTheMaximumInTheLast)
{
  const auto binning = tfc::Binning::Make(0., 1., false, 4);
  EXPECT_EQ(binning.GetBin(0.), 0);
  EXPECT_EQ(binning.GetBin(0.2499), 0);
  EXPECT_EQ(binning.GetBin(0.25), 1);
  EXPECT_EQ(binning.GetBin(0.9999), 3);
  EXPECT_EQ(binning.GetBin(1.), 3);
  EXPECT_EQ(binning.GetBin(-5.), 0);
  EXPECT_EQ(binning.GetBin(5.), 3);
  EXPECT_EQ(binning.GetBin(std::numeric_limits<double>::quiet_NaN()), 4);
}

TEST(Histogram, OneBinPerIntegerWhereTheyFit)
{
  const auto fits = tfc::Binning::Make(-100., 155., true, 256);
  EXPECT_EQ(fits.Bins, 256);
  EXPECT_EQ(fits.GetBin(-100.), 0);
  EXPECT_EQ(fits.GetBin(-99.), 1);
  EXPECT_EQ(fits.GetBin(155.), 255);
  EXPECT_EQ(tfc::Binning::Make(3., 5., true, 256).Bins, 3);
  const auto wide = tfc::Binning::Make(0., 256., true, 256);
  EXPECT_EQ(wide.Bins, 256);
  EXPECT_EQ(wide.GetBin(255.), 255);
  EXPECT_EQ(wide.GetBin(256.), 255);
}

TEST(Histogram, DegenerateRanges)
{
  EXPECT_EQ(tfc::Binning::Make(7., 7., false, 256).Bins, 1);
  EXPECT_EQ(tfc::Binning::Make(7., 7., false, 256).GetBin(7.), 0);
  EXPECT_EQ(tfc::Binning::Make(INFINITY, -INFINITY, false, 256).Bins, 1);
  const auto denormal = tfc::Binning::Make(0., 5e-324, false, 256);
  EXPECT_EQ(denormal.GetBin(0.), 0);
  const auto large = tfc::Binning::Make(-4e307, 4e307, false, 256);
  EXPECT_EQ(large.GetBin(4e307), 255);
  EXPECT_EQ(large.GetBin(-4e307), 0);
}

TEST(Histogram, CountsEverySampleButNaN)
{
  std::vector<double> values(1001, 0.1);
  values[3] = std::numeric_limits<double>::quiet_NaN();
  values[10] = 0.9;
  const auto counts = Compute(values, tfc::Binning::Make(0., 1., false, 2));
  EXPECT_EQ(counts[0], 999);
  EXPECT_EQ(counts[1], 1);
}

TEST(Entropy, ClosedForms)
{
  const std::int64_t uniform[8] = { 5, 5, 5, 5, 5, 5, 5, 5 };
  EXPECT_NEAR(tfc::Entropy(uniform, 8), 3., 1e-15);
  const std::int64_t single[4] = { 0, 42, 0, 0 };
  EXPECT_EQ(tfc::Entropy(single, 4), 0.);
  const std::int64_t mixed[4] = { 4, 2, 1, 1 };
  EXPECT_NEAR(tfc::Entropy(mixed, 4), 1.75, 1e-15);
  const std::int64_t none[2] = { 0, 0 };
  EXPECT_EQ(tfc::Entropy(none, 2), 0.);
}
