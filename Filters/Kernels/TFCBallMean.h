// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Weighted means over balls of a scalar lattice, by Fourier transforms.
 *
 * mean(x) = sum_o w(o) f(x + o) / sum_o w(o), over the offsets o of a BallKernel for which x + o
 * lies in the lattice and is valid (not NaN). Exact up to rounding: numerator and, if there are
 * invalid samples, denominator are convolutions, whose zero padding keeps the borders apart;
 * without invalid samples the denominator comes from BallKernel::SumRow().
 *
 * Three passes, each over independent units, for the caller to spread over threads:
 *   1. Forward(z): transforms along x (two real rows as one complex sequence) and y of a slice;
 *   2. Filter(unit): transform along z, product with the kernel's spectrum, transform back;
 *   3. Backward(z): transforms back along y and x, and the means of the slice.
 * Transforms that would see only padding, or whose result nobody wants, are left out.
 *
 * Real is float, which is accurate to about 1e-6 of the largest |f - offset|, or double where sums
 * of few among many samples must not drown: where there are invalid samples.
 *
 * Cost per sample: about 15 log2(n) operations for each of the numerator and the denominator, n the
 * padded length, size + reach; the same for all radii up to that padding. Memory: GetSize() values.
 */

#ifndef TFCBallMean_h
#define TFCBallMean_h

#include "TFCAlignedVector.h"
#include "TFCBallKernel.h"
#include "TFCFourier.h"

#include <limits>
#include <vector>

namespace tfc
{
template <typename Real>
class BallMean
{
public:
  /// One full wide register of the widest kind.
  static constexpr int Lanes = 64 / sizeof(Real);

