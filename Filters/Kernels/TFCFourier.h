// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Discrete Fourier transforms of several complex sequences side by side, in place.
 *
 * X[k] = sum_j x[j] exp(-2 pi i j k / n), for `Lanes` sequences at once whose j-th numbers lie next
 * to each other, so that every operation is one on adjacent numbers. Lengths are 2^a 3^b 5^c;
 * GetFourierLength() finds the next one. X[k] is left at GetPositions()[k], and the inverse
 * transform takes it from there: a convolution needs no order, and in place a sequence of some
 * hundred numbers stays in the nearest cache.
 *
 * Method: decimation in frequency (Gentleman and Sande) forth and its passes inverted, which is
 * decimation in time, back, with radices 4, 2, 3 and 5 (C. Van Loan, "Computational Frameworks for
 * the Fast Fourier Transform", 1992, chapters 1 and 2). Relative error in units of the type's
 * precision: a few times log2(n).
 *
 * There is no scaling: back and forth is n times the sequence.
 *
 * Why it is here: of what Debian packages, the permissively licensed libraries transform one
 * sequence at a time (several times slower), and FFTW's licence would become this project's.
 *
 * Cost: about 5 n log2(n) operations per sequence; no allocation in the transforms.
 */
#ifndef TFCFourier_h
#define TFCFourier_h

#include "TFCVector.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tfc
{
/**
 * The smallest product of twos, threes and fives that is at least `n` >= 1.
 */
inline std::ptrdiff_t GetFourierLength(std::ptrdiff_t n)
{
  for (;; ++n)
  {
    std::ptrdiff_t rest = n;
    for (const int factor : { 2, 3, 5 })
    {
      while (rest % factor == 0)
      {
        rest /= factor;
      }
    }
    if (rest == 1)
    {
      return n;
    }
  }
}

template <typename Real, int Lanes>
class FourierTransform
{
public:
  /**
   * `n` must be a value of GetFourierLength().
   */
  explicit FourierTransform(std::ptrdiff_t n)
    : Length(n)
    , Positions(static_cast<size_t>(n), 0)
  {
    std::ptrdiff_t weight = 1;
    for (std::ptrdiff_t rest = n; rest > 1; rest = this->Passes.back().Distance)
    {
      const int radix = rest % 4 == 0 ? 4 : rest % 2 == 0 ? 2 : rest % 3 == 0 ? 3 : 5;
      Pass pass{ radix, rest / radix, {}, {} };
      for (std::ptrdiff_t p = 0; p < pass.Distance; ++p)
      {
        for (int j = 1; j < radix; ++j)
        {
          const double angle =
            -2. * 3.14159265358979323846 * static_cast<double>(p * j) / static_cast<double>(rest);
          pass.Cosines.push_back(static_cast<Real>(std::cos(angle)));
          pass.Sines.push_back(static_cast<Real>(std::sin(angle)));
        }
      }
      // A pass sends the frequencies with the same next digit to one part of the block.
      for (std::ptrdiff_t k = 0; k < n; ++k)
      {
        this->Positions[k] += k / weight % radix * pass.Distance;
      }
      weight *= radix;
      this->Passes.push_back(std::move(pass));
    }
  }

  std::ptrdiff_t GetLength() const { return this->Length; }

  /**
   * Number of values of each of the two arrays.
   */
  std::ptrdiff_t GetSize() const { return this->Length * Lanes; }

  /**
   * Where frequency k is, k = 0 ... n - 1: X[k] at [GetPositions()[k] * Lanes + lane].
   */
  const std::ptrdiff_t* GetPositions() const { return this->Positions.data(); }

  /**
   * Transforms (re, im), laid out [j * Lanes + lane].
   */
  void Transform(Real* re, Real* im) const
  {
    for (const Pass& pass : this->Passes)
    {
      this->Run<false>(pass, re, im);
    }
  }

  /**
   * Back, to n times the sequence.
   */
  void Invert(Real* re, Real* im) const
  {
    for (auto pass = this->Passes.rbegin(); pass != this->Passes.rend(); ++pass)
    {
      // Exchanged parts make the inverse of what each pass does.
      this->Run<true>(*pass, im, re);
    }
  }

private:
  struct Pass
  {
    int Radix;
    std::ptrdiff_t Distance; // of the numbers of a butterfly, and the number of different factors
    std::vector<Real> Cosines, Sines;
  };

  /// Where the numbers of a butterfly are multiplied with factors.
  enum class Factors
  {
    None,
    Before,
    After
  };

  template <bool Inverse>
  void Run(const Pass& pass, Real* re, Real* im) const
  {
    switch (pass.Radix)
    {
      case 2:
        this->RunRadix<2, Inverse>(pass, re, im);
        break;
      case 3:
        this->RunRadix<3, Inverse>(pass, re, im);
        break;
      case 4:
        this->RunRadix<4, Inverse>(pass, re, im);
        break;
      default:
        this->RunRadix<5, Inverse>(pass, re, im);
    }
  }

  template <int Radix, bool Inverse>
  void RunRadix(const Pass& pass, Real* re, Real* im) const
  {
    // The first factors are 1.
    this->RunFactor<Radix, Factors::None>(pass, 0, re, im);
    for (std::ptrdiff_t p = 1; p < pass.Distance; ++p)
    {
      this->RunFactor<Radix, Inverse ? Factors::Before : Factors::After>(pass, p, re, im);
    }
  }

  /// The butterflies of all blocks that have the same factors.
  template <int Radix, Factors Where>
  void RunFactor(const Pass& pass, std::ptrdiff_t p, Real* re, Real* im) const
  {
    const Real* cosines = pass.Cosines.data() + p * (Radix - 1);
    const Real* sines = pass.Sines.data() + p * (Radix - 1);
    const std::ptrdiff_t distance = pass.Distance * Lanes;
    for (std::ptrdiff_t at = p * Lanes; at < this->GetSize(); at += Radix * distance)
    {
      Butterfly<Radix, Where>(re + at, im + at, distance, cosines, sines);
    }
  }

  /// (x, y), times the factor c + i s if there is one at this place.
  template <bool Times>
  static void Turn(Real x, Real y, Real c, Real s, Real& u, Real& v)
  {
    u = Times ? x * c - y * s : x;
    v = Times ? x * s + y * c : y;
  }

  template <int Radix, Factors Where>
  static void Butterfly(Real* re, Real* im, std::ptrdiff_t distance, const Real* __restrict c,
    const Real* __restrict s)
  {
    constexpr bool before = Where == Factors::Before, after = Where == Factors::After;
    // Every pointer by itself: the compiler vectorises over the lanes only when it sees that.
    Real* __restrict a0 = re;
    Real* __restrict b0 = im;
    Real* __restrict a1 = re + distance;
    Real* __restrict b1 = im + distance;
    const Real c1 = c[0], s1 = s[0];
    if constexpr (Radix == 2)
    {
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        Real x1, y1;
        const Real x0 = a0[l], y0 = b0[l];
        Turn<before>(a1[l], b1[l], c1, s1, x1, y1);
        a0[l] = x0 + x1;
        b0[l] = y0 + y1;
        Turn<after>(x0 - x1, y0 - y1, c1, s1, a1[l], b1[l]);
      }
      return;
    }
    Real* __restrict a2 = re + 2 * distance;
    Real* __restrict b2 = im + 2 * distance;
    const Real c2 = c[1], s2 = s[1];
    if constexpr (Radix == 3)
    {
      const Real half = Real(0.5), sine = Real(0.86602540378443864676);
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        Real x1, y1, x2, y2;
        const Real x0 = a0[l], y0 = b0[l];
        Turn<before>(a1[l], b1[l], c1, s1, x1, y1);
        Turn<before>(a2[l], b2[l], c2, s2, x2, y2);
        const Real x = x1 + x2, y = y1 + y2;
        const Real dx = (x1 - x2) * sine, dy = (y1 - y2) * sine;
        const Real mx = x0 - half * x, my = y0 - half * y;
        a0[l] = x0 + x;
        b0[l] = y0 + y;
        Turn<after>(mx + dy, my - dx, c1, s1, a1[l], b1[l]);
        Turn<after>(mx - dy, my + dx, c2, s2, a2[l], b2[l]);
      }
      return;
    }
    Real* __restrict a3 = re + 3 * distance;
    Real* __restrict b3 = im + 3 * distance;
    const Real c3 = c[2], s3 = s[2];
    if constexpr (Radix == 4)
    {
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        Real x1, y1, x2, y2, x3, y3;
        const Real x0 = a0[l], y0 = b0[l];
        Turn<before>(a1[l], b1[l], c1, s1, x1, y1);
        Turn<before>(a2[l], b2[l], c2, s2, x2, y2);
        Turn<before>(a3[l], b3[l], c3, s3, x3, y3);
        const Real x02 = x0 + x2, y02 = y0 + y2;
        const Real x13 = x1 + x3, y13 = y1 + y3;
        const Real dx02 = x0 - x2, dy02 = y0 - y2;
        const Real dx13 = x1 - x3, dy13 = y1 - y3;
        a0[l] = x02 + x13;
        b0[l] = y02 + y13;
        Turn<after>(dx02 + dy13, dy02 - dx13, c1, s1, a1[l], b1[l]);
        Turn<after>(x02 - x13, y02 - y13, c2, s2, a2[l], b2[l]);
        Turn<after>(dx02 - dy13, dy02 + dx13, c3, s3, a3[l], b3[l]);
      }
    }
    if constexpr (Radix == 5)
    {
      Real* __restrict a4 = re + 4 * distance;
      Real* __restrict b4 = im + 4 * distance;
      const Real c4 = c[3], s4 = s[3];
      // Cosines and sines of 72 and 144 degrees.
      const Real ca = Real(0.30901699437494742410), cb = Real(-0.80901699437494742410);
      const Real sa = Real(0.95105651629515357212), sb = Real(0.58778525229247312917);
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        Real x1, y1, x2, y2, x3, y3, x4, y4;
        const Real x0 = a0[l], y0 = b0[l];
        Turn<before>(a1[l], b1[l], c1, s1, x1, y1);
        Turn<before>(a2[l], b2[l], c2, s2, x2, y2);
        Turn<before>(a3[l], b3[l], c3, s3, x3, y3);
        Turn<before>(a4[l], b4[l], c4, s4, x4, y4);
        const Real x14 = x1 + x4, y14 = y1 + y4;
        const Real x23 = x2 + x3, y23 = y2 + y3;
        const Real dx14 = x1 - x4, dy14 = y1 - y4;
        const Real dx23 = x2 - x3, dy23 = y2 - y3;
        const Real mxa = x0 + ca * x14 + cb * x23, mya = y0 + ca * y14 + cb * y23;
        const Real mxb = x0 + cb * x14 + ca * x23, myb = y0 + cb * y14 + ca * y23;
        const Real dxa = sa * dx14 + sb * dx23, dya = sa * dy14 + sb * dy23;
        const Real dxb = sb * dx14 - sa * dx23, dyb = sb * dy14 - sa * dy23;
        a0[l] = x0 + x14 + x23;
        b0[l] = y0 + y14 + y23;
        Turn<after>(mxa + dya, mya - dxa, c1, s1, a1[l], b1[l]);
        Turn<after>(mxb + dyb, myb - dxb, c2, s2, a2[l], b2[l]);
        Turn<after>(mxb - dyb, myb + dxb, c3, s3, a3[l], b3[l]);
        Turn<after>(mxa - dya, mya + dxa, c4, s4, a4[l], b4[l]);
      }
    }
  }

  std::ptrdiff_t Length;
  std::vector<Pass> Passes;
  std::vector<std::ptrdiff_t> Positions;
};
}

#endif
