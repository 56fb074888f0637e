// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCShaderTables.h"

#include "vtkTFCPatch.h"
#include "vtkTFCRegionExtent.h"
#include "vtkTFCThreads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <unordered_map>

namespace
{

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

CellRange CellsOf(double minimum, double maximum, int size)
{
  // The shader finds its cell in single precision: widen by more than that rounding.
  constexpr double margin = 1e-5;
  if (!(maximum + margin >= 0.0 && minimum - margin <= 1.0))
  {
    return { 0, -1 };
  }
  const double first = std::floor((minimum - margin) * size);
  const double last = std::floor((maximum + margin) * size);
  return { static_cast<int>(std::clamp(first, 0.0, size - 1.0)),
    static_cast<int>(std::clamp(last, 0.0, size - 1.0)) };
}

//------------------------------------------------------------------------------
// Sets of regions that share a cell, as a tree: a set is its parent and one region more. Equal sets
// are one set, so their records are written once.
class RegionSets
{
public:
  RegionSets() { this->Sets.push_back({ 0, -1, 0 }); }

  int Add(int set, int region)
  {
    const auto key = static_cast<std::uint64_t>(set) << 32 | static_cast<std::uint32_t>(region);
    const auto [place, isNew] = this->Children.emplace(key, static_cast<int>(this->Sets.size()));
    if (isNew)
    {
      this->Sets.push_back({ set, region, this->Sets[set].Size + 1 });
    }
    return place->second;
  }

  std::vector<int> GetRegions(int set) const
  {
    std::vector<int> regions(this->Sets[set].Size);
    for (auto r = regions.rbegin(); r != regions.rend(); ++r)
    {
      *r = this->Sets[set].Region;
      set = this->Sets[set].Parent;
    }
    return regions;
  }

