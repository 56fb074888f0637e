// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCShaderTables.h"

#include <algorithm>
#include <cmath>

namespace
{

constexpr int GridSize = vtkTFCShaderTables::GridSize;
using Texel = std::array<float, 4>;

Texel MakeTexel(double x, double y = 0, double z = 0, double w = 0)
{
  return { static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
    static_cast<float>(w) };
}

//------------------------------------------------------------------------------
// Cells [first, last] that an interval in axis units touches; empty (first > last) outside [0, 1].
struct CellRange
{
  int First;
  int Last;
};

CellRange CellsOf(double minimum, double maximum)
{
  // The shader finds its cell in single precision: widen by more than that rounding.
  constexpr double margin = 1e-5;
  if (!(maximum + margin >= 0.0 && minimum - margin <= 1.0))
  {
    return { 0, -1 };
  }
  const double first = std::floor((minimum - margin) * GridSize);
  const double last = std::floor((maximum + margin) * GridSize);
  return { static_cast<int>(std::clamp(first, 0.0, GridSize - 1.0)),
    static_cast<int>(std::clamp(last, 0.0, GridSize - 1.0)) };
}

//------------------------------------------------------------------------------
// Candidate lists of all cells, in list order: positions in model.Regions.
std::vector<std::vector<int>> FindCandidates(const vtkTFCCompiledModel& model)
{
  std::vector<std::vector<int>> candidates(static_cast<size_t>(GridSize) * GridSize);
  for (size_t r = 0; r < model.Regions.size(); ++r)
  {
    const auto& bounds = model.Regions[r].Bounds;
    const CellRange x = CellsOf(bounds[0], bounds[1]);
    const CellRange y = CellsOf(bounds[2], bounds[3]);
    for (int j = y.First; j <= y.Last; ++j)
    {
      for (int i = x.First; i <= x.Last; ++i)
      {
        candidates[static_cast<size_t>(j) * GridSize + i].push_back(static_cast<int>(r));
      }
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
// Appends edges and nodes behind everything else and hands out their positions.
class Appender
{
public:
  explicit Appender(int base)
    : Base(base)
  {
  }

  int Edges(const std::vector<std::array<double, 2>>& points)
  {
    const int first = this->Next();
    for (size_t i = 0; i < points.size(); ++i)
    {
      const auto& a = points[i];
      const auto& b = points[(i + 1) % points.size()];
      this->Texels.push_back(MakeTexel(a[0], a[1], b[0], b[1]));
    }
    return first;
  }

  template <size_t N>
  int Nodes(const std::vector<std::array<double, N>>& nodes, const vtkTFCStoredAttribute& stored)
  {
    const int first = this->Next();
    for (const auto& node : nodes)
    {
      Texel texel = MakeTexel((node[0] - stored.Offset) / stored.Scale);
      for (size_t c = 1; c < N; ++c)
      {
        texel[c] = static_cast<float>(node[c]);
      }
      this->Texels.push_back(texel);
    }
    return first;
  }

  std::vector<Texel> Texels;

private:
  int Next() const { return this->Base + static_cast<int>(this->Texels.size()); }
  int Base;
};

//------------------------------------------------------------------------------
void WriteRegion(const vtkTFCCompiledRegion& region,
  const std::vector<vtkTFCStoredAttribute>& stored, Texel* texels, Appender& appender)
{
  texels[0] = MakeTexel(static_cast<int>(region.Shape) + 4 * static_cast<int>(region.Falloff),
    region.Width, region.Opacity, 0);
  texels[2] = MakeTexel(0, 0, -1, 0);
  texels[3] = MakeTexel(region.Color[0], region.Color[1], region.Color[2], 0);
  if (region.Shape == vtkTFCShapeType::Ellipse || region.Shape == vtkTFCShapeType::Rectangle)
  {
    texels[1] = MakeTexel(region.Center[0], region.Center[1], region.Cosine, region.Sine);
    texels[2][0] = static_cast<float>(1.0 / region.HalfSize[0]);
    texels[2][1] = static_cast<float>(1.0 / region.HalfSize[1]);
  }
  else
  {
    texels[1] = MakeTexel(appender.Edges(region.Points), static_cast<double>(region.Points.size()),
      1.0 / region.MaximumEdgeDistance);
  }
  if (region.Tertiary >= 0)
  {
    const vtkTFCStoredAttribute& attribute = stored[region.Tertiary];
    texels[2][2] = static_cast<float>(attribute.Channel);
    texels[2][3] = static_cast<float>(appender.Nodes(region.TertiaryOpacity, attribute));
    texels[3][3] = static_cast<float>(region.TertiaryOpacity.size());
    appender.Nodes(region.TertiaryColor, attribute);
    texels[0][3] = static_cast<float>(region.TertiaryColor.size());
  }
}

}

//------------------------------------------------------------------------------
vtkTFCShaderTables vtkTFCShaderTables::Build(const vtkTFCCompiledModel& model,
  const std::vector<vtkTFCStoredAttribute>& stored)
{
  vtkTFCShaderTables tables;
  tables.BlendOver = model.Blend == vtkTFCBlendType::Over;
  for (int axis = 0; axis < 2; ++axis)
  {
    // In double: offsets and ranges may be large and close together.
    const auto& range = model.Range[axis];
    const double extent = range[1] - range[0];
    tables.AxisScale[axis] = static_cast<float>(stored[axis].Scale / extent);
    tables.AxisBias[axis] = static_cast<float>((stored[axis].Offset - range[0]) / extent);
    tables.AxisChannel[axis] = static_cast<float>(stored[axis].Channel);
  }

  const auto candidates = FindCandidates(model);
  size_t numberOfCandidates = 0;
  for (const auto& cell : candidates)
  {
    numberOfCandidates += cell.size();
  }
  tables.CandidateBase = GridSize * GridSize;
  const int regionBase = tables.CandidateBase + static_cast<int>((numberOfCandidates + 3) / 4);
  const int tailBase = regionBase + RegionTexels * static_cast<int>(model.Regions.size());
  tables.Texels.resize(tailBase, MakeTexel(0));

  int entry = 0;
  for (size_t cell = 0; cell < candidates.size(); ++cell)
  {
    tables.Texels[cell] = MakeTexel(entry, static_cast<double>(candidates[cell].size()));
    for (const int region : candidates[cell])
    {
      tables.Texels[tables.CandidateBase + entry / 4][entry % 4] =
        static_cast<float>(regionBase + RegionTexels * region);
      ++entry;
    }
  }

  Appender appender(tailBase);
  for (size_t r = 0; r < model.Regions.size(); ++r)
  {
    WriteRegion(model.Regions[r], stored, &tables.Texels[regionBase + RegionTexels * r], appender);
  }
  tables.Texels.insert(tables.Texels.end(), appender.Texels.begin(), appender.Texels.end());

  const size_t rows = (tables.Texels.size() + RowLength - 1) / RowLength;
  tables.Texels.resize(rows * RowLength, MakeTexel(0));
  return tables;
}
