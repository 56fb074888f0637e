// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Outlines and lassos: geometry against closed forms.
#include "vtkTFCLasso.h"
#include "vtkTFCOutline.h"
#include "vtkTFCShape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using Point = vtkTFCOutline::Point;
const vtkTFCOutline::Ranges RANGES = { { 101225, 101425, -1, 1 } };
const double PI = std::acos(-1.0);

vtkTFCOutline Box(vtkTFCOutline::Types type, double angle)
{
  vtkTFCOutline box = vtkTFCOutline::Between(type, { 0.2, 0.3 }, { 0.6, 0.5 });
  box.Angle = angle;
  return box;
}

std::vector<Point> Circle(int n, double radius, double turns = 1)
{
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
  {
    const double t = turns * 2 * PI * i / n;
    points.push_back({ 200 + radius * std::cos(t), 200 + radius * std::sin(t) });
  }
  return points;
}

double PolygonArea(const std::vector<Point>& points)
{
  return vtkTFCOutline::FromPoints(points).GetArea();
}
}

TEST(Outline, SurvivesTheModel)
{
  vtkTFCOutline polygon =
    vtkTFCOutline::FromPoints({ { 0, 0 }, { 0.5, 0.1 }, { 0.4, 0.9 }, { 0.1, 0.3 } });
  vtkTFCOutline triangle =
    vtkTFCOutline::Between(vtkTFCOutline::Types::Triangle, { 0.1, 0.1 }, { 0.4, 0.7 });
  for (const vtkTFCOutline& outline : { Box(vtkTFCOutline::Types::Ellipse, 30),
         Box(vtkTFCOutline::Types::Rectangle, -70), polygon, triangle })
  {
    const auto shape = outline.NewShape(RANGES);
    ASSERT_TRUE(shape);
    const vtkTFCOutline back = vtkTFCOutline::FromShape(shape, RANGES);
    ASSERT_EQ(back.Type, outline.Type);
    const auto a = outline.GetPolyline();
    const auto b = back.GetPolyline();
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i)
    {
      // 101425 in double has 1e-11 relative to a range of 200.
      EXPECT_NEAR(a[i][0], b[i][0], 1e-12);
      EXPECT_NEAR(a[i][1], b[i][1], 1e-12);
    }
  }
}

TEST(Outline, AreaAndInside)
{
  // 96 chords of an ellipse: sin(x) / x of its area, x = 2 pi / 96.
  const double x = 2 * PI / 96;
  EXPECT_NEAR(Box(vtkTFCOutline::Types::Ellipse, 20).GetArea(), PI * 0.2 * 0.1 * std::sin(x) / x,
    1e-12);
  EXPECT_NEAR(Box(vtkTFCOutline::Types::Rectangle, 20).GetArea(), 0.4 * 0.2, 1e-12);
  const vtkTFCOutline ellipse = Box(vtkTFCOutline::Types::Ellipse, 90);
  EXPECT_TRUE(ellipse.Contains({ 0.4, 0.59 }));
  EXPECT_FALSE(ellipse.Contains({ 0.59, 0.4 }));
  // Even-odd: the middle of a pentagram is outside.
  std::vector<Point> star;
  for (int i = 0; i < 5; ++i)
  {
    star.push_back({ std::sin(4 * PI * i / 5), std::cos(4 * PI * i / 5) });
  }
  EXPECT_FALSE(vtkTFCOutline::FromPoints(star).Contains({ 0, 0 }));
  EXPECT_TRUE(vtkTFCOutline::FromPoints(star).Contains({ 0, 0.8 }));
}

