// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCBrickRanges.h"

#include "vtkTFCThreads.h"

#include <algorithm>
#include <limits>

namespace
{

using Range = vtkTFCBrickRanges::Range;

//------------------------------------------------------------------------------
// The comparisons are false for NaN, so that it changes nothing. As many channels as a vector
// register holds side by side, for the compiler to see.
template <int Channels>
void Extend(Range& range, const float* texel, int count)
{
  std::array<float, Channels> low;
  std::array<float, Channels> high;
  std::copy_n(range.Minimum.begin(), Channels, low.begin());
  std::copy_n(range.Maximum.begin(), Channels, high.begin());
  for (int i = 0; i < count; ++i)
  {
    for (int c = 0; c < Channels; ++c)
    {
      const float value = texel[Channels * i + c];
      low[c] = value < low[c] ? value : low[c];
      high[c] = value > high[c] ? value : high[c];
    }
  }
  std::copy_n(low.begin(), Channels, range.Minimum.begin());
  std::copy_n(high.begin(), Channels, range.Maximum.begin());
}

//------------------------------------------------------------------------------
// One row of texels into the bricks of a row.
template <int Channels>
void ExtendRow(Range* bricks, int numberOfBricks, int size, const float* row, int length)
{
  for (int brick = 0; brick < numberOfBricks; ++brick)
  {
    const int first = brick * size;
    Extend<Channels>(bricks[brick], row + static_cast<vtkIdType>(Channels) * first,
      std::min(size + 1, length - first));
  }
}

//------------------------------------------------------------------------------
// Rows of bricks [begin, end), counted through a layer and then through layers.
template <int Channels>
void ExtendBricks(Range* ranges, const std::array<int, 3>& bricks, int size, const float* values,
  const std::array<int, 3>& texels, vtkIdType begin, vtkIdType end)
{
  for (vtkIdType index = begin; index < end; ++index)
  {
    const int firstY = static_cast<int>(index % bricks[1]) * size;
    const int firstZ = static_cast<int>(index / bricks[1]) * size;
    for (int z = firstZ; z < std::min(firstZ + size + 1, texels[2]); ++z)
    {
      for (int y = firstY; y < std::min(firstY + size + 1, texels[1]); ++y)
      {
        const vtkIdType row = y + static_cast<vtkIdType>(texels[1]) * z;
        ExtendRow<Channels>(ranges + index * bricks[0], bricks[0], size,
          values + Channels * row * texels[0], texels[0]);
      }
    }
  }
}

}

//------------------------------------------------------------------------------
void vtkTFCBrickRanges::Compute(const float* values, const std::array<int, 3>& texels, int channels)
{
  vtkIdType count = 0;
  for (this->BrickSize = 4;; this->BrickSize *= 2)
  {
    count = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Dimensions[axis] =
        std::max(1, (texels[axis] - 1 + this->BrickSize - 1) / this->BrickSize);
      count *= this->Dimensions[axis];
    }
    if (count <= LargestNumberOfBricks)
    {
      break;
    }
  }
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Range empty;
  empty.Minimum.fill(infinity);
  empty.Maximum.fill(-infinity);
  const auto& bricks = this->Dimensions;
  this->Ranges.assign(count, empty);
  const auto extend = channels == 2 ? ExtendBricks<2> : ExtendBricks<4>;
  vtkTFCThreads::For(0, static_cast<vtkIdType>(bricks[1]) * bricks[2], 16,
    [&](vtkIdType begin, vtkIdType end)
    { extend(this->Ranges.data(), bricks, this->BrickSize, values, texels, begin, end); });
}
