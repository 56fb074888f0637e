// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The CPU renderer: the same picture as OpenGL's on a smooth scene, lengths of rays through fog,
// when it classifies, and what it says about what it cannot do.
#include "Support/VolumeScene.h"

#include "vtkTFCGraphicsSupport.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"

#include <gtest/gtest.h>

#include <limits>

using namespace tfctest;

namespace
{

constexpr int Voxels = 64;
constexpr int Pixels = 128;

// Attributes and regions that change little from voxel to voxel.
void MakeSmoothScene(VolumeScene& scene, const std::string& opacities = "[0.15, 0.2, 0.1]")
{
  auto image = MakeImage(Voxels, Voxels, Voxels);
  const double c = 0.5 * (Voxels - 1);
  AddField(image, "x",
    [c](double x, double y, double z)
    { return std::exp(-((x - c) * (x - c) + (y - c) * (y - c) + (z - c) * (z - c)) / 500.0); });
  AddField(image, "y",
    [](double x, double y, double z)
    { return 0.5 + 0.4 * std::sin(0.11 * x + 0.07 * y - 0.05 * z); });
  AddField(image, "t", [](double x, double y, double z) { return 0.3 * x - 0.2 * y + 0.25 * z; });
  scene.Mapper->SetInputData(image);
  double a = 0;
  double b = 0;
  double d = 0;
  ASSERT_EQ(std::sscanf(opacities.c_str(), "[%lf, %lf, %lf]", &a, &b, &d), 3);
  const std::string state = MakeState(
    R"({"id": 1, "shape": {"type": "ellipse", "center": [0.3, 0.5], "radii": [0.25, 0.4],
      "angle": 20}, "falloff": {"type": "smooth", "width": 0.9}, "color": [0.9, 0.2, 0.1],
      "opacity": )" +
    std::to_string(a) + R"(, "tertiary": {"array": "t", "component": 0, "range": [-13, 35],
      "opacity": [[0, 0.1], [10, 1], [30, 0.2]]}},
     {"id": 2, "shape": {"type": "triangle", "points": [[0.4, 0.1], [1.0, 0.5], [0.5, 0.9]]},
      "falloff": {"type": "linear", "width": 0.9}, "color": [0.1, 0.8, 0.3], "opacity": )" +
    std::to_string(b) + R"(},
     {"id": 3, "shape": {"type": "rectangle", "center": [0.6, 0.6], "halfsize": [0.3, 0.3]},
      "falloff": {"type": "smooth", "width": 1}, "color": [0.2, 0.3, 1], "opacity": )" +
    std::to_string(d) + "}");
  ASSERT_TRUE(scene.Model->SetState(state.c_str())) << scene.Model->GetLastError();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(c, c, c);
  camera->SetPosition(c + 90, c + 60, c + 130);
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(32);
}

Difference CompareRenderers(VolumeScene& scene, double& brightest)
{
  scene.Mapper->SetRenderer(vtkTFCVolumeMapper::GPURenderer);
  const Picture gpu = scene.Render();
  EXPECT_FALSE(scene.Mapper->GetUsedCPU());
  scene.Mapper->SetRenderer(vtkTFCVolumeMapper::CPURenderer);
  const Picture cpu = scene.Render();
  EXPECT_TRUE(scene.Mapper->GetUsedCPU());
  EXPECT_EQ(scene.Mapper->GetLastError(), "");
  brightest = *std::max_element(gpu.Values.begin(), gpu.Values.end());
  return Compare(gpu, cpu);
}

struct Messages
{
  void Add() { ++this->Count; }
  int Count = 0;
};

// Constant attributes, seen along -z with two pixels a voxel: a ray of length L has
// 1 - (1 - opacity)^L.
class CpuFog : public testing::Test
{
protected:
  static constexpr double Opacity = 0.06;

