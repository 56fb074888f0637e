// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCScore.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
/**
 * Table 1 of the paper: intensity, gradient magnitude, mean, standard deviation, occlusion.
 */
const std::vector<double> Correlations = {
  1.0000, 0.1654, 0.9973, 0.2435, 0.7286,  //
  0.1654, 1.0000, 0.1690, 0.9569, -0.0583, //
  0.9973, 0.1690, 1.0000, 0.2464, 0.7388,  //
  0.2435, 0.9569, 0.2464, 1.0000, 0.0067,  //
  0.7286, -0.0583, 0.7388, 0.0067, 1.0000  //
};
const std::vector<double> Entropies = { 5.3828, 3.6077, 4.8012, 3.8392, 7.9090 };
}

TEST(Score, PaperTable1WithIntensityAndGradient)
{
  const auto scores = tfc::CombinationScores(Correlations, Entropies, 0.4, 0, 1);
  EXPECT_NEAR(scores.Score[2], -0.0347, 1e-4);
  // The paper prints 0.1938; its inputs, rounded to four digits, give 0.193853.
  EXPECT_NEAR(scores.Score[3], 0.1938, 1e-4);
  EXPECT_NEAR(scores.Score[4], 0.3086, 1e-4);
  EXPECT_EQ(scores.Rank, (std::vector<int>{ 0, 0, 3, 2, 1 }));
  EXPECT_TRUE(std::isnan(scores.Score[0]));
  EXPECT_TRUE(std::isnan(scores.Score[1]));
}

TEST(Score, PaperTable1WithMeanAndDeviation)
{
  const auto scores = tfc::CombinationScores(Correlations, Entropies, 0.4, 2, 3);
  EXPECT_NEAR(scores.Score[0], 0.0094, 1e-4);
  EXPECT_NEAR(scores.Score[1], 0.2061, 1e-4);
  EXPECT_NEAR(scores.Score[4], 0.3045, 1e-4);
  EXPECT_EQ(scores.Rank, (std::vector<int>{ 3, 2, 0, 0, 1 }));
}

TEST(Score, LargestEntropyRunsOverAllProperties)
{
  // The primary has the largest entropy: it still is the normaliser.
  const auto scores = tfc::CombinationScores({ 1., 0.5, 0.5, 1. }, { 8., 4. }, 0.4, 0, -1);
  EXPECT_NEAR(scores.Score[1], -0.4 * 0.5 + 0.6 * 4. / 8., 1e-15);
}

TEST(Score, UndefinedAndEqualOnes)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> r{ 1., nan, .2, -.2, nan, nan, nan, nan, .2, nan, 1., 0., -.2, nan, 0.,
    1. };
  const auto scores = tfc::CombinationScores(r, { 3., 0., 2., 2. }, 0.4, 0, -1);
  EXPECT_EQ(scores.Rank, (std::vector<int>{ 0, 0, 1, 2 }));
  EXPECT_EQ(scores.Score[2], scores.Score[3]);
  EXPECT_TRUE(std::isnan(scores.Score[1]));
  // A constant primary: nothing can be ranked.
  EXPECT_EQ(tfc::CombinationScores(r, { 3., 0., 2., 2. }, 0.4, 1, -1).Rank,
    (std::vector<int>{ 0, 0, 0, 0 }));
  EXPECT_TRUE(tfc::CombinationScores({}, {}, 0.4, 0, -1).Rank.empty());
}

TEST(Score, RankingIntervalsOfPaperTable1)
{
  const auto intervals = tfc::RankingIntervals(Correlations, Entropies, 0, 1);
  ASSERT_FALSE(intervals.empty());
  EXPECT_EQ(intervals.front().From, 0.);
  EXPECT_EQ(intervals.back().To, 1.);
  // By hand: occlusion and deviation cross where their scores are equal.
  const double e = Entropies[3] / Entropies[4];
  const double crossing = (1. - e) / ((1. - e) + (0.7286 - 0.2435));
  bool found = false;
  for (size_t i = 0; i < intervals.size(); ++i)
  {
    const auto& interval = intervals[i];
    EXPECT_EQ(interval.Order.size(), 3u);
    EXPECT_EQ(interval.From, i ? intervals[i - 1].To : 0.);
    EXPECT_LT(interval.From, interval.To);
    found = found || std::abs(interval.To - crossing) < 1e-12;
    // The ranking inside is that of the scores there.
    for (const double part : { 0.01, 0.5, 0.99 })
    {
      const double a = interval.From + part * (interval.To - interval.From);
      const auto scores = tfc::CombinationScores(Correlations, Entropies, a, 0, 1);
      for (size_t r = 0; r < interval.Order.size(); ++r)
      {
        EXPECT_EQ(scores.Rank[interval.Order[r]], static_cast<int>(r) + 1);
      }
    }
    EXPECT_EQ(interval.Order[0], interval.To <= crossing + 1e-12 ? 4 : 3);
  }
  EXPECT_TRUE(found);
}

TEST(Score, RankingIntervalsWithoutCrossingsOrCandidates)
{
  // The second is better in both respects.
  const auto one =
    tfc::RankingIntervals({ 1., .9, .1, .9, 1., 0., .1, 0., 1. }, { 8., 2., 4. }, 0, -1);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].Order, (std::vector<int>{ 2, 1 }));
  EXPECT_EQ(one[0].To, 1.);
  EXPECT_TRUE(tfc::RankingIntervals({ 1. }, { 8. }, 0, -1).empty());
}
