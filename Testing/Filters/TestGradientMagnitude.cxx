// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterVolumes.h"

#include "Filters/vtkTFCGradientMagnitude.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLongArray.h"
#include "vtkLongLongArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkShortArray.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnsignedLongArray.h"
#include "vtkUnsignedLongLongArray.h"
#include "vtkUnsignedShortArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace testing_volumes;

namespace
{
const char* const Result = "a_gradient";

template <typename Array>
class GradientOfType : public ::testing::Test
{
};
using Types = ::testing::Types<vtkCharArray, vtkSignedCharArray, vtkUnsignedCharArray,
  vtkShortArray, vtkUnsignedShortArray, vtkIntArray, vtkUnsignedIntArray, vtkLongArray,
  vtkUnsignedLongArray, vtkLongLongArray, vtkUnsignedLongLongArray, vtkIdTypeArray, vtkFloatArray,
  vtkDoubleArray, vtkSOADataArrayTemplate<float>>;
TYPED_TEST_SUITE(GradientOfType, Types);

TYPED_TEST(GradientOfType, LinearRamp)
{
  const auto image =
    MakeVolume<TypeParam>(9, 6, 5, [](int x, int y, int z) { return 3 * x + 2 * y + 6 * z; });
  vtkNew<vtkTFCGradientMagnitude> filter;
  auto* result = Compute(filter.Get(), image, Result);
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->GetDataType(), VTK_FLOAT);
  for (vtkIdType i = 0; i < result->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(result->GetTuple1(i), 7., 1e-5);
  }
}
}

TEST(GradientMagnitude, BitArray)
{
  const auto image = MakeVolume<vtkBitArray>(11, 3, 3, [](int x, int, int) { return x >= 5; });
  vtkNew<vtkTFCGradientMagnitude> filter;
  auto* result = Compute(filter.Get(), image, Result);
  ASSERT_NE(result, nullptr);
  for (vtkIdType i = 0; i < result->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(result->GetTuple1(i), i % 11 == 4 || i % 11 == 5 ? 0.5 : 0.);
  }
}

TEST(GradientMagnitude, SpacingPerAxisAndOrientation)
{
  const auto image =
    MakeVolume(7, 8, 9, [](int x, int y, int z) { return 3. * x + 2. * y + 6. * z; });
  image->SetSpacing(0.5, 2., 3.);
  const double expected = std::sqrt(36. + 1. + 4.);
  for (const double angle : { 0., 0.7 })
  {
    image->SetDirectionMatrix(std::cos(angle), -std::sin(angle), 0., std::sin(angle),
      std::cos(angle), 0., 0., 0., 1.);
    vtkNew<vtkTFCGradientMagnitude> filter;
    auto* result = Compute(filter.Get(), image, Result);
    ASSERT_NE(result, nullptr);
    for (vtkIdType i = 0; i < result->GetNumberOfTuples(); ++i)
    {
      EXPECT_NEAR(result->GetTuple1(i), expected, 1e-5);
    }
  }
}

TEST(GradientMagnitude, CellData)
{
  // 5 x 4 x 3 cells, whose values are the volume; the points have none.
  const auto image = MakeImage(6, 5, 4);
  image->GetCellData()->AddArray(
    MakeArray("a", 5, 4, 3, [](int x, int y, int z) { return 2. * x - y + 2. * z; }));
  vtkNew<vtkTFCGradientMagnitude> filter;
  auto* result = Compute(filter.Get(), image, Result, vtkDataObject::CELL);
  ASSERT_NE(result, nullptr);
  ASSERT_EQ(result->GetNumberOfTuples(), 60);
  for (vtkIdType i = 0; i < 60; ++i)
  {
    EXPECT_NEAR(result->GetTuple1(i), 3., 1e-5);
  }
}

TEST(GradientMagnitude, FlatVolumes)
{
  // A single sample along an axis: no slope there, even with spacing 0.
  const int sizes[][3] = { { 6, 5, 1 }, { 1, 7, 4 }, { 9, 1, 1 }, { 1, 1, 1 } };
  for (const auto& n : sizes)
  {
    const auto image =
      MakeVolume(n[0], n[1], n[2], [](int x, int y, int z) { return x + 2. * y + 2. * z; });
    image->SetSpacing(1., 1., n[2] > 1 ? 1. : 0.);
    vtkNew<vtkTFCGradientMagnitude> filter;
    auto* result = Compute(filter.Get(), image, Result);
    ASSERT_NE(result, nullptr);
    const double expected =
      std::sqrt((n[0] > 1 ? 1. : 0.) + (n[1] > 1 ? 4. : 0.) + (n[2] > 1 ? 4. : 0.));
    EXPECT_NEAR(result->GetRange()[0], expected, 1e-6);
    EXPECT_NEAR(result->GetRange()[1], expected, 1e-6);
  }
}

