// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSizeVolumes.h"

#include "vtkMatrix3x3.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

using namespace testing_volumes;

namespace
{
void ExpectRefusal(vtkTFCFeatureSize* filter, vtkImageData* image, const std::string& what)
{
  Errors errors(filter);
  filter->Modified();
  EXPECT_EQ(Compute(filter, image, "a_size"), nullptr) << what;
  EXPECT_TRUE(errors.Mention(what)) << errors.Text;
  EXPECT_TRUE(errors.Mention("Set ")) << errors.Text;
  EXPECT_EQ(filter->GetBlobs()->GetNumberOfPoints(), 0);
  EXPECT_NE(filter->GetBlobs()->GetPointData()->GetArray("size"), nullptr);
  filter->RemoveAllObservers();
}
}

TEST(FeatureSizeBlobs, LieInTheWorld)
{
  const auto image = MakeVolume(56, 52, 50, MakeBalls({ { { 25.3, 24.8, 26.4 }, 7., 1. } }));
  image->SetOrigin(10., -20., 5.);
  image->SetSpacing(2., 2., 2.);
  // A quarter turn about z.
  image->SetDirectionMatrix(0., -1., 0., 1., 0., 0., 0., 0., 1.);
  vtkNew<vtkTFCFeatureSize> filter;
  filter->SetLargestSize(20.);
  ASSERT_NE(Compute(filter.Get(), image, "a_size"), nullptr);
  const vtkIdType best = FindStrongest(filter);
  ASSERT_GE(best, 0);
  double place[3], expected[3];
  filter->GetBlobs()->GetPoint(best, place);
  // The image's first sample has the index (3, -2, 7).
  image->TransformContinuousIndexToPhysicalPoint(28.3, 22.8, 33.4, expected);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_NEAR(place[a], expected[a], 0.3);
  }
  EXPECT_NEAR(GetColumn(filter, "size")->GetTuple1(best), 7., 0.5);
  EXPECT_NEAR(GetColumn(filter, "radius_world")->GetTuple1(best), 14., 1.);
  EXPECT_EQ(filter->GetBlobs()->GetNumberOfVerts(), filter->GetBlobs()->GetNumberOfPoints());

  filter->SetLengthUnit(vtkTFCFeatureSize::WORLD);
  filter->SetSmallestSize(5.);
  filter->SetLargestSize(40.);
  ASSERT_NE(Compute(filter.Get(), image, "a_size"), nullptr);
  const vtkIdType world = FindStrongest(filter);
  EXPECT_NEAR(GetColumn(filter, "size")->GetTuple1(world), 14., 1.);
  EXPECT_EQ(GetColumn(filter, "radius_world")->GetTuple1(world),
    GetColumn(filter, "size")->GetTuple1(world));
}

TEST(FeatureSizeBlobs, OfSeveralArrays)
{
  const auto image = MakeVolume(60, 40, 40, MakeBalls({ { { 20., 20., 20. }, 6., 1. } }));
  image->GetPointData()->AddArray(
    MakeArray("b", 60, 40, 40, MakeBalls({ { { 40., 20., 20. }, 9., 50. } })));
  vtkNew<vtkTFCFeatureSize> filter;
  filter->AddArray("b");
  filter->SetLargestSize(15.);
  ASSERT_NE(Compute(filter.Get(), image, "a_size"), nullptr);
  vtkDataArray* second = filter->GetImageDataOutput()->GetPointData()->GetArray("b_size");
  ASSERT_NE(second, nullptr);
  EXPECT_NEAR(GetSizeAt(image, second, 40., 20., 20.), 9., 0.6);
  EXPECT_EQ(GetSizeAt(image, second, 20., 20., 20.), 0.);
  auto* names =
    vtkStringArray::SafeDownCast(filter->GetBlobs()->GetPointData()->GetAbstractArray("array"));
  ASSERT_NE(names, nullptr);
  bool found[2] = { false, false };
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    const bool isSecond = filter->GetBlobs()->GetPoint(i)[0] > 3. + 30.;
    EXPECT_EQ(names->GetValue(i), isSecond ? "b" : "a");
    found[isSecond] = true;
  }
  EXPECT_TRUE(found[0] && found[1]);
}

