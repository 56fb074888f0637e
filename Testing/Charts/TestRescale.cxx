// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions fitted to other data: identity, affine data, and shapes under curved maps.
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTFCOutline.h"
#include "vtkTFCQuantiles.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRescale.h"
#include "vtkTFCShape.h"
#include "vtkTFCTransferFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using Point = vtkTFCOutline::Point;
using Function = std::function<double(double)>;

const char* const STATE = R"({"format": "transfer-function-combination", "version": 1,
  "primary": {"array": "P", "range": [0, 10]}, "secondary": {"array": "S", "range": [-2, 2]},
  "regions": [
    {"id": 1, "shape": {"type": "rectangle", "center": [4, 0], "halfsize": [2, 1]},
     "tertiary": {"array": "T", "range": [0, 1], "opacity": [[0, 0], [0.5, 0], [0.5, 1], [1, 1]],
                  "color": [[0, 1, 0, 0], [1, 0, 0, 1]]}},
    {"id": 2, "shape": {"type": "ellipse", "center": [6, 1], "radii": [2, 0.5], "angle": 30},
     "tertiary": {"array": "P", "opacity": [[1, 0], [3, 1]]}},
    {"id": 3, "shape": {"type": "polygon", "points": [[1, -1], [5, -1.5], [9, 1], [2, 1.5]]}}]})";

std::vector<double> Even(double low, double high, int n = vtkTFCQuantiles::Number)
{
  std::vector<double> list;
  for (int i = 0; i < n; ++i)
  {
    list.push_back(low + (high - low) * i / (n - 1));
  }
  return list;
}

std::vector<double> Mapped(const std::vector<double>& list, const Function& f)
{
  std::vector<double> mapped;
  for (double v : list)
  {
    mapped.push_back(f(v));
  }
  return mapped;
}

// By quantile (of evenly distributed data) or by range, for new data that are f of the old.
std::vector<vtkTFCAttributeChange> Changes(const Function& f, bool byQuantile)
{
  std::vector<vtkTFCAttributeChange> changes;
  for (const auto& range : { std::make_pair("P", Even(0, 10)), std::make_pair("S", Even(-2, 2)),
         std::make_pair("T", Even(0, 1)) })
  {
    const auto& all = range.second;
    const std::vector<double> from =
      byQuantile ? all : std::vector<double>{ all.front(), all.back() };
    changes.push_back(
      { range.first, 0, std::string("new ") + range.first, 1, from, Mapped(from, f) });
  }
  return changes;
}

double Affine(double v)
{
  return 3 + 0.5 * v;
}

// All numbers of a model: ranges, outlines in data units, nodes.
std::vector<double> Numbers(vtkTFCTransferFunction* model)
{
  std::vector<double> numbers(4);
  model->GetAxisRange(0, numbers.data());
  model->GetAxisRange(1, numbers.data() + 2);
  const vtkTFCOutline::Ranges ranges = { { numbers[0], numbers[1], numbers[2], numbers[3] } };
  for (int i = 0; i < model->GetNumberOfRegions(); ++i)
  {
    vtkTFCRegion* region = model->GetRegion(i);
    for (const Point& p : vtkTFCOutline::FromShape(region->GetShape(), ranges).GetPolyline())
    {
      numbers.push_back(ranges[0] + p[0] * (ranges[1] - ranges[0]));
      numbers.push_back(ranges[2] + p[1] * (ranges[3] - ranges[2]));
    }
    vtkNew<vtkDoubleArray> nodes;
    region->GetTertiaryOpacityNodes(nodes);
    for (vtkIdType n = 0; n < nodes->GetNumberOfTuples(); ++n)
    {
      numbers.push_back(nodes->GetComponent(n, 0));
    }
  }
  return numbers;
}
}

TEST(Rescale, KeepsTheStateOfTheSameData)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(STATE));
  const std::string before = model->GetState();
  for (bool byQuantile : { false, true })
  {
    auto changes = Changes([](double v) { return v; }, byQuantile);
    for (auto& change : changes)
    {
      change.NewArray = change.Array;
      change.NewComponent = 0;
    }
    EXPECT_EQ(vtkTFCRescale(model, changes), 0);
    EXPECT_EQ(model->GetState(), before);
  }
}

