// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCState.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

const std::array<const char*, 4> vtkTFCShapeNames = { { "ellipse", "rectangle", "triangle",
  "polygon" } };
const std::array<const char*, 4> vtkTFCFalloffNames = { { "constant", "linear", "smooth",
  "gaussian" } };
const std::array<const char*, 2> vtkTFCBlendNames = { { "mix", "over" } };

//------------------------------------------------------------------------------
bool operator==(const vtkTFCAxisState& a, const vtkTFCAxisState& b)
{
  return std::tie(a.Set, a.Attribute, a.HasRange, a.Range) ==
    std::tie(b.Set, b.Attribute, b.HasRange, b.Range);
}

//------------------------------------------------------------------------------
bool operator==(const vtkTFCShapeState& a, const vtkTFCShapeState& b)
{
  return std::tie(a.Type, a.Center, a.HalfSize, a.Angle, a.Points) ==
    std::tie(b.Type, b.Center, b.HalfSize, b.Angle, b.Points);
}

//------------------------------------------------------------------------------
bool operator==(const vtkTFCTertiaryState& a, const vtkTFCTertiaryState& b)
{
  return std::tie(a.Set, a.Attribute, a.HasRange, a.Range, a.Opacity, a.Color) ==
    std::tie(b.Set, b.Attribute, b.HasRange, b.Range, b.Opacity, b.Color);
}

//------------------------------------------------------------------------------
bool operator==(const vtkTFCRegionState& a, const vtkTFCRegionState& b)
{
  return std::tie(a.Id, a.Name, a.Visible, a.Shape, a.Falloff, a.Width, a.Color, a.Opacity,
           a.Tertiary, a.Extras) ==
    std::tie(b.Id, b.Name, b.Visible, b.Shape, b.Falloff, b.Width, b.Color, b.Opacity, b.Tertiary,
      b.Extras);
}

//------------------------------------------------------------------------------
bool operator==(const vtkTFCState& a, const vtkTFCState& b)
{
  return std::tie(a.Axes, a.Blend, a.Regions, a.Extras) ==
    std::tie(b.Axes, b.Blend, b.Regions, b.Extras);
}

//------------------------------------------------------------------------------
bool vtkTFCIsNumber(double value)
{
  return std::abs(value) <= vtkTFCLimits::Number; // false for NaN
}

//------------------------------------------------------------------------------
std::string vtkTFCNumberText(double value)
{
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), end.ptr);
}

namespace
{
//------------------------------------------------------------------------------
// All points on one line, up to rounding. Each axis is scaled by the extent of the points, because
// the two have unrelated units.
bool AreCollinear(const std::vector<std::array<double, 2>>& points)
{
  std::array<double, 2> low = points[0];
  std::array<double, 2> high = points[0];
  for (const auto& point : points)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  if (low[0] == high[0] || low[1] == high[1])
  {
    return true;
  }
  const auto scaled = [&](const std::array<double, 2>& point)
  {
    return std::array<double, 2>{ { (point[0] - low[0]) / (high[0] - low[0]),
      (point[1] - low[1]) / (high[1] - low[1]) } };
  };
  // Measure from the chord to the point farthest from the first one.
  const auto origin = scaled(points[0]);
  std::array<double, 2> chord = { { 0, 0 } };
  for (const auto& point : points)
  {
    const auto q = scaled(point);
    const std::array<double, 2> d = { { q[0] - origin[0], q[1] - origin[1] } };
    if (d[0] * d[0] + d[1] * d[1] > chord[0] * chord[0] + chord[1] * chord[1])
    {
      chord = d;
    }
  }
  return std::all_of(points.begin(), points.end(),
    [&](const std::array<double, 2>& point)
    {
      const auto q = scaled(point);
      return std::abs(chord[0] * (q[1] - origin[1]) - chord[1] * (q[0] - origin[0])) <= 1e-12;
    });
}
}

