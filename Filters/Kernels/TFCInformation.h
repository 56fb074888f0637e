// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Information that a third property T shares with two axes X and Y, and adds to them, from
 * their joint histogram.
 *
 * Entropies of cells, H = -sum p log2 p in bits, and from them (Cover and Thomas, Elements of
 * Information Theory, chapter 2):
 *   mutual information             I(T; X, Y)  = H(T) + H(X, Y) - H(X, Y, T)
 *   conditional mutual information I(T; X | Y) = H(X, Y) + H(Y, T) - H(Y) - H(X, Y, T)
 *   new information                H(T | X, Y) = H(X, Y, T) - H(X, Y) = H(T) - I(T; X, Y)
 * New information is what the full 3D histogram separates beyond the 2D one: 2^H(T | X, Y) is how
 * many equally likely bins of T a voxel of known X and Y could still be in. It counts noise, too.
 *
 * Few samples per cell make the entropies too small. Every entropy is corrected by (K - 1) / (2 N)
 * nats for K occupied cells and N samples (Miller, "Note on the bias of information estimates",
 * 1955), and the axes have few bins: see GetInformationBins(). Results are cut to what theory
 * allows: 0 <= I(T; X | Y) <= I(T; X, Y) and I(T; X, Y) + H(T | X, Y) = H(T).
 */

#ifndef TFCInformation_h
#define TFCInformation_h

#include "TFCGradient.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace tfc
{
/**
 * Bins per axis for `samples` samples: the largest power of two, 4 to 32, that leaves 32 samples
 * per cell of the 3D histogram on average.
 */
inline int GetInformationBins(double samples)
{
  int bins = 4;
  while (bins < 32 && 8. * bins * bins * bins * 32. <= samples)
  {
    bins *= 2;
  }
  return bins;
}

/**
 * Bins of `n` values, 0 to bins - 1 from minimum to maximum; -1 for NaN. 0 on a constant property.
 */
inline void FindCoarseBins(const double* values, Index n, double minimum, double maximum, int bins,
  std::int32_t* out)
{
  // Halves: the difference of the largest values would overflow.
  const double low = 0.5 * minimum;
  const double width = 0.5 * maximum - low;
  const double scale = width > 0. ? std::min(bins / width, 1e300) : 0.;
  const double last = bins - 1;
  for (Index i = 0; i < n; ++i)
  {
    double bin = (0.5 * values[i] - low) * scale;
    bin = bin > 0. ? bin : 0.; // NaN too
    bin = bin < last ? bin : last;
    out[i] = values[i] == values[i] ? static_cast<std::int32_t>(bin) : -1;
  }
}

/**
 * Entropy in bits with Miller's correction; 0 for no samples.
 */
inline double CorrectedEntropy(const std::vector<std::int64_t>& counts)
{
  double total = 0., sum = 0., occupied = 0.;
  for (const std::int64_t count : counts)
  {
    if (count > 0)
    {
      const auto c = static_cast<double>(count);
      total += c;
      sum += c * std::log2(c);
      occupied += 1.;
    }
  }
  constexpr double bitsPerNat = 1.4426950408889634;
  return total > 0. ? std::log2(total) - sum / total + (occupied - 1.) / (2. * total) * bitsPerNat
                    : 0.;
}

struct Information
{
  double Samples = 0.;
  double Entropy = 0.;           ///< H(T), bits, of the coarse histogram
  double Mutual = 0.;            ///< I(T; X, Y), bits
  double ConditionalMutual = 0.; ///< I(T; X | Y), bits
  double New = 0.;               ///< H(T | X, Y), bits
};

/**
 * From bins^3 counts of T (fastest), X, Y (slowest).
 */
inline Information MeasureInformation(const std::vector<std::int64_t>& counts, int bins)
{
  const auto b = static_cast<size_t>(bins);
  std::vector<std::int64_t> t(b, 0), y(b, 0), xy(b * b, 0), yt(b * b, 0);
  Information result;
  for (size_t cell = 0; cell < counts.size(); ++cell)
  {
    const size_t k = cell % b, i = cell / b % b, j = cell / (b * b);
    const std::int64_t count = counts[cell];
    t[k] += count;
    y[j] += count;
    xy[j * b + i] += count;
    yt[j * b + k] += count;
    result.Samples += static_cast<double>(count);
  }
  const double all = CorrectedEntropy(counts);
  const double axes = CorrectedEntropy(xy);
  result.Entropy = std::min(CorrectedEntropy(t), std::log2(static_cast<double>(bins)));
  result.New = std::min(result.Entropy, std::max(0., all - axes));
  result.Mutual = result.Entropy - result.New;
  const double conditional = axes + CorrectedEntropy(yt) - CorrectedEntropy(y) - all;
  result.ConditionalMutual = std::min(result.Mutual, std::max(0., conditional));
  return result;
}
}

#endif
