// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Pearson correlation of several properties, pairwise complete, from blocks of samples.
 *
 * R_ij = Cov(i, j) / sqrt(Cov(i, i) Cov(j, j)) (Eq. 4 of the paper) over the samples where i and j
 * are both valid (not NaN). The caller shifts and scales every property by constants that are the
 * same for all blocks (best: global mean and global range): the one-pass formulas then lose nothing
 * to cancellation and cannot overflow.
 *
 * A block yields sums in double precision, kept in eight lanes; adding up blocks in a fixed order
 * makes the result independent of the number of threads.
 *
 * Cost: k(k+1)/2 products per sample, six times that in blocks with invalid samples; no allocation.
 */

#ifndef TFCCorrelation_h
#define TFCCorrelation_h

#include "TFCGradient.h"
#include "TFCVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tfc
{
/**
 * Sums over the samples where both properties of a pair are valid.
 */
struct PairSums
{
  double Count = 0., I = 0., J = 0., II = 0., JJ = 0., IJ = 0.;

  PairSums& operator+=(const PairSums& other)
  {
    this->Count += other.Count;
    this->I += other.I;
    this->J += other.J;
    this->II += other.II;
    this->JJ += other.JJ;
    this->IJ += other.IJ;
    return *this;
  }
};

/**
 * Number of pairs i < j of k properties; they are ordered (0,1) (0,2) ... (1,2) ...
 */
inline size_t NumberOfPairs(size_t k)
{
  return k * (k - (k > 0 ? 1 : 0)) / 2;
}

/**
 * Inner product in eight lanes, which the compiler may vectorise without reordering sums.
 */
inline double Dot(const double* a, const double* b, Index n)
{
  double lanes[8] = {};
  Index i = 0;
  for (; i + 8 <= n; i += 8)
  {
    for (int l = 0; l < 8; ++l)
    {
      lanes[l] += a[i + l] * b[i + l];
    }
  }
  for (; i < n; ++i)
  {
    lanes[0] += a[i] * b[i];
  }
  return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) +
    ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
}

/**
 * Scratch memory of AccumulatePairs() for `k` properties and blocks of at most `n` samples.
 */
struct PairWorkspace
{
  PairWorkspace(size_t k, Index n)
    : Stride(n)
    , Values(k * static_cast<size_t>(n))
    , Squares(static_cast<size_t>(n))
    , Valid(k * static_cast<size_t>(n))
    , Ones(static_cast<size_t>(n), 1.)
    , Sums(k)
    , SumsOfSquares(k)
  {
  }

  /**
   * Where the caller puts the samples of property `i`: shifted, scaled, NaN where invalid.
   */
  double* GetValues(size_t i) { return this->Values.data() + i * this->Stride; }

  Index Stride;
  std::vector<double> Values, Squares, Valid, Ones, Sums, SumsOfSquares;
};

/**
 * Add the first `n` samples in `work` to the sums of all pairs of `k` properties. Overwrites
 * invalid samples in `work` with 0.
 */
inline void AccumulatePairs(size_t k, Index n, PairWorkspace& work, PairSums* pairs)
{
  bool complete = true;
  for (size_t i = 0; i < k; ++i)
  {
    double* values = work.GetValues(i);
    double* valid = work.Valid.data() + i * work.Stride;
    TFC_INDEPENDENT
    for (Index s = 0; s < n; ++s)
    {
      const double value = values[s];
      valid[s] = value == value ? 1. : 0.;
      values[s] = value == value ? value : 0.;
    }
    complete = complete && Dot(valid, work.Ones.data(), n) == static_cast<double>(n);
    work.Sums[i] = Dot(values, work.Ones.data(), n);
    work.SumsOfSquares[i] = Dot(values, values, n);
  }

  size_t pair = 0;
  for (size_t i = 0; i < k; ++i)
  {
    const double* x = work.GetValues(i);
    const double* validX = work.Valid.data() + i * work.Stride;
    for (size_t j = i + 1; j < k; ++j, ++pair)
    {
      const double* y = work.GetValues(j);
      PairSums sums;
      sums.IJ = Dot(x, y, n);
      if (complete)
      {
        sums.Count = static_cast<double>(n);
        sums.I = work.Sums[i];
        sums.II = work.SumsOfSquares[i];
        sums.J = work.Sums[j];
        sums.JJ = work.SumsOfSquares[j];
      }
      else
      {
        const double* validY = work.Valid.data() + j * work.Stride;
        const auto masked = [&](const double* v, const double* mask, double& sum, double& squares)
        {
          for (Index s = 0; s < n; ++s)
          {
            work.Squares[s] = v[s] * mask[s];
          }
          sum = Dot(work.Squares.data(), work.Ones.data(), n);
          squares = Dot(work.Squares.data(), work.Squares.data(), n);
        };
        sums.Count = Dot(validX, validY, n);
        masked(x, validY, sums.I, sums.II);
        masked(y, validX, sums.J, sums.JJ);
      }
      pairs[pair] += sums;
    }
  }
}

/**
 * Correlation of one pair, in [-1, 1]. NaN when there are fewer than two common samples or one of
 * the properties is constant over them (its variance is below rounding error).
 */
inline double Correlation(const PairSums& sums)
{
  if (sums.Count < 2.)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double varianceI = sums.II - sums.I * sums.I / sums.Count;
  const double varianceJ = sums.JJ - sums.J * sums.J / sums.Count;
  constexpr double rounding = 1e-13;
  if (!(varianceI > rounding * sums.II) || !(varianceJ > rounding * sums.JJ))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double covariance = sums.IJ - sums.I * sums.J / sums.Count;
  const double r = covariance / (std::sqrt(varianceI) * std::sqrt(varianceJ));
  return std::min(1., std::max(-1., r));
}

/**
 * The k x k matrix (row-major) from the sums of all pairs: symmetric, 1 on the diagonal, NaN in the
 * rows and columns of properties that `constant` marks, their diagonal included.
 */
inline std::vector<double> CorrelationMatrix(const std::vector<PairSums>& pairs,
  const std::vector<bool>& constant)
{
  const size_t k = constant.size();
  std::vector<double> matrix(k * k, std::numeric_limits<double>::quiet_NaN());
  size_t pair = 0;
  for (size_t i = 0; i < k; ++i)
  {
    if (!constant[i])
    {
      matrix[i * k + i] = 1.;
    }
    for (size_t j = i + 1; j < k; ++j, ++pair)
    {
      if (!constant[i] && !constant[j])
      {
        matrix[i * k + j] = matrix[j * k + i] = Correlation(pairs[pair]);
      }
    }
  }
  return matrix;
}
}

#endif
