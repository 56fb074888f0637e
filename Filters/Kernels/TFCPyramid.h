// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lattices of a pyramid: every 1st, 2nd, 4th, ... sample of a volume, per axis.
 *
 * Samples are counted in the whole volume, so that pieces of it, wherever they begin, keep the same
 * ones. They are taken as they are: what is halved must be smooth enough before.
 */

#ifndef TFCPyramid_h
#define TFCPyramid_h

#include "TFCGradient.h"

namespace tfc
{
/**
 * A part of the whole volume on a lattice of the pyramid: sample i lies at (First + i) * Stride.
 */
struct CoarseLattice
{
  Index Stride[3] = { 1, 1, 1 };
  Index First[3] = { 0, 0, 0 };
  Index Size[3] = { 0, 0, 0 };

  Index GetSize() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
};
/**
 * Of the samples [offset, offset + size) of the volume, those on the lattice with this stride.
 */
inline CoarseLattice MakeCoarseLattice(const Index offset[3], const Index size[3],
  const Index stride[3])
{
  CoarseLattice lattice;
  for (int a = 0; a < 3; ++a)
  {
    lattice.Stride[a] = stride[a];
    lattice.First[a] = (offset[a] + stride[a] - 1) / stride[a];
    const Index last = (offset[a] + size[a] - 1) / stride[a];
    lattice.Size[a] = std::max<Index>(0, last - lattice.First[a] + 1);
  }
  return lattice;
}

/**
 * Slice z of a coarse lattice from a finer one.
 */
inline void SubsampleSlice(const float* fine, const CoarseLattice& from, const CoarseLattice& to,
  Index z, float* coarse)
{
  Index step[3], start[3];
  for (int a = 0; a < 3; ++a)
  {
    step[a] = to.Stride[a] / from.Stride[a];
    start[a] = to.First[a] * step[a] - from.First[a];
  }
  for (Index y = 0; y < to.Size[1]; ++y)
  {
    const float* in = fine + start[0] +
      ((start[2] + z * step[2]) * from.Size[1] + start[1] + y * step[1]) * from.Size[0];
    float* out = coarse + (z * to.Size[1] + y) * to.Size[0];
    for (Index x = 0; x < to.Size[0]; ++x)
    {
      out[x] = in[x * step[0]];
    }
  }
}
}

#endif
