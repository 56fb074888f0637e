// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Against ITK, where it is installed: away from the borders, which the two treat in other ways.
#include "FilterVolumes.h"

#include "Filters/vtkTFCGradientMagnitude.h"

#include "vtkFloatArray.h"

#include "itkGradientMagnitudeImageFilter.h"
#include "itkImage.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_volumes;

TEST(ItkPeers, GradientMagnitudeOnAnAnisotropicLattice)
{
  constexpr int size[3] = { 23, 19, 17 };
  const double spacing[3] = { 0.5, 1.25, 2 };
  const auto field = [](int x, int y, int z)
  { return 40 * std::sin(0.7 * x + 0.3 * z) + 25 * std::cos(0.9 * y - 0.2 * x) + (x * y * z) % 7; };
  const auto image = MakeVolume<vtkFloatArray>(size[0], size[1], size[2], field);
  image->SetSpacing(spacing);
  vtkNew<vtkTFCGradientMagnitude> filter;
  auto* ours = Compute(filter.Get(), image, "a_gradient");
  ASSERT_NE(ours, nullptr);

  using Image = itk::Image<float, 3>;
  auto input = Image::New();
  Image::RegionType region;
  region.SetSize({ { size[0], size[1], size[2] } });
  input->SetRegions(region);
  input->SetSpacing(spacing);
  input->Allocate();
  auto peer = itk::GradientMagnitudeImageFilter<Image, Image>::New();
  const auto each = [&](int border, auto&& use)
  {
    for (int z = border; z < size[2] - border; ++z)
    {
      for (int y = border; y < size[1] - border; ++y)
      {
        for (int x = border; x < size[0] - border; ++x)
        {
          use(x, y, z);
        }
      }
    }
  };
  each(0,
    [&](int x, int y, int z) {
      input->SetPixel({ { x, y, z } }, static_cast<float>(field(x, y, z)));
    });
  peer->SetInput(input);
  peer->UseImageSpacingOn();
  peer->Update();
  each(1,
    [&](int x, int y, int z)
    {
      const double expected = peer->GetOutput()->GetPixel({ { x, y, z } });
      const vtkIdType id = x + size[0] * (y + static_cast<vtkIdType>(size[1]) * z);
      EXPECT_NEAR(ours->GetTuple1(id), expected, 1e-5 * (1 + expected))
        << x << " " << y << " " << z;
    });
}
