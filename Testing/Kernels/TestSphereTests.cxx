// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Golden values: SciPy 1.10 (t, skewtest, kurtosistest), except where its skewtest takes symmetric
// samples for asymmetric ones.
#include "Filters/Kernels/TFCSphereShells.h"
#include "Filters/Kernels/TFCSphereTests.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>

namespace
{
double GetK2(const std::vector<double>& values)
{
  const double n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.) / n;
  double m2 = 0., m3 = 0., m4 = 0.;
  for (const double v : values)
  {
    const double d = v - mean;
    m2 += d * d / n;
    m3 += d * d * d / n;
    m4 += d * d * d * d / n;
  }
  return tfc::NormalityStatistic(n, m2, m3, m4);
}

tfc::SampleMoments GetMoments(const std::vector<double>& values)
{
  const double n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.) / n;
  double squares = 0.;
  for (const double v : values)
  {
    squares += (v - mean) * (v - mean);
  }
  return { n, mean, n > 1. ? squares / (n - 1.) : 0. };
}

std::vector<double> Make(int n, const std::function<double(int)>& f)
{
  std::vector<double> values;
  for (int i = 1; i <= n; ++i)
  {
    values.push_back(f(i));
  }
  return values;
}

/**
 * Sums of the samples in all lanes.
 */
tfc::PowerSums GetSums(const std::vector<double>& values, double shift)
{
  tfc::PowerSums sums{};
  for (int i = 0; i < tfc::Lanes; ++i)
  {
    sums.Count[i] = static_cast<float>(values.size());
    for (const double v : values)
    {
      float power = 1.f;
      for (auto& sum : sums.Sum)
      {
        power *= static_cast<float>(v - shift);
        sum[i] += power;
      }
    }
  }
  return sums;
}
}

TEST(Normality, GoldenValues)
{
  const auto squares = Make(33, [](int i) { return static_cast<double>(i * i); });
  EXPECT_NEAR(GetK2(squares), 4.27299538723, 1e-10);
  const tfc::NormalityConstants constants(33.);
  EXPECT_NEAR(constants.GetZ1(.620971000036), 1.60802213973, 1e-9);
  EXPECT_NEAR(constants.GetZ2(2.11955134996), -1.2989457977, 1e-9);
  EXPECT_NEAR(tfc::NormalityCritical(.001), 13.815511, 1e-6);
  EXPECT_NEAR(tfc::NormalityCritical(.01), 9.210340, 1e-6);
}

TEST(Normality, SymmetricSamples)
{
  EXPECT_NEAR(GetK2(Make(33, [](int i) { return i; })), 6.26877781016, 1e-9);
}

TEST(Normality, TwoValues)
{
  EXPECT_NEAR(GetK2(Make(33, [](int i) { return i <= 16 ? 0. : 1.; })), 701.546, 1e-3);
}

TEST(Normality, SevenSamplesHaveTheLimit)
{
  // Z1 is Y, 10 / 30 * skewness^2 at n = 7, and close to what larger samples give.
  const tfc::NormalityConstants constants(7.);
  EXPECT_NEAR(constants.GetZ1(.5), .5 * std::sqrt(80. / 30.), 1e-6);
  EXPECT_TRUE(std::isfinite(constants.GetZ2(2.)));
  EXPECT_NEAR(constants.GetZ1(.5), tfc::NormalityConstants(7.0001).GetZ1(.5), 1e-3);
}

TEST(Normality, IdenticalSamplesPass)
{
  EXPECT_EQ(GetK2(Make(33, [](int) { return 12.; })), 0.);
}

