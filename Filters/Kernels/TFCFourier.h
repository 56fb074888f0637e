// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Discrete Fourier transforms of several complex sequences side by side.
 *
 * X[k] = sum_j x[j] exp(-2 pi i j k / n), for `Lanes` sequences at once whose j-th numbers lie next
 * to each other, so that every operation is one on adjacent numbers. Lengths are 2^a 3^b 5^c;
 * GetFourierLength() finds the next one. Method: Stockham's self-sorting variant with radices 4, 2,
 * 3 and 5 (C. Van Loan, "Computational Frameworks for the Fast Fourier Transform", 1992, section
 * 1.7). Relative error in units of the type's precision: a few times log2(n).
 *
 * There is no scaling, and the inverse transform is the same with real and imaginary part
 * exchanged, in the argument and in the result.
 *
 * Why it is here: of what Debian packages, the permissively licensed libraries transform one
 * sequence at a time (several times slower), and FFTW's licence would become this project's.
 *
 * Cost: about 5 n log2(n) operations per sequence; no allocation in Transform().
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
  {
    for (std::ptrdiff_t rest = n, stride = 1; rest > 1;)
    {
      const int radix = rest % 4 == 0 ? 4 : rest % 2 == 0 ? 2 : rest % 3 == 0 ? 3 : 5;
      Stage stage{ radix, rest / radix, stride, {}, {} };
      for (std::ptrdiff_t p = 0; p < stage.Count; ++p)
      {
        for (int j = 1; j < radix; ++j)
        {
          const double angle =
            -2. * 3.14159265358979323846 * static_cast<double>(p * j) / static_cast<double>(rest);
          stage.Cosines.push_back(static_cast<Real>(std::cos(angle)));
          stage.Sines.push_back(static_cast<Real>(std::sin(angle)));
        }
      }
      this->Stages.push_back(std::move(stage));
      rest /= radix;
      stride *= radix;
    }
  }

  std::ptrdiff_t GetLength() const { return this->Length; }

  /**
   * Number of values of each of the four arrays of Transform().
   */
  std::ptrdiff_t GetSize() const { return this->Length * Lanes; }

  /**
   * Transforms (re, im), laid out [j * Lanes + lane], using (re2, im2) of the same size. Returns
   * whether the result is in the second pair.
   */
  bool Transform(Real* re, Real* im, Real* re2, Real* im2) const
  {
    bool swapped = false;
    for (const Stage& stage : this->Stages)
    {
      switch (stage.Radix)
      {
        case 2:
          Pass<2>(stage, re, im, re2, im2);
          break;
        case 3:
          Pass<3>(stage, re, im, re2, im2);
          break;
        case 4:
          Pass<4>(stage, re, im, re2, im2);
          break;
        default:
          Pass<5>(stage, re, im, re2, im2);
      }
      std::swap(re, re2);
      std::swap(im, im2);
      swapped = !swapped;
    }
    return swapped;
  }

