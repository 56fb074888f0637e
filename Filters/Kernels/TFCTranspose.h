// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Transposition of small square tiles of numbers, in vector registers.
 *
 * A tile of N x N numbers, N a power of two, is transposed by log2(N) perfect shuffles, each of
 * which interleaves the first half of the tile with the second: out[2 m] = in[m],
 * out[2 m + 1] = in[m + N^2 / 2]. In the binary index of a number, a shuffle moves the first digit
 * to the end; after log2(N) of them row and column are exchanged (H. S. Stone, "Parallel Processing
 * with the Perfect Shuffle", IEEE Trans. Computers C-20, 1971). Compilers make vector instructions
 * of an interleaving loop, which they do not of a transposition.
 *
 * Cost: log2(N) / 16 vector loads and stores per number with registers of 16.
 */

#ifndef TFCTranspose_h
#define TFCTranspose_h

#include "TFCVector.h"

#include <cstddef>

namespace tfc
{
template <typename T, int N>
class TileTransposition
{
public:
  /**
   * Row i of the tile at row(i); the transposed tile goes to `to`, row after row.
   */
  template <typename Row>
  void Gather(const Row& row, T* to)
  {
    T* target = Shuffles % 2 ? to : this->Scratch;
    for (int i = 0; i < N / 2; ++i)
    {
      Interleave<N>(row(i), row(i + N / 2), target + 2 * i * N);
    }
    for (int shuffle = 1; shuffle < Shuffles; ++shuffle)
    {
      T* const from = target;
      target = from == to ? this->Scratch : to;
      Interleave<N * N / 2>(from, from + N * N / 2, target);
    }
  }

  /**
   * The tile at `from`, row after row, is overwritten; row i of the transposed tile goes to row(i).
   */
  template <typename Row>
  void Scatter(T* from, const Row& row)
  {
    for (int shuffle = 1; shuffle < Shuffles; ++shuffle)
    {
      T* const to = shuffle % 2 ? this->Scratch : from;
      T* const source = shuffle % 2 ? from : this->Scratch;
      Interleave<N * N / 2>(source, source + N * N / 2, to);
    }
    const T* last = Shuffles % 2 ? from : this->Scratch;
    for (int i = 0; i < N; ++i)
    {
      Interleave<N / 2>(last + i * (N / 2), last + (i + N) * (N / 2), row(i));
    }
  }

private:
  static constexpr int CountShuffles()
  {
    int count = 0;
    for (int n = N; n > 1; n /= 2)
    {
      ++count;
    }
    return count;
  }
  static constexpr int Shuffles = CountShuffles();
  static_assert(N >= 2 && (N & (N - 1)) == 0, "the size of a tile is a power of two");

  template <int Count>
  static void Interleave(const T* __restrict a, const T* __restrict b, T* __restrict to)
  {
    TFC_INDEPENDENT
    for (int m = 0; m < Count; ++m)
    {
      to[2 * m] = a[m];
      to[2 * m + 1] = b[m];
    }
  }

  alignas(64) T Scratch[N * N];
};
}

#endif
