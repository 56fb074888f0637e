// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Discrete Fourier transform of the weights of a ball, plane by plane.
 *
 * The weights around the origin, of a BallKernel, are even along each axis: so is their transform,
 * which is real, and the frequencies 0 ... length / 2 along each axis say everything. Two even
 * sequences are transformed as the parts of one complex sequence: its transform's parts are theirs.
 *
 * Along z and y at once, along x when a plane is asked for: a convolution takes one frequency along
 * y after the other, and the whole would be as large as an eighth of the padded lattice.
 *
 * Memory: (reach_x + Lanes) (length_y / 2 + 1) (length_z / 2 + Lanes) values.
 */

#ifndef TFCBallSpectrum_h
#define TFCBallSpectrum_h

#include "TFCAlignedVector.h"
#include "TFCBallKernel.h"
#include "TFCFourier.h"
#include "TFCTranspose.h"
#include "TFCVector.h"

#include <algorithm>
#include <array>

namespace tfc
{
template <typename Real>
class BallSpectrum
{
public:
  static constexpr int Lanes = 64 / sizeof(Real);

  /**
   * Transform for a lattice of `length` samples, padding included, times `scale`. `run(count,
   * body)` must call body(begin, end) on ranges that cover [0, count), in parallel if it likes.
   */
  template <typename Run>
  BallSpectrum(const BallKernel& kernel, const std::array<Index, 3>& length, double scale,
    Run&& run)
    : X(length[0])
    , Reach(kernel.GetReach(0))
    , Blocks(this->Reach / Lanes + 1)
    , Groups((length[2] / 2 + Lanes) / Lanes)
  {
    const FourierTransform<Real, Lanes> ey(length[1]), ez(length[2]);
    const Index sy = kernel.GetReach(1) + 1, sz = kernel.GetReach(2) + 1;
    const Index row = this->Blocks * Lanes, frequencies = length[2] / 2 + 1;
    // Along z, columns of an y: [frequency of z][y][x].
    AlignedVector<Real> planes(static_cast<size_t>(frequencies * sy * row));
    TransformPairs(
      run, ez, sy * this->Blocks, sz,
      [&](Index column, Index z, Real* to)
      {
        const Index y = column / this->Blocks, x = column % this->Blocks * Lanes;
        for (Index l = 0; l < Lanes; ++l)
        {
          to[l] = x + l <= this->Reach ? static_cast<Real>(scale * kernel.GetWeight(x + l, y, z))
                                       : Real(0);
        }
      },
      [&](Index column, Index kz) { return planes.data() + kz * sy * row + column * Lanes; });
    // Along y, columns of a frequency of z: [frequency of y][frequency of z][x].
    this->Planes.resize(static_cast<size_t>((length[1] / 2 + 1) * this->GetPlaneSize()));
    for (Index ky = 0; ky <= length[1] / 2; ++ky)
    {
      Real* plane = this->Planes.data() + ky * this->GetPlaneSize();
      std::fill(plane + frequencies * row, plane + this->GetPlaneSize(), Real(0));
    }
    TransformPairs(
      run, ey, frequencies * this->Blocks, sy,
      [&](Index column, Index y, Real* to)
      {
        CopyLanes<Lanes>(planes.data() + (column / this->Blocks * sy + y) * row +
            column % this->Blocks * Lanes,
          to);
      },
      [&](Index column, Index ky)
      { return this->Planes.data() + ky * this->GetPlaneSize() + column * Lanes; });
  }

  /**
   * Buffers of one thread.
   */
  struct Workspace
  {
    AlignedVector<Real> Re, Im, Rows, Plane;
  };

  /**
   * The plane of frequency `k` along y, in the workspace: [Lanes frequencies along z][frequency
   * along x][lane], frequencies 0 ... length / 2 of x, zeros beyond the last of z.
   */
  const Real* GetPlane(Index k, Workspace& work) const
  {
    const Index row = this->Blocks * Lanes, size = (this->X.GetLength() / 2 + 1) * Lanes;
    work.Rows.resize(static_cast<size_t>(this->Groups * row * Lanes));
    work.Plane.resize(static_cast<size_t>(this->Groups * size));
    TileTransposition<Real, Lanes> tile;
    for (Index group = 0; group < this->Groups; ++group)
    {
      const Real* from = this->Planes.data() + k * this->GetPlaneSize() + group * Lanes * row;
      for (Index x = 0; x < row; x += Lanes)
      {
        tile.Gather([&](int l) { return from + l * row + x; },
          work.Rows.data() + (group * row + x) * Lanes);
      }
    }
    for (Index group = 0; group < this->Groups; group += 2)
    {
      TransformPair(
        this->X, group, this->Groups, this->Reach + 1, work.Re, work.Im,
        [&](Index g, Index x, Real* to)
        { CopyLanes<Lanes>(work.Rows.data() + (g * row + x) * Lanes, to); },
        [&](Index g, Index kx) { return work.Plane.data() + g * size + kx * Lanes; });
    }
    return work.Plane.data();
  }

private:
  Index GetPlaneSize() const { return this->Groups * Lanes * this->Blocks * Lanes; }

  /**
   * Transforms of all `columns`, of Lanes even sequences each; see TransformPair().
   */
  template <typename Run, typename Load, typename Place>
  static void TransformPairs(Run&& run, const FourierTransform<Real, Lanes>& transform,
    Index columns, Index count, const Load& load, const Place& place)
  {
    run((columns + 1) / 2,
      [&](Index begin, Index end)
      {
        AlignedVector<Real> re, im;
        for (Index pair = begin; pair < end; ++pair)
        {
          TransformPair(transform, 2 * pair, columns, count, re, im, load, place);
        }
      });
  }

  /**
   * Transforms of the columns `first` and, if there is one, first + 1: load(column, j, to) brings
   * the numbers j = 0 ... count - 1, and frequency k goes to place(column, k).
   */
  template <typename Load, typename Place>
  static void TransformPair(const FourierTransform<Real, Lanes>& transform, Index first,
    Index columns, Index count, AlignedVector<Real>& re, AlignedVector<Real>& im, const Load& load,
    const Place& place)
  {
    const Index n = transform.GetLength(), last = std::min(first + 2, columns);
    re.assign(static_cast<size_t>(transform.GetSize()), Real(0));
    im.assign(static_cast<size_t>(transform.GetSize()), Real(0));
    Real* const parts[2] = { re.data(), im.data() };
    for (Index column = first; column < last; ++column)
    {
      Real* part = parts[column - first];
      for (Index j = 0; j < count; ++j)
      {
        load(column, j, part + j * Lanes);
        CopyLanes<Lanes>(part + j * Lanes, part + (j ? n - j : 0) * Lanes);
      }
    }
    transform.Transform(re.data(), im.data());
    for (Index column = first; column < last; ++column)
    {
      for (Index k = 0; k <= n / 2; ++k)
      {
        CopyLanes<Lanes>(parts[column - first] + transform.GetPositions()[k] * Lanes,
          place(column, k));
      }
    }
  }

  FourierTransform<Real, Lanes> X;
  Index Reach, Blocks; // of offsets along x
  Index Groups;        // of frequencies along z
  AlignedVector<Real> Planes;
};
}

#endif