private:
  struct Stage
  {
    int Radix;
    std::ptrdiff_t Count;  // of butterflies with different factors
    std::ptrdiff_t Stride; // sequences that are already apart
    std::vector<Real> Cosines, Sines;
  };

  template <int Radix>
  static void Pass(const Stage& stage, const Real* re, const Real* im, Real* re2, Real* im2)
  {
    const std::ptrdiff_t width = stage.Stride * Lanes;
    const std::ptrdiff_t distance = stage.Count * width;
    for (std::ptrdiff_t p = 0; p < stage.Count; ++p)
    {
      const Real* cosines = stage.Cosines.data() + p * (Radix - 1);
      const Real* sines = stage.Sines.data() + p * (Radix - 1);
      for (std::ptrdiff_t q = 0; q < width; q += Lanes)
      {
        const std::ptrdiff_t from = p * width + q, to = p * Radix * width + q;
        Butterfly<Radix>(re + from, im + from, distance, re2 + to, im2 + to, width, cosines, sines);
      }
    }
  }

  /// Product with the factor c + i s; the pointers are to one number per lane.
  static void Store(Real x, Real y, Real c, Real s, Real& re, Real& im)
  {
    re = x * c - y * s;
    im = x * s + y * c;
  }

  template <int Radix>
  static void Butterfly(const Real* __restrict re, const Real* __restrict im, std::ptrdiff_t in,
    Real* __restrict re2, Real* __restrict im2, std::ptrdiff_t out, const Real* __restrict c,
    const Real* __restrict s)
  {
    // Every pointer by itself: the compiler vectorises over the lanes only when it sees that.
    const Real* __restrict a0 = re;
    const Real* __restrict b0 = im;
    const Real* __restrict a1 = re + in;
    const Real* __restrict b1 = im + in;
    Real* __restrict u0 = re2;
    Real* __restrict v0 = im2;
    Real* __restrict u1 = re2 + out;
    Real* __restrict v1 = im2 + out;
    if constexpr (Radix == 2)
    {
      const Real c1 = c[0], s1 = s[0];
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        u0[l] = a0[l] + a1[l];
        v0[l] = b0[l] + b1[l];
        Store(a0[l] - a1[l], b0[l] - b1[l], c1, s1, u1[l], v1[l]);
      }
      return;
    }
    const Real* __restrict a2 = re + 2 * in;
    const Real* __restrict b2 = im + 2 * in;
    Real* __restrict u2 = re2 + 2 * out;
    Real* __restrict v2 = im2 + 2 * out;
    if constexpr (Radix == 3)
    {
      const Real c1 = c[0], s1 = s[0], c2 = c[1], s2 = s[1];
      const Real half = Real(0.5), sine = Real(0.86602540378443864676);
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        const Real x = a1[l] + a2[l], y = b1[l] + b2[l];
        const Real dx = (a1[l] - a2[l]) * sine, dy = (b1[l] - b2[l]) * sine;
        const Real mx = a0[l] - half * x, my = b0[l] - half * y;
        u0[l] = a0[l] + x;
        v0[l] = b0[l] + y;
        Store(mx + dy, my - dx, c1, s1, u1[l], v1[l]);
        Store(mx - dy, my + dx, c2, s2, u2[l], v2[l]);
      }
      return;
    }
    const Real* __restrict a3 = re + 3 * in;
    const Real* __restrict b3 = im + 3 * in;
    Real* __restrict u3 = re2 + 3 * out;
    Real* __restrict v3 = im2 + 3 * out;
    if constexpr (Radix == 4)
    {
      const Real c1 = c[0], s1 = s[0], c2 = c[1], s2 = s[1], c3 = c[2], s3 = s[2];
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        const Real x02 = a0[l] + a2[l], y02 = b0[l] + b2[l];
        const Real x13 = a1[l] + a3[l], y13 = b1[l] + b3[l];
        const Real dx02 = a0[l] - a2[l], dy02 = b0[l] - b2[l];
        const Real dx13 = a1[l] - a3[l], dy13 = b1[l] - b3[l];
        u0[l] = x02 + x13;
        v0[l] = y02 + y13;
        Store(dx02 + dy13, dy02 - dx13, c1, s1, u1[l], v1[l]);
        Store(x02 - x13, y02 - y13, c2, s2, u2[l], v2[l]);
        Store(dx02 - dy13, dy02 + dx13, c3, s3, u3[l], v3[l]);
      }
    }
    if constexpr (Radix == 5)
    {
      const Real* __restrict a4 = re + 4 * in;
      const Real* __restrict b4 = im + 4 * in;
      Real* __restrict u4 = re2 + 4 * out;
      Real* __restrict v4 = im2 + 4 * out;
      const Real c1 = c[0], s1 = s[0], c2 = c[1], s2 = s[1];
      const Real c3 = c[2], s3 = s[2], c4 = c[3], s4 = s[3];
      // Cosines and sines of 72 and 144 degrees.
      const Real ca = Real(0.30901699437494742410), cb = Real(-0.80901699437494742410);
      const Real sa = Real(0.95105651629515357212), sb = Real(0.58778525229247312917);
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        const Real x14 = a1[l] + a4[l], y14 = b1[l] + b4[l];
        const Real x23 = a2[l] + a3[l], y23 = b2[l] + b3[l];
        const Real dx14 = a1[l] - a4[l], dy14 = b1[l] - b4[l];
        const Real dx23 = a2[l] - a3[l], dy23 = b2[l] - b3[l];
        const Real mxa = a0[l] + ca * x14 + cb * x23, mya = b0[l] + ca * y14 + cb * y23;
        const Real mxb = a0[l] + cb * x14 + ca * x23, myb = b0[l] + cb * y14 + ca * y23;
        const Real dxa = sa * dx14 + sb * dx23, dya = sa * dy14 + sb * dy23;
        const Real dxb = sb * dx14 - sa * dx23, dyb = sb * dy14 - sa * dy23;
        u0[l] = a0[l] + x14 + x23;
        v0[l] = b0[l] + y14 + y23;
        Store(mxa + dya, mya - dxa, c1, s1, u1[l], v1[l]);
        Store(mxb + dyb, myb - dxb, c2, s2, u2[l], v2[l]);
        Store(mxb - dyb, myb + dxb, c3, s3, u3[l], v3[l]);
        Store(mxa - dya, mya + dxa, c4, s4, u4[l], v4[l]);
      }
    }
  }

  std::ptrdiff_t Length;
  std::vector<Stage> Stages;
};
}

#endif
