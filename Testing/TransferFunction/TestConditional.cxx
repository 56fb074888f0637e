// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The editor's histogram of a region, from a joint histogram, against weighing every voxel.
#include "ModelTesting.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTFCJointHistogram.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionHistograms.h"
#include "vtkTFCSparseHistogram.h"

#include <cmath>
#include <numeric>
#include <random>

using namespace ModelTesting;

namespace
{

constexpr int TertiaryBins = 64;
const double Ranges[4] = { -20, 60, 1e5, 1.002e5 };

// Three attributes that depend on each other: the third one differs between places of the plane.
struct Voxels
{
  Voxels()
  {
    this->Image->SetDimensions(50, 50, 40);
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, 1);
    const char* names[3] = { "P", "S", "T" };
    vtkNew<vtkDoubleArray> arrays[3];
    for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
    {
      const double p = 20 + 18 * noise(random);
      const double s = 1.001e5 + 40 * noise(random);
      const double t = 0.4 * p + 0.1 * (s - 1.001e5) + 3 * noise(random);
      this->Values.push_back({ p, s, i % 41 == 3 ? std::nan("") : t });
      for (int a = 0; a < 3; ++a)
      {
        arrays[a]->InsertNextValue(this->Values.back()[static_cast<size_t>(a)]);
      }
    }
    for (int a = 0; a < 3; ++a)
    {
      arrays[a]->SetName(names[a]);
      this->Image->GetPointData()->AddArray(arrays[a]);
    }
  }

  // As the editor has it from the server: bins of the plane on each axis, 64 of the third.
  vtkSmartPointer<vtkTFCSparseHistogram> Count(int bins) const
  {
    vtkNew<vtkTFCJointHistogram> filter;
    const char* names[3] = { "P", "S", "T" };
    for (int a = 0; a < 3; ++a)
    {
      filter->SetArray(a, names[a]);
      filter->SetNumberOfBins(a, a < 2 ? bins : TertiaryBins);
    }
    filter->SetRange(0, Ranges[0], Ranges[1]);
    filter->SetRange(1, Ranges[2], Ranges[3]);
    filter->SetRange(2, -20, 40);
    filter->SetController(nullptr);
    filter->SetInputDataObject(this->Image);
    filter->Update();
    auto histogram = vtkSmartPointer<vtkTFCSparseHistogram>::New();
    histogram->DeepCopy(filter->GetHistogram());
    return histogram;
  }

  // Every voxel by itself, with its own values.
  std::vector<double> Weigh(vtkTFCTransferFunction* model, const vtkTFCSparseHistogram* bins) const
  {
    const vtkTFCCompiledModel compiled = model->Compile(Ranges);
    std::vector<double> counts(TertiaryBins, 0.);
    for (const auto& v : this->Values)
    {
      const double x = (v[0] - Ranges[0]) / (Ranges[1] - Ranges[0]);
      const double y = (v[1] - Ranges[2]) / (Ranges[3] - Ranges[2]);
      const int bin = bins->GetBin(2, v[2]);
      if (bin >= 0 && x >= 0 && x <= 1 && y >= 0 && y <= 1)
      {
        counts[static_cast<size_t>(bin)] +=
          vtkTFCClassifier::RegionWeight(compiled.Regions[0], x, y);
      }
    }
    return counts;
  }

  vtkNew<vtkImageData> Image;
  std::vector<std::array<double, 3>> Values;
};

// Sum of the differences of all bins, as a part of the voxels in the region.
double Difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i)
  {
    sum += std::abs(a[i] - b[i]);
  }
  return sum / std::accumulate(b.begin(), b.end(), 0.);
}

const char* const Shapes[] = {
  R"({"type": "ellipse", "center": [15, 100080], "radii": [25, 60], "angle": 30})",
  R"({"type": "rectangle", "center": [30, 100120], "halfsize": [18, 50], "angle": -15})",
  R"({"type": "triangle", "points": [[-10, 100020], [55, 100060], [10, 100190]]})",
  R"({"type": "polygon", "points": [[-10, 100020], [20, 100060], [55, 100030], [40, 100180],
     [0, 100150]]})",
};
const char* const Falloffs[] = {
  R"({"type": "linear", "width": 0.8})",
  R"({"type": "smooth", "width": 0.5})",
  R"({"type": "gaussian", "width": 0.4})",
};

}

TEST(Conditional, EqualsWeighingEveryVoxelWithinTheBins)
{
  const Voxels voxels;
  const auto coarse = voxels.Count(32);
  const auto fine = voxels.Count(128);
  for (const char* shape : Shapes)
  {
    for (const char* falloff : Falloffs)
    {
      vtkNew<vtkTFCTransferFunction> model;
      ASSERT_TRUE(model->SetState(
        State(R"({"id": 5, "opacity": 0.1, "shape": )" + std::string(shape) + R"(, "falloff": )" +
          falloff + R"(, "tertiary": {"array": "T", "opacity": [[0, 0], [10, 1]]}})")
          .c_str()))
        << model->GetLastError();
      vtkTFCRegion* region = model->GetRegion(0);
      const std::vector<double> expected = voxels.Weigh(model, fine);
      ASSERT_GT(std::accumulate(expected.begin(), expected.end(), 0.), 5000);
      const double atFine =
        Difference(vtkTFCRegionHistograms::MakeConditional(fine, model, region, Ranges), expected);
      const double atCoarse = Difference(
        vtkTFCRegionHistograms::MakeConditional(coarse, model, region, Ranges), expected);
      // A voxel is at most half a bin from where it is weighed, either way: what is left of that is
      // below 1 %, and with bins that are four times as wide it is more.
      EXPECT_LT(atFine, 0.01) << shape << falloff;
      EXPECT_LT(atCoarse, 0.05) << shape << falloff;
      EXPECT_LT(atFine, atCoarse) << shape << falloff;
      // It is the region's own, and not that of all voxels.
      const std::vector<float> ones(128 * 128, 1.F);
      std::vector<double> all(TertiaryBins);
      fine->GetConditional(ones.data(), all.data());
      EXPECT_GT(Difference(all, expected), 0.5);
    }
  }
}

TEST(Conditional, IsOfTheShapeAlone)
{
  const Voxels voxels;
  const auto histogram = voxels.Count(128);
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(State(R"({"id": 5, "shape": )" + std::string(Shapes[0]) +
    R"(}, {"id": 6, "shape": )" + std::string(Shapes[1]) + "}")
                                .c_str()));
  vtkTFCRegion* region = model->GetRegion(0);
  const auto expected = vtkTFCRegionHistograms::MakeConditional(histogram, model, region, Ranges);
  EXPECT_GT(std::accumulate(expected.begin(), expected.end(), 0.), 5000);
  const std::string before = model->GetState();
  region->SetVisible(false);
  region->SetOpacity(0);
  model->SetBlend(vtkTFCTransferFunction::Over);
  model->SetHighlightedRegion(6);
  EXPECT_EQ(vtkTFCRegionHistograms::MakeConditional(histogram, model, region, Ranges), expected);
  region->SetVisible(true);
  region->SetOpacity(1);
  model->SetBlend(vtkTFCTransferFunction::Mix);
  EXPECT_EQ(model->GetState(), before);
}
