// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Six noisy materials with known geometry, after the synthetic dataset of the paper.
 *
 * Zhou, Schott, Hansen 2012, section 5.1: an environment, an outer hull, a filling and three
 * spheres whose values overlap, so that no single attribute separates them. Means and deviations
 * are the paper's; the paper does not give the geometry, the numbers below are this project's.
 *
 * A sample's value is mean + noise * (deviation * N0 + 0.02 * N1) with independent standard
 * normals: N0 stands for the material's texture, N1 for the scanner. The normals are a hash of seed
 * and sample index (the finaliser of SplitMix64, then Box and Muller), so a sample does not depend
 * on the order in which, or by which thread, process or instruction set, samples are computed.
 */

#ifndef TFCPhantom_h
#define TFCPhantom_h

#include "TFCVector.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace tfc
{
struct PhantomMaterial
{
  double Center[3]; ///< of a ball in the cube [-1, 1]^3
  double Radius;
  double Mean;
  double Deviation;
};

constexpr int NumberOfPhantomMaterials = 6;

/// Where balls overlap the last one holds. The first is everywhere.
constexpr PhantomMaterial PhantomMaterials[NumberOfPhantomMaterials] = {
  { { 0, 0, 0 }, 1e9, 0.20, 0.14 },          // environment
  { { 0, 0, 0 }, 0.85, 0.60, 0.11 },         // outer hull
  { { 0, 0, 0 }, 0.70, 0.40, 0.16 },         // filling
  { { 0, 0.34, 0 }, 0.16, 0.60, 0.11 },      // A: small, above
  { { -0.20, -0.20, 0 }, 0.28, 0.80, 0.13 }, // B: larger, below left
  { { 0.33, -0.26, 0 }, 0.12, 0.80, 0.13 }   // C: small, below right
};
constexpr double PhantomScannerDeviation = 0.02;

/**
 * An integer below 2^53 as a double, in operations that every instruction set has on vectors: the
 * halves become mantissas of 2^84 and 2^52.
 */
inline double PhantomToDouble(std::uint64_t value)
{
  const std::uint64_t highBits = (value >> 32) | 0x4530000000000000ULL;
  const std::uint64_t lowBits = (value & 0xffffffffULL) | 0x4330000000000000ULL;
  double high, low;
  std::memcpy(&high, &highBits, sizeof(high));
  std::memcpy(&low, &lowBits, sizeof(low));
  return (high - (0x1.0p84 + 0x1.0p52)) + low;
}

/**
 * Number `draw` (0..3) of sample `index` under `seed`, uniform in (0, 1).
 */
inline double PhantomUniform(std::uint64_t seed, std::uint64_t index, unsigned int draw)
{
  std::uint64_t z = ((seed << 40) + 1 + 4 * index + draw) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  z ^= z >> 31;
  return (PhantomToDouble(z >> 11) + 0.5) * 0x1.0p-53;
}

/**
 * Natural logarithm of a double in (0, 1), to about 1e-16 of max(1, |log u|). The library's would
 * be called for one value after the other.
 */
inline double PhantomLog(double u)
{
  // u = m 2^e with m in [sqrt(1/2), sqrt(2)): subtract the bits of sqrt(1/2) before splitting.
  constexpr std::uint64_t offset = 0x3fe6a09e667f3bcdULL;
  std::uint64_t bits;
  std::memcpy(&bits, &u, sizeof(bits));
  // u < 1: the exponent is at most 0, and 1023 more of it is positive.
  const std::uint64_t shifted = bits - offset + (1023ULL << 52);
  const double e = PhantomToDouble(shifted >> 52) - 1023.;
  const std::uint64_t mantissa = (shifted & 0x000fffffffffffffULL) + offset;
  double m;
  std::memcpy(&m, &mantissa, sizeof(m));
  // log m = 2 atanh((m - 1) / (m + 1)), a series in s^2 <= 0.0295.
  const double s = (m - 1.) / (m + 1.), q = s * s;
  double series = 1. / 21.;
  series = series * q + 1. / 19.;
  series = series * q + 1. / 17.;
  series = series * q + 1. / 15.;
  series = series * q + 1. / 13.;
  series = series * q + 1. / 11.;
  series = series * q + 1. / 9.;
  series = series * q + 1. / 7.;
  series = series * q + 1. / 5.;
  series = series * q + 1. / 3.;
  return e * 0.69314718055994530942 + (2. * s + 2. * s * q * series);
}

/**
 * cos(2 pi v) for v in (0, 1), to about 2e-16.
 */
inline double PhantomCosine(double v)
{
  // = sin(2 pi b) with b in [-1/4, 1/4], by its Taylor series.
  const double b = std::fabs(v - 0.5) - 0.25;
  const double x = b * 6.283185307179586476925286766559, q = x * x;
  double series = -1. / 25852016738884976640000.; // 1 / 23!
  series = series * q + 1. / 51090942171709440000.;
  series = series * q - 1. / 121645100408832000.;
  series = series * q + 1. / 355687428096000.;
  series = series * q - 1. / 1307674368000.;
  series = series * q + 1. / 6227020800.;
  series = series * q - 1. / 39916800.;
  series = series * q + 1. / 362880.;
  series = series * q - 1. / 5040.;
  series = series * q + 1. / 120.;
  series = series * q - 1. / 6.;
  return x + x * q * series;
}

/**
 * Standard normal number `which` (0 or 1) of a sample, by Box and Muller.
 */
inline double PhantomNormal(std::uint64_t seed, std::uint64_t index, unsigned int which)
{
  const double u = PhantomUniform(seed, index, 2 * which);
  const double v = PhantomUniform(seed, index, 2 * which + 1);
  return std::sqrt(-2.0 * PhantomLog(u)) * PhantomCosine(v);
}

/**
 * Samples [first, first + count) of a row of the phantom. The position of sample i in
 * [-1, 1] is 2 (i + 1/2) / length - 1; y and z are that of the row; `index` is the number of
 * the row's sample 0 in the whole volume. `scale` multiplies centres and radii of the balls.
 */
inline void PhantomRow(std::int64_t first, std::int64_t count, double length, double y, double z,
  double scale, std::uint64_t seed, std::uint64_t index, double noise, float* values,
  unsigned char* labels)
{
  // Blocks that stay in the first-level cache.
  constexpr std::int64_t size = 256;
  double x[size], material[size], mean[size], deviation[size];
  for (std::int64_t begin = 0; begin < count; begin += size)
  {
    const std::int64_t n = count - begin < size ? count - begin : size;
    for (std::int64_t i = 0; i < n; ++i)
    {
      const auto number = static_cast<std::uint64_t>(first + begin + i);
      x[i] = 2. * (PhantomToDouble(number) + 0.5) / length - 1.;
      material[i] = 0.;
      mean[i] = PhantomMaterials[0].Mean;
      deviation[i] = PhantomMaterials[0].Deviation;
    }
    for (int m = 1; m < NumberOfPhantomMaterials; ++m)
    {
      const PhantomMaterial& ball = PhantomMaterials[m];
      const double dy = y - scale * ball.Center[1], dz = z - scale * ball.Center[2];
      const double rest = dy * dy + dz * dz;
      const double limit = scale * scale * ball.Radius * ball.Radius;
      if (rest >= limit)
      {
        continue;
      }
      const double number = m, center = scale * ball.Center[0];
      const double ballMean = ball.Mean, ballDeviation = ball.Deviation;
      TFC_INDEPENDENT
      for (std::int64_t i = 0; i < n; ++i)
      {
        const double dx = x[i] - center;
        const bool inside = dx * dx + rest < limit;
        material[i] = inside ? number : material[i];
        mean[i] = inside ? ballMean : mean[i];
        deviation[i] = inside ? ballDeviation : deviation[i];
      }
    }
    const std::uint64_t start = index + static_cast<std::uint64_t>(first + begin);
    TFC_INDEPENDENT
    for (std::int64_t i = 0; i < n; ++i)
    {
      const std::uint64_t sample = start + static_cast<std::uint64_t>(i);
      const double texture = PhantomNormal(seed, sample, 0),
                   scanner = PhantomNormal(seed, sample, 1);
      mean[i] += noise * (deviation[i] * texture + PhantomScannerDeviation * scanner);
    }
    for (std::int64_t i = 0; i < n; ++i)
    {
      values[begin + i] = static_cast<float>(mean[i]);
      labels[begin + i] = static_cast<unsigned char>(material[i]);
    }
  }
}
}

#endif
