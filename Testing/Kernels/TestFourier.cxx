// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCFourier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <random>

namespace
{
template <typename Real, int Lanes>
void CompareWithDefinition(std::ptrdiff_t n, double tolerance)
{
  const tfc::FourierTransform<Real, Lanes> transform(n);
  ASSERT_EQ(transform.GetLength(), n);
  const size_t size = static_cast<size_t>(transform.GetSize());
  std::vector<Real> re(size), im(size);
  std::mt19937 random(5);
  std::uniform_real_distribution<Real> value(-1, 1);
  std::generate(re.begin(), re.end(), [&]() { return value(random); });
  std::generate(im.begin(), im.end(), [&]() { return value(random); });
  const std::vector<Real> a = re, b = im;
  transform.Transform(re.data(), im.data());
  for (int lane = 0; lane < Lanes; lane += Lanes - 1)
  {
    for (std::ptrdiff_t k = 0; k < n; ++k)
    {
      std::complex<double> expected = 0.;
      for (std::ptrdiff_t j = 0; j < n; ++j)
      {
        const double turns = static_cast<double>(j * k % n) / static_cast<double>(n);
        expected += std::complex<double>(a[j * Lanes + lane], b[j * Lanes + lane]) *
          std::polar(1., -2. * 3.14159265358979323846 * turns);
      }
      const std::ptrdiff_t at = transform.GetPositions()[k] * Lanes + lane;
      ASSERT_NEAR(re[at], expected.real(), tolerance * std::sqrt(1. * n)) << n;
      ASSERT_NEAR(im[at], expected.imag(), tolerance * std::sqrt(1. * n)) << n;
    }
  }
  transform.Invert(re.data(), im.data());
  for (size_t i = 0; i < size; ++i)
  {
    ASSERT_NEAR(re[i] / static_cast<Real>(n), a[i], tolerance) << n;
    ASSERT_NEAR(im[i] / static_cast<Real>(n), b[i], tolerance) << n;
  }
}
}

TEST(Fourier, MatchesDefinitionAndInverts)
{
  for (const std::ptrdiff_t n :
    { 1, 2, 3, 4, 5, 6, 8, 9, 10, 12, 15, 16, 25, 60, 81, 90, 128, 270 })
  {
    CompareWithDefinition<float, 16>(n, 1e-6);
    CompareWithDefinition<double, 8>(n, 2e-15);
  }
}

TEST(Fourier, EveryFrequencyHasItsPlace)
{
  const tfc::FourierTransform<float, 16> transform(360);
  std::vector<int> uses(360, 0);
  for (int k = 0; k < 360; ++k)
  {
    ++uses.at(transform.GetPositions()[k]);
  }
  EXPECT_EQ(uses, std::vector<int>(360, 1));
}

TEST(Fourier, LengthsAreProductsOfTwosThreesAndFives)
{
  EXPECT_EQ(tfc::GetFourierLength(1), 1);
  EXPECT_EQ(tfc::GetFourierLength(7), 8);
  EXPECT_EQ(tfc::GetFourierLength(296), 300);
  EXPECT_EQ(tfc::GetFourierLength(2049), 2160);
}
