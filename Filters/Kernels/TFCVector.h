// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the kernels tell the compiler about their loops, and the shortest of these.
 */

#ifndef TFCVector_h
#define TFCVector_h

/**
 * Before a loop whose iterations do not touch each other's data: the compiler may then use wide
 * registers where it cannot prove that itself (GCC does not for more than a few pointers). Loops of
 * known, small length are not unrolled first, after which GCC finds wide registers only by chance.
 */
#if defined(__clang__)
#define TFC_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define TFC_INDEPENDENT _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define TFC_INDEPENDENT
#endif

namespace tfc
{
/**
 * Copies the numbers of one register, or of a few.
 */
template <int Lanes, typename Real>
inline void CopyLanes(const Real* __restrict from, Real* __restrict to)
{
  TFC_INDEPENDENT
  for (int l = 0; l < Lanes; ++l)
  {
    to[l] = from[l];
  }
}
}

#endif
