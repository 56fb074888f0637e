// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Polygons: inside, edge distance and the largest edge distance, against brute force.
#include "ModelTesting.h"

#include "vtkPoints.h"
#include "vtkTFCPolygonShape.h"
#include "vtkTFCRegion.h"

#include <chrono>
#include <cmath>
#include <random>

using namespace ModelTesting;

namespace
{
using Points = std::vector<std::array<double, 2>>;

const double Pi = std::acos(-1.0);

// Axes [0, 1], so that data units are axis units.
vtkTFCCompiledRegion CompilePolygon(const Points& points)
{
  vtkNew<vtkTFCTransferFunction> model;
  vtkNew<vtkPoints> list;
  list->SetDataTypeToDouble();
  for (const auto& point : points)
  {
    list->InsertNextPoint(point[0], point[1], 0);
  }
  vtkTFCRegion* region = model->AddNewRegion("polygon");
  EXPECT_TRUE(vtkTFCPolygonShape::SafeDownCast(region->GetShape())->SetPoints(list));
  region->SetFalloff(vtkTFCRegion::Linear, 1);
  const auto compiled = model->Compile();
  return compiled.Regions.empty() ? vtkTFCCompiledRegion() : compiled.Regions[0];
}

// Negative outside. Winding is not used: even-odd by counting crossings of a ray to +y.
double BruteDistance(const Points& points, double x, double y)
{
  double nearest = HUGE_VAL;
  int crossings = 0;
  for (size_t i = 0; i < points.size(); ++i)
  {
    const auto& a = points[i];
    const auto& b = points[(i + 1) % points.size()];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double t = length == 0
      ? 0
      : std::clamp(((x - a[0]) * (b[0] - a[0]) + (y - a[1]) * (b[1] - a[1])) / (length * length),
          0.0, 1.0);
    nearest =
      std::min(nearest, std::hypot(a[0] + t * (b[0] - a[0]) - x, a[1] + t * (b[1] - a[1]) - y));
    if ((a[0] <= x) != (b[0] <= x) && a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]) > y)
    {
      ++crossings;
    }
  }
  return crossings % 2 == 1 ? nearest : -nearest;
}

// Largest distance on a grid, refined around the best places.
double BruteMaximum(const Points& points)
{
  double best = 0;
  std::array<double, 2> at = { { 0.5, 0.5 } };
  constexpr int n = 300;
  for (int i = 0; i <= n; ++i)
  {
    for (int k = 0; k <= n; ++k)
    {
      const double d = BruteDistance(points, 1.0 * i / n, 1.0 * k / n);
      if (d > best)
      {
        best = d;
        at = { { 1.0 * i / n, 1.0 * k / n } };
      }
    }
  }
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  double step = 1.0 / n;
  for (int i = 0; i < 6000; ++i)
  {
    const double x = at[0] + step * normal(random);
    const double y = at[1] + step * normal(random);
    const double d = BruteDistance(points, x, y);
    if (d > best)
    {
      best = d;
      at = { { x, y } };
    }
    step *= 0.998;
  }
  return best;
}

Points Star(std::mt19937& random, int count, double roughness)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  Points points;
  for (int i = 0; i < count; ++i)
  {
    const double t = 2 * Pi * i / count;
    const double r = 0.45 * (1 - roughness * uniform(random));
    points.push_back({ { 0.5 + r * std::cos(t), 0.5 + r * std::sin(t) } });
  }
  return points;
}
}

TEST(PolygonPole, KnownOutlines)
{
  // Square; a long rectangle whose pole is a segment; an L.
  EXPECT_NEAR(CompilePolygon({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }).MaximumEdgeDistance, 0.5,
    1e-9);
  EXPECT_NEAR(CompilePolygon({ { 0, 0 }, { 1, 0 }, { 1, 0.1 }, { 0, 0.1 } }).MaximumEdgeDistance,
    0.05, 1e-9);
  // The largest circle of the L touches two outer edges and the inner corner (0.3, 0.3).
  EXPECT_NEAR(CompilePolygon({ { 0, 0 }, { 1, 0 }, { 1, 0.3 }, { 0.3, 0.3 }, { 0.3, 1 }, { 0, 1 } })
                .MaximumEdgeDistance,
    0.3 * std::sqrt(2.0) / (1 + std::sqrt(2.0)), 1e-9);
  // A regular 64-gon of circumradius 0.5.
  Points gon;
  for (int i = 0; i < 64; ++i)
  {
    gon.push_back({ { 0.5 + 0.5 * std::cos(Pi * i / 32), 0.5 + 0.5 * std::sin(Pi * i / 32) } });
  }
  EXPECT_NEAR(CompilePolygon(gon).MaximumEdgeDistance, 0.5 * std::cos(Pi / 64), 1e-9);
}

