// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelVolumes.h"
#include "ScaleSpaceVolumes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_volumes;

namespace
{
tfc::ScaleSpaceParameters MakeParameters(const Size& n, double conductance)
{
  tfc::ScaleSpaceParameters parameters;
  std::copy(n.begin(), n.end(), parameters.WholeSize);
  parameters.Conductance = conductance;
  return parameters;
}

/**
 * Samples of f at the squared distance from the middle sample.
 */
template <typename Function>
std::vector<float> MakeRadial(const Size& n, const Function& f, const double spacing[3])
{
  const Size middle = { n[0] / 2, n[1] / 2, n[2] / 2 };
  return Make(n,
    [&](auto x, auto y, auto z)
    {
      const double dx = static_cast<double>(x - middle[0]) * spacing[0];
      const double dy = static_cast<double>(y - middle[1]) * spacing[1];
      const double dz = static_cast<double>(z - middle[2]) * spacing[2];
      return f(dx * dx + dy * dy + dz * dz);
    });
}

constexpr double Cubic[3] = { 1., 1., 1. };

/**
 * Sigma and height of the response's peak at the middle of a ball.
 */
double FindBallSigma(const Size& n, double radius, const tfc::ScaleSpaceParameters& parameters,
  double* height)
{
  const tfc::ScaleSpacePlan plan = tfc::ScaleSpacePlanner(parameters).Plan;
  const auto volume = MakeRadial(
    n, [&](double squared) { return squared <= radius * radius ? 1. : 0.; }, parameters.Spacing);
  const Size middle = { n[0] / 2, n[1] / 2, n[2] / 2 };
  return FindPeakSigma(ComputeResponses(plan, n.data(), volume), middle.data(), height);
}
}

TEST(ScaleSpace, ScalesAreGeometricWithOneMoreOnEitherSide)
{
  for (const double conductance : { 0., 0.5 })
  {
    const auto parameters = MakeParameters({ 64, 64, 64 }, conductance);
    const tfc::ScaleSpacePlan plan = tfc::ScaleSpacePlanner(parameters).Plan;
    ASSERT_EQ(plan.Sigmas.size(), 14u);
    EXPECT_EQ(plan.Dimension, 3);
    const double ratio = std::pow(10., 1. / 11.);
    for (size_t i = 0; i < plan.Sigmas.size(); ++i)
    {
      const double expected = 2.5 / std::sqrt(3.) * std::pow(ratio, static_cast<double>(i) - 1.);
      EXPECT_NEAR(plan.Sigmas[i], expected, 1e-9 * expected);
    }
  }
}

TEST(ScaleSpace, StepsSumUpToTheScale)
{
  const auto parameters = MakeParameters({ 64, 64, 64 }, 0.);
  const tfc::ScaleSpacePlan plan = tfc::ScaleSpacePlanner(parameters).Plan;
  double variance = 0.;
  size_t response = 0;
  for (const tfc::ScaleSpaceAction& action : plan.Actions)
  {
    const double h = static_cast<double>(action.Stride[0]);
    if (action.Kind == tfc::ScaleSpaceAction::Diffuse)
    {
      variance += 2. * action.Coefficients.Flux[0] * h * h;
    }
    else if (action.Kind == tfc::ScaleSpaceAction::Respond)
    {
      const double sigma = plan.Sigmas[response++];
      EXPECT_NEAR(variance + 0.1 * h * h, sigma * sigma, 1e-5 * sigma * sigma);
      EXPECT_NEAR(action.Weights[1] * h * h, sigma * sigma, 1e-5 * sigma * sigma);
    }
    else
    {
      EXPECT_NEAR(std::sqrt(variance), tfc::CoarseningSigma * h / 2., 1e-5);
    }
  }
  EXPECT_EQ(response, plan.Sigmas.size());
}

TEST(ScaleSpace, AxesAreHalvedByTheirSpacing)
{
  auto parameters = MakeParameters({ 100, 80, 1 }, 0.);
  parameters.Spacing[1] = 3.;
  const tfc::ScaleSpacePlan plan = tfc::ScaleSpacePlanner(parameters).Plan;
  EXPECT_EQ(plan.Dimension, 2);
  tfc::Index previous[3] = { 1, 1, 1 };
  for (const tfc::ScaleSpaceAction& action : plan.Actions)
  {
    EXPECT_EQ(action.Stride[2], 1);
    EXPECT_GE(4 * action.Stride[1], action.Stride[0]);
    EXPECT_GE(action.Stride[0], previous[0]);
    EXPECT_GE(action.Stride[1], previous[1]);
    std::copy(action.Stride, action.Stride + 3, previous);
  }
  EXPECT_GT(previous[0], previous[1]);
  // Few samples are not made fewer.
  const auto small = MakeParameters({ 15, 15, 15 }, 0.);
  for (const tfc::ScaleSpaceAction& action : tfc::ScaleSpacePlanner(small).Plan.Actions)
  {
    EXPECT_EQ(action.Stride[0], 1);
  }
}

