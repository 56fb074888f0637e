// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Separable box sums of a scalar lattice with running sums: cost independent of the radius.
 *
 * For every sample of an output block, the sum (and the number) of the valid samples of the cube
 * |o_x| <= R_x, |o_y| <= R_y, |o_z| <= R_z that lie inside the lattice. Sum / number is the
 * in-volume mean: the part of the box outside the volume plays no part. This is b * b * b * I of
 * Eq. 9 of the paper, with b of width 2R + 1 along each axis.
 *
 * NaN marks an invalid sample. The masked variant excludes them by summing the validity as
 * well; the plain one assumes that there are none, and the count is a product of three lengths.
 *
 * Pass 1 handles one z-slice: running sums along x (eight rows interleaved, because a running sum
 * is a chain of dependent additions), then along y (vectorised over x). Pass 2 runs along z over a
 * tile of rows. Accumulators are double, so that adding and subtracting leaves no drift; the
 * sums stored in between are float (relative error 1e-7). Cost per sample: 3 additions and 3
 * subtractions; temporary memory 4 bytes per sample of the output block's columns, 8 when masked.
 * Slices and tiles are independent, and their results do not depend on who computes them.
 */

#ifndef TFCBoxMean_h
#define TFCBoxMean_h

#include "TFCGradient.h"

#include <algorithm>
#include <vector>

namespace tfc
{
/**
 * What a box sum adds up.
 */
enum class BoxTerm
{
  Value,      ///< the samples, none of which is NaN
  ValidValue, ///< the samples, NaN counting as 0
  Validity    ///< 1 per valid sample, 0 per NaN
};

template <BoxTerm Term>
inline float BoxTermOf(float value)
{
  if constexpr (Term == BoxTerm::Value)
  {
    return value;
  }
  else if constexpr (Term == BoxTerm::ValidValue)
  {
    return IsValid(value) ? value : 0.f;
  }
  else
  {
    return IsValid(value) ? 1.f : 0.f;
  }
}

class BoxSum
{
public:
  /**
   * Sums over boxes of `radius` >= 0 samples to either side in a lattice of `size` samples, wanted
   * for the block [begin, end) of it.
   */
  BoxSum(const Index size[3], const Index begin[3], const Index end[3], const Index radius[3])
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Size[a] = size[a];
      this->Begin[a] = begin[a];
      this->End[a] = end[a];
      // A larger radius changes nothing, and cannot overflow an index.
      this->Radius[a] = std::min(radius[a], size[a]);
    }
    this->Width = end[0] - begin[0];
    this->Height = end[1] - begin[1];
  }

  /**
   * Number of floats that one temporary array of SumSlice() needs.
   */
  Index GetTemporarySize() const { return this->Width * this->Height * this->Size[2]; }

  /**
   * Number of samples of the box around `i` that lie in the lattice, along `axis`.
   */
  Index CountAlong(int axis, Index i) const
  {
    return std::min(i + this->Radius[axis], this->Size[axis] - 1) -
      std::max<Index>(i - this->Radius[axis], 0) + 1;
  }

  /**
   * Buffers of one thread.
   */
  struct Workspace
  {
    std::vector<float> Rows;
    std::vector<double> Sums;
    std::vector<double> Counts;
  };

  /**
   * Pass 1: sums over x and y of slice `z` of `volume` into slice `z` of `temporary`.
   */
  template <BoxTerm Term>
  void SumSlice(const float* volume, Index z, float* temporary, Workspace& work) const
  {
    const Index nx = this->Size[0], ny = this->Size[1];
    // Only these rows are within reach of the output block.
    const Index first = std::max<Index>(this->Begin[1] - this->Radius[1], 0);
    const Index last = std::min(this->End[1] - 1 + this->Radius[1], ny - 1);
    work.Rows.resize(static_cast<size_t>(this->Width * ny));
    for (Index y = first; y <= last; y += 8)
    {
      const int rows = static_cast<int>(std::min<Index>(8, last + 1 - y));
      const float* in = volume + (z * ny + y) * nx;
      float* out = work.Rows.data() + y * this->Width;
      if (rows == 8)
      {
        this->SumRows<Term, 8>(in, out);
      }
      else
      {
        for (int r = 0; r < rows; ++r)
        {
          this->SumRows<Term, 1>(in + r * nx, out + r * this->Width);
        }
      }
    }

    const auto row = [&](Index y) { return work.Rows.data() + y * this->Width; };
    float* out = temporary + z * this->Width * this->Height;
    this->RunAlong(1, this->Width, work.Sums, row,
      [&](Index, const double* sums)
      {
        for (Index x = 0; x < this->Width; ++x)
        {
          out[x] = static_cast<float>(sums[x]);
        }
        out += this->Width;
      });
  }

  /**
   * Pass 2 for the rows [y0, y1), counted from 0 within the output block: calls
   * store(y, z, sums, counts) for every row with y and z counted in the lattice and pointers to the
   * Width values of that row. `counts` is null when `validity` is.
   */
  template <typename Store>
  void SumColumns(const float* temporary, const float* validity, Index y0, Index y1,
    Workspace& work, Store&& store) const
  {
    const Index length = (y1 - y0) * this->Width;
    const Index stride = this->Width * this->Height;
    const auto tile = [&](const float* from)
    { return [=](Index z) { return from + z * stride + y0 * this->Width; }; };
    const auto rows = [&](Index z, const double* sums, const double* counts)
    {
      for (Index y = y0; y < y1; ++y)
      {
        const Index offset = (y - y0) * this->Width;
        store(y + this->Begin[1], z, sums + offset, counts ? counts + offset : nullptr);
      }
    };
    if (validity)
    {
      // Both sums advance together; the running counts are one step of the running sums behind.
      Runner<decltype(tile(validity))> count(*this, 2, length, work.Counts, tile(validity));
      this->RunAlong(2, length, work.Sums, tile(temporary),
        [&](Index z, const double* sums)
        {
          rows(z, sums, work.Counts.data());
          count.Advance(z);
        });
    }
    else
    {
      this->RunAlong(2, length, work.Sums, tile(temporary),
        [&](Index z, const double* sums) { rows(z, sums, nullptr); });
    }
  }

