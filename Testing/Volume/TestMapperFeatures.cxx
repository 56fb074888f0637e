// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// What the mapper does besides classifying, measured with fog: a region that covers everything with
// one opacity a, so that a ray that sees a length L must have 1 - (1 - a)^(L / unit) in every
// pixel.
#include "Support/VolumeScene.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCollection.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>

using namespace tfctest;

namespace
{

constexpr double Opacity = 0.06;
constexpr int Pixels = 64;

double FogValue(double length, double unit = 1.0)
{
  return 255 * (1 - std::pow(1 - Opacity, length / unit));
}

// A 31 x 25 x 21 voxel image with constant attributes, seen along -z with two pixels a voxel.
class Fog : public testing::Test
{
protected:
  Fog()
    : Scene(Pixels)
    , Image(MakeImage(31, 25, 21))
  {
    EXPECT_TRUE(this->Scene.Model->SetState(MakeState(MakeFog(Opacity)).c_str()));
    AddField(this->Image, "x", [](double, double, double) { return 0.5; });
    AddField(this->Image, "y", [](double, double, double) { return 0.5; });
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.Mapper->SetSampleDistance(0.7);
    this->Scene.LookAlongZ(15.1, 12.1, 10, Pixels / 2.0);
  }

  // Red value of the pixel that sees (x, y).
  double At(const Picture& picture, double x, double y) const
  {
    const int column = static_cast<int>(std::floor(Pixels / 2.0 + 2 * (x - 15.1)));
    const int row = static_cast<int>(std::floor(Pixels / 2.0 + 2 * (y - 12.1)));
    return picture.At(column, row)[0];
  }

  void ExpectLength(const Picture& picture, double x, double y, double length, double unit = 1.0)
  {
    EXPECT_NEAR(this->At(picture, x, y), FogValue(length, unit), 1.01)
      << "at " << x << ", " << y << " for length " << length;
  }

  // A plane across the volume at height z, for x up to 15.
  void AddBlackPlane(double z, double opacity)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-50, -50, z);
    plane->SetPoint1(15, -50, z);
    plane->SetPoint2(-50, 80, z);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0, 0, 0);
    actor->GetProperty()->SetOpacity(opacity);
    actor->GetProperty()->LightingOff();
    this->Scene.Renderer->AddActor(actor);
  }

  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

}

TEST_F(Fog, HasItsOpacityAtAnySampleDistance)
{
  for (const double distance : { 0.0, 0.1, 0.7, 1.0, 3.0, 50.0 })
  {
    this->Scene.Mapper->SetSampleDistance(distance);
    const Picture picture = this->Scene.Render();
    for (const double x : { 1.0, 15.0, 29.0 })
    {
      this->ExpectLength(picture, x, 1, 20);
      this->ExpectLength(picture, x, 23, 20);
    }
    EXPECT_EQ(this->At(picture, -0.6, 12), 0) << "beside the volume";
  }
}

TEST_F(Fog, OpacityIsPerUnitDistance)
{
  this->Scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(4.0);
  this->ExpectLength(this->Scene.Render(), 15, 12, 20, 4.0);
}

TEST_F(Fog, LengthIsInWorldUnitsWhenTheVolumeIsScaled)
{
  this->Scene.Volume->SetScale(1, 1, 2.5);
  this->ExpectLength(this->Scene.Render(), 15, 12, 50);
}

TEST_F(Fog, AnisotropicSpacing)
{
  this->Image->SetSpacing(1, 1, 0.25);
  this->ExpectLength(this->Scene.Render(), 15, 12, 5);
}

TEST_F(Fog, OpaqueGeometryHidesWhatIsBehind)
{
  this->AddBlackPlane(7.3, 1.0);
  const Picture picture = this->Scene.Render();
  this->ExpectLength(picture, 5, 12, 20 - 7.3);
  this->ExpectLength(picture, 25, 12, 20);
}

TEST_F(Fog, DepthPeelingOfVolumesKeepsTheLength)
{
  this->AddBlackPlane(7.3, 0.5);
  this->Scene.Window->SetAlphaBitPlanes(1);
  this->Scene.Renderer->SetUseDepthPeeling(1);
  this->Scene.Renderer->SetUseDepthPeelingForVolumes(true);
  this->Scene.Renderer->SetMaximumNumberOfPeels(10);
  this->Scene.Renderer->SetOcclusionRatio(0);
  const Picture picture = this->Scene.Render();
  this->ExpectLength(picture, 25, 12, 20);
  const double front = FogValue(20 - 7.3);
  const double expected = front + (255 - front) / 255 * 0.5 * FogValue(7.3);
  EXPECT_NEAR(this->At(picture, 5, 12), expected, 2.5);
}

