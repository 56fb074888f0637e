// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCSplit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
constexpr int Bins = 256;

/**
 * Histogram of normal samples: pairs of mean and standard deviation in bins, in turns.
 */
std::vector<double> Normal(int samples, const std::vector<std::pair<double, double>>& parts)
{
  std::mt19937 random(5);
  std::vector<double> counts(Bins, 0.);
  for (int i = 0; i < samples; ++i)
  {
    const auto& part = parts[static_cast<size_t>(i) % parts.size()];
    const double value = std::normal_distribution<double>(part.first, part.second)(random);
    counts[static_cast<size_t>(std::min(Bins - 1., std::max(0., value)))] += 1.;
  }
  return counts;
}

/**
 * Between-class variance over total variance by definition.
 */
double Eta(const std::vector<double>& counts, size_t edge)
{
  double w[2] = {}, m[2] = {}, total = 0., mean = 0., variance = 0.;
  for (size_t b = 0; b < counts.size(); ++b)
  {
    w[b >= edge] += counts[b];
    m[b >= edge] += counts[b] * static_cast<double>(b);
    total += counts[b];
    mean += counts[b] * static_cast<double>(b);
  }
  for (size_t b = 0; b < counts.size(); ++b)
  {
    variance += counts[b] / total * std::pow(static_cast<double>(b) - mean / total, 2);
  }
  return w[0] > 0. && w[1] > 0.
    ? w[0] / total * w[1] / total * std::pow(m[1] / w[1] - m[0] / w[0], 2) / variance
    : 0.;
}
}

TEST(Split, SeparabilityIsBetweenClassVariance)
{
  const auto counts = Normal(5000, { { 60, 20 }, { 150, 9 }, { 90, 40 } });
  const auto eta = tfc::FindSeparabilities(counts);
  double best = 0.;
  for (size_t edge = 0; edge <= Bins; ++edge)
  {
    EXPECT_NEAR(eta[edge], Eta(counts, edge), 1e-12);
    best = std::max(best, Eta(counts, edge));
  }
  EXPECT_NEAR(tfc::FindSplit(counts, 5000.).Separability, best, 1e-12);
}

TEST(Split, TwoSpikes)
{
  std::vector<double> counts(Bins, 0.);
  counts[40] = 3.;
  counts[200] = 1.;
  const auto split = tfc::FindSplit(counts, 4.);
  EXPECT_NEAR(split.Separability, 1., 1e-12);
  EXPECT_NEAR(split.Threshold, 120.5, 1e-9) << "in the middle of the gap";
  EXPECT_NEAR(split.Below, 0.75, 1e-12);
  EXPECT_EQ(split.Weight, 4.);
  EXPECT_GT(split.Power, 0.9);
}

TEST(Split, TwoBellsAndOne)
{
  const auto two = tfc::FindSplit(Normal(100000, { { 70, 12 }, { 180, 12 } }), 100000.);
  EXPECT_GT(two.Power, 0.9);
  EXPECT_NEAR(two.Cut, 125., 12.);
  EXPECT_NEAR(two.Below, 0.5, 0.01);
  for (const int samples : { 300, 3000, 100000 })
  {
    const auto one = tfc::FindSplit(Normal(samples, { { 128, 25 } }), samples);
    EXPECT_NEAR(one.Separability, 2. / 3.14159265, 0.04);
    EXPECT_LT(one.Power, 0.1) << samples << " samples: noise makes no valley";
  }
  // A small part beside a large one is found where they meet, not inside of the large one.
  std::vector<std::pair<double, double>> parts(20, { 80, 12 });
  parts.push_back({ 200, 8 });
  const auto small = tfc::FindSplit(Normal(210000, parts), 210000.);
  EXPECT_GT(small.Valley, 0.9);
  EXPECT_GT(small.Cut, 125.);
  EXPECT_LT(small.Cut, 180.);
  EXPECT_NEAR(small.Below, 20. / 21., 0.002);
}

TEST(Split, NothingToSplit)
{
  EXPECT_EQ(tfc::FindSplit({}, 0.).Power, 0.);
  EXPECT_EQ(tfc::FindSplit(std::vector<double>(Bins, 0.), 0.).Separability, 0.);
  std::vector<double> counts(Bins, 0.);
  counts[7] = 50.;
  const auto split = tfc::FindSplit(counts, 50.);
  EXPECT_EQ(split.Separability, 0.);
  EXPECT_EQ(split.Weight, 50.);
  // A ramp has no valley.
  for (int b = 0; b < Bins; ++b)
  {
    counts[static_cast<size_t>(b)] = b;
  }
  EXPECT_EQ(tfc::FindSplit(counts, 1e6).Power, 0.);
}