TEST(Welch, GoldenValues)
{
  const std::vector<double> a{ 1, 2, 3, 4, 5, 6, 7 }, b{ 3, 4, 5, 6, 7, 8, 9, 20 };
  const tfc::WelchComparison test(GetMoments(a), GetMoments(b));
  EXPECT_NEAR(test.Difference / std::sqrt(test.Variance), -1.82349202156, 1e-10);
  EXPECT_NEAR(1. / test.InverseFreedom, 9.47779469263, 1e-10);
  EXPECT_NEAR(std::exp(tfc::LogStudentTail(1.82349202156, 9.47779469263)), .0998641161811, 1e-11);
  EXPECT_TRUE(tfc::WelchSimilar(GetMoments(a), GetMoments(b), .0998));
  EXPECT_FALSE(tfc::WelchSimilar(GetMoments(a), GetMoments(b), .0999));
}

TEST(Welch, Quantiles)
{
  const double golden[][3] = { { .001, 1, 636.619249432 }, { .001, 6, 5.95881617993 },
    { .001, 26, 3.70661174331 }, { .001, 100, 3.39049131941 }, { .001, 4096, 3.29290371244 },
    { .001, 1e300, 3.29052673 }, { .1, 2, 2.91998558036 }, { .1, 1e300, 1.64485362695 },
    { .9, 1, .158384440325 }, { 1e-10, 6, 93.6312095107 } };
  for (const auto& g : golden)
  {
    EXPECT_NEAR(tfc::StudentCritical(g[0], g[1]) / g[2], 1., 1e-8) << g[0] << " " << g[1];
  }
}

TEST(Welch, DegenerateSamples)
{
  const tfc::SampleMoments flat{ 7., 2., 0. }, same{ 26., 2., 0. }, other{ 26., 2.001, 0. };
  EXPECT_TRUE(tfc::WelchSimilar(flat, same, .001));
  EXPECT_FALSE(tfc::WelchSimilar(flat, other, .001));
  // An empty shell; a single sample within and beyond the scatter of the others.
  const tfc::SampleMoments some{ 9., 2., 1. };
  EXPECT_TRUE(tfc::WelchSimilar(some, { 0., 0., 0. }, .001));
  EXPECT_TRUE(tfc::WelchSimilar(some, { 1., 5., 0. }, .001));
  EXPECT_FALSE(tfc::WelchSimilar(some, { 1., 9., 0. }, .001));
  EXPECT_TRUE(tfc::WelchSimilar({ 1., 5., 0. }, some, .001));
  EXPECT_TRUE(tfc::WelchSimilar({ 1., 5., 0. }, { 1., 5., 0. }, .001));
  EXPECT_FALSE(tfc::WelchSimilar({ 1., 5., 0. }, { 1., 6., 0. }, .001));
}

TEST(SphereTests, LogarithmOfTheLanes)
{
  for (double x = 1.; x < 1e12; x *= 1.0003)
  {
    const auto value = static_cast<float>(x);
    const double expected = std::log(static_cast<double>(value));
    ASSERT_NEAR(tfc::LaneLog(value), expected, 1.5e-7 * std::max(expected, 0.3)) << x;
  }
}

