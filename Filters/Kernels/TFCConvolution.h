// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Convolution of a real lattice with a kernel that is even along each axis, by Fourier
 * transforms: sum_o w(o) f(x + o), with f = 0 outside of the lattice.
 *
 * Three passes, each over independent units, for the caller to spread over threads:
 *   1. Forward(z), z = 0, 2, 4 ...: transform along y of two slices, as real and imaginary part of
 *      one complex sequence, `Lanes` columns of x at a time;
 *   2. Filter(k): for a frequency along y, the transforms along z and x, the product with the
 *      kernel's spectrum, and back. Its plane stays in the second-level cache; only here are
 *      columns and rows transposed (TFCTranspose.h);
 *   3. Backward(z): back along y, two slices.
 * Of the padding, the spectrum holds only that of y. Transforms that would see only padding, or
 * whose result nobody wants, are left out.
 *
 * Layout of the spectrum: [z][frequency of y][block of x][real, imaginary][lane].
 *
 * Cost per sample: about 15 log2(n) operations, n the padded length, size + reach. Memory:
 * GetSize() values, about 1 + reach / size per sample, and in each thread a plane of frequencies.
 */

#ifndef TFCConvolution_h
#define TFCConvolution_h

#include "TFCAlignedVector.h"
#include "TFCFourier.h"
#include "TFCGradient.h" // For Index
#include "TFCTranspose.h"
#include "TFCVector.h"

#include <algorithm>
#include <array>

namespace tfc
{
template <typename Real>
class EvenConvolution
{
public:
  /// One full wide register of the widest kind.
  static constexpr int Lanes = 64 / sizeof(Real);

  /**
   * For a lattice of `size` samples of which the block [begin, end) is wanted, and a kernel that is
   * 0 beyond the offsets `reach`.
   */
  EvenConvolution(const Index size[3], const Index begin[3], const Index end[3],
    const Index reach[3])
    : X(GetFourierLength(size[0] + reach[0]))
    , Y(GetFourierLength(size[1] + reach[1]))
    , Z(GetFourierLength(size[2] + reach[2]))
  {
    std::copy_n(size, 3, this->Size);
    std::copy_n(begin, 3, this->Begin);
    std::copy_n(end, 3, this->End);
    this->Blocks = (size[0] + Lanes - 1) / Lanes;
    this->FirstBlock = begin[0] / Lanes;
    this->LastBlock = (end[0] + Lanes - 1) / Lanes;
  }

  ///@{
  /**
   * Lengths of the transforms, and the factor that the kernel's spectrum must contain.
   */
  std::array<Index, 3> GetLengths() const
  {
    return { this->X.GetLength(), this->Y.GetLength(), this->Z.GetLength() };
  }
  double GetScale() const
  {
    // Forward() leaves out a division by 2.
    return 0.5 /
      (static_cast<double>(this->X.GetLength()) * this->Y.GetLength() * this->Z.GetLength());
  }
  ///@}

  /**
   * Number of Real values of the spectrum.
   */
  Index GetSize() const { return this->At(this->Size[2], 0, 0); }

  /**
   * Number of frequencies along y: units of Filter().
   */
  Index GetNumberOfFrequencies() const { return this->Y.GetLength() / 2 + 1; }

  /**
   * Distance of the rows of Backward()'s result.
   */
  Index GetPitch() const { return this->Blocks * Lanes; }

  /**
   * Buffers of one thread, for one convolution.
   */
  struct Workspace
  {
    AlignedVector<Real> Re, Im; // sequences to transform
    AlignedVector<Real> Plane;  // of a frequency along y
    AlignedVector<Real> Zeros;
  };

  /**
   * Pass 1 for the slices z and z + 1 of `values`; convert(value) is the number to transform.
   */
  template <typename Convert>
  void Forward(Index z, const float* values, const Convert& convert, Real* spectrum,
    Workspace& work) const
  {
    this->Prepare(work);
    const Index nx = this->Size[0], ny = this->Size[1], n = this->Y.GetLength();
    const Index* positions = this->Y.GetPositions();
    const bool second = z + 1 < this->Size[2];
    const float* slices[2] = { values + z * ny * nx, values + (second ? z + 1 : z) * ny * nx };
    for (Index block = 0; block < this->Blocks; ++block)
    {
      Real* re = work.Re.data();
      Real* im = work.Im.data();
      const Index x = block * Lanes, count = std::min<Index>(Lanes, nx - x);
      for (Index y = 0; y < ny; ++y)
      {
        Load(slices[0] + y * nx + x, count, convert, re + y * Lanes);
        Load(slices[1] + y * nx + x, second ? count : 0, convert, im + y * Lanes);
      }
      std::fill(re + ny * Lanes, re + n * Lanes, Real(0));
      std::fill(im + ny * Lanes, im + n * Lanes, Real(0));
      this->Y.Transform(re, im);
      // The even and the odd part of the complex sequence's transform belong to one slice each.
      for (Index k = 0; k <= n / 2; ++k)
      {
        const Index a = positions[k] * Lanes, b = positions[k ? n - k : 0] * Lanes;
        AddParts(re + a, re + b, im + a, im + b, spectrum + this->At(z, k, block));
        if (second)
        {
          AddParts(im + a, im + b, re + b, re + a, spectrum + this->At(z + 1, k, block));
        }
      }
    }
  }