TEST_F(Fog, ClippingPlanesCutExactly)
{
  vtkNew<vtkPlane> across;
  across->SetOrigin(0, 0, 3.3);
  across->SetNormal(0, 0, 1);
  vtkNew<vtkPlane> oblique; // keeps z < 18 - x / 10
  oblique->SetOrigin(0, 0, 18);
  oblique->SetNormal(-0.1, 0, -1);
  vtkNew<vtkPlane> aside;
  aside->SetOrigin(0, 8.0, 0);
  aside->SetNormal(0, 1, 0);
  for (vtkPlane* plane : { across.Get(), oblique.Get(), aside.Get() })
  {
    this->Scene.Mapper->AddClippingPlane(plane);
  }
  const Picture picture = this->Scene.Render();
  for (const double x : { 2.35, 15.35, 28.35 }) // centres of pixels
  {
    this->ExpectLength(picture, x, 12, 18 - x / 10 - 3.3);
  }
  EXPECT_EQ(this->At(picture, 15, 7), 0);
}

TEST_F(Fog, CroppingToABoxCutsExactly)
{
  this->Scene.Mapper->SetCropping(1);
  this->Scene.Mapper->SetCroppingRegionPlanes(10.0, 20.0, 5.0, 15.0, 4.2, 11.9);
  this->Scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  const Picture picture = this->Scene.Render();
  this->ExpectLength(picture, 15, 10, 11.9 - 4.2);
  EXPECT_EQ(this->At(picture, 9, 10), 0);
  EXPECT_EQ(this->At(picture, 21, 10), 0);
  EXPECT_EQ(this->At(picture, 15, 16), 0);
}

TEST_F(Fog, EachOfThe27CroppingRegionsShowsItsPart)
{
  const double planes[3][4] = { { 0, 10, 20, 30 }, { 0, 8, 16, 24 }, { 0, 6, 13, 20 } };
  this->Scene.Mapper->SetCropping(1);
  this->Scene.Mapper->SetSampleDistance(0.02);
  this->Scene.Mapper->SetCroppingRegionPlanes(10, 20, 8, 16, 6, 13);
  for (int region = 0; region < 27; ++region)
  {
    this->Scene.Mapper->SetCroppingRegionFlags(1 << region);
    const Picture picture = this->Scene.Render();
    const int own[3] = { region % 3, region / 3 % 3, region / 9 };
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        const bool visible = i == own[0] && j == own[1];
        this->ExpectLength(picture, 0.5 * (planes[0][i] + planes[0][i + 1]),
          0.5 * (planes[1][j] + planes[1][j + 1]),
          visible ? planes[2][own[2] + 1] - planes[2][own[2]] : 0.0);
      }
    }
  }
}

TEST_F(Fog, CellDataFillsTheCells)
{
  vtkNew<vtkImageData> cells;
  cells->SetDimensions(31, 25, 21);
  for (const char* name : { "x", "y" })
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(cells->GetNumberOfCells());
    array->Fill(0.5);
    cells->GetCellData()->AddArray(array);
  }
  this->Scene.Mapper->SetInputData(cells);
  const Picture picture = this->Scene.Render();
  this->ExpectLength(picture, 1, 1, 20);
  this->ExpectLength(picture, 29, 23, 20);
  EXPECT_EQ(this->At(picture, -0.6, 12), 0);
}

TEST_F(Fog, NoDataIsInvisible)
{
  AddField(this->Image, "y",
    [](double x, double, double z)
    { return x > 20 || z > 15 ? std::numeric_limits<double>::quiet_NaN() : 0.5; });
  this->Scene.Mapper->SetSampleDistance(0.05); // where data ends is not known to the ray
  const Picture picture = this->Scene.Render();
  EXPECT_EQ(this->At(picture, 25, 12), 0);
  this->ExpectLength(picture, 10, 12, 15); // interpolation with a NaN is NaN
}

