// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Combination of regions: blends, tertiary functions, region ids, values that are in no region.
#include "ModelTesting.h"

#include <cmath>
#include <limits>

using namespace ModelTesting;

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

const char* const Red = "[1, 0, 0]";
const char* const Green = "[0, 1, 0]";

std::string Tertiary(const std::string& opacity, const std::string& color = "null")
{
  return R"({"array": "T", "opacity": )" + opacity + R"(, "color": )" + color + "}";
}

void ExpectColor(const Sample& sample, float r, float g, float b, float a)
{
  const float tolerance = 1e-6F;
  EXPECT_NEAR(sample.RGBA[0], r, tolerance);
  EXPECT_NEAR(sample.RGBA[1], g, tolerance);
  EXPECT_NEAR(sample.RGBA[2], b, tolerance);
  EXPECT_NEAR(sample.RGBA[3], a, tolerance);
  EXPECT_EQ(sample.RGBA[3], sample.Opacity);
}
}

TEST(Blend, MixOfTwo)
{
  const auto sample =
    Evaluate(State(Everywhere(3, 0.5, Red) + "," + Everywhere(4, 0.25, Green)), { 5, 0 });
  ExpectColor(sample, 0.5F / 0.75F, 0.25F / 0.75F, 0, 1 - 0.5F * 0.75F);
  EXPECT_EQ(sample.Region, 3);
}

TEST(Blend, OverOfTwo)
{
  const auto sample =
    Evaluate(State(Everywhere(3, 0.5, Red) + "," + Everywhere(4, 0.8, Green), "over"), { 5, 0 });
  // 0.5 red in front, of green 0.8 * 0.5 is left.
  ExpectColor(sample, 0.5F / 0.9F, 0.4F / 0.9F, 0, 0.9F);
  EXPECT_EQ(sample.Region, 3) << "after occlusion red contributes more";
  EXPECT_EQ(
    Evaluate(State(Everywhere(3, 0.5, Red) + "," + Everywhere(4, 0.8, Green)), { 5, 0 }).Region, 4)
    << "without occlusion green does";
}

TEST(Blend, OpaqueFrontHidesAll)
{
  const auto sample =
    Evaluate(State(Everywhere(1, 1, Red) + "," + Everywhere(2, 1, Green), "over"), { 5, 0 });
  ExpectColor(sample, 1, 0, 0, 1);
  EXPECT_EQ(sample.Region, 1);
}

TEST(Blend, MixOfOpaqueRegionsStaysOne)
{
  std::string regions;
  for (int id = 1; id <= 20; ++id)
  {
    regions += (id > 1 ? "," : "") + Everywhere(id, 1, id % 2 ? Red : Green);
  }
  ExpectColor(Evaluate(State(regions), { 5, 0 }), 0.5F, 0.5F, 0, 1);
}

TEST(RegionId, FirstAmongEqualsAndZeroForNone)
{
  const std::string state = State(Everywhere(9, 0.5, Red) + "," + Everywhere(4, 0.5, Green));
  EXPECT_EQ(Evaluate(state, { 5, 0 }).Region, 9);
  const auto none = Evaluate(State(""), { 5, 0 });
  EXPECT_EQ(none.Region, 0);
  ExpectColor(none, 0, 0, 0, 0);
}

TEST(RegionId, InvisibleAndZeroOpacityDoNotCount)
{
  const std::string hidden = R"({"id": 7, "visible": false, "shape": {"type": "rectangle",
    "center": [5, 0], "halfsize": [9, 9]}})";
  const auto model = Compile(State(hidden + "," + Everywhere(8, 0, Red)));
  EXPECT_TRUE(model.Regions.empty());
}

TEST(AxisRange, EndsBelongToItAndNothingBeyond)
{
  const vtkTFCClassifier classifier(Compile(State(Everywhere(1, 1, Red))));
  for (const double inside : { 0.0, 10.0, 5.0 })
  {
    EXPECT_EQ(Evaluate(classifier, { inside, -1 }).Region, 1);
    EXPECT_EQ(Evaluate(classifier, { inside, 1 }).Region, 1);
  }
  for (const double outside :
    { std::nextafter(0.0, -1.0), std::nextafter(10.0, 11.0), NaN, Infinity, -Infinity })
  {
    ExpectColor(Evaluate(classifier, { outside, 0 }), 0, 0, 0, 0);
    EXPECT_EQ(Evaluate(classifier, { outside, 0 }).Region, 0);
  }
  for (const double outside :
    { std::nextafter(-1.0, -2.0), std::nextafter(1.0, 2.0), NaN, Infinity })
  {
    EXPECT_EQ(Evaluate(classifier, { 5, outside }).Region, 0);
  }
}

TEST(Tertiary, PiecewiseLinearWithExtendedEnds)
{
  const vtkTFCClassifier classifier(
    Compile(State(Everywhere(1, 0.5, Red, Tertiary("[[0, 0.2], [10, 1], [20, 0.4]]")))));
  const auto alpha = [&](double t) { return Evaluate(classifier, { 5, 0, t }).Opacity; };
  EXPECT_FLOAT_EQ(alpha(-5), 0.1F);
  EXPECT_FLOAT_EQ(alpha(0), 0.1F);
  EXPECT_FLOAT_EQ(alpha(5), 0.3F);
  EXPECT_FLOAT_EQ(alpha(10), 0.5F);
  EXPECT_FLOAT_EQ(alpha(15), 0.35F);
  EXPECT_FLOAT_EQ(alpha(99), 0.2F);
  EXPECT_FLOAT_EQ(alpha(Infinity), 0.2F);
  EXPECT_FLOAT_EQ(alpha(-Infinity), 0.1F);
  EXPECT_EQ(alpha(NaN), 0);
}

