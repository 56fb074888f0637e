// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelVolumes.h"

#include "Filters/Kernels/TFCDiffusion.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace testing_volumes;

namespace
{
using Coefficients = tfc::DiffusionCoefficients;

/**
 * 0 along axes with one sample, as the kernel demands.
 */
Coefficients MakeCoefficients(const Size& n, float step, float edge)
{
  Coefficients coefficients;
  const float scale[3] = { 1.f, 0.5f, 0.25f };
  for (int a = 0; a < 3; ++a)
  {
    coefficients.Flux[a] = n[a] > 1 ? step * scale[a] : 0.f;
    coefficients.Edge[a] = n[a] > 1 ? edge * scale[a] : 0.f;
  }
  return coefficients;
}

template <bool Nonlinear, bool Masked>
std::vector<float> Diffuse(const std::vector<float>& from, const std::vector<float>& cycle,
  const Size& n, const Coefficients& coefficients)
{
  std::vector<float> to(from.size());
  tfc::DiffuseSlices<Nonlinear, Masked>(from.data(), cycle.data(), n.data(), coefficients, 0, n[2],
    to.data());
  return to;
}

/**
 * The definition at a sample, in double precision: the sum of the fluxes over its faces.
 */
double Reference(const std::vector<float>& from, const std::vector<float>& cycle, const Size& n,
  const Coefficients& coefficients, bool nonlinear, const Size& at)
{
  const double here = At(from, n, at[0], at[1], at[2]);
  const double edgeHere = At(cycle, n, at[0], at[1], at[2]);
  double sum = 0.;
  for (int a = 0; a < 3; ++a)
  {
    for (const int side : { -1, 1 })
    {
      Size there = at;
      there[a] += side;
      if (there[a] < 0 || there[a] >= n[a])
      {
        continue;
      }
      const double value = At(from, n, there[0], there[1], there[2]);
      const double g = At(cycle, n, there[0], there[1], there[2]) - edgeHere;
      const double c = nonlinear ? 1. / (1. + g * g * coefficients.Edge[a]) : 1.;
      sum += std::isnan(value) ? 0. : c * (value - here) * coefficients.Flux[a];
    }
  }
  return here + sum;
}

double Sum(const std::vector<float>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.);
}
}

TEST(Diffusion, CyclesLastAsLongAsTheyShould)
{
  for (int n = 1; n <= 40; ++n)
  {
    const double longest = tfc::GetLongestCycle(n, 1. / 6.);
    EXPECT_NEAR(longest, (n * n + n) / 18., 1e-12);
    for (const double time : { longest, 0.3 * longest })
    {
      const std::vector<double> steps = tfc::MakeCycle(n, time);
      ASSERT_EQ(static_cast<int>(steps.size()), n);
      EXPECT_NEAR(std::accumulate(steps.begin(), steps.end(), 0.), time, 1e-9 * time) << n;
    }
  }
  EXPECT_NEAR(tfc::MakeCycle(1, 0.125)[0], 0.125, 1e-12);
}

TEST(Diffusion, CyclesAreStableAndTheirOrderKeepsRoundingSmall)
{
  // The factors of a cycle and of its last steps, for the frequencies of the lattice.
  for (int n = 1; n <= tfc::MaximumCycleSteps; ++n)
  {
    const std::vector<double> steps = tfc::MakeCycle(n, tfc::GetLongestCycle(n, 1. / 6.));
    for (double lambda = 0.; lambda <= 12.; lambda += 0.01)
    {
      double factor = 1.;
      for (auto step = steps.rbegin(); step != steps.rend(); ++step)
      {
        factor *= 1. - *step * lambda;
        EXPECT_LE(std::fabs(factor), 20.) << n << " " << lambda;
      }
      EXPECT_LE(std::fabs(factor), 1. + 1e-9) << n << " " << lambda;
    }
  }
}

TEST(Diffusion, StepIsTheSumOfFluxes)
{
  for (const Size& n : GetSizes())
  {
    const auto from = MakeNoise(n, 1, 0.1), other = MakeNoise(n, 2);
    auto cycle = other;
    for (size_t i = 0; i < cycle.size(); ++i)
    {
      // Invalid samples stay invalid throughout a cycle.
      cycle[i] = std::isnan(from[i]) ? NaN : cycle[i];
    }
    const Coefficients coefficients = MakeCoefficients(n, 0.15f, 3.f);
    const auto linear = Diffuse<false, true>(from, cycle, n, coefficients);
    const auto nonlinear = Diffuse<true, true>(from, cycle, n, coefficients);
    for (tfc::Index i = 0; i < static_cast<tfc::Index>(from.size()); ++i)
    {
      const Size at = { i % n[0], i / n[0] % n[1], i / (n[0] * n[1]) };
      if (std::isnan(from[i]))
      {
        EXPECT_TRUE(std::isnan(linear[i]) && std::isnan(nonlinear[i]));
        continue;
      }
      EXPECT_NEAR(linear[i], Reference(from, cycle, n, coefficients, false, at), 2e-6);
      EXPECT_NEAR(nonlinear[i], Reference(from, cycle, n, coefficients, true, at), 2e-6);
    }
  }
}