TEST_F(Fog, BlankedPointsAndCellsAreInvisible)
{
  vtkUnsignedCharArray* points = this->Image->AllocatePointGhostArray();
  for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    this->Image->GetPoint(i, p);
    points->SetValue(i, p[0] > 20 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  Picture picture = this->Scene.Render();
  EXPECT_EQ(this->At(picture, 25, 12), 0);
  this->ExpectLength(picture, 10, 12, 20);

  this->Image->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  vtkUnsignedCharArray* cells = this->Image->AllocateCellGhostArray();
  for (vtkIdType i = 0; i < this->Image->GetNumberOfCells(); ++i)
  {
    cells->SetValue(i, i % 30 < 10 ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  picture = this->Scene.Render();
  EXPECT_EQ(this->At(picture, 5, 12), 0);
  this->ExpectLength(picture, 25, 12, 20);
}

TEST_F(Fog, AFlatImageIsOneVoxelThick)
{
  auto flat = MakeImage(31, 25, 1);
  flat->SetSpacing(1, 1, 3);
  AddField(flat, "x", [](double, double, double) { return 0.5; });
  AddField(flat, "y", [](double, double, double) { return 0.5; });
  this->Scene.Mapper->SetInputData(flat);
  this->ExpectLength(this->Scene.Render(), 15, 12, 3);
  double bounds[6];
  this->Scene.Mapper->GetBounds(bounds);
  EXPECT_DOUBLE_EQ(bounds[4], -1.5);
  EXPECT_DOUBLE_EQ(bounds[5], 1.5);
}

TEST_F(Fog, GhostCellsAreNotDrawn)
{
  vtkUnsignedCharArray* ghosts = this->Image->AllocateCellGhostArray();
  vtkIdType cell = 0;
  for (int k = 0; k < 20; ++k)
  {
    for (int j = 0; j < 24; ++j)
    {
      for (int i = 0; i < 30; ++i, ++cell)
      {
        ghosts->SetValue(cell,
          k >= 17 || i < 2 ? vtkDataSetAttributes::DUPLICATECELL : static_cast<unsigned char>(0));
      }
    }
  }
  const Picture picture = this->Scene.Render();
  this->ExpectLength(picture, 15, 12, 17);
  EXPECT_EQ(this->At(picture, 1.2, 12), 0);
}

TEST_F(Fog, DirectionMatrixTurnsTheVolume)
{
  // Index axes x, y, z along world z, x, y.
  const double direction[9] = { 0, 1, 0, 0, 0, 1, 1, 0, 0 };
  this->Image->SetDirectionMatrix(direction);
  const Picture picture = this->Scene.Render();
  this->ExpectLength(picture, 12, 10, 30);
  EXPECT_EQ(this->At(picture, 25, 10), 0);
}

TEST_F(Fog, TwoBlocksThatShareAFaceAreSeamless)
{
  this->Scene.Mapper->SetSampleDistance(3.0);
  const Picture whole = this->Scene.Render();
  const int split = 9;
  this->Scene.Renderer->RemoveVolume(this->Scene.Volume);
  std::vector<vtkSmartPointer<vtkVolume>> volumes;
  for (const int part : { 0, 1 }) // back to front for a camera on +z
  {
    auto piece = vtkSmartPointer<vtkImageData>::New();
    piece->DeepCopy(this->Image);
    const int extent[6] = { 0, 30, 0, 24, part ? split : 0, part ? 20 : split };
    piece->Crop(extent);
    vtkNew<vtkTFCVolumeMapper> mapper;
    mapper->SetInputData(piece);
    mapper->SetTransferFunction(this->Scene.Model);
    mapper->SetSampleDistance(3.0);
    auto volume = vtkSmartPointer<vtkVolume>::New();
    volume->SetMapper(mapper);
    volumes.push_back(volume);
    this->Scene.Renderer->AddVolume(volume);
  }
  EXPECT_LE(Compare(whole, this->Scene.Render()).Largest, 1);
}

TEST_F(Fog, JitteringMovesTheSamplesAndKeepsTheOpacity)
{
  this->Scene.Mapper->SetSampleDistance(3);
  this->Scene.Mapper->UseJitteringOn();
  this->ExpectLength(this->Scene.Render(), 15, 12, 20);

  // A ball that coarse samples see in rings: noise now, as bright in the mean.
  AddField(this->Image, "x",
    [](double x, double y, double z)
    { return (std::hypot(x - 15, y - 12, z - 10) < 9) ? 0.5 : 5.0; });
  const Picture noisy = this->Scene.Render();
  this->Scene.Mapper->UseJitteringOff();
  const Picture rings = this->Scene.Render();
  EXPECT_GT(Compare(noisy, rings).Largest, 8);
  const auto mean = [](const Picture& picture)
  {
    double sum = 0;
    for (const unsigned char value : picture.Values)
    {
      sum += value;
    }
    return sum / static_cast<double>(picture.Values.size());
  };
  EXPECT_NEAR(mean(noisy), mean(rings), 0.03 * mean(rings));
  this->Scene.Mapper->SetSampleDistance(0.02);
  EXPECT_NEAR(mean(noisy), mean(this->Scene.Render()), 0.03 * mean(rings));
}

TEST(ScalarTypes, AllGiveThePictureOfDouble)
{
  VolumeScene scene(Pixels);
  ASSERT_TRUE(scene.Model->SetState(MakeState(
    R"({"id": 1, "shape": {"type": "ellipse", "center": [40, 50], "radii": [30, 40]},
        "falloff": {"type": "smooth", "width": 1}, "opacity": 0.2,
        "tertiary": {"array": "y", "component": 0, "range": [0, 100],
                     "opacity": [[10, 0], [90, 1]]}})",
    "[0, 100]", "[0, 100]")
                                      .c_str()));
  auto image = MakeImage(24, 24, 24);
  AddField(image, "x", [](double x, double y, double) { return std::floor(2.2 * (x + y)); });
  AddField(image, "y", [](double x, double, double z) { return std::floor(2.1 * (z + x)); });
  scene.Mapper->SetInputData(image);
  scene.LookAlongZ(11.5, 11.5, 11.5, 30);
  const Picture reference = scene.Render();
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT })
  {
    auto other = MakeImage(24, 24, 24);
    for (const char* name : { "x", "y" })
    {
      auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
      array->DeepCopy(image->GetPointData()->GetArray(name));
      array->SetName(name);
      other->GetPointData()->AddArray(array);
    }
    scene.Mapper->SetInputData(other);
    EXPECT_LE(Compare(reference, scene.Render()).Largest, 1) << vtkImageScalarTypeNameMacro(type);
  }
}

