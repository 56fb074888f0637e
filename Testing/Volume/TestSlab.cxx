// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// A one-voxel-thick slab under parallel projection is the shader's classification made visible:
// every pixel must be within 1/255 of the CPU reference, for every shape, fall-off, blend and kind
// of tertiary function.
#include "Support/VolumeScene.h"

#include "vtkTFCClassifier.h"

#include <gtest/gtest.h>

using namespace tfctest;

namespace
{

constexpr int Size = 160;   // pixels, one voxel each
constexpr int Voxels = 180; // the slab sticks out of the window on all sides

double AxisOf(double world)
{
  return world / (Voxels - 1);
}

double TertiaryOf(double worldX, double worldY)
{
  return (worldX + 2 * worldY) / (3 * (Voxels - 1));
}

// Attribute "u0" to "u5" at a place.
double FurtherOf(int number, double worldX, double worldY)
{
  return ((number + 1) * worldX + (6 - number) * worldY) / (7 * (Voxels - 1));
}

// What the pixel at (column, row) must be; `scale` is the size of a pixel in world units.
std::array<float, 4> Reference(const vtkTFCClassifier& classifier, double column, double row,
  double scale)
{
  const double middle = 0.5 * (Voxels - 1);
  const double worldX = middle + scale * (column + 0.5 - 0.5 * Size);
  const double worldY = middle + scale * (row + 0.5 - 0.5 * Size);
  double values[9] = { AxisOf(worldX), AxisOf(worldY), TertiaryOf(worldX, worldY) };
  for (int i = 0; i < 6; ++i)
  {
    values[3 + i] = FurtherOf(i, worldX, worldY);
  }
  std::vector<const double*> attributes;
  for (const auto& attribute : classifier.GetModel().Attributes)
  {
    const std::string& name = attribute.Array;
    attributes.push_back(&values[name == "x" ? 0
        : name == "y"                        ? 1
        : name == "t"                        ? 2
                                             : 3 + std::stoi(name.substr(1))]);
  }
  std::array<float, 4> rgba;
  classifier.Classify(1, attributes.data(), rgba.data());
  return rgba;
}

// Where the classification jumps within two thousandths of a pixel, single and double precision may
// fall on different sides.
bool IsAtJump(const vtkTFCClassifier& classifier, int column, int row, double scale)
{
  const auto here = Reference(classifier, column, row, scale);
  constexpr double reach = 2e-3;
  const double steps[4][2] = { { reach, 0 }, { -reach, 0 }, { 0, reach }, { 0, -reach } };
  for (const auto& step : steps)
  {
    const auto there = Reference(classifier, column + step[0], row + step[1], scale);
    for (int c = 0; c < 4; ++c)
    {
      if (std::abs(here[c] - there[c]) > 0.5 / 255)
      {
        return true;
      }
    }
  }
  return false;
}

void ExpectSlabMatches(const std::string& state, double scale = 1.0)
{
  VolumeScene scene(Size);
  ASSERT_TRUE(scene.Model->SetState(state.c_str())) << scene.Model->GetLastError();
  auto image = MakeImage(Voxels, Voxels, 1);
  AddField(image, "x", [](double x, double, double) { return AxisOf(x); });
  AddField(image, "y", [](double, double y, double) { return AxisOf(y); });
  AddField(image, "t", [](double x, double y, double) { return TertiaryOf(x, y); });
  for (int i = 0; i < 6; ++i)
  {
    AddField(image, ("u" + std::to_string(i)).c_str(),
      [i](double x, double y, double) { return FurtherOf(i, x, y); });
  }
  scene.Mapper->SetInputData(image);
  const double middle = 0.5 * (Voxels - 1);
  scene.LookAlongZ(middle, middle, 0, Size * scale);
  const Picture picture = scene.Render();

  const vtkTFCClassifier classifier(scene.Model->Compile());
  double largest = 0;
  int skipped = 0;
  int visible = 0;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      if (IsAtJump(classifier, column, row, scale))
      {
        ++skipped;
        continue;
      }
      const auto rgba = Reference(classifier, column, row, scale);
      for (int c = 0; c < 3; ++c)
      {
        const double expected = 255.0 * rgba[c] * rgba[3];
        visible += expected > 1.0 ? 1 : 0;
        const double difference = std::abs(expected - picture.At(column, row)[c]);
        EXPECT_LE(difference, 1.0) << "pixel " << column << ", " << row << " channel " << c;
        largest = std::max(largest, difference);
      }
    }
  }
  EXPECT_GT(visible, 500) << "nothing to compare: " << state;
  EXPECT_LT(skipped, Size * Size / 20);
  std::cout << "largest difference " << largest << " of 255, " << skipped << " pixels at jumps\n";
}

