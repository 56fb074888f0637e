// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterVolumes.h"

#include "Filters/vtkTFCCombinationScore.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkShortArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace testing_volumes;

namespace
{
constexpr int N = 20;

vtkSmartPointer<vtkImageData> MakeAttributes()
{
  auto image = MakeImage(N, N, N);
  auto* points = image->GetPointData();
  points->AddArray(MakeArray("P", N, N, N, [](int x, int, int) { return 1000. + x; }));
  points->AddArray(MakeArray<vtkFloatArray>("TC", N, N, N,
    [](int x, int y, int z) { return -2. * x + 4. * Noise(x, y, z); }));
  points->AddArray(MakeArray("free", N, N, N, Noise));
  points->AddArray(
    MakeArray<vtkUnsignedCharArray>("flag", N, N, N, [](int, int y, int) { return y >= N / 4; }));
  points->AddArray(MakeArray<vtkShortArray>("constant", N, N, N, [](int, int, int) { return 7; }));
  return image;
}

/**
 * Row of the table by attribute name, -1 when there is none.
 */
int FindRow(vtkTable* table, const std::string& attribute)
{
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (table->GetValueByName(row, "attribute").ToString() == attribute)
    {
      return static_cast<int>(row);
    }
  }
  return -1;
}

double Get(vtkTable* table, const std::string& attribute, const char* column)
{
  const int row = FindRow(table, attribute);
  EXPECT_GE(row, 0) << attribute;
  return row < 0 ? NaN : table->GetValueByName(row, column).ToDouble();
}

/**
 * Two-pass correlation of the samples where both are valid.
 */
double Correlate(const std::vector<double>& a, const std::vector<double>& b)
{
  long double n = 0, meanA = 0, meanB = 0, aa = 0, bb = 0, ab = 0;
  for (int pass = 0; pass < 2; ++pass)
  {
    for (size_t i = 0; i < a.size(); ++i)
    {
      if (std::isnan(a[i]) || std::isnan(b[i]))
      {
        continue;
      }
      if (pass == 0)
      {
        n += 1;
        meanA += a[i];
        meanB += b[i];
        continue;
      }
      aa += (a[i] - meanA / n) * (a[i] - meanA / n);
      bb += (b[i] - meanB / n) * (b[i] - meanB / n);
      ab += (a[i] - meanA / n) * (b[i] - meanB / n);
    }
  }
  return static_cast<double>(ab / std::sqrt(aa * bb));
}

std::vector<double> GetValues(vtkDataSet* data, const char* name)
{
  std::vector<double> values;
  auto* array = data->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  return values;
}
}

TEST(CombinationScore, TableAndMatrix)
{
  const auto image = MakeAttributes();
  vtkNew<vtkTFCCombinationScore> filter;
  filter->SetInputData(image);
  filter->SetPrimary("P");
  filter->SetSecondary("TC");
  filter->Update();
  vtkTable* table = filter->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 5);
  ASSERT_EQ(table->GetNumberOfColumns(), 9);

  // P takes N values equally often, flag two: closed forms.
  EXPECT_NEAR(Get(table, "P", "entropy"), std::log2(N), 1e-12);
  EXPECT_NEAR(Get(table, "flag", "entropy"), 0.25 * 2. + 0.75 * std::log2(4. / 3.), 1e-12);
  EXPECT_EQ(Get(table, "constant", "entropy"), 0.);
  EXPECT_NEAR(Get(table, "flag", "correlation"), 0., 1e-12);
  const double r = Correlate(GetValues(image, "P"), GetValues(image, "free"));
  EXPECT_NEAR(Get(table, "free", "correlation"), r, 1e-12);
  EXPECT_LT(Get(table, "TC", "correlation"), -0.5);

  double largest = 0.;
  for (const char* name : { "P", "TC", "free", "flag", "constant" })
  {
    largest = std::max(largest, Get(table, name, "entropy"));
  }
  EXPECT_NEAR(Get(table, "free", "score"),
    -0.4 * std::abs(r) + 0.6 * Get(table, "free", "entropy") / largest, 1e-12);

  // Best first; the primary, the secondary and the constant one follow without a rank.
  EXPECT_EQ(FindRow(table, "free"), 0);
  EXPECT_EQ(FindRow(table, "flag"), 1);
  EXPECT_EQ(FindRow(table, "P"), 2);
  EXPECT_EQ(FindRow(table, "TC"), 3);
  EXPECT_EQ(FindRow(table, "constant"), 4);
  EXPECT_EQ(Get(table, "free", "rank"), 1.);
  EXPECT_EQ(Get(table, "flag", "rank"), 2.);
  for (const char* name : { "P", "TC", "constant" })
  {
    EXPECT_EQ(Get(table, name, "rank"), 0.);
    EXPECT_TRUE(std::isnan(Get(table, name, "score")));
  }

  vtkTable* matrix = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(matrix->GetNumberOfRows(), 5);
  ASSERT_EQ(matrix->GetNumberOfColumns(), 6);
  EXPECT_EQ(Get(matrix, "P", "P"), 1.);
  EXPECT_EQ(Get(matrix, "P", "free"), Get(matrix, "free", "P"));
  EXPECT_NEAR(Get(matrix, "P", "free"), r, 1e-12);
  EXPECT_TRUE(std::isnan(Get(matrix, "constant", "constant")));
  EXPECT_TRUE(std::isnan(Get(matrix, "constant", "P")));
}

