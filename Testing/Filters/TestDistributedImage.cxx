// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterVolumes.h"

#include "Filters/vtkTFCDistributedImage.h"
#include "Filters/vtkTFCGradientMagnitude.h"
#include "Filters/vtkTFCOcclusion.h"

#include "vtkCellData.h"
#include "vtkImageAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_volumes;

// Several processes are the subject of mpi_pieces.py; here is what one process can tell.

namespace
{
using Extent = vtkTFCDistributedImage::Extent;

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int Cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;

/**
 * A source that produces what it is asked for and no more.
 */
class PartialSource : public vtkImageAlgorithm
{
public:
  static PartialSource* New();
  vtkTypeMacro(PartialSource, vtkImageAlgorithm);

protected:
  PartialSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**,
    vtkInformationVector* outputVector) override
  {
    auto* info = outputVector->GetInformationObject(0);
    const int whole[6] = { 0, 19, 0, 14, 0, 9 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**,
    vtkInformationVector* outputVector) override
  {
    int e[6];
    outputVector->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
      e);
    auto* image = vtkImageData::GetData(outputVector);
    image->SetExtent(e);
    image->GetPointData()->SetScalars(MakeArray("a", e[1] - e[0] + 1, e[3] - e[2] + 1,
      e[5] - e[4] + 1, [&](int x, int y, int z) { return Noise(x + e[0], y + e[2], z + e[4]); }));
    return 1;
  }
};
vtkStandardNewMacro(PartialSource);
}

TEST(DistributedImage, LatticesOfPointsAndCells)
{
  const auto image = MakeImage(5, 4, 1);
  const vtkTFCDistributedImage points(image, Points, nullptr);
  EXPECT_EQ(points.GetNumberOfRanks(), 1);
  EXPECT_EQ(points.GetLocalExtent(), (Extent{ 3, 7, -2, 1, 7, 7 }));
  EXPECT_EQ(points.GetWholeExtent(), points.GetLocalExtent());
  EXPECT_EQ(points.GetGrownExtent(40), points.GetLocalExtent());
  EXPECT_TRUE(points.GetOwnedSamples().empty());
  const vtkTFCDistributedImage cells(image, Cells, nullptr);
  EXPECT_EQ(cells.GetLocalExtent(), (Extent{ 3, 6, -2, 0, 7, 7 }));
  EXPECT_EQ(vtkTFCDistributedImage::GetNumberOfSamples(cells.GetLocalExtent()),
    image->GetNumberOfCells());
}

TEST(DistributedImage, EmptyAndUnstructured)
{
  vtkNew<vtkImageData> image;
  const vtkTFCDistributedImage empty(image, Points, nullptr);
  EXPECT_EQ(vtkTFCDistributedImage::GetNumberOfSamples(empty.GetWholeExtent()), 0);
  EXPECT_EQ(vtkTFCDistributedImage::GetNumberOfSamples(empty.GetGrownExtent(3)), 0);
  EXPECT_TRUE(empty.GetOwnedSamples().empty());
  float none = 0.f;
  empty.Exchange(nullptr, 2, &none);
  EXPECT_EQ(empty.ShareText(false, ""), "");
  EXPECT_EQ(empty.ShareText(true, "x"), "x");
  EXPECT_FALSE(empty.Any(false));
  EXPECT_TRUE(empty.All(true));
}

TEST(DistributedImage, GhostLayersAreNotOwned)
{
  // The first cell layer along x is a ghost: its inner face belongs to this piece.
  const auto image = MakeImage(5, 3, 3);
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int i = 0; i < 4 * 2 * 2; ++i)
  {
    flags->InsertNextValue(i % 4 == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  image->GetCellData()->AddArray(flags);
  const auto points = vtkTFCDistributedImage(image, Points, nullptr).GetOwnedSamples();
  ASSERT_EQ(points.size(), 45u);
  const auto cells = vtkTFCDistributedImage(image, Cells, nullptr).GetOwnedSamples();
  ASSERT_EQ(cells.size(), 16u);
  for (int i = 0; i < 45; ++i)
  {
    EXPECT_EQ(points[i], i % 5 != 0);
  }
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_EQ(cells[i], i % 4 != 0);
  }
}

TEST(DistributedImage, PointFlagsAlone)
{
  const auto image = MakeImage(4, 4, 2);
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int i = 0; i < 32; ++i)
  {
    flags->InsertNextValue(i % 4 == 3 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  image->GetPointData()->AddArray(flags);
  const auto owned = vtkTFCDistributedImage(image, Points, nullptr).GetOwnedSamples();
  ASSERT_EQ(owned.size(), 32u);
  EXPECT_EQ(owned[2], 1);
  EXPECT_EQ(owned[3], 0);
}

TEST(DistributedImage, PartsRequestedDownstreamGetTheValuesOfTheWhole)
{
  vtkNew<PartialSource> source;
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetRadius(4);
  filter->SetInputConnection(source->GetOutputPort());
  filter->UpdateWholeExtent();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(filter->GetImageDataOutput());

  vtkNew<PartialSource> again;
  filter->SetInputConnection(again->GetOutputPort());
  int part[6] = { 5, 8, 2, 6, 4, 4 };
  filter->UpdateExtent(part);
  auto* output = filter->GetImageDataOutput();
  auto* values = output->GetPointData()->GetArray("a_occlusion");
  auto* expected = whole->GetPointData()->GetArray("a_occlusion");
  ASSERT_NE(values, nullptr);
  for (int x = 5; x <= 8; ++x)
  {
    int ijk[3] = { x, 3, 4 };
    EXPECT_EQ(values->GetTuple1(output->ComputePointId(ijk)),
      expected->GetTuple1(whole->ComputePointId(ijk)));
  }
}
