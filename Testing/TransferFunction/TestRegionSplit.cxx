// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTFCRegionSplit on volumes whose best attribute and cut are known.
#include "ModelTesting.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionSplit.h"
#include "vtkTable.h"

#include <cmath>
#include <functional>
#include <random>

using namespace ModelTesting;

namespace
{
// P and S spread over the axes. T has two parts where P < 5, one elsewhere; U has one everywhere; C
// is constant; W is T, ten times as large, as the first component of a vector.
vtkSmartPointer<vtkImageData> Volume()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(40, 40, 40);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal(0, 1);
  vtkNew<vtkDoubleArray> p, s, t, u, c, w;
  w->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double x = 10 * unit(random);
    p->InsertNextValue(x);
    s->InsertNextValue(2 * unit(random) - 1);
    const double center = x >= 5 ? 50 : unit(random) < 0.25 ? 80 : 20;
    t->InsertNextValue(i % 97 == 0 ? std::nan("") : center + 6 * normal(random));
    u->InsertNextValue(normal(random));
    c->InsertNextValue(3);
    w->InsertNextTuple2(10 * t->GetValue(i), 1);
  }
  const std::vector<std::pair<const char*, vtkDoubleArray*>> arrays = { { "P", p }, { "S", s },
    { "T", t }, { "U", u }, { "C", c }, { "W", w } };
  for (const auto& array : arrays)
  {
    array.second->SetName(array.first);
    image->GetPointData()->AddArray(array.second);
  }
  return image;
}

const std::string Halves = State(
  R"({"id": 7, "name": "left", "shape": {"type": "rectangle", "center": [2, 0],
    "halfsize": [2, 1]}, "opacity": 0.1},
  {"id": 3, "name": "right", "shape": {"type": "rectangle", "center": [8, 0],
    "halfsize": [2, 1]}},
  {"id": 5, "name": "nothing", "shape": {"type": "rectangle", "center": [50, 0],
    "halfsize": [2, 1]}})");

vtkTable* Compute(vtkTFCRegionSplit* filter, vtkDataObject* input, const std::string& state)
{
  filter->SetInputDataObject(input);
  filter->SetTransferFunction(state.c_str());
  filter->Update();
  return filter->GetOutput();
}

double Number(vtkTable* table, int row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

std::string Text(vtkTable* table, int row, const char* column)
{
  return table->GetValueByName(row, column).ToString();
}
}

TEST(RegionSplit, BestAttributeAndCutPerRegion)
{
  const auto volume = Volume();
  vtkNew<vtkTFCRegionSplit> filter;
  vtkTable* table = Compute(filter, volume, Halves);
  ASSERT_EQ(table->GetNumberOfRows(), 9) << "T, U and C in three regions";
  EXPECT_EQ(Number(table, 0, "region"), 7);
  EXPECT_EQ(Text(table, 0, "region_name"), "left");
  EXPECT_EQ(Text(table, 0, "attribute"), "T");
  EXPECT_EQ(Number(table, 0, "rank"), 1);
  EXPECT_GT(Number(table, 0, "power"), 0.85);
  EXPECT_NEAR(Number(table, 0, "cut"), 52, 10);
  EXPECT_NEAR(Number(table, 0, "below"), 0.75, 0.02);
  EXPECT_EQ(Text(table, 1, "attribute"), "U");
  EXPECT_LT(Number(table, 1, "power"), 0.1);
  EXPECT_EQ(Text(table, 2, "attribute"), "C");
  EXPECT_EQ(Number(table, 2, "rank"), 0);
  EXPECT_TRUE(std::isnan(Number(table, 2, "power")));
  EXPECT_EQ(Text(table, 2, "keep_above"), "");
  // Where T has one part it is no better than U.
  EXPECT_EQ(Number(table, 3, "region"), 3);
  EXPECT_LT(Number(table, 3, "power"), 0.1);
  EXPECT_GT(Number(table, 3, "voxels"), 10000);
  for (int row = 6; row < 9; ++row)
  {
    EXPECT_EQ(Number(table, row, "rank"), 0) << "no voxels";
    EXPECT_EQ(Number(table, row, "voxels"), 0);
  }
}

