// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSizeVolumes.h"

#include "vtkCellData.h"
#include "vtkCommand.h"

#include <gtest/gtest.h>

#include <chrono>

using namespace testing_volumes;

namespace
{
constexpr double Middle = 30.;

/**
 * One ball in the middle of 61 samples per axis.
 */
vtkSmartPointer<vtkImageData> MakeBall(double radius, double contrast = 1.)
{
  return MakeVolume(61, 61, 61, MakeBalls({ { { Middle, Middle, Middle }, radius, contrast } }));
}
}

TEST(FeatureSize, BallsGetTheirRadii)
{
  for (const int scaleSpace : { vtkTFCFeatureSize::NONLINEAR, vtkTFCFeatureSize::GAUSSIAN })
  {
    for (const double radius : { 4., 6.5, 9., 13. })
    {
      const auto image = MakeBall(radius);
      vtkNew<vtkTFCFeatureSize> filter;
      filter->SetScaleSpace(scaleSpace);
      vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
      ASSERT_NE(sizes, nullptr);
      EXPECT_NEAR(GetSizeAt(image, sizes, Middle, Middle, Middle), radius, 0.06 * radius);
      EXPECT_EQ(GetSizeAt(image, sizes, 0., 0., 0.), 0.);
      const vtkIdType best = FindStrongest(filter);
      ASSERT_GE(best, 0);
      EXPECT_NEAR(GetColumn(filter, "response")->GetTuple1(best), 0.925, 0.05);
      const double sigma = GetColumn(filter, "scale")->GetTuple1(best);
      EXPECT_NEAR(sigma * std::sqrt(3.), GetColumn(filter, "size")->GetTuple1(best), 1e-5 * radius);
    }
  }
}

