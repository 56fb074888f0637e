// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes and fall-offs against closed forms. Axes: P in [0, 10], S in [-1, 1].
#include "ModelTesting.h"

#include <cmath>

using namespace ModelTesting;

namespace
{
const double Pi = std::acos(-1.0);

// Weight of one region, read through Classify(): opacity 1, no tertiary function.
class Weight
{
public:
  Weight(const std::string& shape, const std::string& falloff)
    : Classifier(
        Compile(State(R"({"id": 1, "shape": )" + shape + R"(, "falloff": )" + falloff + "}")))
  {
  }
  // In data units.
  double operator()(double primary, double secondary) const
  {
    return Evaluate(this->Classifier, { primary, secondary }).Opacity;
  }
  const vtkTFCCompiledRegion& Region() const { return this->Classifier.GetModel().Regions.at(0); }

private:
  vtkTFCClassifier Classifier;
};

// Linear with width 1 makes the weight 1 - d, which shows the distance itself.
const char* const Cone = R"({"type": "linear", "width": 1})";
const char* const Constant = R"({"type": "constant"})";
}

TEST(Falloff, FollowsItsFormula)
{
  for (const double width : { 0.01, 0.25, 0.5, 1.0 })
  {
    for (double d = 0; d <= 1; d += 1.0 / 64)
    {
      const double linear = std::min(1.0, (1 - d) / width);
      const auto weight = [&](vtkTFCFalloffType type)
      { return vtkTFCClassifier::FalloffWeight(type, width, d); };
      EXPECT_EQ(weight(vtkTFCFalloffType::Constant), 1);
      EXPECT_DOUBLE_EQ(weight(vtkTFCFalloffType::Linear), linear);
      EXPECT_DOUBLE_EQ(weight(vtkTFCFalloffType::Smooth),
        3 * linear * linear - 2 * linear * linear * linear);
      EXPECT_DOUBLE_EQ(weight(vtkTFCFalloffType::Gaussian), std::exp(-d * d / (2 * width * width)));
    }
  }
}

TEST(Falloff, IsZeroOutsideAndForNaN)
{
  for (int type = 0; type < 4; ++type)
  {
    const auto falloff = static_cast<vtkTFCFalloffType>(type);
    EXPECT_EQ(vtkTFCClassifier::FalloffWeight(falloff, 0.5, std::nextafter(1.0, 2.0)), 0);
    EXPECT_EQ(vtkTFCClassifier::FalloffWeight(falloff, 0.5, std::nan("")), 0);
  }
}

TEST(Falloff, SmallestWidthsAreNumbers)
{
  for (int type = 0; type < 4; ++type)
  {
    const auto falloff = static_cast<vtkTFCFalloffType>(type);
    EXPECT_EQ(vtkTFCClassifier::FalloffWeight(falloff, 5e-324, 0), 1);
    const double weight = vtkTFCClassifier::FalloffWeight(falloff, 5e-324, 0.5);
    EXPECT_EQ(weight, falloff == vtkTFCFalloffType::Gaussian ? 0 : 1);
  }
}

TEST(Falloff, DefaultIsSmoothQuarter)
{
  const auto model =
    Compile(State(R"({"id": 1, "shape": {"type": "ellipse", "center": [5, 0], "radii": [1, 1]}})"));
  EXPECT_EQ(model.Regions[0].Falloff, vtkTFCFalloffType::Smooth);
  EXPECT_EQ(model.Regions[0].Width, 0.25);
}

TEST(Ellipse, DistanceInDataUnits)
{
  const Weight weight(R"({"type": "ellipse", "center": [4, 0.25], "radii": [2, 0.5]})", Cone);
  EXPECT_FLOAT_EQ(weight(4, 0.25), 1);
  EXPECT_NEAR(weight(5, 0.25), 0.5, 1e-6);
  EXPECT_NEAR(weight(4, 0), 0.5, 1e-6);
  EXPECT_NEAR(weight(5, 0.5), 1 - std::sqrt(0.5), 1e-6);
  EXPECT_EQ(weight(6.01, 0.25), 0);
  EXPECT_EQ(weight(4, 0.76), 0);
}

TEST(Ellipse, RotatesInAxisUnits)
{
  // In axis units: centre (0.5, 0.5), radii (0.4, 0.1), turned by 30 degrees.
  const Weight weight(R"({"type": "ellipse", "center": [5, 0], "radii": [4, 0.2], "angle": 30})",
    Cone);
  for (int k = 0; k < 24; ++k)
  {
    const double t = 2 * Pi * k / 24;
    const double u = 0.5 * 0.4 * std::cos(t);
    const double v = 0.5 * 0.1 * std::sin(t);
    const double x = 0.5 + u * std::cos(Pi / 6) - v * std::sin(Pi / 6);
    const double y = 0.5 + u * std::sin(Pi / 6) + v * std::cos(Pi / 6);
    EXPECT_NEAR(weight(10 * x, 2 * y - 1), 0.5, 1e-6) << k;
  }
}

