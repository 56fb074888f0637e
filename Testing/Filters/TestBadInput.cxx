// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterVolumes.h"

#include "Filters/vtkTFCCombinationScore.h"
#include "Filters/vtkTFCGradientMagnitude.h"
#include "Filters/vtkTFCOcclusion.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_volumes;

namespace
{
/**
 * Runs a filter on array `a`: an empty output, and an error that mentions `what`.
 */
template <typename Filter>
void ExpectRefusal(Filter* filter, vtkImageData* image, const std::string& what,
  const char* array = "a", int association = vtkDataObject::POINT)
{
  const Errors errors(filter);
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, association, array);
  filter->Update();
  EXPECT_TRUE(errors.Mention(what)) << "expected: " << what << "\nreported: " << errors.Text;
  auto* output = filter->GetImageDataOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(output->GetCellData()->GetNumberOfArrays(), 0);
}

/**
 * The same for the score: no rows.
 */
void ExpectNoScores(vtkTFCCombinationScore* filter, vtkDataSet* data, const std::string& what)
{
  const Errors errors(filter);
  filter->SetInputData(data);
  filter->Update();
  EXPECT_TRUE(errors.Mention(what)) << "expected: " << what << "\nreported: " << errors.Text;
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
}
}

TEST(BadInput, MissingArrayListsWhatThereIs)
{
  const auto image = MakeVolume(4, 4, 4, Noise);
  image->GetCellData()->AddArray(MakeArray("c", 3, 3, 3, Noise));
  vtkNew<vtkTFCGradientMagnitude> filter;
  ExpectRefusal(filter.Get(), image,
    "no point or cell array 'density'. Set InputArray to one of the point arrays 'a' or the cell "
    "arrays 'c'",
    "density");
  ExpectRefusal(filter.Get(), image, "no point or cell array 'a'", "a", vtkDataObject::CELL);
  vtkNew<vtkTFCGradientMagnitude> withoutChoice;
  withoutChoice->SetInputData(MakeImage(3, 3, 3));
  const Errors errors(withoutChoice.Get());
  withoutChoice->Update();
  EXPECT_TRUE(errors.Mention("'(active scalars)'")) << errors.Text;
  EXPECT_TRUE(errors.Mention("point arrays none")) << errors.Text;
}

TEST(BadInput, TextArray)
{
  const auto image = MakeImage(2, 2, 2);
  vtkNew<vtkStringArray> text;
  text->SetName("a");
  text->SetNumberOfValues(8);
  image->GetPointData()->AddArray(text);
  vtkNew<vtkTFCOcclusion> filter;
  ExpectRefusal(filter.Get(), image, "holds text");
}

TEST(BadInput, FieldData)
{
  const auto image = MakeImage(2, 2, 2);
  image->GetFieldData()->AddArray(MakeArray("a", 2, 2, 2, Noise));
  vtkNew<vtkTFCOcclusion> filter;
  ExpectRefusal(filter.Get(), image, "no point or cell array", "a", vtkDataObject::FIELD);
}

TEST(BadInput, WrongComponent)
{
  const auto image = MakeVolume(4, 4, 4, Noise);
  vtkNew<vtkTFCGradientMagnitude> filter;
  for (const int component : { -2, 1, 1000 })
  {
    filter->SetComponent(component);
    ExpectRefusal(filter.Get(), image,
      "Component " + std::to_string(component) + " of the array 'a'");
  }
}

TEST(BadInput, WrongSize)
{
  const auto image = MakeImage(4, 4, 4);
  image->GetPointData()->AddArray(MakeArray("a", 4, 4, 3, Noise));
  vtkNew<vtkTFCOcclusion> filter;
  ExpectRefusal(filter.Get(), image, "has 48 values, but the volume has 64");
}

TEST(BadInput, EmptyVolume)
{
  vtkNew<vtkImageData> image;
  vtkNew<vtkTFCOcclusion> occlusion;
  ExpectRefusal(occlusion.Get(), image, "The input is empty");
  vtkNew<vtkTFCGradientMagnitude> gradient;
  ExpectRefusal(gradient.Get(), image, "The input is empty");
  vtkNew<vtkTFCCombinationScore> score;
  ExpectNoScores(score.Get(), image, "The input is empty");
}

