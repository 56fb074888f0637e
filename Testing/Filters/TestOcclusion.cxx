// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterVolumes.h"

#include "Filters/vtkTFCOcclusion.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkShortArray.h"
#include "vtkUniformGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace testing_volumes;

namespace
{
const char* const Result = "a_occlusion";

/**
 * The metric by its definition; invalid samples are NaN.
 */
std::vector<double> Reference(const std::vector<double>& v, const std::array<int, 3>& n, int radius,
  double eta)
{
  double low = INFINITY, high = -INFINITY;
  for (const double value : v)
  {
    low = value < low ? value : low;
    high = value > high ? value : high;
  }
  const double scale = high > low ? 1. / (high - low) : 0.;
  const auto at = [&](int x, int y, int z)
  {
    const bool inside = x >= 0 && x < n[0] && y >= 0 && y < n[1] && z >= 0 && z < n[2];
    return inside ? v[(static_cast<size_t>(z) * n[1] + y) * n[0] + x] : NaN;
  };
  std::vector<double> out;
  for (int z = 0; z < n[2]; ++z)
  {
    for (int y = 0; y < n[1]; ++y)
    {
      for (int x = 0; x < n[0]; ++x)
      {
        double squared = 0.;
        for (int a = 0; a < 3; ++a)
        {
          const double c = at(x, y, z), l = at(x - (a == 0), y - (a == 1), z - (a == 2)),
                       h = at(x + (a == 0), y + (a == 1), z + (a == 2));
          const double d = !std::isnan(l) && !std::isnan(h) ? (h - l) / 2.
            : !std::isnan(h)                                ? h - c
            : !std::isnan(l)                                ? c - l
                                                            : 0.;
          squared += d * d * scale * scale;
        }
        double sum = 0., count = 0.;
        for (int k = std::max(0, z - radius); k <= std::min(n[2] - 1, z + radius); ++k)
        {
          for (int j = std::max(0, y - radius); j <= std::min(n[1] - 1, y + radius); ++j)
          {
            for (int i = std::max(0, x - radius); i <= std::min(n[0] - 1, x + radius); ++i)
            {
              const double value = at(i, j, k);
              sum += std::isnan(value) ? 0. : value;
              count += std::isnan(value) ? 0. : 1.;
            }
          }
        }
        out.push_back(
          std::isnan(at(x, y, z)) ? NaN : eta * eta / (squared + eta * eta) * sum / count);
      }
    }
  }
  return out;
}

void ExpectNear(vtkDataArray* values, const std::vector<double>& expected, double tolerance)
{
  ASSERT_NE(values, nullptr);
  ASSERT_EQ(values->GetNumberOfTuples(), static_cast<vtkIdType>(expected.size()));
  for (size_t i = 0; i < expected.size(); ++i)
  {
    const double value = values->GetTuple1(static_cast<vtkIdType>(i));
    ASSERT_EQ(std::isnan(value), std::isnan(expected[i])) << i;
    if (!std::isnan(value))
    {
      ASSERT_NEAR(value, expected[i], tolerance) << i;
    }
  }
}
}

TEST(Occlusion, MatchesDefinition)
{
  const std::array<int, 3> sizes[] = { { 9, 7, 5 }, { 8, 10, 6 }, { 12, 1, 1 }, { 1, 1, 9 },
    { 6, 7, 1 }, { 1, 1, 1 } };
  for (const auto& n : sizes)
  {
    for (const int radius : { 1, 2, 4, 12 })
    {
      if (radius > std::max({ n[0], n[1], n[2] }))
      {
        continue;
      }
      for (const int holes : { 0, 5 })
      {
        const auto f = [&](int x, int y, int z)
        { return holes && (x + 2 * y + 3 * z) % holes == 1 ? NaN : Noise(x, y, z); };
        const auto image = MakeVolume(n[0], n[1], n[2], f);
        std::vector<double> values;
        for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
        {
          values.push_back(image->GetPointData()->GetArray("a")->GetTuple1(i));
        }
        vtkNew<vtkTFCOcclusion> filter;
        filter->SetRadius(radius);
        filter->SetBoundaryParameter(0.3);
        ExpectNear(Compute(filter.Get(), image, Result), Reference(values, n, radius, 0.3), 5e-6);
      }
    }
  }
}

