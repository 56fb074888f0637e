// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCClassifier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
// Samples handled at a time: the scratch arrays of a chunk stay in the first-level cache.
constexpr std::size_t ChunkSize = 256;

//------------------------------------------------------------------------------
double LinearWeight(double width, double d)
{
  return std::min(1.0, (1 - d) / width);
}

//------------------------------------------------------------------------------
double SmoothWeight(double width, double d)
{
  const double linear = LinearWeight(width, d);
  return linear * linear * (3 - 2 * linear);
}

//------------------------------------------------------------------------------
double GaussianWeight(double width, double d)
{
  // The square of a very small width is 0; then only the centre is left.
  const double square = 2 * width * width;
  return square > 0 ? std::exp(-d * d / square) : (d > 0 ? 0.0 : 1.0);
}

//------------------------------------------------------------------------------
// Normalised distance for ellipse and rectangle.
template <vtkTFCShapeType Shape>
double CenteredDistance(const vtkTFCCompiledRegion& region, double x, double y)
{
  const double dx = x - region.Center[0];
  const double dy = y - region.Center[1];
  const double u = (region.Cosine * dx + region.Sine * dy) / region.HalfSize[0];
  const double v = (region.Cosine * dy - region.Sine * dx) / region.HalfSize[1];
  return Shape == vtkTFCShapeType::Ellipse ? std::sqrt(u * u + v * v)
                                           : std::max(std::abs(u), std::abs(v));
}

//------------------------------------------------------------------------------
// Piecewise linear, ends extended; at a step the later node holds. `value` is not NaN.
template <std::size_t N>
std::array<double, N - 1> Interpolate(const std::vector<std::array<double, N>>& nodes, double value)
{
  const auto after = std::upper_bound(nodes.begin(), nodes.end(), value,
    [](double v, const std::array<double, N>& node) { return v < node[0]; });
  std::array<double, N - 1> result;
  const auto& right = after == nodes.end() ? nodes.back() : *after;
  const auto& left = after == nodes.begin() ? nodes.front() : *(after - 1);
  const double span = right[0] - left[0];
  const double t = span > 0 ? (value - left[0]) / span : 0.0;
  for (std::size_t i = 0; i + 1 < N; ++i)
  {
    result[i] = (1 - t) * left[i + 1] + t * right[i + 1];
  }
  return result;
}
}

//------------------------------------------------------------------------------
// The samples under work, and what the regions so far made of them.
struct vtkTFCClassifier::Chunk
{
  std::size_t Count = 0;
  std::array<double, ChunkSize> X; ///< axis units; NaN where no region can be
  std::array<double, ChunkSize> Y;
  std::array<double, ChunkSize> Transparency; ///< prod(1 - alpha_j)
  std::array<double, ChunkSize> Sum;          ///< of the weights of the colours
  std::array<std::array<double, ChunkSize>, 3> Color;
  std::array<double, ChunkSize> Largest; ///< contribution
  std::array<int, ChunkSize> Id;

  // Of one region: the samples within its bounding box.
  std::size_t Candidates = 0;
  std::array<unsigned short, ChunkSize> Index;
  std::array<double, ChunkSize> Weight; ///< first the normalised distance, then alpha_j
};

//------------------------------------------------------------------------------
vtkTFCClassifier::vtkTFCClassifier(vtkTFCCompiledModel model)
  : Model(std::move(model))
{
  for (const vtkTFCCompiledRegion& region : this->Model.Regions)
  {
    this->Edges.push_back(MakeEdges(region));
  }
}

//------------------------------------------------------------------------------
std::vector<vtkTFCClassifier::Edge> vtkTFCClassifier::MakeEdges(const vtkTFCCompiledRegion& region)
{
  std::vector<Edge> edges;
  const auto& points = region.Points;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
  {
    const double dx = points[i][0] - points[j][0];
    const double dy = points[i][1] - points[j][1];
    const double square = dx * dx + dy * dy;
    edges.push_back({ points[j][0], points[j][1], dx, dy, square > 0 ? 1 / square : 0.0 });
  }
  return edges;
}