TEST(Tertiary, StepsHoldFromTheirValueOn)
{
  const vtkTFCClassifier classifier(Compile(State(Everywhere(1, 1, Red,
    Tertiary("[[0, 0.1], [0, 0.2], [1, 0.2], [1, 0.8], [2, 0.8], [2, 0.3]]")))));
  const auto alpha = [&](double t) { return Evaluate(classifier, { 5, 0, t }).Opacity; };
  EXPECT_FLOAT_EQ(alpha(std::nextafter(0.0, -1.0)), 0.1F);
  EXPECT_FLOAT_EQ(alpha(0), 0.2F);
  EXPECT_FLOAT_EQ(alpha(std::nextafter(1.0, 0.0)), 0.2F);
  EXPECT_FLOAT_EQ(alpha(1), 0.8F);
  EXPECT_FLOAT_EQ(alpha(2), 0.3F);
  EXPECT_FLOAT_EQ(alpha(3), 0.3F);
}

TEST(Tertiary, SingleNodeIsConstant)
{
  const vtkTFCClassifier classifier(
    Compile(State(Everywhere(1, 1, Red, Tertiary("[[3, 0.25]]", "[[9, 0.1, 0.2, 0.3]]")))));
  for (const double t : { -1.0, 3.0, 1e30 })
  {
    ExpectColor(Evaluate(classifier, { 5, 0, t }), 0.1F, 0.2F, 0.3F, 0.25F);
  }
}

TEST(Tertiary, ColorReplacesTheRegionColor)
{
  const vtkTFCClassifier classifier(Compile(State(
    Everywhere(1, 1, Red, Tertiary("[[0, 1]]", "[[0, 0, 0, 1], [10, 0, 1, 0], [10, 1, 1, 1]]")))));
  ExpectColor(Evaluate(classifier, { 5, 0, -3 }), 0, 0, 1, 1);
  ExpectColor(Evaluate(classifier, { 5, 0, 2.5 }), 0, 0.25F, 0.75F, 1);
  ExpectColor(Evaluate(classifier, { 5, 0, 10 }), 1, 1, 1, 1);
}

TEST(Tertiary, NaNTakesOnlyItsOwnRegionOut)
{
  const std::string state =
    State(Everywhere(1, 0.5, Red, Tertiary("[[0, 1]]")) + "," + Everywhere(2, 0.25, Green));
  const auto sample = Evaluate(state, { 5, 0, NaN });
  ExpectColor(sample, 0, 1, 0, 0.25F);
  EXPECT_EQ(sample.Region, 2);
}

TEST(Tertiary, AttributesAreSharedAndMayBeAnAxis)
{
  const std::string byAxis = R"({"array": "P", "opacity": [[0, 0], [10, 1]]})";
  const std::string other = R"({"array": "T", "component": 1, "opacity": [[0, 1]]})";
  const auto model = Compile(State(Everywhere(1, 1, Red, Tertiary("[[0, 1]]")) + "," +
    Everywhere(2, 1, Red, byAxis) + "," + Everywhere(3, 1, Red, other) + "," +
    Everywhere(4, 0, Red, R"({"array": "U", "opacity": [[0, 1]]})") + "," +
    Everywhere(5, 1, Red, Tertiary("[[0, 1]]"))));
  ASSERT_EQ(model.Attributes.size(), 5u);
  EXPECT_EQ(model.Attributes[2], (vtkTFCAttribute{ "T", 0 }));
  EXPECT_EQ(model.Attributes[3], (vtkTFCAttribute{ "T", 1 }));
  EXPECT_EQ(model.Attributes[4].Array, "U") << "of a region whose opacity happens to be 0";
  ASSERT_EQ(model.Regions.size(), 4u);
  EXPECT_EQ(model.Regions[0].Tertiary, 2);
  EXPECT_EQ(model.Regions[1].Tertiary, 0);
  EXPECT_EQ(model.Regions[2].Tertiary, 3);
  EXPECT_EQ(model.Regions[3].Tertiary, 2);
}

TEST(Batch, EqualsSingleSamplesAndOutputsAreOptional)
{
  const vtkTFCClassifier classifier(Compile(State(
    R"({"id": 1, "shape": {"type": "ellipse", "center": [4, 0], "radii": [3, 0.8], "angle": 25},
        "falloff": {"type": "gaussian", "width": 0.4}, "color": [0.3, 0.6, 0.9]})")));
  for (const size_t count : { 0u, 1u, 255u, 256u, 257u, 1000u })
  {
    std::vector<double> p(count);
    std::vector<double> s(count);
    for (size_t i = 0; i < count; ++i)
    {
      p[i] = 11.0 * static_cast<double>(i) / 1000 - 0.5;
      s[i] = std::sin(static_cast<double>(i));
    }
    const double* pointers[] = { p.data(), s.data() };
    std::vector<float> rgba(4 * count + 1, -1);
    std::vector<int> region(count + 1, -1);
    std::vector<float> opacity(count + 1, -1);
    classifier.Classify(count, pointers, rgba.data(), region.data(), opacity.data());
    classifier.Classify(count, pointers, nullptr, nullptr, opacity.data());
    for (size_t i = 0; i < count; ++i)
    {
      const auto sample = Evaluate(classifier, { p[i], s[i] });
      EXPECT_EQ(sample.RGBA[3], rgba[4 * i + 3]);
      EXPECT_EQ(sample.RGBA[1], rgba[4 * i + 1]);
      EXPECT_EQ(sample.Region, region[i]);
      EXPECT_EQ(sample.Opacity, opacity[i]);
    }
    EXPECT_EQ(rgba[4 * count], -1);
    EXPECT_EQ(region[count], -1);
    EXPECT_EQ(opacity[count], -1);
  }
}
