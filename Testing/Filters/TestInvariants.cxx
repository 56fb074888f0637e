// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// What flips, transposes, translations and affine changes of the intensity do to the attributes.
#include "FilterVolumes.h"

#include "Filters/vtkTFCGradientMagnitude.h"
#include "Filters/vtkTFCOcclusion.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_volumes;

namespace
{
constexpr int Size[3] = { 17, 14, 12 };

using Run = std::function<vtkDataArray*(vtkImageData*)>;

/**
 * Values of `a` at sample (x, y, z) of the untouched volume.
 */
double Original(int x, int y, int z)
{
  return Noise(x, y, z) + 0.3 * std::sin(0.5 * x + 0.2 * y * z);
}

void ForSamples(const std::function<void(int, int, int)>& body)
{
  for (int z = 0; z < Size[2]; ++z)
  {
    for (int y = 0; y < Size[1]; ++y)
    {
      for (int x = 0; x < Size[0]; ++x)
      {
        body(x, y, z);
      }
    }
  }
}

vtkIdType Index(int x, int y, int z, const int n[3])
{
  return (static_cast<vtkIdType>(z) * n[1] + y) * n[0] + x;
}

/**
 * Checks one attribute. An affine change v -> scale v + shift of the intensity must change the
 * attribute to `change`(attribute, scale, shift).
 */
template <typename Change>
void Check(const Run& run, Change&& change)
{
  const auto image = MakeVolume(Size[0], Size[1], Size[2], Original);
  vtkNew<vtkFloatArray> result;
  result->DeepCopy(run(image));
  const auto expected = [&](int x, int y, int z)
  { return result->GetTuple1(Index(x, y, z, Size)); };

  // Flips.
  const auto flipped = MakeVolume(Size[0], Size[1], Size[2],
    [](int x, int y, int z) { return Original(Size[0] - 1 - x, y, Size[2] - 1 - z); });
  auto* values = run(flipped);
  ForSamples(
    [&](int x, int y, int z)
    {
      ASSERT_NEAR(values->GetTuple1(Index(Size[0] - 1 - x, y, Size[2] - 1 - z, Size)),
        expected(x, y, z), 2e-6);
    });

  // Transpose of x and z.
  const int transposed[3] = { Size[2], Size[1], Size[0] };
  const auto other = MakeVolume(transposed[0], transposed[1], transposed[2],
    [](int x, int y, int z) { return Original(z, y, x); });
  values = run(other);
  ForSamples([&](int x, int y, int z)
    { ASSERT_NEAR(values->GetTuple1(Index(z, y, x, transposed)), expected(x, y, z), 2e-6); });

  // Translation and rotation in space: origin, extent and direction matrix play no part.
  const auto moved = MakeVolume(Size[0], Size[1], Size[2], Original);
  moved->SetOrigin(100., -3., 7.);
  moved->SetExtent(50, 50 + Size[0] - 1, -9, -9 + Size[1] - 1, 0, Size[2] - 1);
  const double turned[9] = { 0., -1., 0., 1., 0., 0., 0., 0., 1. };
  moved->SetDirectionMatrix(turned);
  values = run(moved);
  ForSamples([&](int x, int y, int z)
    { ASSERT_EQ(values->GetTuple1(Index(x, y, z, Size)), expected(x, y, z)); });

  // Affine changes of the intensity.
  for (const double scale : { 250., -3. })
  {
    const auto scaled = MakeVolume(Size[0], Size[1], Size[2],
      [&](int x, int y, int z) { return scale * Original(x, y, z) + 40.; });
    values = run(scaled);
    ForSamples(
      [&](int x, int y, int z)
      {
        ASSERT_NEAR(values->GetTuple1(Index(x, y, z, Size)), change(expected(x, y, z), scale, 40.),
          2e-5 * std::fabs(scale));
      });
  }
}
}

TEST(Invariants, GradientMagnitude)
{
  Check(
    [](vtkImageData* image)
    {
      static vtkNew<vtkTFCGradientMagnitude> filter;
      return Compute(filter.Get(), image, "a_gradient");
    },
    [](double value, double scale, double) { return std::fabs(scale) * value; });
}

TEST(Invariants, Occlusion)
{
  for (const int neighborhood : { vtkTFCOcclusion::BOX, vtkTFCOcclusion::SPHERE })
  {
    // A mean changes as the intensity does.
    Check(
      [&](vtkImageData* image)
      {
        static vtkNew<vtkTFCOcclusion> filter;
        filter->SetNeighborhood(neighborhood);
        filter->SetRadius(3);
        filter->BoundaryTermOff();
        return Compute(filter.Get(), image, "a_occlusion");
      },
      [](double value, double scale, double shift) { return scale * value + shift; });
  }
}

TEST(Invariants, BoundaryFactorIsRelativeToTheRange)
{
  // So that with the factor only a shift of the intensity matters.
  const auto image = MakeVolume(Size[0], Size[1], Size[2], Original);
  const auto scaled = MakeVolume(Size[0], Size[1], Size[2],
    [&](int x, int y, int z) { return 1000. * Original(x, y, z); });
  vtkNew<vtkTFCOcclusion> filter;
  filter->SetRadius(3);
  filter->SetBoundaryParameter(0.2);
  vtkNew<vtkFloatArray> first;
  first->DeepCopy(Compute(filter.Get(), image, "a_occlusion"));
  auto* second = Compute(filter.Get(), scaled, "a_occlusion");
  for (vtkIdType i = 0; i < first->GetNumberOfValues(); ++i)
  {
    ASSERT_NEAR(second->GetTuple1(i), 1000. * first->GetValue(i), 2e-3);
  }
}
