// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Loops compiled for several instruction sets, chosen at run time.
 *
 * vtkTFCSimd::Vectorize(body) wraps a loop body(begin, end) so that it, with everything that it
 * calls and that the compiler can inline, exists three times: for the baseline of the build
 * (x86-64: SSE2), for AVX2 and for AVX-512. The best one that the processor has is called. On other
 * processors and compilers there is the baseline only.
 *
 * All three give the same bits: the loops hold no reduction that the compiler may reorder, and
 * multiplications and additions are not contracted (-ffp-contract=off, see CMakeLists.txt).
 *
 * The environment variable TFC_SIMD limits the choice: "baseline", "avx2" or "avx512". It is read
 * at every call, so that a test can compare them in one process.
 */

#ifndef vtkTFCSimd_h
#define vtkTFCSimd_h

#include "vtkTFCFiltersModule.h" // For export macro

#include "vtkType.h" // For vtkIdType

#include <utility> // For std::move

// Clang has the attributes, but not "flatten" as GCC means it: nothing would be gained there.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TFC_HAS_SIMD_LEVELS 1
#define TFC_AVX2 __attribute__((target("avx2"), flatten, noinline))
#define TFC_AVX512                                                                                 \
  __attribute__((target("avx512f,avx512vl,avx512dq,avx512bw,prefer-vector-width=512"), flatten,    \
    noinline))
#else
#define TFC_HAS_SIMD_LEVELS 0
#define TFC_AVX2
#define TFC_AVX512
#endif

namespace vtkTFCSimd
{
enum class Level
{
  Baseline,
  AVX2,
  AVX512
};

/**
 * The level that Vectorize() uses: the best of this processor, or what TFC_SIMD allows of it.
 */
VTKTFCFILTERS_EXPORT Level GetLevel();

/**
 * Its name as in TFC_SIMD.
 */
VTKTFCFILTERS_EXPORT const char* GetName(Level level);

template <typename Body>
TFC_AVX2 void RunAVX2(const Body& body, vtkIdType begin, vtkIdType end)
{
  body(begin, end);
}

template <typename Body>
TFC_AVX512 void RunAVX512(const Body& body, vtkIdType begin, vtkIdType end)
{
  body(begin, end);
}

/**
 * A copy of `body` as a callable for vtkTFCThreads that runs at the best level.
 */
template <typename Body>
auto Vectorize(Body body)
{
  return [body = std::move(body), level = GetLevel()](vtkIdType begin, vtkIdType end)
  {
    if (TFC_HAS_SIMD_LEVELS && level == Level::AVX512)
    {
      RunAVX512(body, begin, end);
    }
    else if (TFC_HAS_SIMD_LEVELS && level == Level::AVX2)
    {
      RunAVX2(body, begin, end);
    }
    else
    {
      body(begin, end);
    }
  };
}
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCSimd.h