//------------------------------------------------------------------------------
// Normalised distance 1 - e / maximum inside (even-odd), above 1 outside.
double vtkTFCClassifier::EdgeDistance(const std::vector<Edge>& edges, double maximum, double x,
  double y)
{
  bool inside = false;
  for (const Edge& edge : edges)
  {
    if ((edge.Y > y) != (edge.Y + edge.DY > y) && x < edge.X + (y - edge.Y) * edge.DX / edge.DY)
    {
      inside = !inside;
    }
  }
  if (!inside)
  {
    return 2;
  }
  double square = std::numeric_limits<double>::max();
  for (const Edge& edge : edges)
  {
    const double px = x - edge.X;
    const double py = y - edge.Y;
    const double t =
      std::min(1.0, std::max(0.0, (px * edge.DX + py * edge.DY) * edge.InverseSquare));
    const double qx = px - t * edge.DX;
    const double qy = py - t * edge.DY;
    square = std::min(square, qx * qx + qy * qy);
  }
  // The maximum is exact to a tolerance only; d is never negative.
  return std::max(0.0, 1 - std::sqrt(square) / maximum);
}

//------------------------------------------------------------------------------
double vtkTFCClassifier::FalloffWeight(vtkTFCFalloffType falloff, double width, double d)
{
  if (!(d <= 1))
  {
    return 0;
  }
  switch (falloff)
  {
    case vtkTFCFalloffType::Constant:
      return 1;
    case vtkTFCFalloffType::Linear:
      return LinearWeight(width, d);
    case vtkTFCFalloffType::Smooth:
      return SmoothWeight(width, d);
    case vtkTFCFalloffType::Gaussian:
      return GaussianWeight(width, d);
  }
  return 0;
}

//------------------------------------------------------------------------------
double vtkTFCClassifier::RegionWeight(const vtkTFCCompiledRegion& region, double x, double y)
{
  double d = 2;
  switch (region.Shape)
  {
    case vtkTFCShapeType::Ellipse:
      d = CenteredDistance<vtkTFCShapeType::Ellipse>(region, x, y);
      break;
    case vtkTFCShapeType::Rectangle:
      d = CenteredDistance<vtkTFCShapeType::Rectangle>(region, x, y);
      break;
    case vtkTFCShapeType::Triangle:
    case vtkTFCShapeType::Polygon:
      d = EdgeDistance(MakeEdges(region), region.MaximumEdgeDistance, x, y);
      break;
  }
  return FalloffWeight(region.Falloff, region.Width, d);
}

