// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelVolumes.h"

#include "Filters/Kernels/TFCBlobs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace testing_volumes;

namespace
{
/**
 * Three lattices of responses, -f(x, y, z, scale), and their detector.
 */
struct Scene
{
  Scene(const Size& n, const std::function<double(double, double, double, int)>& f)
  {
    for (int scale = 0; scale < 3; ++scale)
    {
      this->Volumes[scale] =
        Make(n, [&](double x, double y, double z) { return -f(x, y, z, scale); });
      this->Detector.Responses[scale] = this->Volumes[scale].data();
      this->Detector.LogSigmas[scale] = 0.2 * scale;
    }
    std::copy(n.begin(), n.end(), this->Detector.Lattice.Size);
    this->Detector.Scale = 1;
    this->Detector.Threshold = 0.1f;
  }

  std::vector<tfc::Blob> Find() const
  {
    std::vector<tfc::Blob> found;
    for (tfc::Index z = 0; z < this->Detector.Lattice.Size[2]; ++z)
    {
      this->Detector.FindInSlice(z, found);
    }
    return found;
  }

  std::vector<float> Volumes[3];
  tfc::BlobDetector Detector;
};

/**
 * A parabola in space and log sigma with its top, of 1, at the given place.
 */
std::function<double(double, double, double, int)> Parabola(double x0, double y0, double z0,
  double logSigma)
{
  return [=](double x, double y, double z, int scale)
  {
    const double dx = x - x0, dy = y - y0, dz = z - z0, ds = 0.2 * scale - logSigma;
    return 1. - 0.01 * (dx * dx + dy * dy + dz * dz) - ds * ds;
  };
}
}

TEST(Blobs, ParabolaBetweenSamples)
{
  EXPECT_NEAR(tfc::FitParabola(1. - 0.36, 1. - 0.16 + 0.2, 1. - 0.36), 0., 1e-12);
  const auto f = [](double x) { return 3. - 2. * (x - 0.3) * (x - 0.3); };
  EXPECT_NEAR(tfc::FitParabola(f(-1.), f(0.), f(1.)), 0.3, 1e-12);
  EXPECT_EQ(tfc::FitParabola(1., 1., 1.), 0.);
  EXPECT_EQ(tfc::FitParabola(0., 1., 1.), 0.5);
  const double x[3] = { -2., 0., 0.7 }, y[3] = { f(-2.), f(0.), f(0.7) };
  EXPECT_NEAR(tfc::FitParabola(x, y), 0.3, 1e-12);
  EXPECT_NEAR(tfc::EvaluateParabola(x, y, 0.3), 3., 1e-12);
  const double same[3] = { 1., 1., 2. };
  EXPECT_EQ(tfc::FitParabola(same, y), 1.);
  EXPECT_EQ(tfc::EvaluateParabola(same, y, 1.5), y[1]);
}

TEST(Blobs, OneMaximumBetweenSamplesAndScales)
{
  const Scene scene({ 9, 10, 8 }, Parabola(4.3, 5.2, 2.6, 0.25));
  const auto found = scene.Find();
  ASSERT_EQ(found.size(), 1u);
  const double expected[3] = { 4.3, 5.2, 2.6 };
  const tfc::Index voxel[3] = { 4, 5, 3 };
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_NEAR(found[0].Position[a], expected[a], 1e-4);
    EXPECT_EQ(found[0].Voxel[a], voxel[a]);
  }
  EXPECT_NEAR(std::log(found[0].Sigma), 0.25, 1e-4);
  EXPECT_NEAR(found[0].Response, 1., 1e-4);
}

TEST(Blobs, PolarityAndThreshold)
{
  Scene scene({ 9, 10, 8 }, Parabola(4., 5., 3., 0.2));
  scene.Detector.Sign = 1.f;
  EXPECT_TRUE(scene.Find().empty());
  scene.Detector.Sign = -1.f;
  EXPECT_EQ(scene.Find().size(), 1u);
  scene.Detector.Threshold = 1.01f;
  EXPECT_TRUE(scene.Find().empty());
  for (auto& volume : scene.Volumes)
  {
    for (float& value : volume)
    {
      value = -value;
    }
  }
  scene.Detector.Threshold = 0.1f;
  EXPECT_TRUE(scene.Find().empty());
  scene.Detector.Sign = 1.f;
  ASSERT_EQ(scene.Find().size(), 1u);
  EXPECT_NEAR(scene.Find()[0].Response, -1., 1e-5);
}

