// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scratch memory for vector code: begins at a cache line, and is not initialised.
 *
 * A vector register as wide as a cache line that is loaded from anywhere else takes two of them.
 */

#ifndef TFCAlignedVector_h
#define TFCAlignedVector_h

#include <cstddef>
#include <new>
#include <vector>

namespace tfc
{
template <typename T>
struct AlignedAllocator
{
  using value_type = T;
  static constexpr std::align_val_t Alignment{ 64 };

  AlignedAllocator() = default;
  template <typename U>
  AlignedAllocator(const AlignedAllocator<U>&)
  {
  }

  T* allocate(std::size_t count)
  {
    return static_cast<T*>(::operator new(count * sizeof(T), Alignment));
  }
  void deallocate(T* memory, std::size_t) { ::operator delete(memory, Alignment); }

  /// resize() leaves new numbers as they are.
  template <typename U>
  void construct(U* at)
  {
    ::new (static_cast<void*>(at)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* at, const Arguments&... arguments)
  {
    ::new (static_cast<void*>(at)) U(arguments...);
  }

  friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
  friend bool operator!=(const AlignedAllocator&, const AlignedAllocator&) { return false; }
};

template <typename T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;
}

#endif
