// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRescale.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTFCOutline.h"
#include "vtkTFCQuantiles.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTFCTransferFunction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Changes = std::vector<vtkTFCAttributeChange>;
using Point = vtkTFCOutline::Point;

/// How both axes change: maps of their values, and the ranges that were and are axis units.
struct AxisMaps
{
  std::array<vtkTFCValueMap, 2> Maps;
  vtkTFCOutline::Ranges Old = { { 0, 1, 0, 1 } };
  vtkTFCOutline::Ranges New = { { 0, 1, 0, 1 } };

  bool IsIdentity() const { return this->Maps[0].IsIdentity() && this->Maps[1].IsIdentity(); }
  bool IsAffine() const { return this->Maps[0].IsAffine() && this->Maps[1].IsAffine(); }

  /// A point in axis units.
  Point operator()(const Point& p) const
  {
    Point mapped;
    for (int i = 0; i < 2; ++i)
    {
      const double* from = this->Old.data() + 2 * i;
      const double* to = this->New.data() + 2 * i;
      const double value = this->Maps[i](from[0] + p[i] * (from[1] - from[0]));
      mapped[i] = (value - to[0]) / (to[1] - to[0]);
    }
    return mapped;
  }
};

//------------------------------------------------------------------------------
const vtkTFCAttributeChange* Find(const Changes& changes, const std::string& array, int component)
{
  const auto found = std::find_if(changes.begin(), changes.end(),
    [&](const vtkTFCAttributeChange& change)
    { return change.Array == array && change.Component == component; });
  return found == changes.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
// The map of a change. `range` stands for what it goes from where it does not say; null when there
// is none.
vtkTFCValueMap MakeMap(const vtkTFCAttributeChange& change, const double* range)
{
  const auto spans = [](const std::vector<double>& list)
  { return list.size() >= 2 && list.front() < list.back(); };
  if (!spans(change.To))
  {
    return {};
  }
  if (change.From.empty() && range)
  {
    return { { range[0], range[1] }, { change.To.front(), change.To.back() } };
  }
  return spans(change.From) ? vtkTFCValueMap(change.From, change.To) : vtkTFCValueMap();
}

//------------------------------------------------------------------------------
AxisMaps ChangeAxes(vtkTFCTransferFunction* model, const Changes& changes)
{
  AxisMaps maps;
  for (int axis = 0; axis < 2; ++axis)
  {
    const vtkTFCAttributeChange* change =
      Find(changes, model->GetAxisArray(axis), model->GetAxisComponent(axis));
    double range[2];
    const bool hasRange = model->GetAxisRange(axis, range);
    double* from = maps.Old.data() + 2 * axis;
    double* to = maps.New.data() + 2 * axis;
    if (hasRange)
    {
      std::copy_n(range, 2, from);
      std::copy_n(range, 2, to);
    }
    if (!change || model->GetAxisArray(axis).empty())
    {
      continue;
    }
    maps.Maps[axis] = MakeMap(*change, hasRange ? range : nullptr);
    const vtkTFCValueMap& map = maps.Maps[axis];
    model->SetAxis(axis, change->NewArray.c_str(), change->NewComponent);
    if (map.IsIdentity())
    {
      continue;
    }
    if (!hasRange)
    {
      // An automatic range was the extent of the old data, and will be that of the new.
      from[0] = change->From.front();
      from[1] = change->From.back();
    }
    to[0] = map(from[0]);
    to[1] = map(from[1]);
    if (hasRange && to[0] < to[1])
    {
      model->SetAxisRange(axis, to[0], to[1]);
    }
  }
  return maps;
}

//------------------------------------------------------------------------------
vtkTFCOutline MapOutline(vtkTFCOutline outline, const AxisMaps& maps)
{
  if (!outline.IsBox())
  {
    std::transform(outline.Points.begin(), outline.Points.end(), outline.Points.begin(), maps);
    return outline;
  }
  const double radians = outline.Angle * std::acos(-1.0) / 180;
  const Point c = outline.Center;
  std::array<Point, 4> ends;
  for (int i = 0; i < 2; ++i)
  {
    const double x = (i == 0 ? std::cos(radians) : -std::sin(radians)) * outline.HalfSize[i];
    const double y = (i == 0 ? std::sin(radians) : std::cos(radians)) * outline.HalfSize[i];
    // Along the axes exactly, so that a rectangle stays upright.
    ends[2 * i] = maps({ c[0] - x, c[1] - y });
    ends[2 * i + 1] = maps({ c[0] + x, c[1] + y });
    outline.HalfSize[i] =
      std::hypot(ends[2 * i + 1][0] - ends[2 * i][0], ends[2 * i + 1][1] - ends[2 * i][1]) / 2;
  }
  outline.Center = { 0, 0 };
  if (outline.Angle == 0)
  {
    // Each axis on its own: the other one's ends do not pull the centre.
    outline.Center = { (ends[0][0] + ends[1][0]) / 2, (ends[2][1] + ends[3][1]) / 2 };
    return outline;
  }
  for (const Point& end : ends)
  {
    outline.Center[0] += end[0] / 4;
    outline.Center[1] += end[1] / 4;
  }
  const Point a = { ends[1][0] - ends[0][0], ends[1][1] - ends[0][1] };
  const Point b = { ends[3][0] - ends[2][0], ends[3][1] - ends[2][1] };
  if (a[0] * b[1] == a[1] * b[0])
  {
    // Flattened to a line, whatever its length.
    outline.HalfSize = { 0, 0 };
  }
  outline.Angle = std::atan2(a[1], a[0]) * 180 / std::acos(-1.0);
  return outline;
}

//------------------------------------------------------------------------------
void MapNodes(vtkDoubleArray* nodes, const vtkTFCValueMap& map)
{
  vtkNew<vtkDoubleArray> mapped;
  mapped->SetNumberOfComponents(nodes->GetNumberOfComponents());
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
  {
    nodes->SetComponent(i, 0, map(nodes->GetComponent(i, 0)));
    const vtkIdType n = mapped->GetNumberOfTuples();
    if (n >= 2 && mapped->GetComponent(n - 2, 0) == nodes->GetComponent(i, 0))
    {
      mapped->SetTuple(n - 1, i, nodes);
    }
    else
    {
      mapped->InsertNextTuple(i, nodes);
    }
  }
  nodes->DeepCopy(mapped);
}

//------------------------------------------------------------------------------
void ChangeTertiary(vtkTFCRegion* region, const Changes& changes)
{
  const vtkTFCAttributeChange* change =
    Find(changes, region->GetTertiaryArray(), region->GetTertiaryComponent());
  if (!region->HasTertiary() || !change)
  {
    return;
  }
  vtkNew<vtkDoubleArray> nodes;
  vtkNew<vtkDoubleArray> colors;
  region->GetTertiaryOpacityNodes(nodes);
  region->GetTertiaryColorNodes(colors);
  double range[2];
  const bool hasRange = region->GetTertiaryRange(range);
  if (!hasRange)
  {
    range[0] = nodes->GetComponent(0, 0);
    range[1] = nodes->GetComponent(nodes->GetNumberOfTuples() - 1, 0);
  }
  const vtkTFCValueMap map = MakeMap(*change, range);
  if (!map.IsIdentity())
  {
    MapNodes(nodes, map);
    MapNodes(colors, map);
    region->ClearTertiaryRange();
  }
  region->SetTertiary(change->NewArray.c_str(), change->NewComponent, nodes,
    colors->GetNumberOfTuples() > 0 ? colors.Get() : nullptr);
  if (hasRange && !map.IsIdentity() && map(range[0]) < map(range[1]))
  {
    region->SetTertiaryRange(map(range[0]), map(range[1]));
  }
}
}

//------------------------------------------------------------------------------
int vtkTFCRescale(vtkTFCTransferFunction* model, const Changes& changes)
{
  const AxisMaps maps = ChangeAxes(model, changes);
  int vanished = 0;
  for (int i = 0; i < model->GetNumberOfRegions(); ++i)
  {
    vtkTFCRegion* region = model->GetRegion(i);
    if (!maps.IsIdentity())
    {
      const vtkTFCOutline outline = vtkTFCOutline::FromShape(region->GetShape(), maps.Old);
      // By range nothing changes in axis units.
      const vtkTFCOutline mapped = maps.IsAffine() ? outline : MapOutline(outline, maps);
      vanished += mapped.Store(region->GetShape(), maps.New) ? 0 : 1;
    }
    ChangeTertiary(region, changes);
  }
  return vanished;
}
