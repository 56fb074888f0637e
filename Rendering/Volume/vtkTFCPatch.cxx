// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCPatch.h"

#include "vtkTFCClassifier.h"

#include <algorithm>
#include <cmath>

namespace
{

using Value = std::array<double, 4>;

//------------------------------------------------------------------------------
// Normalised distance of an ellipse or rectangle.
double Distance(const vtkTFCCompiledRegion& region, double x, double y)
{
  const double dx = x - region.Center[0];
  const double dy = y - region.Center[1];
  const double u = std::abs(region.Cosine * dx + region.Sine * dy) / region.HalfSize[0];
  const double v = std::abs(region.Cosine * dy - region.Sine * dx) / region.HalfSize[1];
  return region.Shape == vtkTFCShapeType::Ellipse ? std::hypot(u, v) : std::max(u, v);
}

//------------------------------------------------------------------------------
// Whether a region's weight has no jump, no kink and no strong curvature in a box. The values at a
// few points could not tell: a narrow region may lie between them.
bool IsSmooth(const vtkTFCCompiledRegion& region, const std::array<double, 4>& box)
{
  // Polygons are left out for their cost: this runs for every cell at every edit.
  if (region.Tertiary >= 0 || !region.Points.empty())
  {
    return false;
  }
  // d is convex, so it is largest in a corner, and changes by at most 1 over the smaller half size.
  const double largest =
    std::max({ Distance(region, box[0], box[2]), Distance(region, box[1], box[2]),
      Distance(region, box[0], box[3]), Distance(region, box[1], box[3]) });
  const double half = std::min(region.HalfSize[0], region.HalfSize[1]);
  const double smallest = Distance(region, 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3])) -
    0.5 * std::hypot(box[1] - box[0], box[3] - box[2]) / half;
  const double core = 1.0 - region.Width; // the weight is 1 up to here: linear and smooth
  const bool wide = region.Width * half >= 12.0 * (box[1] - box[0]) / (vtkTFCPatch::Nodes - 1);
  const bool isEllipse = region.Shape == vtkTFCShapeType::Ellipse;
  switch (region.Falloff)
  {
    case vtkTFCFalloffType::Constant:
      return largest <= 1.0;
    case vtkTFCFalloffType::Linear:
      return largest <= core ||
        (isEllipse && wide && smallest > std::max(core, 0.1) && largest <= 1.0);
    case vtkTFCFalloffType::Smooth:
      return largest <= core || (isEllipse && wide);
    case vtkTFCFalloffType::Gaussian:
      return isEllipse && wide && largest <= 1.0;
  }
  return false;
}

//------------------------------------------------------------------------------
// The blend of regions at a point, colour times opacity and opacity.
Value Blend(const vtkTFCCompiledModel& model, const std::vector<int>& regions, double x, double y)
{
  Value sum = { 0, 0, 0, 0 };
  double transparency = 1.0;
  for (const int r : regions)
  {
    const vtkTFCCompiledRegion& region = model.Regions[r];
    const double alpha = region.Opacity * vtkTFCClassifier::RegionWeight(region, x, y);
    const double share = model.Blend == vtkTFCBlendType::Over ? transparency * alpha : alpha;
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += share * region.Color[c];
    }
    sum[3] += share;
    transparency *= 1.0 - alpha;
  }
  const double scale = sum[3] > 0.0 ? (1.0 - transparency) / sum[3] : 0.0;
  return { sum[0] * scale, sum[1] * scale, sum[2] * scale, 1.0 - transparency };
}

}

//------------------------------------------------------------------------------
bool vtkTFCPatch::Fit(const vtkTFCCompiledModel& model, const std::vector<int>& regions,
  const std::array<double, 4>& box)
{
  if (static_cast<int>(regions.size()) < FewestRegions ||
    !std::all_of(regions.begin(), regions.end(),
      [&](int r) { return IsSmooth(model.Regions[r], box); }))
  {
    return false;
  }
  const double stepX = (box[1] - box[0]) / (Nodes - 1);
  const double stepY = (box[3] - box[2]) / (Nodes - 1);
  std::array<Value, Nodes * Nodes> nodes;
  double largest = 0.0;
  for (int j = 0; j < Nodes; ++j)
  {
    for (int i = 0; i < Nodes; ++i)
    {
      const Value value = Blend(model, regions, box[0] + i * stepX, box[2] + j * stepY);
      largest = std::max(largest, value[3]);
      nodes[i + Nodes * j] = value;
      std::transform(value.begin(), value.end(), this->Values[i + Nodes * j].begin(),
        [](double v) { return static_cast<float>(v); });
    }
  }
  for (int j = 0; j + 1 < Nodes; ++j)
  {
    for (int i = 0; i + 1 < Nodes; ++i)
    {
      const Value exact =
        Blend(model, regions, box[0] + (i + 0.5) * stepX, box[2] + (j + 0.5) * stepY);
      const Value* corner = &nodes[i + Nodes * j];
      for (int c = 0; c < 4; ++c)
      {
        const double middle =
          0.25 * (corner[0][c] + corner[1][c] + corner[Nodes][c] + corner[Nodes + 1][c]);
        if (std::abs(middle - exact[c]) > Tolerance * largest)
        {
          return false;
        }
      }
    }
  }
  return true;
}
