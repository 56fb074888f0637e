// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTFCClassificationQuality against counting by hand, what it leaves out, threads, bad input.
#include "ModelTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTFCClassificationQuality.h"
#include "vtkTFCClassify.h"
#include "vtkTFCQualityCounts.h"
#include "vtkTable.h"
#include "vtkUniformGrid.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

using namespace ModelTesting;

namespace
{
using Extent = std::array<int, 6>;

vtkSmartPointer<vtkDataArray> MakeArray(int type, const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfTuples(count);
  return array;
}

// Random P, S and T, a few of them NaN or infinite, and labels that depend on them and on chance.
vtkSmartPointer<vtkUniformGrid> Volume(const Extent& extent, int labelType = VTK_SHORT)
{
  auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->SetExtent(const_cast<int*>(extent.data()));
  const vtkIdType count = grid->GetNumberOfPoints();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto p = MakeArray(VTK_DOUBLE, "P", count);
  const auto s = MakeArray(VTK_DOUBLE, "S", count);
  const auto t = MakeArray(VTK_FLOAT, "T", count);
  const auto labels = MakeArray(labelType, "truth", count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double x = 12 * unit(random) - 1;
    const double y = 2.4 * unit(random) - 1.2;
    const double z = 100 * unit(random);
    const int label = unit(random) < 0.1 ? 90 : x + 3 * y > 6 ? 3 : z > 60 ? 70 : 11;
    p->SetComponent(i, 0, i % 53 == 5 ? std::nan("") : x);
    s->SetComponent(i, 0, i % 61 == 7 ? HUGE_VAL : y);
    t->SetComponent(i, 0, i % 47 == 3 ? std::nan("") : i % 43 == 9 ? -HUGE_VAL : z);
    labels->SetComponent(i, 0, label);
  }
  for (const auto& array : { p, s, t, labels })
  {
    grid->GetPointData()->AddArray(array);
  }
  return grid;
}

std::string VolumeState()
{
  return State(
    R"({"id": 12, "name": "tall", "shape": {"type": "rectangle", "center": [2, 0],
      "halfsize": [3, 0.8]}, "opacity": 0.7,
      "tertiary": {"array": "T", "opacity": [[50, 0], [60, 1]]}},
    {"id": 4, "name": "corner", "shape": {"type": "polygon",
      "points": [[3, 1], [10, -1], [10, 1]]}},
    {"id": 6, "visible": false, "shape": {"type": "ellipse", "center": [5, 0],
      "radii": [1, 1]}})");
}

using Filter = vtkNew<vtkTFCClassificationQuality>;

void Measure(vtkTFCClassificationQuality* filter, vtkDataObject* input, const std::string& state,
  const char* labels = "truth")
{
  filter->SetInputDataObject(input);
  filter->SetLabelArray(labels);
  filter->SetTransferFunction(state.c_str());
  filter->Update();
}

double Number(vtkTFCClassificationQuality* filter, int port, vtkIdType row, const char* column)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
  return table->GetValueByName(row, column).ToDouble();
}

std::string Text(vtkTFCClassificationQuality* filter, vtkIdType row, const char* column)
{
  return filter->GetOutput()->GetValueByName(row, column).ToString();
}

// label -> region -> voxels, with what vtkTFCClassify says.
using Counts = std::map<int, std::map<int, double>>;
Counts Count(vtkUniformGrid* grid, const std::string& state, const std::set<int>& ignored)
{
  vtkNew<vtkTFCClassify> classify;
  classify->SetInputDataObject(grid);
  classify->SetTransferFunction(state.c_str());
  classify->Update();
  auto* output = vtkDataSet::SafeDownCast(classify->GetOutputDataObject(0))->GetPointData();
  Counts counts;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const int label = static_cast<int>(output->GetArray("truth")->GetComponent(i, 0));
    if (ignored.count(label) == 0 && grid->IsPointVisible(i))
    {
      ++counts[label][static_cast<int>(output->GetArray("tfc_region")->GetComponent(i, 0))];
    }
  }
  return counts;
}

