// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Bad input: a message that says what is wrong, nothing drawn, and a picture again afterwards.
#include "Support/VolumeScene.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>

using namespace tfctest;

namespace
{

class Errors : public testing::Test
{
protected:
  Errors()
    : Scene(40)
    , Image(MakeImage(10, 10, 10))
  {
    // Messages go to GetLastError(), the console would only repeat them.
    this->Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, &this->Quiet, &Errors::Silence::Ignore);
    this->Scene.Model->AddObserver(vtkCommand::ErrorEvent, &this->Quiet, &Errors::Silence::Ignore);
    AddField(this->Image, "x", [](double, double, double) { return 0.5; });
    AddField(this->Image, "y", [](double, double, double) { return 0.5; });
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.LookAlongZ(4.5, 4.5, 4.5, 12);
  }

  struct Silence
  {
    void Ignore() { ++this->Count; }
    int Count = 0;
  };

  void Set(const std::string& state)
  {
    ASSERT_TRUE(this->Scene.Model->SetState(state.c_str())) << this->Scene.Model->GetLastError();
  }

  bool IsVisible() { return this->Scene.Render().At(20, 20)[0] > 0; }

  // Nothing is drawn and every one of `parts` is in the message.
  void ExpectError(const std::vector<std::string>& parts)
  {
    EXPECT_FALSE(this->IsVisible());
    const std::string& error = this->Scene.Mapper->GetLastError();
    for (const std::string& part : parts)
    {
      EXPECT_NE(error.find(part), std::string::npos) << part << " is not in: " << error;
    }
  }

  void ExpectRecovery()
  {
    this->Scene.Mapper->SetInputData(this->Image);
    this->Set(MakeState(MakeFog(0.5)));
    EXPECT_TRUE(this->IsVisible());
    EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
  }

  Silence Quiet;
  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

std::string FogOf(const std::string& tertiary)
{
  std::string fog = MakeFog(0.5);
  fog.pop_back();
  return fog + R"(, "tertiary": {"array": ")" + tertiary +
    R"(", "component": 0, "opacity": [[0, 1]]}})";
}

}

TEST_F(Errors, MissingArrayNamesItAndThoseThereAre)
{
  this->Set(MakeState(FogOf("QVAPOR")));
  this->ExpectError({ "QVAPOR", "x", "y" });
  this->Scene.Render();
  EXPECT_EQ(this->Quiet.Count, 1) << "one message for one cause";
  this->ExpectRecovery();
}

TEST_F(Errors, MissingComponent)
{
  std::string state = MakeState(MakeFog(0.5));
  state.replace(state.find("\"component\": 0"), 14, "\"component\": 2");
  this->Set(state);
  this->ExpectError({ "x", "component" });
  this->ExpectRecovery();
}

TEST_F(Errors, MoreAttributesThanChannels)
{
  for (const char* name : { "a", "b", "c", "d", "e", "f", "g" })
  {
    AddField(this->Image, name, [](double, double, double) { return 0.5; });
  }
  std::string regions;
  int id = 0;
  for (const char* name : { "a", "b", "c", "d", "e", "f", "g" })
  {
    std::string fog = FogOf(name);
    fog.replace(fog.find("\"id\": 1"), 7, "\"id\": " + std::to_string(++id));
    regions += (id > 1 ? ", " : "") + fog;
  }
  this->Set(MakeState(regions));
  this->ExpectError({ "9 attributes", "at most 8" });
  this->ExpectRecovery();
}

TEST_F(Errors, PointAndCellAttributesCannotMix)
{
  vtkNew<vtkFloatArray> cells;
  cells->SetName("cells");
  cells->SetNumberOfTuples(this->Image->GetNumberOfCells());
  cells->Fill(0.5);
  this->Image->GetCellData()->AddArray(cells);
  this->Set(MakeState(FogOf("cells")));
  this->ExpectError({ "cells" });
  this->ExpectRecovery();
}

TEST_F(Errors, AttributeOfAnotherSize)
{
  vtkNew<vtkFloatArray> wrong;
  wrong->SetName("short");
  wrong->SetNumberOfTuples(7);
  wrong->Fill(0.5);
  this->Image->GetPointData()->AddArray(wrong);
  this->Set(MakeState(FogOf("short")));
  this->ExpectError({ "short" });
  this->ExpectRecovery();
}

TEST_F(Errors, BlendModesThatMakeNoSense)
{
  this->Set(MakeState(MakeFog(0.5)));
  this->Scene.Mapper->SetBlendModeToIsoSurface();
  this->ExpectError({ "blend mode" });
  this->Scene.Mapper->SetBlendModeToComposite();
  this->ExpectRecovery();
}

TEST_F(Errors, OnlyImages)
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  mesh->SetPoints(points);
  this->Set(MakeState(MakeFog(0.5)));
  this->Scene.Mapper->SetInputDataObject(mesh);
  this->ExpectError({ "vtkPolyData", "Resample To Image" });
  this->ExpectRecovery();
}

TEST_F(Errors, NothingToDrawIsNoError)
{
  for (const char* state : { "", "no regions", "no data", "NaN" })
  {
    const std::string kind = state;
    if (kind == "no regions")
    {
      this->Set(MakeState(""));
    }
    else if (kind == "no data")
    {
      this->Set(MakeState(MakeFog(0.5)));
      vtkNew<vtkImageData> empty;
      this->Scene.Mapper->SetInputData(empty);
    }
    else if (kind == "NaN")
    {
      AddField(this->Image, "x",
        [](double, double, double) { return std::numeric_limits<double>::quiet_NaN(); });
      this->Scene.Mapper->SetInputData(this->Image);
    }
    EXPECT_FALSE(this->IsVisible()) << kind;
    EXPECT_EQ(this->Scene.Mapper->GetLastError(), "") << kind;
  }
}

TEST_F(Errors, RegionsWithoutAxes)
{
  this->Set(R"({"format": "transfer-function-combination", "version": 1, "regions": [)" +
    MakeFog(0.5) + "]}");
  this->ExpectError({ "axes" });
  this->ExpectRecovery();
}

TEST_F(Errors, AModelThatDoesNotFitTheDataKeepsThePicture)
{
  this->Set(MakeState(MakeFog(0.5)));
  const Picture before = this->Scene.Render();
  this->Set(MakeState(FogOf("QVAPOR")));
  EXPECT_EQ(Compare(before, this->Scene.Render()).Largest, 0);
  EXPECT_NE(this->Scene.Mapper->GetLastError(), "");
  // But not over other data.
  this->Image->GetPointData()->GetArray("x")->Modified();
  this->ExpectError({ "QVAPOR" });
  this->ExpectRecovery();
}

TEST_F(Errors, ABadStateKeepsThePicture)
{
  this->Set(MakeState(MakeFog(0.5)));
  const Picture before = this->Scene.Render();
  EXPECT_FALSE(this->Scene.Model->SetState("{\"format\": 3}"));
  EXPECT_FALSE(this->Scene.Model->SetState(std::string(10 << 20, 'x').c_str()));
  EXPECT_EQ(Compare(before, this->Scene.Render()).Largest, 0);
}
