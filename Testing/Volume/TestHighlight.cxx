// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// A highlighted region: the others are dimmed by a known factor, and nothing of it stays.
#include "Support/VolumeScene.h"

#include "vtkTFCRegion.h"

#include "vtk_glew.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

constexpr double LENGTH = 10; // world units along the rays
constexpr double OPACITY = 0.2;

std::string Half(int id, double center, const std::string& extra = "")
{
  return R"({"id": )" + std::to_string(id) + R"(, "falloff": {"type": "constant"}, "opacity": )" +
    std::to_string(OPACITY) +
    R"(, "color": [1, 1, 1], "shape": {"type": "rectangle", "center": [)" + std::to_string(center) +
    R"(, 0.5], "halfsize": [0.25, 2]})" + extra + "}";
}

int CountPrograms()
{
  int count = 0;
  for (GLuint name = 1; name < 10000; ++name)
  {
    count += glIsProgram(name) ? 1 : 0;
  }
  return count;
}

// Fog: the left half of the picture is region 1, the right half region 2.
class Highlight : public testing::TestWithParam<int>
{
protected:
  Highlight()
    : Scene(60)
  {
    const auto image = MakeImage(21, 21, static_cast<int>(LENGTH) + 1);
    AddField(image, "x", [](double x, double, double) { return x / 20; });
    AddField(image, "y", [](double, double y, double) { return y / 20; });
    AddField(image, "t", [](double, double, double z) { return z / LENGTH; });
    this->Scene.Mapper->SetInputData(image);
    this->Scene.Mapper->SetRenderer(this->GetParam());
    this->Scene.Mapper->SetSampleDistance(0.25);
    this->Scene.LookAlongZ(10, 10, LENGTH / 2, 24);
    EXPECT_TRUE(
      this->Scene.Model->SetState(MakeState(Half(1, 0.25) + ", " + Half(2, 0.75)).c_str()))
      << this->Scene.Model->GetLastError();
  }

  int Left(const Picture& picture) const { return picture.At(15, 30)[0]; }
  int Right(const Picture& picture) const { return picture.At(45, 30)[0]; }

  VolumeScene Scene;
};

int Fog(double opacity)
{
  return static_cast<int>(std::lround(255 * (1 - std::pow(1 - opacity, LENGTH))));
}

}

TEST_P(Highlight, DimsTheOthersByItsFactorAndLeavesNothingBehind)
{
  const Picture before = this->Scene.Render();
  // The CPU keeps opacities in 8 bits.
  const int tolerance = this->GetParam() == vtkTFCVolumeMapper::CPURenderer ? 6 : 2;
  EXPECT_NEAR(this->Left(before), Fog(OPACITY), tolerance);
  const int programs = CountPrograms();
  const int tables = this->Scene.Mapper->GetNumberOfTableUploads();
  const std::string state = this->Scene.Model->GetState();
  const double dimmed = OPACITY * vtkTFCTransferFunction::HighlightDimming;
  ASSERT_LT(dimmed, OPACITY / 10);

  this->Scene.Model->SetHighlightedRegion(1);
  const Picture left = this->Scene.Render();
  EXPECT_EQ(this->Left(left), this->Left(before));
  EXPECT_NEAR(this->Right(left), Fog(dimmed), tolerance);
  this->Scene.Model->SetHighlightedRegion(2);
  const Picture right = this->Scene.Render();
  EXPECT_NEAR(this->Left(right), Fog(dimmed), tolerance);
  EXPECT_EQ(this->Right(right), this->Right(before));

  EXPECT_EQ(this->Scene.Model->GetState(), state) << "it is a look, no edit";
  this->Scene.Model->SetHighlightedRegion(0);
  EXPECT_EQ(Compare(before, this->Scene.Render()).Largest, 0);
  EXPECT_EQ(CountPrograms(), programs);
  if (this->GetParam() == vtkTFCVolumeMapper::GPURenderer)
  {
    EXPECT_EQ(this->Scene.Mapper->GetNumberOfTableUploads(), tables + 3);
    EXPECT_EQ(this->Scene.Mapper->GetNumberOfVolumeUploads(), 1);
  }
}

TEST_P(Highlight, OfARegionThatIsNotDrawnChangesNothing)
{
  const Picture before = this->Scene.Render();
  this->Scene.Model->SetHighlightedRegion(77);
  EXPECT_EQ(Compare(before, this->Scene.Render()).Largest, 0);
  this->Scene.Model->GetRegion(0)->SetVisible(false);
  this->Scene.Model->SetHighlightedRegion(0);
  const Picture hidden = this->Scene.Render();
  this->Scene.Model->SetHighlightedRegion(1);
  EXPECT_EQ(Compare(hidden, this->Scene.Render()).Largest, 0);
}

TEST_P(Highlight, DimsTertiaryFunctionsAndSurvivesEdits)
{
  const std::string step =
    R"(, "tertiary": {"array": "t", "component": 0, "opacity": [[0, 1], [1, 1]]})";
  ASSERT_TRUE(this->Scene.Model->SetState(
    MakeState(Half(1, 0.25, step) + ", " + Half(2, 0.75, step)).c_str()));
  const Picture before = this->Scene.Render();
  const int tolerance = this->GetParam() == vtkTFCVolumeMapper::CPURenderer ? 6 : 2;
  this->Scene.Model->SetHighlightedRegion(2);
  const Picture dimmed = this->Scene.Render();
  EXPECT_NEAR(this->Left(dimmed), Fog(OPACITY * vtkTFCTransferFunction::HighlightDimming),
    tolerance);
  EXPECT_EQ(this->Right(dimmed), this->Right(before));
  // An edit through the state, as ParaView makes it.
  ASSERT_TRUE(this->Scene.Model->SetState(MakeState(Half(1, 0.25) + ", " + Half(2, 0.75)).c_str()));
  EXPECT_EQ(this->Scene.Model->GetHighlightedRegion(), 2);
  EXPECT_NEAR(this->Left(this->Scene.Render()), this->Left(dimmed), tolerance);
}

INSTANTIATE_TEST_SUITE_P(Renderers, Highlight,
  testing::Values(vtkTFCVolumeMapper::GPURenderer, vtkTFCVolumeMapper::CPURenderer),
  [](const testing::TestParamInfo<int>& info)
  { return info.param == vtkTFCVolumeMapper::GPURenderer ? "GPU" : "CPU"; });