TEST(SphereTests, DecideAsTheTestsInDouble)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal(5., 2.);
  std::uniform_real_distribution<double> uniform(0., 1.);
  int decisions = 0, differences = 0, passes = 0;
  for (const double alpha : { .001, .1, .9 })
  {
    const tfc::SphereTests tests(alpha, 600);
    for (int i = 0; i < 2000; ++i)
    {
      // Sizes from 1 on, skewed by an exponential part, and shells that differ a little.
      const int n1 = 1 + static_cast<int>(uniform(random) * 200.);
      const int n2 = static_cast<int>(uniform(random) * 300.);
      const double skew = 3. * uniform(random), step = 2. * uniform(random) / std::sqrt(n1);
      std::vector<double> inner, shell;
      for (int k = 0; k < n1 + n2; ++k)
      {
        auto& to = k < n1 ? inner : shell;
        to.push_back(normal(random) - skew * std::log(1. - uniform(random)) + (k < n1 ? 0. : step));
      }
      auto all = inner;
      all.insert(all.end(), shell.begin(), shell.end());
      const double shift = inner[0];
      const auto sums = GetSums(all, shift);
      tfc::SphereTests::LaneConstants constants;
      tests.Look(sums.Count, constants);
      std::int32_t isNormal[tfc::Lanes], isSimilar[tfc::Lanes];
      std::fill(isNormal, isNormal + tfc::Lanes, 1);
      std::fill(isSimilar, isSimilar + tfc::Lanes, 1);
      tests.TestNormality(sums, constants, isNormal);
      tests.TestSimilarity(GetSums(inner, shift), GetSums(shell, shift), isSimilar);
      const bool expectNormal = all.size() < 8 || GetK2(all) < tfc::NormalityCritical(alpha);
      const bool expectSimilar = tfc::WelchSimilar(GetMoments(inner), GetMoments(shell), alpha);
      for (int lane = 1; lane < tfc::Lanes; ++lane)
      {
        EXPECT_EQ(isNormal[lane], isNormal[0]);
        EXPECT_EQ(isSimilar[lane], isSimilar[0]);
      }
      decisions += 2;
      passes += expectNormal + expectSimilar;
      differences += (isNormal[0] != expectNormal) + (isSimilar[0] != expectSimilar);
    }
  }
  EXPECT_LE(differences, decisions / 2000);
  // Both outcomes are common: the comparison means something.
  EXPECT_GT(passes, decisions / 5);
  EXPECT_LT(passes, decisions * 4 / 5);
}

TEST(SphereShells, CountsOnACubicLattice)
{
  const tfc::Index size[3] = { 100, 100, 100 };
  const double cubic[3] = { 1., 1., 1. };
  const auto shells = tfc::SphereShells::Make(size, cubic, 12.);
  const tfc::Index counts[] = { 0, 7, 33, 123, 257, 515, 925, 1419, 2109, 3071, 4169, 5575, 7153 };
  ASSERT_EQ(shells.NumberOfShells, 12);
  for (size_t k = 0; k <= 12; ++k)
  {
    EXPECT_EQ(shells.Ends[k], counts[k]);
  }
  // Neither scale nor rounding of the spacing matters.
  const double scaled[3] = { 0.1, 0.1, 0.1 };
  EXPECT_EQ(tfc::SphereShells::Make(size, scaled, 1.2).Offsets.size(), 7153u);
}

TEST(SphereShells, AnisotropicAndThin)
{
  const double spacing[3] = { 1., 2., 3. };
  const tfc::Index size[3] = { 50, 50, 50 };
  const auto shells = tfc::SphereShells::Make(size, spacing, 6.5);
  EXPECT_EQ(shells.NumberOfShells, 6);
  EXPECT_EQ(shells.Reach[0], 6);
  EXPECT_EQ(shells.Reach[1], 3);
  EXPECT_EQ(shells.Reach[2], 2);
  EXPECT_EQ(shells.Ends[1], 3); // only along x
  for (size_t i = 0; i < shells.Offsets.size(); ++i)
  {
    const auto& o = shells.Offsets[i];
    const double length = std::hypot(o[0] * 1., o[1] * 2., o[2] * 3.);
    size_t k = 1;
    while (static_cast<tfc::Index>(i) >= shells.Ends[k])
    {
      ++k;
    }
    EXPECT_LE(length, static_cast<double>(k));
    EXPECT_TRUE(k == 1 || length > static_cast<double>(k - 1));
  }
  // The step is that of the axes that exist; offsets outside of every volume are left out.
  const tfc::Index line[3] = { 1, 1, 4 };
  const auto thin = tfc::SphereShells::Make(line, spacing, 30.);
  EXPECT_EQ(thin.Step, 3.);
  EXPECT_EQ(thin.NumberOfShells, 10);
  EXPECT_EQ(thin.Offsets.size(), 7u);
  EXPECT_EQ(tfc::SphereShells(line, spacing, 2.9).NumberOfShells, 0);
}