  CpuFog()
    : Scene(64)
    , Image(MakeImage(31, 25, 21))
  {
    this->Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, &this->Errors, &Messages::Add);
    EXPECT_TRUE(this->Scene.Model->SetState(MakeState(MakeFog(Opacity)).c_str()));
    AddField(this->Image, "x", [](double, double, double) { return 0.5; });
    AddField(this->Image, "y", [](double, double, double) { return 0.5; });
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.Mapper->SetRenderer(vtkTFCVolumeMapper::CPURenderer);
    this->Scene.Mapper->SetSampleDistance(0.1);
    this->Scene.LookAlongZ(15.1, 12.1, 10, 32.0);
  }

  int At(const Picture& picture, double x, double y) const
  {
    return picture.At(static_cast<int>(std::floor(32 + 2 * (x - 15.1))),
      static_cast<int>(std::floor(32 + 2 * (y - 12.1))))[0];
  }

  // VTK places whole samples only: a step more or less.
  void ExpectLength(const Picture& picture, double x, double y, double length, double unit = 1.0,
    double tolerance = 3.0)
  {
    EXPECT_NEAR(this->At(picture, x, y), 255 * (1 - std::pow(1 - Opacity, length / unit)),
      tolerance)
      << "at " << x << ", " << y << " for length " << length;
  }

  Messages Errors;
  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

}

TEST(Fallback, GivesThePictureOfOpenGLOnASmoothScene)
{
  VolumeScene scene(Pixels);
  MakeSmoothScene(scene);
  for (const double unit : { 1.5, 0.5 })
  {
    scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(unit);
    double brightest = 0;
    const Difference difference = CompareRenderers(scene, brightest);
    EXPECT_GT(brightest, 80);
    EXPECT_LE(difference.Mean, 2.0) << "unit " << unit;
    std::cout << "unit " << unit << ": mean " << difference.Mean << ", largest "
              << difference.Largest << ", brightest " << brightest << "\n";
  }
}

// Eight linear bits would have less than three steps for the first region.
TEST(Fallback, KeepsLowOpacitiesBesideAnOpaqueRegion)
{
  VolumeScene scene(Pixels);
  MakeSmoothScene(scene, "[0.01, 1.0, 0.01]");
  double brightest = 0;
  const Difference difference = CompareRenderers(scene, brightest);
  EXPECT_GT(brightest, 150);
  EXPECT_LE(difference.Mean, 2.0);
  std::cout << "mean " << difference.Mean << ", largest " << difference.Largest << "\n";

  MakeSmoothScene(scene, "[0.004, 0.003, 0.004]");
  const Difference thin = CompareRenderers(scene, brightest);
  EXPECT_GT(brightest, 5);
  EXPECT_LE(thin.Mean, 1.0);
  std::cout << "thin: mean " << thin.Mean << ", largest " << thin.Largest << ", brightest "
            << brightest << "\n";
}

TEST(Fallback, ClassifiesOnlyWhenTheDataOrTheModelHasChanged)
{
  VolumeScene scene(Pixels);
  MakeSmoothScene(scene);
  scene.Mapper->SetRenderer(vtkTFCVolumeMapper::CPURenderer);
  const Picture first = scene.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfClassifications(), 1);
  EXPECT_EQ(Compare(first, scene.Render()).Largest, 0);
  scene.Renderer->GetActiveCamera()->Azimuth(30);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(3);
  scene.Volume->SetScale(1, 1, 1.5);
  scene.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfClassifications(), 1);
  scene.Model->SetState(MakeState(MakeFog(0.1)).c_str());
  scene.Render();
  scene.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfClassifications(), 2);
  vtkImageData::SafeDownCast(scene.Mapper->GetInputDataObject(0, 0))
    ->GetPointData()
    ->GetArray("x")
    ->Modified();
  scene.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfClassifications(), 3);
}

TEST(Fallback, ShadesAsTheVolumesPropertySays)
{
  VolumeScene scene(Pixels);
  MakeSmoothScene(scene);
  scene.Mapper->SetRenderer(vtkTFCVolumeMapper::CPURenderer);
  const Picture plain = scene.Render();
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->ShadeOn();
  property->SetAmbient(0);
  property->SetSpecular(0);
  property->SetDiffuse(1);
  const Picture lit = scene.Render();
  EXPECT_GT(Compare(plain, lit).Mean, 1);
  property->SetDiffuse(0.5);
  const Picture half = scene.Render();
  double ratio = 0;
  int count = 0;
  for (size_t i = 0; i < lit.Values.size(); ++i)
  {
    if (lit.Values[i] > 60)
    {
      ratio += double(half.Values[i]) / lit.Values[i];
      ++count;
    }
  }
  ASSERT_GT(count, 500);
  EXPECT_NEAR(ratio / count, 0.5, 0.02);
}