TEST(ScaleSpace, GaussianBlob)
{
  // exp(-d^2 / 2 s^2) in D dimensions: response D t (s^2 / (s^2 + t))^(D/2) / (s^2 + t).
  const Size n = { 65, 65, 65 };
  const double s = 4.5;
  const tfc::ScaleSpacePlan plan = tfc::ScaleSpacePlanner(MakeParameters(n, 0.)).Plan;
  const auto volume = MakeRadial(
    n, [&](double squared) { return std::exp(-0.5 * squared / (s * s)); }, Cubic);
  const auto responses = ComputeResponses(plan, n.data(), volume);
  const Size middle = { 32, 32, 32 };
  for (const Responses& response : responses)
  {
    const double t = response.Sigma * response.Sigma;
    if (response.Sigma < 7.)
    {
      const double expected = -3. * t * std::pow(s * s / (s * s + t), 1.5) / (s * s + t);
      EXPECT_NEAR(response.At(middle.data()), expected, 0.03 * std::fabs(expected))
        << response.Sigma;
    }
  }
  EXPECT_NEAR(FindPeakSigma(responses, middle.data()), std::sqrt(2. / 3.) * s, 0.02 * s);
}

TEST(ScaleSpace, GaussianBall)
{
  for (const int radius : { 4, 6, 8, 10, 14, 17 })
  {
    const Size n = { 73, 73, 73 };
    double height = 0.;
    const double sigma = FindBallSigma(n, radius, MakeParameters(n, 0.), &height);
    EXPECT_NEAR(sigma * std::sqrt(3.), radius, 0.02 * radius);
    EXPECT_NEAR(height, 0.92508, 0.012);
  }
}

TEST(ScaleSpace, NonlinearBall)
{
  for (const double conductance : { 0.5, 1. })
  {
    for (const int radius : { 4, 6, 10, 17 })
    {
      const Size n = { 73, 73, 73 };
      double height = 0.;
      const double sigma = FindBallSigma(n, radius, MakeParameters(n, conductance), &height);
      EXPECT_NEAR(sigma * std::sqrt(3.), radius, 0.06 * radius) << conductance;
      EXPECT_NEAR(height, 0.92508, 0.04) << conductance << " " << radius;
    }
  }
}

TEST(ScaleSpace, DiskAndBallOnAnUnevenLattice)
{
  double height = 0.;
  const Size flat = { 81, 1, 81 };
  const double disk = FindBallSigma(flat, 10., MakeParameters(flat, 0.), &height);
  EXPECT_NEAR(disk * std::sqrt(2.), 10., 0.2);
  EXPECT_NEAR(height, 2. / std::exp(1.), 0.01);

  const Size n = { 72, 36, 24 };
  auto uneven = MakeParameters(n, 0.);
  uneven.Spacing[1] = 2.;
  uneven.Spacing[2] = 3.;
  const double ball = FindBallSigma(n, 12., uneven, &height);
  EXPECT_NEAR(ball * std::sqrt(3.), 12., 0.36);
}

TEST(ScaleSpace, PiecesHaveTheSamplesOfTheWhole)
{
  const tfc::Index whole[3] = { 23, 18, 9 }, stride[3] = { 4, 2, 1 }, zero[3] = { 0, 0, 0 };
  const tfc::CoarseLattice all = tfc::MakeCoarseLattice(zero, whole, stride);
  EXPECT_EQ(all.Size[0], 6);
  EXPECT_EQ(all.Size[1], 9);
  EXPECT_EQ(all.Size[2], 9);
  for (tfc::Index offset = 0; offset < 12; ++offset)
  {
    const tfc::Index begin[3] = { offset, offset / 2, 3 }, size[3] = { 9, 9, 4 };
    const tfc::CoarseLattice part = tfc::MakeCoarseLattice(begin, size, stride);
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_GE(part.First[a] * stride[a], begin[a]);
      EXPECT_LT((part.First[a] - 1) * stride[a], begin[a]);
      EXPECT_LT((part.First[a] + part.Size[a] - 1) * stride[a], begin[a] + size[a]);
      EXPECT_GE((part.First[a] + part.Size[a]) * stride[a], begin[a] + size[a]);
    }
    // Values tell where they come from.
    const Size n = { size[0], size[1], size[2] };
    const auto fine = Make(n,
      [&](auto x, auto y, auto z)
      { return (begin[0] + x) + 100 * (begin[1] + y) + 10000 * (begin[2] + z); });
    const tfc::Index unit[3] = { 1, 1, 1 };
    const tfc::CoarseLattice from = tfc::MakeCoarseLattice(begin, size, unit);
    std::vector<float> coarse(part.GetSize());
    for (tfc::Index z = 0; z < part.Size[2]; ++z)
    {
      tfc::SubsampleSlice(fine.data(), from, part, z, coarse.data());
    }
    const float expected = static_cast<float>(
      part.First[0] * stride[0] + 100 * part.First[1] * stride[1] + 10000 * part.First[2]);
    EXPECT_EQ(coarse[0], expected);
    EXPECT_EQ(coarse[1], expected + static_cast<float>(stride[0]));
  }
}
