// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRegionExtent.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
bool vtkTFCMayOverlap(const vtkTFCCompiledRegion& region, const std::array<double, 4>& box)
{
  const auto& bounds = region.Bounds;
  if (!(box[0] <= bounds[1] && box[1] >= bounds[0] && box[2] <= bounds[3] && box[3] >= bounds[2]))
  {
    return false;
  }
  if (region.Shape != vtkTFCShapeType::Ellipse && region.Shape != vtkTFCShapeType::Rectangle)
  {
    return true;
  }
  // The box in the frame where the shape is the unit circle or square: centre and reach of its
  // projections, made a little larger against rounding.
  const double x = 0.5 * (box[0] + box[1]) - region.Center[0];
  const double y = 0.5 * (box[2] + box[3]) - region.Center[1];
  const double halfX = 0.5 * (box[1] - box[0]);
  const double halfY = 0.5 * (box[3] - box[2]);
  const double c = region.Cosine;
  const double s = region.Sine;
  const double u = std::abs(c * x + s * y) - std::abs(c) * halfX - std::abs(s) * halfY;
  const double v = std::abs(c * y - s * x) - std::abs(s) * halfX - std::abs(c) * halfY;
  const double du = std::max(0.0, u) / region.HalfSize[0];
  const double dv = std::max(0.0, v) / region.HalfSize[1];
  constexpr double one = 1.0 + 1e-9;
  return region.Shape == vtkTFCShapeType::Ellipse ? du * du + dv * dv <= one
                                                  : du <= one && dv <= one;
}

//------------------------------------------------------------------------------
std::vector<std::array<double, 2>> vtkTFCPositiveIntervals(const vtkTFCCompiledRegion& region)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& nodes = region.TertiaryOpacity;
  if (region.Tertiary < 0 || nodes.empty())
  {
    return { { -infinity, infinity } };
  }
  std::vector<std::array<double, 2>> intervals;
  const auto add = [&intervals](double begin, double end)
  {
    if (!intervals.empty() && intervals.back()[1] >= begin)
    {
      intervals.back()[1] = end;
    }
    else
    {
      intervals.push_back({ begin, end });
    }
  };
  if (nodes.front()[1] > 0.0)
  {
    add(-infinity, nodes.front()[0]);
  }
  for (size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    if (nodes[i][1] > 0.0 || nodes[i + 1][1] > 0.0)
    {
      add(nodes[i][0], nodes[i + 1][0]);
    }
  }
  if (nodes.back()[1] > 0.0)
  {
    add(nodes.back()[0], infinity);
  }
  return intervals;
}