TEST(Ellipse, QuarterTurnSwapsRadiiInAxisUnits)
{
  // Radii (0.4, 0.1) in axis units become (0.1, 0.4): 1 in P, 0.8 in S.
  const Weight weight(R"({"type": "ellipse", "center": [5, 0], "radii": [4, 0.2], "angle": -90})",
    Cone);
  EXPECT_NEAR(weight(5.5, 0), 0.5, 1e-6);
  EXPECT_NEAR(weight(5, 0.4), 0.5, 1e-6);
  EXPECT_EQ(weight(6.001, 0), 0);
}

TEST(Ellipse, BoundsContainTheOutline)
{
  const Weight weight(R"({"type": "ellipse", "center": [5, 0], "radii": [4, 0.2], "angle": 50})",
    Constant);
  const auto& bounds = weight.Region().Bounds;
  double width = 0;
  for (int k = 0; k < 3600; ++k)
  {
    const double t = 2 * Pi * k / 3600;
    const double x =
      0.4 * std::cos(t) * std::cos(50 * Pi / 180) - 0.1 * std::sin(t) * std::sin(50 * Pi / 180);
    width = std::max(width, x);
    EXPECT_LE(x, bounds[1] - 0.5);
  }
  EXPECT_NEAR(bounds[1] - 0.5, width, 1e-5);
}

TEST(Rectangle, DistanceAndBorder)
{
  const Weight weight(R"({"type": "rectangle", "center": [4, 0], "halfsize": [2, 0.5]})", Cone);
  EXPECT_NEAR(weight(5, 0.1), 0.5, 1e-6);
  EXPECT_NEAR(weight(4.2, 0.375), 0.25, 1e-6);
  const Weight box(R"({"type": "rectangle", "center": [4, 0], "halfsize": [2, 0.5]})", Constant);
  EXPECT_EQ(box(2, 0.5), 1) << "the outline belongs to the region";
  EXPECT_EQ(box(std::nextafter(6.0, 7.0) + 1e-12, 0), 0);
}

TEST(Rectangle, RotatesInAxisUnits)
{
  const Weight weight(
    R"({"type": "rectangle", "center": [5, 0], "halfsize": [3, 0.2], "angle": 20})", Cone);
  const double c = std::cos(Pi / 9);
  const double s = std::sin(Pi / 9);
  for (const auto& uv : { std::array<double, 2>{ 0.15, 0.02 }, { -0.15, -0.049 }, { 0.01, 0.05 } })
  {
    const double x = 0.5 + c * uv[0] - s * uv[1];
    const double y = 0.5 + s * uv[0] + c * uv[1];
    const double d = std::max(std::abs(uv[0]) / 0.3, std::abs(uv[1]) / 0.1);
    EXPECT_NEAR(weight(10 * x, 2 * y - 1), 1 - d, 1e-6);
  }
}

TEST(Triangle, DistanceIsRelativeToTheInradius)
{
  // In axis units (0, 0), (0.6, 0), (0, 0.8): a 3-4-5 triangle, inradius 0.2, incentre (0.2, 0.2).
  const Weight weight(R"({"type": "triangle", "points": [[0, -1], [6, -1], [0, 0.6]]})", Cone);
  EXPECT_DOUBLE_EQ(weight.Region().MaximumEdgeDistance, 0.2);
  EXPECT_NEAR(weight(2, -0.6), 1, 1e-6);
  EXPECT_NEAR(weight(1, -0.6), 0.5, 1e-6);
  EXPECT_NEAR(weight(2, -0.8), 0.5, 1e-6);
  EXPECT_EQ(weight(6, 0.6), 0);
}

TEST(Triangle, OrientationDoesNotMatter)
{
  const Weight one(R"({"type": "triangle", "points": [[1, -1], [6, -0.5], [3, 0.6]]})", Cone);
  const Weight two(R"({"type": "triangle", "points": [[3, 0.6], [6, -0.5], [1, -1]]})", Cone);
  for (double p = 0; p <= 10; p += 0.37)
  {
    for (double s = -1; s <= 1; s += 0.11)
    {
      EXPECT_NEAR(one(p, s), two(p, s), 1e-6);
    }
  }
}

TEST(Shapes, AThousandthOfAnAxisIsExact)
{
  const Weight weight(R"({"type": "ellipse", "center": [5, 0], "radii": [0.01, 0.002]})", Cone);
  EXPECT_NEAR(weight(5.005, 0), 0.5, 1e-6);
  EXPECT_NEAR(weight(5, 0.0005), 0.75, 1e-6);
  EXPECT_EQ(weight(5.0101, 0), 0);
}

TEST(Shapes, GeometryThatAxisUnitsCannotHoldIsLeftOut)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(R"({"format": "transfer-function-combination", "version": 1,
    "primary": {"array": "P", "range": [0, 1e-300]}, "secondary": {"array": "S", "range": [-1e300, 1e300]},
    "regions": [{"id": 1, "shape": {"type": "ellipse", "center": [0, 0], "radii": [1e300, 1e-300]}},
      {"id": 2, "shape": {"type": "polygon", "points": [[0, 0], [1e300, 0], [0, 1]]}}]})"));
  EXPECT_TRUE(model->Compile().Regions.empty());
}
