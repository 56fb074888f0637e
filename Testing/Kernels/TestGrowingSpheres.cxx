// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SphereReference.h"

using namespace testing_volumes;

TEST(GrowingSpheres, MatchDefinition)
{
  for (const Size& n : GetSizes())
  {
    for (const double invalid : { 0., 0.1, 0.9 })
    {
      ExpectReference(MakeNoise(n, 11, invalid), n, {});
    }
  }
  // Large enough for groups without a border.
  const Size large{ 45, 15, 13 };
  ExpectReference(MakeNoise(large, 5), large, {});
  ExpectReference(MakeNoise(large, 6, 0.01), large, {});
}

TEST(GrowingSpheres, MatchDefinitionInWorldUnits)
{
  Parameters parameters;
  parameters.Radius = 4.2;
  parameters.Spacing[0] = 0.7;
  parameters.Spacing[1] = 1.9;
  parameters.Spacing[2] = 1.1;
  const Size n{ 40, 9, 14 };
  ExpectReference(MakeNoise(n, 8), n, parameters);
  ExpectReference(MakeNoise(n, 9, 0.2), n, parameters);
}

TEST(GrowingSpheres, StopAtAStep)
{
  // Two constant halves: growth ends where the sphere would reach the other one.
  const Size n{ 40, 15, 15 };
  const auto volume = Make(n, [](auto x, auto, auto) { return x < 20 ? 1.5 : 2.5; });
  const auto out = Compute(volume, n, {});
  for (tfc::Index x = 0; x < n[0]; ++x)
  {
    const tfc::Index distance = x < 20 ? 20 - x : x - 19;
    const size_t i = static_cast<size_t>((7 * n[1] + 7) * n[0] + x);
    if (distance > 1)
    {
      EXPECT_EQ(out[tfc::SphereRadius][i],
        static_cast<float>(std::min<tfc::Index>(5, distance - 1)));
      EXPECT_EQ(out[tfc::SphereMean][i], x < 20 ? 1.5f : 2.5f);
      EXPECT_EQ(out[tfc::SphereDeviation][i], 0.f);
      EXPECT_EQ(out[tfc::SphereSkewness][i], 0.f);
      EXPECT_EQ(out[tfc::SphereKurtosis][i], 3.f);
    }
  }
}

TEST(GrowingSpheres, PartsHaveTheBitsOfTheWhole)
{
  const Size n{ 50, 20, 18 };
  for (const double invalid : { 0., 0.05 })
  {
    const auto volume = MakeNoise(n, 21, invalid);
    const auto whole = Compute(volume, n, {});
    // A block with a halo of the reach, 5, where the volume goes on: [18, 41) of x, all of y, [3,
    // 9) of z.
    const Size begin{ 5, 0, 3 }, end{ 28, 20, 9 }, size{ 32, 20, 14 };
    const auto lattice =
      Make(size, [&](auto x, auto y, auto z) { return At(volume, n, x + 13, y, z); });
    const auto part = Compute(lattice, size, begin, end, n, {});
    for (size_t s = 0; s < whole.size(); ++s)
    {
      size_t i = 0;
      for (tfc::Index z = 3; z < 9; ++z)
      {
        for (tfc::Index y = 0; y < 20; ++y)
        {
          for (tfc::Index x = 18; x < 41; ++x, ++i)
          {
            const float a = part[s][i], b = At(whole[s], n, x, y, z);
            ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b)));
          }
        }
      }
    }
  }
}

TEST(GrowingSpheres, GapsChangeNoBitElsewhere)
{
  // One gap: groups nearby are added up with weights, others without.
  const Size n{ 64, 20, 20 };
  for (const double reach : { 5., 9. })
  {
    auto volume = MakeNormal(n, 31);
    const auto complete = Compute(volume, n, WithRadius(reach));
    volume[(10 * n[1] + 10) * n[0] + 30] = NaN;
    const auto holed = Compute(volume, n, WithRadius(reach));
    size_t compared = 0, i = 0;
    for (tfc::Index z = 0; z < n[2]; ++z)
    {
      for (tfc::Index y = 0; y < n[1]; ++y)
      {
        for (tfc::Index x = 0; x < n[0]; ++x, ++i)
        {
          if (std::hypot(x - 30., y - 10., z - 10.) > reach)
          {
            ++compared;
            for (size_t s = 0; s < holed.size(); ++s)
            {
              ASSERT_EQ(holed[s][i], complete[s][i]);
            }
          }
        }
      }
    }
    EXPECT_EQ(compared, volume.size() - (reach < 6. ? 515 : 3071));
  }
}

TEST(GrowingSpheres, ScaleRoundsNothing)
{
  const Size n{ 20, 12, 12 };
  auto volume = MakeNoise(n, 2);
  const auto expected = Compute(volume, n, {});
  // Values whose fourth powers float does not hold.
  for (const int exponent : { -60, 60 })
  {
    auto scaled = volume;
    for (float& v : scaled)
    {
      v = std::ldexp(v, exponent);
    }
    Parameters parameters;
    parameters.Scale = std::ldexp(1.f, -exponent);
    const auto out = Compute(scaled, n, parameters);
    for (size_t i = 0; i < volume.size(); ++i)
    {
      EXPECT_EQ(out[tfc::SphereRadius][i], expected[tfc::SphereRadius][i]);
      EXPECT_EQ(out[tfc::SphereMean][i], std::ldexp(expected[tfc::SphereMean][i], exponent));
      EXPECT_EQ(out[tfc::SphereDeviation][i],
        std::ldexp(expected[tfc::SphereDeviation][i], exponent));
      EXPECT_EQ(out[tfc::SphereKurtosis][i], expected[tfc::SphereKurtosis][i]);
    }
  }
}
