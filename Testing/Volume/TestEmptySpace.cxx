// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Skipping empty space must not change a pixel, and no visible voxel may lie in a skipped brick.
#include "Support/VolumeScene.h"

#include "vtkTFCBrickActivity.h"
#include "vtkTFCBrickDistances.h"
#include "vtkTFCClassifier.h"

#include "vtkCamera.h"
#include "vtkPlane.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace tfctest;

namespace
{

constexpr int Voxels = 50;

std::string MakeBlob(int id, double x, double y, const std::string& tertiary)
{
  return R"({"id": )" + std::to_string(id) + R"(, "shape": {"type": "ellipse", "center": [)" +
    std::to_string(x) + ", " + std::to_string(y) + R"(], "radii": [0.04, 0.1], "angle": 30},
    "color": [1, 0.6, 0.2], "opacity": 0.4, "tertiary": )" +
    tertiary + "}";
}

const std::string Ramp = R"({"array": "t", "component": 0, "range": [0, 1],
  "opacity": [[0.3, 0], [0.5, 1], [0.5, 0.2], [0.7, 0]]})";

// Smooth attributes, few of whose values are visible, seen obliquely.
class EmptySpace : public testing::Test
{
protected:
  EmptySpace()
    : Scene(150)
    , Image(MakeImage(Voxels, Voxels - 7, Voxels + 9))
  {
    AddField(this->Image, "x",
      [](double x, double y, double z)
      { return 0.5 + 0.5 * std::sin(0.1 * x + 0.07 * y) * z / 60; });
    AddField(this->Image, "y",
      [](double x, double y, double z)
      { return 0.5 + 0.5 * std::cos(0.13 * z + 0.05 * x - 0.02 * y); });
    AddField(this->Image, "t", [](double x, double y, double) { return (x + y) / (2 * Voxels); });
    this->Scene.Mapper->SetInputData(this->Image);
    this->SetRegions(MakeBlob(1, 0.6, 0.6, "null") + "," + MakeBlob(2, 0.3, 0.3, Ramp));
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(90, 70, 120);
    camera->SetFocalPoint(24, 21, 28);
    camera->SetViewUp(0, 1, 0.2);
  }

  void SetRegions(const std::string& regions)
  {
    ASSERT_TRUE(this->Scene.Model->SetState(MakeState(regions).c_str()))
      << this->Scene.Model->GetLastError();
  }

  void ExpectSamePicture()
  {
    for (const double distance : { 0.0, 1.7, 30.0 })
    {
      this->Scene.Mapper->SetSampleDistance(distance);
      this->Scene.Mapper->EmptySpaceSkippingOn();
      const Picture with = this->Scene.Render();
      this->Scene.Mapper->EmptySpaceSkippingOff();
      const Picture without = this->Scene.Render();
      EXPECT_EQ(Compare(with, without).Largest, 0) << "sample distance " << distance;
      EXPECT_GT(*std::max_element(with.Values.begin(), with.Values.end()), 40);
    }
  }

  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

}

TEST_F(EmptySpace, PerspectiveAndParallel)
{
  this->ExpectSamePicture();
  this->Scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Scene.Renderer->GetActiveCamera()->SetParallelScale(40);
  this->ExpectSamePicture();
}

TEST_F(EmptySpace, AlongAnAxisAndFromInside)
{
  this->Scene.LookAlongZ(24, 21, 28, 60);
  this->ExpectSamePicture();
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(3, 4, 55);
  this->ExpectSamePicture();
}

TEST_F(EmptySpace, SevenAttributes)
{
  std::string regions;
  for (int i = 0; i < 5; ++i)
  {
    const std::string name = "v" + std::to_string(i);
    AddField(this->Image, name.c_str(),
      [i](double x, double y, double z)
      { return 0.5 + 0.5 * std::sin(0.05 * (i + 1) * x + 0.03 * y - 0.02 * i * z); });
    regions += (i ? "," : "") +
      MakeBlob(i + 1, 0.2 + 0.15 * i, 0.4 + 0.1 * (i % 3),
        R"({"array": ")" + name + R"(", "component": 0, "range": [0, 1],
          "opacity": [[0.6, 0], [0.8, 1]]})");
  }
  this->SetRegions(regions);
  this->ExpectSamePicture();
}

