// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Memory for volumes: not initialised, and in large pages where the system has them.
 *
 * The first touch of a page costs more than a whole gradient; large pages make it 512 times rarer.
 */

#ifndef vtkTFCLargeBuffer_h
#define vtkTFCLargeBuffer_h

#include "vtkType.h" // For vtkIdType

#include <cstdlib>
#include <memory>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace vtkTFCLargeBuffer
{
struct Free
{
  void operator()(float* memory) const { std::free(memory); }
};
using Pointer = std::unique_ptr<float, Free>;

/**
 * `count` floats; throws std::bad_alloc. Released with free(), so that a vtkFloatArray may own
 * them.
 */
inline Pointer Allocate(vtkIdType count)
{
  const size_t bytes = static_cast<size_t>(count > 0 ? count : 1) * sizeof(float);
#ifdef __linux__
  constexpr size_t page = size_t{ 1 } << 21;
  if (bytes >= 4 * page)
  {
    const size_t rounded = (bytes + page - 1) / page * page;
    if (void* memory = std::aligned_alloc(page, rounded))
    {
      // Advice only: where it is not followed, pages are small.
      madvise(memory, rounded, MADV_HUGEPAGE);
      return Pointer(static_cast<float*>(memory));
    }
  }
#endif
  if (void* memory = std::malloc(bytes))
  {
    return Pointer(static_cast<float*>(memory));
  }
  throw std::bad_alloc();
}
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCLargeBuffer.h
