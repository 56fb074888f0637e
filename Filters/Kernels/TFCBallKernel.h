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

#include "TFCGradient.h"
#include "TFCVector.h"

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
    for (Index z = 0; z < nz; ++z)
    {
      for (Index y = 0; y < ny; ++y)
      {
        for (Index x = 0; x < nx; ++x)
        {
          const double dx = static_cast<double>(x) * spacing[0];
          const double dy = static_cast<double>(y) * spacing[1];
          const double dz = static_cast<double>(z) * spacing[2];
          const double q = std::sqrt(dx * dx + dy * dy + dz * dz) / radius;
          double w = q <= 1. + 1e-9 ? 1. : 0.;
          if (weight == DistanceWeight::Linear)
          {
            w *= std::max(0., 1. - q / (1. + smallest / radius));
          }
          else if (weight == DistanceWeight::Gaussian)
          {
            w *= std::exp(-2. * q * q);
          }
          const Index i = (z * ny + y) * nx + x;
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
   * Number of values of GetSpectrum() for transforms of the given lengths.
   */
  static Index GetSpectrumSize(const Index length[3])
  {
    return (length[0] / 2 + 1) * (length[1] / 2 + 1) * (length[2] / 2 + 1);
  }

  /**
   * Discrete Fourier transform of the weights around the origin, times `scale`, of which the
   * frequencies 0 ... length / 2 along each axis say everything: real, and even along each axis.
   * By matrix products with cosines; `run(count, body)` must call body(begin, end) on ranges that
   * cover [0, count), in parallel if it likes.
   */
  template <typename Real, typename Run>
  std::vector<Real> GetSpectrum(const Index length[3], double scale, Run&& run) const
  {
    const Index sx = this->Reach[0] + 1, sy = this->Reach[1] + 1, sz = this->Reach[2] + 1;
    const Index kx = length[0] / 2 + 1, ky = length[1] / 2 + 1, kz = length[2] / 2 + 1;
    std::vector<Real> a(static_cast<size_t>(kx * sy * sz)), b(static_cast<size_t>(kx * ky * sz));
    std::vector<Real> result(static_cast<size_t>(kx * ky * kz));
    const std::vector<Real> ex = Cosines<Real>(length[0], sx, scale);
    run(sy * sz,
      [&](Index begin, Index end)
      {
        for (Index row = begin; row < end; ++row)
        {
          for (Index x = 0; x < sx; ++x)
          {
            AddMultiple(kx, static_cast<Real>(this->Weights[row * sx + x]), ex.data() + x * kx,
              a.data() + row * kx);
          }
        }
      });
    const std::vector<Real> ey = Cosines<Real>(length[1], sy, 1.);
    run(sz * ky,
      [&](Index begin, Index end)
      {
        for (Index row = begin; row < end; ++row)
        {
          const Index z = row / ky, k = row % ky;
          for (Index y = 0; y < sy; ++y)
          {
            AddMultiple(kx, ey[y * ky + k], a.data() + (z * sy + y) * kx, b.data() + row * kx);
          }
        }
      });
    const std::vector<Real> ez = Cosines<Real>(length[2], sz, 1.);
    run(kz * ky,
      [&](Index begin, Index end)
      {
        for (Index row = begin; row < end; ++row)
        {
          const Index k = row / ky, y = row % ky;
          for (Index z = 0; z < sz; ++z)
          {
            AddMultiple(kx, ez[z * kz + k], b.data() + (z * ky + y) * kx, result.data() + row * kx);
          }
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
    for (Index i = stride; i < total; ++i)
    {
      if (i / stride % length)
      {
        this->Cumulated[i] += this->Cumulated[i - stride];
      }
    }
  }

  /// Row j: the contribution of the offsets j and -j to each frequency.
  template <typename Real>
  static std::vector<Real> Cosines(Index length, Index count, double scale)
  {
    const Index frequencies = length / 2 + 1;
    std::vector<Real> result(static_cast<size_t>(frequencies * count));
    for (Index j = 0; j < count; ++j)
    {
      for (Index k = 0; k < frequencies; ++k)
      {
        const double turns = static_cast<double>(j * k % length) / static_cast<double>(length);
        result[j * frequencies + k] =
          static_cast<Real>(scale * (j ? 2. : 1.) * std::cos(2. * 3.14159265358979323846 * turns));
      }
    }
    return result;
  }

  template <typename Real>
  static void AddMultiple(Index count, Real factor, const Real* __restrict from,
    Real* __restrict to)
  {
    TFC_INDEPENDENT
    for (Index i = 0; i < count; ++i)
    {
      to[i] += factor * from[i];
    }
  }

  Index Size[3], Reach[3];
  std::vector<double> Weights;   // of the octant of offsets >= 0
  std::vector<double> Cumulated; // sums from the centre to an offset, each axis counting 0 half
};
}

#endif