TEST(FeatureSizeBlobs, BadParameters)
{
  const auto image = MakeVolume(60, 30, 30, Noise);
  vtkNew<vtkTFCFeatureSize> filter;
  const auto expect = [&](const std::string& what) { ExpectRefusal(filter, image, what); };

  filter->UseIntensityRangeOn();
  for (const double upper : { 2., 1., NaN, static_cast<double>(INFINITY) })
  {
    filter->SetIntensityRange(2., upper);
    expect("IntensityRange is (2,");
  }
  filter->UseIntensityRangeOff();
  for (const double size : { 0., -1., NaN, static_cast<double>(INFINITY) })
  {
    filter->SetSmallestSize(size);
    expect("SmallestSize is");
  }
  filter->SetSmallestSize(2.5);
  for (const double size : { 0., -1., 2.5, 2., NaN, static_cast<double>(INFINITY) })
  {
    filter->SetLargestSize(size);
    expect("LargestSize is");
  }
  filter->SetLargestSize(30.5);
  expect("half the volume's longest side is 30");
  filter->SetLargestSize(25.);
  filter->SetSmallestSize(1.4);
  expect("smaller than 1.5");
  filter->SetSmallestSize(2.5);
  filter->SetLengthUnit(vtkTFCFeatureSize::WORLD);
  image->SetSpacing(4., 2., 3.);
  expect("smaller than 3");
  filter->SetLengthUnit(vtkTFCFeatureSize::VOXELS);
  for (const int scales : { -1, 0, 1, 101 })
  {
    filter->SetNumberOfScales(scales);
    expect("NumberOfScales is");
  }
  filter->SetNumberOfScales(12);
  for (const double value : { 0., -1., NaN, static_cast<double>(INFINITY) })
  {
    filter->SetConductance(value);
    expect("Conductance is");
    filter->SetConductance(0.5);
    filter->SetThreshold(value);
    expect("Threshold is");
    filter->SetThreshold(0.1);
  }
  EXPECT_NE(Compute(filter.Get(), image, "a_size"), nullptr);

  // The conductance plays no part in the Gaussian scale space.
  filter->SetScaleSpace(vtkTFCFeatureSize::GAUSSIAN);
  filter->SetConductance(0.);
  EXPECT_NE(Compute(filter.Get(), image, "a_size"), nullptr);

  const auto single = MakeVolume(1, 1, 1, Noise);
  Errors errors(filter);
  EXPECT_EQ(Compute(filter.Get(), single, "a_size"), nullptr);
  EXPECT_TRUE(errors.Mention("The volume has one sample"));
}

TEST(FeatureSizeBlobs, ExtremesOfTheParameters)
{
  const auto image = MakeVolume(60, 30, 30, Noise);
  for (const int scales : { 2, 3, 100 })
  {
    vtkNew<vtkTFCFeatureSize> filter;
    filter->SetNumberOfScales(scales);
    filter->SetSmallestSize(1.5);
    filter->SetLargestSize(30.);
    filter->SetConductance(scales == 3 ? 1e-30 : 1e30);
    filter->SetThreshold(1e-6);
    filter->SetPolarity(vtkTFCFeatureSize::BOTH);
    vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
    ASSERT_NE(sizes, nullptr);
    EXPECT_GE(sizes->GetRange()[0], 0.);
    EXPECT_LE(sizes->GetRange()[1], 30. * std::sqrt(20.));
    EXPECT_TRUE(scales < 100 || filter->GetBlobs()->GetNumberOfPoints() > 0);
  }
}

TEST(FeatureSizeBlobs, RangesAtTheLimitsOfFloats)
{
  const Function ball = MakeBalls({ { { 30., 24., 24. }, 7., 1. } });
  for (const double factor : { 1e-42, 1e-37, 1e37, 1.6e38 })
  {
    const auto image = MakeVolume(56, 50, 48,
      [&](int x, int y, int z) { return factor * (2. * ball(x, y, z) - 1.); });
    vtkNew<vtkTFCFeatureSize> filter;
    vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
    ASSERT_NE(sizes, nullptr);
    const double expected = factor < 1e-40 ? 0. : 7.;
    EXPECT_NEAR(GetSizeAt(image, sizes, 30., 24., 24.), expected, 0.4) << factor;
  }
}

TEST(FeatureSizeBlobs, MemoryIsRefusedBeforeItIsTaken)
{
  const auto image = MakeVolume(80, 80, 80, Noise);
  vtkNew<vtkTFCFeatureSize> filter;
  Errors errors(filter);
  setenv("TFC_MEMORY_LIMIT", "8", 1);
  EXPECT_EQ(Compute(filter.Get(), image, "a_size"), nullptr);
  unsetenv("TFC_MEMORY_LIMIT");
  EXPECT_TRUE(errors.Mention("MiB of memory")) << errors.Text;
}

TEST(FeatureSizeBlobs, EmptyInput)
{
  vtkNew<vtkImageData> image;
  vtkNew<vtkTFCFeatureSize> filter;
  Errors errors(filter);
  EXPECT_EQ(Compute(filter.Get(), image, "a_size"), nullptr);
  EXPECT_TRUE(errors.Mention("The input is empty"));
  EXPECT_EQ(filter->GetBlobs()->GetNumberOfPoints(), 0);
}
