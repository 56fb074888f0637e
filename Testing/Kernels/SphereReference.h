// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Growing spheres by their definition, voxel by voxel in double precision.
 */

#ifndef SphereReference_h
#define SphereReference_h

#include "Filters/Kernels/TFCGrowingSpheres.h"
#include "KernelVolumes.h"

#include <gtest/gtest.h>

namespace testing_volumes
{
using Statistics = std::array<std::vector<float>, tfc::NumberOfSphereStatistics>;

struct Parameters
{
  double Radius = 5., Alpha = 0.01;
  double Spacing[3] = { 1., 1., 1. };
  float Scale = 1.f;
  tfc::Index Direct = tfc::GrowingSpheres::Direct;
};

inline Parameters WithRadius(double radius, double alpha = 0.01)
{
  Parameters parameters;
  parameters.Radius = radius;
  parameters.Alpha = alpha;
  return parameters;
}

/**
 * Normal numbers, so that spheres grow large, with about `invalid` of the samples NaN.
 */
inline std::vector<float> MakeNormal(const Size& n, unsigned int seed, double invalid = 0.,
  double mean = 0., double deviation = 1.)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> value(mean, deviation);
  std::uniform_real_distribution<double> chance(0., 1.);
  return Make(n,
    [&](auto, auto, auto)
    {
      const double v = value(random);
      return chance(random) < invalid ? static_cast<double>(NaN) : v;
    });
}

/**
 * The statistics of the block [begin, end) of a lattice that is part of a volume of `whole`
 * samples.
 */
inline Statistics Compute(const std::vector<float>& lattice, const Size& n, const Size& begin,
  const Size& end, const Size& whole, const Parameters& parameters)
{
  const auto shells = tfc::SphereShells::Make(whole.data(), parameters.Spacing, parameters.Radius);
  const tfc::SphereTests tests(parameters.Alpha, shells.Ends.back());
  const tfc::GrowingSpheres spheres(shells, tests, n.data(), begin.data(), end.data(),
    parameters.Scale, parameters.Direct);
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

inline Statistics Compute(const std::vector<float>& volume, const Size& n,
  const Parameters& parameters)
{
  return Compute(volume, n, { 0, 0, 0 }, n, n, parameters);
}

struct Moments
{
  double Count = 0., Mean = 0., M2 = 0., M3 = 0., M4 = 0.;

  explicit Moments(const std::vector<double>& values)
    : Count(static_cast<double>(values.size()))
  {
    // From differences: equal values have their value as mean, and no deviation.
    const double first = values.empty() ? 0. : values.front();
    for (const double v : values)
    {
      this->Mean += (v - first) / this->Count;
    }
    this->Mean += first;
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
inline std::array<double, tfc::NumberOfSphereStatistics> Reference(const std::vector<float>& volume,
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
inline void ExpectReference(const std::vector<float>& volume, const Size& n,
  const Parameters& parameters, double unit = 1.)
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
          ASSERT_NEAR(out[s][i], expected[s], s < tfc::SphereSkewness ? 4e-6 * unit : 2e-4)
            << s << " at " << x << " " << y << " " << z;
        }
      }
    }
  }
  EXPECT_LE(differences, volume.size() / 1000);
}
}

#endif
