// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// A small volume against a compositor on the CPU that steps the same rays in double precision, and
// against itself at half the sample distance.
#include "Support/VolumeScene.h"

#include "vtkTFCClassifier.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

constexpr int Voxels = 64;
constexpr int Size = 96;

vtkSmartPointer<vtkImageData> MakeVolume()
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
  AddField(image, "u", [](double x, double y, double z) { return std::cos(0.1 * (x + y + z)); });
  return image;
}

const std::string Regions = R"(
  {"id": 1, "shape": {"type": "ellipse", "center": [0.3, 0.5], "radii": [0.25, 0.4], "angle": 20},
   "falloff": {"type": "smooth", "width": 0.9}, "color": [0.9, 0.2, 0.1], "opacity": 0.15,
   "tertiary": {"array": "t", "component": 0, "range": [-13, 35],
                "opacity": [[0, 0.1], [10, 1], [30, 0.2]]}},
  {"id": 2, "shape": {"type": "triangle", "points": [[0.4, 0.1], [1.0, 0.5], [0.5, 0.9]]},
   "falloff": {"type": "linear", "width": 0.9}, "color": [0.1, 0.8, 0.3], "opacity": 0.2,
   "tertiary": {"array": "u", "component": 0, "range": [-1, 1],
                "opacity": [[-1, 1], [1, 0]]}},
  {"id": 3, "shape": {"type": "rectangle", "center": [0.6, 0.6], "halfsize": [0.3, 0.3]},
   "falloff": {"type": "gaussian", "width": 0.4}, "color": [0.2, 0.3, 1], "opacity": 0.1})";

// Trilinear interpolation of a point array; position in index space, inside the volume.
double Interpolate(const double* values, const double p[3])
{
  int i[3];
  double f[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    i[axis] = std::clamp(static_cast<int>(p[axis]), 0, Voxels - 2);
    f[axis] = p[axis] - i[axis];
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int d[3] = { corner & 1, (corner >> 1) & 1, corner >> 2 };
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      weight *= d[axis] ? f[axis] : 1 - f[axis];
    }
    sum += weight * values[i[0] + d[0] + Voxels * (i[1] + d[1] + Voxels * (i[2] + d[2]))];
  }
  return sum;
}

// Colour of one ray from `eye` along the unit vector `direction`, on black.
std::array<double, 3> CastRay(const vtkTFCClassifier& classifier, vtkImageData* image,
  const double eye[3], const double direction[3], double step, double unit)
{
  double begin = 0;
  double end = 1e30;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = (0 - eye[axis]) / direction[axis];
    const double b = (Voxels - 1 - eye[axis]) / direction[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  std::array<double, 3> color = { 0, 0, 0 };
  double transparency = 1;
  for (double cut = std::floor(begin / step); cut * step < end; ++cut)
  {
    const double from = std::max(begin, cut * step);
    const double to = std::min(end, (cut + 1) * step);
    double p[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = eye[axis] + 0.5 * (from + to) * direction[axis];
    }
    std::vector<double> values;
    values.reserve(classifier.GetModel().Attributes.size());
    for (const auto& attribute : classifier.GetModel().Attributes)
    {
      auto* array =
        vtkDoubleArray::SafeDownCast(image->GetPointData()->GetArray(attribute.Array.c_str()));
      values.push_back(Interpolate(array->GetPointer(0), p));
    }
    std::vector<const double*> pointers;
    pointers.reserve(values.size());
    for (const double& value : values)
    {
      pointers.push_back(&value);
    }
    std::array<float, 4> rgba;
    classifier.Classify(1, pointers.data(), rgba.data());
    const double alpha = 1 - std::pow(1.0 - rgba[3], std::max(0.0, to - from) / unit);
    for (int c = 0; c < 3; ++c)
    {
      color[c] += transparency * alpha * rgba[c];
    }
    transparency *= 1 - alpha;
  }
  return color;
}

void Frame(VolumeScene& scene)
{
  const double c = 0.5 * (Voxels - 1);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(c, c, c);
  camera->SetPosition(c + 90, c + 60, c + 130);
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(32);
}

}

TEST(Compositor, AgreesWithTheMapperOnEveryRay)
{
  VolumeScene scene(Size);
  ASSERT_TRUE(scene.Model->SetState(MakeState(Regions).c_str())) << scene.Model->GetLastError();
  auto image = MakeVolume();
  scene.Mapper->SetInputData(image);
  scene.Mapper->SetSampleDistance(0.8);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(1.5);
  Frame(scene);
  const Picture picture = scene.Render();

  const vtkTFCClassifier classifier(scene.Model->Compile());
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  double eye[3];
  double forward[3];
  double up[3];
  double right[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(forward);
  camera->OrthogonalizeViewUp();
  camera->GetViewUp(up);
  vtkMath::Cross(forward, up, right);
  const double half = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));

  std::vector<double> differences;
  double brightest = 0;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      const double x = half * (2 * (column + 0.5) / Size - 1);
      const double y = half * (2 * (row + 0.5) / Size - 1);
      double direction[3];
      for (int i = 0; i < 3; ++i)
      {
        direction[i] = forward[i] + x * right[i] + y * up[i];
      }
      vtkMath::Normalize(direction);
      const auto expected = CastRay(classifier, image, eye, direction, 0.8, 1.5);
      for (int c = 0; c < 3; ++c)
      {
        brightest = std::max(brightest, expected[c]);
        differences.push_back(std::abs(255 * expected[c] - picture.At(column, row)[c]));
      }
    }
  }
  EXPECT_GT(brightest, 0.3);
  std::sort(differences.begin(), differences.end());
  double mean = 0;
  for (const double d : differences)
  {
    mean += d / static_cast<double>(differences.size());
  }
  const double percentile = differences[differences.size() * 999 / 1000];
  EXPECT_LE(mean, 0.5);
  EXPECT_LE(percentile, 3.0);
  std::cout << "mean " << mean << ", 99.9th percentile " << percentile << " of 255\n";
}

TEST(Compositor, HalvingTheSampleDistanceChangesNoPixel)
{
  VolumeScene scene(200);
  ASSERT_TRUE(scene.Model->SetState(MakeState(Regions).c_str()));
  auto image = MakeVolume();
  scene.Mapper->SetInputData(image);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(1.5);
  Frame(scene);
  for (const double distance : { 1.0, 0.5, 0.25 })
  {
    scene.Mapper->SetSampleDistance(distance);
    const Picture coarse = scene.Render();
    scene.Mapper->SetSampleDistance(distance / 2);
    const Difference difference = Compare(coarse, scene.Render());
    EXPECT_LE(difference.Largest, 2) << "at sample distance " << distance;
  }
}