  /**
   * Means of `values`, a lattice of `size` samples, for the block [begin, end) of it. `offset` is a
   * value near the samples, subtracted from them. `masked` says whether there may be NaN.
   */
  BallMean(const float* values, const Index size[3], const Index begin[3], const Index end[3],
    float offset, bool masked, const BallKernel& kernel)
    : Values(values)
    , Offset(offset)
    , Fields(masked ? 2 : 1)
    , Kernel(kernel)
    , X(GetFourierLength(size[0] + kernel.GetReach(0)))
    , Y(GetFourierLength(size[1] + kernel.GetReach(1)))
    , Z(GetFourierLength(size[2] + kernel.GetReach(2)))
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Size[a] = size[a];
      this->Begin[a] = begin[a];
      this->End[a] = end[a];
    }
    this->Blocks = (this->X.GetLength() / 2 + Lanes) / Lanes;
  }

  ///@{
  /**
   * Lengths of the transforms.
   */
  void GetLengths(Index length[3]) const
  {
    length[0] = this->X.GetLength();
    length[1] = this->Y.GetLength();
    length[2] = this->Z.GetLength();
  }
  double GetScale() const
  {
    return 1. /
      (static_cast<double>(this->X.GetLength()) * this->Y.GetLength() * this->Z.GetLength());
  }
  ///@}

  /**
   * Number of Real values that the passes need: their last argument but one.
   */
  Index GetSize() const
  {
    return this->Fields * this->Size[2] * this->Y.GetLength() * this->Blocks * 2 * Lanes;
  }

  /**
   * Number of units of Filter().
   */
  Index GetNumberOfUnits() const { return this->Fields * this->Y.GetLength(); }

  /**
   * Buffers of one thread.
   */
  struct Workspace
  {
    AlignedVector<Real> Sequences[4]; // for a transform
    AlignedVector<Real> Rows;         // of a slice, in the spectrum's layout
    std::vector<Real> Results;        // rows of a slice
    std::vector<double> Profile, Weights;
  };

  /**
   * Pass 1 for slice `z` of the lattice.
   */
  void Forward(Index z, Real* spectrum, Workspace& work) const
  {
    for (int field = 0; field < this->Fields; ++field)
    {
      this->Prepare(work);
      for (Index y = 0; y < this->Size[1]; y += 2 * Lanes)
      {
        this->ForwardRows(field, y, z, work);
      }
      for (Index block = 0; block < this->Blocks; ++block)
      {
        Real* re = work.Sequences[0].data();
        Real* im = work.Sequences[1].data();
        for (Index y = 0; y < this->Y.GetLength(); ++y)
        {
          const bool inside = y < this->Size[1];
          const Real* from = work.Rows.data() + (inside ? this->At(y, block) : 0);
          for (int l = 0; l < Lanes; ++l)
          {
            re[y * Lanes + l] = inside ? from[l] : Real(0);
            im[y * Lanes + l] = inside ? from[Lanes + l] : Real(0);
          }
        }
        const int at =
          this->Y.Transform(re, im, work.Sequences[2].data(), work.Sequences[3].data());
        re = work.Sequences[2 * at].data();
        im = work.Sequences[2 * at + 1].data();
        Real* slice = spectrum + this->SliceAt(field, z);
        for (Index y = 0; y < this->Y.GetLength(); ++y)
        {
          Copy(re + y * Lanes, slice + this->At(y, block));
          Copy(im + y * Lanes, slice + this->At(y, block) + Lanes);
        }
      }
    }
  }

  /**
   * Pass 2 for one unit; `response` is BallKernel::GetSpectrum(lengths, GetScale()).
   */
  void Filter(Index unit, const Real* response, Real* spectrum, Workspace& work) const
  {
    const Index ny = this->Y.GetLength(), nz = this->Z.GetLength();
    const Index kx = BallKernel::GetSpectrumPitch<Real>(this->X.GetLength()), ky = ny / 2 + 1;
    const Index y = unit % ny, yResponse = std::min(y, ny - y);
    this->Prepare(work);
    for (Index block = 0; block < this->Blocks; ++block)
    {
      Real* column = spectrum + this->SliceAt(unit / ny, 0) + this->At(y, block);
      const Index stride = this->SliceAt(0, 1);
      Real* re = work.Sequences[0].data();
      Real* im = work.Sequences[1].data();
      for (Index z = 0; z < this->Size[2]; ++z)
      {
        Copy(column + z * stride, re + z * Lanes);
        Copy(column + z * stride + Lanes, im + z * Lanes);
      }
      std::fill(re + this->Size[2] * Lanes, re + nz * Lanes, Real(0));
      std::fill(im + this->Size[2] * Lanes, im + nz * Lanes, Real(0));
      const int at = this->Z.Transform(re, im, work.Sequences[2].data(), work.Sequences[3].data());
      re = work.Sequences[2 * at].data();
      im = work.Sequences[2 * at + 1].data();
      Real* re2 = work.Sequences[2 - 2 * at].data();
      Real* im2 = work.Sequences[3 - 2 * at].data();
      for (Index z = 0; z < nz; ++z)
      {
        const Real* row = response + (std::min(z, nz - z) * ky + yResponse) * kx + block * Lanes;
        TFC_INDEPENDENT
        for (int l = 0; l < Lanes; ++l)
        {
          re[z * Lanes + l] *= row[l];
          im[z * Lanes + l] *= row[l];
        }
      }
      // Exchanged parts: the inverse.
      const bool swapped = this->Z.Transform(im, re, im2, re2);
      re = swapped ? re2 : re;
      im = swapped ? im2 : im;
      for (Index z = this->Begin[2]; z < this->End[2]; ++z)
      {
        Copy(re + z * Lanes, column + z * stride);
        Copy(im + z * Lanes, column + z * stride + Lanes);
      }
    }
  }

  /**
   * Pass 3 for slice `z` of the lattice, Begin <= z < End, into the slice `means` of the block: NaN
   * for an invalid sample.
   */
  void Backward(Index z, const Real* spectrum, Workspace& work, float* means) const
  {
    const Index nx = this->Size[0], width = this->End[0] - this->Begin[0];
    const Index height = this->End[1] - this->Begin[1];
    work.Results.resize(static_cast<size_t>(this->Fields * width * height));
    for (int field = 0; field < this->Fields; ++field)
    {
      this->Prepare(work);
      this->BackwardColumns(spectrum + this->SliceAt(field, z), work);
      for (Index y = this->Begin[1]; y < this->End[1]; y += 2 * Lanes)
      {
        this->BackwardRows(y, work, work.Results.data() + field * width * height);
      }
    }
    work.Weights.resize(static_cast<size_t>(width));
    for (Index y = this->Begin[1]; y < this->End[1]; ++y)
    {
      const Index row = (y - this->Begin[1]) * width;
      const float* samples = this->Values + (z * this->Size[1] + y) * nx + this->Begin[0];
      const Real* sums = work.Results.data() + row;
      if (this->Fields == 1)
      {
        this->Kernel.SumRow(y, z, this->Begin[0], this->End[0], work.Profile, work.Weights.data());
      }
      else
      {
        std::copy(sums + width * height, sums + width * height + width, work.Weights.begin());
      }
      for (Index x = 0; x < width; ++x)
      {
        const double mean = this->Offset + static_cast<double>(sums[x]) / work.Weights[x];
        // NaN where the sample is; where not, the sample's own weight keeps the divisor from 0.
        means[row + x] = static_cast<float>(mean) + (samples[x] - samples[x]);
      }
    }
  }