const std::vector<std::string> Shapes = {
  R"({"type": "ellipse", "center": [0.45, 0.55], "radii": [0.3, 0.2], "angle": 25})",
  R"({"type": "rectangle", "center": [0.5, 0.45], "halfsize": [0.3, 0.15], "angle": -40})",
  R"({"type": "triangle", "points": [[0.15, 0.2], [0.85, 0.35], [0.4, 0.9]]})",
  R"({"type": "polygon", "points": [[0.2, 0.2], [0.8, 0.25], [0.55, 0.5], [0.85, 0.8], [0.3, 0.85],
      [0.4, 0.5]]})",
  // A pentagram: the middle is outside by the even-odd rule.
  R"({"type": "polygon", "points": [[0.5, 0.95], [0.23, 0.13], [0.94, 0.64], [0.06, 0.64],
      [0.77, 0.13]]})",
};

std::string MakeRegion(int id, const std::string& shape, const std::string& falloff,
  const std::string& color, double opacity, const std::string& tertiary = "null")
{
  return R"({"id": )" + std::to_string(id) + R"(, "shape": )" + shape + R"(, "falloff": )" +
    falloff + R"(, "color": )" + color + R"(, "opacity": )" + std::to_string(opacity) +
    R"(, "tertiary": )" + tertiary + "}";
}

}

class SlabShapes : public testing::TestWithParam<std::tuple<size_t, const char*>>
{
};

TEST_P(SlabShapes, MatchTheReference)
{
  const auto [shape, falloff] = GetParam();
  const std::string type = falloff;
  const std::string width = type == "gaussian" ? "0.5" : "0.6";
  ExpectSlabMatches(MakeState(MakeRegion(1, Shapes[shape],
    R"({"type": ")" + type + R"(", "width": )" + width + "}", "[0.9, 0.5, 0.25]", 0.8)));
}

INSTANTIATE_TEST_SUITE_P(AllShapesAndFalloffs, SlabShapes,
  testing::Combine(testing::Values(0u, 1u, 2u, 3u, 4u),
    testing::Values("constant", "linear", "smooth", "gaussian")));

class SlabBlends : public testing::TestWithParam<const char*>
{
};

TEST_P(SlabBlends, OverlappingRegionsMatchTheReference)
{
  const std::string falloff = R"({"type": "smooth", "width": 0.7})";
  ExpectSlabMatches(MakeState(MakeRegion(1, Shapes[0], falloff, "[1, 0, 0]", 0.9) + "," +
      MakeRegion(2, Shapes[1], falloff, "[0, 1, 0]", 0.6) + "," +
      MakeRegion(3, Shapes[2], falloff, "[0, 0, 1]", 1.0),
    "[0, 1]", "[0, 1]", GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Both, SlabBlends, testing::Values("mix", "over"));

TEST(Slab, TertiaryOpacityMatchesTheReference)
{
  const std::string tertiary = R"({"array": "t", "component": 0, "range": [0, 1],
    "opacity": [[0.2, 0], [0.35, 1], [0.6, 0.25], [0.6, 0.75], [0.8, 0]]})";
  ExpectSlabMatches(MakeState(
    MakeRegion(1, Shapes[1], R"({"type": "linear", "width": 1})", "[1, 0.8, 0.2]", 1.0, tertiary)));
}

TEST(Slab, TertiaryColorMatchesTheReference)
{
  const std::string tertiary = R"({"array": "t", "component": 0, "range": [0, 1],
    "opacity": [[0, 1]],
    "color": [[0.2, 1, 0, 0], [0.5, 0, 1, 0.5], [0.7, 0, 0, 1]]})";
  ExpectSlabMatches(MakeState(
    MakeRegion(1, Shapes[3], R"({"type": "smooth", "width": 0.5})", "[1, 1, 1]", 0.9, tertiary)));
}

TEST(Slab, AxisAsTertiaryMatchesTheReference)
{
  const std::string tertiary = R"({"array": "x", "component": 0, "range": [0, 1],
    "opacity": [[0.3, 0], [0.5, 1], [0.7, 0]]})";
  ExpectSlabMatches(
    MakeState(MakeRegion(1, Shapes[1], R"({"type": "constant"})", "[0.2, 0.8, 1]", 0.7, tertiary)));
}

