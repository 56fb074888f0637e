// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Light on a block that is opaque from its front face on, whose normal is the gradient of a ramp:
// the brightness of a pixel is a sum of cosines.
#include "Support/VolumeScene.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightKit.h"
#include "vtkMath.h"

#include <gtest/gtest.h>

#include <limits>

using namespace tfctest;

namespace
{

constexpr int Pixels = 64;
constexpr double Front = 16; // z of the face that the camera sees

using Vector = std::array<double, 3>;

Vector Tilted(double degrees)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  return { std::sin(angle), 0, std::cos(angle) };
}

class Lighting : public testing::Test
{
protected:
  Lighting()
    : Scene(Pixels)
    , Image(MakeImage(41, 21, 9))
  {
    std::string opaque = MakeFog(0.99999);
    opaque.replace(opaque.find("[2, 2]"), 6, "[200, 2]");
    EXPECT_TRUE(this->Scene.Model->SetState(MakeState(opaque, "[-100, 100]").c_str()));
    this->Image->SetSpacing(0.5, 1, 2);
    AddField(this->Image, "y", [](double, double, double) { return 0.5; });
    this->AddRamp("x", 0);
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.LookAlongZ(10, 10, 8, 16);
    vtkVolumeProperty* property = this->Scene.Volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(0);
    property->SetDiffuse(1);
    property->SetSpecular(0);
  }

  void AddRamp(const char* name, double degrees)
  {
    const Vector n = Tilted(degrees);
    AddField(this->Image, name,
      [n](double x, double y, double z) { return n[0] * x + n[1] * y + n[2] * z; });
  }

  // Without lights of its own, the renderer makes a headlight.
  double CenterValue() { return this->Scene.Render().At(32, 32)[0]; }

  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Messages
{
  void Add() { ++this->Count; }
  int Count = 0;
};

}

TEST_F(Lighting, ShadingArrayGivesTheNormal)
{
  for (const double degrees : { 0.0, 30.0, 60.0 })
  {
    this->AddRamp("s", degrees);
    this->Scene.Mapper->SetShadingArray("s");
    EXPECT_NEAR(this->CenterValue(), 255 * std::cos(vtkMath::RadiansFromDegrees(degrees)), 2.5);
    this->Scene.Mapper->SetShadingArray("");
    EXPECT_NEAR(this->CenterValue(), 255, 2.5) << "the primary attribute's";
  }
  EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
}

TEST_F(Lighting, ShadeByOpacityTakesTheSurfaceThatTheModelMakes)
{
  // The opacity rises with s, whose gradient is not that of the primary attribute.
  for (const double degrees : { 0.0, 30.0, 60.0 })
  {
    this->AddRamp("s", degrees);
    ASSERT_TRUE(this->Scene.Model->SetState(MakeState(R"({"id": 1, "opacity": 1,
      "shape": {"type": "rectangle", "center": [0.5, 0.5], "halfsize": [200, 2]},
      "falloff": {"type": "constant"}, "tertiary": {"array": "s", "component": 0,
      "opacity": [[-100, 0.9], [100, 1]]}})",
      "[-100, 100]")
                                              .c_str()));
    EXPECT_NEAR(this->CenterValue(), 255, 2.5) << "the primary attribute's";
    this->Scene.Mapper->ShadeByOpacityOn();
    EXPECT_NEAR(this->CenterValue(), 255 * std::cos(vtkMath::RadiansFromDegrees(degrees)), 2.5);
    this->Scene.Mapper->ShadeByOpacityOff();
  }
  EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
}

TEST_F(Lighting, ShadeByOpacityInBlocksAndWithManyAttributes)
{
  const char* names[] = { "x", "y", "s", "t", "u", "v" };
  for (int i = 2; i < 6; ++i)
  {
    this->AddRamp(names[i], 15.0 * i);
  }
  std::string regions;
  for (int i = 0; i < 4; ++i)
  {
    regions += std::string(i ? "," : "") + R"({"id": )" + std::to_string(i + 1) +
      R"(, "opacity": 0.5, "falloff": {"type": "smooth", "width": 1}, "shape": {"type": "ellipse",
      "center": [)" +
      std::to_string(0.49 + 0.01 * i) + R"(, 0.5], "radii": [4, 4]},
      "tertiary": {"array": ")" +
      names[i + 2] + R"(", "component": 0, "opacity": [[-40, 0],
      [40, 1]]}})";
  }
  ASSERT_TRUE(this->Scene.Model->SetState(MakeState(regions, "[-100, 100]").c_str()));
  this->Scene.Mapper->ShadeByOpacityOn();
  const Picture whole = this->Scene.Render();
  EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
  EXPECT_GT(*std::max_element(whole.Values.begin(), whole.Values.end()), 30);
  this->Scene.Mapper->SetLongestTextureSide(16);
  EXPECT_LE(Compare(whole, this->Scene.Render()).Largest, 2);
}

