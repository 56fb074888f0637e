// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Six noisy materials with known geometry, after the synthetic dataset of the paper.
 *
 * Zhou, Schott, Hansen 2012, section 5.1: an environment, an outer hull, a filling and three
 * spheres whose values overlap, so that no single attribute separates them. Means and deviations
 * are the paper's; the paper does not give the geometry, the numbers below are this project's.
 *
 * A sample's value is mean + noise * (deviation * N0 + 0.02 * N1) with independent standard
 * normals: N0 stands for the material's texture, N1 for the scanner. The normals are a hash of seed
 * and sample index (the finaliser of SplitMix64, then Box and Muller), so a sample does not depend
 * on the order in which, or by which thread or process, samples are computed.
 */

#ifndef TFCPhantom_h
#define TFCPhantom_h

#include <cmath>
#include <cstdint>

namespace tfc
{
struct PhantomMaterial
{
  double Center[3]; ///< of a ball in the cube [-1, 1]^3
  double Radius;
  double Mean;
  double Deviation;
};

constexpr int NumberOfPhantomMaterials = 6;

/// Where balls overlap the last one holds. The first is everywhere.
constexpr PhantomMaterial PhantomMaterials[NumberOfPhantomMaterials] = {
  { { 0, 0, 0 }, 1e9, 0.20, 0.14 },          // environment
  { { 0, 0, 0 }, 0.85, 0.60, 0.11 },         // outer hull
  { { 0, 0, 0 }, 0.70, 0.40, 0.16 },         // filling
  { { 0, 0.34, 0 }, 0.16, 0.60, 0.11 },      // A: small, above
  { { -0.20, -0.20, 0 }, 0.28, 0.80, 0.13 }, // B: larger, below left
  { { 0.33, -0.26, 0 }, 0.12, 0.80, 0.13 }   // C: small, below right
};
constexpr double PhantomScannerDeviation = 0.02;

/**
 * Material at a position in [-1, 1]^3; `scale` multiplies the centres and radii of the balls.
 */
inline int PhantomMaterialAt(double x, double y, double z, double scale)
{
  for (int m = NumberOfPhantomMaterials - 1; m > 0; --m)
  {
    const PhantomMaterial& ball = PhantomMaterials[m];
    const double dx = x - scale * ball.Center[0];
    const double dy = y - scale * ball.Center[1];
    const double dz = z - scale * ball.Center[2];
    if (dx * dx + dy * dy + dz * dz < scale * scale * ball.Radius * ball.Radius)
    {
      return m;
    }
  }
  return 0;
}

/**
 * Number `draw` (0..3) of sample `index` under `seed`, uniform in (0, 1).
 */
inline double PhantomUniform(std::uint64_t seed, std::uint64_t index, unsigned int draw)
{
  std::uint64_t z = ((seed << 40) + 1 + 4 * index + draw) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  z ^= z >> 31;
  return (static_cast<double>(z >> 11) + 0.5) * 0x1.0p-53;
}

/**
 * Standard normal number `which` (0 or 1) of a sample.
 */
inline double PhantomNormal(std::uint64_t seed, std::uint64_t index, unsigned int which)
{
  constexpr double twoPi = 6.283185307179586476925286766559;
  const double u = PhantomUniform(seed, index, 2 * which);
  const double v = PhantomUniform(seed, index, 2 * which + 1);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(twoPi * v);
}

/**
 * Value of a sample of `material`.
 */
inline float PhantomValue(int material, std::uint64_t seed, std::uint64_t index, double noise)
{
  const PhantomMaterial& m = PhantomMaterials[material];
  return static_cast<float>(m.Mean +
    noise *
      (m.Deviation * PhantomNormal(seed, index, 0) +
        PhantomScannerDeviation * PhantomNormal(seed, index, 1)));
}
}

#endif