  /**
   * Pass 2 for the frequency k along y. `response` is the kernel's spectrum there times GetScale():
   * [Lanes frequencies along z][frequency along x][lane], frequencies 0 ... length / 2.
   */
  void Filter(Index k, const Real* response, Real* spectrum, Workspace& work) const
  {
    this->Prepare(work);
    const Index n = this->Z.GetLength(), stride = this->At(1, 0, 0);
    const Index* positions = this->Z.GetPositions();
    for (Index block = 0; block < this->Blocks; ++block)
    {
      Real* re = work.Re.data();
      Real* im = work.Im.data();
      const Real* column = spectrum + this->At(0, k, block);
      for (Index z = 0; z < this->Size[2]; ++z)
      {
        CopyLanes<Lanes>(column + z * stride, re + z * Lanes);
        CopyLanes<Lanes>(column + z * stride + Lanes, im + z * Lanes);
      }
      std::fill(re + this->Size[2] * Lanes, re + n * Lanes, Real(0));
      std::fill(im + this->Size[2] * Lanes, im + n * Lanes, Real(0));
      this->Z.Transform(re, im);
      for (Index kz = 0; kz < n; ++kz)
      {
        const Index from = positions[kz] * Lanes;
        CopyLanes<Lanes>(re + from, work.Plane.data() + this->PlaneAt(kz, block));
        CopyLanes<Lanes>(im + from, work.Plane.data() + this->PlaneAt(kz, block) + Lanes);
      }
    }
    // The frequencies kz and n - kz have the same response.
    for (Index kz = 0; kz <= n / 2; kz += Lanes)
    {
      for (const bool mirrored : { false, true })
      {
        this->FilterRows(kz, mirrored, response + kz * (this->X.GetLength() / 2 + 1), work);
      }
    }
    for (Index block = this->FirstBlock; block < this->LastBlock; ++block)
    {
      Real* re = work.Re.data();
      Real* im = work.Im.data();
      for (Index kz = 0; kz < n; ++kz)
      {
        const Index to = positions[kz] * Lanes;
        CopyLanes<Lanes>(work.Plane.data() + this->PlaneAt(kz, block), re + to);
        CopyLanes<Lanes>(work.Plane.data() + this->PlaneAt(kz, block) + Lanes, im + to);
      }
      this->Z.Invert(re, im);
      for (Index z = this->Begin[2]; z < this->End[2]; ++z)
      {
        CopyLanes<Lanes>(re + z * Lanes, spectrum + this->At(z, k, block));
        CopyLanes<Lanes>(im + z * Lanes, spectrum + this->At(z, k, block) + Lanes);
      }
    }
  }

  /**
   * Pass 3 for the slices z and z + 1, of those that are wanted: result for the rows
   * Begin <= y < End of the one and then of the other, x = 0 ... at distances of GetPitch(). What
   * is there for an x outside of the block means nothing.
   */
  void Backward(Index z, const Real* spectrum, Real* sums, Workspace& work) const
  {
    this->Prepare(work);
    const Index n = this->Y.GetLength(), pitch = this->GetPitch();
    const Index* positions = this->Y.GetPositions();
    const bool second = z + 1 < this->End[2];
    for (Index block = this->FirstBlock; block < this->LastBlock; ++block)
    {
      Real* re = work.Re.data();
      Real* im = work.Im.data();
      for (Index k = 0; k <= n / 2; ++k)
      {
        const Real* a = spectrum + this->At(z, k, block);
        const Real* b = second ? spectrum + this->At(z + 1, k, block) : work.Zeros.data();
        const Index at = positions[k] * Lanes, mirrored = positions[k ? n - k : 0] * Lanes;
        Merge(a, b, re + at, im + at, re + mirrored, im + mirrored);
      }
      this->Y.Invert(re, im);
      Real* to = sums + block * Lanes;
      for (Index y = this->Begin[1]; y < this->End[1]; ++y, to += pitch)
      {
        CopyLanes<Lanes>(re + y * Lanes, to);
        if (second)
        {
          CopyLanes<Lanes>(im + y * Lanes, to + (this->End[1] - this->Begin[1]) * pitch);
        }
      }
    }
  }

private:
  /// Places of a block in the spectrum, and in the plane of a frequency along y. There, an odd
  /// number of blocks keeps a column's numbers from sharing few places of the cache.
  Index At(Index z, Index k, Index block) const
  {
    return ((z * this->GetNumberOfFrequencies() + k) * this->Blocks + block) * 2 * Lanes;
  }
  Index PlaneAt(Index z, Index block) const { return (z * (this->Blocks | 1) + block) * 2 * Lanes; }