TEST(PolygonPole, TriangleGivesTheInradius)
{
  const auto region = CompilePolygon({ { 0.1, 0.1 }, { 0.4, 0.1 }, { 0.1, 0.5 } });
  EXPECT_NEAR(region.MaximumEdgeDistance, 0.1, 1e-10);
}

TEST(PolygonPole, TiltedSliver)
{
  // 1 long, 1e-5 wide, at 33 degrees: far below any grid.
  const double c = std::cos(0.57595865);
  const double s = std::sin(0.57595865);
  Points points;
  for (const auto& p : Points{ { 0, 0 }, { 1, 0 }, { 1, 1e-5 }, { 0, 1e-5 } })
  {
    points.push_back({ { c * p[0] - s * p[1], s * p[0] + c * p[1] } });
  }
  EXPECT_NEAR(CompilePolygon(points).MaximumEdgeDistance, 5e-6, 1e-11);
}

TEST(PolygonPole, MatchesBruteForceOnRandomOutlines)
{
  std::mt19937 random(1);
  for (int round = 0; round < 12; ++round)
  {
    const Points points = Star(random, 5 + 9 * round, 0.8);
    const double brute = BruteMaximum(points);
    const double found = CompilePolygon(points).MaximumEdgeDistance;
    // Brute force never exceeds the truth; ours may miss it by 2e-4 at most.
    EXPECT_GT(found, brute - 2e-4) << round;
    EXPECT_LT(found, brute + 1.0 / 300) << round;
  }
}

TEST(PolygonPole, SelfIntersectionsAreEvenOdd)
{
  // A pentagram: its centre pentagon is outside.
  Points points;
  for (int i = 0; i < 5; ++i)
  {
    const double t = Pi / 2 + 4 * Pi * i / 5;
    points.push_back({ { 0.5 + 0.5 * std::cos(t), 0.5 + 0.5 * std::sin(t) } });
  }
  const auto region = CompilePolygon(points);
  EXPECT_EQ(vtkTFCClassifier::RegionWeight(region, 0.5, 0.5), 0);
  EXPECT_GT(vtkTFCClassifier::RegionWeight(region, 0.5, 0.8), 0);
  EXPECT_NEAR(region.MaximumEdgeDistance, BruteMaximum(points), 2e-4);
}

TEST(PolygonPole, RepeatedAndClosingPointsChangeNothing)
{
  const auto once = CompilePolygon({ { 0, 0 }, { 1, 0 }, { 0.7, 1 } });
  const auto more =
    CompilePolygon({ { 0, 0 }, { 0, 0 }, { 1, 0 }, { 1, 0 }, { 0.7, 1 }, { 0, 0 } });
  EXPECT_NEAR(once.MaximumEdgeDistance, more.MaximumEdgeDistance, 1e-9);
  for (double x = 0.005; x < 1; x += 0.1)
  {
    EXPECT_NEAR(vtkTFCClassifier::RegionWeight(once, x, 0.2),
      vtkTFCClassifier::RegionWeight(more, x, 0.2), 1e-9);
  }
}

TEST(PolygonPole, AnOutlineThatEnclosesNothingIsLeftOut)
{
  // Forth and back on the same edges: not on one line, yet every point is outside.
  EXPECT_EQ(CompilePolygon({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1, 0 } }).Id, 0);
}

TEST(PolygonWeight, MatchesBruteForce)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int round = 0; round < 20; ++round)
  {
    Points points;
    if (round % 2 == 0)
    {
      points = Star(random, 40, 0.7);
    }
    else
    {
      for (int i = 0; i < 4 + round; ++i)
      {
        points.push_back({ { uniform(random), uniform(random) } }); // crosses itself many times
      }
    }
    const auto region = CompilePolygon(points);
    for (int i = 0; i < 500; ++i)
    {
      const double x = uniform(random);
      const double y = uniform(random);
      const double e = BruteDistance(points, x, y);
      const double expected = e < 0 ? 0 : std::min(1.0, e / region.MaximumEdgeDistance);
      EXPECT_NEAR(vtkTFCClassifier::RegionWeight(region, x, y), expected, 1e-9);
    }
  }
}

TEST(PolygonPole, IsFastEnoughToDrag)
{
  std::mt19937 random(3);
  for (const int count : { 20, 200, 2000 })
  {
    const Points points = Star(random, count, 0.3);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_GT(CompilePolygon(points).MaximumEdgeDistance, 0);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    RecordProperty("milliseconds_" + std::to_string(count), std::to_string(time.count()));
    // Generous, for sanitizers and busy machines; a frame at 200 points in a Release build.
    EXPECT_LT(time.count(), 2000) << count;
  }
}

TEST(PolygonPole, HostileOutlineEnds)
{
  // 10000 random points: about 10^7 crossings, no inside larger than a crumb.
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  Points points;
  for (int i = 0; i < 10000; ++i)
  {
    points.push_back({ { uniform(random), uniform(random) } });
  }
  EXPECT_GT(CompilePolygon(points).MaximumEdgeDistance, 0);
}
