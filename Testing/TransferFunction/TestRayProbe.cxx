// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The probe along a line of sight against closed forms.
#include "ModelTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTFCRayProbe.h"
#include "vtkTable.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace ModelTesting;

namespace
{

//------------------------------------------------------------------------------
void AddField(vtkImageData* image, const char* name, const std::function<double(const double*)>& f)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    array->InsertNextValue(f(p));
  }
  image->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
// P is x, S is 0 and V is y, over [x0, x1] x [0, 10] x [0, 10] with a spacing of 1.
vtkSmartPointer<vtkImageData> MakeImage(int x0, int x1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(x0, x1, 0, 10, 0, 10);
  AddField(image, "P", [](const double* p) { return p[0]; });
  AddField(image, "S", [](const double*) { return 0.0; });
  AddField(image, "V", [](const double* p) { return p[1]; });
  return image;
}

class RayProbe : public testing::Test
{
protected:
  RayProbe()
  {
    this->Probe->SetInputDataObject(MakeImage(0, 10));
    this->SetRegions(Everywhere(1, 0.1, "[1, 0, 0]"));
    this->Probe->SetStartPoint(-5, 5, 5);
    this->Probe->SetEndPoint(20, 5, 5);
    this->Probe->SetSampleDistance(0.01);
  }

  void SetRegions(const std::string& regions, const std::string& blend = "mix")
  {
    this->Probe->SetTransferFunction(State(regions, blend).c_str());
    ASSERT_EQ(this->Probe->GetTransferFunction().empty(), false);
  }

  double Get(const char* name, int port = 0, int row = 0)
  {
    this->Probe->Update();
    vtkTable* table = this->Probe->GetOutput(port);
    EXPECT_GT(table->GetNumberOfRows(), row) << name;
    EXPECT_NE(table->GetColumnByName(name), nullptr) << name;
    return table->GetValueByName(row, name).ToDouble();
  }

  void ExpectError(const std::string& part)
  {
    Catcher errors(this->Probe);
    this->Probe->Update();
    EXPECT_NE(errors.Errors.find(part), std::string::npos) << errors.Errors;
    EXPECT_EQ(this->Probe->GetOutput(0)->GetNumberOfRows(), 0);
    EXPECT_EQ(this->Probe->GetOutput(1)->GetNumberOfRows(), 0);
  }

  vtkNew<vtkTFCRayProbe> Probe;
};

}

TEST_F(RayProbe, FindsWhereFogReachesTheThreshold)
{
  const double depth = std::log(0.5) / std::log(0.9);
  EXPECT_NEAR(this->Get("x"), depth, 0.011);
  EXPECT_NEAR(this->Get("distance"), 5 + depth, 0.011);
  EXPECT_EQ(this->Get("y"), 5);
  EXPECT_EQ(this->Get("reached"), 1);
  EXPECT_NEAR(this->Get("opacity"), 0.5, 0.001);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 10), 1e-9);
  EXPECT_NEAR(this->Get("P"), this->Get("x"), 1e-9);
  EXPECT_EQ(this->Get("i"), std::floor(this->Get("x") + 0.5));
  EXPECT_EQ(this->Get("j"), 5);
  EXPECT_EQ(this->Get("red"), 1);
  EXPECT_NEAR(this->Get("alpha"), 0.1, 1e-7);
  EXPECT_EQ(this->Get("contribution", 1), 1);
}

TEST_F(RayProbe, CoarseStepsGiveTheSameOpacity)
{
  this->Probe->SetSampleDistance(0.7);
  this->Probe->SetUnitDistance(3);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 10.0 / 3), 1e-9);
}

TEST_F(RayProbe, BelowTheThresholdTheLargestContributionCounts)
{
  // Opaque enough around x = 7 only.
  this->SetRegions(R"({"id": 4, "name": "seven", "opacity": 0.3, "falloff": {"type": "linear",
    "width": 1}, "shape": {"type": "ellipse", "center": [7, 0], "radii": [1, 0.5]}})");
  EXPECT_EQ(this->Get("reached"), 0);
  EXPECT_NEAR(this->Get("x"), 7, 0.05);
  EXPECT_NEAR(this->Get("weight", 1), 1, 0.05);
  EXPECT_EQ(this->Probe->GetOutput(1)->GetValueByName(0, "name").ToString(), "seven");
  EXPECT_EQ(this->Get("id", 1), 4);
}

