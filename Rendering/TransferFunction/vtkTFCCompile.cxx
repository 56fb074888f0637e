// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCState.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Ranges = std::array<std::array<double, 2>, 2>;

//------------------------------------------------------------------------------
double ToAxis(double value, const std::array<double, 2>& range)
{
  return (value - range[0]) / (range[1] - range[0]);
}

//------------------------------------------------------------------------------
void CompileCentered(const vtkTFCShapeState& shape, const Ranges& used, vtkTFCCompiledRegion& out)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    out.Center[axis] = ToAxis(shape.Center[axis], used[axis]);
    out.HalfSize[axis] = shape.HalfSize[axis] / (used[axis][1] - used[axis][0]);
  }
  // Multiples of 90 degrees exactly, so that an upright outline has upright edges.
  const double angle = std::remainder(shape.Angle, 360.0);
  const double radians = angle * 3.14159265358979323846 / 180.0;
  const bool quarter = std::remainder(angle, 90.0) == 0;
  out.Cosine = quarter ? std::round(std::cos(radians)) : std::cos(radians);
  out.Sine = quarter ? std::round(std::sin(radians)) : std::sin(radians);

  const double c = std::abs(out.Cosine);
  const double s = std::abs(out.Sine);
  const double hx = out.HalfSize[0];
  const double hy = out.HalfSize[1];
  const bool ellipse = shape.Type == vtkTFCShapeType::Ellipse;
  double ex = ellipse ? std::hypot(hx * c, hy * s) : hx * c + hy * s;
  double ey = ellipse ? std::hypot(hx * s, hy * c) : hx * s + hy * c;
  // The rounding of the rotation must not put a point of the border outside.
  const double slack = 8 * std::numeric_limits<double>::epsilon();
  ex += slack * (ex + std::abs(out.Center[0]));
  ey += slack * (ey + std::abs(out.Center[1]));
  out.Bounds = { { out.Center[0] - ex, out.Center[0] + ex, out.Center[1] - ey,
    out.Center[1] + ey } };
}

//------------------------------------------------------------------------------
void CompilePoints(const vtkTFCShapeState& shape, const Ranges& used, vtkTFCCompiledRegion& out,
  const vtkTFCPoleCache* before, vtkTFCPoleCache* after)
{
  out.Bounds = { { HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL } };
  for (const auto& point : shape.Points)
  {
    const std::array<double, 2> p = { { ToAxis(point[0], used[0]), ToAxis(point[1], used[1]) } };
    out.Points.push_back(p);
    for (int axis = 0; axis < 2; ++axis)
    {
      out.Bounds[2 * axis] = std::min(out.Bounds[2 * axis], p[axis]);
      out.Bounds[2 * axis + 1] = std::max(out.Bounds[2 * axis + 1], p[axis]);
    }
  }
  if (shape.Type == vtkTFCShapeType::Triangle)
  {
    const auto& p = out.Points;
    const double area = std::abs(
      (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
    double perimeter = 0;
    for (int i = 0; i < 3; ++i)
    {
      perimeter += std::hypot(p[(i + 1) % 3][0] - p[i][0], p[(i + 1) % 3][1] - p[i][1]);
    }
    out.MaximumEdgeDistance = area / perimeter; // the inradius: twice the area over the perimeter
    return;
  }
  if (before)
  {
    const auto known = before->find(out.Points);
    if (known != before->end())
    {
      out.MaximumEdgeDistance = known->second;
      after->insert(*known);
      return;
    }
  }
  out.MaximumEdgeDistance = vtkTFCMaximumEdgeDistance(out.Points);
  if (after)
  {
    after->emplace(out.Points, out.MaximumEdgeDistance);
  }
}

//------------------------------------------------------------------------------
// False for geometry that axis units cannot hold: a radius far below or above the axis.
bool IsUsable(const vtkTFCCompiledRegion& region)
{
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(region.Bounds.begin(), region.Bounds.end(), finite))
  {
    return false;
  }
  if (region.Shape == vtkTFCShapeType::Ellipse || region.Shape == vtkTFCShapeType::Rectangle)
  {
    return region.HalfSize[0] > 0 && region.HalfSize[1] > 0;
  }
  return std::isfinite(region.MaximumEdgeDistance) && region.MaximumEdgeDistance > 0;
}
}

//------------------------------------------------------------------------------
std::vector<vtkTFCAttribute> vtkTFCCollectAttributes(const vtkTFCState& state)
{
  std::vector<vtkTFCAttribute> attributes = { state.Axes[0].Attribute, state.Axes[1].Attribute };
  for (const vtkTFCRegionState& region : state.Regions)
  {
    // Also those of opacity 0, which compile to nothing: the attributes on the graphics card then
    // do not change while an opacity passes through 0.
    if (region.Visible && region.Tertiary.Set &&
      std::find(attributes.begin(), attributes.end(), region.Tertiary.Attribute) ==
        attributes.end())
    {
      attributes.push_back(region.Tertiary.Attribute);
    }
  }
  return attributes;
}

//------------------------------------------------------------------------------
vtkTFCCompiledModel vtkTFCCompileState(const vtkTFCState& state, const Ranges& used,
  vtkTFCPoleCache* cache)
{
  vtkTFCCompiledModel model;
  model.Attributes = vtkTFCCollectAttributes(state);
  model.Range = used;
  model.Blend = state.Blend;
  vtkTFCPoleCache kept;
  for (const vtkTFCRegionState& region : state.Regions)
  {
    if (!region.Visible)
    {
      continue;
    }
    vtkTFCCompiledRegion out;
    if (region.Tertiary.Set)
    {
      out.Tertiary = static_cast<int>(
        std::find(model.Attributes.begin(), model.Attributes.end(), region.Tertiary.Attribute) -
        model.Attributes.begin());
      out.TertiaryOpacity = region.Tertiary.Opacity;
      out.TertiaryColor = region.Tertiary.Color;
    }
    out.Id = region.Id;
    out.Shape = region.Shape.Type;
    out.Falloff = region.Falloff;
    out.Width = region.Width;
    out.Color = region.Color;
    out.Opacity = region.Opacity;
    if (out.Shape == vtkTFCShapeType::Ellipse || out.Shape == vtkTFCShapeType::Rectangle)
    {
      CompileCentered(region.Shape, used, out);
    }
    else
    {
      CompilePoints(region.Shape, used, out, cache, cache ? &kept : nullptr);
    }
    if (region.Opacity > 0 && IsUsable(out))
    {
      model.Regions.push_back(std::move(out));
    }
  }
  if (cache)
  {
    *cache = std::move(kept);
  }
  return model;
}
