// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelVolumes.h"

#include <gtest/gtest.h>

using namespace testing_volumes;

namespace
{
/**
 * Gradient magnitude of a whole volume by the kernel.
 */
template <bool Masked>
std::vector<float> Compute(const std::vector<float>& volume, const Size& n,
  const std::array<float, 3>& weights)
{
  std::vector<float> out(volume.size());
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    for (tfc::Index y = 0; y < n[1]; ++y)
    {
      float* row = out.data() + (z * n[1] + y) * n[0];
      tfc::GradientSquaredRow<Masked>(volume.data(), n.data(), y, z, 0, n[0], weights.data(), row);
      tfc::RootRow(row, n[0], 1.f);
    }
  }
  return out;
}

/**
 * The definition, sample by sample in double precision.
 */
double Reference(const std::vector<float>& volume, const Size& n,
  const std::array<float, 3>& weights, const Size& at)
{
  const double center = At(volume, n, at[0], at[1], at[2]);
  double sum = 0.;
  for (int a = 0; a < 3; ++a)
  {
    Size low = at, high = at;
    --low[a];
    ++high[a];
    const bool useLow = low[a] >= 0 && !std::isnan(At(volume, n, low[0], low[1], low[2]));
    const bool useHigh = high[a] < n[a] && !std::isnan(At(volume, n, high[0], high[1], high[2]));
    const double lower = useLow ? At(volume, n, low[0], low[1], low[2]) : center;
    const double upper = useHigh ? At(volume, n, high[0], high[1], high[2]) : center;
    const double d = (upper - lower) * weights[a] / (useLow && useHigh ? 2. : 1.);
    sum += d * d;
  }
  return std::isnan(center) ? center : std::sqrt(sum);
}
}

TEST(Gradient, LinearFieldIsExactEverywhere)
{
  for (const Size& n : GetSizes())
  {
    const auto volume = Make(n, [](auto x, auto y, auto z) { return 3. * x - 2. * y + 6. * z; });
    const double expected =
      std::sqrt((n[0] > 1 ? 9. : 0.) + (n[1] > 1 ? 4. / 4. : 0.) + (n[2] > 1 ? 36. * 16. : 0.));
    for (const float g : Compute<false>(volume, n, { 1.f, 0.5f, 4.f }))
    {
      EXPECT_NEAR(g, expected, 1e-5 * expected);
    }
  }
}

TEST(Gradient, QuadraticFieldIsExactInside)
{
  // A central difference of a parabola is its derivative.
  const Size n{ 12, 10, 9 };
  const auto volume = Make(n, [](auto x, auto y, auto z) { return x * x + 2. * y * y - z * z; });
  const auto g = Compute<false>(volume, n, { 1.f, 1.f, 1.f });
  for (tfc::Index z = 1; z + 1 < n[2]; ++z)
  {
    for (tfc::Index y = 1; y + 1 < n[1]; ++y)
    {
      for (tfc::Index x = 1; x + 1 < n[0]; ++x)
      {
        const double expected = std::sqrt(4. * x * x + 16. * y * y + 4. * z * z);
        EXPECT_NEAR(At(g, n, x, y, z), expected, 1e-5 * expected);
      }
    }
  }
}

TEST(Gradient, RadialFieldHasSlopeOne)
{
  // |grad |p|| = 1; central differences err by h^2 / 6 times third derivatives of order 1 / r^2.
  const Size n{ 41, 41, 41 };
  const auto r = [](auto x, auto y, auto z)
  { return std::sqrt((x - 20.) * (x - 20.) + (y - 20.) * (y - 20.) + (z - 20.) * (z - 20.)); };
  const auto g = Compute<false>(Make(n, r), n, { 1.f, 1.f, 1.f });
  for (tfc::Index z = 1; z + 1 < n[2]; ++z)
  {
    for (tfc::Index y = 1; y + 1 < n[1]; ++y)
    {
      for (tfc::Index x = 1; x + 1 < n[0]; ++x)
      {
        if (r(x, y, z) > 10.)
        {
          EXPECT_NEAR(At(g, n, x, y, z), 1., 0.01);
        }
      }
    }
  }
}

TEST(Gradient, MatchesDefinitionOnNoise)
{
  const std::array<float, 3> weights{ 1.f, 0.25f, 2.5f };
  for (const Size& n : GetSizes())
  {
    for (const double invalid : { 0., 0.2, 0.7 })
    {
      const auto volume = MakeNoise(n, 17, invalid);
      const auto masked = Compute<true>(volume, n, weights);
      const auto plain = Compute<false>(volume, n, weights);
      for (tfc::Index z = 0; z < n[2]; ++z)
      {
        for (tfc::Index y = 0; y < n[1]; ++y)
        {
          for (tfc::Index x = 0; x < n[0]; ++x)
          {
            const double expected = Reference(volume, n, weights, { x, y, z });
            const float value = At(masked, n, x, y, z);
            if (std::isnan(expected))
            {
              EXPECT_TRUE(std::isnan(value));
              continue;
            }
            EXPECT_NEAR(value, expected, 1e-5 * (1. + expected));
            if (invalid == 0.)
            {
              EXPECT_NEAR(At(plain, n, x, y, z), expected, 1e-5 * (1. + expected));
            }
          }
        }
      }
    }
  }
}

TEST(Gradient, PartOfARowIsThatPartOfTheRow)
{
  const Size n{ 19, 5, 4 };
  const auto volume = MakeNoise(n, 3);
  const float weights[3] = { 1.f, 1.f, 1.f };
  std::vector<float> whole(19), part(19);
  tfc::GradientSquaredRow<false>(volume.data(), n.data(), 2, 1, 0, 19, weights, whole.data());
  for (tfc::Index x0 = 0; x0 < 19; ++x0)
  {
    for (tfc::Index x1 = x0 + 1; x1 <= 19; ++x1)
    {
      tfc::GradientSquaredRow<false>(volume.data(), n.data(), 2, 1, x0, x1, weights, part.data());
      for (tfc::Index x = x0; x < x1; ++x)
      {
        ASSERT_EQ(part[x - x0], whole[x]);
      }
    }
  }
}
