// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCBallMean.h"
#include "KernelVolumes.h"

#include <gtest/gtest.h>

using namespace testing_volumes;

namespace
{
using Spacing = std::array<double, 3>;

/**
 * Means of the block [begin, end) by the kernel.
 */
template <typename Real>
std::vector<float> Compute(const std::vector<float>& volume, const Size& n, const Size& begin,
  const Size& end, const tfc::BallKernel& kernel, bool masked)
{
  const tfc::BallMean<Real> ball(volume.data(), n.data(), begin.data(), end.data(), 1.f, masked,
    kernel, [](tfc::Index count, auto&& body) { body(0, count); });
  std::vector<Real> spectrum(static_cast<size_t>(ball.GetSize()));
  typename tfc::BallMean<Real>::Workspace work;
  for (tfc::Index z = 0; z < n[2]; z += 2)
  {
    ball.Forward(z, spectrum.data(), work);
  }
  for (tfc::Index unit = 0; unit < ball.GetNumberOfUnits(); ++unit)
  {
    ball.Filter(unit, spectrum.data(), work);
  }
  const tfc::Index slice = (end[0] - begin[0]) * (end[1] - begin[1]);
  std::vector<float> out(static_cast<size_t>(slice * (end[2] - begin[2])));
  for (tfc::Index z = begin[2]; z < end[2]; z += 2)
  {
    ball.Backward(z, spectrum.data(), work, out.data() + (z - begin[2]) * slice);
  }
  return out;
}

/**
 * Weight by the definition in the header; q is the distance in units of the radius.
 */
double GetWeight(double q, double step, tfc::DistanceWeight weight)
{
  if (q > 1. + 1e-9)
  {
    return 0.;
  }
  return weight == tfc::DistanceWeight::Constant ? 1.
    : weight == tfc::DistanceWeight::Linear      ? 1. - q / (1. + step)
                                                 : std::exp(-2. * q * q);
}

/**
 * Mean around `at` by the definition; the sum of the weights goes to `total`.
 */
double Reference(const std::vector<float>& volume, const Size& n, const Size& at,
  const Spacing& spacing, double radius, tfc::DistanceWeight weight, double& total)
{
  const double smallest = std::min({ spacing[0], spacing[1], spacing[2] });
  double sum = 0.;
  total = 0.;
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    for (tfc::Index y = 0; y < n[1]; ++y)
    {
      for (tfc::Index x = 0; x < n[0]; ++x)
      {
        const double dx = static_cast<double>(x - at[0]) * spacing[0];
        const double dy = static_cast<double>(y - at[1]) * spacing[1];
        const double dz = static_cast<double>(z - at[2]) * spacing[2];
        const double q = std::sqrt(dx * dx + dy * dy + dz * dz) / radius;
        const float value = volume[(z * n[1] + y) * n[0] + x];
        const double w = tfc::IsValid(value) ? GetWeight(q, smallest / radius, weight) : 0.;
        sum += w == 0. ? 0. : w * value;
        total += w;
      }
    }
  }
  return sum / total;
}
}

TEST(BallMean, MatchesDefinition)
{
  using Weight = tfc::DistanceWeight;
  for (const Size& n : GetSizes())
  {
    for (const Spacing& spacing : { Spacing{ 1., 1., 1. }, Spacing{ 0.5, 1.3, 2. } })
    {
      for (const double radius : { 1., 3., 7.5, 40. })
      {
        for (const Weight weight : { Weight::Constant, Weight::Linear, Weight::Gaussian })
        {
          const tfc::BallKernel kernel(n.data(), spacing.data(), radius, weight);
          const auto volume = MakeNoise(n, 3);
          const auto holes = MakeNoise(n, 4, 0.3);
          const auto means = Compute<float>(volume, n, { 0, 0, 0 }, n, kernel, false);
          const auto masked = Compute<double>(holes, n, { 0, 0, 0 }, n, kernel, true);
          std::vector<double> profile, sums(n[0]);
          for (size_t i = 0; i < volume.size(); i += 3)
          {
            const tfc::Index row = static_cast<tfc::Index>(i) / n[0];
            const Size at{ static_cast<tfc::Index>(i) % n[0], row % n[1], row / n[1] };
            double total;
            ASSERT_NEAR(means[i], Reference(volume, n, at, spacing, radius, weight, total), 3e-6);
            kernel.SumRow(at[1], at[2], 0, n[0], profile, sums.data());
            ASSERT_NEAR(sums[at[0]], total, 1e-9 * total);
            ASSERT_EQ(tfc::IsValid(masked[i]), tfc::IsValid(holes[i]));
            if (tfc::IsValid(holes[i]))
            {
              ASSERT_NEAR(masked[i], Reference(holes, n, at, spacing, radius, weight, total), 1e-6);
            }
          }
        }
      }
    }
  }
}

TEST(BallMean, PartOfTheVolumeIsThatPartOfTheResult)
{
  // Also a part that begins and ends beyond the first register of a row, with an odd number of
  // slices.
  const Size n{ 53, 17, 14 };
  for (const auto& [begin, end] : { std::pair<Size, Size>{ { 3, 5, 2 }, { 18, 11, 9 } },
         std::pair<Size, Size>{ { 20, 0, 3 }, { 41, 17, 14 } } })
  {
    const double spacing[3] = { 1., 1., 1. };
    const tfc::BallKernel kernel(n.data(), spacing, 4., tfc::DistanceWeight::Constant);
    const auto volume = MakeNoise(n, 9);
    const auto whole = Compute<float>(volume, n, { 0, 0, 0 }, n, kernel, false);
    const auto part = Compute<float>(volume, n, begin, end, kernel, false);
    size_t i = 0;
    for (tfc::Index z = begin[2]; z < end[2]; ++z)
    {
      for (tfc::Index y = begin[1]; y < end[1]; ++y)
      {
        for (tfc::Index x = begin[0]; x < end[0]; ++x)
        {
          // Not the same bits: other slices share a transform.
          ASSERT_NEAR(part[i++], whole[(z * n[1] + y) * n[0] + x], 1e-6);
        }
      }
    }
  }
}

TEST(BallMean, LatticeCounts)
{
  // Lattice points within r of the origin, sequence A000605 of the OEIS.
  const Size n{ 61, 61, 61 };
  const double spacing[3] = { 1., 1., 1. };
  const std::pair<double, double> counts[] = { { 1, 7 }, { 2, 33 }, { 3, 123 }, { 4, 257 },
    { 10, 4169 }, { 20, 33401 } };
  for (const auto& [radius, expected] : counts)
  {
    const tfc::BallKernel kernel(n.data(), spacing, radius, tfc::DistanceWeight::Constant);
    std::vector<double> profile;
    double sum = 0.;
    kernel.SumRow(30, 30, 30, 31, profile, &sum);
    EXPECT_EQ(sum, expected);
  }
}

TEST(BallMean, OneValidSampleAmongManyIsItsOwnMean)
{
  const Size n{ 40, 40, 40 };
  const double spacing[3] = { 1., 1., 1. };
  const tfc::BallKernel kernel(n.data(), spacing, 18., tfc::DistanceWeight::Constant);
  const auto volume = Make(n,
    [](tfc::Index x, tfc::Index y, tfc::Index z)
    { return x == 9 && y == 20 && z == 30 ? 0.37f : NaN; });
  const auto means = Compute<double>(volume, n, { 0, 0, 0 }, n, kernel, true);
  EXPECT_FLOAT_EQ(means[(30 * 40 + 20) * 40 + 9], 0.37f);
}
