// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelVolumes.h"

#include "Filters/Kernels/TFCShepard.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_volumes;

namespace
{
/**
 * The definition at a sample, in double precision.
 */
double Reference(const std::vector<tfc::SizedBlob>& blobs, const double spacing[3],
  const tfc::Index at[3])
{
  double weighted = 0., weights = 0.;
  for (const tfc::SizedBlob& blob : blobs)
  {
    double squared = 0.;
    for (int a = 0; a < 3; ++a)
    {
      const double d = (static_cast<double>(at[a]) - blob.Position[a]) * spacing[a];
      squared += d * d;
    }
    const double q = std::sqrt(squared) / blob.Radius;
    const double phi = q < 1. ? std::pow(1. - q, 4.) * (4. * q + 1.) : 0.;
    weighted += phi * blob.Radius;
    weights += phi;
  }
  return weights > 0. ? weighted / weights : 0.;
}

std::vector<float> Raise(const std::vector<tfc::SizedBlob>& blobs, const tfc::SizeBox& box)
{
  const tfc::Index slice = box.GetWidth() * box.GetHeight();
  std::vector<float> sizes(slice * (box.End[2] - box.Begin[2]), 0.f);
  tfc::SizeWorkspace work;
  for (tfc::Index z = box.Begin[2]; z < box.End[2]; ++z)
  {
    tfc::RaiseSlice(blobs, box, z, work, sizes.data() + (z - box.Begin[2]) * slice);
  }
  return sizes;
}

const std::vector<tfc::SizedBlob> Some = { { { 5.3, 4.1, 6.7 }, 4. }, { { 8., 6., 6. }, 5.5 },
  { { 14.2, -1.5, 3. }, 6. }, { { -30., 4., 4. }, 3. }, { { 12., 11., 2. }, 1.6 } };
}

TEST(Shepard, Wendland)
{
  EXPECT_EQ(tfc::Wendland(0.f), 1.f);
  EXPECT_NEAR(tfc::Wendland(0.25f), 0.31640625 * 2., 1e-6);
  EXPECT_NEAR(tfc::Wendland(0.5f), 0.0625 * 3., 1e-6);
  EXPECT_EQ(tfc::Wendland(1.f), 0.f);
  EXPECT_EQ(tfc::Wendland(7.f), 0.f);
}

TEST(Shepard, Definition)
{
  for (const bool uneven : { false, true })
  {
    tfc::SizeBox box;
    const tfc::Index end[3] = { 17, 13, 9 };
    std::copy(end, end + 3, box.End);
    box.Spacing[1] = uneven ? 0.5 : 1.;
    box.Spacing[2] = uneven ? 2. : 1.;
    const auto sizes = Raise(Some, box);
    size_t covered = 0;
    for (tfc::Index i = 0; i < static_cast<tfc::Index>(sizes.size()); ++i)
    {
      const tfc::Index at[3] = { i % 17, i / 17 % 13, i / (17 * 13) };
      const double expected = Reference(Some, box.Spacing, at);
      EXPECT_NEAR(sizes[i], expected, 2e-5);
      covered += expected > 0. ? 1 : 0;
    }
    EXPECT_GT(covered, 100u);
    EXPECT_LT(covered, sizes.size());
  }
}

TEST(Shepard, OneBlobGivesItsRadius)
{
  tfc::SizeBox box;
  const tfc::Index end[3] = { 12, 12, 12 };
  std::copy(end, end + 3, box.End);
  const auto sizes = Raise({ { { 5.5, 5.5, 5.5 }, 4.25 } }, box);
  for (const float size : sizes)
  {
    EXPECT_TRUE(size == 0.f || std::fabs(size - 4.25f) < 1e-6f) << size;
  }
  EXPECT_NEAR(sizes[5 + 12 * (5 + 12 * 5)], 4.25, 1e-6);
}

TEST(Shepard, TheLargestScaleIsKept)
{
  tfc::SizeBox box;
  const tfc::Index end[3] = { 12, 12, 1 };
  std::copy(end, end + 3, box.End);
  tfc::SizeWorkspace work;
  std::vector<float> sizes(144, 0.f);
  tfc::RaiseSlice({ { { 5., 5., 0. }, 5. } }, box, 0, work, sizes.data());
  tfc::RaiseSlice({ { { 5., 5., 0. }, 3. } }, box, 0, work, sizes.data());
  EXPECT_NEAR(sizes[5 + 12 * 5], 5., 1e-6);
  EXPECT_NEAR(sizes[8 + 12 * 8], 5., 1e-6);
}

TEST(Shepard, PartsGiveTheBitsOfTheWhole)
{
  tfc::SizeBox whole;
  const tfc::Index end[3] = { 17, 13, 9 };
  std::copy(end, end + 3, whole.End);
  const auto all = Raise(Some, whole);
  tfc::SizeBox part = whole;
  const tfc::Index begin[3] = { 6, 3, 2 };
  std::copy(begin, begin + 3, part.Begin);
  const auto some = Raise(Some, part);
  size_t i = 0;
  for (tfc::Index z = 2; z < 9; ++z)
  {
    for (tfc::Index y = 3; y < 13; ++y)
    {
      for (tfc::Index x = 6; x < 17; ++x)
      {
        EXPECT_EQ(some[i++], all[(z * 13 + y) * 17 + x]);
      }
    }
  }
}