TEST(Rescale, ChangesNamesAloneWithoutValues)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(STATE));
  const auto before = Numbers(model);
  vtkTFCRescale(model, { { "P", 0, "Q", -1, {}, {} } });
  EXPECT_EQ(model->GetAxisArray(0), "Q");
  EXPECT_EQ(model->GetAxisComponent(0), -1);
  EXPECT_EQ(model->GetAxisArray(1), "S");
  EXPECT_EQ(model->GetRegion(1)->GetTertiaryArray(), "Q");
  EXPECT_EQ(model->GetRegion(0)->GetTertiaryArray(), "T");
  EXPECT_EQ(Numbers(model), before);
}

TEST(Rescale, OfAffineDataByQuantileIsThatByRange)
{
  vtkNew<vtkTFCTransferFunction> original;
  vtkNew<vtkTFCTransferFunction> byRange;
  vtkNew<vtkTFCTransferFunction> byQuantile;
  for (vtkTFCTransferFunction* model : { original.Get(), byRange.Get(), byQuantile.Get() })
  {
    ASSERT_TRUE(model->SetState(STATE));
  }
  EXPECT_EQ(vtkTFCRescale(byRange, Changes(Affine, false)), 0);
  EXPECT_EQ(vtkTFCRescale(byQuantile, Changes(Affine, true)), 0);
  EXPECT_EQ(byRange->GetAxisArray(0), "new P");
  const auto before = Numbers(original);
  const auto range = Numbers(byRange);
  const auto quantile = Numbers(byQuantile);
  ASSERT_EQ(range.size(), before.size());
  ASSERT_EQ(quantile.size(), before.size());
  for (size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_NEAR(range[i], Affine(before[i]), 1e-9) << i;
    EXPECT_NEAR(quantile[i], Affine(before[i]), 1e-9) << i;
  }
}

TEST(Rescale, MapsCornersSidesAndNodesByQuantile)
{
  const Function f = [](double v) { return v * v * v; };
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(STATE));
  auto changes = Changes(f, true);
  EXPECT_EQ(vtkTFCRescale(model, changes), 0);
  const auto old = Even(0, 10);
  const vtkTFCValueMap p(old, Mapped(old, f));
  const vtkTFCValueMap s(Even(-2, 2), Mapped(Even(-2, 2), f));
  const vtkTFCOutline::Ranges ranges = { { 0, 1000, -8, 8 } };
  double range[2];
  ASSERT_TRUE(model->GetAxisRange(0, range));
  EXPECT_EQ(range[1], 1000);
  const auto box = vtkTFCOutline::FromShape(model->GetRegion(0)->GetShape(), ranges).GetBounds();
  EXPECT_NEAR(1000 * box[0], p(2), 1e-9);
  EXPECT_NEAR(1000 * box[1], p(6), 1e-9);
  EXPECT_NEAR(-8 + 16 * box[2], s(-1), 1e-9);
  EXPECT_NEAR(-8 + 16 * box[3], s(1), 1e-9);
  const auto polygon = vtkTFCOutline::FromShape(model->GetRegion(2)->GetShape(), ranges);
  EXPECT_NEAR(1000 * polygon.Points[1][0], p(5), 1e-9);
  EXPECT_NEAR(-8 + 16 * polygon.Points[1][1], s(-1.5), 1e-9);
  vtkNew<vtkDoubleArray> nodes;
  model->GetRegion(0)->GetTertiaryOpacityNodes(nodes);
  ASSERT_EQ(nodes->GetNumberOfTuples(), 4);
  EXPECT_NEAR(nodes->GetComponent(1, 0), 0.125, 1e-9);
  EXPECT_EQ(nodes->GetComponent(1, 0), nodes->GetComponent(2, 0));
  EXPECT_EQ(nodes->GetComponent(2, 1), 1);
}

