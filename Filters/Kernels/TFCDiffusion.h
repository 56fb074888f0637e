// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Explicit steps of linear and of Perona-Malik diffusion, and the Laplacian.
 *
 * dL/dT = div(c grad L). Linear: c = 1, and time T makes a Gaussian of sigma = sqrt(2 T). Nonlinear
 * (Perona and Malik 1990, second conductance): c = 1 / (1 + (g / K)^2) with g the difference across
 * the face between two samples. A step adds the fluxes over the faces to the 2, 4 or 6 neighbours.
 *
 * Fast explicit diffusion (Grewenig, Weickert and Bruhn 2010): cycles of n steps of which some are
 * longer than a stable one, tau_j = q tau_max / (2 cos^2(pi (2j+1) / (4n+2))), reach
 * tau_max (n^2+n) / 3. The conductance must not change within a cycle: it is computed from the
 * lattice at its beginning. Only short cycles look like a Gaussian (one step after the other is a
 * Gaussian by the central limit theorem; one cycle is a box), so that they have at most
 * MaximumCycleSteps steps.
 *
 * Nothing flows across the border or across a face to an invalid sample (NaN), which stays NaN.
 *
 * Layout: x fastest, then y, then z. Cost of a step: 8 bytes per sample read (4 in a cycle's
 * first step and in a linear one) and 4 written; no allocation. Results do not depend on how slices
 * are spread over threads.
 */

#ifndef TFCDiffusion_h
#define TFCDiffusion_h

#include "TFCGradient.h"

#include <cmath>
#include <vector>

