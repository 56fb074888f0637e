// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCLasso.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
using Point = vtkTFCOutline::Point;
using Stroke = std::vector<Point>;

double Cross(const Point& a, const Point& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

bool Crossing(const Point& a, const Point& b, const Point& c, const Point& d, Point& where)
{
  const Point r = { b[0] - a[0], b[1] - a[1] };
  const Point s = { d[0] - c[0], d[1] - c[1] };
  const double denominator = Cross(r, s);
  if (denominator == 0)
  {
    return false;
  }
  const Point offset = { c[0] - a[0], c[1] - a[1] };
  const double t = Cross(offset, s) / denominator;
  const double u = Cross(offset, r) / denominator;
  where = { a[0] + t * r[0], a[1] + t * r[1] };
  return t >= 0 && t <= 1 && u >= 0 && u <= 1;
}

void CutTails(Stroke& stroke)
{
  const size_t n = stroke.size();
  const size_t quarter = n / 4;
  for (size_t i = 0; i + 1 < quarter; ++i)
  {
    for (size_t j = n - quarter; j + 1 < n; ++j)
    {
      Point where;
      if (Crossing(stroke[i], stroke[i + 1], stroke[j], stroke[j + 1], where))
      {
        Stroke cut(stroke.begin() + i + 1, stroke.begin() + j + 1);
        cut.push_back(where);
        stroke.swap(cut);
        return;
      }
    }
  }
}

double SegmentDistance(const Point& p, const Point& a, const Point& b)
{
  const Point d = { b[0] - a[0], b[1] - a[1] };
  const double length = d[0] * d[0] + d[1] * d[1];
  const double t =
    length > 0 ? std::clamp(((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / length, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - t * d[0], p[1] - a[1] - t * d[1]);
}

// Marks what stays of the open line between two kept points. An explicit stack: the recursion can
// be as deep as the stroke is long.
void Keep(const Stroke& line, size_t first, size_t last, double tolerance, std::vector<char>& kept)
{
  std::vector<std::pair<size_t, size_t>> parts = { { first, last } };
  while (!parts.empty())
  {
    const auto [a, b] = parts.back();
    parts.pop_back();
    double largest = tolerance;
    size_t farthest = 0;
    for (size_t i = a + 1; i < b; ++i)
    {
      const double distance = SegmentDistance(line[i], line[a], line[b]);
      if (distance > largest)
      {
        largest = distance;
        farthest = i;
      }
    }
    if (farthest)
    {
      kept[farthest] = 1;
      parts.emplace_back(a, farthest);
      parts.emplace_back(farthest, b);
    }
  }
}

Stroke Simplify(const Stroke& stroke, double tolerance)
{
  // The closed line in two halves, from the first point to the one that is farthest from it.
  size_t farthest = 0;
  double largest = 0;
  for (size_t i = 0; i < stroke.size(); ++i)
  {
    const double d = std::hypot(stroke[i][0] - stroke[0][0], stroke[i][1] - stroke[0][1]);
    if (d > largest)
    {
      largest = d;
      farthest = i;
    }
  }
  Stroke closed = stroke;
  closed.push_back(stroke[0]);
  std::vector<char> kept(closed.size(), 0);
  kept[0] = kept[farthest] = 1;
  Keep(closed, 0, farthest, tolerance, kept);
  Keep(closed, farthest, closed.size() - 1, tolerance, kept);
  Stroke result;
  for (size_t i = 0; i < stroke.size(); ++i)
  {
    if (kept[i])
    {
      result.push_back(stroke[i]);
    }
  }
  return result;
}

// Of the even-odd inside, by a scan over the crossings of 64 horizontal lines: the signed area of a
// figure of eight is 0.
double EvenOddArea(const Stroke& line)
{
  const auto [low, high] = std::minmax_element(line.begin(), line.end(),
    [](const Point& a, const Point& b) { return a[1] < b[1]; });
  constexpr int rows = 64;
  const double height = ((*high)[1] - (*low)[1]) / rows;
  double area = 0;
  std::vector<double> crossings;
  for (int row = 0; row < rows; ++row)
  {
    const double y = (*low)[1] + (row + 0.5) * height;
    crossings.clear();
    for (size_t i = 0, j = line.size() - 1; i < line.size(); j = i++)
    {
      if ((line[i][1] > y) != (line[j][1] > y))
      {
        crossings.push_back(
          line[i][0] + (line[j][0] - line[i][0]) * (y - line[i][1]) / (line[j][1] - line[i][1]));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (size_t i = 0; i + 1 < crossings.size(); i += 2)
    {
      area += (crossings[i + 1] - crossings[i]) * height;
    }
  }
  return area;
}
}

std::vector<Point> vtkTFCSimplifyLasso(Stroke stroke, double tolerance, double smallestArea,
  std::size_t most)
{
  stroke.erase(std::remove_if(stroke.begin(), stroke.end(),
                 [](const Point& p) { return !std::isfinite(p[0]) || !std::isfinite(p[1]); }),
    stroke.end());
  stroke.erase(std::unique(stroke.begin(), stroke.end()), stroke.end());
  while (stroke.size() > 1 && stroke.back() == stroke.front())
  {
    stroke.pop_back();
  }
  if (stroke.size() < 3)
  {
    return {};
  }
  CutTails(stroke);
  Stroke result = stroke;
  for (double t = tolerance; result.size() >= 3; t *= 2)
  {
    result = Simplify(stroke, t);
    if (result.size() <= most)
    {
      break;
    }
  }
  if (result.size() < 3 || EvenOddArea(result) < smallestArea)
  {
    return {};
  }
  return result;
}
