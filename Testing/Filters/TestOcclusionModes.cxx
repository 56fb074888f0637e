// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterVolumes.h"

#include "Filters/vtkTFCOcclusion.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace testing_volumes;

namespace
{
const char* const Result = "a_occlusion";

/**
 * Weighted mean of M over the samples within `radius`, by the definition.
 */
template <typename Mapping, typename Weight>
double Reference(vtkImageData* image, int x, int y, int z, double radius, Mapping&& map,
  Weight&& weigh)
{
  const int* n = image->GetDimensions();
  const double* h = image->GetSpacing();
  auto* values = image->GetPointData()->GetArray("a");
  double sum = 0., total = 0.;
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        const double d = std::hypot((i - x) * h[0], (j - y) * h[1], (k - z) * h[2]);
        const double v = values->GetTuple1((k * n[1] + j) * n[0] + i);
        if (d <= radius * (1. + 1e-9) && !std::isnan(v))
        {
          sum += weigh(d / radius) * map(v);
          total += weigh(d / radius);
        }
      }
    }
  }
  return sum / total;
}

template <typename Mapping, typename Weight>
void Compare(vtkTFCOcclusion* filter, vtkImageData* image, double radius, Mapping&& map,
  Weight&& weigh)
{
  auto* result = Compute(filter, image, Result);
  ASSERT_NE(result, nullptr);
  const int* n = image->GetDimensions();
  for (vtkIdType i = 0; i < result->GetNumberOfTuples(); i += 7)
  {
    const int x = i % n[0], y = i / n[0] % n[1], z = i / n[0] / n[1];
    if (std::isnan(image->GetPointData()->GetArray("a")->GetTuple1(i)))
    {
      EXPECT_TRUE(std::isnan(result->GetTuple1(i)));
      continue;
    }
    ASSERT_NEAR(result->GetTuple1(i), Reference(image, x, y, z, radius, map, weigh), 5e-6);
  }
}

const auto Same = [](double v) { return v; };
const auto One = [](double) { return 1.; };
}

TEST(OcclusionModes, SpectrumMatchesDefinition)
{
  for (const bool holes : { false, true })
  {
    const auto image = MakeVolume(13, 11, 9,
      [&](int x, int y, int z) { return holes && (x + y) % 4 == 1 ? NaN : Noise(x, y, z); });
    vtkNew<vtkTFCOcclusion> filter;
    filter->SetMetric(vtkTFCOcclusion::SPECTRUM);
    filter->SetNeighborhood(vtkTFCOcclusion::SPHERE);
    filter->SetRadius(3.5);
    Compare(filter.Get(), image, 3.5, Same, One);
    filter->SetDistanceWeight(vtkTFCOcclusion::GAUSSIAN);
    Compare(filter.Get(), image, 3.5, Same, [](double q) { return std::exp(-2. * q * q); });
    filter->SetDistanceWeight(vtkTFCOcclusion::LINEAR);
    Compare(filter.Get(), image, 3.5, Same, [](double q) { return 1. - q / (1. + 1. / 3.5); });
    filter->SetMapping(vtkTFCOcclusion::TRUNCATED_RAMP);
    filter->SetMappingRange(0., 2.);
    Compare(
      filter.Get(), image, 3.5, [](double v) { return v > 0. && v < 2. ? v : 0.; },
      [](double q) { return 1. - q / (1. + 1. / 3.5); });
  }
}

TEST(OcclusionModes, TruncatedRampOverBoxes)
{
  // The box of the whole volume: the mean of what the interval keeps.
  const auto image = MakeVolume(6, 6, 6, Noise);
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetMetric(vtkTFCOcclusion::SPECTRUM);
  filter->SetMapping(vtkTFCOcclusion::TRUNCATED_RAMP);
  filter->SetMappingRange(1., 2.5);
  filter->SetRadius(6);
  auto* result = Compute(filter.Get(), image, Result);
  ASSERT_NE(result, nullptr);
  double sum = 0.;
  for (vtkIdType i = 0; i < 216; ++i)
  {
    const double v = image->GetPointData()->GetArray("a")->GetTuple1(i);
    sum += v > 1. && v < 2.5 ? v : 0.;
  }
  EXPECT_NEAR(result->GetTuple1(0), sum / 216., 1e-6);
  EXPECT_NEAR(result->GetTuple1(100), sum / 216., 1e-6);
}

TEST(OcclusionModes, WorldUnitsMakeRoundNeighbourhoods)
{
  const auto image = MakeVolume(14, 12, 10, Noise);
  image->SetSpacing(0.5, 1., 2.);
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetLengthUnit(vtkTFCPropertyFilter::WORLD);
  filter->SetMetric(vtkTFCOcclusion::SPECTRUM);
  filter->SetNeighborhood(vtkTFCOcclusion::SPHERE);
  filter->SetRadius(3.);
  Compare(filter.Get(), image, 3., Same, One);

  // A box of 3 world units to either side: 6, 3 and 1 voxels.
  filter->SetNeighborhood(vtkTFCOcclusion::BOX);
  auto* result = Compute(filter.Get(), image, Result);
  double sum = 0.;
  for (int z = 4; z <= 6; ++z)
  {
    for (int y = 2; y <= 8; ++y)
    {
      for (int x = 1; x <= 13; ++x)
      {
        sum += Noise(x, y, z);
      }
    }
  }
  EXPECT_NEAR(result->GetTuple1((5 * 12 + 5) * 14 + 7), sum / (3 * 7 * 13), 1e-6);
}

