// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The blend modes against sums along rays on the CPU. Rays run along z, through the centres of
// voxels, with one sample per voxel where the attributes are known exactly.
#include "Support/VolumeScene.h"

#include "vtkTFCClassifier.h"

#include "vtkCommand.h"
#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

constexpr int Side = 24;
constexpr int Depth = 33; // points, so 32 unit lengths

const std::string Regions = R"(
  {"id": 1, "shape": {"type": "ellipse", "center": [0.35, 0.5], "radii": [0.3, 0.5]},
   "falloff": {"type": "smooth", "width": 0.9}, "color": [0.9, 0.2, 0.1], "opacity": 0.25,
   "tertiary": {"array": "t", "component": 0, "range": [0, 1], "opacity": [[0, 0.2], [1, 1]]}},
  {"id": 2, "shape": {"type": "rectangle", "center": [0.7, 0.4], "halfsize": [0.2, 0.3]},
   "falloff": {"type": "linear", "width": 0.8}, "color": [0.1, 0.7, 0.9], "opacity": 0.4})";

vtkSmartPointer<vtkImageData> MakeVolume()
{
  auto image = MakeImage(Side, Side, Depth);
  AddField(image, "x",
    [](double x, double, double z) { return 0.5 + 0.5 * std::sin(0.2 * x + 0.13 * z); });
  AddField(image, "y",
    [](double, double y, double z) { return 0.5 + 0.4 * std::cos(0.15 * y - 0.1 * z); });
  AddField(image, "t", [](double x, double y, double z) { return (x + y + z) / 80; });
  return image;
}

struct Piece
{
  double Length;
  std::array<float, 4> RGBA;
};

// The pieces of the ray from +z at the voxel (i, j), `cuts` a unit length. The camera is far and at
// a whole distance, so cuts are at whole positions.
std::vector<Piece> MakePieces(const vtkTFCClassifier& classifier, vtkImageData* image, int i, int j,
  int cuts)
{
  std::vector<Piece> pieces;
  for (int p = 0; p < (Depth - 1) * cuts; ++p)
  {
    const double z = Depth - 1 - (p + 0.5) / cuts;
    const int k = static_cast<int>(z);
    std::vector<double> values;
    for (const auto& attribute : classifier.GetModel().Attributes)
    {
      vtkDataArray* array = image->GetPointData()->GetArray(attribute.Array.c_str());
      const vtkIdType id = i + Side * (j + static_cast<vtkIdType>(Side) * k);
      values.push_back((k + 1 - z) * array->GetComponent(id, 0) +
        (z - k) * array->GetComponent(id + Side * Side, 0));
    }
    std::vector<const double*> pointers;
    for (const double& value : values)
    {
      pointers.push_back(&value);
    }
    Piece piece = { 1.0 / cuts, {} };
    classifier.Classify(1, pointers.data(), piece.RGBA.data());
    pieces.push_back(piece);
  }
  return pieces;
}

// What vtkTFCVolumeMapper.h says, for a black background.
std::array<double, 3> Blend(int mode, const std::vector<Piece>& pieces, double unit)
{
  std::array<double, 3> color = { 0, 0, 0 };
  double largest = 0;
  double visible = 0;
  double transparency = 1;
  for (const Piece& piece : pieces)
  {
    const double length = piece.Length / unit;
    const double a = piece.RGBA[3];
    const double b = 1 - std::pow(1 - a, length);
    visible += a > 0 ? length : 0;
    for (int c = 0; c < 3; ++c)
    {
      switch (mode)
      {
        case vtkVolumeMapper::COMPOSITE_BLEND:
          color[c] += transparency * b * piece.RGBA[c];
          break;
        case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
          color[c] = a > largest ? a * piece.RGBA[c] : color[c];
          break;
        default:
          color[c] += length * a * piece.RGBA[c];
      }
    }
    largest = std::max(largest, a);
    transparency *= 1 - b;
  }
  for (double& channel : color)
  {
    if (mode == vtkVolumeMapper::AVERAGE_INTENSITY_BLEND)
    {
      channel = visible > 0 ? channel / visible : 0;
    }
    channel = std::min(1.0, channel);
  }
  return color;
}

class Blending : public testing::TestWithParam<int>
{
protected:
  Blending()
    : Scene(4 * Side)
    , Image(MakeVolume())
  {
    EXPECT_TRUE(this->Scene.Model->SetState(MakeState(Regions).c_str()));
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.Mapper->SetBlendMode(GetParam());
    // Four pixels a voxel; the centre of pixel (4 i + 2, 4 j + 2) sees the point (i, j).
    const double center = 0.5 * Side - 0.625;
    this->Scene.LookAlongZ(center, center, 16, Side);
  }

  // Largest difference to the sums, over the rays through points.
  double Compare(double unit, int cuts, double& brightest)
  {
    this->Scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(unit);
    this->Scene.Mapper->SetSampleDistance(1.0 / cuts);
    const Picture picture = this->Scene.Render();
    EXPECT_EQ(this->Scene.Mapper->GetLastError(), "");
    const vtkTFCClassifier classifier(this->Scene.Model->Compile());
    double largest = 0;
    for (int j = 1; j < Side - 1; ++j)
    {
      for (int i = 1; i < Side - 1; ++i)
      {
        const auto expected =
          Blend(GetParam(), MakePieces(classifier, this->Image, i, j, cuts), unit);
        for (int c = 0; c < 3; ++c)
        {
          const double shown = picture.At(4 * i + 2, 4 * j + 2)[c];
          largest = std::max(largest, std::abs(255 * expected[c] - shown));
          brightest = std::max(brightest, shown);
        }
      }
    }
    return largest;
  }