TEST_F(RayProbe, SharesOfRegions)
{
  const std::string regions = Everywhere(1, 0.2, "[1, 0, 0]") + "," +
    Everywhere(2, 0.4, "[0, 0, 1]", R"({"array": "V", "opacity": [[0, 0], [10, 1]]})");
  this->SetRegions(regions);
  EXPECT_NEAR(this->Get("tertiary", 1, 1), 0.5, 1e-9);
  EXPECT_NEAR(this->Get("opacity", 1, 1), 0.2, 1e-9);
  EXPECT_NEAR(this->Get("contribution", 1, 0), 0.5, 1e-9);
  EXPECT_NEAR(this->Get("alpha"), 1 - 0.8 * 0.8, 1e-6);
  this->SetRegions(regions, "over");
  EXPECT_NEAR(this->Get("contribution", 1, 0), 0.2 / (0.2 + 0.8 * 0.2), 1e-9);
  EXPECT_NEAR(this->Get("red"), 0.2 / (0.2 + 0.8 * 0.2), 1e-6);
}

TEST_F(RayProbe, NothingVisibleIsNoRowAndNoError)
{
  Catcher errors(this->Probe);
  this->Probe->SetStartPoint(-5, 50, 5);
  this->Probe->SetEndPoint(20, 50, 5);
  this->Probe->Update();
  EXPECT_EQ(this->Probe->GetOutput(0)->GetNumberOfRows(), 0);
  this->Probe->SetStartPoint(-5, 5, 5);
  this->Probe->SetEndPoint(-1, 5, 5);
  this->Probe->Update();
  EXPECT_EQ(this->Probe->GetOutput(0)->GetNumberOfRows(), 0);
  EXPECT_EQ(errors.Errors, "");
}

TEST_F(RayProbe, BeginsInsideWhereTheEyeIs)
{
  this->Probe->SetStartPoint(4, 5, 5);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 6), 1e-9);
  this->Probe->SetEndPoint(6, 5, 5);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 2), 1e-9);
}

TEST_F(RayProbe, BlocksAreOneVolume)
{
  const double x = this->Get("x");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeImage(6, 10));
  blocks->SetBlock(1, MakeImage(0, 6));
  this->Probe->SetInputDataObject(blocks);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 10), 1e-9);
  EXPECT_EQ(this->Get("x"), x);
  EXPECT_EQ(this->Get("block"), x < 6 ? 1 : 0);
}

TEST_F(RayProbe, MissingDataIsInvisible)
{
  auto image = MakeImage(0, 10);
  // Every interpolation between x = 2 and x = 4 meets it.
  AddField(image, "P",
    [](const double* p) { return p[0] == 3 ? std::numeric_limits<double>::quiet_NaN() : p[0]; });
  this->Probe->SetInputDataObject(image);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 8), 1e-9);
}

TEST_F(RayProbe, CellsAndATransform)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(0, 10, 0, 10, 0, 10);
  for (const char* name : { "P", "S" })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
    {
      array->InsertNextValue(*name == 'P' ? static_cast<double>(i % 10) + 0.5 : 0.0);
    }
    image->GetCellData()->AddArray(array);
  }
  this->Probe->SetInputDataObject(image);
  // Twice as large, and moved by one.
  const double transform[16] = { 2, 0, 0, 1, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1 };
  this->Probe->SetTransform(transform);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 19), 1e-6); // ends at x = 20
  EXPECT_NEAR(this->Get("x"), 1 + std::log(0.5) / std::log(0.9), 0.011);
  EXPECT_NEAR(this->Get("P"), (this->Get("x") - 1) / 2, 1e-9);
  EXPECT_EQ(this->Get("i"), std::floor((this->Get("x") - 1) / 2));
}

TEST_F(RayProbe, ALayerIsOneVoxelThick)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(5, 5, 0, 10, 0, 10);
  AddField(image, "P", [](const double*) { return 3.0; });
  AddField(image, "S", [](const double*) { return 0.0; });
  this->Probe->SetInputDataObject(image);
  EXPECT_NEAR(this->Get("total_opacity"), 0.1, 1e-7);
  EXPECT_NEAR(this->Get("x"), 5, 0.5);
}