TEST(OcclusionModes, BoundaryTermMultiplies)
{
  for (const int neighborhood : { vtkTFCOcclusion::BOX, vtkTFCOcclusion::SPHERE })
  {
    const auto image = MakeVolume(9, 8, 7, Noise);
    vtkNew<vtkTFCOcclusion> filter;
    filter->SetNeighborhood(neighborhood);
    filter->SetRadius(3);
    filter->SetBoundaryParameter(0.2);
    vtkNew<vtkFloatArray> with;
    with->DeepCopy(Compute(filter.Get(), image, Result));
    filter->BoundaryTermOff();
    auto* without = Compute(filter.Get(), image, Result);
    // Interior sample: per-voxel gradient, relative to the range.
    double range[2];
    image->GetPointData()->GetArray("a")->GetRange(range);
    const double span = range[1] - range[0];
    const double gx = (Noise(5, 4, 3) - Noise(3, 4, 3)) / 2. / span;
    const double gy = (Noise(4, 5, 3) - Noise(4, 3, 3)) / 2. / span;
    const double gz = (Noise(4, 4, 4) - Noise(4, 4, 2)) / 2. / span;
    const double factor = 0.04 / (0.04 + gx * gx + gy * gy + gz * gz);
    const vtkIdType i = (3 * 8 + 4) * 9 + 4;
    EXPECT_NEAR(with->GetValue(i), factor * without->GetTuple1(i), 1e-6);
  }
}

TEST(OcclusionModes, AutoRadiusMaximisesTheVariance)
{
  // Slabs of alternating sign with a period of 12: a box of 13 averages them away, and
  // one of 19 takes one and a half.
  const auto image = MakeVolume<vtkFloatArray>(480, 4, 4,
    [](int x, int y, int z) { return (x / 6 % 2 ? 1. : -1.) * (1. + 0.001 * Noise(x, y, z)); });
  const auto variance = [&](double radius)
  {
    vtkNew<vtkTFCOcclusion> filter;
    filter->BoundaryTermOff();
    filter->SetRadius(radius);
    auto* result = Compute(filter.Get(), image, Result);
    double sum = 0., squares = 0.;
    const double n = static_cast<double>(result->GetNumberOfTuples());
    for (vtkIdType i = 0; i < result->GetNumberOfTuples(); ++i)
    {
      sum += result->GetTuple1(i);
      squares += result->GetTuple1(i) * result->GetTuple1(i);
    }
    return squares / n - sum * sum / n / n;
  };
  vtkNew<vtkTFCOcclusion> filter;
  filter->BoundaryTermOff();
  filter->AutoRadiusOn();
  // From 6 on, where the variance is near its minimum, to 12: the maximum is inside, near 9.
  filter->SetAutoRadiusRange(6., 12.);
  auto* result = vtkFloatArray::SafeDownCast(Compute(filter.Get(), image, Result));
  ASSERT_NE(result, nullptr);
  int best = 6;
  for (int radius = 7; radius <= 12; ++radius)
  {
    best = variance(radius) > variance(best) ? radius : best;
  }
  EXPECT_EQ(filter->GetUsedRadius(), best);
  EXPECT_GT(best, 6);
  EXPECT_LT(best, 12);
  auto* told = filter->GetOutput()->GetFieldData()->GetArray("a_occlusion_radius");
  ASSERT_NE(told, nullptr);
  EXPECT_EQ(told->GetTuple1(0), best);
  // The array is that of the chosen radius.
  vtkNew<vtkTFCOcclusion> fixed;
  fixed->BoundaryTermOff();
  fixed->SetRadius(best);
  EXPECT_EQ(GetBytes(result), GetBytes(Compute(fixed.Get(), image, Result)));
}

TEST(OcclusionModes, SameBitsOnEveryProcessorAndThreadCount)
{
  for (const bool holes : { false, true })
  {
    const auto image = MakeVolume<vtkFloatArray>(61, 40, 33,
      [&](int x, int y, int z) { return holes && x == 7 && y > 3 ? NaN : Noise(x, y, z); });
    for (const int neighborhood : { vtkTFCOcclusion::BOX, vtkTFCOcclusion::SPHERE })
    {
      std::string first;
      for (const char* level : { "baseline", "avx2", "avx512" })
      {
        for (const int number : { 1, 2, 4 })
        {
          const SimdLimit limit(level);
          const Threads threads(number);
          vtkNew<vtkTFCOcclusion> filter;
          filter->SetNeighborhood(neighborhood);
          filter->SetRadius(5);
          const std::string bytes = GetBytes(Compute(filter.Get(), image, Result));
          ASSERT_FALSE(bytes.empty());
          first = first.empty() ? bytes : first;
          EXPECT_TRUE(first == bytes) << level << ", " << number << " threads";
        }
      }
    }
  }
}
