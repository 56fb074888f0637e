// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Occlusion metric of the paper (Eqs. 6 to 9): boundary factor times ambient mean.
 *
 * m_x = g_x * mean of I over the in-volume part of the box of radius R around x, with
 * g_x = eta^2 / (|grad I|^2 + eta^2) (Eq. 7; Perona and Malik's second conductance). The gradient
 * is the per-voxel one of the intensity scaled to [0, 1] by the global range of its finite values,
 * which is what the paper's eta in [0.001, 0.01] presumes; the mean stays in data units.
 *
 * g_x is evaluated as 1 / (1 + |grad I / eta|^2): nothing underflows for a small eta. A constant
 * volume has range 0 and g_x = 1. Invalid samples (NaN) take no part in the mean, are treated
 * as GradientSquaredRow() says in the gradient, and have no occlusion (NaN).
 *
 * Cost: that of BoxSum, plus one gradient pass fused into its last pass.
 */

#ifndef TFCOcclusion_h
#define TFCOcclusion_h

#include "TFCBoxMean.h"

#include <vector>

namespace tfc
{
/**
 * Weight of the differences of GradientSquaredRow() so that it returns |grad I / eta|^2.
 */
inline float ConductanceWeight(double range, double eta)
{
  if (!(range > 0.))
  {
    return 0.f;
  }
  // The cap keeps 0 * weight from becoming NaN when the range is denormal.
  return static_cast<float>(std::min(1. / (range * eta), 1e30));
}

/**
 * The boundary factor on its own: row (y, z), samples [x0, x1), of `means` becomes the metric.
 * `scratch` holds x1 - x0 values.
 */
template <bool Masked>
void ApplyBoundaryRow(const float* volume, const Index size[3], Index y, Index z, Index x0,
  Index x1, float weight, float* scratch, float* means)
{
  const float weights[3] = { weight, weight, weight };
  GradientSquaredRow<Masked>(volume, size, y, z, x0, x1, weights, scratch);
  for (Index x = 0; x < x1 - x0; ++x)
  {
    means[x] /= 1.f + scratch[x];
  }
}

/**
 * One row of the metric from one row of box sums (see BoxSum::SumColumns()). `counts` may be null
 * for a lattice without invalid samples. `inverseLengths` holds 1 / CountAlong(0, x) of the row.
 */
template <bool Masked>
void OcclusionRow(const float* volume, const Index size[3], Index y, Index z, Index x0, Index x1,
  float weight, const double* sums, const double* counts, const double* inverseLengths,
  double inverseArea, float* out)
{
  const float weights[3] = { weight, weight, weight };
  GradientSquaredRow<Masked>(volume, size, y, z, x0, x1, weights, out);
  const Index count = x1 - x0;
  for (Index x = 0; x < count; ++x)
  {
    double mean;
    if constexpr (Masked)
    {
      // 0 / 0 only where the sample itself is invalid, and there the metric is NaN anyway.
      mean = sums[x] / counts[x];
    }
    else
    {
      mean = sums[x] * (inverseLengths[x] * inverseArea);
    }
    out[x] = static_cast<float>(mean) / (1.f + out[x]);
  }
}

/**
 * The metric for the rows [y0, y1) of the output block (see BoxSum::SumColumns()), into `out`,
 * which holds the whole block.
 */
template <bool Masked>
void OcclusionTile(const BoxSum& box, const float* volume, const Index size[3],
  const Index begin[3], const Index end[3], float weight, const float* sums, const float* validity,
  Index y0, Index y1, BoxSum::Workspace& work, float* out)
{
  const Index width = end[0] - begin[0], height = end[1] - begin[1];
  std::vector<double> inverseLengths(static_cast<size_t>(width));
  for (Index x = 0; x < width; ++x)
  {
    inverseLengths[x] = 1. / static_cast<double>(box.CountAlong(0, x + begin[0]));
  }
  box.SumColumns(sums, validity, y0, y1, work,
    [&](Index y, Index z, const double* rowSums, const double* rowCounts)
    {
      const double area = static_cast<double>(box.CountAlong(1, y)) * box.CountAlong(2, z);
      OcclusionRow<Masked>(volume, size, y, z, begin[0], end[0], weight, rowSums, rowCounts,
        inverseLengths.data(), 1. / area, out + ((z - begin[2]) * height + y - begin[1]) * width);
    });
}
}

#endif