TEST(CombinationScore, FillValuesInvalidAndBlankedPoints)
{
  auto image = MakeImage(N, N, N);
  const auto land = [](int x, int y, int) { return x < 5 && y < 7; };
  image->GetPointData()->AddArray(MakeArray<vtkFloatArray>("P", N, N, N,
    [&](int x, int y, int z) { return land(x, y, z) ? 1e35 : x + Noise(x, y, z); }));
  image->GetPointData()->AddArray(MakeArray("Q", N, N, N,
    [&](int x, int y, int z) {
      return z == 3 ? NaN : z == 4 && y == 2 ? -INFINITY : x * y + Noise(z, y, x);
    }));
  Blank(image, [](vtkIdType i) { return i % 97 == 5; });
  auto p = GetValues(image, "P");
  auto q = GetValues(image, "Q");
  for (size_t i = 0; i < p.size(); ++i)
  {
    p[i] = p[i] > 1e34 || i % 97 == 5 ? NaN : p[i];
    q[i] = std::isinf(q[i]) || i % 97 == 5 ? NaN : q[i];
  }
  vtkNew<vtkTFCCombinationScore> filter;
  filter->SetInputData(image);
  filter->AddFillValue(-9999.);
  filter->AddFillValue(1e35);
  filter->Update();
  EXPECT_NEAR(Get(filter->GetOutput(), "Q", "correlation"), Correlate(p, q), 1e-12);

  // Binned by the documented rule.
  double low = INFINITY, high = -INFINITY;
  double total = 0., counts[16] = {}, entropy = 0.;
  for (const double v : q)
  {
    low = v < low ? v : low;
    high = v > high ? v : high;
  }
  for (const double v : q)
  {
    if (!std::isnan(v))
    {
      ++counts[std::min(15, static_cast<int>((v - low) * (16 / (high - low))))];
      ++total;
    }
  }
  for (const double count : counts)
  {
    entropy -= count > 0. ? count / total * std::log2(count / total) : 0.;
  }
  filter->SetNumberOfBins(16);
  filter->Update();
  EXPECT_NEAR(Get(filter->GetOutput(), "Q", "entropy"), entropy, 1e-12);
}

TEST(CombinationScore, ChosenArraysAndComponents)
{
  auto image = MakeAttributes();
  vtkNew<vtkFloatArray> wind;
  wind->SetName("wind");
  wind->SetNumberOfComponents(3);
  for (int i = 0; i < N * N * N; ++i)
  {
    wind->InsertNextTuple3(i % N, Noise(i, 1, 2), 2. * (i % N));
  }
  image->GetPointData()->AddArray(wind);
  image->GetPointData()->AddArray(MakeArray("odd:0", N, N, N, Noise));

  vtkNew<vtkTFCCombinationScore> filter;
  filter->SetInputData(image);
  filter->AddArray("free");
  filter->AddArray("wind:1");
  filter->AddArray("wind:2");
  filter->AddArray("wind:magnitude");
  filter->AddArray("free");
  filter->AddArray("odd:0");
  filter->AddArray("vtkGhostType");
  filter->SetPrimary("wind:0");
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 6);
  EXPECT_NEAR(Get(filter->GetOutput(), "wind:2", "correlation"), 1., 1e-12);
  EXPECT_GT(Get(filter->GetOutput(), "wind:magnitude", "correlation"), 0.9);
  filter->ClearArrays();
  filter->SetPrimary("None");
  filter->Update();
  // All single-component arrays; the first of them is the primary one.
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 6);
  EXPECT_EQ(Get(filter->GetOutput(), "P", "correlation"), 1.);
  EXPECT_EQ(Get(filter->GetOutput(), "P", "rank"), 0.);
}