private:
  /**
   * Running sums of whole rows along one axis; `Row(i)` is the i-th row.
   */
  template <typename Row>
  struct Runner
  {
    Runner(const BoxSum& box, int axis, Index length, std::vector<double>& sums, Row row)
      : Size(box.Size[axis])
      , Radius(box.Radius[axis])
      , Length(length)
      , Sums(sums)
      , GetRow(row)
    {
      const Index begin = box.Begin[axis];
      this->Sums.assign(static_cast<size_t>(length), 0.);
      for (Index i = std::max<Index>(begin - this->Radius, 0);
           i <= std::min(begin + this->Radius, this->Size - 1); ++i)
      {
        const float* values = this->GetRow(i);
        for (Index x = 0; x < length; ++x)
        {
          this->Sums[x] += values[x];
        }
      }
    }

    void Advance(Index i)
    {
      const Index enters = i + this->Radius + 1, leaves = i - this->Radius;
      double* sums = this->Sums.data();
      const float* in = enters < this->Size ? this->GetRow(enters) : nullptr;
      const float* out = leaves >= 0 ? this->GetRow(leaves) : nullptr;
      if (in && out)
      {
        for (Index x = 0; x < this->Length; ++x)
        {
          sums[x] += static_cast<double>(in[x]) - static_cast<double>(out[x]);
        }
      }
      else if (in)
      {
        for (Index x = 0; x < this->Length; ++x)
        {
          sums[x] += in[x];
        }
      }
      else if (out)
      {
        for (Index x = 0; x < this->Length; ++x)
        {
          sums[x] -= out[x];
        }
      }
    }

    Index Size, Radius, Length;
    std::vector<double>& Sums;
    Row GetRow;
  };

  template <typename Row, typename Use>
  void RunAlong(int axis, Index length, std::vector<double>& sums, Row row, Use&& use) const
  {
    Runner<Row> runner(*this, axis, length, sums, row);
    for (Index i = this->Begin[axis]; i < this->End[axis]; ++i)
    {
      use(i, sums.data());
      if (i + 1 < this->End[axis])
      {
        runner.Advance(i);
      }
    }
  }

  /**
   * Running sums along x of `Rows` adjacent rows.
   */
  template <BoxTerm Term, int Rows>
  void SumRows(const float* in, float* out) const
  {
    const Index n = this->Size[0], radius = this->Radius[0], begin = this->Begin[0];
    double sums[Rows] = {};
    for (Index x = std::max<Index>(begin - radius, 0); x <= std::min(begin + radius, n - 1); ++x)
    {
      for (int r = 0; r < Rows; ++r)
      {
        sums[r] += BoxTermOf<Term>(in[r * n + x]);
      }
    }
    const auto run = [&](Index from, Index to, auto adds, auto subtracts)
    {
      for (Index x = from; x < to; ++x)
      {
        for (int r = 0; r < Rows; ++r)
        {
          out[r * this->Width + x - begin] = static_cast<float>(sums[r]);
          double change = 0.;
          if constexpr (adds)
          {
            change += BoxTermOf<Term>(in[r * n + x + radius + 1]);
          }
          if constexpr (subtracts)
          {
            change -= BoxTermOf<Term>(in[r * n + x - radius]);
          }
          sums[r] += change;
        }
      }
    };
    // Three stretches: the box enters the lattice, lies inside (or covers all of it), leaves it.
    const Index end = this->End[0];
    const auto clamp = [&](Index x) { return std::min(std::max(x, begin), end); };
    const Index lastAdd = clamp(n - radius - 1), firstSubtract = clamp(radius);
    const std::true_type yes{};
    const std::false_type no{};
    if (firstSubtract <= lastAdd)
    {
      run(begin, firstSubtract, yes, no);
      run(firstSubtract, lastAdd, yes, yes);
      run(lastAdd, end, no, yes);
    }
    else
    {
      run(begin, lastAdd, yes, no);
      run(lastAdd, firstSubtract, no, no);
      run(firstSubtract, end, no, yes);
    }
  }

  Index Size[3], Begin[3], End[3], Radius[3];
  Index Width, Height;
};
}

#endif
