// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The tests of TFCNormality.h and TFCWelch.h for 16 voxels side by side.
 *
 * The same decisions in float and without branches, so that the compiler turns each loop over the
 * lanes into a few wide instructions. What depends on the number of samples only comes from a
 * table; Student's quantile from a table over 1 / nu, interpolated linearly (relative error below
 * 1e-4, below 1e-6 for nu > 6 and usual alpha). K^2 < c is decided without a cubic root: Z2^2 < c -
 * Z1^2 is a pair of bounds on what stands under the root.
 *
 * Sums are those of values shifted by some value near the mean of the lane; else float does not
 * hold the fourth power. Lanes that are done may hold NaN: their results mean nothing.
 */

#ifndef TFCSphereTests_h
#define TFCSphereTests_h

#include "TFCNormality.h"
#include "TFCPowerSums.h"
#include "TFCWelch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace tfc
{
/**
 * Natural logarithm of a normal number >= 1 (Cephes; relative error 1e-7).
 */
inline float LaneLog(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  // Mantissa in [sqrt(1/2), sqrt(2)): the offset carries into the exponent from sqrt(2) on.
  bits += 0x3f800000u - 0x3f3504f3u;
  const float exponent = static_cast<float>(static_cast<std::int32_t>(bits >> 23) - 127);
  bits = (bits & 0x007fffffu) + 0x3f3504f3u;
  float x;
  std::memcpy(&x, &bits, sizeof(x));
  x -= 1.f;
  float y = 7.0376836292e-2f;
  y = y * x - 1.1514610310e-1f;
  y = y * x + 1.1676998740e-1f;
  y = y * x - 1.2420140846e-1f;
  y = y * x + 1.4249322787e-1f;
  y = y * x - 1.6668057665e-1f;
  y = y * x + 2.0000714765e-1f;
  y = y * x - 2.4999993993e-1f;
  y = y * x + 3.3333331174e-1f;
  const float square = x * x;
  y = y * x * square - 2.12194440e-4f * exponent - 0.5f * square;
  return x + y + 0.693359375f * exponent;
}

/**
 * The larger number; `least` for NaN.
 */
inline float AtLeast(float value, float least)
{
  return value > least ? value : least;
}

class SphereTests
{
public:
  /**
   * For a level alpha in (0, 1) and spheres of up to `largest` points.
   */
  SphereTests(double alpha, std::ptrdiff_t largest)
    : Critical(static_cast<float>(NormalityCritical(alpha)))
    , Constants(static_cast<size_t>(largest) + 1)
    , Quantiles(Intervals + 1)
  {
    for (std::ptrdiff_t n = 0; n <= largest; ++n)
    {
      auto& c = this->Constants[static_cast<size_t>(n)];
      c[InverseCount] = n > 0 ? static_cast<float>(1. / static_cast<double>(n)) : 0.f;
      if (n < SmallestNormalitySample)
      {
        // Z1 = 0, and bounds so wide that everything passes.
        c[KurtosisWidth] = 1e9f;
        continue;
      }
      const NormalityConstants exact(static_cast<double>(n));
      c[SkewnessScale] = static_cast<float>(exact.SkewnessScale);
      c[SkewnessDelta] = static_cast<float>(exact.SkewnessDelta);
      c[KurtosisMean] = static_cast<float>(exact.KurtosisMean);
      c[KurtosisScale] = static_cast<float>(exact.KurtosisScale);
      c[KurtosisNumerator] = static_cast<float>(exact.KurtosisNumerator);
      c[KurtosisCenter] = static_cast<float>(exact.KurtosisCenter);
      c[KurtosisWidth] = static_cast<float>(exact.KurtosisWidth);
    }
    // Below, quantiles leave the range of numbers and nothing is told apart any more.
    const double level = std::max(alpha, 1e-100);
    double t = 1.;
    for (int i = 0; i <= Intervals; ++i)
    {
      t = StudentCritical(level, i ? static_cast<double>(Intervals) / i : 1e300, t);
      this->Quantiles[static_cast<size_t>(i)] = static_cast<float>(std::min(t * t, 1e30));
    }
  }

  /**
   * Constants for the sizes of the lanes' samples, one row per constant.
   */
  struct LaneConstants
  {
    alignas(64) float Of[8][Lanes];
  };
  void Look(const float* counts, LaneConstants& lanes) const
  {
    for (int i = 0; i < Lanes; ++i)
    {
      const auto& from = this->Constants[static_cast<size_t>(counts[i])];
      for (int k = 0; k < 8; ++k)
      {
        lanes.Of[k][i] = from[static_cast<size_t>(k)];
      }
    }
  }

  /**
   * passed[i] = 0 where the samples of lane i are not normal.
   */
  void TestNormality(const PowerSums& sums, const LaneConstants& lanes,
    std::int32_t* __restrict passed) const
  {
    const float critical = this->Critical;
    const float* __restrict s1 = sums.Sum[0];
    const float* __restrict s2 = sums.Sum[1];
    const float* __restrict s3 = sums.Sum[2];
    const float* __restrict s4 = sums.Sum[3];
    for (int i = 0; i < Lanes; ++i)
    {
      const float inverse = lanes.Of[InverseCount][i];
      const float mean = s1[i] * inverse, square = mean * mean;
      const float e2 = s2[i] * inverse, e3 = s3[i] * inverse, e4 = s4[i] * inverse;
      const float m2 = e2 - square;
      const float m3 = e3 - mean * (3.f * e2 - 2.f * square);
      const float m4 = e4 - mean * (4.f * e3 - mean * (6.f * e2 - 3.f * square));
      const bool varies = m2 > 0.f;
      const float divisor = varies ? m2 : 1.f;
      const float kurtosis = m4 / divisor / divisor;
      const float skewness = std::fabs(m3) / divisor / std::sqrt(divisor);

      const float x = skewness * lanes.Of[SkewnessScale][i];
      const float z1 = lanes.Of[SkewnessDelta][i] * LaneLog(x + std::sqrt(x * x + 1.f));
      const float rest = critical - z1 * z1;
      const float reach = std::sqrt(rest > 0.f ? rest : 0.f) * lanes.Of[KurtosisWidth][i];
      const float low = lanes.Of[KurtosisCenter][i] - reach;
      const float high = lanes.Of[KurtosisCenter][i] + reach;
      const float denominator =
        1.f + lanes.Of[KurtosisScale][i] * (kurtosis - lanes.Of[KurtosisMean][i]);
      const float cube = lanes.Of[KurtosisNumerator][i] / denominator;
      const bool normal = (rest > 0.f) & (cube > low * low * low) & (cube < high * high * high);
      passed[i] &= static_cast<std::int32_t>(normal | !varies);
    }
  }

  /**
   * passed[i] = 0 where the samples `inner` and `shell` of lane i are not similar.
   */
  void TestSimilarity(const PowerSums& inner, const PowerSums& shell,
    std::int32_t* __restrict passed) const
  {
    // Several loops, each with few selections: in a long one the compiler joins them to branches.
    alignas(64) float n1[Lanes], n2[Lanes], less1[Lanes], less2[Lanes];
    alignas(64) float difference[Lanes], variance1[Lanes], variance2[Lanes], variance[Lanes];
    alignas(64) float inverseFreedom[Lanes], place[Lanes];
    alignas(64) std::int32_t interval[Lanes];
    for (int i = 0; i < Lanes; ++i)
    {
      n1[i] = AtLeast(inner.Count[i], 1.f);
      n2[i] = AtLeast(shell.Count[i], 1.f);
      less1[i] = AtLeast(inner.Count[i] - 1.f, 1.f);
      less2[i] = AtLeast(shell.Count[i] - 1.f, 1.f);
    }
    for (int i = 0; i < Lanes; ++i)
    {
      const float mean1 = inner.Sum[0][i] / n1[i], mean2 = shell.Sum[0][i] / n2[i];
      const float squares1 = inner.Sum[1][i] - inner.Sum[0][i] * mean1;
      const float squares2 = shell.Sum[1][i] - shell.Sum[0][i] * mean2;
      variance1[i] = AtLeast(squares1, 0.f) / less1[i];
      variance2[i] = AtLeast(squares2, 0.f) / less2[i];
      difference[i] = mean1 - mean2;
    }
    for (int i = 0; i < Lanes; ++i)
    {
      // A sample of one borrows the other's variance.
      const float u = (n1[i] < 2.f ? variance2[i] : variance1[i]) / n1[i];
      const float w = (n2[i] < 2.f ? variance1[i] : variance2[i]) / n2[i];
      variance[i] = u + w;
      const float part = u / AtLeast(u + w, 1e-37f), other = 1.f - part;
      inverseFreedom[i] = part * part / less1[i] + other * other / less2[i];
    }
    for (int i = 0; i < Lanes; ++i)
    {
      const float student = 1.f / AtLeast(n1[i] + n2[i] - 2.f, 1.f);
      const float fewest = n1[i] < n2[i] ? n1[i] : n2[i];
      inverseFreedom[i] = fewest < 2.f ? student : inverseFreedom[i];
    }
    for (int i = 0; i < Lanes; ++i)
    {
      const float position = AtLeast(inverseFreedom[i] * static_cast<float>(Intervals), 0.f);
      const float top = static_cast<float>(Intervals) - 0.001f;
      const float inside = position < top ? position : top;
      interval[i] = static_cast<std::int32_t>(inside);
      place[i] = inside - static_cast<float>(interval[i]);
      // An empty shell differs from nothing.
      difference[i] = shell.Count[i] > 0.f ? difference[i] : 0.f;
    }
    const float* quantiles = this->Quantiles.data();
    for (int i = 0; i < Lanes; ++i)
    {
      const float a = quantiles[interval[i]], b = quantiles[interval[i] + 1];
      const float quantile = a + place[i] * (b - a);
      passed[i] &=
        static_cast<std::int32_t>(difference[i] * difference[i] <= quantile * variance[i]);
    }
  }

private:
  enum Constant
  {
    InverseCount,
    SkewnessScale,
    SkewnessDelta,
    KurtosisMean,
    KurtosisScale,
    KurtosisNumerator,
    KurtosisCenter,
    KurtosisWidth
  };
  static constexpr int Intervals = 4096;

  float Critical;
  std::vector<std::array<float, 8>> Constants; // by number of samples
  std::vector<float> Quantiles;                // squares, over 1 / nu in [0, 1]
};
}

#endif
