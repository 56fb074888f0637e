// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// A moving picture is as coarse as the frame rate asks for, and one at rest is not.
#include "Support/VolumeScene.h"

#include "vtkTFCFrameBudget.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

constexpr int Pixels = 64;
constexpr double AtRest = 0.0001;
constexpr double Impossible = 1000.0; // frames per second

// Balls in shells of three voxels, one pixel of shells each two voxels.
class Interaction : public testing::Test
{
protected:
  Interaction()
    : Scene(Pixels)
    , Image(MakeImage(33, 33, 33))
  {
    EXPECT_TRUE(this->Scene.Model->SetState(MakeState(MakeFog(0.06)).c_str()));
    AddField(this->Image, "x",
      [](double x, double y, double z) { return int(x + y + z) / 3 % 2 ? 0.5 : 2.0; });
    AddField(this->Image, "y", [](double, double, double) { return 0.5; });
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.Mapper->SetSampleDistance(0.1);
    this->Scene.LookAlongZ(16, 16, 16, 32);
  }

  Picture Move(double rate)
  {
    this->Scene.Window->SetDesiredUpdateRate(rate);
    Picture picture;
    for (int frame = 0; frame < 4; ++frame)
    {
      picture = this->Scene.Render();
    }
    this->Scene.Window->SetDesiredUpdateRate(AtRest);
    return picture;
  }

  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

}

TEST_F(Interaction, IsCoarserOnlyWhileItLasts)
{
  const Picture still = this->Scene.Render();
  EXPECT_GT(*std::max_element(still.Values.begin(), still.Values.end()), 100);
  EXPECT_GT(Compare(still, this->Move(Impossible)).Mean, 1);
  EXPECT_EQ(Compare(still, this->Scene.Render()).Largest, 0) << "at once, in full";
}

TEST_F(Interaction, HasFewerPixelsAndTheSameOpacity)
{
  AddField(this->Image, "x", [](double, double, double) { return 0.5; });
  this->Image->Modified();
  this->Scene.LookAlongZ(16, 16, 16, 41); // with the border
  const Picture still = this->Scene.Render();
  const Picture moving = this->Move(Impossible);
  for (int y = 16; y < Pixels - 16; ++y)
  {
    for (int x = 16; x < Pixels - 16; ++x)
    {
      ASSERT_NEAR(moving.At(x, y)[0], still.At(x, y)[0], 2) << x << " " << y;
    }
  }
  // The outline runs between pixels of 4 x 4.
  EXPECT_GT(Compare(still, moving).Largest, 20);
}

TEST_F(Interaction, IsFullWhereThereIsTime)
{
  const Picture still = this->Scene.Render();
  // 600 s a frame: more than any machine needs. VTK divides the time by the number of props.
  this->Scene.Renderer->SetAllocatedRenderTime(600);
  this->Scene.Volume->SetAllocatedRenderTime(600, this->Scene.Renderer);
  EXPECT_EQ(Compare(still, this->Move(1.0)).Largest, 0);
}

TEST_F(Interaction, BuildsNoShaderAndUploadsNothing)
{
  this->Scene.Render();
  const vtkMTimeType time = this->Scene.Mapper->GetMTime();
  const int uploads = this->Scene.Mapper->GetNumberOfVolumeUploads();
  this->Move(Impossible);
  this->Scene.Render();
  EXPECT_EQ(this->Scene.Mapper->GetMTime(), time);
  EXPECT_EQ(this->Scene.Mapper->GetNumberOfVolumeUploads(), uploads);
}

TEST_F(Interaction, OfSeveralBlocksIsOneCoarsePicture)
{
  AddField(this->Image, "x", [](double, double, double) { return 0.5; });
  this->Image->Modified();
  const Picture whole = this->Move(Impossible);
  this->Scene.Mapper->SetLongestTextureSide(12);
  const Picture blocks = this->Move(Impossible);
  for (int y = 8; y < Pixels - 8; ++y)
  {
    for (int x = 8; x < Pixels - 8; ++x)
    {
      ASSERT_NEAR(blocks.At(x, y)[0], whole.At(x, y)[0], 12) << x << " " << y;
    }
  }
}

TEST(FrameBudget, IsFullUntilItKnowsBetter)
{
  const auto level = vtkTFCFrameBudget().Choose(1e-6);
  EXPECT_EQ(level.Image, 1);
  EXPECT_EQ(level.Step, 1);
}

TEST(FrameBudget, TakesTheFinestLevelThatIsQuickEnough)
{
  const struct
  {
    double Share; // of the time that a full frame takes
    int Image;
    int Step;
  } cases[] = { { 1.0, 1, 1 }, { 0.5, 2, 1 }, { 0.25, 2, 1 }, { 0.2, 2, 2 }, { 0.1, 3, 2 },
    { 0.05, 4, 2 }, { 0.03, 4, 4 }, { 0.001, 4, 4 } };
  for (const auto& c : cases)
  {
    vtkTFCFrameBudget budget;
    budget.Report({ 1, 1 }, 2.0);
    const auto level = budget.Choose(2.0 * c.Share);
    EXPECT_EQ(level.Image, c.Image) << c.Share;
    EXPECT_EQ(level.Step, c.Step) << c.Share;
  }
}

TEST(FrameBudget, DoesNotFlickerBetweenTwoLevels)
{
  vtkTFCFrameBudget budget;
  budget.Report({ 1, 1 }, 1.0);
  EXPECT_EQ(budget.Choose(0.95).Image, 2);
  budget.Report({ 2, 1 }, 0.25);
  EXPECT_EQ(budget.Choose(1.05).Image, 2) << "a full frame would only just do";
  EXPECT_EQ(budget.Choose(1.5).Image, 1);
}