namespace tfc
{
constexpr int MaximumCycleSteps = 6;

/**
 * The longest time of a cycle of n steps: `longestStable` is tau_max, for distances h_a between
 * the samples 1 / (2 sum of 1 / h_a^2).
 */
inline double GetLongestCycle(int n, double longestStable)
{
  return longestStable * n * (n + 1) / 3.;
}

/**
 * The lengths of the n steps of a cycle that lasts `time`, at most GetLongestCycle(). Long steps
 * stand between short ones, or rounding errors would grow: every kappa-th modulo a prime.
 */
inline std::vector<double> MakeCycle(int n, double time)
{
  const auto isPrime = [](int p)
  {
    for (int d = 2; d * d <= p; ++d)
    {
      if (p % d == 0)
      {
        return false;
      }
    }
    return p > 1;
  };
  int prime = n + 1;
  while (!isPrime(prime))
  {
    ++prime;
  }
  const int kappa = std::max(1, n / 2);
  std::vector<double> steps;
  for (int k = 1; static_cast<int>(steps.size()) < n; ++k)
  {
    const int j = (k * kappa) % prime - 1;
    if (j >= 0 && j < n)
    {
      const double cosine = std::cos(3.14159265358979323846 * (2 * j + 1) / (4 * n + 2));
      steps.push_back(1.5 * time / (n * (n + 1) * cosine * cosine));
    }
  }
  return steps;
}

/**
 * Coefficients per axis: Flux is tau / h^2, Edge is 1 / K^2 for differences between neighbours of
 * that axis (not used by linear diffusion). Both must be 0 along an axis with one sample.
 */
struct DiffusionCoefficients
{
  float Flux[3] = { 0.f, 0.f, 0.f };
  float Edge[3] = { 0.f, 0.f, 0.f };
};

/**
 * The rows around row (y, z); a missing one is replaced by the row itself.
 */
struct NeighborRows
{
  NeighborRows(const float* lattice, const Index n[3], Index y, Index z)
    : Center(lattice + (z * n[1] + y) * n[0])
    , YLow(y > 0 ? Center - n[0] : Center)
    , YHigh(y + 1 < n[1] ? Center + n[0] : Center)
    , ZLow(z > 0 ? Center - n[0] * n[1] : Center)
    , ZHigh(z + 1 < n[2] ? Center + n[0] * n[1] : Center)
  {
  }
  const float* Center;
  const float* YLow;
  const float* YHigh;
  const float* ZLow;
  const float* ZHigh;
};

/**
 * Call sample(x, low, high) for row (y, z) with the indices of the neighbours in x. Where the
 * memory around the row belongs to the lattice, the vectorised loop begins with it, at an aligned
 * address if rows are; its wrong first and last sample are then overwritten.
 */
template <typename Sample>
inline void ForRow(const Index n[3], Index y, Index z, const Sample& sample)
{
  const bool isFirst = y == 0 && z == 0, isLast = y + 1 == n[1] && z + 1 == n[2];
  const Index begin = isFirst ? 1 : 0, end = isLast ? n[0] - 1 : n[0];
  for (Index x = begin; x < end; ++x)
  {
    sample(x, x - 1, x + 1);
  }
  sample(0, 0, n[0] > 1 ? 1 : 0);
  if (n[0] > 1)
  {
    sample(n[0] - 1, n[0] - 2, n[0] - 1);
  }
}

/**
 * One step from `from` to `to` for the slices [begin, end); the conductance comes from `cycle`, the
 * lattice at the beginning of the cycle. `to` must be another lattice than both. `Masked` must be
 * true when the lattice may hold NaN.
 */
template <bool Nonlinear, bool Masked>
inline void DiffuseSlices(const float* from, const float* cycle, const Index n[3],
  const DiffusionCoefficients& coefficients, Index begin, Index end, float* to)
{
  const float fx = coefficients.Flux[0], fy = coefficients.Flux[1], fz = coefficients.Flux[2];
  const float ex = coefficients.Edge[0], ey = coefficients.Edge[1], ez = coefficients.Edge[2];
  // What flows in over two opposite faces, with one division for both. Opposite ones are treated
  // alike: a mirrored lattice gives mirrored bits.
  const auto flux =
    [](float here, float low, float high, float gHere, float gLow, float gHigh, float f, float e)
  {
    float fromLow = low - here, fromHigh = high - here;
    if constexpr (Masked)
    {
      fromLow = IsValid(fromLow) ? fromLow : 0.f;
      fromHigh = IsValid(fromHigh) ? fromHigh : 0.f;
    }
    if constexpr (!Nonlinear)
    {
      return (fromLow + fromHigh) * f;
    }
    else
    {
      float toLow = gLow - gHere, toHigh = gHigh - gHere;
      if constexpr (Masked)
      {
        toLow = IsValid(toLow) ? toLow : 0.f;
        toHigh = IsValid(toHigh) ? toHigh : 0.f;
      }
      const float a = 1.f + toLow * toLow * e, b = 1.f + toHigh * toHigh * e;
      return (fromLow * b + fromHigh * a) * f / (a * b);
    }
  };
  const auto row = [&](Index y, Index z)
  {
    const NeighborRows u(from, n, y, z), g(cycle, n, y, z);
    const float* __restrict uc = u.Center;
    const float* __restrict ul = u.YLow;
    const float* __restrict uh = u.YHigh;
    const float* __restrict ub = u.ZLow;
    const float* __restrict ut = u.ZHigh;
    const float* __restrict gc = g.Center;
    const float* __restrict gl = g.YLow;
    const float* __restrict gh = g.YHigh;
    const float* __restrict gb = g.ZLow;
    const float* __restrict gt = g.ZHigh;
    float* __restrict out = to + (z * n[1] + y) * n[0];
    ForRow(n, y, z,
      [=](Index x, Index low, Index high)
      {
        const float c = uc[x], d = gc[x];
        const float alongX = flux(c, uc[low], uc[high], d, gc[low], gc[high], fx, ex);
        const float alongY = flux(c, ul[x], uh[x], d, gl[x], gh[x], fy, ey);
        const float alongZ = flux(c, ub[x], ut[x], d, gb[x], gt[x], fz, ez);
        out[x] = c + ((alongX + alongY) + alongZ);
      });
  };
  // Bands of rows, of which three slices of both lattices fit into the second-level cache.
  const Index band = std::max<Index>(4, (Index{ 1 } << 14) / n[0]);
  for (Index first = 0; first < n[1]; first += band)
  {
    for (Index z = begin; z < end; ++z)
    {
      for (Index y = first; y < std::min(n[1], first + band); ++y)
      {
        row(y, z);
      }
    }
  }
}

/**
 * The Laplacian of slice z, each axis with its weight; 0 for an invalid sample.
 */
template <bool Masked>
inline void LaplacianSlice(const float* lattice, const Index n[3], const float weights[3], Index z,
  float* to)
{
  const float wx = weights[0], wy = weights[1], wz = weights[2];
  const auto difference = [](float here, float there)
  {
    const float result = there - here;
    if constexpr (Masked)
    {
      return IsValid(result) ? result : 0.f;
    }
    return result;
  };
  for (Index y = 0; y < n[1]; ++y)
  {
    const NeighborRows u(lattice, n, y, z);
    const float* __restrict uc = u.Center;
    const float* __restrict ul = u.YLow;
    const float* __restrict uh = u.YHigh;
    const float* __restrict ub = u.ZLow;
    const float* __restrict ut = u.ZHigh;
    float* __restrict out = to + (z * n[1] + y) * n[0];
    ForRow(n, y, z,
      [=](Index x, Index low, Index high)
      {
        const float c = uc[x];
        const float alongX = (difference(c, uc[low]) + difference(c, uc[high])) * wx;
        const float alongY = (difference(c, ul[x]) + difference(c, uh[x])) * wy;
        const float alongZ = (difference(c, ub[x]) + difference(c, ut[x])) * wz;
        out[x] = (alongX + alongY) + alongZ;
      });
  }
}
}

#endif
