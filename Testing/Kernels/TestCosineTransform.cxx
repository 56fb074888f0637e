// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCCosineTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace
{
// The whole sequence, by the definition of the discrete Fourier transform.
double GetExpected(const std::vector<double>& half, tfc::Index length, tfc::Index k)
{
  std::complex<double> sum = 0.;
  for (tfc::Index j = 1 - static_cast<tfc::Index>(half.size());
       j < static_cast<tfc::Index>(half.size()); ++j)
  {
    const double turns = static_cast<double>(j * k) / static_cast<double>(length);
    sum += half[std::abs(j)] * std::polar(1., -2. * 3.14159265358979323846 * turns);
  }
  EXPECT_NEAR(sum.imag(), 0., 1e-12);
  return sum.real();
}

std::vector<double> MakeRandom(size_t size)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> result(size);
  for (double& x : result)
  {
    x = value(random);
  }
  return result;
}
}

// Odd and even lengths, multiples of four or not; one offset, and as many as there can be.
TEST(CosineTransform, MatchesDefinition)
{
  for (const tfc::Index length : { 1, 2, 3, 4, 6, 8, 9, 10, 27, 30, 36, 100 })
  {
    for (const tfc::Index count : { tfc::Index(1), length / 4 + 1, (length + 1) / 2 })
    {
      const std::vector<double> half = MakeRandom(static_cast<size_t>(count));
      const double scale = 0.5;
      const tfc::CosineTransform<double> transform(length, count, scale);
      const tfc::Index pitch = tfc::CosineTransform<double>::GetPitch(length);
      ASSERT_EQ(pitch % 8, 0);
      std::vector<double> all(static_cast<size_t>(pitch), NAN);
      transform.TransformSequence(half.data(), all.data());
      for (tfc::Index k = 0; k < pitch; ++k)
      {
        const double expected = k <= length / 2 ? scale * GetExpected(half, length, k) : 0.;
        ASSERT_NEAR(all[k], expected, 1e-12) << length << " " << count << " " << k;
      }
    }
  }
}

// Three sequences in rows that are further apart than they are wide.
TEST(CosineTransform, TransformsRows)
{
  constexpr tfc::Index width = 3, distance = 5, rowPitch = 4;
  for (const tfc::Index length : { 5, 8, 10, 12, 15 })
  {
    const tfc::Index count = (length + 1) / 2, frequencies = length / 2 + 1;
    const std::vector<double> rows = MakeRandom(static_cast<size_t>(count * distance));
    std::vector<double> result(static_cast<size_t>(frequencies * rowPitch), 7.);
    const tfc::CosineTransform<double> transform(length, count);
    for (tfc::Index pair = 0; pair < transform.GetNumberOfPairs(); ++pair)
    {
      transform.TransformRows(pair, rows.data(), distance, width, result.data(), rowPitch);
    }
    for (tfc::Index i = 0; i < rowPitch; ++i)
    {
      std::vector<double> half;
      for (tfc::Index j = 0; j < count; ++j)
      {
        half.push_back(rows[j * distance + i]);
      }
      for (tfc::Index k = 0; k < frequencies; ++k)
      {
        const double expected = i < width ? GetExpected(half, length, k) : 7.;
        ASSERT_NEAR(result[k * rowPitch + i], expected, 1e-12) << length << " " << k << " " << i;
      }
    }
  }
}