  VolumeScene Scene;
  vtkSmartPointer<vtkImageData> Image;
};

struct Messages
{
  void Add() { ++this->Count; }
  int Count = 0;
};

}

TEST_P(Blending, IsTheSumThatTheHeaderSays)
{
  for (const int cuts : { 1, 2 })
  {
    for (const double unit : { 2.0, 12.0 })
    {
      double brightest = 0;
      const double largest = this->Compare(unit, cuts, brightest);
      EXPECT_LE(largest, 1.5) << cuts << " pieces a voxel, unit " << unit;
      EXPECT_GT(brightest, 10);
    }
  }
}

TEST_P(Blending, DoesNotDependOnTheSampleDistance)
{
  // The largest sample comes near the largest value only with the distance; where two regions are
  // nearly the same there, it may be of either.
  const bool maximum = GetParam() == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND;
  this->Scene.Mapper->SetSampleDistance(maximum ? 0.1 : 0.5);
  const Picture coarse = this->Scene.Render();
  this->Scene.Mapper->SetSampleDistance(maximum ? 0.05 : 0.1);
  const Difference difference = tfctest::Compare(coarse, this->Scene.Render());
  EXPECT_LE(difference.Mean, 0.5);
  EXPECT_LE(difference.Largest, maximum ? 255 : 2);
}

TEST_P(Blending, IsTheSameWithoutEmptySpaceSkipping)
{
  std::string small = Regions;
  small.replace(small.find("[0.3, 0.5]"), 10, "[0.1, 0.1]");
  ASSERT_TRUE(this->Scene.Model->SetState(MakeState(small).c_str()));
  const Picture with = this->Scene.Render();
  this->Scene.Mapper->EmptySpaceSkippingOff();
  EXPECT_EQ(tfctest::Compare(with, this->Scene.Render()).Largest, 0);
}

TEST_P(Blending, BackToCompositeIsAsBefore)
{
  this->Scene.Mapper->SetBlendModeToComposite();
  const Picture before = this->Scene.Render();
  this->Scene.Mapper->SetBlendMode(GetParam());
  const Picture other = this->Scene.Render();
  EXPECT_EQ(tfctest::Compare(before, other).Largest == 0,
    GetParam() == vtkVolumeMapper::COMPOSITE_BLEND);
  this->Scene.Mapper->SetBlendModeToComposite();
  EXPECT_EQ(tfctest::Compare(before, this->Scene.Render()).Largest, 0);
}

TEST_P(Blending, OfSeveralBlocksIsRightOrRefused)
{
  this->Scene.Mapper->SetSampleDistance(0.5);
  const Picture whole = this->Scene.Render();
  Messages errors;
  this->Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, &errors, &Messages::Add);
  this->Scene.Mapper->SetLongestTextureSide(20);
  const Picture blocks = this->Scene.Render();
  if (GetParam() == vtkVolumeMapper::COMPOSITE_BLEND)
  {
    EXPECT_LE(tfctest::Compare(whole, blocks).Largest, 4); // half a step a block
    EXPECT_EQ(errors.Count, 0);
    return;
  }
  this->Scene.Render();
  EXPECT_EQ(errors.Count, 1);
  EXPECT_EQ(*std::max_element(blocks.Values.begin(), blocks.Values.end()), 0);
  EXPECT_NE(this->Scene.Mapper->GetLastError().find("blocks"), std::string::npos);
  this->Scene.Mapper->SetLongestTextureSide(0);
  this->Scene.Mapper->SetDistributed(true);
  this->Scene.Render();
  EXPECT_NE(this->Scene.Mapper->GetLastError().find("one process"), std::string::npos);
  this->Scene.Mapper->SetDistributed(false);
  EXPECT_EQ(tfctest::Compare(whole, this->Scene.Render()).Largest, 0);
}

INSTANTIATE_TEST_SUITE_P(Modes, Blending,
  testing::Values(vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
    vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND));

TEST(BlendingErrors, ModesOfOneScalarAndScatteringAreRefused)
{
  VolumeScene scene(48);
  ASSERT_TRUE(scene.Model->SetState(MakeState(Regions).c_str()));
  scene.Mapper->SetInputData(MakeVolume());
  scene.LookAlongZ(11.5, 11.5, 16, Side);
  const Picture plain = scene.Render();
  Messages errors;
  Messages warnings;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, &errors, &Messages::Add);
  scene.Mapper->AddObserver(vtkCommand::WarningEvent, &warnings, &Messages::Add);
  for (const int mode :
    { vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND })
  {
    scene.Mapper->SetBlendMode(mode);
    const Picture picture = scene.Render();
    EXPECT_EQ(*std::max_element(picture.Values.begin(), picture.Values.end()), 0);
    EXPECT_NE(scene.Mapper->GetLastError().find("composite, maximum, average, additive or slice"),
      std::string::npos);
  }
  EXPECT_EQ(errors.Count, 1) << "the same cause";
  scene.Mapper->SetBlendModeToComposite();
  EXPECT_EQ(Compare(plain, scene.Render()).Largest, 0);

  scene.Mapper->SetVolumetricScatteringBlending(0.5);
  EXPECT_EQ(Compare(plain, scene.Render()).Largest, 0) << "drawn without";
  scene.Render();
  EXPECT_EQ(warnings.Count, 1);
  EXPECT_EQ(errors.Count, 1);
}
