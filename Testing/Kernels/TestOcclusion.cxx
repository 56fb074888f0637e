// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCOcclusion.h"
#include "KernelVolumes.h"

#include <gtest/gtest.h>

using namespace testing_volumes;

namespace
{
std::vector<float> Compute(const std::vector<float>& volume, const Size& n, tfc::Index radius,
  double range, double eta)
{
  const tfc::Index begin[3] = { 0, 0, 0 };
  const tfc::Index radii[3] = { radius, radius, radius };
  const tfc::BoxSum box(n.data(), begin, n.data(), radii);
  std::vector<float> sums(box.GetTemporarySize()), out(volume.size());
  tfc::BoxSum::Workspace work;
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    box.SumSlice<tfc::BoxTerm::Value>(volume.data(), z, sums.data(), work);
  }
  tfc::OcclusionTile<false>(box, volume.data(), n.data(), begin, n.data(),
    tfc::ConductanceWeight(range, eta), sums.data(), nullptr, 0, n[1], work, out.data());
  return out;
}
}

TEST(Occlusion, IsTheMeanWhereNothingChanges)
{
  // Range 0: the boundary factor is 1 and the mean that of a constant.
  const Size n{ 9, 8, 7 };
  for (const float v : Compute(std::vector<float>(9 * 8 * 7, 12.5f), n, 3, 0., 0.005))
  {
    EXPECT_EQ(v, 12.5f);
  }
}

TEST(Occlusion, BoundaryFactorOfALinearRamp)
{
  // Slope 1 / 15 of the range per voxel: g = eta^2 / (slope^2 + eta^2); the mean is closed form
  // too.
  const Size n{ 16, 5, 5 };
  const double slope = 1. / 15., eta = 0.05;
  const auto volume = Make(n, [](auto x, auto, auto) { return 2. * x; });
  const auto out = Compute(volume, n, 2, 30., eta);
  const double g = eta * eta / (slope * slope + eta * eta);
  for (tfc::Index x = 2; x < 14; ++x)
  {
    EXPECT_NEAR(At(out, n, x, 2, 2), g * 2. * x, 1e-5 * 30.);
  }
}

TEST(Occlusion, ExtremeParametersStayFinite)
{
  const Size n{ 6, 5, 4 };
  const auto volume = MakeNoise(n, 1);
  for (const double range : { 1e-300, 4., 1e30 })
  {
    for (const double eta : { 1e-30, 1e-3, 1e30 })
    {
      for (const float v : Compute(volume, n, 2, range, eta))
      {
        EXPECT_TRUE(std::isfinite(v));
      }
    }
  }
}
