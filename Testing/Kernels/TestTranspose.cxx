// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Kernels/TFCTranspose.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace
{
// Tiles within a larger matrix, so that rows are apart.
template <typename T, int N>
void TestTile()
{
  constexpr int pitch = N + 3;
  std::vector<T> matrix(N * pitch), tile(N * N), back(N * pitch, T(-1));
  std::iota(matrix.begin(), matrix.end(), T(0));
  tfc::TileTransposition<T, N> transposition;
  transposition.Gather([&](int row) { return matrix.data() + row * pitch; }, tile.data());
  for (int row = 0; row < N; ++row)
  {
    for (int column = 0; column < N; ++column)
    {
      ASSERT_EQ(tile[column * N + row], matrix[row * pitch + column]) << N;
    }
  }
  transposition.Scatter(tile.data(), [&](int row) { return back.data() + row * pitch; });
  for (int row = 0; row < N; ++row)
  {
    for (int column = 0; column < pitch; ++column)
    {
      ASSERT_EQ(back[row * pitch + column], column < N ? matrix[row * pitch + column] : T(-1));
    }
  }
}
}

TEST(Transpose, GathersAndScattersTiles)
{
  TestTile<int, 2>();
  TestTile<double, 4>();
  TestTile<double, 8>();
  TestTile<float, 16>();
}
