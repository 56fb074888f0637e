// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// A volume in pieces must look like the whole.
#include "Support/VolumeScene.h"

#include "vtkTFCImageBlocks.h"
#include "vtkTFCRegion.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPointDataToCellData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRectilinearGrid.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

double X(double x, double, double z)
{
  return 0.2 + 0.01 * x + 0.004 * z;
}

double Y(double x, double y, double z)
{
  return 0.3 + 0.012 * y - 0.002 * x + 0.003 * z;
}

double T(double x, double y, double z)
{
  return (x + y + z) / 120;
}

const std::string Regions = R"({"id": 1, "color": [1, 0.5, 0.2], "opacity": 0.06, "shape":
  {"type": "ellipse", "center": [0.5, 0.5], "radii": [0.25, 0.2]}, "tertiary": {"array": "t",
  "component": 0, "range": [0, 1], "opacity": [[0.1, 0.2], [0.5, 1], [0.8, 0.4]]}},
  {"id": 2, "color": [0.2, 0.5, 1], "opacity": 0.05, "shape":
  {"type": "rectangle", "center": [0.3, 0.7], "halfsize": [0.15, 0.2]}})";

//------------------------------------------------------------------------------
// An image over part of a world lattice with the given spacing.
vtkSmartPointer<vtkImageData> MakeBlock(const double bounds[6], double spacing)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  int dimensions[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] =
      1 + static_cast<int>(std::lround((bounds[2 * axis + 1] - bounds[2 * axis]) / spacing));
  }
  image->SetDimensions(dimensions);
  image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  image->SetSpacing(spacing, spacing, spacing);
  AddField(image, "x", X);
  AddField(image, "y", Y);
  AddField(image, "t", T);
  return image;
}

class Blocks : public testing::Test
{
protected:
  Blocks()
    : Scene(160)
    , Whole(MakeBlock(Bounds, 1.0))
  {
    this->SetState("[0, 1]");
    this->Scene.Mapper->SetSampleDistance(0.7);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(100, 80, 120);
    camera->SetFocalPoint(20, 20, 20);
    camera->SetViewUp(0, 1, 0.2);
  }

  void SetState(const std::string& range)
  {
    ASSERT_TRUE(this->Scene.Model->SetState(MakeState(Regions, range, range).c_str()))
      << this->Scene.Model->GetLastError();
  }

  Picture Draw(vtkDataObject* input)
  {
    this->Scene.Mapper->SetInputDataObject(input);
    return this->Scene.Render();
  }

  /// From several sides.
  void ExpectSame(vtkDataObject* a, const std::function<void()>& change, vtkDataObject* b)
  {
    const double places[][3] = { { 100, 80, 120 }, { -60, 30, -40 }, { 20, 20, 150 },
      { 21, -90, 18 } };
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    std::vector<Picture> pictures;
    for (const auto& place : places)
    {
      camera->SetPosition(place);
      pictures.push_back(this->Draw(a));
    }
    change();
    for (int i = 0; i < 4; ++i)
    {
      camera->SetPosition(places[i]);
      const Picture picture = this->Draw(b);
      const Difference difference = Compare(pictures[i], picture);
      EXPECT_LE(difference.Largest, 1) << "view " << i;
      EXPECT_LT(difference.Mean, 0.3) << "view " << i;
      const unsigned char brightest =
        *std::max_element(picture.Values.begin(), picture.Values.end());
      EXPECT_GT(brightest, 30) << "nothing to be seen";
    }
    EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
  }

  static constexpr double Bounds[6] = { 0, 40, 0, 40, 0, 40 };
  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Whole;
};

constexpr double Blocks::Bounds[6];

}

TEST_F(Blocks, AMemoryLimitChangesNothing)
{
  // 41^3 voxels of 16 bytes: 1.05 MiB.
  this->ExpectSame(
    this->Whole, [&] { this->Scene.Mapper->SetMemoryLimit(1); }, this->Whole);
}

TEST_F(Blocks, TexturesOfTwelveVoxelsChangeNothing)
{
  this->ExpectSame(
    this->Whole, [&] { this->Scene.Mapper->SetLongestTextureSide(12); }, this->Whole);
}

TEST_F(Blocks, TexturesOfTwelveVoxelsChangeNoLight)
{
  this->Scene.Volume->GetProperty()->ShadeOn();
  this->ExpectSame(
    this->Whole, [&] { this->Scene.Mapper->SetLongestTextureSide(12); }, this->Whole);
}

TEST_F(Blocks, GeometryInsideAndAWindowWithOtherViewports)
{
  // What is behind the plane must stay hidden, and pixels must stay in their places.
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(5, 10, 22);
  plane->SetPoint1(38, 10, 15);
  plane->SetPoint2(5, 30, 18);
  vtkNew<vtkPolyDataMapper> geometry;
  geometry->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(geometry);
  actor->GetProperty()->SetColor(0.1, 0.6, 0.2);
  actor->GetProperty()->LightingOff();
  this->Scene.Renderer->AddActor(actor);
  this->Scene.Renderer->SetViewport(0.3, 0.2, 1, 0.9);
  this->Scene.Renderer->SetBackground(0.2, 0.1, 0.3);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0, 0, 0.3, 1);
  other->SetBackground(0.3, 0.3, 0);
  this->Scene.Window->AddRenderer(other);
  this->ExpectSame(
    this->Whole, [&] { this->Scene.Mapper->SetLongestTextureSide(12); }, this->Whole);
}