TEST(Rescale, MapsTheEndsOfATurnedEllipse)
{
  // The first axis in axis units, before and after; only the secondary axis is curved.
  const Function f = [](double v) { return std::exp(v); };
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(STATE));
  const auto from = Even(-2, 2);
  const auto old = vtkTFCOutline::FromShape(model->GetRegion(1)->GetShape(), { { 0, 10, -2, 2 } });
  vtkTFCRescale(model, { { "S", 0, "S", 0, from, Mapped(from, f) } });
  const double low = f(-2);
  const double high = f(2);
  const auto now =
    vtkTFCOutline::FromShape(model->GetRegion(1)->GetShape(), { { 0, 10, low, high } });
  const vtkTFCValueMap map(from, Mapped(from, f));
  const auto y = [&](double axis) { return (map(-2 + 4 * axis) - low) / (high - low); };
  const double turn = std::acos(-1.0) / 6;
  const double dx = old.HalfSize[0] * std::cos(turn);
  const double dy = old.HalfSize[0] * std::sin(turn);
  const double rise = y(old.Center[1] + dy) - y(old.Center[1] - dy);
  EXPECT_NEAR(now.HalfSize[0], std::hypot(2 * dx, rise) / 2, 1e-9);
  EXPECT_NEAR(now.Angle, std::atan2(rise, 2 * dx) * 180 / std::acos(-1.0), 1e-9);
  EXPECT_NEAR(now.Center[0], old.Center[0], 1e-9);
}

TEST(Rescale, TakesTheRangeOfTheAxisOrTheNodesWithoutOldData)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(STATE));
  vtkTFCRescale(model, { { "P", 0, "P", 0, {}, { 100, 200 } }, { "T", 0, "T", 0, {}, { 5, 6 } } });
  double range[2];
  ASSERT_TRUE(model->GetAxisRange(0, range));
  EXPECT_EQ(range[0], 100);
  EXPECT_EQ(range[1], 200);
  // Nodes of region 2 from 1 to 3, without a range of their own.
  vtkNew<vtkDoubleArray> nodes;
  model->GetRegion(1)->GetTertiaryOpacityNodes(nodes);
  EXPECT_EQ(nodes->GetComponent(0, 0), 100);
  EXPECT_EQ(nodes->GetComponent(1, 0), 200);
  model->GetRegion(0)->GetTertiaryOpacityNodes(nodes);
  EXPECT_EQ(nodes->GetComponent(1, 0), 5.5);
  // An automatic axis says nothing about the old data.
  model->ClearAxisRange(1);
  const auto before = Numbers(model);
  vtkTFCRescale(model, { { "S", 0, "S", 0, {}, { 7, 9 } } });
  EXPECT_FALSE(model->HasAxisRange(1));
  EXPECT_EQ(Numbers(model), before);
}

TEST(Rescale, KeepsShapesThatWouldVanish)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(STATE));
  const vtkTFCOutline::Ranges ranges = { { 0, 10, -2, 2 } };
  const auto before = vtkTFCOutline::FromShape(model->GetRegion(0)->GetShape(), ranges);
  // All of 1 to 9 has one value.
  EXPECT_EQ(vtkTFCRescale(model, { { "P", 0, "P", 0, { 0, 1, 9, 10 }, { 0, 5, 5, 10 } } }), 3);
  const auto after = vtkTFCOutline::FromShape(model->GetRegion(0)->GetShape(), ranges);
  EXPECT_EQ(after.HalfSize, before.HalfSize);
  vtkNew<vtkTFCTransferFunction> copy;
  EXPECT_TRUE(copy->SetState(model->GetState().c_str()));
}

TEST(Rescale, KeepsTheEndsOfNodesThatMeet)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(STATE));
  vtkNew<vtkDoubleArray> nodes;
  nodes->SetNumberOfComponents(2);
  for (double v : { 0., 0.3, 0.4, 0.6, 1. })
  {
    nodes->InsertNextTuple2(v, v);
  }
  ASSERT_TRUE(model->GetRegion(0)->SetTertiary("T", 0, nodes));
  vtkTFCRescale(model, { { "T", 0, "T", 0, { 0, 0.2, 0.8, 1 }, { 0, 3, 3, 4 } } });
  model->GetRegion(0)->GetTertiaryOpacityNodes(nodes);
  ASSERT_EQ(nodes->GetNumberOfTuples(), 4);
  EXPECT_EQ(nodes->GetComponent(1, 0), 3);
  EXPECT_EQ(nodes->GetComponent(1, 1), 0.3);
  EXPECT_EQ(nodes->GetComponent(2, 0), 3);
  EXPECT_EQ(nodes->GetComponent(2, 1), 0.6);
}
