// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Blobs: maxima of the response in space and scale (Lindeberg 1998).
 *
 * A sample is a maximum when it exceeds its neighbours in 3x3x3 samples and three scales, as far as
 * they lie inside the volume. Of equal neighbours the first wins, by scale, then z, y, x, so that
 * an object centred between samples is found, and once. A parabola through the three
 * values along each axis, and one in log sigma, give its position between samples and its sigma.
 *
 * Nonlinear diffusion leaves edges sharp, and an uneven edge has extrema of its own, narrow ones at
 * any scale. A blob is as wide as its scale: half a sigma away along each axis the response must
 * still be a part, SmallestPlateau, of the maximum. For a ball it is about 0.9.
 *
 * Where the resolution is halved, a scale is compared with the one above on the coarser lattice,
 * and had been compared with the one below on the finer: a blob between the two could fail in both.
 * The second comparison is therefore made with a tolerance, HalvingTolerance, and
 * RemoveDuplicates() takes away what was found twice.
 *
 * Responses are Laplacians: bright blobs are negative ones. Invalid samples have the response 0,
 * and a threshold above 0 keeps them from being maxima.
 *
 * Cost: one pass over three lattices; the full test only where a sample exceeds its eight
 * neighbours along the axes of space and scale.
 */

#ifndef TFCBlobs_h
#define TFCBlobs_h

#include "TFCDiffusion.h"
#include "TFCPyramid.h"

#include <cstdlib>
#include <vector>

namespace tfc
{
constexpr float SmallestPlateau = 0.3f;
constexpr float HalvingTolerance = 0.05f;

/**
 * A blob. Position and Voxel count samples of the whole volume.
 */
struct Blob
{
  double Position[3] = { 0., 0., 0. };
  Index Voxel[3] = { 0, 0, 0 }; ///< the sample where the maximum is
  int Scale = 0;                ///< index of the scale where it is
  double Sigma = 0.;
  double Response = 0.; ///< positive for a bright blob
};

/**
 * Where in (-0.5, 0.5) the parabola through (-1, low), (0, center), (1, high) has its maximum; 0
 * where it has none.
 */
inline double FitParabola(double low, double center, double high)
{
  const double curvature = 2. * center - low - high;
  if (!(curvature > 0.))
  {
    return 0.;
  }
  return std::min(0.5, std::max(-0.5, 0.5 * (high - low) / curvature));
}

/**
 * The same for values at x[0] < x[1] < x[2]: the position, clamped to the midpoints.
 */
inline double FitParabola(const double x[3], const double y[3])
{
  const double below = x[1] - x[0], above = x[2] - x[1];
  if (!(below > 0. && above > 0.))
  {
    return x[1];
  }
  const double slopeBelow = (y[1] - y[0]) / below, slopeAbove = (y[2] - y[1]) / above;
  const double curvature = (slopeBelow - slopeAbove) / (below + above);
  if (!(curvature > 0.))
  {
    return x[1];
  }
  const double position = 0.5 * (x[0] + x[1] + slopeBelow / curvature);
  return std::min(x[1] + 0.5 * above, std::max(x[1] - 0.5 * below, position));
}

/**
 * The parabola through three values, at t.
 */
inline double EvaluateParabola(const double x[3], const double y[3], double t)
{
  if (!(x[0] < x[1] && x[1] < x[2]))
  {
    return y[1];
  }
  return y[0] * (t - x[1]) * (t - x[2]) / ((x[0] - x[1]) * (x[0] - x[2])) +
    y[1] * (t - x[0]) * (t - x[2]) / ((x[1] - x[0]) * (x[1] - x[2])) +
    y[2] * (t - x[0]) * (t - x[1]) / ((x[2] - x[0]) * (x[2] - x[1]));
}

/**
 * Finds the maxima of one polarity in the middle of three lattices of responses.
 */
struct BlobDetector
{
  const float* Responses[3] = { nullptr, nullptr, nullptr }; ///< of consecutive scales
  double LogSigmas[3] = { 0., 0., 0. };
  CoarseLattice Lattice;        ///< of all three
  Index Width[3] = { 1, 1, 1 }; ///< half a sigma in samples of the lattice, at least 1
  int Scale = 0;
  float Sign = -1.f;     ///< -1 finds bright blobs, 1 dark ones
  float Threshold = 0.f; ///< magnitude of the response, above 0
  bool IsHalved = false; ///< whether Lattice is coarser than the middle scale's own

