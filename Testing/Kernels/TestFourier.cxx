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
  std::vector<Real> re(size), im(size), re2(size), im2(size);
  std::mt19937 random(5);
  std::uniform_real_distribution<Real> value(-1, 1);
  std::generate(re.begin(), re.end(), [&]() { return value(random); });
  std::generate(im.begin(), im.end(), [&]() { return value(random); });
  const std::vector<Real> a = re, b = im;
  const bool second = transform.Transform(re.data(), im.data(), re2.data(), im2.data());
  const auto& x = second ? re2 : re;
  const auto& y = second ? im2 : im;
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
      ASSERT_NEAR(x[k * Lanes + lane], expected.real(), tolerance * std::sqrt(1. * n)) << n;
      ASSERT_NEAR(y[k * Lanes + lane], expected.imag(), tolerance * std::sqrt(1. * n)) << n;
    }
  }
}
}

TEST(Fourier, MatchesDefinition)
{
  for (const std::ptrdiff_t n :
    { 1, 2, 3, 4, 5, 6, 8, 9, 10, 12, 15, 16, 25, 60, 81, 90, 128, 270 })
  {
    CompareWithDefinition<float, 16>(n, 1e-6);
    CompareWithDefinition<double, 8>(n, 2e-15);
  }
}

TEST(Fourier, ExchangedPartsInvert)
{
  constexpr int lanes = 16;
  const tfc::FourierTransform<double, lanes> transform(60);
  const size_t size = static_cast<size_t>(transform.GetSize());
  std::vector<double> re(size), im(size), re2(size), im2(size);
  for (size_t i = 0; i < size; ++i)
  {
    re[i] = std::sin(0.1 * static_cast<double>(i * i));
    im[i] = std::cos(0.3 * static_cast<double>(i * i));
  }
  const auto a = re, b = im;
  if (transform.Transform(re.data(), im.data(), re2.data(), im2.data()))
  {
    re.swap(re2);
    im.swap(im2);
  }
  if (transform.Transform(im.data(), re.data(), im2.data(), re2.data()))
  {
    re.swap(re2);
    im.swap(im2);
  }
  for (size_t i = 0; i < size; ++i)
  {
    ASSERT_NEAR(re[i] / 60., a[i], 1e-14);
    ASSERT_NEAR(im[i] / 60., b[i], 1e-14);
  }
}

TEST(Fourier, LengthsAreProductsOfTwosThreesAndFives)
{
  EXPECT_EQ(tfc::GetFourierLength(1), 1);
  EXPECT_EQ(tfc::GetFourierLength(7), 8);
  EXPECT_EQ(tfc::GetFourierLength(296), 300);
  EXPECT_EQ(tfc::GetFourierLength(2049), 2160);
}