TEST(FeatureSize, NoisyPhantom)
{
  for (const int scaleSpace : { vtkTFCFeatureSize::NONLINEAR, vtkTFCFeatureSize::GAUSSIAN })
  {
    for (const unsigned int seed : { 1u, 2u })
    {
      const auto image = MakeVolume<vtkFloatArray>(PhantomSize[0], PhantomSize[1], PhantomSize[2],
        AddNoise(MakeBalls(GetThreeBalls()), 0.13, seed));
      vtkNew<vtkTFCFeatureSize> filter;
      filter->SetScaleSpace(scaleSpace);
      vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
      ASSERT_NE(sizes, nullptr);
      for (const Ball& ball : GetThreeBalls())
      {
        // The core: within half the radius.
        for (int i = 0; i < 27; ++i)
        {
          const double step = 0.28 * ball.Radius;
          const int side[3] = { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
          const double x = ball.Center[0] + side[0] * step;
          const double y = ball.Center[1] + side[1] * step;
          const double z = ball.Center[2] + side[2] * step;
          EXPECT_NEAR(GetSizeAt(image, sizes, x, y, z), ball.Radius, 0.1 * ball.Radius);
        }
      }
      // Noise does not dominate.
      vtkIdType covered = 0;
      for (vtkIdType i = 0; i < sizes->GetNumberOfTuples(); ++i)
      {
        covered += sizes->GetTuple1(i) > 0. ? 1 : 0;
      }
      EXPECT_LT(static_cast<double>(covered),
        0.08 * static_cast<double>(image->GetNumberOfPoints()));
      EXPECT_LT(filter->GetBlobs()->GetNumberOfPoints(), 40);
    }
  }
}

TEST(FeatureSize, IntensityRangeUncoversSmallObjects)
{
  const auto image = MakeVolume(61, 61, 61,
    MakeBalls({ { { Middle, Middle, Middle }, 22., 50. }, { { 36., 30., 30. }, 6., 50. } }));
  vtkNew<vtkTFCFeatureSize> filter;
  filter->SetLargestSize(28.);
  vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
  EXPECT_NEAR(GetSizeAt(image, sizes, 36., 30., 30.), 22., 2.2);

  filter->UseIntensityRangeOn();
  filter->SetIntensityRange(75., 110.);
  sizes = Compute(filter.Get(), image, "a_size");
  EXPECT_NEAR(GetSizeAt(image, sizes, 36., 30., 30.), 6., 0.6);
  EXPECT_EQ(GetSizeAt(image, sizes, 20., 30., 30.), 0.);

  filter->SetIntensityRange(40., 60.);
  sizes = Compute(filter.Get(), image, "a_size");
  EXPECT_NEAR(GetSizeAt(image, sizes, 22., 30., 30.), 22., 2.2);

  // Nothing inside: not an error, there are just no objects.
  filter->SetIntensityRange(1000., 2000.);
  Errors errors(filter);
  sizes = Compute(filter.Get(), image, "a_size");
  EXPECT_EQ(sizes->GetRange()[1], 0.);
  EXPECT_EQ(filter->GetBlobs()->GetNumberOfPoints(), 0);
  EXPECT_EQ(errors.Text, "");
}

TEST(FeatureSize, Polarity)
{
  const auto image = MakeVolume(61, 40, 40,
    MakeBalls({ { { 16., 20., 20. }, 7., 1. }, { { 44., 20., 20. }, 7., -1. } }));
  vtkNew<vtkTFCFeatureSize> filter;
  filter->SetLargestSize(15.);
  const double expected[3][2] = { { 7., 0. }, { 0., 7. }, { 7., 7. } };
  for (const int polarity :
    { vtkTFCFeatureSize::BRIGHT, vtkTFCFeatureSize::DARK, vtkTFCFeatureSize::BOTH })
  {
    filter->SetPolarity(polarity);
    vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
    EXPECT_NEAR(GetSizeAt(image, sizes, 16., 20., 20.), expected[polarity][0], 0.6);
    EXPECT_NEAR(GetSizeAt(image, sizes, 44., 20., 20.), expected[polarity][1], 0.6);
    for (vtkIdType i = 0; i < filter->GetBlobs()->GetNumberOfPoints(); ++i)
    {
      const double response = GetColumn(filter, "response")->GetTuple1(i);
      EXPECT_TRUE(polarity == vtkTFCFeatureSize::BOTH ||
        (response > 0.) == (polarity == vtkTFCFeatureSize::BRIGHT));
    }
  }
}

TEST(FeatureSize, WorldUnitsOnUnevenSpacing)
{
  for (const int scaleSpace : { vtkTFCFeatureSize::NONLINEAR, vtkTFCFeatureSize::GAUSSIAN })
  {
    const auto image =
      MakeVolume(80, 40, 27, MakeBalls({ { { 2., 1.9, 1.95 }, 0.9, 1. } }, 0.05, 0.1, 0.15));
    image->SetSpacing(0.05, 0.1, 0.15);
    vtkNew<vtkTFCFeatureSize> filter;
    filter->SetScaleSpace(scaleSpace);
    filter->SetLengthUnit(vtkTFCFeatureSize::WORLD);
    filter->SetSmallestSize(0.2);
    filter->SetLargestSize(1.8);
    vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
    ASSERT_NE(sizes, nullptr);
    EXPECT_NEAR(GetSizeAt(image, sizes, 40., 19., 13.), 0.9, 0.05);
  }
}

TEST(FeatureSize, VoxelsTakeTheLatticeAsCubic)
{
  const auto image = MakeBall(7.);
  vtkNew<vtkTFCFeatureSize> filter, stretched;
  vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(image);
  copy->SetSpacing(3., 0.1, 17.);
  vtkDataArray* other = Compute(stretched.Get(), copy, "a_size");
  for (vtkIdType i = 0; i < sizes->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(sizes->GetTuple1(i), other->GetTuple1(i));
  }
}

TEST(FeatureSize, ThinVolumes)
{
  const Function disk = [](int x, int y, int z)
  { return std::hypot(x, y, z - 40.) <= 8. ? 1. : 0.; };
  const auto shifted = [&](int x, int y, int z, int axis)
  {
    return axis == 0 ? disk(0, y - 40, z)
      : axis == 1    ? disk(x - 40, 0, z)
                     : disk(x - 40, y - 40, 40);
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    int n[3] = { 81, 81, 81 };
    n[axis] = 1;
    const auto image =
      MakeVolume(n[0], n[1], n[2], [&](int x, int y, int z) { return shifted(x, y, z, axis); });
    vtkNew<vtkTFCFeatureSize> filter;
    vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
    ASSERT_NE(sizes, nullptr);
    double at[3] = { 40., 40., 40. };
    at[axis] = 0.;
    EXPECT_NEAR(GetSizeAt(image, sizes, at[0], at[1], at[2]), 8., 0.4) << axis;
  }
  // A line: 2 h + 1 samples are 2 h + 1 long.
  const auto line =
    MakeVolume(1, 1, 101, [](int, int, int z) { return std::abs(z - 50) <= 8 ? 1. : 0.; });
  vtkNew<vtkTFCFeatureSize> filter;
  vtkDataArray* sizes = Compute(filter.Get(), line, "a_size");
  EXPECT_NEAR(GetSizeAt(line, sizes, 0., 0., 50.), 8.5, 0.5);
}

TEST(FeatureSize, ConstantVolumeHasNoObjects)
{
  const auto image = MakeVolume(51, 20, 20, [](int, int, int) { return 7.; });
  vtkNew<vtkTFCFeatureSize> filter;
  Errors errors(filter);
  vtkDataArray* sizes = Compute(filter.Get(), image, "a_size");
  ASSERT_NE(sizes, nullptr);
  EXPECT_EQ(sizes->GetRange()[0], 0.);
  EXPECT_EQ(sizes->GetRange()[1], 0.);
  EXPECT_EQ(filter->GetBlobs()->GetNumberOfPoints(), 0);
  EXPECT_EQ(errors.Text, "");
}

TEST(FeatureSize, InvalidSamplesAreWalls)
{
  const auto ball = MakeBalls({ { { 22., Middle, Middle }, 8., 1. } });
  const auto isHole = [](int x, int y, int z)
  { return x >= 42 || (x == 22 && y == 30 && z == 38) || (x == 3 && y == 3); };
  const auto holes = MakeVolume(61, 61, 61,
    [&](int x, int y, int z) { return isHole(x, y, z) ? NaN : ball(x, y, z); });
  const auto blanked = MakeVolume(61, 61, 61,
    [&](int x, int y, int z) { return isHole(x, y, z) ? 1e6 : ball(x, y, z); });
  Blank(blanked,
    [&](vtkIdType i)
    {
      return isHole(static_cast<int>(i % 61), static_cast<int>(i / 61 % 61),
        static_cast<int>(i / 3721));
    });
  vtkNew<vtkTFCFeatureSize> filter, other;
  filter->SetPolarity(vtkTFCFeatureSize::BOTH);
  other->SetPolarity(vtkTFCFeatureSize::BOTH);
  vtkDataArray* sizes = Compute(filter.Get(), holes, "a_size");
  vtkDataArray* fromBlanked = Compute(other.Get(), blanked, "a_size");
  EXPECT_NEAR(GetSizeAt(holes, sizes, 22., Middle, Middle), 8., 0.6);
  for (vtkIdType i = 0; i < sizes->GetNumberOfTuples(); ++i)
  {
    const bool hole =
      isHole(static_cast<int>(i % 61), static_cast<int>(i / 61 % 61), static_cast<int>(i / 3721));
    ASSERT_EQ(std::isnan(sizes->GetTuple1(i)), hole);
    ASSERT_TRUE(hole || sizes->GetTuple1(i) == fromBlanked->GetTuple1(i));
  }
}

TEST(FeatureSize, CellData)
{
  const auto f = MakeBalls({ { { 20., 24., 22. }, 7., 1. } });
  const auto points = MakeVolume(50, 48, 46, f);
  const auto cells = MakeImage(51, 49, 47);
  cells->GetCellData()->AddArray(MakeArray("a", 50, 48, 46, f));
  vtkNew<vtkTFCFeatureSize> ofPoints, ofCells;
  for (const auto& filter : { ofPoints.Get(), ofCells.Get() })
  {
    filter->SetLargestSize(20.);
  }
  vtkDataArray* expected = Compute(ofPoints.Get(), points, "a_size");
  vtkDataArray* sizes =
    Compute(ofCells.Get(), cells, "a_size", vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ASSERT_NE(sizes, nullptr);
  ASSERT_EQ(sizes->GetNumberOfTuples(), expected->GetNumberOfTuples());
  for (vtkIdType i = 0; i < sizes->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(sizes->GetTuple1(i), expected->GetTuple1(i));
  }
  // The middle of a cell is half a sample off its corner.
  double point[3], cell[3];
  ofPoints->GetBlobs()->GetPoint(0, point);
  ofCells->GetBlobs()->GetPoint(0, cell);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_NEAR(cell[a] - point[a], 0.5, 1e-9);
  }
}

TEST(FeatureSize, ProgressAndAbort)
{
  const auto image = MakeVolume<vtkFloatArray>(96, 96, 96, Noise);
  struct Log
  {
    std::vector<double> Values;
    double AbortAt = 2.;
    std::chrono::steady_clock::time_point Aborted;
  } log;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&log);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void* value)
    {
      auto* seen = static_cast<Log*>(data);
      seen->Values.push_back(*static_cast<double*>(value));
      if (seen->Values.back() >= seen->AbortAt)
      {
        seen->Aborted = std::chrono::steady_clock::now();
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    });
  vtkNew<vtkTFCFeatureSize> filter;
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  EXPECT_NE(Compute(filter.Get(), image, "a_size"), nullptr);
  EXPECT_TRUE(std::is_sorted(log.Values.begin(), log.Values.end()));
  EXPECT_GT(log.Values.size(), 40u);
  EXPECT_NEAR(log.Values.back(), 1., 1e-9);

  log.AbortAt = 0.4;
  filter->Modified();
  EXPECT_EQ(Compute(filter.Get(), image, "a_size"), nullptr);
  const std::chrono::duration<double> late = std::chrono::steady_clock::now() - log.Aborted;
  EXPECT_LT(late.count(), 1.);
  EXPECT_EQ(filter->GetBlobs()->GetNumberOfPoints(), 0);
}