TEST(Blobs, EqualNeighboursAreOneBlob)
{
  for (const double x0 : { 4., 4.5 })
  {
    for (const double y0 : { 5., 5.5 })
    {
      for (const double z0 : { 3., 3.5 })
      {
        for (const double s0 : { 0.2, 0.1, 0.3 })
        {
          const auto found = Scene({ 9, 10, 8 }, Parabola(x0, y0, z0, s0)).Find();
          // Equal scales: the lower one of the two has it, and is not always the middle one.
          ASSERT_LE(found.size(), 1u);
          ASSERT_TRUE(found.size() == 1u || s0 != 0.2);
          if (!found.empty())
          {
            EXPECT_NEAR(found[0].Position[0], x0, 1e-4);
            EXPECT_NEAR(found[0].Position[1], y0, 1e-4);
            EXPECT_NEAR(found[0].Position[2], z0, 1e-4);
          }
        }
      }
    }
  }
}

TEST(Blobs, MaximaAtTheBorder)
{
  for (const Size& n : { Size{ 7, 6, 5 }, Size{ 7, 1, 5 }, Size{ 1, 1, 9 }, Size{ 300, 1, 1 } })
  {
    for (const bool last : { false, true })
    {
      const auto at = [&](int a) { return last ? static_cast<double>(n[a] - 1) : 0.; };
      const auto found = Scene(n, Parabola(at(0), at(1), at(2), 0.2)).Find();
      ASSERT_EQ(found.size(), 1u);
      for (int a = 0; a < 3; ++a)
      {
        EXPECT_EQ(found[0].Position[a], at(a));
      }
    }
  }
}

TEST(Blobs, BruteForceOnNoise)
{
  const Size n = { 300, 9, 7 };
  std::vector<float> noise[3] = { MakeNoise(n, 1), MakeNoise(n, 2), MakeNoise(n, 3) };
  Scene scene(n,
    [&](double x, double y, double z, int scale)
    {
      return At(noise[scale], n, static_cast<tfc::Index>(x), static_cast<tfc::Index>(y),
        static_cast<tfc::Index>(z));
    });
  // Wherever it looks, the test of the width must see what is there.
  for (float& value : scene.Volumes[1])
  {
    value -= 3.f;
  }
  size_t expected = 0;
  for (tfc::Index i = 0; i < n[0] * n[1] * n[2]; ++i)
  {
    const tfc::Index x = i % n[0], y = i / n[0] % n[1], z = i / (n[0] * n[1]);
    const float value = scene.Volumes[1][i];
    bool isMinimum = true, isWide = true;
    for (int scale = 0; scale < 3; ++scale)
    {
      for (tfc::Index j = 0; j < 27; ++j)
      {
        const tfc::Index p[3] = { x + j % 3 - 1, y + j / 3 % 3 - 1, z + j / 9 - 1 };
        const bool inside =
          p[0] >= 0 && p[0] < n[0] && p[1] >= 0 && p[1] < n[1] && p[2] >= 0 && p[2] < n[2];
        if (inside && (scale != 1 || j != 13))
        {
          const float other = At(scene.Volumes[scale], n, p[0], p[1], p[2]);
          isMinimum = isMinimum && value < other;
          const bool onAxis = j == 4 || j == 10 || j == 12 || j == 14 || j == 16 || j == 22;
          isWide = isWide && (scale != 1 || !onAxis || other <= tfc::SmallestPlateau * value);
        }
      }
    }
    expected += isMinimum && isWide && value < -0.1f ? 1 : 0;
  }
  EXPECT_GT(expected, 100u);
  EXPECT_EQ(scene.Find().size(), expected);
}

TEST(Blobs, NarrowOnesAreEdges)
{
  Scene scene({ 21, 21, 21 },
    [](double x, double y, double z, int scale)
    {
      // A ridge that is one sample thick along x, and as wide as you like along y and z.
      const double dy = y - 10., dz = z - 10.;
      return (x == 10. ? 1. : 0.) * (1. - 0.001 * (dy * dy + dz * dz)) - 0.1 * std::abs(scale - 1);
    });
  scene.Detector.Width[0] = scene.Detector.Width[1] = scene.Detector.Width[2] = 3;
  EXPECT_TRUE(scene.Find().empty());
}

TEST(Blobs, DuplicatesOfAdjacentScales)
{
  const auto make = [](tfc::Index x, tfc::Index z, double response)
  {
    tfc::Blob blob;
    blob.Voxel[0] = x;
    blob.Voxel[2] = z;
    blob.Response = response;
    return blob;
  };
  const tfc::Index stride[3] = { 2, 2, 2 };
  std::vector<tfc::Blob> below = { make(0, 0, 0.5), make(9, 0, 0.5), make(5, 8, -0.5) };
  std::vector<tfc::Blob> above = { make(1, 1, 0.6), make(9, 2, 0.4), make(5, 8, 0.6) };
  tfc::RemoveDuplicates(below, above, stride);
  ASSERT_EQ(below.size(), 2u);
  ASSERT_EQ(above.size(), 2u);
  EXPECT_EQ(below[0].Voxel[0], 9);
  EXPECT_EQ(below[1].Response, -0.5);
  EXPECT_EQ(above[0].Voxel[0], 1);
  EXPECT_EQ(above[1].Response, 0.6);
}