TEST(Occlusion, SpacingPlaysNoPart)
{
  const auto image = MakeVolume(7, 6, 5, Noise);
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetRadius(2);
  vtkNew<vtkFloatArray> first;
  first->DeepCopy(Compute(filter.Get(), image, Result));
  image->SetSpacing(0.1, 7., 3.);
  auto* second = Compute(filter.Get(), image, Result);
  for (vtkIdType i = 0; i < second->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(first->GetValue(i), second->GetTuple1(i));
  }
}

TEST(Occlusion, ConstantVolume)
{
  const auto image = MakeVolume<vtkShortArray>(10, 9, 8, [](int, int, int) { return -700; });
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetRadius(4);
  auto* result = Compute(filter.Get(), image, Result);
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->GetRange()[0], -700.);
  EXPECT_EQ(result->GetRange()[1], -700.);
}

TEST(Occlusion, SamplesWithoutNeighbours)
{
  // One valid voxel among invalid ones is its own mean.
  const auto image =
    MakeVolume(5, 5, 5, [](int x, int y, int z) { return x == 2 && y == 2 && z == 2 ? 4. : NaN; });
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetRadius(4);
  auto* result = Compute(filter.Get(), image, Result);
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->GetTuple1(62), 4.);
  EXPECT_TRUE(std::isnan(result->GetTuple1(61)));
}

TEST(Occlusion, BlankedPointsAndCells)
{
  const std::array<int, 3> n{ 6, 5, 4 };
  std::vector<double> values;
  const auto image = MakeVolume<vtkFloatArray>(n[0], n[1], n[2], Noise);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values.push_back(i % 4 == 2 ? NaN : image->GetPointData()->GetArray("a")->GetTuple1(i));
  }
  Blank(image, [](vtkIdType i) { return i % 4 == 2; });
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetRadius(2);
  filter->SetBoundaryParameter(0.3);
  ExpectNear(Compute(filter.Get(), image, Result), Reference(values, n, 2, 0.3), 5e-6);

  // The same samples as cells.
  vtkNew<vtkUniformGrid> grid;
  grid->SetDimensions(n[0] + 1, n[1] + 1, n[2] + 1);
  grid->GetCellData()->AddArray(image->GetPointData()->GetArray("a"));
  for (vtkIdType i = 2; i < grid->GetNumberOfCells(); i += 4)
  {
    grid->BlankCell(i);
  }
  vtkNew<vtkTFCOcclusion> ofCells;
  ofCells->SetRadius(2);
  ofCells->SetBoundaryParameter(0.3);
  ExpectNear(Compute(ofCells.Get(), grid, Result, vtkDataObject::CELL),
    Reference(values, n, 2, 0.3), 5e-6);
  EXPECT_TRUE(ofCells->GetOutput()->IsA("vtkUniformGrid"));
}

TEST(Occlusion, DoesNotDependOnThreads)
{
  for (const bool holes : { false, true })
  {
    const auto image = MakeVolume<vtkFloatArray>(61, 40, 33,
      [&](int x, int y, int z) { return holes && x == 7 && y > 3 ? NaN : Noise(x, y, z); });
    std::vector<float> first;
    for (const int number : { 1, 2, 3, 7 })
    {
      const Threads threads(number);
      vtkNew<vtkTFCOcclusion> filter;
      filter->SetRadius(5);
      auto* result = vtkFloatArray::SafeDownCast(Compute(filter.Get(), image, Result));
      ASSERT_NE(result, nullptr);
      const float* values = result->GetPointer(0);
      if (first.empty())
      {
        first.assign(values, values + result->GetNumberOfValues());
      }
      EXPECT_EQ(std::memcmp(first.data(), values, first.size() * sizeof(float)), 0);
    }
  }
}

class OcclusionOf : public testing::TestWithParam<int>
{
};

TEST_P(OcclusionOf, ProgressAndAbort)
{
  const auto image = MakeVolume<vtkFloatArray>(20, 20, 20, Noise);
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetNeighborhood(this->GetParam());
  filter->SetRadius(4);
  double last = 0.;
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(&last);
  progress->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* data)
    {
      auto* seen = static_cast<double*>(client);
      const double now = *static_cast<double*>(data);
      EXPECT_GE(now, *seen);
      *seen = now;
      if (now > 0.3)
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  EXPECT_EQ(Compute(filter.Get(), image, Result), nullptr);
  EXPECT_GT(last, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Neighborhoods, OcclusionOf,
  testing::Values(vtkTFCOcclusion::BOX, vtkTFCOcclusion::SPHERE));