TEST(CombinationScore, LargeOffsetsAndRangesKeepTheirPrecision)
{
  auto image = MakeImage(N, N, N);
  image->GetPointData()->AddArray(MakeArray("offset", N, N, N,
    [](int x, int y, int z) { return 1e9 + 16. * Noise(x, y, z) + x; }));
  image->GetPointData()->AddArray(
    MakeArray("large", N, N, N, [](int x, int y, int z) { return 1e300 * Noise(z, x, y) * x; }));
  image->GetPointData()->AddArray(
    MakeArray("small", N, N, N, [](int x, int y, int) { return 1e-300 * x * y; }));
  vtkNew<vtkTFCCombinationScore> filter;
  filter->SetInputData(image);
  filter->Update();
  auto large = GetValues(image, "large");
  auto small = GetValues(image, "small");
  for (size_t i = 0; i < large.size(); ++i)
  {
    large[i] /= 1e300;
    small[i] /= 1e-300;
  }
  const auto offset = GetValues(image, "offset");
  EXPECT_NEAR(Get(filter->GetOutput(), "large", "correlation"), Correlate(offset, large), 1e-12);
  EXPECT_NEAR(Get(filter->GetOutput(), "small", "correlation"), Correlate(offset, small), 1e-12);
}

TEST(CombinationScore, OtherDataSets)
{
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(N, 1, 1);
  vtkNew<vtkDoubleArray> coordinates;
  for (int i = 0; i < N; ++i)
  {
    coordinates->InsertNextValue(i * i);
  }
  grid->SetXCoordinates(coordinates);
  grid->GetPointData()->AddArray(MakeArray("a", N, 1, 1, [](int x, int, int) { return x; }));
  grid->GetPointData()->AddArray(MakeArray("b", N, 1, 1, [](int x, int, int) { return -x; }));
  vtkNew<vtkTFCCombinationScore> filter;
  filter->SetInputData(grid);
  filter->Update();
  EXPECT_NEAR(Get(filter->GetOutput(), "b", "correlation"), -1., 1e-12);
}

TEST(CombinationScore, DoesNotDependOnThreads)
{
  auto image = MakeImage(61, 60, 59);
  image->GetPointData()->AddArray(
    MakeArray<vtkFloatArray>("a", 61, 60, 59, [](int x, int y, int z) { return Noise(x, y, z); }));
  image->GetPointData()->AddArray(MakeArray<vtkFloatArray>("b", 61, 60, 59,
    [](int x, int y, int z) { return x % 9 ? Noise(z, x, y) + x : NaN; }));
  double first[2] = {};
  for (const int number : { 1, 2, 3, 7 })
  {
    const Threads threads(number);
    vtkNew<vtkTFCCombinationScore> filter;
    filter->SetInputData(image);
    filter->Update();
    const double now[2] = { Get(filter->GetOutput(), "b", "correlation"),
      Get(filter->GetOutput(), "b", "entropy") };
    if (number == 1)
    {
      std::copy_n(now, 2, first);
    }
    EXPECT_EQ(now[0], first[0]);
    EXPECT_EQ(now[1], first[1]);
  }
}

TEST(CombinationScore, InformationBeyondCorrelation)
{
  constexpr int n = 48;
  auto image = MakeImage(n, n, n);
  auto* points = image->GetPointData();
  const auto x = [](int i, int j, int k) { return Noise(i, j, k); };
  const auto y = [](int i, int j, int k) { return Noise(j + 100, k, i); };
  points->AddArray(MakeArray("x", n, n, n, x));
  points->AddArray(MakeArray("y", n, n, n, y));
  // An arch: determined by x, though hardly correlated with it.
  points->AddArray(
    MakeArray("arch", n, n, n, [&](int i, int j, int k) { return std::pow(x(i, j, k) - 1., 2.); }));
  points->AddArray(
    MakeArray("free", n, n, n, [](int i, int j, int k) { return Noise(k, i + 99, j); }));
  // Only both axes together determine it.
  points->AddArray(MakeArray("parity", n, n, n,
    [&](int i, int j, int k) { return (x(i, j, k) > 1.) == (y(i, j, k) > 1.) ? 0. : 5.; }));
  points->AddArray(MakeArray("constant", n, n, n, [](int, int, int) { return 3.; }));
  vtkNew<vtkTFCCombinationScore> filter;
  filter->SetInputData(image);
  filter->SetPrimary("x");
  filter->SetSecondary("y");
  filter->Update();
  vtkTable* table = filter->GetOutput();
  EXPECT_LT(std::abs(Get(table, "arch", "correlation")), 0.05);
  EXPECT_LT(Get(table, "arch", "separation"), 0.45) << "x leaves little open";
  EXPECT_GT(Get(table, "arch", "conditional_mutual_information"), 1.);
  EXPECT_LT(Get(table, "free", "mutual_information"), 0.01) << "independent";
  EXPECT_GT(Get(table, "free", "separation"), 0.99);
  EXPECT_NEAR(Get(table, "free", "new_information"), 3., 0.02) << "8 bins, all alike";
  EXPECT_NEAR(Get(table, "parity", "mutual_information"), 1., 0.01);
  EXPECT_NEAR(Get(table, "parity", "conditional_mutual_information"), 1., 0.01);
  EXPECT_NEAR(Get(table, "parity", "new_information"), 0., 0.01);
  EXPECT_EQ(Get(table, "constant", "new_information"), 0.);
  EXPECT_TRUE(std::isnan(Get(table, "x", "new_information")));

  filter->SetSecondary("None");
  filter->Update();
  EXPECT_NEAR(Get(filter->GetOutput(), "parity", "mutual_information"), 0., 0.01);
  filter->MeasureInformationOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfColumns(), 5);
}