  /// Append the blobs of slice z, in the order of their samples.
  void FindInSlice(Index z, std::vector<Blob>& found) const
  {
    constexpr Index block = 256;
    unsigned char candidates[block];
    const Index* n = this->Lattice.Size;
    for (Index y = 0; y < n[1]; ++y)
    {
      const NeighborRows rows(this->Responses[1], n, y, z);
      const Index start = (z * n[1] + y) * n[0];
      for (Index x0 = 0; x0 < n[0]; x0 += block)
      {
        const Index count = std::min(block, n[0] - x0);
        if (this->MarkCandidates(rows, start, x0, count, candidates))
        {
          for (Index i = 0; i < count; ++i)
          {
            if (candidates[i] && this->IsMaximum(x0 + i, y, z) && this->IsWide(x0 + i, y, z))
            {
              found.push_back(this->Fit(x0 + i, y, z));
            }
          }
        }
      }
    }
  }

private:
  /// The test that can be vectorised; whether any sample passed.
  bool MarkCandidates(const NeighborRows& rows, Index start, Index x0, Index count,
    unsigned char* __restrict candidates) const
  {
    const float sign = this->Sign, threshold = this->Threshold;
    const float* __restrict c = rows.Center + x0;
    const float* __restrict yl = rows.YLow + x0;
    const float* __restrict yh = rows.YHigh + x0;
    const float* __restrict zl = rows.ZLow + x0;
    const float* __restrict zh = rows.ZHigh + x0;
    const float* __restrict below = this->Responses[0] + start + x0;
    const float* __restrict above = this->Responses[2] + start + x0;
    const float signBelow = sign / this->GetFactorBelow();
    unsigned char any = 0;
    for (Index i = 0; i < count; ++i)
    {
      const float v = sign * c[i];
      const bool pass = (v > threshold) & (v >= sign * yl[i]) & (v >= sign * yh[i]) &
        (v >= sign * zl[i]) & (v >= sign * zh[i]) & (v > signBelow * below[i]) &
        (v >= sign * above[i]);
      candidates[i] = pass ? 1 : 0;
      any = static_cast<unsigned char>(any | candidates[i]);
    }
    return any != 0;
  }

  float GetFactorBelow() const { return this->IsHalved ? 1.f + HalvingTolerance : 1.f; }

  float Get(int scale, Index x, Index y, Index z) const
  {
    const Index* n = this->Lattice.Size;
    return this->Sign * this->Responses[scale][(z * n[1] + y) * n[0] + x];
  }

  bool IsMaximum(Index x, Index y, Index z) const
  {
    const Index* n = this->Lattice.Size;
    const float v = this->Get(1, x, y, z);
    for (int scale = 0; scale < 3; ++scale)
    {
      const float factor = scale == 0 ? 1.f / this->GetFactorBelow() : 1.f;
      for (Index dz = z > 0 ? -1 : 0; dz <= (z + 1 < n[2] ? 1 : 0); ++dz)
      {
        for (Index dy = y > 0 ? -1 : 0; dy <= (y + 1 < n[1] ? 1 : 0); ++dy)
        {
          for (Index dx = x > 0 ? -1 : 0; dx <= (x + 1 < n[0] ? 1 : 0); ++dx)
          {
            const Index order = ((scale - 1) * 3 + dz) * 9 + dy * 3 + dx;
            const float other = factor * this->Get(scale, x + dx, y + dy, z + dz);
            if (order != 0 && (order < 0 ? !(v > other) : !(v >= other)))
            {
              return false;
            }
          }
        }
      }
    }
    return true;
  }