TEST(Fallback, IsChosenByWhatTheDriverLacks)
{
  vtkTFCGraphicsSupport support;
  EXPECT_NE(support.FindMissing().find("OpenGL 3.2"), std::string::npos);
  support.HasOpenGL = true;
  EXPECT_NE(support.FindMissing().find("volume rendering"), std::string::npos);
  support.HasVolumes = true;
  support.LongestTextureSide = 32;
  EXPECT_NE(support.FindMissing().find("32 texels"), std::string::npos);
  support.LongestTextureSide = 256;
  support.TextureUnits = 8;
  EXPECT_NE(support.FindMissing().find("8 texture units"), std::string::npos);
  support.TextureUnits = 16;
  EXPECT_EQ(support.FindMissing(), "");

  VolumeScene scene(Pixels);
  MakeSmoothScene(scene);
  scene.Render();
  EXPECT_FALSE(scene.Mapper->GetUsedCPU());
  EXPECT_EQ(vtkTFCGraphicsSupport::Probe(scene.Window, scene.Volume).FindMissing(), "");
}

TEST_F(CpuFog, HasItsOpacityAtAnySampleDistanceAndUnit)
{
  for (const double distance : { 0.0, 0.1, 0.7 })
  {
    this->Scene.Mapper->SetSampleDistance(distance);
    const Picture picture = this->Scene.Render();
    this->ExpectLength(picture, 15, 12, 20, 1.0, 5.0);
    this->ExpectLength(picture, 2, 2, 20, 1.0, 5.0);
    EXPECT_EQ(this->At(picture, -0.6, 12), 0) << "beside the volume";
  }
  for (const double unit : { 0.25, 4.0, 40.0 })
  {
    this->Scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(unit);
    this->ExpectLength(this->Scene.Render(), 15, 12, 20, unit);
  }
}

TEST_F(CpuFog, LengthIsInWorldUnits)
{
  this->Image->SetSpacing(1, 1, 0.5);
  this->ExpectLength(this->Scene.Render(), 15, 12, 10);
  this->Scene.Volume->SetScale(1, 1, 3);
  this->ExpectLength(this->Scene.Render(), 15, 12, 30);
}

TEST_F(CpuFog, DirectionMatrixTurnsTheVolume)
{
  const double direction[9] = { 0, 1, 0, 0, 0, 1, 1, 0, 0 }; // x, y, z along world z, x, y
  this->Image->SetDirectionMatrix(direction);
  const Picture picture = this->Scene.Render();
  this->ExpectLength(picture, 12, 10, 30);
  EXPECT_EQ(this->At(picture, 25, 10), 0);
}

TEST_F(CpuFog, CroppingAndClipping)
{
  this->Image->SetOrigin(0, 0, -2);
  this->Image->SetSpacing(1, 1, 1.2);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 6, 0);
  plane->SetNormal(0, 1, 0);
  this->Scene.Mapper->AddClippingPlane(plane);
  this->Scene.Mapper->SetCropping(1);
  this->Scene.Mapper->SetCroppingRegionPlanes(10.0, 20.0, 0.0, 24.0, 4.0, 12.0);
  this->Scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  const Picture picture = this->Scene.Render();
  this->ExpectLength(picture, 15, 10, 8);
  EXPECT_EQ(this->At(picture, 8.5, 10), 0);
  EXPECT_EQ(this->At(picture, 21.5, 10), 0);
  EXPECT_EQ(this->At(picture, 15, 5), 0);
}