TEST(RegionSplit, CutIsReadyForTheState)
{
  const auto volume = Volume();
  vtkNew<vtkTFCRegionSplit> filter;
  vtkTable* table = Compute(filter, volume, Halves);
  for (const bool above : { true, false })
  {
    const std::string tertiary = Text(table, 0, above ? "keep_above" : "keep_below");
    const std::string state = State(Everywhere(1, 1, "[1, 1, 1]", tertiary));
    EXPECT_EQ(Evaluate(state, { 5, 0, 80 }).Opacity, above ? 1.f : 0.f);
    EXPECT_EQ(Evaluate(state, { 5, 0, 20 }).Opacity, above ? 0.f : 1.f);
    EXPECT_NEAR(Evaluate(state, { 5, 0, Number(table, 0, "cut") }).Opacity, 0.5, 1e-6);
  }
}

TEST(RegionSplit, NamedArraysAndBlocks)
{
  const auto volume = Volume();
  vtkNew<vtkTFCRegionSplit> filter, named;
  vtkTable* table = Compute(filter, volume, Halves);
  named->AddArray("W:0");
  named->AddArray("S");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, volume);
  blocks->SetBlock(1, volume);
  vtkTable* other = Compute(named, blocks, Halves);
  ASSERT_EQ(other->GetNumberOfRows(), 3) << "an axis is not tried";
  EXPECT_EQ(Text(other, 0, "attribute"), "W");
  EXPECT_NEAR(Number(other, 0, "cut"), 10 * Number(table, 0, "cut"), 1e-9 + 8);
  EXPECT_NEAR(Number(other, 0, "voxels"), 2 * Number(table, 0, "voxels"), 1);
  // Only the regions change: the kept histograms give what new ones do.
  vtkNew<vtkTFCRegionSplit> fresh;
  const std::string moved = State(R"({"id": 7, "shape": {"type": "ellipse", "center": [3, 0.2],
    "radii": [1, 0.5]}})");
  vtkTable* a = Compute(filter, volume, moved);
  vtkTable* b = Compute(fresh, volume, moved);
  ASSERT_EQ(a->GetNumberOfRows(), 3);
  EXPECT_EQ(Number(a, 0, "cut"), Number(b, 0, "cut"));
  EXPECT_EQ(Number(a, 0, "voxels"), Number(b, 0, "voxels"));
}

TEST(RegionSplit, CanBeAborted)
{
  const auto volume = Volume();
  vtkNew<vtkTFCRegionSplit> filter;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(Compute(filter, volume, Halves)->GetNumberOfRows(), 0);
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 9) << "and then again";
}

TEST(RegionSplit, BadInput)
{
  const auto fails = [](const std::function<void(vtkTFCRegionSplit*)>& change, const char* word,
                       vtkImageData* input, const std::string& state = Halves)
  {
    vtkNew<vtkTFCRegionSplit> filter;
    Catcher catcher(filter);
    change(filter);
    EXPECT_EQ(Compute(filter, input, state)->GetNumberOfRows(), 0);
    EXPECT_NE(catcher.Errors.find(word), std::string::npos) << word << " in " << catcher.Errors;
  };
  const auto volume = Volume();
  fails([](auto* f) { f->AddArray("nobody"); }, "'nobody'", volume);
  fails([](auto* f) { f->AddArray("W"); }, "'W:0' to 'W:1'", volume);
  fails([](auto* f) { f->SetNumberOfBins(4); }, "NumberOfBins is 4", volume);
  fails([](auto*) {}, "lacks an axis", volume, "");
  fails([](auto*) {}, "input is empty", vtkSmartPointer<vtkImageData>::New());
  const auto axesOnly = Volume();
  for (const char* name : { "T", "U", "C" })
  {
    axesOnly->GetPointData()->RemoveArray(name);
  }
  fails([](auto*) {}, "no attribute to try", axesOnly);
}
