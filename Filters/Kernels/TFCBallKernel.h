// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Weights of a ball of lattice points, their sum inside a lattice, and their spectrum.
 *
 * The ball holds the offsets o with |(o_x h_x, o_y h_y, o_z h_z)| <= R, h the distance of the
 * samples. Weight as a function of q = |.| / R:
 *   constant  1
 *   linear    1 - q / (1 + e), with e = one h_min / R, so that the outermost sample counts
 *   gaussian  exp(-2 q^2), a standard deviation of R / 2
 *
 * Weights are even along each axis, so that an octant says everything. Offsets that no pair of
 * samples of the lattice has are left out: a radius beyond the lattice changes nothing.
 *
 * Memory: 12 to 16 bytes per offset of the octant, and that of the spectrum's octant.
 */

#ifndef TFCBallKernel_h
#define TFCBallKernel_h

#include "TFCAlignedVector.h"
#include "TFCCosineTransform.h"
#include "TFCGradient.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tfc
{
enum class DistanceWeight
{
  Constant,
  Linear,
  Gaussian
};

class BallKernel
{
public:
  /**
   * Ball of radius `radius` > 0 for a lattice of `size` samples at distances `spacing` > 0.
   */
  BallKernel(const Index size[3], const double spacing[3], double radius, DistanceWeight weight)
  {
    double smallest = spacing[0];
    for (int a = 0; a < 3; ++a)
    {
      smallest = std::min(smallest, spacing[a]);
      // The tolerance lets a radius of 3 spacings reach the third neighbour whatever 3 h rounds to.
      const double reach = std::floor(radius / spacing[a] * (1. + 1e-9));
      this->Reach[a] = static_cast<Index>(std::min(reach, static_cast<double>(size[a] - 1)));
      this->Size[a] = size[a];
    }
    const Index nx = this->Reach[0] + 1, ny = this->Reach[1] + 1, nz = this->Reach[2] + 1;
    this->Weights.resize(static_cast<size_t>(nx * ny * nz));
    this->Cumulated.resize(this->Weights.size());
    const double largest = (1. + 1e-9) * (1. + 1e-9) * radius * radius;
    for (Index z = 0, i = 0; z < nz; ++z)
    {
      for (Index y = 0; y < ny; ++y)
      {
        const double dy = static_cast<double>(y) * spacing[1];
        const double dz = static_cast<double>(z) * spacing[2];
        for (Index x = 0; x < nx; ++x, ++i)
        {
          const double dx = static_cast<double>(x) * spacing[0];
          const double square = dx * dx + dy * dy + dz * dz;
          double w = square <= largest ? 1. : 0.;
          if (weight == DistanceWeight::Linear)
          {
            w *= std::max(0., 1. - std::sqrt(square) / (radius + smallest));
          }
          else if (weight == DistanceWeight::Gaussian)
          {
            w *= std::exp(-2. * square / (radius * radius));
          }
          this->Weights[i] = w;
          // The planes through the centre are shared by two octants.
          this->Cumulated[i] = w * (x ? 1. : .5) * (y ? 1. : .5) * (z ? 1. : .5);
        }
      }
    }
    this->Cumulate(1, nx, nx * ny * nz);
    this->Cumulate(nx, ny, nx * ny * nz);
    this->Cumulate(nx * ny, nz, nx * ny * nz);
  }

  /**
   * Largest offset along an axis.
   */
  Index GetReach(int axis) const { return this->Reach[axis]; }

  /**
   * For each sample [x0, x1) of row (y, z) of the lattice: the sum of the weights of the part of
   * the ball around it that lies in the lattice. `profile` is scratch.
   */
  void SumRow(Index y, Index z, Index x0, Index x1, std::vector<double>& profile,
    double* sums) const
  {
    const Index nx = this->Reach[0] + 1;
    profile.assign(static_cast<size_t>(nx), 0.);
    for (const Index dz : { this->Low(2, z), this->High(2, z) })
    {
      for (const Index dy : { this->Low(1, y), this->High(1, y) })
      {
        const double* row = this->Cumulated.data() + (dz * (this->Reach[1] + 1) + dy) * nx;
        for (Index x = 0; x < nx; ++x)
        {
          profile[x] += row[x];
        }
      }
    }
    for (Index x = x0; x < x1; ++x)
    {
      sums[x - x0] = profile[this->Low(0, x)] + profile[this->High(0, x)];
    }
  }

  /**
   * Distance between rows of frequencies along x in GetSpectrum(): zeros fill the last register.
   */
  template <typename Real>
  static Index GetSpectrumPitch(Index length)
  {
    return CosineTransform<Real>::GetPitch(length);
  }

  /**
   * Discrete Fourier transform of the weights around the origin, times `scale`, of which the
   * frequencies 0 ... length / 2 along each axis say everything: real, and even along each axis.
   * By products with cosines; `run(count, body)` must call body(begin, end) on ranges that cover
   * [0, count), in parallel if it likes.
   */
  template <typename Real, typename Run>
  AlignedVector<Real> GetSpectrum(const Index length[3], double scale, Run&& run) const
  {
    const Index sx = this->Reach[0] + 1, sy = this->Reach[1] + 1, sz = this->Reach[2] + 1;
    const Index kx = GetSpectrumPitch<Real>(length[0]);
    const Index ky = length[1] / 2 + 1, kz = length[2] / 2 + 1;
    const CosineTransform<Real> ex(length[0], sx, scale), ey(length[1], sy), ez(length[2], sz);
    const std::vector<Real> weights(this->Weights.begin(), this->Weights.end());
    AlignedVector<Real> a(static_cast<size_t>(kx * sy * sz)), b(static_cast<size_t>(kx * ky * sz));
    AlignedVector<Real> result(static_cast<size_t>(kx * ky * kz));
    run(sy * sz,
      [&](Index begin, Index end)
      {
        for (Index row = begin; row < end; ++row)
        {
          ex.TransformSequence(weights.data() + row * sx, a.data() + row * kx);
        }
      });
    run(sz * ey.GetNumberOfPairs(),
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          const Index z = i / ey.GetNumberOfPairs(), pair = i % ey.GetNumberOfPairs();
          ey.TransformRows(pair, a.data() + z * sy * kx, kx, kx, b.data() + z * ky * kx, kx);
        }
      });
    // All of a y first: its rows of b then stay in the nearest cache.
    run(ky * ez.GetNumberOfPairs(),
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          const Index y = i / ez.GetNumberOfPairs(), pair = i % ez.GetNumberOfPairs();
          ez.TransformRows(pair, b.data() + y * kx, ky * kx, kx, result.data() + y * kx, ky * kx);
        }
      });
    return result;
  }

private:
  Index Low(int axis, Index i) const { return std::min(i, this->Reach[axis]); }
  Index High(int axis, Index i) const
  {
    return std::min(this->Size[axis] - 1 - i, this->Reach[axis]);
  }

  /// Running sums along the axis with the given stride and length.
  void Cumulate(Index stride, Index length, Index total)
  {
    for (Index line = 0; line < total; line += stride * length)
    {
      for (Index i = line + stride; i < line + stride * length; ++i)
      {
        this->Cumulated[i] += this->Cumulated[i - stride];
      }
    }
  }

  Index Size[3], Reach[3];
  std::vector<double> Weights;   // of the octant of offsets >= 0
  std::vector<double> Cumulated; // sums from the centre to an offset, each axis counting 0 half
};
}

#endif
