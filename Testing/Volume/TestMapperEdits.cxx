// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// What an edit costs: one upload of tables, no shader program, no volume.
#include "Support/VolumeScene.h"

#include "vtkTFCRegion.h"

#include "vtkPlane.h"
#include "vtk_glew.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

int CountPrograms()
{
  int count = 0;
  for (GLuint name = 1; name < 10000; ++name)
  {
    count += glIsProgram(name) ? 1 : 0;
  }
  return count;
}

std::string Ellipse(double x, const std::string& tertiary = "t", double low = 0.1)
{
  return R"({"id": 1, "shape": {"type": "ellipse", "center": [)" + std::to_string(x) +
    R"(, 0.5], "radii": [0.2, 0.3]}, "opacity": 0.4, "tertiary": {"array": ")" + tertiary +
    R"(", "component": 0, "range": [0, 1], "opacity": [[)" + std::to_string(low) +
    R"(, 0], [1, 1]]}})";
}

const std::string Triangle = R"(, {"id": 2, "opacity": 0.3,
  "shape": {"type": "polygon", "points": [[0.1, 0.1], [0.9, 0.2], [0.5, 0.8]]}})";

class Edits : public testing::Test
{
protected:
  Edits()
    : Scene(100)
    , Image(MakeImage(32, 32, 32))
  {
    AddField(this->Image, "x", [](double x, double, double) { return x / 31; });
    AddField(this->Image, "y", [](double, double y, double) { return y / 31; });
    AddField(this->Image, "t", [](double, double, double z) { return z / 31; });
    AddField(this->Image, "u", [](double x, double, double z) { return (x + z) / 62; });
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.LookAlongZ(15.5, 15.5, 15.5, 40);
  }

  void Set(const std::string& regions)
  {
    ASSERT_TRUE(this->Scene.Model->SetState(MakeState(regions).c_str()))
      << this->Scene.Model->GetLastError();
  }

  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

}

TEST_F(Edits, FiftyEditsBuildNoShaderAndUploadNoVolume)
{
  // Every kind of edit once before counting: what VTK compiles lazily is not ours.
  // First uses of polygons and of tertiary functions build a shader, once.
  this->Set(Ellipse(0.3) + Triangle);
  this->Scene.Render();
  this->Set(Ellipse(0.5));
  Picture previous = this->Scene.Render();
  const int programs = CountPrograms();
  const int tables = this->Scene.Mapper->GetNumberOfTableUploads();
  ASSERT_GT(programs, 0);
  for (int edit = 0; edit < 50; ++edit)
  {
    switch (edit % 5)
    {
      case 0:
        this->Set(Ellipse(0.3 + 0.008 * edit));
        break;
      case 1: // another 1D function
        this->Set(Ellipse(0.3, "t", 0.01 * edit));
        break;
      case 2: // another region, blend and shape
        this->Set(Ellipse(0.3 + 0.005 * edit) + Triangle);
        break;
      case 3:
        this->Scene.Model->GetRegion(0)->SetColor(0.02 * edit, 0.5, 1);
        break;
      default:
        this->Scene.Model->GetRegion(0)->SetVisible(edit % 2 == 0);
        this->Scene.Model->GetRegion(0)->SetOpacity(0.2 + 0.01 * edit);
    }
    const Picture picture = this->Scene.Render();
    EXPECT_GT(Compare(previous, picture).Mean, 0) << "edit " << edit << " changed nothing";
    previous = picture;
  }
  EXPECT_EQ(CountPrograms(), programs);
  EXPECT_EQ(this->Scene.Mapper->GetNumberOfTableUploads(), tables + 50);
  EXPECT_EQ(this->Scene.Mapper->GetNumberOfVolumeUploads(), 1);
}