TEST(BadInput, NothingValid)
{
  const auto image = MakeVolume(4, 4, 4, [](int x, int, int) { return x ? NaN : INFINITY; });
  vtkNew<vtkTFCOcclusion> filter;
  ExpectRefusal(filter.Get(), image, "no valid value");
  const auto blanked = MakeVolume(4, 4, 4, Noise);
  Blank(blanked, [](vtkIdType) { return true; });
  ExpectRefusal(filter.Get(), blanked, "no valid value");
}

TEST(BadInput, ZeroSpacing)
{
  const auto image = MakeVolume(4, 4, 4, Noise);
  image->SetSpacing(1., 0., 1.);
  vtkNew<vtkTFCGradientMagnitude> filter;
  ExpectRefusal(filter.Get(), image, "spacing of the volume along axis 1");
}

TEST(BadInput, OcclusionParameters)
{
  const auto image = MakeVolume(4, 4, 4, Noise);
  vtkNew<vtkTFCOcclusion> filter;
  for (const int radius : { 0, -5 })
  {
    filter->SetRadius(radius);
    ExpectRefusal(filter.Get(), image, "Radius is " + std::to_string(radius));
  }
  for (const double radius : { NaN, static_cast<double>(INFINITY) })
  {
    filter->SetRadius(radius);
    ExpectRefusal(filter.Get(), image, "Radius is");
  }
  filter->SetRadius(0.5);
  ExpectRefusal(filter.Get(), image, "Radius is 0.5 voxels, less than one voxel");
  filter->SetRadius(5);
  ExpectRefusal(filter.Get(), image, "longer than the volume, whose longest side has 4");
  filter->SetLengthUnit(vtkTFCPropertyFilter::WORLD);
  image->SetSpacing(0.1, 0.2, 0.1);
  ExpectRefusal(filter.Get(), image, "longer than the volume, whose longest side has 0.8");
  filter->SetRadius(0.05);
  ExpectRefusal(filter.Get(), image, "less than one voxel. Set it to 0.1 or more");
  filter->SetRadius(0.2);
  for (const double eta : { 0., -1., NaN, static_cast<double>(INFINITY) })
  {
    filter->SetBoundaryParameter(eta);
    ExpectRefusal(filter.Get(), image, "BoundaryParameter is");
  }
  filter->BoundaryTermOff();
  EXPECT_NE(Compute(filter.Get(), image, "a_occlusion"), nullptr);
}

TEST(BadInput, SpectrumParameters)
{
  const auto image = MakeVolume(4, 4, 4, Noise);
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetRadius(2);
  filter->SetMetric(vtkTFCOcclusion::SPECTRUM);
  filter->SetMapping(vtkTFCOcclusion::TRUNCATED_RAMP);
  filter->SetMappingRange(3., 3.);
  ExpectRefusal(filter.Get(), image, "MappingRange is 3 to 3, which is empty");
  filter->SetMapping(vtkTFCOcclusion::LINEAR_RAMP);
  filter->SetDistanceWeight(vtkTFCOcclusion::GAUSSIAN);
  ExpectRefusal(filter.Get(), image, "Set Neighborhood to Sphere");
  filter->SetNeighborhood(vtkTFCOcclusion::SPHERE);
  filter->AutoRadiusOn();
  filter->SetAutoRadiusRange(4., 2.);
  ExpectRefusal(filter.Get(), image, "AutoRadiusRange is 4 to 2");
  filter->SetAutoRadiusRange(0., 2.);
  ExpectRefusal(filter.Get(), image, "AutoRadiusRange is 0 to 2");
  filter->SetAutoRadiusRange(1., 100.);
  EXPECT_NE(Compute(filter.Get(), image, "a_occlusion"), nullptr);
}

TEST(BadInput, MemoryThatWillNotSuffice)
{
  const auto image = MakeVolume(64, 64, 64, Noise);
  vtkNew<vtkTFCOcclusion> filter;
  setenv("TFC_MEMORY_LIMIT", "1", 1);
  ExpectRefusal(filter.Get(), image, "MiB of memory for 'a', and 1 MiB are available");
  unsetenv("TFC_MEMORY_LIMIT");
  EXPECT_NE(Compute(filter.Get(), image, "a_occlusion"), nullptr);
}