TEST(Outline, CornersFollowThePointerAndKeepTheOppositeCorner)
{
  const Point margin = { 0.05, 0.05 };
  for (double angle : { 0.0, 37.0, 180.0, -120.0 })
  {
    const vtkTFCOutline box = Box(vtkTFCOutline::Types::Rectangle, angle);
    const auto before = box.GetHandles(margin);
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_EQ(before[i].Kind, vtkTFCOutline::Handles::Corner);
      const Point from = before[i].Position;
      const Point to = { from[0] + 0.03, from[1] - 0.02 };
      const auto after = box.Drag(before[i], from, to, {}, { 1e-3, 1e-3 }).GetHandles(margin);
      const int opposite = (i + 2) % 4;
      for (int axis = 0; axis < 2; ++axis)
      {
        EXPECT_NEAR(after[i].Position[axis], to[axis], 1e-12);
        EXPECT_NEAR(after[opposite].Position[axis], before[opposite].Position[axis], 1e-12);
      }
      // With Control the centre stays instead.
      const vtkTFCOutline symmetric =
        box.Drag(before[i], from, to, { false, true }, { 1e-3, 1e-3 });
      EXPECT_EQ(symmetric.Center, box.Center);
      EXPECT_NEAR(symmetric.GetHandles(margin)[i].Position[0], to[0], 1e-12);
      // With Shift the ratio of the sides.
      const vtkTFCOutline similar = box.Drag(before[i], from, to, { true, false }, { 1e-3, 1e-3 });
      EXPECT_NEAR(similar.HalfSize[0] / similar.HalfSize[1], 2, 1e-12);
    }
  }
}

TEST(Outline, NeverFoldsOver)
{
  const vtkTFCOutline box = Box(vtkTFCOutline::Types::Ellipse, 10);
  for (const vtkTFCOutline::Handle& handle : box.GetHandles({ 0.05, 0.05 }))
  {
    for (const Point to : { Point{ 5, 5 }, Point{ -5, 5 }, Point{ -5, -5 }, Point{ 0.4, 0.4 } })
    {
      for (bool flag : { false, true })
      {
        const vtkTFCOutline after =
          box.Drag(handle, handle.Position, to, { flag, !flag }, { 1e-3, 1e-3 });
        EXPECT_TRUE(after.IsValid());
        EXPECT_GE(after.HalfSize[0], 0.49e-3 * (flag ? 0.4 : 1));
      }
    }
  }
}

TEST(Outline, TurnsAndSnaps)
{
  const vtkTFCOutline box = Box(vtkTFCOutline::Types::Rectangle, 0);
  const vtkTFCOutline::Handle turn = box.GetHandles({ 0.1, 0.1 }).back();
  ASSERT_EQ(turn.Kind, vtkTFCOutline::Handles::Turn);
  EXPECT_NEAR(box.Drag(turn, { 0.4, 0.6 }, { 0.2, 0.4 }, {}, { 0, 0 }).Angle, 90, 1e-12);
  EXPECT_NEAR(box.Drag(turn, { 0.4, 0.6 }, { 0.39, 0.6 }, { true, false }, { 0, 0 }).Angle, 0,
    1e-12);
  const vtkTFCOutline square =
    vtkTFCOutline::FromPoints({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }).Turned(45);
  EXPECT_NEAR(square.GetBounds()[1], 0.5 + std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(square.GetArea(), 1, 1e-12);
}

TEST(Outline, VerticesComeAndGo)
{
  vtkTFCOutline triangle =
    vtkTFCOutline::Between(vtkTFCOutline::Types::Triangle, { 0, 0 }, { 1, 1 });
  EXPECT_FALSE(triangle.RemoveVertex(0));
  double distance;
  EXPECT_EQ(triangle.NearestEdge({ 0.5, -0.1 }, { 1, 0.1 }, &distance), 0);
  EXPECT_NEAR(distance, 1, 1e-12);
  EXPECT_TRUE(triangle.InsertVertex(0, { 0.5, -0.1 }));
  EXPECT_EQ(triangle.Type, vtkTFCOutline::Types::Polygon);
  EXPECT_EQ(triangle.Points.size(), 4u);
  EXPECT_TRUE(triangle.RemoveVertex(1));
  EXPECT_FALSE(triangle.RemoveVertex(1));
  // Three corners on one line would enclose nothing.
  vtkTFCOutline flat = vtkTFCOutline::FromPoints({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } });
  EXPECT_FALSE(flat.RemoveVertex(3));
  EXPECT_FALSE(vtkTFCOutline::FromPoints({ { 0, 0 }, { 1, 1 }, { 2, 2 } }).NewShape(RANGES));
}