// A ramp along a direction in data coordinates: a surface everywhere, with that normal. Its
// brightness is the cosine between normal and light, whatever the block's proportions and spacing.
class Shading : public testing::TestWithParam<bool>
{
};

TEST_P(Shading, IsTheCosineBetweenGradientAndLight)
{
  const bool severalLights = GetParam();
  for (const double degrees : { 0.0, 30.0, 60.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    VolumeScene scene(Pixels);
    std::string fog = MakeFog(0.5);
    fog.replace(fog.find("[2, 2]"), 6, "[200, 2]");
    ASSERT_TRUE(scene.Model->SetState(MakeState(fog, "[-100, 100]").c_str()));
    auto image = MakeImage(41, 21, 9);
    image->SetSpacing(0.5, 1, 2);
    AddField(image, "x",
      [=](double x, double, double z) { return std::sin(angle) * x + std::cos(angle) * z; });
    AddField(image, "y", [](double, double, double) { return 0.5; });
    scene.Mapper->SetInputData(image);
    scene.LookAlongZ(10, 10, 8, 16);
    scene.Volume->GetProperty()->ShadeOn();
    scene.Volume->GetProperty()->SetAmbient(0);
    scene.Volume->GetProperty()->SetDiffuse(1);
    scene.Volume->GetProperty()->SetSpecular(0);
    if (severalLights)
    {
      scene.Renderer->SetAutomaticLightCreation(0);
      for (const double intensity : { 0.25, 0.75 })
      {
        vtkNew<vtkLight> light;
        light->SetLightTypeToHeadlight();
        light->SetIntensity(intensity);
        scene.Renderer->AddLight(light);
      }
    }
    const Picture picture = scene.Render();
    const double alpha = 1 - std::pow(0.5, 16.0);
    EXPECT_NEAR(picture.At(32, 32)[0], 255 * alpha * std::cos(angle), 2.5) << degrees;
  }
}

INSTANTIATE_TEST_SUITE_P(HeadlightAndSeveral, Shading, testing::Bool());
