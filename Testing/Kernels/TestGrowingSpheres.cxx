// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCGrowingSpheres.h"
#include "KernelVolumes.h"

#include <gtest/gtest.h>

using namespace testing_volumes;

namespace
{
using Statistics = std::array<std::vector<float>, tfc::NumberOfSphereStatistics>;

struct Parameters
{
  double Radius = 5., Alpha = 0.01;
  double Spacing[3] = { 1., 1., 1. };
  float Scale = 1.f;
};

/**
 * The statistics of the block [begin, end) of a lattice that is part of a volume of `whole`
 * samples.
 */
Statistics Compute(const std::vector<float>& lattice, const Size& n, const Size& begin,
  const Size& end, const Size& whole, const Parameters& parameters)
{
  const auto shells = tfc::SphereShells::Make(whole.data(), parameters.Spacing, parameters.Radius);
  const tfc::SphereTests tests(parameters.Alpha, shells.Ends.back());
  const tfc::GrowingSpheres spheres(shells, tests, n.data(), begin.data(), end.data(),
    parameters.Scale);
  Statistics out;
  float* pointers[tfc::NumberOfSphereStatistics];
  for (size_t s = 0; s < out.size(); ++s)
  {
    out[s].assign((end[0] - begin[0]) * (end[1] - begin[1]) * (end[2] - begin[2]), -77.f);
    pointers[s] = out[s].data();
  }
  tfc::GrowingSpheres::Workspace work;
  for (tfc::Index tile = 0; tile < spheres.GetNumberOfTiles(); ++tile)
  {
    spheres.ComputeTile(lattice.data(), tile, pointers, work);
  }
  return out;
}

Statistics Compute(const std::vector<float>& volume, const Size& n, const Parameters& parameters)
{
  return Compute(volume, n, { 0, 0, 0 }, n, n, parameters);
}

struct Moments
{
  double Count = 0., Mean = 0., M2 = 0., M3 = 0., M4 = 0.;

  explicit Moments(const std::vector<double>& values)
    : Count(static_cast<double>(values.size()))
  {
    for (const double v : values)
    {
      this->Mean += v / this->Count;
    }
    for (const double v : values)
    {
      const double d = v - this->Mean;
      this->M2 += d * d / this->Count;
      this->M3 += d * d * d / this->Count;
      this->M4 += d * d * d * d / this->Count;
    }
  }
  double GetVariance() const
  {
    return this->Count > 1. ? this->M2 * this->Count / (this->Count - 1.) : 0.;
  }
};

/**
 * The statistics of one voxel by their definition.
 */
std::array<double, tfc::NumberOfSphereStatistics> Reference(const std::vector<float>& volume,
  const Size& n, const Size& at, const Parameters& parameters)
{
  const auto shells = tfc::SphereShells::Make(n.data(), parameters.Spacing, parameters.Radius);
  const auto collect = [&](tfc::Index k)
  {
    std::vector<double> values;
    for (tfc::Index i = shells.Ends[k - 1]; i < shells.Ends[k]; ++i)
    {
      const auto& o = shells.Offsets[i];
      const tfc::Index x = at[0] + o[0], y = at[1] + o[1], z = at[2] + o[2];
      const bool inside = x >= 0 && x < n[0] && y >= 0 && y < n[1] && z >= 0 && z < n[2];
      if (inside && !std::isnan(At(volume, n, x, y, z)))
      {
        values.push_back(At(volume, n, x, y, z));
      }
    }
    return values;
  };
  auto accepted = collect(1);
  tfc::Index radius = 1;
  for (tfc::Index k = 2; k <= shells.NumberOfShells; ++k)
  {
    const auto shell = collect(k);
    auto all = accepted;
    all.insert(all.end(), shell.begin(), shell.end());
    const Moments old(accepted), added(shell), both(all);
    const bool normal = both.Count < 8. ||
      tfc::NormalityStatistic(both.Count, both.M2, both.M3, both.M4) <
        tfc::NormalityCritical(parameters.Alpha);
    if (!normal ||
      !tfc::WelchSimilar({ old.Count, old.Mean, old.GetVariance() },
        { added.Count, added.Mean, added.GetVariance() }, parameters.Alpha))
    {
      break;
    }
    accepted = all;
    radius = k;
  }
  const Moments m(accepted);
  const bool varies = m.M2 > 0.;
  return { m.Mean, std::sqrt(m.GetVariance()), static_cast<double>(radius) * shells.Step,
    varies ? m.M3 / std::pow(m.M2, 1.5) : 0., varies ? m.M4 / (m.M2 * m.M2) : 3. };
}

/**
 * All voxels against the reference. Decisions on the edge may differ: then everything does.
 */
void ExpectReference(const std::vector<float>& volume, const Size& n, const Parameters& parameters)
{
  const auto out = Compute(volume, n, parameters);
  size_t i = 0, differences = 0;
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    for (tfc::Index y = 0; y < n[1]; ++y)
    {
      for (tfc::Index x = 0; x < n[0]; ++x, ++i)
      {
        if (std::isnan(volume[i]))
        {
          for (const auto& values : out)
          {
            EXPECT_TRUE(std::isnan(values[i]));
          }
          continue;
        }
        const auto expected = Reference(volume, n, { x, y, z }, parameters);
        if (std::fabs(out[tfc::SphereRadius][i] - expected[tfc::SphereRadius]) > 1e-5)
        {
          ++differences;
          continue;
        }
        for (size_t s = 0; s < out.size(); ++s)
        {
          // Powers lose more digits than sums: of 4 units at most.
          ASSERT_NEAR(out[s][i], expected[s], s < tfc::SphereSkewness ? 4e-6 : 2e-4)
            << s << " at " << x << " " << y << " " << z;
        }
      }
    }
  }
  EXPECT_LE(differences, volume.size() / 1000);
}
}

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
  auto volume = MakeNoise(n, 31);
  const auto complete = Compute(volume, n, {});
  volume[(10 * n[1] + 10) * n[0] + 30] = NaN;
  const auto holed = Compute(volume, n, {});
  size_t compared = 0, i = 0;
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    for (tfc::Index y = 0; y < n[1]; ++y)
    {
      for (tfc::Index x = 0; x < n[0]; ++x, ++i)
      {
        if (std::hypot(x - 30., y - 10., z - 10.) > 5.)
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
  EXPECT_EQ(compared, volume.size() - 515);
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
