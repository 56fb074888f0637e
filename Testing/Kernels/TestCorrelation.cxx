// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCCorrelation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

using Columns = std::vector<std::vector<double>>;

/**
 * Matrix by the kernel, in blocks of `block` samples.
 */
std::vector<double> Compute(const Columns& columns, tfc::Index block)
{
  const size_t k = columns.size();
  const tfc::Index n = static_cast<tfc::Index>(columns[0].size());
  std::vector<tfc::PairSums> pairs(tfc::NumberOfPairs(k));
  tfc::PairWorkspace work(k, block);
  for (tfc::Index first = 0; first < n; first += block)
  {
    const tfc::Index count = std::min(block, n - first);
    for (size_t i = 0; i < k; ++i)
    {
      std::copy_n(columns[i].begin() + first, count, work.GetValues(i));
    }
    tfc::AccumulatePairs(k, count, work, pairs.data());
  }
  return tfc::CorrelationMatrix(pairs, std::vector<bool>(k, false));
}

/**
 * Two-pass definition over the common samples, in long double.
 */
double Reference(const std::vector<double>& a, const std::vector<double>& b)
{
  long double n = 0, meanA = 0, meanB = 0, aa = 0, bb = 0, ab = 0;
  for (size_t i = 0; i < a.size(); ++i)
  {
    if (!std::isnan(a[i]) && !std::isnan(b[i]))
    {
      n += 1;
      meanA += a[i];
      meanB += b[i];
    }
  }
  meanA /= n;
  meanB /= n;
  for (size_t i = 0; i < a.size(); ++i)
  {
    if (!std::isnan(a[i]) && !std::isnan(b[i]))
    {
      aa += (a[i] - meanA) * (a[i] - meanA);
      bb += (b[i] - meanB) * (b[i] - meanB);
      ab += (a[i] - meanA) * (b[i] - meanB);
    }
  }
  return static_cast<double>(ab / std::sqrt(aa * bb));
}

Columns MakeColumns(size_t k, size_t n, double invalid)
{
  std::mt19937 random(99);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> chance(0., 1.);
  Columns columns(k, std::vector<double>(n));
  for (size_t s = 0; s < n; ++s)
  {
    const double common = normal(random);
    for (size_t i = 0; i < k; ++i)
    {
      columns[i][s] = (i % 2 ? -1. : 1.) * common + 0.3 * i * normal(random);
      columns[i][s] = chance(random) < invalid ? NaN : columns[i][s];
    }
  }
  return columns;
}
}

TEST(Correlation, MatchesDefinition)
{
  for (const double invalid : { 0., 0.25 })
  {
    const Columns columns = MakeColumns(5, 1003, invalid);
    for (const tfc::Index block : { 1, 7, 64, 2048 })
    {
      const auto matrix = Compute(columns, block);
      for (size_t i = 0; i < 5; ++i)
      {
        EXPECT_EQ(matrix[i * 5 + i], 1.);
        for (size_t j = 0; j < 5; ++j)
        {
          EXPECT_EQ(matrix[i * 5 + j], matrix[j * 5 + i]);
          EXPECT_NEAR(matrix[i * 5 + j], i == j ? 1. : Reference(columns[i], columns[j]), 1e-12);
        }
      }
    }
  }
}

TEST(Correlation, ExactlyLinearIsExactlyOne)
{
  Columns columns(3);
  for (int s = 0; s < 500; ++s)
  {
    columns[0].push_back(0.1 * s);
    columns[1].push_back(7. - 0.3 * s);
    columns[2].push_back(s % 2);
  }
  const auto matrix = Compute(columns, 128);
  EXPECT_NEAR(matrix[1], -1., 1e-14);
  EXPECT_GE(matrix[1], -1.);
  EXPECT_NEAR(matrix[2], Reference(columns[0], columns[2]), 1e-12);
}

TEST(Correlation, UndefinedIsNaN)
{
  // Constant where both have data; one common sample; none.
  const Columns columns{ { 3., 3., 3., 4. }, { 1., 2., 5., NaN }, { NaN, NaN, 1., 2. },
    { 1., 2., NaN, NaN } };
  const auto matrix = Compute(columns, 4);
  EXPECT_TRUE(std::isnan(matrix[0 * 4 + 1]));
  EXPECT_TRUE(std::isnan(matrix[1 * 4 + 2]));
  EXPECT_TRUE(std::isnan(matrix[2 * 4 + 3]));
  const auto marked = tfc::CorrelationMatrix(std::vector<tfc::PairSums>(1), { true, false });
  EXPECT_TRUE(std::isnan(marked[0]));
  EXPECT_EQ(marked[3], 1.);
}

TEST(Correlation, NumberOfPairs)
{
  EXPECT_EQ(tfc::NumberOfPairs(0), 0u);
  EXPECT_EQ(tfc::NumberOfPairs(1), 0u);
  EXPECT_EQ(tfc::NumberOfPairs(5), 10u);
}