TEST(Slab, EightAttributesMatchTheReference)
{
  std::string regions;
  for (int i = 0; i < 6; ++i)
  {
    const std::string low = std::to_string(0.15 + 0.08 * i);
    const std::string high = std::to_string(0.45 + 0.05 * i);
    regions += (i ? "," : "") +
      MakeRegion(i + 1, Shapes[i % 4], R"({"type": "linear", "width": 0.8})",
        i % 2 ? "[0.3, 0.9, 0.1]" : "[0.9, 0.2, 0.7]", 0.5 + 0.05 * i,
        R"({"array": "u)" + std::to_string(i) + R"(", "component": 0, "range": [0, 1],
          "opacity": [[)" +
          low + ", 0], [" + high + ", 1], [0.95, 0.2]]}");
  }
  ExpectSlabMatches(MakeState(regions));
}

TEST(Slab, ManyOverlappingRegionsMatchTheReference)
{
  // Neighbouring pixels see different numbers of regions and different pieces of their functions.
  for (const char* blend : { "mix", "over" })
  {
    std::string regions;
    for (int i = 0; i < 14; ++i)
    {
      const std::string x = std::to_string(0.2 + 0.045 * i);
      const std::string y = std::to_string(0.5 + 0.02 * (i % 5));
      const std::string shape = i % 3 == 0
        ? R"({"type": "rectangle", "center": [)" + x + ", " + y + R"(], "halfsize": [0.2, 0.1]})"
        : R"({"type": "ellipse", "center": [)" + x + ", " + y + R"(], "radii": [0.15, 0.35]})";
      const std::string begin = std::to_string(0.1 + 0.03 * i);
      const std::string end = std::to_string(0.25 + 0.03 * i);
      const std::string tertiary = i % 2 == 0 ? "null"
                                              : R"({"array": "t", "component": 0, "range": [0, 1],
        "opacity": [[)" +
          begin + ", 0], [" + end + ", 1], [" + end + R"(, 0.5], [0.9, 0]]})";
      regions += (i ? "," : "") +
        MakeRegion(i + 1, shape, R"({"type": "smooth", "width": 0.6})",
          i % 3 ? "[0.2, 0.9, 0.4]" : "[1, 0.1, 0.6]", 0.2 + 0.04 * i, tertiary);
    }
    ExpectSlabMatches(MakeState(regions, "[0, 1]", "[0, 1]", blend));
  }
}

TEST(Slab, ManyRegionsWithoutTertiariesMatchTheReference)
{
  // Enough of them to be drawn by patches where they are smooth, and one that is not.
  for (const char* blend : { "mix", "over" })
  {
    std::string regions =
      MakeRegion(50, Shapes[1], R"({"type": "constant"})", "[0.1, 0.3, 1]", 0.3);
    for (int i = 0; i < 12; ++i)
    {
      const std::string x = std::to_string(0.4 + 0.02 * i);
      const std::string y = std::to_string(0.5 + 0.02 * (i % 5));
      regions += "," +
        MakeRegion(i + 1,
          R"({"type": "ellipse", "center": [)" + x + ", " + y + R"(], "radii": [0.3, 0.35]})",
          R"({"type": "smooth", "width": 0.5})", i % 3 ? "[0.2, 0.9, 0.4]" : "[1, 0.1, 0.6]",
          0.05 + 0.02 * i);
    }
    ExpectSlabMatches(MakeState(regions, "[0, 1]", "[0, 1]", blend));
  }
}

TEST(Slab, ANarrowRegionAmongManyMatchesTheReference)
{
  // It is narrower than the distance of a patch's nodes, and must not fall between them.
  std::string regions = MakeRegion(50,
    R"({"type": "rectangle", "center": [0.5, 0.5], "halfsize": [0.0004, 0.3], "angle": 3})",
    R"({"type": "constant"})", "[1, 1, 1]", 0.8);
  for (int i = 0; i < 6; ++i)
  {
    const char* falloffs[] = { "linear", "smooth", "gaussian" };
    const std::string radius = std::to_string(0.3 + 0.02 * i);
    regions += "," +
      MakeRegion(i + 1,
        R"({"type": "ellipse", "center": [0.5, 0.5], "radii": [)" + radius + ", 0.35]}",
        R"({"type": ")" + std::string(falloffs[i % 3]) + R"(", "width": 0.9})", "[0.2, 0.9, 0.4]",
        0.1);
  }
  for (const double scale : { 1.0, 0.01 })
  {
    ExpectSlabMatches(MakeState(regions), scale);
  }
}

TEST(Slab, DifferentAxisRangesMatchTheReference)
{
  // Rotation is in axis units, so unequal ranges shear it in data units.
  ExpectSlabMatches(MakeState(
    MakeRegion(1, R"({"type": "ellipse", "center": [0.5, 0.6], "radii": [0.3, 0.5], "angle": 50})",
      R"({"type": "smooth", "width": 0.8})", "[1, 1, 1]", 1.0),
    "[-0.5, 1.5]", "[0.2, 3]"));
}

TEST(Slab, RegionAThousandthOfAnAxisWideMatchesTheReference)
{
  // The window shows about a thousandth of both axes, and the region fills it.
  constexpr double scale = 0.001 * (Voxels - 1) / Size;
  for (const std::string shape :
    { R"({"type": "ellipse", "center": [0.5, 0.5], "radii": [0.0005, 0.0003], "angle": 30})",
      R"({"type": "rectangle", "center": [0.5, 0.5], "halfsize": [0.0005, 0.0002], "angle": 70})",
      R"({"type": "triangle", "points": [[0.4996, 0.4995], [0.5005, 0.4998], [0.4998, 0.5005]]})" })
  {
    ExpectSlabMatches(
      MakeState(MakeRegion(1, shape, R"({"type": "smooth", "width": 0.8})", "[1, 0.6, 0.3]", 1.0)),
      scale);
  }
}