//------------------------------------------------------------------------------
std::string vtkTFCCheckShape(const vtkTFCShapeState& shape, std::string* field)
{
  const auto fail = [field](const std::string& where, const std::string& what)
  {
    if (field)
    {
      *field = where;
    }
    return what;
  };
  if (shape.Type == vtkTFCShapeType::Ellipse || shape.Type == vtkTFCShapeType::Rectangle)
  {
    const char* size = shape.Type == vtkTFCShapeType::Ellipse ? "radii" : "halfsize";
    for (int axis = 0; axis < 2; ++axis)
    {
      const std::string index = "[" + std::to_string(axis) + "]";
      if (!vtkTFCIsNumber(shape.Center[axis]))
      {
        return fail("center" + index,
          "expected a finite number, got " + vtkTFCNumberText(shape.Center[axis]));
      }
      if (!(shape.HalfSize[axis] > 0) || !vtkTFCIsNumber(shape.HalfSize[axis]))
      {
        return fail(size + index,
          "expected a number > 0, got " + vtkTFCNumberText(shape.HalfSize[axis]));
      }
    }
    if (!vtkTFCIsNumber(shape.Angle))
    {
      return fail("angle",
        "expected a finite number of degrees, got " + vtkTFCNumberText(shape.Angle));
    }
    return std::string();
  }

  const size_t count = shape.Points.size();
  const std::string got = ", got " + std::to_string(count);
  if (shape.Type == vtkTFCShapeType::Triangle && count != 3)
  {
    return fail("points", "expected 3 points" + got);
  }
  if (count < 3 || count > vtkTFCLimits::Points)
  {
    return fail("points",
      "expected 3 to " + std::to_string(vtkTFCLimits::Points) + " points" + got);
  }
  for (size_t i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      if (!vtkTFCIsNumber(shape.Points[i][axis]))
      {
        return fail("points[" + std::to_string(i) + "][" + std::to_string(axis) + "]",
          "expected a finite number, got " + vtkTFCNumberText(shape.Points[i][axis]));
      }
    }
  }
  if (AreCollinear(shape.Points))
  {
    return fail("points", "expected points that enclose an area, got points on one line");
  }
  return std::string();
}

//------------------------------------------------------------------------------
template <size_t N>
std::string vtkTFCCheckNodes(const std::vector<std::array<double, N>>& nodes, std::string* field)
{
  const auto fail = [field](const std::string& where, const std::string& what)
  {
    if (field)
    {
      *field = where;
    }
    return what;
  };
  if (nodes.empty() || nodes.size() > vtkTFCLimits::Nodes)
  {
    return fail("",
      "expected 1 to " + std::to_string(vtkTFCLimits::Nodes) + " nodes, got " +
        std::to_string(nodes.size()));
  }
  for (size_t i = 0; i < nodes.size(); ++i)
  {
    const std::string index = "[" + std::to_string(i) + "]";
    if (!vtkTFCIsNumber(nodes[i][0]))
    {
      return fail(index + "[0]", "expected a finite number, got " + vtkTFCNumberText(nodes[i][0]));
    }
    for (size_t k = 1; k < N; ++k)
    {
      if (!(nodes[i][k] >= 0 && nodes[i][k] <= 1))
      {
        return fail(index + "[" + std::to_string(k) + "]",
          "expected a number in [0, 1], got " + vtkTFCNumberText(nodes[i][k]));
      }
    }
    if (i > 0 && nodes[i][0] < nodes[i - 1][0])
    {
      return fail(index + "[0]",
        "expected values in increasing order, got " + vtkTFCNumberText(nodes[i][0]) + " after " +
          vtkTFCNumberText(nodes[i - 1][0]));
    }
    if (i > 1 && nodes[i][0] == nodes[i - 2][0])
    {
      return fail(index + "[0]",
        "expected at most two nodes (a step) at one value, got a third at " +
          vtkTFCNumberText(nodes[i][0]));
    }
  }
  return std::string();
}

template std::string vtkTFCCheckNodes<2>(const std::vector<std::array<double, 2>>&, std::string*);
template std::string vtkTFCCheckNodes<4>(const std::vector<std::array<double, 4>>&, std::string*);