TEST_F(Edits, PlanesCroppingAndDistancesBuildNoShader)
{
  this->Set(Ellipse(0.5));
  // The first use of cropping that is not a box builds a shader, once.
  this->Scene.Mapper->SetCropping(1);
  this->Scene.Mapper->SetCroppingRegionPlanes(5, 20, 5, 20, 5, 20);
  this->Scene.Mapper->SetCroppingRegionFlagsToFence();
  this->Scene.Render();
  this->Scene.Mapper->SetCropping(0);
  this->Scene.Render();
  const int programs = CountPrograms();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 0, 10);
  this->Scene.Mapper->AddClippingPlane(plane);
  this->Scene.Render();
  plane->SetOrigin(0, 0, 14);
  this->Scene.Render();
  this->Scene.Mapper->SetCropping(1);
  this->Scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  this->Scene.Render();
  this->Scene.Mapper->SetCroppingRegionFlagsToInvertedFence();
  this->Scene.Render();
  this->Scene.Mapper->SetSampleDistance(0.3);
  this->Scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(2);
  this->Scene.Render();
  EXPECT_EQ(CountPrograms(), programs);
}

TEST_F(Edits, SameStateUploadsNothing)
{
  this->Set(Ellipse(0.5));
  this->Scene.Render();
  const int tables = this->Scene.Mapper->GetNumberOfTableUploads();
  this->Set(Ellipse(0.5));
  this->Scene.Render();
  EXPECT_EQ(this->Scene.Mapper->GetNumberOfTableUploads(), tables);
}

TEST_F(Edits, SwitchingBackToAPackedTertiaryUploadsNoVolume)
{
  // Both tertiary attributes are in use, then the first region changes from one to the other.
  const std::string second = R"(, {"id": 2, "opacity": 0.3, "tertiary": {"array": "u",
    "component": 0, "opacity": [[0, 1]]},
    "shape": {"type": "rectangle", "center": [0.5, 0.5], "halfsize": [0.1, 0.1]}})";
  this->Set(Ellipse(0.5, "t") + second);
  this->Scene.Render();
  this->Set(Ellipse(0.5, "u") + second);
  this->Scene.Render();
  this->Set(Ellipse(0.5, "t") + second);
  this->Scene.Render();
  EXPECT_EQ(this->Scene.Mapper->GetNumberOfVolumeUploads(), 1);
}

TEST_F(Edits, ASingleRegionLooksTheSameBeforeAndAfterSeveral)
{
  // At first the shader knows one region only, whose outline may also lie beyond the axes.
  for (const double x : { 0.5, 0.05, 1.3 })
  {
    VolumeScene fresh(100);
    fresh.Mapper->SetInputData(this->Image);
    fresh.LookAlongZ(15.5, 15.5, 15.5, 40);
    ASSERT_TRUE(fresh.Model->SetState(MakeState(Ellipse(x)).c_str()));
    const Picture alone = fresh.Render();
    ASSERT_TRUE(fresh.Model->SetState(MakeState(Ellipse(x) + Triangle).c_str()));
    EXPECT_GT(Compare(alone, fresh.Render()).Mean, 1);
    ASSERT_TRUE(fresh.Model->SetState(MakeState(Ellipse(x)).c_str()));
    EXPECT_LE(Compare(alone, fresh.Render()).Largest, 1) << x;
  }
}

TEST_F(Edits, ChangedDataIsPackedAgain)
{
  this->Set(Ellipse(0.5));
  const Picture before = this->Scene.Render();
  AddField(this->Image, "t", [](double, double, double z) { return 0.5 * z / 31; });
  EXPECT_GT(Compare(before, this->Scene.Render()).Mean, 0);
  EXPECT_EQ(this->Scene.Mapper->GetNumberOfVolumeUploads(), 2);
}

TEST_F(Edits, AThousandRegionsRender)
{
  std::string regions;
  for (int i = 0; i < 1000; ++i)
  {
    const int column = i % 32;
    const int row = i / 32;
    const double x = (column + 0.5) / 32;
    const double y = (row + 0.5) / 32;
    regions += (i ? ", " : "") + std::string(R"({"id": )") + std::to_string(i + 1) +
      R"(, "shape": {"type": "ellipse", "center": [)" + std::to_string(x) + ", " +
      std::to_string(y) + R"(], "radii": [0.02, 0.02]}, "opacity": 1})";
  }
  this->Set(regions);
  const Picture picture = this->Scene.Render();
  EXPECT_GT(picture.At(50, 50)[0], 200);
}
