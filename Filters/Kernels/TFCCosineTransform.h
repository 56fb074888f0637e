// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Discrete Fourier transform of short even sequences, by products with cosines.
 *
 * X[k] = scale * (x[0] + 2 sum_{0 < j < count} x[j] cos(2 pi j k / length)), k = 0 ... length / 2:
 * all of the transform of a sequence of `length` numbers that is even, x[-j] = x[j], and 0 from
 * j = count on. For few offsets that is less work than a fast transform.
 *
 * The frequencies k and length / 2 - k have the same cosines but for the sign of those of odd j, so
 * that an even length takes half of the products: "pairs".
 *
 * Cost: count * (length / 4 + 1) products per sequence for even lengths, twice that for odd ones.
 */

#ifndef TFCCosineTransform_h
#define TFCCosineTransform_h

#include "TFCAlignedVector.h"
#include "TFCGradient.h" // For Index
#include "TFCVector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tfc
{
template <typename Real>
class CosineTransform
{
public:
  CosineTransform(Index length, Index count, double scale = 1.)
    : Length(length)
    , Count(count)
    , Pitch(GetPitch(length))
    , Factors(static_cast<size_t>(count * GetPitch(length)))
  {
    // One period of the cosine has all values.
    std::vector<Real> cosines(static_cast<size_t>(length));
    for (Index i = 0; i < length; ++i)
    {
      const double angle =
        2. * 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(length);
      cosines[i] = static_cast<Real>(2. * scale * std::cos(angle));
    }
    for (Index j = 0; j < count; ++j)
    {
      Real* row = this->Factors.data() + j * this->Pitch;
      for (Index k = 0, i = 0; k < this->Pitch; ++k)
      {
        row[k] = k > length / 2 ? Real(0) : j ? cosines[i] : static_cast<Real>(scale);
        i += i + j < length ? j : j - length;
      }
    }
  }

  /**
   * Frequencies of TransformSequence(): length / 2 + 1, and zeros up to the end of a cache line.
   */
  static Index GetPitch(Index length)
  {
    constexpr Index line = 64 / sizeof(Real);
    return (length / 2 + line) / line * line;
  }

  /**
   * Number of pairs k, length / 2 - k; of frequencies where the length is odd.
   */
  Index GetNumberOfPairs() const
  {
    return this->Length % 2 ? this->Length / 2 + 1 : this->Length / 4 + 1;
  }

  /**
   * All frequencies of one sequence: GetPitch() values.
   */
  void TransformSequence(const Real* from, Real* to) const
  {
    std::fill(to, to + this->Pitch, Real(0));
    AddRows(this->Count, from, 1, this->Factors.data(), this->Pitch, this->Pitch, to);
  }

  /**
   * Transforms `width` sequences side by side: x[j] at from + j * distance, X[k] at to + k * pitch;
   * both frequencies of one pair.
   */
  void TransformRows(Index pair, const Real* from, Index distance, Index width, Real* to,
    Index pitch) const
  {
    const Real* factors = this->Factors.data() + pair;
    Real* low = to + pair * pitch;
    std::fill(low, low + width, Real(0));
    if (this->Length % 2)
    {
      AddRows(this->Count, factors, this->Pitch, from, distance, width, low);
      return;
    }
    const Index stride = 2 * this->Pitch;
    AddRows((this->Count + 1) / 2, factors, stride, from, 2 * distance, width, low);
    const Index mirrored = this->Length / 2 - pair;
    if (mirrored == pair)
    {
      return; // a quarter of the length: the cosines of odd j are 0
    }
    Real* high = to + mirrored * pitch;
    std::fill(high, high + width, Real(0));
    AddRows(this->Count / 2, factors + this->Pitch, stride, from + distance, 2 * distance, width,
      high);
    TFC_INDEPENDENT
    for (Index i = 0; i < width; ++i)
    {
      const Real even = low[i], odd = high[i];
      low[i] = even + odd;
      high[i] = even - odd;
    }
  }

private:
  /// to += sum_j factors[j * stride] * from[j * distance ...]; four rows at a time, so that the sum
  /// is read and written less often.
  static void AddRows(Index rows, const Real* factors, Index stride, const Real* from,
    Index distance, Index width, Real* __restrict to)
  {
    Index j = 0;
    for (; j + 4 <= rows; j += 4)
    {
      const Real f0 = factors[j * stride], f1 = factors[(j + 1) * stride];
      const Real f2 = factors[(j + 2) * stride], f3 = factors[(j + 3) * stride];
      const Real* __restrict a0 = from + j * distance;
      const Real* __restrict a1 = a0 + distance;
      const Real* __restrict a2 = a1 + distance;
      const Real* __restrict a3 = a2 + distance;
      TFC_INDEPENDENT
      for (Index i = 0; i < width; ++i)
      {
        to[i] += (f0 * a0[i] + f1 * a1[i]) + (f2 * a2[i] + f3 * a3[i]);
      }
    }
    for (; j < rows; ++j)
    {
      const Real factor = factors[j * stride];
      const Real* __restrict a = from + j * distance;
      TFC_INDEPENDENT
      for (Index i = 0; i < width; ++i)
      {
        to[i] += factor * a[i];
      }
    }
  }

  Index Length, Count, Pitch;
  AlignedVector<Real> Factors; // of offset j, one per frequency
};
}

#endif
