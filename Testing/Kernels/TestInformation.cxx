// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCInformation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <tuple>

namespace
{
using Cell = std::tuple<int, int, int>; // t, x, y

std::vector<std::int64_t> Count(const std::vector<Cell>& samples, int bins)
{
  std::vector<std::int64_t> counts(static_cast<size_t>(bins) * bins * bins, 0);
  for (const auto& [t, x, y] : samples)
  {
    const auto b = static_cast<size_t>(bins);
    ++counts[(static_cast<size_t>(y) * b + static_cast<size_t>(x)) * b + static_cast<size_t>(t)];
  }
  return counts;
}

/**
 * Corrected entropy of what `key` makes of the samples, by definition.
 */
template <typename Key>
double Entropy(const std::vector<Cell>& samples, Key&& key)
{
  std::map<Cell, double> cells;
  for (const Cell& sample : samples)
  {
    cells[key(sample)] += 1.;
  }
  const auto n = static_cast<double>(samples.size());
  double entropy = (static_cast<double>(cells.size()) - 1.) / (2. * n) / std::log(2.);
  for (const auto& cell : cells)
  {
    entropy -= cell.second / n * std::log2(cell.second / n);
  }
  return entropy;
}

tfc::Information Measure(const std::vector<Cell>& samples, int bins)
{
  return tfc::MeasureInformation(Count(samples, bins), bins);
}
}

TEST(Information, Definition)
{
  std::mt19937 random(1);
  std::vector<Cell> samples;
  for (int i = 0; i < 20000; ++i)
  {
    const int x = static_cast<int>(random() % 8), y = static_cast<int>(random() % 8);
    samples.push_back({ (x * y + static_cast<int>(random() % 3)) % 8, x, y });
  }
  const auto found = Measure(samples, 8);
  const double t = Entropy(samples, [](const Cell& c) { return Cell(std::get<0>(c), 0, 0); });
  const double y = Entropy(samples, [](const Cell& c) { return Cell(0, 0, std::get<2>(c)); });
  const double xy =
    Entropy(samples, [](const Cell& c) { return Cell(0, std::get<1>(c), std::get<2>(c)); });
  const double yt =
    Entropy(samples, [](const Cell& c) { return Cell(std::get<0>(c), 0, std::get<2>(c)); });
  const double all = Entropy(samples, [](const Cell& c) { return c; });
  EXPECT_EQ(found.Samples, 20000.);
  EXPECT_NEAR(found.Entropy, t, 1e-12);
  EXPECT_NEAR(found.New, all - xy, 1e-12);
  EXPECT_NEAR(found.Mutual, t + xy - all, 1e-12);
  EXPECT_NEAR(found.ConditionalMutual, xy + yt - y - all, 1e-12);
  EXPECT_GT(found.ConditionalMutual, 0.5);
}

TEST(Information, IndependentSharesNothing)
{
  // As few samples per cell as GetInformationBins() allows: 32.
  std::mt19937 random(2);
  std::vector<Cell> samples;
  samples.reserve(32 * 4096);
  for (int i = 0; i < 32 * 4096; ++i)
  {
    samples.push_back({ static_cast<int>(random() % 16), static_cast<int>(random() % 16),
      static_cast<int>(random() % 16) });
  }
  EXPECT_EQ(tfc::GetInformationBins(32 * 4096), 16);
  const auto found = Measure(samples, 16);
  // Uncorrected, the bias of I(T; X, Y) is 15 * 255 / (2 N ln 2) = 0.021 bits.
  EXPECT_LT(found.Mutual, 0.002);
  EXPECT_LT(found.ConditionalMutual, 0.002);
  EXPECT_NEAR(found.New, 4., 0.002);
}

TEST(Information, DeterminedSharesAll)
{
  std::mt19937 random(3);
  std::vector<Cell> ofX, ofBoth;
  for (int i = 0; i < 100000; ++i)
  {
    const int x = static_cast<int>(random() % 8), y = static_cast<int>(random() % 8);
    ofX.push_back({ (3 * x) % 8, x, y });
    ofBoth.push_back({ x ^ y, x, y });
  }
  auto found = Measure(ofX, 8);
  EXPECT_NEAR(found.Mutual, found.Entropy, 1e-12);
  EXPECT_NEAR(found.New, 0., 1e-12);
  EXPECT_NEAR(found.ConditionalMutual, 3., 1e-3);
  found = Measure(ofBoth, 8);
  EXPECT_NEAR(found.Mutual, found.Entropy, 1e-12);
  EXPECT_NEAR(found.ConditionalMutual, 3., 1e-3);
}

TEST(Information, NothingAndConstant)
{
  auto found = Measure({}, 4);
  EXPECT_EQ(found.Samples, 0.);
  EXPECT_EQ(found.Mutual, 0.);
  found = Measure(std::vector<Cell>(50, Cell(2, 1, 3)), 4);
  EXPECT_EQ(found.Entropy, 0.);
  EXPECT_EQ(found.New, 0.);
}

TEST(Information, Bins)
{
  EXPECT_EQ(tfc::GetInformationBins(0.), 4);
  EXPECT_EQ(tfc::GetInformationBins(32. * 512.), 8);
  EXPECT_EQ(tfc::GetInformationBins(32. * 512. - 1.), 4);
  EXPECT_EQ(tfc::GetInformationBins(1e12), 32);
  const double values[6] = { 0., 0.49, 0.5, 1., std::numeric_limits<double>::quiet_NaN(), -1. };
  std::int32_t bins[6];
  tfc::FindCoarseBins(values, 6, 0., 1., 4, bins);
  const std::int32_t expected[6] = { 0, 1, 2, 3, -1, 0 };
  EXPECT_TRUE(std::equal(bins, bins + 6, expected));
  tfc::FindCoarseBins(values, 3, 0., 0., 4, bins);
  EXPECT_EQ(bins[0], 0);
}