TEST_F(RayProbe, CroppingHidesWhatThePlanesSay)
{
  this->Probe->UseCroppingOn();
  this->Probe->SetCroppingOrigin(2, 0, 0);
  this->Probe->SetCroppingScale(0.5, 1, 1); // x from 2 to 7
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 5), 1e-3);
  this->Probe->SetThreshold(0.1);
  EXPECT_NEAR(this->Get("x"), 3, 0.011);
  // Before the box along x, inside of it along y and z; then behind it.
  this->Probe->SetCroppingRegionFlags(1 << 12);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 2), 1e-3);
  this->Probe->SetCroppingRegionFlags(1 << 14);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 3), 1e-3);
  EXPECT_NEAR(this->Get("x"), 8, 0.011);
  this->Probe->SetCroppingRegionFlags(0);
  this->Probe->Update();
  EXPECT_EQ(this->Probe->GetOutput(0)->GetNumberOfRows(), 0);
  this->Probe->UseCroppingOff();
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 10), 1e-9);
}

TEST_F(RayProbe, ARectilinearGridIsWhereItsCoordinatesAre)
{
  // x in [0, 10] with uneven steps, from index 3 on; P is x^2 at the points.
  const double places[] = { 0, 1, 1.5, 4, 10 };
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetExtent(3, 7, 0, 10, 0, 10);
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> even;
  for (const double place : places)
  {
    x->InsertNextValue(place);
  }
  for (int i = 0; i < 11; ++i)
  {
    even->InsertNextValue(i);
  }
  grid->SetXCoordinates(x);
  grid->SetYCoordinates(even);
  grid->SetZCoordinates(even);
  for (const char* name : { "P", "S" })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double p[3];
      grid->GetPoint(i, p);
      array->InsertNextValue(*name == 'P' ? p[0] * p[0] / 10 : 0.0);
    }
    grid->GetPointData()->AddArray(array);
  }
  this->Probe->SetInputDataObject(grid);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 10), 1e-9);
  const double depth = std::log(0.5) / std::log(0.9); // 6.58, between 4 and 10
  EXPECT_NEAR(this->Get("x"), depth, 0.011);
  EXPECT_NEAR(this->Get("P"), 1.6 + (this->Get("x") - 4) / 6 * 8.4, 1e-9);
  EXPECT_EQ(this->Get("i"), 6);
  EXPECT_EQ(this->Get("j"), 5);
  this->Probe->UseCroppingOn();
  this->Probe->SetCroppingScale(0.5, 1, 1);
  EXPECT_NEAR(this->Get("total_opacity"), 1 - std::pow(0.9, 5), 1e-3);

  // On cells: the third one, from 1.5 to 4, has its own value in its middle.
  this->Probe->UseCroppingOff();
  vtkNew<vtkPointDataToCellData> convert;
  convert->SetInputData(grid);
  convert->PassPointDataOff();
  convert->Update();
  this->Probe->SetInputDataObject(convert->GetOutput());
  this->Probe->SetThreshold(1 - std::pow(0.9, 2.75));
  EXPECT_NEAR(this->Get("x"), 2.75, 0.011);
  EXPECT_EQ(this->Get("i"), 5);
  EXPECT_NEAR(this->Get("P"), (0.225 + 1.6) / 2, 0.01);
}

TEST_F(RayProbe, BadInput)
{
  this->Probe->SetThreshold(0);
  this->ExpectError("Threshold is 0");
  this->Probe->SetThreshold(0.5);
  this->Probe->SetUnitDistance(0);
  this->ExpectError("UnitDistance");
  this->Probe->SetUnitDistance(1);
  this->Probe->SetEndPoint(this->Probe->GetStartPoint());
  this->ExpectError("the same");
  this->Probe->SetEndPoint(20, 5, 5);
  this->Probe->SetSampleDistance(1e-9);
  this->ExpectError("SampleDistance");
  this->Probe->SetSampleDistance(0);
  const double flat[16] = { 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  this->Probe->SetTransform(flat);
  this->ExpectError("singular");
  const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  this->Probe->SetTransform(identity);
  auto image = MakeImage(0, 10);
  image->GetPointData()->RemoveArray("S");
  this->Probe->SetInputDataObject(image);
  this->ExpectError("'S'");
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  mesh->SetPoints(points);
  this->Probe->SetInputDataObject(mesh);
  this->ExpectError("vtkPolyData");
  vtkNew<vtkImageData> empty;
  this->Probe->SetInputDataObject(empty);
  this->ExpectError("empty");
}
