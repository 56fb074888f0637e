// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Volumes for the kernels' tests.
 */

#ifndef KernelVolumes_h
#define KernelVolumes_h

#include "Filters/Kernels/TFCGradient.h"

#include <array>
#include <limits>
#include <random>
#include <vector>

namespace testing_volumes
{
using Size = std::array<tfc::Index, 3>;

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

/**
 * Odd, even, flat and thin lattices.
 */
inline std::vector<Size> GetSizes()
{
  return { { 7, 9, 5 }, { 8, 6, 10 }, { 16, 1, 1 }, { 1, 9, 1 }, { 1, 1, 7 }, { 5, 4, 1 },
    { 1, 4, 6 }, { 1, 1, 1 }, { 2, 2, 2 }, { 33, 17, 3 } };
}

template <typename Function>
std::vector<float> Make(const Size& n, Function&& f)
{
  std::vector<float> volume;
  for (tfc::Index z = 0; z < n[2]; ++z)
  {
    for (tfc::Index y = 0; y < n[1]; ++y)
    {
      for (tfc::Index x = 0; x < n[0]; ++x)
      {
        volume.push_back(static_cast<float>(f(x, y, z)));
      }
    }
  }
  return volume;
}

/**
 * Uniform noise in [-1, 3) with about `invalid` of the samples NaN.
 */
inline std::vector<float> MakeNoise(const Size& n, unsigned int seed, double invalid = 0.)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(-1.f, 3.f);
  std::uniform_real_distribution<double> chance(0., 1.);
  return Make(n,
    [&](tfc::Index, tfc::Index, tfc::Index)
    {
      const float v = value(random);
      return chance(random) < invalid ? NaN : v;
    });
}

inline float At(const std::vector<float>& volume, const Size& n, tfc::Index x, tfc::Index y,
  tfc::Index z)
{
  return volume[(z * n[1] + y) * n[0] + x];
}
}

#endif
