// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pole of inaccessibility of an outline, in two parts that need each other: branch and bound
// over square cells says where the largest distance can be, and a monotone local search makes a
// good point exact. The bound prunes well only when the best point so far is good, so the search
// runs on every improvement.
#include "vtkTFCState.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace
{
using Point = std::array<double, 2>;

struct Edge
{
  Point A;
  Point D;              ///< from A to the other end
  double InverseSquare; ///< 1 / |D|^2, or 0
};

//------------------------------------------------------------------------------
class Outline
{
public:
  explicit Outline(const std::vector<Point>& points)
  {
    for (size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
    {
      const Point d = { { points[i][0] - points[j][0], points[i][1] - points[j][1] } };
      const double square = d[0] * d[0] + d[1] * d[1];
      // Two equal points in a row make no edge; with fewer than three there is no inside anyway.
      if (square > 0)
      {
        this->Edges.push_back({ points[j], d, 1 / square });
      }
    }
  }

  static Point Nearest(const Edge& edge, const Point& p)
  {
    const double along =
      ((p[0] - edge.A[0]) * edge.D[0] + (p[1] - edge.A[1]) * edge.D[1]) * edge.InverseSquare;
    const double t = std::min(1.0, std::max(0.0, along));
    return { { edge.A[0] + t * edge.D[0], edge.A[1] + t * edge.D[1] } };
  }

  /// Distance to the nearest edge, negative outside.
  double SignedDistance(const Point& p) const
  {
    double square = HUGE_VAL;
    bool inside = false;
    for (const Edge& edge : this->Edges)
    {
      const Point q = Nearest(edge, p);
      const double dx = p[0] - q[0];
      const double dy = p[1] - q[1];
      square = std::min(square, dx * dx + dy * dy);
      const double endY = edge.A[1] + edge.D[1];
      if ((edge.A[1] > p[1]) != (endY > p[1]) &&
        p[0] < edge.A[0] + (p[1] - edge.A[1]) * edge.D[0] / edge.D[1])
      {
        inside = !inside;
      }
    }
    return inside ? std::sqrt(square) : -std::sqrt(square);
  }

  double Improve(Point& p) const;

  std::vector<Edge> Edges;
};

//------------------------------------------------------------------------------
// Move p uphill. The distance to an edge is convex, so its linearisation at p is never above it:
// the point that maximises the least linearisation is at least as good as p and on the same side of
// every edge. That is a linear program in (x, y, t), solved by bisection on t over the polygon
// that the half-planes leave of a box. Steps repeat until they gain nothing.
double Outline::Improve(Point& p) const
{
  double best = this->SignedDistance(p);
  struct HalfPlane
  {
    Point Normal;
    double Offset; ///< value is Normal * (q - p) + Offset
  };
  std::vector<HalfPlane> planes;
  std::vector<Point> polygon;
  std::vector<Point> clipped;
  for (int step = 0; step < 60 && best > 0; ++step)
  {
    // No point within `reach` can gain more than that, so edges beyond never matter.
    const double reach = best;
    planes.clear();
    for (const Edge& edge : this->Edges)
    {
      const Point q = Nearest(edge, p);
      const double distance = std::hypot(p[0] - q[0], p[1] - q[1]);
      if (distance > 0 && distance <= best + 4 * reach)
      {
        planes.push_back({ { { (p[0] - q[0]) / distance, (p[1] - q[1]) / distance } }, distance });
      }
    }
    const auto feasible = [&](double t)
    {
      polygon = { { { -reach, -reach } }, { { reach, -reach } }, { { reach, reach } },
        { { -reach, reach } } };
      for (const HalfPlane& plane : planes)
      {
        clipped.clear();
        for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        {
          const Point& a = polygon[j];
          const Point& b = polygon[i];
          const double va = plane.Normal[0] * a[0] + plane.Normal[1] * a[1] + plane.Offset - t;
          const double vb = plane.Normal[0] * b[0] + plane.Normal[1] * b[1] + plane.Offset - t;
          if ((va < 0) != (vb < 0))
          {
            const double s = va / (va - vb);
            clipped.push_back({ { a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]) } });
          }
          if (vb >= 0)
          {
            clipped.push_back(b);
          }
        }
        polygon.swap(clipped);
        if (polygon.empty())
        {
          return false;
        }
      }
      return true;
    };
    double low = best;
    double high = best + 1.5 * reach;
    Point move = { { 0, 0 } };
    for (int i = 0; i < 60 && high - low > 1e-14 * best; ++i)
    {
      const double middle = 0.5 * (low + high);
      if (feasible(middle))
      {
        low = middle;
        move = { { 0, 0 } };
        for (const Point& corner : polygon)
        {
          move[0] += corner[0] / static_cast<double>(polygon.size());
          move[1] += corner[1] / static_cast<double>(polygon.size());
        }
      }
      else
      {
        high = middle;
      }
    }
    const Point next = { { p[0] + move[0], p[1] + move[1] } };
    const double value = this->SignedDistance(next);
    const double gain = value - best;
    if (gain > 0)
    {
      p = next;
      best = value;
    }
    if (!(gain > 1e-13 * best))
    {
      break;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
// Points that are inside whatever the outline looks like: the middles of the inside intervals of
// some horizontal lines, each between two neighbouring heights of vertices. Slivers that are
// thinner than any affordable cell still get one.
std::vector<Point> InsidePoints(const std::vector<Point>& points, const Outline& outline)
{
  std::vector<double> heights;
  heights.reserve(points.size());
  for (const Point& point : points)
  {
    heights.push_back(point[1]);
  }
  std::sort(heights.begin(), heights.end());
  std::vector<double> lines;
  constexpr size_t wanted = 16;
  for (size_t k = 0; k < wanted; ++k)
  {
    // The widest gap within this share of the heights.
    const size_t begin = k * (heights.size() - 1) / wanted;
    const size_t end = std::max(begin + 1, (k + 1) * (heights.size() - 1) / wanted);
    size_t widest = begin;
    for (size_t i = begin; i < end; ++i)
    {
      widest = heights[i + 1] - heights[i] > heights[widest + 1] - heights[widest] ? i : widest;
    }
    lines.push_back(0.5 * (heights[widest] + heights[widest + 1]));
  }
  std::vector<Point> result;
  std::vector<double> crossings;
  std::vector<Point> intervals; // width, middle
  for (const double y : lines)
  {
    crossings.clear();
    for (const Edge& edge : outline.Edges)
    {
      if ((edge.A[1] > y) != (edge.A[1] + edge.D[1] > y))
      {
        crossings.push_back(edge.A[0] + (y - edge.A[1]) * edge.D[0] / edge.D[1]);
      }
    }
    std::sort(crossings.begin(), crossings.end());
    // The widest intervals only: an outline that crosses itself a lot has thousands.
    intervals.clear();
    for (size_t i = 0; i + 1 < crossings.size(); i += 2)
    {
      intervals.push_back(
        { { crossings[i + 1] - crossings[i], 0.5 * (crossings[i] + crossings[i + 1]) } });
    }
    std::sort(intervals.rbegin(), intervals.rend());
    for (size_t i = 0; i < std::min<size_t>(8, intervals.size()); ++i)
    {
      result.push_back({ { intervals[i][1], y } });
    }
  }
  return result;
}

struct Cell
{
  Point Center;
  double Half;     ///< of its side
  double Distance; ///< signed, at the centre
  double Bound;    ///< no point of the cell is farther from the edges
  bool operator<(const Cell& other) const { return this->Bound < other.Bound; }
};
}

//------------------------------------------------------------------------------
double vtkTFCMaximumEdgeDistance(const std::vector<std::array<double, 2>>& points)
{
  Point low = points[0];
  Point high = points[0];
  for (const Point& point : points)
  {
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
    {
      return 0;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  // In units of the box's longer side: no square below overflows or vanishes.
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  if (!(size > 0) || !std::isfinite(size))
  {
    return 0;
  }
  std::vector<Point> scaled;
  scaled.reserve(points.size());
  for (const Point& point : points)
  {
    scaled.push_back({ { (point[0] - low[0]) / size, (point[1] - low[1]) / size } });
  }
  const Outline outline(scaled);
  if (outline.Edges.size() < 3)
  {
    return 0;
  }

  double best = 0;
  Point bestPoint = { { 0, 0 } };
  const auto consider = [&](Point p, double distance)
  {
    if (distance > best)
    {
      best = std::max(distance, outline.Improve(p));
      bestPoint = p;
    }
  };
  for (const Point& p : InsidePoints(scaled, outline))
  {
    consider(p, outline.SignedDistance(p));
  }

  // Enough for any outline that a hand draws; slivers and hostile outlines end with the best point
  // so far, which the local search has made a maximum.
  const long edges = static_cast<long>(outline.Edges.size());
  long budget = std::min(20000L, std::max(2000L, 30000000L / edges));
  std::priority_queue<Cell> cells;
  const auto push = [&](const Point& center, double half)
  {
    const double distance = outline.SignedDistance(center);
    --budget;
    consider(center, distance);
    cells.push({ center, half, distance, distance + half * std::sqrt(2.0) });
  };
  const double width = (high[0] - low[0]) / size;
  const double height = (high[1] - low[1]) / size;
  const double side = std::max(std::min(width, height), 1.0 / 512);
  for (double x = 0; x < width; x += side)
  {
    for (double y = 0; y < height; y += side)
    {
      push({ { x + 0.5 * side, y + 0.5 * side } }, 0.5 * side);
    }
  }
  constexpr double tolerance = 2e-4;
  while (!cells.empty() && budget > 0)
  {
    const Cell cell = cells.top();
    cells.pop();
    // For slivers the tolerance shrinks with them, as far as the budget goes.
    if (cell.Bound <= best + tolerance * std::min(1.0, 40 * best))
    {
      break;
    }
    const double half = 0.5 * cell.Half;
    for (int k = 0; k < 4; ++k)
    {
      push({ { cell.Center[0] + ((k & 1) ? half : -half),
             cell.Center[1] + ((k & 2) ? half : -half) } },
        half);
    }
  }
  return best * size;
}