void CheckTables(vtkTFCClassificationQuality* filter, Counts counts)
{
  ASSERT_EQ(filter->GetOutput()->GetNumberOfRows(), static_cast<vtkIdType>(counts.size()));
  std::map<int, double> sizes;
  for (auto& label : counts)
  {
    for (const int id : { 0, 12, 4 })
    {
      sizes[id] += label.second[id];
    }
  }
  vtkIdType row = 0;
  for (auto& label : counts)
  {
    auto& of = label.second;
    const double total = of[0] + of[12] + of[4];
    EXPECT_EQ(Number(filter, 0, row, "label"), label.first);
    EXPECT_EQ(Number(filter, 1, row, "label"), label.first);
    EXPECT_EQ(Number(filter, 0, row, "voxels"), total);
    EXPECT_EQ(Number(filter, 1, row, "none"), of[0]);
    EXPECT_EQ(Number(filter, 1, row, "region 12"), of[12]);
    EXPECT_EQ(Number(filter, 1, row, "region 4"), of[4]);
    const double dice12 = 2 * of[12] / (total + sizes[12]);
    const double dice4 = 2 * of[4] / (total + sizes[4]);
    const int best = dice4 > dice12 ? 4 : 12;
    EXPECT_EQ(Number(filter, 0, row, "region"), best);
    EXPECT_EQ(Text(filter, row, "region_name"), best == 4 ? "corner" : "tall");
    EXPECT_DOUBLE_EQ(Number(filter, 0, row, "dice"), std::max(dice4, dice12));
    EXPECT_DOUBLE_EQ(Number(filter, 0, row, "precision"), of[best] / sizes[best]);
    EXPECT_DOUBLE_EQ(Number(filter, 0, row, "recall"), of[best] / total);
    EXPECT_NEAR(Number(filter, 0, row, "leakage"), 1 - of[best] / sizes[best], 1e-12);
    ++row;
  }
}

// The attainable coefficients from their definition, with every threshold tried.
double Attainable(vtkUniformGrid* grid, int wanted, int bins, bool third)
{
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  auto* data = grid->GetPointData();
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double t = data->GetArray("T")->GetComponent(i, 0);
    low = std::isfinite(t) ? std::min(low, t) : low;
    high = std::isfinite(t) ? std::max(high, t) : high;
  }
  double best = 0;
  for (int width = 1; (bins + width - 1) / width >= 4; width *= 2)
  {
    std::map<std::array<int, 3>, std::array<double, 4>> cells; // label and all, of both halves
    double total = 0;
    std::array<double, 2> totals = { { 0, 0 } };
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const auto bin = [&](double v, double from, double to) {
        return std::max(0, std::min(bins - 1, static_cast<int>((v - from) / (to - from) * bins)));
      };
      const double p = data->GetArray("P")->GetComponent(i, 0);
      const double s = data->GetArray("S")->GetComponent(i, 0);
      double t = data->GetArray("T")->GetComponent(i, 0);
      const bool is = data->GetArray("truth")->GetComponent(i, 0) == wanted;
      int ijk[3];
      const int* e = grid->GetExtent();
      ijk[0] = e[0] + static_cast<int>(i % (e[1] - e[0] + 1));
      ijk[1] = e[2] + static_cast<int>(i / (e[1] - e[0] + 1) % (e[3] - e[2] + 1));
      ijk[2] = e[4] + static_cast<int>(i / (e[1] - e[0] + 1) / (e[3] - e[2] + 1));
      const unsigned half = vtkTFCQualityCounts::GetHalf(static_cast<std::uint64_t>(ijk[0]),
        static_cast<std::uint64_t>(ijk[1]), static_cast<std::uint64_t>(ijk[2]));
      total += is;
      totals[half] += is;
      if (p >= 0 && p <= 10 && s >= -1 && s <= 1 && !(third && std::isnan(t)))
      {
        t = std::max(low, std::min(high, t));
        auto& cell = cells[{ bin(p, 0, 10) / width, bin(s, -1, 1) / width,
          third ? bin(t, low, high) / width : 0 }];
        cell[half] += is;
        cell[2 + half] += 1;
      }
    }
    double hits = 0;
    double chosen = 0;
    for (int fit = 0; fit < 2; ++fit)
    {
      double bestFit = 0;
      std::array<double, 2> judged = { { 0, 0 } };
      for (const auto& at : cells)
      {
        // All cells with at least this share.
        const double share = at.second[fit] / at.second[2 + fit];
        double fitHits = 0;
        double fitChosen = 0;
        std::array<double, 2> test = { { 0, 0 } };
        for (const auto& other : cells)
        {
          if (other.second[fit] > 0 && other.second[fit] / other.second[2 + fit] >= share)
          {
            fitHits += other.second[fit];
            fitChosen += other.second[2 + fit];
            test[0] += other.second[1 - fit];
            test[1] += other.second[3 - fit];
          }
        }
        const double dice = 2 * fitHits / (totals[fit] + fitChosen);
        // Among equals the smaller set.
        if (share > 0 && (dice > bestFit || (dice == bestFit && test[1] < judged[1])))
        {
          bestFit = dice;
          judged = test;
        }
      }
      hits += judged[0];
      chosen += judged[1];
    }
    best = std::max(best, 2 * hits / (total + chosen));
  }
  return best;
}

