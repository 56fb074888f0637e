// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SphereReference.h"

using namespace testing_volumes;

TEST(LargeSpheres, MatchDefinition)
{
  // Beyond the tiles' height and the first batch of shared slices; thin along each axis.
  for (const Size& n : { Size{ 18, 9, 13 }, Size{ 5, 4, 70 }, Size{ 25, 20, 1 }, Size{ 40, 1, 20 },
         Size{ 1, 20, 25 }, Size{ 1, 1, 300 }, Size{ 3, 2, 90 } })
  {
    for (const double invalid : { 0., 0.05, 0.6 })
    {
      ExpectReference(MakeNormal(n, 3, invalid), n, WithRadius(10.));
    }
  }
  const Size n{ 17, 10, 15 };
  ExpectReference(MakeNormal(n, 4), n, WithRadius(14., 0.001));
  ExpectReference(MakeNormal(n, 5, 0.3), n, WithRadius(14., 0.001));
  for (const double radius : { 4., 5., 6.5, 7., 8., 11. })
  {
    ExpectReference(MakeNormal({ 18, 7, 9 }, 6), { 18, 7, 9 }, WithRadius(radius));
  }
}

TEST(LargeSpheres, MatchDefinitionInWorldUnits)
{
  const Size n{ 18, 12, 24 };
  for (const auto& spacing : { std::array<double, 3>{ 0.7, 1.9, 1.1 },
         std::array<double, 3>{ 1., 1.3, 0.4 }, std::array<double, 3>{ 1., 1., 3. } })
  {
    auto parameters = WithRadius(10. * *std::min_element(spacing.begin(), spacing.end()));
    std::copy(spacing.begin(), spacing.end(), parameters.Spacing);
    ExpectReference(MakeNormal(n, 8), n, parameters);
    ExpectReference(MakeNormal(n, 9, 0.2), n, parameters);
  }
}

TEST(LargeSpheres, KeepDigits)
{
  // A deviation far below the values, where neighbours are 3e-5 apart; with constant regions; and
  // two levels in one column.
  const Size n{ 20, 10, 26 };
  const double unit = 32.;
  ExpectReference(MakeNormal(n, 12, 0., 300., 0.01), n, WithRadius(10.), unit);
  auto levels = MakeNormal(n, 13, 0.02, 300., 0.01);
  for (size_t i = 0; i < levels.size(); ++i)
  {
    levels[i] = i < levels.size() / 3 ? 299.7f
      : i > levels.size() / 3 * 2     ? levels[i] + 5.f
                                      : levels[i];
  }
  ExpectReference(levels, n, WithRadius(10.), unit);
}

TEST(LargeSpheres, BothWaysOfSummingAgree)
{
  const Size n{ 40, 20, 80 };
  const double spacings[][3] = { { 1., 1., 1. }, { 0.8, 1.2, 1. } };
  for (const double invalid : { 0., 0.001, 0.2 })
  {
    const auto volume = MakeNormal(n, 41, invalid);
    for (const auto& spacing : spacings)
    {
      auto parameters = WithRadius(9.);
      std::copy(spacing, spacing + 3, parameters.Spacing);
      const auto shared = Compute(volume, n, parameters);
      parameters.Direct = 100;
      const auto direct = Compute(volume, n, parameters);
      size_t differences = 0, large = 0;
      for (size_t i = 0; i < volume.size(); ++i)
      {
        const float radius = shared[tfc::SphereRadius][i];
        large += radius > 8.9f * 0.8f;
        if (radius != direct[tfc::SphereRadius][i])
        {
          differences += std::isnan(volume[i]) ? 0 : 1;
          continue;
        }
        for (size_t s = 0; s < shared.size(); ++s)
        {
          // Each is as close to the definition as ExpectReference() wants it.
          ASSERT_NEAR(shared[s][i], direct[s][i], s < tfc::SphereSkewness ? 8e-6 : 4e-4);
        }
      }
      EXPECT_LE(differences, volume.size() / 10000);
      EXPECT_GT(large, volume.size() / 4);
    }
  }
}

TEST(LargeSpheres, PartsHaveTheBitsOfTheWhole)
{
  // Voxels that stop early everywhere change which slices a column skips.
  const Size n{ 30, 12, 100 };
  for (const double invalid : { 0., 0.01 })
  {
    auto volume = MakeNormal(n, 22, invalid);
    for (size_t i = 0; i < volume.size(); i += 997)
    {
      volume[i] += 9.f;
    }
    const auto parameters = WithRadius(11., 0.001);
    const auto whole = Compute(volume, n, parameters);
    for (const tfc::Index cut : { 1, 37, 64, 70 })
    {
      // [cut, cut + 20) of z, with a halo of 11 where the volume goes on.
      const tfc::Index from = std::max<tfc::Index>(cut - 11, 0), to = std::min(cut + 31, n[2]);
      const Size size{ 30, 12, to - from };
      const auto lattice =
        Make(size, [&](auto x, auto y, auto z) { return At(volume, n, x, y, z + from); });
      const auto part =
        Compute(lattice, size, { 0, 0, cut - from }, { 30, 12, cut - from + 20 }, n, parameters);
      for (size_t s = 0; s < whole.size(); ++s)
      {
        for (size_t i = 0; i < part[s].size(); ++i)
        {
          const float a = part[s][i], b = whole[s][i + static_cast<size_t>(cut * n[0] * n[1])];
          ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b)));
        }
      }
    }
  }
}