  int GetSize(int set) const { return this->Sets[set].Size; }
  int GetNumberOfSets() const { return static_cast<int>(this->Sets.size()); }

private:
  struct Set
  {
    int Parent;
    int Region;
    int Size;
  };
  std::vector<Set> Sets;
  std::unordered_map<std::uint64_t, int> Children;
};

//------------------------------------------------------------------------------
// The set of every cell of a grid of size x size.
std::vector<int> FindSets(const vtkTFCCompiledModel& model, int size, RegionSets& sets)
{
  std::vector<int> cells(static_cast<size_t>(size) * size, 0);
  // The shader finds its cell in single precision: widen by more than that rounding.
  constexpr double margin = 1e-5;
  for (size_t r = 0; r < model.Regions.size(); ++r)
  {
    const auto& bounds = model.Regions[r].Bounds;
    const CellRange x = CellsOf(bounds[0], bounds[1], size);
    const CellRange y = CellsOf(bounds[2], bounds[3], size);
    for (int j = y.First; j <= y.Last; ++j)
    {
      int from = -1;
      int to = -1;
      for (int i = x.First; i <= x.Last; ++i)
      {
        if (vtkTFCMayOverlap(model.Regions[r],
              { static_cast<double>(i) / size - margin, (i + 1.0) / size + margin,
                static_cast<double>(j) / size - margin, (j + 1.0) / size + margin }))
        {
          int& cell = cells[static_cast<size_t>(j) * size + i];
          if (cell != from)
          {
            from = cell;
            to = sets.Add(cell, static_cast<int>(r));
          }
          cell = to;
        }
      }
    }
  }
  return cells;
}

//------------------------------------------------------------------------------
// The linear pieces of opacity times tertiary function in stored units, and the buckets that point
// into them. Returns the first bucket.
int WriteFunction(const vtkTFCCompiledRegion& region, const vtkTFCStoredAttribute& stored,
  std::vector<Texel>& texels)
{
  constexpr int buckets = vtkTFCShaderTables::Buckets;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto first = static_cast<int>(texels.size());
  const int firstPiece = first + buckets;
  std::vector<Texel> pieces;
  const auto add = [&](double a, double b, float end)
  {
    pieces.push_back(MakeTexel(region.Opacity * a, region.Opacity * b, end,
      firstPiece + static_cast<double>(pieces.size()) + 1));
  };
  if (region.Tertiary < 0)
  {
    add(1.0, 0.0, infinity);
  }
  else
  {
    const auto& nodes = region.TertiaryOpacity;
    std::vector<float> values; // as the shader compares them
    values.reserve(nodes.size());
    for (const auto& node : nodes)
    {
      values.push_back(static_cast<float>((node[0] - stored.Offset) / stored.Scale));
    }
    add(nodes.front()[1], 0.0, values.front());
    for (size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      const double span = static_cast<double>(values[i + 1]) - values[i];
      if (span > 0.0)
      {
        const double slope = (nodes[i + 1][1] - nodes[i][1]) / span;
        add(nodes[i][1] - slope * values[i], slope, values[i + 1]);
      }
    }
    add(nodes.back()[1], 0.0, infinity);
  }

  size_t piece = 0;
  for (int i = 0; i < buckets; ++i)
  {
    // The first bucket is also for what is below; rounding may choose the next one too early.
    while (i > 0 && pieces[piece][2] <= (i - 0.01) / buckets)
    {
      ++piece;
    }
    texels.push_back(pieces[piece]);
  }
  texels.insert(texels.end(), pieces.begin(), pieces.end());
  return first;
}

//------------------------------------------------------------------------------
// A region's record; its edges and functions are appended to the list.
std::array<Texel, vtkTFCShaderTables::RecordTexels> MakeRecord(const vtkTFCCompiledRegion& region,
  const std::vector<vtkTFCStoredAttribute>& stored, bool tertiaries, std::vector<Texel>& texels)
{
  std::array<Texel, vtkTFCShaderTables::RecordTexels> record;
  const double type = static_cast<int>(region.Shape) + 4 * static_cast<int>(region.Falloff);
  if (region.Shape == vtkTFCShapeType::Ellipse || region.Shape == vtkTFCShapeType::Rectangle)
  {
    const auto& half = region.HalfSize;
    record[0] =
      MakeTexel(region.Center[0], region.Center[1], region.Cosine / half[0], region.Sine / half[0]);
    record[1] =
      MakeTexel(-region.Sine / half[1], region.Cosine / half[1], 1.0 / region.Width, type);
  }
  else
  {
    const auto& points = region.Points;
    record[0] = MakeTexel(static_cast<double>(texels.size()), static_cast<double>(points.size()),
      1.0 / region.MaximumEdgeDistance);
    record[1] = MakeTexel(0, 0, 1.0 / region.Width, type);
    for (size_t i = 0; i < points.size(); ++i)
    {
      const auto& a = points[i];
      const auto& b = points[(i + 1) % points.size()];
      texels.push_back(MakeTexel(a[0], a[1], b[0], b[1]));
    }
  }
  const auto& color = region.Color;
  record[2] = MakeTexel(region.Opacity, color[0], color[1], color[2]);
  if (tertiaries)
  {
    static const vtkTFCStoredAttribute none;
    const auto& attribute = region.Tertiary >= 0 ? stored[region.Tertiary] : none;
    const auto first = static_cast<double>(texels.size());
    for (const auto& node : region.TertiaryColor)
    {
      texels.push_back(
        MakeTexel((node[0] - attribute.Offset) / attribute.Scale, node[1], node[2], node[3]));
    }
    texels.push_back(MakeTexel(first, static_cast<double>(region.TertiaryColor.size())));
    record[2][0] = static_cast<float>(WriteFunction(region, attribute, texels));
    record[1][3] += static_cast<float>(16 * attribute.Channel);
  }
  return record;
}

//------------------------------------------------------------------------------
// The patches of the cells that can have one; null for the others.
std::vector<std::unique_ptr<vtkTFCPatch>> FitPatches(const vtkTFCCompiledModel& model, int size,
  const std::vector<int>& cells, const std::vector<std::vector<int>>& members)
{
  std::vector<std::unique_ptr<vtkTFCPatch>> patches(cells.size());
  vtkTFCThreads::For(0, static_cast<vtkIdType>(cells.size()), 256,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const auto& regions = members[cells[cell]];
        const vtkIdType column = cell % size, row = cell / size;
        const double x = static_cast<double>(column), y = static_cast<double>(row);
        vtkTFCPatch patch;
        if (!regions.empty() &&
          patch.Fit(model, regions, { x / size, (x + 1) / size, y / size, (y + 1) / size }))
        {
          patches[cell] = std::make_unique<vtkTFCPatch>(patch);
        }
      }
    });
  return patches;
}