TEST_F(CpuFog, NoDataBlankedAndGhostCellsAreInvisible)
{
  AddField(this->Image, "y",
    [](double x, double, double)
    { return x > 25 ? std::numeric_limits<double>::quiet_NaN() : 0.5; });
  vtkUnsignedCharArray* cells = this->Image->AllocateCellGhostArray();
  for (vtkIdType i = 0; i < this->Image->GetNumberOfCells(); ++i)
  {
    const int x = static_cast<int>(i % 30);
    const int z = static_cast<int>(i / 30 / 24);
    const int flags = (x < 5 ? vtkDataSetAttributes::HIDDENCELL : 0) |
      (z >= 16 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    cells->SetValue(i, static_cast<unsigned char>(flags));
  }
  const Picture picture = this->Scene.Render();
  EXPECT_EQ(this->At(picture, 27, 12), 0);
  EXPECT_EQ(this->At(picture, 2, 12), 0);
  this->ExpectLength(picture, 15, 12, 16);
}

// As a rank has it: an extent that does not begin at 0, with ghost cells in front of it.
TEST_F(CpuFog, AnyExtentWithGhostCellsOnEitherSide)
{
  for (const bool low : { true, false })
  {
    vtkNew<vtkImageData> part;
    part->SetExtent(-15, 15, -12, 12, 30, 50);
    part->SetOrigin(15, 12, -30);
    for (const char* name : { "x", "y" })
    {
      part->GetPointData()->AddArray(this->Image->GetPointData()->GetArray(name));
    }
    vtkUnsignedCharArray* ghosts = part->AllocateCellGhostArray();
    for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i)
    {
      const int z = static_cast<int>(i / 30 / 24);
      ghosts->SetValue(i,
        (low ? z < 7 : z >= 13) ? vtkDataSetAttributes::DUPLICATECELL
                                : static_cast<unsigned char>(0));
    }
    this->Scene.Mapper->SetInputData(part);
    this->ExpectLength(this->Scene.Render(), 15, 12, 13);
  }
}

TEST_F(CpuFog, CellDataAndASingleLayer)
{
  for (const int layers : { 21, 1 })
  {
    vtkNew<vtkImageData> cells;
    cells->SetDimensions(31, 25, layers);
    for (const char* name : { "x", "y" })
    {
      vtkNew<vtkFloatArray> array;
      array->SetName(name);
      array->SetNumberOfTuples(cells->GetNumberOfCells());
      array->Fill(0.5);
      cells->GetCellData()->AddArray(array);
    }
    this->Scene.Mapper->SetInputData(cells);
    this->ExpectLength(this->Scene.Render(), 15, 12, layers == 1 ? 1 : 20);
  }
}

TEST_F(CpuFog, WhatItCannotDoIsAnErrorThatSaysSo)
{
  const auto expect = [this](const std::string& words)
  {
    const Picture picture = this->Scene.Render();
    EXPECT_EQ(*std::max_element(picture.Values.begin(), picture.Values.end()), 0) << words;
    EXPECT_NE(this->Scene.Mapper->GetLastError().find(words), std::string::npos)
      << this->Scene.Mapper->GetLastError();
  };
  this->Scene.Mapper->SetBlendModeToAdditive();
  expect("on the CPU only composite blending");
  this->Scene.Mapper->SetBlendModeToComposite();

  this->Scene.Mapper->SetDistributed(true);
  expect("in one process");
  this->Scene.Mapper->SetDistributed(false);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, this->Image);
  blocks->SetBlock(1, this->Image);
  this->Scene.Mapper->SetInputDataObject(blocks);
  expect("the input has 2");

  this->Scene.Mapper->SetInputDataObject(this->Image);
  const Picture before = this->Scene.Render();
  EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
  std::string state = MakeState(MakeFog(0.5));
  state.replace(state.find("\"y\""), 3, "\"z\"");
  this->Scene.Model->SetState(state.c_str());
  EXPECT_EQ(Compare(before, this->Scene.Render()).Largest, 0) << "the previous model stays";
  EXPECT_NE(this->Scene.Mapper->GetLastError().find("'z'"), std::string::npos)
    << this->Scene.Mapper->GetLastError();
  EXPECT_EQ(this->Errors.Count, 4);
}
