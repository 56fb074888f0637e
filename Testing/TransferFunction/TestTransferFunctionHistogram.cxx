// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTFCTransferFunctionHistogram against counting and weighting voxel by voxel.
#include "ModelTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTFCTransferFunctionHistogram.h"
#include "vtkTable.h"

#include <cmath>
#include <random>

using namespace ModelTesting;

namespace
{
constexpr int Bins = 16;

// P in [0, 10], S in [-1, 1] and somewhat beyond, T in [0, 100], some NaN.
vtkSmartPointer<vtkImageData> Volume()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(20, 18, 16);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  vtkNew<vtkDoubleArray> p, s;
  vtkNew<vtkFloatArray> t;
  p->SetName("P");
  s->SetName("S");
  t->SetName("T");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    p->InsertNextValue(i % 31 == 4 ? std::nan("") : 11 * unit(random) - 0.5);
    s->InsertNextValue(2.2 * unit(random) - 1.1);
    t->InsertNextValue(i % 37 == 9 ? std::nanf("") : static_cast<float>(100 * unit(random)));
  }
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(p), static_cast<vtkDataArray*>(s), static_cast<vtkDataArray*>(t) })
  {
    image->GetPointData()->AddArray(array);
  }
  return image;
}

std::string TwoRegions(const std::string& tertiary = R"({"array": "T", "range": [0, 80],
  "opacity": [[50, 0], [60, 1]]})")
{
  return State(R"({"id": 12, "shape": {"type": "ellipse", "center": [4, 0], "radii": [3, 0.8],
      "angle": 20}, "falloff": {"type": "gaussian", "width": 0.6}, "opacity": 0.2,
      "tertiary": )" +
    tertiary + R"(},
    {"id": 4, "shape": {"type": "polygon", "points": [[3, 1], [10, -1], [10, 1]]},
      "tertiary": {"array": "S", "opacity": [[0, 1]]}},
    {"id": 9, "shape": {"type": "rectangle", "center": [5, 0], "halfsize": [1, 1]}},
    {"id": 6, "visible": false, "shape": {"type": "ellipse", "center": [5, 0],
      "radii": [1, 1]}, "tertiary": {"array": "nobody", "opacity": [[0, 1]]}})");
}

int BinOf(double v, double low, double high)
{
  return v >= low && v <= high
    ? std::min(Bins - 1, static_cast<int>(std::floor((v - low) / (high - low) * Bins)))
    : -1;
}

// The definition: every voxel, weighted at the centre of its bin.
std::vector<double> Weigh(vtkDataSetAttributes* data, const std::string& state, int regionIndex,
  const char* name, double low, double high)
{
  const vtkTFCCompiledModel model = Compile(state);
  std::vector<double> sums(Bins, 0.);
  for (vtkIdType i = 0; i < data->GetNumberOfTuples(); ++i)
  {
    const int x = BinOf(data->GetArray("P")->GetTuple1(i), 0, 10);
    const int y = BinOf(data->GetArray("S")->GetTuple1(i), -1, 1);
    const int z = BinOf(data->GetArray(name)->GetTuple1(i), low, high);
    if (x >= 0 && y >= 0 && z >= 0)
    {
      sums[z] += vtkTFCClassifier::RegionWeight(model.Regions[regionIndex], (x + 0.5) / Bins,
        (y + 0.5) / Bins);
    }
  }
  return sums;
}

using Filter = vtkNew<vtkTFCTransferFunctionHistogram>;

void Compute(vtkTFCTransferFunctionHistogram* filter, vtkDataObject* input,
  const std::string& state)
{
  filter->SetInputDataObject(input);
  filter->SetNumberOfBins(Bins);
  filter->SetTransferFunction(state.c_str());
  filter->Update();
}

vtkImageData* Plane(vtkTFCTransferFunctionHistogram* filter)
{
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkTable* Table(vtkTFCTransferFunctionHistogram* filter)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
}

void ExpectColumn(vtkTable* table, const char* name, const std::vector<double>& expected)
{
  auto* column = vtkDoubleArray::SafeDownCast(table->GetColumnByName(name));
  ASSERT_NE(column, nullptr) << name;
  ASSERT_EQ(column->GetNumberOfTuples(), static_cast<vtkIdType>(expected.size()));
  for (size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(column->GetValue(static_cast<vtkIdType>(i)), expected[i], 1e-4) << name << i;
  }
}
}