TEST(Diffusion, MaskedAndPlainGiveTheSameBitsForValidData)
{
  for (const Size& n : GetSizes())
  {
    const auto from = MakeNoise(n, 3), cycle = MakeNoise(n, 4);
    const Coefficients coefficients = MakeCoefficients(n, 0.15f, 3.f);
    const auto plain = Diffuse<true, false>(from, cycle, n, coefficients);
    const auto masked = Diffuse<true, true>(from, cycle, n, coefficients);
    EXPECT_EQ(plain, masked);
    const auto plainLinear = Diffuse<false, false>(from, cycle, n, coefficients);
    const auto maskedLinear = Diffuse<false, true>(from, cycle, n, coefficients);
    EXPECT_EQ(plainLinear, maskedLinear);
  }
}

TEST(Diffusion, ConservesTheSumAndInventsNoExtrema)
{
  for (const Size& n : GetSizes())
  {
    auto values = MakeNoise(n, 5);
    const double sum = Sum(values);
    const auto range = std::minmax_element(values.begin(), values.end());
    const float low = *range.first, high = *range.second;
    const Coefficients coefficients = MakeCoefficients(n, 1.f / 6.f, 2.f);
    for (int step = 0; step < 20; ++step)
    {
      values = Diffuse<true, false>(values, values, n, coefficients);
      for (const float value : values)
      {
        EXPECT_GE(value, low - 1e-6f);
        EXPECT_LE(value, high + 1e-6f);
      }
    }
    EXPECT_NEAR(Sum(values), sum, 1e-5 * static_cast<double>(values.size()));
  }
}

TEST(Diffusion, NothingPassesAWall)
{
  const Size n = { 9, 6, 5 };
  auto values = Make(n, [](auto x, auto, auto) { return x < 4 ? 1. : x == 4 ? NaN : 0.; });
  for (int step = 0; step < 30; ++step)
  {
    values = Diffuse<false, true>(values, values, n, MakeCoefficients(n, 0.15f, 0.f));
  }
  const auto expected = Make(n, [](auto x, auto, auto) { return x < 4 ? 1. : x == 4 ? NaN : 0.; });
  for (size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_TRUE(values[i] == expected[i] || std::isnan(expected[i]));
  }
}

TEST(Diffusion, MirroredDataGiveMirroredBits)
{
  const Size n = { 13, 9, 8 };
  const auto from = MakeNoise(n, 6), cycle = MakeNoise(n, 7);
  const Coefficients coefficients = MakeCoefficients(n, 0.15f, 3.f);
  const auto result = Diffuse<true, false>(from, cycle, n, coefficients);
  const auto mirror = [&](const std::vector<float>& v, int axis)
  {
    return Make(n,
      [&](auto x, auto y, auto z)
      {
        Size at = { x, y, z };
        at[axis] = n[axis] - 1 - at[axis];
        return At(v, n, at[0], at[1], at[2]);
      });
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto mirrored =
      Diffuse<true, false>(mirror(from, axis), mirror(cycle, axis), n, coefficients);
    EXPECT_EQ(mirrored, mirror(result, axis)) << axis;
  }
}

TEST(Diffusion, LaplacianOfAParabola)
{
  const Size n = { 12, 11, 10 };
  const float weights[3] = { 1.f, 2.f, 3.f };
  auto values = Make(n,
    [](auto x, auto y, auto z) { return 0.5 * x * x - 1.5 * y * y + 0.25 * z * z + x - 2. * z; });
  std::vector<float> result(values.size());
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    tfc::LaplacianSlice<false>(values.data(), n.data(), weights, z, result.data());
  }
  for (tfc::Index z = 1; z < n[2] - 1; ++z)
  {
    for (tfc::Index y = 1; y < n[1] - 1; ++y)
    {
      for (tfc::Index x = 1; x < n[0] - 1; ++x)
      {
        EXPECT_NEAR(At(result, n, x, y, z), 1. - 2. * 3. + 3. * 0.5, 1e-4);
      }
    }
  }
  values[tfc::Index{ 5 } + 12 * (5 + 11 * 5)] = NaN;
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    tfc::LaplacianSlice<true>(values.data(), n.data(), weights, z, result.data());
  }
  EXPECT_EQ(At(result, n, 5, 5, 5), 0.f);
  EXPECT_TRUE(std::none_of(result.begin(), result.end(), [](float v) { return std::isnan(v); }));
}