TEST(CombinationScore, BinsByBitDepth)
{
  auto image = MakeImage(N, N, N);
  auto* points = image->GetPointData();
  points->AddArray(MakeArray<vtkShortArray>("wide", N, N, N,
    [](int x, int y, int z) { return x + N * y + N * N * z - 4000; }));
  points->AddArray(MakeArray<vtkUnsignedCharArray>("bytes", N, N, N,
    [](int x, int, int z) { return x + 10 * z; }));
  points->AddArray(MakeArray("real", N, N, N, Noise));
  vtkNew<vtkTFCCombinationScore> filter;
  filter->SetInputData(image);
  filter->Update();
  const double real = Get(filter->GetOutput(), "real", "entropy");
  const double bytes = Get(filter->GetOutput(), "bytes", "entropy");
  EXPECT_LE(Get(filter->GetOutput(), "wide", "entropy"), 8.);
  filter->SetNumberOfBins(0);
  filter->Update();
  EXPECT_NEAR(Get(filter->GetOutput(), "wide", "entropy"), std::log2(N * N * N), 1e-11);
  EXPECT_EQ(Get(filter->GetOutput(), "bytes", "entropy"), bytes);
  EXPECT_EQ(Get(filter->GetOutput(), "real", "entropy"), real);
}

TEST(CombinationScore, CellsGiveWhatPointsGive)
{
  const auto image = MakeAttributes();
  auto cells = vtkSmartPointer<vtkImageData>::New();
  cells->SetDimensions(N + 1, N + 1, N + 1);
  for (const char* name : { "P", "TC", "free", "flag" })
  {
    cells->GetCellData()->AddArray(image->GetPointData()->GetArray(name));
  }
  vtkNew<vtkTFCCombinationScore> ofPoints, ofCells;
  ofPoints->SetInputData(image);
  ofCells->SetInputData(cells);
  ofPoints->Update();
  ofCells->Update();
  for (const char* name : { "TC", "free", "flag" })
  {
    for (const char* column : { "correlation", "entropy", "score", "new_information" })
    {
      EXPECT_EQ(Get(ofCells->GetOutput(), name, column), Get(ofPoints->GetOutput(), name, column));
    }
  }
}

TEST(CombinationScore, BlocksGiveWhatTheWholeGives)
{
  const auto whole = MakeAttributes();
  // Slabs of 7, 6 and 7 layers, and nothing in between.
  vtkNew<vtkMultiBlockDataSet> blocks;
  int first = 0;
  for (const int layers : { 7, 6, 7 })
  {
    auto slab = vtkSmartPointer<vtkImageData>::New();
    slab->SetExtent(0, N - 1, 0, N - 1, first, first + layers - 1);
    for (int a = 0; a < whole->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* from = whole->GetPointData()->GetArray(a);
      auto part = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
      part->SetName(from->GetName());
      part->InsertTuples(0, static_cast<vtkIdType>(N) * N * layers,
        static_cast<vtkIdType>(N) * N * first, from);
      slab->GetPointData()->AddArray(part);
    }
    blocks->SetBlock(blocks->GetNumberOfBlocks() + 1, slab);
    first += layers;
  }
  vtkNew<vtkTFCCombinationScore> ofWhole, ofBlocks;
  ofWhole->SetInputData(whole);
  ofBlocks->SetInputDataObject(blocks);
  ofWhole->Update();
  ofBlocks->Update();
  ASSERT_EQ(ofBlocks->GetOutput()->GetNumberOfRows(), 5);
  for (const char* name : { "TC", "free", "flag" })
  {
    for (const char* column : { "correlation", "entropy", "score", "new_information" })
    {
      EXPECT_NEAR(Get(ofBlocks->GetOutput(), name, column), Get(ofWhole->GetOutput(), name, column),
        1e-12);
    }
  }
  vtkImageData::SafeDownCast(blocks->GetBlock(3))->GetPointData()->RemoveArray("free");
  Errors errors(ofBlocks);
  ofBlocks->Modified();
  ofBlocks->Update();
  EXPECT_EQ(ofBlocks->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_TRUE(errors.Mention("blocks hold different arrays")) << errors.Text;
}