TEST_F(Blocks, DepthPeelingWarns)
{
  // VTK takes the maximum of all that is between two layers of translucent geometry.
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> geometry;
  geometry->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(geometry);
  actor->GetProperty()->SetOpacity(0.5);
  this->Scene.Renderer->AddActor(actor);
  this->Scene.Renderer->UseDepthPeelingOn();
  this->Scene.Renderer->UseDepthPeelingForVolumesOn();
  std::vector<std::string> warnings;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&warnings);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* list, void* text) {
      static_cast<std::vector<std::string>*>(list)->emplace_back(static_cast<const char*>(text));
    });
  this->Scene.Mapper->AddObserver(vtkCommand::WarningEvent, observer);
  this->Draw(this->Whole);
  EXPECT_TRUE(warnings.empty());
  this->Scene.Mapper->SetLongestTextureSide(24);
  this->Draw(this->Whole);
  this->Draw(this->Whole);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("depth peeling"), std::string::npos) << warnings[0];
}

TEST_F(Blocks, CellDataInPieces)
{
  vtkNew<vtkPointDataToCellData> convert;
  convert->SetInputData(this->Whole);
  convert->Update();
  vtkImageData* cells = vtkImageData::SafeDownCast(convert->GetOutput());
  this->ExpectSame(
    cells, [&] { this->Scene.Mapper->SetLongestTextureSide(14); }, cells);
}

TEST_F(Blocks, PartsOfOtherSpacingsAndTheirRanges)
{
  // Attributes are linear, so that any lattice interpolates them alike. The axes have no ranges.
  this->SetState("null");
  vtkNew<vtkMultiBlockDataSet> parts;
  vtkNew<vtkMultiBlockDataSet> upper;
  const double bounds[][6] = { { 0, 40, 0, 16, 0, 40 }, { 0, 20, 16, 40, 0, 40 },
    { 20, 40, 16, 40, 0, 40 } };
  parts->SetBlock(0, MakeBlock(bounds[0], 1.0));
  upper->SetBlock(0, MakeBlock(bounds[1], 2.0));
  upper->SetBlock(1, MakeBlock(bounds[2], 0.5));
  parts->SetBlock(1, upper);
  this->ExpectSame(
    this->Whole, [] {}, parts);
}

TEST_F(Blocks, PartsWithoutAnAttributeAreNotDrawn)
{
  const double bounds[][6] = { { 0, 40, 0, 40, 0, 20 }, { 0, 40, 0, 40, 20, 40 } };
  vtkNew<vtkMultiBlockDataSet> parts;
  auto first = MakeBlock(bounds[0], 1.0);
  auto second = MakeBlock(bounds[1], 1.0);
  second->GetPointData()->RemoveArray("t");
  parts->SetBlock(0, first);
  parts->SetBlock(1, second);
  this->ExpectSame(
    first, [] {}, parts);
  first->GetPointData()->RemoveArray("t");
  this->Draw(parts);
  EXPECT_NE(this->Scene.Mapper->GetLastError().find("'t'"), std::string::npos)
    << this->Scene.Mapper->GetLastError();
}

TEST_F(Blocks, ARectilinearGridIsResampled)
{
  vtkNew<vtkRectilinearGrid> grid;
  vtkNew<vtkFloatArray> coordinates;
  for (const float place : { 0.0F, 1.0F, 3.0F, 8.0F, 9.0F, 20.0F, 21.5F, 30.0F, 40.0F })
  {
    coordinates->InsertNextValue(place);
  }
  grid->SetDimensions(9, 9, 9);
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  double (*const functions[])(double, double, double) = { X, Y, T };
  const char* names[] = { "x", "y", "t" };
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(names[i]);
    for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
    {
      double p[3];
      grid->GetPoint(point, p);
      array->InsertNextValue(functions[i](p[0], p[1], p[2]));
    }
    grid->GetPointData()->AddArray(array);
  }
  this->ExpectSame(
    this->Whole, [] {}, grid);
}

TEST_F(Blocks, AnEditUploadsNoVolume)
{
  this->Scene.Mapper->SetLongestTextureSide(12);
  this->Draw(this->Whole);
  const int volumes = this->Scene.Mapper->GetNumberOfVolumeUploads();
  EXPECT_GT(volumes, 30);
  this->Scene.Model->GetRegion(0)->SetOpacity(0.2);
  this->Draw(this->Whole);
  EXPECT_EQ(this->Scene.Mapper->GetNumberOfVolumeUploads(), volumes);
}

TEST(ImageBlocks, SlabsShareTheMemoryOfTheImage)
{
  auto image = MakeImage(5, 6, 30);
  AddField(image, "x", X);
  vtkTFCImageBlocks blocks;
  vtkTFCImageBlocks::Limits limits;
  limits.MostVoxels = 5 * 6 * 10;
  std::string error;
  const std::vector<vtkTFCAttribute> attributes = { { "x", 0 } };
  const auto list = blocks.Update(image, attributes, limits, error);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(error, "");
  EXPECT_EQ(list[1].Drawn, (std::array<int, 6>{ 0, 4, 0, 5, 9, 19 }));
  EXPECT_EQ(list[1].Image->GetExtent()[4], 8);
  EXPECT_EQ(list[1].Image->GetExtent()[5], 20);
  EXPECT_EQ(list[1].Image->GetPointData()->GetArray("x")->GetVoidPointer(0),
    image->GetPointData()->GetArray("x")->GetVoidPointer(5 * 6 * 8));
  const unsigned int generation = blocks.GetGeneration();
  blocks.Update(image, attributes, limits, error);
  EXPECT_EQ(blocks.GetGeneration(), generation);
  image->GetPointData()->GetArray("x")->Modified();
  blocks.Update(image, attributes, limits, error);
  EXPECT_GT(blocks.GetGeneration(), generation);
}
