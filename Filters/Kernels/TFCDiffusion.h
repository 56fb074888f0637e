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
 * Step lengths that together last `time`, in cycles of equal length: the first of a cycle is at a
 * multiple of the cycle's length n. `longestStable` is tau_max, for distances h_a between the
 * samples 1 / (2 sum of 1 / h_a^2). Empty for a time that is not positive.
 */
struct DiffusionSchedule
{
  int CycleSteps = 0;
  std::vector<double> Steps;
};

inline DiffusionSchedule MakeDiffusionSchedule(double time, double longestStable,
  int longestCycle = MaximumCycleSteps)
{
  DiffusionSchedule schedule;
  if (!(time > 0.))
  {
    return schedule;
  }
  const double longest = longestStable * longestCycle * (longestCycle + 1) / 3.;
  // The tolerance is for times that are multiples of a cycle but for rounding.
  const int cycles = std::max(1, static_cast<int>(std::ceil(time / longest - 1e-9)));
  const double each = time / cycles;
  const int n = std::max(1,
    static_cast<int>(std::ceil(std::sqrt(3. * each / longestStable + 0.25) - 0.5 - 1e-9)));
  const double q = 3. * each / (longestStable * n * (n + 1));
  // Long steps between short ones, or rounding errors would grow: every kappa-th modulo a prime.
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
  std::vector<double> cycle;
  for (int k = 1; static_cast<int>(cycle.size()) < n; ++k)
  {
    const int j = (k * kappa) % prime - 1;
    if (j >= 0 && j < n)
    {
      const double cosine = std::cos(3.14159265358979323846 * (2 * j + 1) / (4 * n + 2));
      cycle.push_back(q * longestStable / (2. * cosine * cosine));
    }
  }
  schedule.CycleSteps = n;
  for (int i = 0; i < cycles; ++i)
  {
    schedule.Steps.insert(schedule.Steps.end(), cycle.begin(), cycle.end());
  }
  return schedule;
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
 * Call sample(x, low, high) for a row of n samples with the indices of the neighbours: the
 * interior in a loop that the compiler can vectorise.
 */
template <typename Sample>
inline void ForRow(Index n, const Sample& sample)
{
  sample(0, 0, n > 1 ? 1 : 0);
  for (Index x = 1; x < n - 1; ++x)
  {
    sample(x, x - 1, x + 1);
  }
  if (n > 1)
  {
    sample(n - 1, n - 2, n - 1);
  }
}

/**
 * One step from `from` to `to` for slice z; the conductance comes from `cycle`, the lattice at the
 * beginning of the cycle. `to` must be another lattice than both. `Masked` must be true when
 * the lattice may hold NaN.
 */
template <bool Nonlinear, bool Masked>
inline void DiffuseSlice(const float* from, const float* cycle, const Index n[3],
  const DiffusionCoefficients& coefficients, Index z, float* to)
{
  const float fx = coefficients.Flux[0], fy = coefficients.Flux[1], fz = coefficients.Flux[2];
  const float ex = coefficients.Edge[0], ey = coefficients.Edge[1], ez = coefficients.Edge[2];
  const auto flux = [](float here, float there, float gHere, float gThere, float f, float e)
  {
    float result = (there - here) * f;
    if constexpr (Nonlinear)
    {
      const float g = gThere - gHere;
      result = result / (1.f + g * g * e);
    }
    if constexpr (Masked)
    {
      result = IsValid(result) ? result : 0.f;
    }
    return result;
  };
  for (Index y = 0; y < n[1]; ++y)
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
    ForRow(n[0],
      [=](Index x, Index low, Index high)
      {
        const float c = uc[x], d = gc[x];
        // Sums of opposite faces first: a mirrored lattice then gives mirrored bits.
        const float alongX =
          flux(c, uc[low], d, gc[low], fx, ex) + flux(c, uc[high], d, gc[high], fx, ex);
        const float alongY = flux(c, ul[x], d, gl[x], fy, ey) + flux(c, uh[x], d, gh[x], fy, ey);
        const float alongZ = flux(c, ub[x], d, gb[x], fz, ez) + flux(c, ut[x], d, gt[x], fz, ez);
        out[x] = c + ((alongX + alongY) + alongZ);
      });
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
    ForRow(n[0],
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