TEST_F(Lighting, ShadingArrayOfSlabsAndOfASingleLayer)
{
  AddField(this->Image, "s",
    [](double x, double y, double z)
    { return std::sin(0.4 * x) + std::cos(0.3 * y) + 0.02 * z * z + 0.1 * x * z; });
  this->Scene.Mapper->SetShadingArray("s");
  const Picture whole = this->Scene.Render();
  this->Scene.Mapper->SetLongestTextureSide(16);
  EXPECT_LE(Compare(whole, this->Scene.Render()).Largest, 3);

  auto flat = MakeImage(21, 21, 1);
  AddField(flat, "x", [](double, double, double) { return 0.5; });
  AddField(flat, "y", [](double, double, double) { return 0.5; });
  AddField(flat, "s", [](double x, double, double) { return x; }); // across the view: dark
  this->Scene.Mapper->SetInputData(flat);
  EXPECT_LE(this->CenterValue(), 3);
  EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
}

TEST_F(Lighting, AShadingArrayThatCannotBeUsedIsReportedOnce)
{
  Messages errors;
  this->Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, &errors, &Messages::Add);
  this->Scene.Mapper->SetShadingArray("missing");
  EXPECT_NEAR(this->CenterValue(), 255, 2.5) << "the primary attribute's";
  this->CenterValue();
  EXPECT_EQ(errors.Count, 1);
  EXPECT_NE(this->Scene.Mapper->GetLastError().find("'missing'"), std::string::npos);

  vtkNew<vtkDoubleArray> cells;
  cells->SetName("cells");
  cells->SetNumberOfTuples(this->Image->GetNumberOfCells());
  cells->Fill(1);
  this->Image->GetCellData()->AddArray(cells);
  this->Scene.Mapper->SetShadingArray("cells");
  EXPECT_NEAR(this->CenterValue(), 255, 2.5);
  EXPECT_NE(this->Scene.Mapper->GetLastError().find("must be a point array"), std::string::npos);

  this->Scene.Mapper->SetShadingArray("x");
  EXPECT_NEAR(this->CenterValue(), 255, 2.5);
  EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
  EXPECT_EQ(errors.Count, 2);
}

TEST_F(Lighting, ShadingArrayIsPackedAgainOnlyWhenItChanges)
{
  this->AddRamp("s", 60);
  this->Scene.Mapper->SetShadingArray("s");
  this->CenterValue();
  const int uploads = this->Scene.Mapper->GetNumberOfVolumeUploads();
  this->AddRamp("s", 0);
  EXPECT_NEAR(this->CenterValue(), 255, 2.5) << "a new array";
  auto* array = vtkDoubleArray::SafeDownCast(this->Image->GetPointData()->GetArray("s"));
  array->Fill(std::numeric_limits<double>::quiet_NaN());
  array->Modified();
  EXPECT_LE(this->CenterValue(), 1) << "no gradient, no diffuse light";
  EXPECT_EQ(this->Scene.Mapper->GetNumberOfVolumeUploads(), uploads) << "attributes stay";
}

TEST_F(Lighting, PositionalLightsAreNearAndHaveACone)
{
  this->Scene.Renderer->SetAutomaticLightCreation(0);
  const Vector place = { 13, 8, Front + 5 };
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(180);
  light->SetPosition(place.data());
  light->SetFocalPoint(place[0], place[1], 0);
  this->Scene.Renderer->AddLight(light);
  const auto expect = [&](double coneCosine)
  {
    const Picture picture = this->Scene.Render();
    for (const int row : { 10, 32, 50 })
    {
      for (const int column : { 8, 32, 44, 60 })
      {
        const Vector toLight = { place[0] - (10 + (column + 0.5 - 32) / 4),
          place[1] - (10 + (row + 0.5 - 32) / 4), place[2] - Front };
        const double cosine = toLight[2] / vtkMath::Norm(toLight.data());
        if (std::abs(cosine - coneCosine) < 0.05)
        {
          continue; // what is seen lies a little behind the face, perhaps across the cone's border
        }
        EXPECT_NEAR(picture.At(column, row)[0], cosine > coneCosine ? 255 * cosine : 0, 5)
          << "pixel " << column << ", " << row;
      }
    }
  };
  expect(-1);
  light->SetConeAngle(40);
  light->SetExponent(0);
  expect(std::cos(vtkMath::RadiansFromDegrees(40.0)));
}

TEST_F(Lighting, LightKitIsTheSumOfItsLights)
{
  this->Scene.Renderer->SetAutomaticLightCreation(0);
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(this->Scene.Renderer);
  for (const double degrees : { 0.0, 40.0 })
  {
    this->AddRamp("s", degrees);
    this->Scene.Mapper->SetShadingArray("s");
    const Picture picture = this->Scene.Render();
    Vector expected = { 0, 0, 0 };
    vtkLightCollection* lights = this->Scene.Renderer->GetLights();
    lights->InitTraversal();
    int count = 0;
    while (vtkLight* light = lights->GetNextItem())
    {
      Vector to;
      double target[3];
      light->GetTransformedPosition(to.data());
      light->GetTransformedFocalPoint(target);
      for (int i = 0; i < 3; ++i)
      {
        to[i] -= target[i];
      }
      vtkMath::Normalize(to.data());
      for (int c = 0; c < 3; ++c)
      {
        // Two-sided, as VTK's lighting is.
        expected[c] +=
          light->GetIntensity() * light->GetDiffuseColor()[c] * std::abs(Dot(to, Tilted(degrees)));
      }
      ++count;
    }
    EXPECT_GE(count, 4);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(picture.At(32, 32)[c], 255 * std::min(1.0, expected[c]), 3) << "channel " << c;
    }
  }
}