private:
  /// Places in the spectrum: of a row's block within a slice, and of a slice.
  Index At(Index y, Index block) const { return (y * this->Blocks + block) * 2 * Lanes; }
  Index SliceAt(Index field, Index z) const
  {
    return this->At((field * this->Size[2] + z) * this->Y.GetLength(), 0);
  }

  static void Copy(const Real* __restrict from, Real* __restrict to)
  {
    TFC_INDEPENDENT
    for (int l = 0; l < Lanes; ++l)
    {
      to[l] = from[l];
    }
  }

  void Prepare(Workspace& work) const
  {
    // Lanes without a sequence are transformed with the others: of zeros, as what happens to be in
    // memory may be slow to calculate with.
    const Index size = std::max({ this->X.GetSize(), this->Y.GetSize(), this->Z.GetSize() });
    if (work.Rows.empty())
    {
      for (auto& sequence : work.Sequences)
      {
        sequence.assign(static_cast<size_t>(size), Real(0));
      }
      work.Rows.assign(static_cast<size_t>(this->At(this->Size[1], 0)), Real(0));
    }
  }

  /// Number to transform for a sample: the value, or whether there is one.
  Real Load(int field, float value) const
  {
    const bool valid = IsValid(value);
    return field ? (valid ? Real(1) : Real(0))
                 : (valid ? static_cast<Real>(value) - static_cast<Real>(this->Offset) : Real(0));
  }

  /**
   * Transforms along x the rows y ... y + 2 Lanes - 1: lane l takes rows y + 2 l and y + 2 l + 1.
   */
  void ForwardRows(int field, Index y, Index z, Workspace& work) const
  {
    const Index nx = this->Size[0], ny = this->Size[1], n = this->X.GetLength();
    Real* re = work.Sequences[0].data();
    Real* im = work.Sequences[1].data();
    // The padding; and the lanes that have no row.
    const Index padded = ny - y < 2 * Lanes ? 0 : nx;
    std::fill(re + padded * Lanes, re + n * Lanes, Real(0));
    std::fill(im + padded * Lanes, im + n * Lanes, Real(0));
    for (Index row = y; row < std::min(y + 2 * Lanes, ny); ++row)
    {
      const float* from = this->Values + (z * ny + row) * nx;
      Real* to = ((row - y) % 2 ? im : re) + (row - y) / 2;
      for (Index x = 0; x < nx; ++x)
      {
        to[x * Lanes] = this->Load(field, from[x]);
      }
    }
    const int at = this->X.Transform(re, im, work.Sequences[2].data(), work.Sequences[3].data());
    re = work.Sequences[2 * at].data();
    im = work.Sequences[2 * at + 1].data();
    for (Index row = y; row < std::min(y + 2 * Lanes, ny); ++row)
    {
      // The even and the odd part of the complex sequence's transform belong to one row each.
      const Index lane = (row - y) / 2;
      const bool odd = (row - y) % 2;
      const Real* a = (odd ? im : re) + lane;
      const Real* b = (odd ? re : im) + lane;
      const Real sign = odd ? Real(-0.5) : Real(0.5);
      Real* to = work.Rows.data() + this->At(row, 0);
      for (Index k = 0; k <= n / 2; ++k)
      {
        const Index mirrored = (k ? n - k : 0) * Lanes;
        Real* pair = to + k / Lanes * 2 * Lanes + k % Lanes;
        pair[0] = Real(0.5) * (a[k * Lanes] + a[mirrored]);
        pair[Lanes] = sign * (b[k * Lanes] - b[mirrored]);
      }
    }
  }

  /**
   * Transforms a slice back along y, into work.Rows.
   */
  void BackwardColumns(const Real* slice, Workspace& work) const
  {
    for (Index block = 0; block < this->Blocks; ++block)
    {
      Real* re = work.Sequences[0].data();
      Real* im = work.Sequences[1].data();
      for (Index y = 0; y < this->Y.GetLength(); ++y)
      {
        Copy(slice + this->At(y, block), re + y * Lanes);
        Copy(slice + this->At(y, block) + Lanes, im + y * Lanes);
      }
      const int at = this->Y.Transform(im, re, work.Sequences[3].data(), work.Sequences[2].data());
      re = work.Sequences[2 * at].data();
      im = work.Sequences[2 * at + 1].data();
      for (Index y = this->Begin[1]; y < this->End[1]; ++y)
      {
        Copy(re + y * Lanes, work.Rows.data() + this->At(y, block));
        Copy(im + y * Lanes, work.Rows.data() + this->At(y, block) + Lanes);
      }
    }
  }

  /**
   * Transforms work.Rows back along x, rows y ... y + 2 Lanes - 1, two as one complex sequence.
   */
  void BackwardRows(Index y, Workspace& work, Real* results) const
  {
    const Index n = this->X.GetLength(), width = this->End[0] - this->Begin[0];
    Real* re = work.Sequences[0].data();
    Real* im = work.Sequences[1].data();
    const Index last = std::min(y + 2 * Lanes, this->End[1]);
    for (Index row = y; row < last; row += 2)
    {
      const Real* a = work.Rows.data() + this->At(row, 0);
      const Real* b = row + 1 < last ? work.Rows.data() + this->At(row + 1, 0) : nullptr;
      const Index lane = (row - y) / 2;
      for (Index k = 0; k <= n / 2; ++k)
      {
        const Index at = k / Lanes * 2 * Lanes + k % Lanes;
        const Index mirrored = (k ? n - k : 0) * Lanes + lane;
        const Real aRe = a[at], aIm = a[at + Lanes];
        const Real bRe = b ? b[at] : Real(0), bIm = b ? b[at + Lanes] : Real(0);
        re[mirrored] = aRe + bIm;
        im[mirrored] = bRe - aIm;
        re[k * Lanes + lane] = aRe - bIm;
        im[k * Lanes + lane] = aIm + bRe;
      }
    }
    const int at = this->X.Transform(im, re, work.Sequences[3].data(), work.Sequences[2].data());
    re = work.Sequences[2 * at].data();
    im = work.Sequences[2 * at + 1].data();
    for (Index row = y; row < last; ++row)
    {
      const Real* from = ((row - y) % 2 ? im : re) + this->Begin[0] * Lanes + (row - y) / 2;
      Real* to = results + (row - this->Begin[1]) * width;
      for (Index x = 0; x < width; ++x)
      {
        to[x] = from[x * Lanes];
      }
    }
  }

  const float* Values;
  float Offset;
  int Fields;
  const BallKernel& Kernel;
  FourierTransform<Real, Lanes> X, Y, Z;
  Index Size[3], Begin[3], End[3];
  Index Blocks; // of Lanes frequencies along x
};
}

#endif