TEST(GradientMagnitude, InvalidVoxels)
{
  // A ramp has the same one-sided differences: only the invalid voxels themselves differ.
  const auto ramp = [](int x, int y, int z)
  {
    return x == 2 && y == 2 && z == 2 ? NaN
      : x == 4 && y == 3 && z == 0    ? INFINITY
      : x == 0 && y == 0 && z == 6    ? -1e300
                                      : 3. * x + 2. * y + 6. * z;
  };
  const vtkIdType blanked = 6 + 9 * (3 + 7 * 3);
  for (const bool asFloat : { false, true })
  {
    const auto image =
      asFloat ? MakeVolume<vtkFloatArray>(9, 7, 7, ramp) : MakeVolume(9, 7, 7, ramp);
    Blank(image, [&](vtkIdType i) { return i == blanked; });
    vtkNew<vtkTFCGradientMagnitude> filter;
    auto* result = Compute(filter.Get(), image, Result);
    ASSERT_NE(result, nullptr);
    for (vtkIdType i = 0; i < result->GetNumberOfTuples(); ++i)
    {
      const bool invalid =
        i == blanked || i == 2 + 9 * (2 + 7 * 2) || i == 4 + 9 * 3 || i == 9 * 7 * 6;
      EXPECT_EQ(std::isnan(result->GetTuple1(i)), invalid) << i;
      if (!invalid)
      {
        EXPECT_NEAR(result->GetTuple1(i), 7., 1e-5) << i;
      }
    }
  }
}

TEST(GradientMagnitude, SmallAndLargeValuesKeepTheirPrecision)
{
  for (const double unit : { 1e-30, 1e30 })
  {
    const auto image = MakeVolume<vtkFloatArray>(5, 4, 3,
      [&](int x, int y, int z) { return unit * (3. * x + 2. * y + 6. * z); });
    vtkNew<vtkTFCGradientMagnitude> filter;
    auto* result = Compute(filter.Get(), image, Result);
    ASSERT_NE(result, nullptr);
    for (vtkIdType i = 0; i < result->GetNumberOfTuples(); ++i)
    {
      EXPECT_NEAR(result->GetTuple1(i) / unit, 7., 1e-5);
    }
  }
}

TEST(GradientMagnitude, Components)
{
  const auto image = MakeImage(6, 6, 6);
  vtkNew<vtkDoubleArray> vector;
  vector->SetName("a");
  vector->SetNumberOfComponents(3);
  for (int i = 0; i < 216; ++i)
  {
    vector->InsertNextTuple3(i % 6, 2. * (i % 6), 2. * (i % 6));
  }
  image->GetPointData()->AddArray(vector);
  const int components[] = { 0, 1, 2, -1 };
  const double expected[] = { 1., 2., 2., 3. };
  for (int c = 0; c < 4; ++c)
  {
    vtkNew<vtkTFCGradientMagnitude> filter;
    filter->SetComponent(components[c]);
    auto* result = Compute(filter.Get(), image, Result);
    ASSERT_NE(result, nullptr);
    EXPECT_NEAR(result->GetTuple1(100), expected[c], 1e-5);
  }
}

TEST(GradientMagnitude, InputIsPassedAndUnchanged)
{
  const auto image = MakeVolume<vtkFloatArray>(8, 7, 6, Noise);
  image->GetPointData()->AddArray(MakeArray("other", 8, 7, 6, Noise));
  vtkNew<vtkTFCGradientMagnitude> filter;
  ASSERT_NE(Compute(filter.Get(), image, Result), nullptr);
  auto* output = filter->GetImageDataOutput()->GetPointData();
  EXPECT_EQ(output->GetNumberOfArrays(), 3);
  EXPECT_EQ(output->GetArray("other"), image->GetPointData()->GetArray("other"));
  EXPECT_EQ(output->GetScalars(), image->GetPointData()->GetScalars());
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 2);
}

TEST(GradientMagnitude, AnEmptyArrayNameStandsForTheActiveScalars)
{
  const auto image =
    MakeVolume<vtkFloatArray>(6, 5, 4, [](int x, int, int) { return static_cast<float>(3 * x); });
  image->GetPointData()->SetActiveScalars("a");
  vtkNew<vtkTFCGradientMagnitude> filter;
  filter->SetInputDataObject(image);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_NONE, "");
  filter->Update();
  vtkDataArray* result = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0))
                           ->GetPointData()
                           ->GetArray("a_gradient");
  ASSERT_NE(result, nullptr);
  EXPECT_FLOAT_EQ(result->GetComponent(40, 0), 3.0F);
}

TEST(GradientMagnitude, DoesNotDependOnThreads)
{
  const auto image = MakeVolume<vtkFloatArray>(61, 40, 33,
    [](int x, int y, int z) { return x == 7 && y == 3 ? NaN : Noise(x, y, z); });
  std::vector<float> first;
  for (const int number : { 1, 2, 3, 7 })
  {
    const Threads threads(number);
    vtkNew<vtkTFCGradientMagnitude> filter;
    auto* result = vtkFloatArray::SafeDownCast(Compute(filter.Get(), image, Result));
    ASSERT_NE(result, nullptr);
    const float* values = result->GetPointer(0);
    if (first.empty())
    {
      first.assign(values, values + result->GetNumberOfValues());
    }
    EXPECT_EQ(std::memcmp(first.data(), values, first.size() * sizeof(float)), 0);
  }
}

TEST(GradientMagnitude, SameBitsOnEveryProcessor)
{
  for (const bool holes : { false, true })
  {
    const auto image = MakeVolume<vtkFloatArray>(61, 20, 13,
      [&](int x, int y, int z) { return holes && x == 7 && y > 3 ? NaN : Noise(x, y, z); });
    std::string first;
    for (const char* level : { "baseline", "avx2", "avx512" })
    {
      const SimdLimit limit(level);
      vtkNew<vtkTFCGradientMagnitude> filter;
      const std::string bytes = GetBytes(Compute(filter.Get(), image, "a_gradient"));
      ASSERT_FALSE(bytes.empty());
      first = first.empty() ? bytes : first;
      EXPECT_TRUE(first == bytes) << level;
    }
  }
}