  void Prepare(Workspace& work) const
  {
    if (work.Plane.empty())
    {
      const Index size = std::max(
        { this->X.GetSize(), this->Y.GetSize(), this->Z.GetSize(), this->Blocks * Lanes * Lanes });
      work.Re.assign(static_cast<size_t>(size), Real(0));
      work.Im.assign(static_cast<size_t>(size), Real(0));
      work.Plane.resize(static_cast<size_t>(this->PlaneAt(this->Z.GetLength(), 0)));
      work.Zeros.assign(static_cast<size_t>(this->PlaneAt(1, 0)), Real(0));
    }
  }

  template <typename Convert>
  static void Load(const float* __restrict from, Index count, const Convert& convert,
    Real* __restrict to)
  {
    if (count == Lanes)
    {
      TFC_INDEPENDENT
      for (int l = 0; l < Lanes; ++l)
      {
        to[l] = convert(from[l]);
      }
      return;
    }
    for (Index l = 0; l < Lanes; ++l)
    {
      to[l] = l < count ? convert(from[l]) : Real(0);
    }
  }

  /// Real part a + b, imaginary part c - d.
  static void AddParts(const Real* __restrict a, const Real* __restrict b, const Real* __restrict c,
    const Real* __restrict d, Real* __restrict to)
  {
    TFC_INDEPENDENT
    for (int l = 0; l < Lanes; ++l)
    {
      to[l] = a[l] + b[l];
      to[Lanes + l] = c[l] - d[l];
    }
  }

  /// a + i b, of Hermitian sequences, at a frequency and at the mirrored one. These may be the
  /// same: then both numbers are real.
  static void Merge(const Real* __restrict a, const Real* __restrict b, Real* re, Real* im,
    Real* mirroredRe, Real* mirroredIm)
  {
    TFC_INDEPENDENT
    for (int l = 0; l < Lanes; ++l)
    {
      mirroredRe[l] = a[l] + b[Lanes + l];
      mirroredIm[l] = b[l] - a[Lanes + l];
      re[l] = a[l] - b[Lanes + l];
      im[l] = a[Lanes + l] + b[l];
    }
  }

  /**
   * Convolution along x of `Lanes` rows of the plane: of the frequencies kz + lane, kz <= length /
   * 2, or of those mirrored, which are not among them.
   */
  void FilterRows(Index kz, bool mirrored, const Real* response, Workspace& work) const
  {
    const Index nz = this->Z.GetLength(), n = this->X.GetLength();
    Real* rows[Lanes];
    for (Index l = 0; l < Lanes; ++l)
    {
      const Index k = kz + l;
      const bool there = k <= nz / 2 && !(mirrored && (k == 0 || 2 * k == nz));
      rows[l] = there ? work.Plane.data() + this->PlaneAt(mirrored ? nz - k : k, 0) : nullptr;
    }
    Real* zeros = work.Zeros.data();
    TileTransposition<Real, Lanes> tile;
    Real* re = work.Re.data();
    Real* im = work.Im.data();
    for (Index block = 0; block < this->Blocks; ++block)
    {
      const Index from = block * 2 * Lanes, to = block * Lanes * Lanes;
      tile.Gather([&](int l) { return rows[l] ? rows[l] + from : zeros; }, re + to);
      tile.Gather([&](int l) { return rows[l] ? rows[l] + from + Lanes : zeros; }, im + to);
    }
    const Index padding = std::min(this->Blocks * Lanes, n) * Lanes;
    std::fill(re + padding, re + n * Lanes, Real(0));
    std::fill(im + padding, im + n * Lanes, Real(0));
    this->X.Transform(re, im);
    const Index* positions = this->X.GetPositions();
    for (Index k = 0; k < n; ++k)
    {
      const Index at = positions[k] * Lanes;
      Multiply(response + std::min(k, n - k) * Lanes, re + at, im + at);
    }
    this->X.Invert(re, im);
    for (Index block = this->FirstBlock; block < this->LastBlock; ++block)
    {
      const Index to = block * 2 * Lanes, from = block * Lanes * Lanes;
      Real unwanted[Lanes];
      tile.Scatter(re + from, [&](int l) { return rows[l] ? rows[l] + to : unwanted; });
      tile.Scatter(im + from, [&](int l) { return rows[l] ? rows[l] + to + Lanes : unwanted; });
    }
  }

  static void Multiply(const Real* __restrict factors, Real* __restrict re, Real* __restrict im)
  {
    TFC_INDEPENDENT
    for (int l = 0; l < Lanes; ++l)
    {
      re[l] *= factors[l];
      im[l] *= factors[l];
    }
  }

  FourierTransform<Real, Lanes> X, Y, Z;
  Index Size[3], Begin[3], End[3];
  Index Blocks;                // of Lanes columns
  Index FirstBlock, LastBlock; // that are wanted
};
}

#endif
