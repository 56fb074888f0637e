// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK's hardware selection finds the volume where something of it can be seen, and the voxel.
#include "Support/VolumeScene.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

constexpr int Pixels = 66;
constexpr int Side = 34; // voxels; 33 cells, two pixels a cell

// A ball that is visible, in the middle of an image that is not.
class Selection : public testing::Test
{
protected:
  Selection()
    : Scene(Pixels)
    , Image(MakeImage(Side, Side, Side))
  {
    EXPECT_TRUE(this->Scene.Model->SetState(MakeState(MakeFog(0.5)).c_str()));
    AddField(this->Image, "x",
      [](double x, double y, double z)
      { return std::hypot(x - Middle, y - Middle, z - Middle) < Radius ? 0.5 : 5.0; });
    AddField(this->Image, "y", [](double, double, double) { return 0.5; });
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.Mapper->SetSampleDistance(0.25);
    this->Scene.LookAlongZ(Middle, Middle, Middle, Side - 1);
  }

  vtkSmartPointer<vtkSelection> Select(int x, int y,
    int association = vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Scene.Renderer);
    selector->SetArea(x, y, x, y);
    selector->SetFieldAssociation(association);
    return vtkSmartPointer<vtkSelection>::Take(selector->Select());
  }

  // Prop that a selection has found, or null.
  static vtkProp* GetProp(vtkSelection* selection)
  {
    return selection->GetNumberOfNodes() == 0
      ? nullptr
      : vtkProp::SafeDownCast(
          selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()));
  }

  static constexpr double Middle = 16.5;
  static constexpr double Radius = 10;
  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

}

TEST_F(Selection, FindsTheVolumeWhereItIsVisible)
{
  const Picture before = this->Scene.Render();
  EXPECT_EQ(GetProp(this->Select(Pixels / 2, Pixels / 2)), this->Scene.Volume);
  EXPECT_EQ(GetProp(this->Select(Pixels / 2 + 14, Pixels / 2)), this->Scene.Volume);
  EXPECT_EQ(GetProp(this->Select(3, 3)), nullptr) << "inside of the box, with nothing to see";
  EXPECT_EQ(Compare(before, this->Scene.Render()).Largest, 0);
}

TEST_F(Selection, FindsTheVoxelAtWhichTheBallBegins)
{
  this->Scene.Render();
  const auto selection = this->Select(Pixels / 2 + 1, Pixels / 2 + 1);
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  ASSERT_TRUE(ids && ids->GetNumberOfTuples() == 1);
  // VTK counts the voxels of a volume from 1 here, as its own mapper does.
  const vtkIdType id = ids->GetValue(0) - 1;
  constexpr int cells = Side - 1;
  EXPECT_NEAR(static_cast<double>(id % cells), Middle, 1.0);
  EXPECT_NEAR(static_cast<double>(id / cells % cells), Middle, 1.0);
  EXPECT_NEAR(static_cast<double>(id / (cells * cells)), Middle + Radius, 1.5);
}

TEST_F(Selection, OfAVolumeInBlocks)
{
  this->Scene.Mapper->SetLongestTextureSide(12);
  const Picture before = this->Scene.Render();
  EXPECT_EQ(GetProp(this->Select(Pixels / 2, Pixels / 2)), this->Scene.Volume);
  EXPECT_EQ(GetProp(this->Select(3, 3)), nullptr);
  EXPECT_EQ(Compare(before, this->Scene.Render()).Largest, 0);
}

TEST_F(Selection, GeometryInFrontIsFoundFirst)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0, 0, 30);
  plane->SetPoint1(Middle, 0, 30);
  plane->SetPoint2(0, 33, 30);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Scene.Renderer->AddActor(actor);
  this->Scene.Render();
  EXPECT_EQ(GetProp(this->Select(Pixels / 2 - 5, Pixels / 2)), actor);
  EXPECT_EQ(GetProp(this->Select(Pixels / 2 + 5, Pixels / 2)), this->Scene.Volume);
}

TEST_F(Selection, OfPointsLeavesTheVolumeOut)
{
  // A volume has no points to select; its colours must not be taken for their numbers.
  this->Scene.Render();
  const auto selection =
    this->Select(Pixels / 2, Pixels / 2, vtkDataObject::FIELD_ASSOCIATION_POINTS);
  EXPECT_EQ(GetProp(selection), nullptr);
}