//------------------------------------------------------------------------------
double vtkTFCClassifier::TertiaryOpacity(const vtkTFCCompiledRegion& region, double value)
{
  if (region.Tertiary < 0 || region.TertiaryOpacity.empty())
  {
    return 1;
  }
  return std::isnan(value) ? 0 : Interpolate(region.TertiaryOpacity, value)[0];
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkTFCClassifier::TertiaryColor(const vtkTFCCompiledRegion& region,
  double value)
{
  if (region.Tertiary < 0 || region.TertiaryColor.empty() || std::isnan(value))
  {
    return region.Color;
  }
  return Interpolate(region.TertiaryColor, value);
}

//------------------------------------------------------------------------------
// Replace normalised distances by opacities. One tight loop per fall-off: the choice is made once
// per chunk, and the simple ones become vector instructions.
void vtkTFCClassifier::ApplyFalloff(const vtkTFCCompiledRegion& region, Chunk& chunk)
{
  const auto apply = [&region, &chunk](const auto& weight)
  {
    for (std::size_t k = 0; k < chunk.Candidates; ++k)
    {
      const double d = chunk.Weight[k];
      chunk.Weight[k] = d <= 1 ? region.Opacity * weight(d) : 0.0;
    }
  };
  const double width = region.Width;
  switch (region.Falloff)
  {
    case vtkTFCFalloffType::Constant:
      apply([](double) { return 1.0; });
      break;
    case vtkTFCFalloffType::Linear:
      apply([width](double d) { return LinearWeight(width, d); });
      break;
    case vtkTFCFalloffType::Smooth:
      apply([width](double d) { return SmoothWeight(width, d); });
      break;
    case vtkTFCFalloffType::Gaussian:
      apply([width](double d) { return GaussianWeight(width, d); });
      break;
  }
}

//------------------------------------------------------------------------------
void vtkTFCClassifier::ClassifyRegion(std::size_t index, const double* const* attributes,
  std::size_t first, Chunk& chunk) const
{
  const vtkTFCCompiledRegion& region = this->Model.Regions[index];
  chunk.Candidates = 0;
  for (std::size_t i = 0; i < chunk.Count; ++i)
  {
    chunk.Index[chunk.Candidates] = static_cast<unsigned short>(i);
    chunk.Candidates += chunk.X[i] >= region.Bounds[0] && chunk.X[i] <= region.Bounds[1] &&
        chunk.Y[i] >= region.Bounds[2] && chunk.Y[i] <= region.Bounds[3]
      ? 1
      : 0;
  }

  // The shape is chosen once per chunk, outside of the loops over samples.
  const auto measure = [&chunk](const auto& distance)
  {
    for (std::size_t k = 0; k < chunk.Candidates; ++k)
    {
      chunk.Weight[k] = distance(chunk.X[chunk.Index[k]], chunk.Y[chunk.Index[k]]);
    }
  };
  switch (region.Shape)
  {
    case vtkTFCShapeType::Ellipse:
      measure([&region](double x, double y)
        { return CenteredDistance<vtkTFCShapeType::Ellipse>(region, x, y); });
      break;
    case vtkTFCShapeType::Rectangle:
      measure([&region](double x, double y)
        { return CenteredDistance<vtkTFCShapeType::Rectangle>(region, x, y); });
      break;
    case vtkTFCShapeType::Triangle:
    case vtkTFCShapeType::Polygon:
      measure([this, &region, index](double x, double y)
        { return EdgeDistance(this->Edges[index], region.MaximumEdgeDistance, x, y); });
      break;
  }

  ApplyFalloff(region, chunk);
  const double* tertiary = region.Tertiary >= 0 ? attributes[region.Tertiary] + first : nullptr;
  for (std::size_t k = 0; k < chunk.Candidates; ++k)
  {
    const std::size_t i = chunk.Index[k];
    double alpha = chunk.Weight[k];
    if (!(alpha > 0))
    {
      continue;
    }
    std::array<double, 3> color = region.Color;
    if (tertiary)
    {
      alpha *= TertiaryOpacity(region, tertiary[i]);
      if (!(alpha > 0))
      {
        continue;
      }
      color = TertiaryColor(region, tertiary[i]);
    }
    const double contribution =
      this->Model.Blend == vtkTFCBlendType::Over ? alpha * chunk.Transparency[i] : alpha;
    for (int c = 0; c < 3; ++c)
    {
      chunk.Color[c][i] += contribution * color[c];
    }
    chunk.Sum[i] += contribution;
    chunk.Transparency[i] *= 1 - alpha;
    if (contribution > chunk.Largest[i])
    {
      chunk.Largest[i] = contribution;
      chunk.Id[i] = region.Id;
    }
  }
}

//------------------------------------------------------------------------------
void vtkTFCClassifier::Classify(std::size_t count, const double* const* attributes, float* rgba,
  int* regionId, float* opacity) const
{
  const auto& range = this->Model.Range;
  Chunk chunk;
  for (std::size_t first = 0; first < count; first += ChunkSize)
  {
    chunk.Count = std::min(ChunkSize, count - first);
    for (std::size_t i = 0; i < chunk.Count; ++i)
    {
      const double primary = attributes[0][first + i];
      const double secondary = attributes[1][first + i];
      // Compared in data units: rounding in axis units could let the next number beyond an end in.
      const bool inside = primary >= range[0][0] && primary <= range[0][1] &&
        secondary >= range[1][0] && secondary <= range[1][1];
      const double nan = std::numeric_limits<double>::quiet_NaN();
      chunk.X[i] = inside ? (primary - range[0][0]) / (range[0][1] - range[0][0]) : nan;
      chunk.Y[i] = inside ? (secondary - range[1][0]) / (range[1][1] - range[1][0]) : nan;
    }
    std::fill_n(chunk.Transparency.begin(), chunk.Count, 1.0);
    std::fill_n(chunk.Sum.begin(), chunk.Count, 0.0);
    std::fill_n(chunk.Largest.begin(), chunk.Count, 0.0);
    std::fill_n(chunk.Id.begin(), chunk.Count, 0);
    for (auto& channel : chunk.Color)
    {
      std::fill_n(channel.begin(), chunk.Count, 0.0);
    }

    for (std::size_t index = 0; index < this->Model.Regions.size(); ++index)
    {
      this->ClassifyRegion(index, attributes, first, chunk);
    }

    for (std::size_t i = 0; i < chunk.Count; ++i)
    {
      const float alpha = static_cast<float>(1 - chunk.Transparency[i]);
      // A division, not a factor: the inverse of a denormal sum would overflow.
      const double sum = chunk.Sum[i] > 0 ? chunk.Sum[i] : 1.0;
      if (rgba)
      {
        float* out = rgba + 4 * (first + i);
        for (int c = 0; c < 3; ++c)
        {
          out[c] = static_cast<float>(std::min(1.0, chunk.Color[c][i] / sum));
        }
        out[3] = alpha;
      }
      if (regionId)
      {
        regionId[first + i] = chunk.Id[i];
      }
      if (opacity)
      {
        opacity[first + i] = alpha;
      }
    }
  }
}