  bool IsWide(Index x, Index y, Index z) const
  {
    const float least = SmallestPlateau * this->Get(1, x, y, z);
    for (int a = 0; a < 3; ++a)
    {
      for (const Index step : { -this->Width[a], this->Width[a] })
      {
        Index there[3] = { x, y, z };
        there[a] += step;
        const bool inside = there[a] >= 0 && there[a] < this->Lattice.Size[a];
        if (inside && !(this->Get(1, there[0], there[1], there[2]) >= least))
        {
          return false;
        }
      }
    }
    return true;
  }

  Blob Fit(Index x, Index y, Index z) const
  {
    Blob blob;
    blob.Scale = this->Scale;
    const Index at[3] = { x, y, z };
    const double center = this->Get(1, x, y, z);
    blob.Response = center;
    for (int a = 0; a < 3; ++a)
    {
      const Index stride = this->Lattice.Stride[a];
      blob.Voxel[a] = (this->Lattice.First[a] + at[a]) * stride;
      double offset = 0.;
      // At the border the volume is its own mirror image: the maximum is on it.
      if (at[a] > 0 && at[a] + 1 < this->Lattice.Size[a])
      {
        Index low[3] = { x, y, z }, high[3] = { x, y, z };
        low[a] -= 1;
        high[a] += 1;
        const double l = this->Get(1, low[0], low[1], low[2]);
        const double h = this->Get(1, high[0], high[1], high[2]);
        offset = FitParabola(l, center, h);
        blob.Response += 0.25 * (h - l) * offset;
      }
      blob.Position[a] = static_cast<double>(blob.Voxel[a]) + offset * static_cast<double>(stride);
    }
    const double values[3] = { this->Get(0, x, y, z), center, this->Get(2, x, y, z) };
    const double logSigma = FitParabola(this->LogSigmas, values);
    blob.Sigma = std::exp(logSigma);
    blob.Response += EvaluateParabola(this->LogSigmas, values, logSigma) - center;
    blob.Response *= -this->Sign;
    return blob;
  }
};

/**
 * Of blobs of the same polarity in consecutive scales that lie within `stride` samples of each
 * other keep the one with the stronger response. Both lists are, and stay, sorted by z of Voxel.
 */
inline void RemoveDuplicates(std::vector<Blob>& below, std::vector<Blob>& above,
  const Index stride[3])
{
  std::vector<bool> dropBelow(below.size(), false), dropAbove(above.size(), false);
  for (size_t i = 0; i < above.size(); ++i)
  {
    const Blob& blob = above[i];
    const auto first = std::lower_bound(below.begin(), below.end(), blob.Voxel[2] - stride[2],
      [](const Blob& b, Index z) { return b.Voxel[2] < z; });
    for (auto other = first; other != below.end(); ++other)
    {
      if (other->Voxel[2] > blob.Voxel[2] + stride[2])
      {
        break;
      }
      const bool same = std::abs(other->Voxel[0] - blob.Voxel[0]) <= stride[0] &&
        std::abs(other->Voxel[1] - blob.Voxel[1]) <= stride[1] &&
        (other->Response > 0.) == (blob.Response > 0.);
      if (same)
      {
        const bool keepsAbove = std::fabs(blob.Response) > std::fabs(other->Response);
        dropAbove[i] = dropAbove[i] || !keepsAbove;
        dropBelow[other - below.begin()] = dropBelow[other - below.begin()] || keepsAbove;
      }
    }
  }
  const auto drop = [](std::vector<Blob>& blobs, const std::vector<bool>& dropped)
  {
    size_t kept = 0;
    for (size_t i = 0; i < blobs.size(); ++i)
    {
      if (!dropped[i])
      {
        blobs[kept++] = blobs[i];
      }
    }
    blobs.resize(kept);
  };
  drop(below, dropBelow);
  drop(above, dropAbove);
}
}

#endif