TEST_F(EmptySpace, Shaded)
{
  this->Scene.Volume->GetProperty()->ShadeOn();
  this->ExpectSamePicture();
}

TEST_F(EmptySpace, NearestNeighbour)
{
  this->Scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
  this->ExpectSamePicture();
}

TEST_F(EmptySpace, ClippingAndCropping)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(20, 20, 20);
  plane->SetNormal(-0.3, 0.2, 1);
  this->Scene.Mapper->AddClippingPlane(plane);
  this->ExpectSamePicture();
  this->Scene.Mapper->SetCropping(1);
  this->Scene.Mapper->SetCroppingRegionPlanes(10, 30, 10, 30, 12.5, 40);
  this->Scene.Mapper->SetCroppingRegionFlagsToFence();
  this->ExpectSamePicture();
}

TEST_F(EmptySpace, NoDataAndBlankedCells)
{
  AddField(this->Image, "y",
    [](double x, double y, double z)
    {
      return x > 30 && z > 30 ? std::numeric_limits<double>::quiet_NaN()
                              : 0.5 + 0.5 * std::cos(0.13 * z + 0.05 * x - 0.02 * y);
    });
  this->ExpectSamePicture();
  vtkUnsignedCharArray* cells = this->Image->AllocateCellGhostArray();
  for (vtkIdType i = 0; i < this->Image->GetNumberOfCells(); ++i)
  {
    cells->SetValue(i, i % 49 < 10 ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  this->ExpectSamePicture();
}

TEST_F(EmptySpace, ATwistedAndAnisotropicImage)
{
  const double direction[9] = { 0, 1, 0, 0.6, 0, 0.8, 0.8, 0, -0.6 };
  this->Image->SetDirectionMatrix(direction);
  this->Image->SetSpacing(1, 0.3, 2);
  this->Scene.Renderer->ResetCamera();
  this->ExpectSamePicture();
}

TEST_F(EmptySpace, AnEditMovesTheActiveBricks)
{
  this->Scene.Render();
  this->SetRegions(MakeBlob(1, 0.7, 0.45, Ramp));
  this->ExpectSamePicture();
}

TEST(BrickActivity, NoVisibleVoxelIsInAnInactiveBrick)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::array<int, 3> texels = { 37, 17, 26 };
  const size_t count = static_cast<size_t>(texels[0]) * texels[1] * texels[2];
  const std::vector<vtkTFCStoredAttribute> stored = { { 0, 0, 1 }, { 1, -2, 4 }, { 2, 10, 5 } };
  int inactive = 0;
  for (int round = 0; round < 40; ++round)
  {
    // Clumps of similar values, so that there are bricks of all kinds.
    std::vector<float> values(4 * count);
    double phase[9];
    std::generate(phase, phase + 9, [&] { return 0.4 * uniform(random) - 0.2; });
    for (size_t i = 0; i < count; ++i)
    {
      const double p[3] = { static_cast<double>(i % texels[0]),
        static_cast<double>(i / texels[0] % texels[1]),
        static_cast<double>(i / texels[0] / texels[1]) };
      for (int c = 0; c < 3; ++c)
      {
        const double wave = std::sin(
          phase[3 * c] * p[0] + phase[3 * c + 1] * p[1] + phase[3 * c + 2] * p[2] + 3.0 * c);
        const bool nan = uniform(random) < 0.001;
        values[4 * i + c] =
          nan ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(0.5 + 0.5 * wave);
      }
    }
    vtkTFCCompiledModel model;
    model.Attributes = { { "x", 0 }, { "y", 0 }, { "t", 0 } };
    model.Range = { { { 0.1, 0.9 }, { -1.8, 1.9 } } };
    for (int r = 0; r < 3; ++r)
    {
      vtkTFCCompiledRegion region;
      region.Shape = r % 2 ? vtkTFCShapeType::Ellipse : vtkTFCShapeType::Rectangle;
      region.Falloff = vtkTFCFalloffType::Constant;
      region.Center = { uniform(random), uniform(random) };
      region.HalfSize = { 0.01 + 0.1 * uniform(random), 0.01 + 0.2 * uniform(random) };
      region.Cosine = std::cos(round);
      region.Sine = std::sin(round);
      const double reach = region.HalfSize[0] + region.HalfSize[1];
      region.Bounds = { region.Center[0] - reach, region.Center[0] + reach,
        region.Center[1] - reach, region.Center[1] + reach };
      if (r > 0)
      {
        region.Tertiary = 2;
        const double begin = 10 + 4 * uniform(random);
        region.TertiaryOpacity = { { begin, 0 }, { begin + 0.5, 1 }, { begin + 0.5, 0 } };
      }
      model.Regions.push_back(region);
    }

    vtkTFCBrickRanges ranges;
    ranges.Compute(values.data(), texels, 4);
    const auto active = vtkTFCBrickActivity::Find(ranges, {}, model, stored);
    const auto& bricks = ranges.GetDimensions();
    const vtkTFCClassifier classifier(model);
    for (size_t i = 0; i < count; ++i)
    {
      const int p[3] = { static_cast<int>(i % texels[0]),
        static_cast<int>(i / texels[0] % texels[1]), static_cast<int>(i / texels[0] / texels[1]) };
      double data[3];
      const double* attributes[3] = { data, data + 1, data + 2 };
      for (int c = 0; c < 3; ++c)
      {
        data[c] = stored[c].Offset + stored[c].Scale * static_cast<double>(values[4 * i + c]);
      }
      float opacity = 0;
      classifier.Classify(1, attributes, nullptr, nullptr, &opacity);
      std::array<int, 3> b;
      for (int axis = 0; axis < 3; ++axis)
      {
        b[axis] = std::min(p[axis] / ranges.GetBrickSize(), bricks[axis] - 1);
      }
      const size_t brick = b[0] + static_cast<size_t>(bricks[0]) * (b[1] + bricks[1] * b[2]);
      ASSERT_TRUE(opacity == 0 || active[brick]) << "voxel " << i << " of round " << round;
    }
    inactive += static_cast<int>(std::count(active.begin(), active.end(), 0));
  }
  EXPECT_GT(inactive, 200) << "nothing would be skipped";
}

TEST(BrickActivity, LargeVolumesHaveLargerBricks)
{
  vtkTFCBrickRanges ranges;
  std::vector<float> values(size_t(2) * 3000 * 3000, 0.25F);
  ranges.Compute(values.data(), { 3000, 300, 1 }, 2);
  EXPECT_EQ(ranges.GetBrickSize(), 4);
  values[2 * 5000] = 0.5F; // in row 1
  ranges.Compute(values.data(), { 3000, 3000, 1 }, 2);
  EXPECT_EQ(ranges.GetBrickSize(), 8);
  EXPECT_EQ(ranges.GetDimensions(), (std::array<int, 3>{ 375, 375, 1 }));
  EXPECT_EQ(ranges.GetRanges()[250].Minimum[0], 0.25F);
  EXPECT_EQ(ranges.GetRanges()[250].Maximum[0], 0.5F);
  EXPECT_EQ(ranges.GetRanges()[251].Maximum[0], 0.25F);
}

TEST(BrickDistances, AreChessboardDistances)
{
  std::mt19937 random(3);
  const std::array<int, 3> sizes[] = { { 9, 7, 12 }, { 70, 3, 2 }, { 1, 40, 5 }, { 2, 3, 80 },
    { 1, 1, 1 } };
  for (const auto& size : sizes)
  {
    const size_t count = static_cast<size_t>(size[0]) * size[1] * size[2];
    const auto place = [&](size_t i)
    {
      return std::array<int, 3>{ static_cast<int>(i % size[0]),
        static_cast<int>(i / size[0] % size[1]), static_cast<int>(i / size[0] / size[1]) };
    };
    for (const size_t number : { 0, 1, 4, 30 })
    {
      std::vector<unsigned char> active(count, 0);
      std::vector<size_t> list;
      for (size_t i = 0; i < number; ++i)
      {
        list.push_back(random() % count);
        active[list.back()] = 1;
      }
      const auto distances = vtkTFCBrickDistances::Find(active, size);
      for (size_t i = 0; i < count; ++i)
      {
        int expected = vtkTFCBrickDistances::Largest;
        for (const size_t j : list)
        {
          int distance = 0;
          for (int axis = 0; axis < 3; ++axis)
          {
            distance = std::max(distance, std::abs(place(i)[axis] - place(j)[axis]));
          }
          expected = std::min(expected, distance);
        }
        ASSERT_EQ(distances[i], expected) << i << " of " << count << ", " << number << " active";
      }
    }
  }
}