TEST(Outline, FalloffLineOfASquareGoesFromItsMiddleToASide)
{
  Point inner;
  Point outer;
  vtkTFCOutline::FromPoints({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
    .GetFalloffLine(inner, outer);
  EXPECT_NEAR(inner[0], 0.5, 1.0 / 48);
  EXPECT_NEAR(inner[1], 0.5, 1.0 / 48);
  EXPECT_NEAR(std::hypot(outer[0] - inner[0], outer[1] - inner[1]), 0.5, 1.0 / 48);
}

TEST(Lasso, KeepsTheAreaWithFewVertices)
{
  const auto lasso = vtkTFCSimplifyLasso(Circle(2000, 100), 1.5, 9);
  EXPECT_GE(lasso.size(), 8u);
  EXPECT_LE(lasso.size(), 40u);
  EXPECT_NEAR(PolygonArea(lasso), PI * 1e4, 0.02 * PI * 1e4);
}

TEST(Lasso, CutsTheTailsWhereTheEndCrossesTheBeginning)
{
  // A spiral of 1.15 turns whose end lies inside its beginning would leave a hole by even-odd.
  std::vector<Point> stroke;
  for (int i = 0; i <= 400; ++i)
  {
    const double t = 2 * PI * 1.15 * i / 400;
    const double radius = 100 + 15 * std::cos(0.95 * t);
    stroke.push_back({ 200 + radius * std::cos(t), 200 + radius * std::sin(t) });
  }
  const auto lasso = vtkTFCSimplifyLasso(stroke, 1.5, 9);
  ASSERT_FALSE(lasso.empty());
  const vtkTFCOutline outline = vtkTFCOutline::FromPoints(lasso);
  for (int i = 0; i < 36; ++i)
  {
    const double t = 2 * PI * i / 36;
    EXPECT_TRUE(outline.Contains({ 200 + 80 * std::cos(t), 200 + 80 * std::sin(t) })) << i;
  }
}

TEST(Lasso, DegenerateStrokesGiveNothing)
{
  EXPECT_TRUE(vtkTFCSimplifyLasso({}, 1.5, 9).empty());
  EXPECT_TRUE(vtkTFCSimplifyLasso({ { 1, 1 } }, 1.5, 9).empty());
  EXPECT_TRUE(vtkTFCSimplifyLasso({ { 1, 1 }, { 50, 50 } }, 1.5, 9).empty());
  EXPECT_TRUE(vtkTFCSimplifyLasso(std::vector<Point>(10000, { 3, 3 }), 1.5, 9).empty());
  std::vector<Point> line;
  for (int i = 0; i < 10000; ++i)
  {
    line.push_back({ i * 0.1, i * 0.05 });
  }
  EXPECT_TRUE(vtkTFCSimplifyLasso(line, 1.5, 9).empty());
  const double nan = std::nan("");
  EXPECT_TRUE(vtkTFCSimplifyLasso({ { nan, 0 }, { 0, nan }, { 1, 1 } }, 1.5, 9).empty());
}

TEST(Lasso, FigureOfEightKeepsBothLobes)
{
  std::vector<Point> eight;
  for (int i = 0; i < 500; ++i)
  {
    const double t = 2 * PI * (i + 0.25) / 500;
    eight.push_back({ 200 + 100 * std::sin(t), 200 + 50 * std::sin(2 * t) });
  }
  const auto lasso = vtkTFCSimplifyLasso(eight, 1.5, 9);
  const vtkTFCOutline outline = vtkTFCOutline::FromPoints(lasso);
  ASSERT_FALSE(lasso.empty());
  EXPECT_TRUE(outline.Contains({ 260, 200 }));
  EXPECT_TRUE(outline.Contains({ 140, 200 }));
}

TEST(Lasso, TenThousandRandomPointsAreReduced)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0, 500);
  std::vector<Point> stroke;
  for (int i = 0; i < 10000; ++i)
  {
    stroke.push_back({ anywhere(random), anywhere(random) });
  }
  const auto lasso = vtkTFCSimplifyLasso(stroke, 1.5, 9);
  EXPECT_LE(lasso.size(), 64u);
}