TEST(TransferFunctionHistogram, PlaneAndConditionals)
{
  const auto volume = Volume();
  Filter filter;
  Compute(filter, volume, TwoRegions());
  vtkImageData* plane = Plane(filter);
  int dimensions[3];
  plane->GetDimensions(dimensions);
  EXPECT_EQ(dimensions[0], Bins);
  EXPECT_EQ(dimensions[1], Bins);
  EXPECT_NEAR(plane->GetOrigin()[0], 0.3125, 1e-12);
  EXPECT_NEAR(plane->GetSpacing()[1], 0.125, 1e-12);
  std::vector<double> counts(Bins * Bins, 0.);
  vtkDataSetAttributes* data = volume->GetPointData();
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    const int x = BinOf(data->GetArray("P")->GetTuple1(i), 0, 10);
    const int y = BinOf(data->GetArray("S")->GetTuple1(i), -1, 1);
    if (x >= 0 && y >= 0)
    {
      counts[y * Bins + x] += 1.;
    }
  }
  for (vtkIdType cell = 0; cell < Bins * Bins; ++cell)
  {
    EXPECT_EQ(plane->GetPointData()->GetArray("count")->GetTuple1(cell), counts[cell]);
  }

  // Hidden regions and those without a tertiary attribute have no columns; opacity is no weight.
  vtkTable* table = Table(filter);
  ASSERT_EQ(table->GetNumberOfColumns(), 4);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    low = std::min(low, data->GetArray("S")->GetTuple1(i));
    high = std::max(high, data->GetArray("S")->GetTuple1(i));
  }
  ExpectColumn(table, "region 12 count", Weigh(data, TwoRegions(), 0, "T", 0, 80));
  ExpectColumn(table, "region 4 count", Weigh(data, TwoRegions(), 1, "S", low, high));
  std::vector<double> centers;
  centers.reserve(Bins);
  for (int i = 0; i < Bins; ++i)
  {
    centers.push_back(5. * i + 2.5);
  }
  ExpectColumn(table, "region 12 T", centers);
}

TEST(TransferFunctionHistogram, FollowsEditsAndData)
{
  const auto volume = Volume();
  Filter filter;
  Compute(filter, volume, TwoRegions());
  const auto fresh = [&](const std::string& state)
  {
    Filter other;
    Compute(other, volume, state);
    Compute(filter, volume, state);
    for (vtkIdType c = 0; c < Table(other)->GetNumberOfColumns(); ++c)
    {
      std::vector<double> expected;
      for (vtkIdType row = 0; row < Bins; ++row)
      {
        expected.push_back(Table(other)->GetValue(row, c).ToDouble());
      }
      ExpectColumn(Table(filter), Table(other)->GetColumnName(c), expected);
    }
  };
  fresh(TwoRegions(R"({"array": "T", "range": [0, 50], "opacity": [[0, 1]]})"));
  fresh(TwoRegions(R"({"array": "P", "opacity": [[0, 1]]})"));
  fresh(TwoRegions());
  vtkDataArray* t = volume->GetPointData()->GetArray("T");
  t->SetTuple1(5, 3.);
  t->SetTuple1(6, 3.);
  t->Modified();
  fresh(TwoRegions());
}

TEST(TransferFunctionHistogram, CellsBlocksAndAutomaticRanges)
{
  const auto volume = Volume();
  auto cells = vtkSmartPointer<vtkImageData>::New();
  cells->SetDimensions(21, 19, 17);
  cells->GetCellData()->ShallowCopy(volume->GetPointData());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, volume);
  blocks->SetBlock(1, volume);
  Filter a, b, c;
  Compute(a, volume, TwoRegions());
  Compute(b, cells, TwoRegions());
  Compute(c, blocks, TwoRegions());
  for (vtkIdType row = 0; row < Bins; ++row)
  {
    const double expected = Table(a)->GetValueByName(row, "region 12 count").ToDouble();
    EXPECT_EQ(Table(b)->GetValueByName(row, "region 12 count").ToDouble(), expected);
    EXPECT_EQ(Table(c)->GetValueByName(row, "region 12 count").ToDouble(), 2. * expected);
  }
  Filter automatic;
  Compute(automatic, volume, R"({"format": "transfer-function-combination", "version": 1,
    "primary": {"array": "T"}, "secondary": {"array": "T"}})");
  double total = 0.;
  for (vtkIdType cell = 0; cell < Bins * Bins; ++cell)
  {
    total += Plane(automatic)->GetPointData()->GetArray("count")->GetTuple1(cell);
  }
  EXPECT_EQ(total, 5760. - 156.) << "all but NaN";
}

TEST(TransferFunctionHistogram, BadInput)
{
  const auto volume = Volume();
  const auto fails = [&](const std::string& state, const char* word, int bins = Bins)
  {
    Filter filter;
    Catcher catcher(filter);
    filter->SetInputDataObject(volume);
    filter->SetNumberOfBins(bins);
    filter->SetTransferFunction(state.c_str());
    filter->Update();
    EXPECT_NE(catcher.Errors.find(word), std::string::npos) << word << " in " << catcher.Errors;
    EXPECT_EQ(Table(filter)->GetNumberOfColumns(), 0);
    EXPECT_EQ(Plane(filter)->GetNumberOfPoints(), 0);
  };
  fails("", "lacks an axis");
  fails(TwoRegions(R"({"array": "Q", "opacity": [[0, 1]]})"), "'Q'");
  fails(TwoRegions(), "NumberOfBins is 1", 1);
  fails(TwoRegions(), "NumberOfBins is 2000", 2000);
}