void ExpectError(vtkDataObject* input, const std::string& state, const char* labels,
  const std::string& words, int bins = 64)
{
  Filter filter;
  Catcher catcher(filter);
  filter->SetNumberOfBins(bins);
  Measure(filter, input, state, labels);
  EXPECT_NE(catcher.Errors.find(words), std::string::npos) << catcher.Errors;
  EXPECT_EQ(filter->GetOutput()->GetNumberOfColumns(), 0);
}
}

TEST(ClassificationQuality, CountsByHand)
{
  const auto grid = Volume({ { -3, 14, 5, 20, 0, 12 } });
  Filter filter;
  Measure(filter, grid, VolumeState());
  CheckTables(filter, Count(grid, VolumeState(), {}));
  auto* confusion = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(confusion->GetNumberOfColumns(), 4) << "no column for the hidden region";
}

TEST(ClassificationQuality, BlankedAndIgnoredVoxelsAreLeftOut)
{
  const auto grid = Volume({ { 0, 15, 0, 14, 0, 13 } });
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); i += 3)
  {
    grid->BlankPoint(i);
  }
  Filter filter;
  filter->AddIgnoredLabel(90);
  filter->AddIgnoredLabel(12345);
  Measure(filter, grid, VolumeState());
  CheckTables(filter, Count(grid, VolumeState(), { 90 }));
  filter->ClearIgnoredLabels();
  filter->Update();
  CheckTables(filter, Count(grid, VolumeState(), {}));
}

TEST(ClassificationQuality, AttainableByDefinition)
{
  for (const int bins : { 5, 8 })
  {
    const auto grid = Volume({ { -3, 14, 5, 20, 0, 12 } });
    Filter filter;
    filter->SetNumberOfBins(bins);
    Measure(filter, grid, VolumeState());
    for (vtkIdType row = 0; row < 4; ++row)
    {
      const int label = static_cast<int>(Number(filter, 0, row, "label"));
      const double axes = Attainable(grid, label, bins, false);
      const double all = Attainable(grid, label, bins, true);
      EXPECT_NEAR(Number(filter, 0, row, "axes_dice"), axes, 1e-12) << label;
      EXPECT_NEAR(Number(filter, 0, row, "best_dice"), std::max(axes, all), 1e-12) << label;
      EXPECT_EQ(Text(filter, row, "best_attribute"), all > axes ? "T" : "") << label;
    }
    EXPECT_GT(Number(filter, 0, 2, "best_dice"), Number(filter, 0, 2, "axes_dice") + 0.1);
  }
}

