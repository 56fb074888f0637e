// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Slice blending: each pixel is the classified colour of the point in the plane behind it.
#include "Support/VolumeScene.h"

#include "vtkTFCClassifier.h"

#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

constexpr int Pixels = 80;

double X(double x, double y, double z)
{
  return 0.1 + 0.01 * x + 0.004 * y + 0.006 * z;
}

double Y(double x, double y, double z)
{
  return 0.3 - 0.002 * x + 0.013 * y + 0.002 * z;
}

double T(double x, double, double z)
{
  return 0.5 * (x + z) / 40;
}

const std::string Regions = R"({"id": 1, "color": [1, 0.5, 0.2], "opacity": 0.9, "shape":
  {"type": "ellipse", "center": [0.5, 0.5], "radii": [0.4, 0.4]}, "falloff": {"type": "smooth",
  "width": 1}, "tertiary": {"array": "t", "component": 0, "opacity": [[0, 0.2], [1, 1]]}},
  {"id": 2, "color": [0.2, 0.5, 1], "opacity": 0.5, "shape": {"type": "ellipse",
  "center": [0.3, 0.7], "radii": [0.4, 0.3]}, "falloff": {"type": "linear", "width": 1}})";

class Slice : public testing::Test
{
protected:
  Slice()
    : Scene(Pixels)
    , Image(MakeImage(41, 41, 41))
  {
    EXPECT_TRUE(this->Scene.Model->SetState(MakeState(Regions).c_str()));
    AddField(this->Image, "x", X);
    AddField(this->Image, "y", Y);
    AddField(this->Image, "t", T);
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.Mapper->SetBlendMode(vtkVolumeMapper::SLICE_BLEND);
    this->Scene.Volume->GetProperty()->SetSliceFunction(this->Plane);
    this->Scene.LookAlongZ(20, 20, 20, 40);
    this->Plane->SetOrigin(20, 20, 20);
    this->Plane->SetNormal(0.3, -0.2, 1);
  }

  // Where the ray of a pixel meets the plane.
  std::array<double, 3> FindPoint(int column, int row)
  {
    const double x = (column + 0.5) * 40 / Pixels;
    const double y = (row + 0.5) * 40 / Pixels;
    const double* o = this->Plane->GetOrigin();
    const double* n = this->Plane->GetNormal();
    return { x, y, o[2] - (n[0] * (x - o[0]) + n[1] * (y - o[1])) / n[2] };
  }

  // Largest difference from the classifier over pixels whose point lies in `bounds`, 0 elsewhere.
  double FindError(const Picture& picture, double zmin, double zmax)
  {
    const vtkTFCClassifier classifier(this->Scene.Model->Compile());
    double worst = 0;
    for (int row = 0; row < Pixels; ++row)
    {
      for (int column = 0; column < Pixels; ++column)
      {
        const auto p = this->FindPoint(column, row);
        const double values[] = { X(p[0], p[1], p[2]), Y(p[0], p[1], p[2]), T(p[0], p[1], p[2]) };
        const double* arrays[] = { &values[0], &values[1], &values[2] };
        float rgba[4];
        classifier.Classify(1, arrays, rgba, nullptr, nullptr);
        if (std::abs(p[2] - zmin) < 0.01 || std::abs(p[2] - zmax) < 0.01)
        {
          continue;
        }
        const bool inside = p[2] > zmin && p[2] < zmax;
        for (int c = 0; c < 3; ++c)
        {
          const double expected = inside ? 255.0 * rgba[c] * rgba[3] : 0.0;
          worst = std::max(worst, std::abs(expected - picture.At(column, row)[c]));
        }
      }
    }
    return worst;
  }

  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkPlane> Plane;
};

}

TEST_F(Slice, ShowsTheClassifiedPlane)
{
  const Picture picture = this->Scene.Render();
  EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
  EXPECT_GT(*std::max_element(picture.Values.begin(), picture.Values.end()), 120);
  EXPECT_LE(this->FindError(picture, 0, 40), 1.0);
  this->Scene.Mapper->EmptySpaceSkippingOff();
  EXPECT_EQ(Compare(picture, this->Scene.Render()).Largest, 0);
}

TEST_F(Slice, EndsAtTheBordersOfTheVolume)
{
  this->Plane->SetNormal(1.5, 0, 1);
  EXPECT_LE(this->FindError(this->Scene.Render(), 0, 40), 1.0);
}

TEST_F(Slice, IsCutByClippingPlanesAndGeometry)
{
  vtkNew<vtkPlane> clip;
  clip->SetOrigin(0, 0, 15);
  clip->SetNormal(0, 0, 1);
  this->Scene.Mapper->AddClippingPlane(clip);
  EXPECT_LE(this->FindError(this->Scene.Render(), 15, 40), 1.0);
}

TEST_F(Slice, DoesNotDependOnSampleDistanceNorUnitNorLight)
{
  const Picture picture = this->Scene.Render();
  this->Scene.Mapper->SetSampleDistance(3);
  this->Scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(7);
  this->Scene.Volume->GetProperty()->ShadeOn();
  EXPECT_LE(Compare(picture, this->Scene.Render()).Largest, 1);
}

TEST_F(Slice, OfSeveralBlocksHasNeitherGapsNorTwins)
{
  const double normals[][3] = { { 0.3, -0.2, 1 }, { 0, 0, 1 }, { 0.02, 0.01, 1 } };
  for (const auto& normal : normals)
  {
    this->Plane->SetNormal(normal);
    for (const double z : { 12.0, 20.0, 20.5 }) // also in the face between two blocks
    {
      this->Plane->SetOrigin(20, 20, z);
      this->Scene.Mapper->SetLongestTextureSide(0);
      const Picture whole = this->Scene.Render();
      for (const int side : { 11, 24 })
      {
        this->Scene.Mapper->SetLongestTextureSide(side);
        EXPECT_LE(Compare(whole, this->Scene.Render()).Largest, 1) << normal[0] << " " << z;
      }
    }
  }
}

TEST_F(Slice, PlaneIsInWorldCoordinates)
{
  const Picture picture = this->Scene.Render();
  vtkNew<vtkTransform> transform;
  transform->Translate(3, 5, 2);
  transform->Scale(1, 1, 0.5);
  this->Scene.Volume->SetUserMatrix(transform->GetMatrix());
  double origin[3] = { 20, 20, 20 };
  transform->TransformPoint(origin, origin);
  this->Plane->SetOrigin(origin);
  this->Plane->SetNormal(0.3, -0.2, 2); // the plane of before: z is half as long
  this->Scene.LookAlongZ(23, 25, 12, 40);
  EXPECT_LE(Compare(picture, this->Scene.Render()).Largest, 1);
}

TEST_F(Slice, WithoutAPlaneIsAnError)
{
  this->Scene.Volume->GetProperty()->SetSliceFunction(nullptr);
  this->Scene.Render();
  EXPECT_NE(this->Scene.Mapper->GetLastError().find("SliceFunction"), std::string::npos);
}