TEST(BadInput, FurtherArrays)
{
  const auto image = MakeVolume(4, 4, 4, Noise);
  image->GetPointData()->AddArray(MakeArray("b", 4, 4, 4, Noise));
  vtkNew<vtkTFCGradientMagnitude> filter;
  filter->AddArray("c");
  ExpectRefusal(filter.Get(), image, "no point or cell array 'c'");
  filter->ClearArrays();
  filter->AddArray("b");
  filter->AddArray("a");
  EXPECT_NE(Compute(filter.Get(), image, "a_gradient"), nullptr);
  EXPECT_NE(filter->GetImageDataOutput()->GetPointData()->GetArray("b_gradient"), nullptr);
  EXPECT_EQ(filter->GetImageDataOutput()->GetPointData()->GetNumberOfArrays(), 4);
}

TEST(BadInput, ScoreParametersAndArrays)
{
  const auto image = MakeVolume(4, 4, 4, Noise);
  vtkNew<vtkTFCCombinationScore> filter;
  for (const double balance : { 1., -0.1, 7., NaN })
  {
    filter->SetBalance(balance);
    ExpectNoScores(filter.Get(), image, "Balance is");
  }
  filter->SetBalance(0.4);
  filter->SetNumberOfBins(1);
  ExpectNoScores(filter.Get(), image, "NumberOfBins is 1");
  filter->SetNumberOfBins(256);
  filter->AddArray("b");
  ExpectNoScores(filter.Get(), image, "no array 'b'. Choose from the point arrays 'a'");
  filter->ClearArrays();
  filter->SetPrimary("a:5");
  ExpectNoScores(filter.Get(), image, "no component '5'");
  filter->SetPrimary("a:");
  filter->SetSecondary("a:x");
  ExpectNoScores(filter.Get(), image, "no component 'x'");
  filter->SetPrimary(nullptr);
  filter->SetSecondary(nullptr);
  ExpectNoScores(filter.Get(), MakeImage(3, 3, 3), "no numeric single-component array");
  auto mixed = MakeVolume(4, 4, 4, Noise);
  mixed->GetCellData()->AddArray(MakeArray("c", 3, 3, 3, Noise));
  filter->SetPrimary("a");
  filter->SetSecondary("c");
  ExpectNoScores(filter.Get(), mixed, "'c' is a cell array");
  // In a list of arrays, such as ParaView's default, it is left out.
  vtkNew<vtkTFCCombinationScore> ofMixed;
  std::string warning;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&warning);
  listen->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  ofMixed->AddObserver(vtkCommand::WarningEvent, listen);
  ofMixed->SetInputData(mixed);
  ofMixed->AddArray("a");
  ofMixed->AddArray("c");
  ofMixed->Update();
  EXPECT_EQ(ofMixed->GetOutput()->GetNumberOfRows(), 1);
  EXPECT_NE(warning.find("Left out: 'c'"), std::string::npos) << warning;
  mixed->GetPointData()->AddArray(MakeArray("short", 2, 2, 2, Noise));
  filter->SetSecondary("short");
  ExpectNoScores(filter.Get(), mixed, "'short' has 8 values for 64 points");
}

TEST(BadInput, ScoreOfNothingValid)
{
  // No data is a result here, not an error: nothing can be ranked.
  const auto image = MakeVolume(4, 4, 4, [](int, int, int) { return NaN; });
  image->GetPointData()->AddArray(MakeArray("b", 4, 4, 4, Noise));
  vtkNew<vtkTFCCombinationScore> filter;
  filter->SetInputData(image);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfRows(), 2);
  for (int row = 0; row < 2; ++row)
  {
    EXPECT_EQ(filter->GetOutput()->GetValueByName(row, "rank").ToInt(), 0);
  }

  // Nor is a single array: it is the primary one, and there is no candidate.
  vtkNew<vtkTFCCombinationScore> single;
  single->SetInputData(MakeVolume(4, 4, 4, Noise));
  single->Update();
  ASSERT_EQ(single->GetOutput()->GetNumberOfRows(), 1);
  EXPECT_EQ(single->GetOutput()->GetValueByName(0, "rank").ToInt(), 0);
}