TEST(ClassificationQuality, SaysWhatIsTheLimit)
{
  // Labels are known exactly by T, in part by P and S.
  const auto grid = Volume({ { 0, 29, 0, 29, 0, 19 } });
  auto* data = grid->GetPointData();
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    data->GetArray("P")->SetComponent(i, 0, 5 + 4 * std::sin(static_cast<double>(i)));
    data->GetArray("S")->SetComponent(i, 0, 0.5);
    data->GetArray("T")->SetComponent(i, 0, static_cast<double>(i % 100));
    data->GetArray("truth")->SetComponent(i, 0, i % 100 < 40 ? 1 : 2);
  }
  Filter filter;
  Measure(filter, grid,
    State(
      Everywhere(1, 1, "[1, 0, 0]", R"({"array": "T", "opacity": [[0, 1], [40, 1], [40, 0]]})")));
  EXPECT_EQ(Number(filter, 0, 0, "dice"), 1);
  EXPECT_EQ(Text(filter, 0, "limited_by"), "neither");
  EXPECT_EQ(Text(filter, 1, "limited_by"), "regions") << "no region has it";
  EXPECT_EQ(Number(filter, 0, 1, "region"), 0);
  EXPECT_EQ(Number(filter, 0, 1, "leakage"), 0);
  EXPECT_GT(Number(filter, 0, 1, "best_dice"), 0.97);
  Measure(filter, grid, State(Everywhere(1, 1, "[1, 0, 0]")));
  EXPECT_EQ(Text(filter, 0, "limited_by"), "axes");
  EXPECT_NEAR(Number(filter, 0, 0, "dice"), 0.8 / 1.4, 1e-3);
  EXPECT_NEAR(Number(filter, 0, 0, "leakage"), 0.6, 1e-3);
  Measure(filter, grid, State(""));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 2) << "no regions at all";
  EXPECT_NEAR(Number(filter, 0, 1, "axes_dice"), 1.2 / 1.6, 0.02);
}

TEST(ClassificationQuality, DoesNotDependOnThreadsOrTypes)
{
  std::vector<double> first;
  for (const char* threads : { "1", "2", "5" })
  {
    ::setenv("TFC_NUM_THREADS", threads, 1);
    for (const int type : { VTK_CHAR, VTK_UNSIGNED_SHORT, VTK_LONG_LONG, VTK_ID_TYPE })
    {
      Filter filter;
      Measure(filter, Volume({ { 0, 49, 0, 39, 0, 29 } }, type), VolumeState());
      std::vector<double> values;
      for (vtkIdType row = 0; row < 4; ++row)
      {
        for (const char* column : { "label", "voxels", "dice", "axes_dice", "best_dice" })
        {
          values.push_back(Number(filter, 0, row, column));
        }
      }
      first = first.empty() ? values : first;
      EXPECT_EQ(values, first) << threads << " threads, type " << type;
    }
  }
  ::unsetenv("TFC_NUM_THREADS");
}

TEST(ClassificationQuality, LabelsFarApartAndNegative)
{
  const auto grid = Volume({ { 0, 9, 0, 9, 0, 9 } }, VTK_LONG_LONG);
  auto* labels = grid->GetPointData()->GetArray("truth");
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    labels->SetComponent(i, 0, i % 3 == 0 ? -4e15 : i % 3 == 1 ? 7 : 9e15);
  }
  Filter filter;
  Measure(filter, grid, VolumeState());
  ASSERT_EQ(filter->GetOutput()->GetNumberOfRows(), 3);
  EXPECT_EQ(Number(filter, 0, 0, "label"), -4e15);
  EXPECT_EQ(Number(filter, 0, 0, "voxels"), 334);
  EXPECT_EQ(Number(filter, 0, 2, "voxels"), 333);
  labels->SetComponent(5, 0, 9.1e15);
  ExpectError(grid, VolumeState(), "truth", "2^53");
}

TEST(ClassificationQuality, CellData)
{
  const auto points = Volume({ { 0, 9, 0, 9, 0, 9 } });
  auto cells = vtkSmartPointer<vtkUniformGrid>::New();
  cells->SetDimensions(11, 11, 11);
  for (const char* name : { "P", "S", "T", "truth" })
  {
    cells->GetCellData()->AddArray(points->GetPointData()->GetArray(name));
  }
  Filter ofPoints;
  Measure(ofPoints, points, VolumeState());
  Filter ofCells;
  Measure(ofCells, cells, VolumeState());
  for (const char* column : { "label", "voxels", "dice", "best_dice" })
  {
    EXPECT_EQ(Number(ofPoints, 0, 2, column), Number(ofCells, 0, 2, column)) << column;
  }
  const auto mixed = Volume({ { 0, 9, 0, 9, 0, 9 } });
  const auto labels = MakeArray(VTK_INT, "of cells", 729);
  mixed->GetCellData()->AddArray(labels);
  ExpectError(mixed, VolumeState(), "of cells", "Point Data to Cell Data, not the labels");
}

