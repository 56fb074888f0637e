// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCBrickDistances.h"

#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include <algorithm>

namespace
{

using Byte = unsigned char;

//------------------------------------------------------------------------------
// Distances along a row: once forth, once back.
void FindInRow(const Byte* active, Byte* out, vtkIdType length)
{
  int distance = vtkTFCBrickDistances::Largest;
  for (vtkIdType i = 0; i < length; ++i)
  {
    distance = active[i] ? 0 : std::min(distance + 1, vtkTFCBrickDistances::Largest);
    out[i] = static_cast<Byte>(distance);
  }
  distance = vtkTFCBrickDistances::Largest;
  for (vtkIdType i = length - 1; i >= 0; --i)
  {
    distance = std::min<int>(out[i], std::min(distance + 1, vtkTFCBrickDistances::Largest));
    out[i] = static_cast<Byte>(distance);
  }
}

//------------------------------------------------------------------------------
// Distances of row `index` of `count` rows that lie `stride` bytes apart, from those that only look
// along the rows. `rows` is the first of them.
void FindAcrossRows(const Byte* rows, vtkIdType stride, vtkIdType index, vtkIdType count,
  vtkIdType length, Byte* __restrict out)
{
  const Byte* own = rows + index * stride;
  std::copy_n(own, length, out);
  for (vtkIdType k = 1; k < vtkTFCBrickDistances::Largest; ++k)
  {
    // From outside of the volume nothing comes nearer.
    const Byte* before = index >= k ? own - k * stride : own;
    const Byte* after = index + k < count ? own + k * stride : own;
    const auto step = static_cast<Byte>(k);
    Byte farthest = 0;
    for (vtkIdType i = 0; i < length; ++i)
    {
      const Byte nearer = before[i] < after[i] ? before[i] : after[i];
      const Byte there = nearer > step ? nearer : step;
      const Byte now = there < out[i] ? there : out[i];
      out[i] = now;
      farthest = now > farthest ? now : farthest;
    }
    if (farthest <= k)
    {
      break;
    }
  }
}

}

//------------------------------------------------------------------------------
std::vector<unsigned char> vtkTFCBrickDistances::Find(const std::vector<unsigned char>& active,
  const std::array<int, 3>& dimensions)
{
  const vtkIdType length = dimensions[0];
  const vtkIdType height = dimensions[1];
  const vtkIdType depth = dimensions[2];
  const vtkIdType layer = length * height;
  std::vector<Byte> along(active.size());
  std::vector<Byte> distances(active.size());
  // A row is a unit of work; a few thousand bricks make a task.
  const vtkIdType grain = std::max<vtkIdType>(1, 8192 / std::max<vtkIdType>(1, length));
  const vtkIdType rows = height * depth;

  vtkTFCThreads::For(0, rows, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        FindInRow(active.data() + row * length, along.data() + row * length, length);
      }
    });
  vtkTFCThreads::For(0, rows, grain,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          FindAcrossRows(along.data() + row / height * layer, length, row % height, height, length,
            distances.data() + row * length);
        }
      }));
  vtkTFCThreads::For(0, rows, grain,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          FindAcrossRows(distances.data() + row % height * length, layer, row / height, depth,
            length, along.data() + row * length);
        }
      }));
  return along;
}
