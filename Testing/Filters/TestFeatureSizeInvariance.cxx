// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSizeVolumes.h"

#include <gtest/gtest.h>

using namespace testing_volumes;

namespace
{
constexpr int Samples[3] = { 61, 57, 53 };

/**
 * Balls and noise, of which samples are taken wherever a symmetry wants them.
 */
double Scene(int x, int y, int z)
{
  static const Function balls = MakeBalls({ { { 17., 20., 22. }, 6., 4. },
    { { 40., 33., 27. }, 11., 3. }, { { 14., 44., 36. }, 4., -4. } });
  return balls(x, y, z) + 0.3 * Noise(x, y, z);
}

struct Result
{
  vtkSmartPointer<vtkDataArray> Sizes;
  vtkSmartPointer<vtkPolyData> Blobs;
};

Result Measure(const Function& f, int polarity = vtkTFCFeatureSize::BRIGHT, int nx = Samples[0],
  int ny = Samples[1], int nz = Samples[2])
{
  vtkNew<vtkTFCFeatureSize> filter;
  filter->SetPolarity(polarity);
  filter->SetLargestSize(20.);
  filter->SetNumberOfScales(10);
  Result result;
  result.Sizes = Compute(filter.Get(), MakeVolume<vtkFloatArray>(nx, ny, nz, f), "a_size");
  result.Blobs = filter->GetBlobs();
  return result;
}

void ExpectSameBits(const Result& result, const Result& expected)
{
  ASSERT_EQ(result.Sizes->GetNumberOfTuples(), expected.Sizes->GetNumberOfTuples());
  for (vtkIdType i = 0; i < result.Sizes->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(result.Sizes->GetTuple1(i), expected.Sizes->GetTuple1(i)) << i;
  }
  ASSERT_EQ(result.Blobs->GetNumberOfPoints(), expected.Blobs->GetNumberOfPoints());
  ASSERT_GT(result.Blobs->GetNumberOfPoints(), 2);
  for (vtkIdType i = 0; i < result.Blobs->GetNumberOfPoints(); ++i)
  {
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_EQ(result.Blobs->GetPoint(i)[a], expected.Blobs->GetPoint(i)[a]);
    }
  }
}
}

TEST(FeatureSizeInvariance, ThreadsAndRegisters)
{
  const auto holes = [](int x, int y, int z)
  { return (x * y + z) % 97 == 0 ? NaN : Scene(x, y, z); };
  for (const Function& f : { Function(Scene), Function(holes) })
  {
    Result expected;
    {
      const Threads threads(1);
      const SimdLimit limit("baseline");
      expected = Measure(f, vtkTFCFeatureSize::BOTH);
    }
    // NaN is not equal to itself.
    for (vtkIdType i = 0; i < expected.Sizes->GetNumberOfTuples(); ++i)
    {
      const double size = expected.Sizes->GetTuple1(i);
      expected.Sizes->SetTuple1(i, std::isnan(size) ? -1. : size);
    }
    for (const int number : { 1, 2, 4, 7 })
    {
      for (const char* level : { "baseline", "avx2", "avx512" })
      {
        const Threads threads(number);
        const SimdLimit limit(level);
        Result result = Measure(f, vtkTFCFeatureSize::BOTH);
        for (vtkIdType i = 0; i < result.Sizes->GetNumberOfTuples(); ++i)
        {
          const double size = result.Sizes->GetTuple1(i);
          result.Sizes->SetTuple1(i, std::isnan(size) ? -1. : size);
        }
        ExpectSameBits(result, expected);
      }
    }
  }
}

TEST(FeatureSizeInvariance, ScaledIntensities)
{
  const Result expected = Measure(Scene);
  // A power of two changes no mantissa.
  ExpectSameBits(Measure([](int x, int y, int z) { return 8. * Scene(x, y, z); }), expected);
  const Result affine = Measure([](int x, int y, int z) { return 300. * Scene(x, y, z) + 1000.; });
  ASSERT_EQ(affine.Blobs->GetNumberOfPoints(), expected.Blobs->GetNumberOfPoints());
  for (vtkIdType i = 0; i < affine.Sizes->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(affine.Sizes->GetTuple1(i), expected.Sizes->GetTuple1(i), 0.01);
  }
  const Result dark =
    Measure([](int x, int y, int z) { return -Scene(x, y, z); }, vtkTFCFeatureSize::DARK);
  ASSERT_EQ(dark.Blobs->GetNumberOfPoints(), expected.Blobs->GetNumberOfPoints());
  for (vtkIdType i = 0; i < dark.Sizes->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(dark.Sizes->GetTuple1(i), expected.Sizes->GetTuple1(i), 0.01);
  }
}

TEST(FeatureSizeInvariance, FlipsAndTransposes)
{
  // 61, 57 and 53 samples: the middle stays on the coarser lattices, which have every 2nd and 4th.
  const Result expected = Measure(Scene);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto flip = [=](int& x, int& y, int& z)
    {
      int* at[3] = { &x, &y, &z };
      *at[axis] = Samples[axis] - 1 - *at[axis];
    };
    const Result flipped = Measure(
      [&](int x, int y, int z)
      {
        flip(x, y, z);
        return Scene(x, y, z);
      });
    EXPECT_EQ(flipped.Blobs->GetNumberOfPoints(), expected.Blobs->GetNumberOfPoints());
    for (vtkIdType i = 0; i < flipped.Sizes->GetNumberOfTuples(); ++i)
    {
      int x = static_cast<int>(i % Samples[0]), y = static_cast<int>(i / Samples[0] % Samples[1]);
      int z = static_cast<int>(i / (Samples[0] * Samples[1]));
      flip(x, y, z);
      const vtkIdType j = (static_cast<vtkIdType>(z) * Samples[1] + y) * Samples[0] + x;
      ASSERT_NEAR(flipped.Sizes->GetTuple1(i), expected.Sizes->GetTuple1(j), 0.01) << axis;
    }
  }
  const Result transposed = Measure([](int x, int y, int z) { return Scene(z, x, y); },
    vtkTFCFeatureSize::BRIGHT, Samples[1], Samples[2], Samples[0]);
  EXPECT_EQ(transposed.Blobs->GetNumberOfPoints(), expected.Blobs->GetNumberOfPoints());
  for (vtkIdType i = 0; i < transposed.Sizes->GetNumberOfTuples(); ++i)
  {
    const vtkIdType y = i % Samples[1], z = i / Samples[1] % Samples[2];
    const vtkIdType x = i / (Samples[1] * Samples[2]);
    const vtkIdType j = (z * Samples[1] + y) * Samples[0] + x;
    ASSERT_NEAR(transposed.Sizes->GetTuple1(i), expected.Sizes->GetTuple1(j), 0.01);
  }
}

TEST(FeatureSizeInvariance, Translations)
{
  // By the coarsest lattice's distance of samples nothing changes, by less than that little.
  const auto ball = [](int x, int y, int z, int shift)
  { return std::hypot(x - 28. - shift, y - 28., z - 26.) <= 10. ? 1. : 0.; };
  const auto getSize = [&](int shift)
  {
    const Result result = Measure([&](int x, int y, int z) { return ball(x, y, z, shift); });
    return result.Sizes->GetTuple1((26 * Samples[1] + 28) * Samples[0] + 28 + shift);
  };
  const double expected = getSize(0);
  EXPECT_NEAR(expected, 10., 0.3);
  EXPECT_NEAR(getSize(4), expected, 0.001);
  for (const int shift : { 1, 2, 3, 5 })
  {
    EXPECT_NEAR(getSize(shift), expected, 0.15) << shift;
  }
}