TEST(ClassificationQuality, BadInput)
{
  const auto grid = Volume({ { 0, 19, 0, 19, 0, 19 } });
  ExpectError(grid, VolumeState(), "T", "'T' holds values of the type float, not integers");
  ExpectError(grid, VolumeState(), "nobody", "There is no label array 'nobody'");
  ExpectError(grid, VolumeState(), "None", "LabelArray is not set");
  ExpectError(grid, VolumeState(), "truth", "NumberOfBins is 1. Set it to 2 to 1024", 1);
  ExpectError(grid, VolumeState(), "truth", "NumberOfBins is 1025", 1025);
  ExpectError(grid, "", "truth", "lacks an axis");
  ExpectError(grid, R"({"format": "transfer-function-combination", "version": 1,
    "primary": {"array": "Q"}, "secondary": {"array": "S"}})",
    "truth", "There is no array 'Q'");
  vtkNew<vtkStringArray> text;
  text->SetName("words");
  text->SetNumberOfValues(8000);
  grid->GetPointData()->AddArray(text);
  ExpectError(grid, VolumeState(), "words", "no label array 'words' of numbers");
  const auto many = MakeArray(VTK_INT, "many", 8000);
  for (vtkIdType i = 0; i < 8000; ++i)
  {
    many->SetComponent(i, 0, static_cast<double>(i));
  }
  grid->GetPointData()->AddArray(many);
  ExpectError(grid, VolumeState(), "many", "more than 4096 labels");
  vtkNew<vtkIntArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(8000);
  vectors->Fill(1);
  grid->GetPointData()->AddArray(vectors);
  ExpectError(grid, VolumeState(), "vectors", "'vectors' has 3 components");
  vtkNew<vtkUniformGrid> empty;
  ExpectError(empty, VolumeState(), "truth", "The input is empty");

  Filter filter;
  Catcher catcher(filter);
  for (const int label : { 3, 11, 70, 90 })
  {
    filter->AddIgnoredLabel(label);
  }
  Measure(filter, grid, VolumeState());
  EXPECT_NE(catcher.Errors.find("No voxel is left"), std::string::npos) << catcher.Errors;
}

TEST(ClassificationQuality, AttributesWithoutNumbers)
{
  const auto grid = Volume({ { 0, 9, 0, 9, 0, 9 } });
  for (const char* name : { "P", "T" })
  {
    auto* array = grid->GetPointData()->GetArray(name);
    array->FillComponent(0, std::nan(""));
  }
  Filter filter;
  Measure(filter, grid, VolumeState());
  ASSERT_EQ(filter->GetOutput()->GetNumberOfRows(), 4);
  for (vtkIdType row = 0; row < 4; ++row)
  {
    EXPECT_EQ(Number(filter, 1, row, "none"), Number(filter, 0, row, "voxels"));
    EXPECT_EQ(Number(filter, 0, row, "best_dice"), 0);
    EXPECT_EQ(Text(filter, row, "limited_by"), "axes");
  }
}

TEST(ClassificationQuality, LargestNumbersAndSingleVoxels)
{
  const auto grid = Volume({ { 0, 9, 0, 9, 0, 9 } });
  auto* data = grid->GetPointData();
  const auto huge = MakeArray(VTK_DOUBLE, "T", 1000);
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    data->GetArray("P")->SetComponent(i, 0, 5);
    data->GetArray("S")->SetComponent(i, 0, 0);
    data->GetArray("truth")->SetComponent(i, 0, i == 7 ? 8 : static_cast<double>(i % 2));
    huge->SetComponent(i, 0, i % 2 ? 1.7e308 : -1.7e308);
  }
  data->AddArray(huge);
  Filter filter;
  Measure(filter, grid, VolumeState());
  ASSERT_EQ(filter->GetOutput()->GetNumberOfRows(), 3);
  EXPECT_EQ(Number(filter, 0, 0, "best_dice"), 1);
  EXPECT_GT(Number(filter, 0, 1, "best_dice"), 0.99);
  EXPECT_EQ(Number(filter, 0, 2, "best_dice"), 0) << "nothing to learn it from";
}

TEST(ClassificationQuality, AbortLeavesEmptyTables)
{
  Filter filter;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  Measure(filter, Volume({ { 0, 59, 0, 49, 0, 49 } }), VolumeState());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfColumns(), 0);
}
