// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Squared gradient magnitude of a scalar lattice, one row at a time.
 *
 * |grad f|^2 = sum over the axes a of (w_a D_a f)^2, with D_a the central difference
 * (f[i+1] - f[i-1]) / 2 inside, the one-sided difference of the two nearest samples at the border,
 * and 0 along an axis with a single sample. Weights: w_a = 1 / spacing_a gives data units per world
 * unit, w_a = 1 / range gives the per-voxel gradient of an intensity scaled to [0, 1]. Both are
 * invariant under rotation of the lattice, so a direction matrix plays no part.
 *
 * A sample is invalid when it is NaN. Policy of the masked variant: where one neighbour is invalid
 * the one-sided difference with the valid one is used, where both are, the axis contributes 0, and
 * an invalid sample itself has no gradient (NaN).
 *
 * Layout: x fastest, then y, then z. Cost: one pass, 8 bytes per sample of memory traffic
 * beside the write allocation of the output; no allocation.
 */

#ifndef TFCGradient_h
#define TFCGradient_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tfc
{
using Index = std::ptrdiff_t;

/**
 * A NaN test that the compiler can vectorise.
 */
inline bool IsValid(float value)
{
  return value == value;
}

/**
 * Difference along one axis in the masked variant. `hasLow` and `hasHigh` say whether the
 * neighbours exist at all; `weight` is 1 / distance of two adjacent samples.
 */
inline float ValidDifference(float low, float center, float high, bool hasLow, bool hasHigh,
  float weight)
{
  const bool useLow = hasLow & IsValid(low);
  const bool useHigh = hasHigh & IsValid(high);
  const float a = useLow ? low : center;
  const float b = useHigh ? high : center;
  return (b - a) * ((useLow & useHigh) ? 0.5f * weight : weight);
}

/**
 * Squared gradient magnitude of the samples [x0, x1) of row (y, z) of a lattice of `n` samples.
 * `Masked` must be true when the lattice may hold NaN. `out` receives x1 - x0 values.
 */
template <bool Masked>
void GradientSquaredRow(const float* volume, const Index n[3], Index y, Index z, Index x0, Index x1,
  const float weights[3], float* out)
{
  const Index slice = n[0] * n[1];
  const float* row = volume + z * slice + y * n[0];
  const bool hasYLow = y > 0, hasYHigh = y + 1 < n[1];
  const bool hasZLow = z > 0, hasZHigh = z + 1 < n[2];
  // A missing neighbour is replaced by the sample itself: the difference becomes one-sided.
  const float* yLow = hasYLow ? row - n[0] : row;
  const float* yHigh = hasYHigh ? row + n[0] : row;
  const float* zLow = hasZLow ? row - slice : row;
  const float* zHigh = hasZHigh ? row + slice : row;

  if constexpr (Masked)
  {
    for (Index x = x0; x < x1; ++x)
    {
      const bool hasLow = x > 0, hasHigh = x + 1 < n[0];
      const float c = row[x];
      const float dx = ValidDifference(row[hasLow ? x - 1 : x], c, row[hasHigh ? x + 1 : x], hasLow,
        hasHigh, weights[0]);
      const float dy = ValidDifference(yLow[x], c, yHigh[x], hasYLow, hasYHigh, weights[1]);
      const float dz = ValidDifference(zLow[x], c, zHigh[x], hasZLow, hasZHigh, weights[2]);
      // c - c is 0, or NaN for an invalid sample.
      out[x - x0] = dx * dx + dy * dy + dz * dz + (c - c);
    }
  }
  else
  {
    const float wy = (hasYLow && hasYHigh ? 0.5f : 1.f) * weights[1];
    const float wz = (hasZLow && hasZHigh ? 0.5f : 1.f) * weights[2];
    const auto sample = [&](Index x, Index low, Index high, float wx)
    {
      const float dx = (row[high] - row[low]) * wx;
      const float dy = (yHigh[x] - yLow[x]) * wy;
      const float dz = (zHigh[x] - zLow[x]) * wz;
      return dx * dx + dy * dy + dz * dz;
    };
    const Index begin = std::max<Index>(x0, 1);
    const Index end = std::min<Index>(x1, n[0] - 1);
    if (x0 == 0 && x1 > 0)
    {
      out[0] = sample(0, 0, n[0] > 1 ? 1 : 0, weights[0]);
    }
    const float wx = 0.5f * weights[0];
    for (Index x = begin; x < end; ++x)
    {
      out[x - x0] = sample(x, x - 1, x + 1, wx);
    }
    if (x1 == n[0] && n[0] > 1 && x0 < n[0])
    {
      out[n[0] - 1 - x0] = sample(n[0] - 1, n[0] - 2, n[0] - 1, weights[0]);
    }
  }
}

/**
 * Square roots times `scale`, in place: turns a row of GradientSquaredRow() into magnitudes.
 */
inline void RootRow(float* row, Index count, float scale)
{
  for (Index i = 0; i < count; ++i)
  {
    row[i] = std::sqrt(row[i]) * scale;
  }
}
}

#endif