//------------------------------------------------------------------------------
unsigned int FindFeatures(const vtkTFCCompiledModel& model)
{
  unsigned int features = model.Regions.size() > 1 ? vtkTFCShaderTables::SeveralRegions : 0;
  for (const auto& region : model.Regions)
  {
    features |=
      region.Shape == vtkTFCShapeType::Triangle || region.Shape == vtkTFCShapeType::Polygon
      ? vtkTFCShaderTables::Polygons
      : 0;
    features |= region.Falloff == vtkTFCFalloffType::Gaussian ? vtkTFCShaderTables::Gaussians : 0;
    features |= region.Tertiary >= 0 ? vtkTFCShaderTables::Tertiaries : 0;
    features |= region.Tertiary >= 0 && !region.TertiaryColor.empty()
      ? vtkTFCShaderTables::TertiaryColors
      : 0;
  }
  return features;
}

}

//------------------------------------------------------------------------------
vtkTFCShaderTables vtkTFCShaderTables::Build(const vtkTFCCompiledModel& model,
  const std::vector<vtkTFCStoredAttribute>& stored, unsigned int features)
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
  }

  tables.FeaturesUsed = features | FindFeatures(model);
  const bool hasMore = std::any_of(stored.begin(), stored.end(),
    [](const vtkTFCStoredAttribute& attribute) { return attribute.Channel > 3; });
  tables.FeaturesUsed |= hasMore ? MoreAttributes : 0;
  const bool hasTertiaries = tables.FeaturesUsed & Tertiaries;

  // Where very many regions overlap in very many ways, a coarser grid keeps the list short.
  RegionSets sets;
  std::vector<int> cells;
  size_t records = 0;
  for (tables.GridSize = LargestGridSize;; tables.GridSize /= 2)
  {
    sets = RegionSets();
    cells = FindSets(model, tables.GridSize, sets);
    std::vector<char> used(sets.GetNumberOfSets(), 0);
    records = 0;
    for (const int set : cells)
    {
      records += used[set] ? 0 : sets.GetSize(set);
      used[set] = 1;
    }
    if (records <= LargestNumberOfRecords || tables.GridSize == 1)
    {
      break;
    }
  }

  auto& texels = tables.Texels;
  texels.resize(cells.size(), MakeTexel(0));
  std::vector<std::array<Texel, RecordTexels>> regions;
  for (const auto& region : model.Regions)
  {
    regions.push_back(MakeRecord(region, stored, hasTertiaries, texels));
  }
  texels.reserve(texels.size() + RecordTexels * (records + 1));
  if (regions.size() == 1)
  {
    tables.FirstRecord = static_cast<int>(texels.size());
    texels.insert(texels.end(), regions[0].begin(), regions[0].end());
  }
  std::vector<std::vector<int>> members;
  members.reserve(static_cast<size_t>(sets.GetNumberOfSets()));
  for (int set = 0; set < sets.GetNumberOfSets(); ++set)
  {
    members.push_back(
      sets.GetSize(set) < vtkTFCPatch::FewestRegions ? std::vector<int>() : sets.GetRegions(set));
  }
  const auto patches = FitPatches(model, tables.GridSize, cells, members);
  std::vector<int> places(sets.GetNumberOfSets(), -1);
  for (size_t cell = 0; cell < cells.size(); ++cell)
  {
    const int set = cells[cell];
    if (patches[cell])
    {
      tables.FeaturesUsed |= Patches;
      texels[cell] = MakeTexel(0, 0, static_cast<double>(texels.size()), 1);
      texels.insert(texels.end(), patches[cell]->Values.begin(), patches[cell]->Values.end());
      continue;
    }
    if (sets.GetSize(set) == 0)
    {
      continue;
    }
    if (places[set] < 0)
    {
      places[set] = static_cast<int>(texels.size());
      for (const int region : sets.GetRegions(set))
      {
        texels.insert(texels.end(), regions[region].begin(), regions[region].end());
      }
    }
    texels[cell] = MakeTexel(places[set], places[set] + RecordTexels * sets.GetSize(set), 0, 1);
  }
  return tables;
}
