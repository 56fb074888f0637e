// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Histogram of one property and its entropy.
 *
 * Bins: q = floor((v - min) * bins / (max - min)), the maximum belonging to the last bin. An
 * integer property whose range max - min + 1 fits into the bins gets one bin per value instead, so
 * that no two neighbouring values share a bin by rounding. NaN is in no bin.
 *
 * Entropy: E = -sum p_b log2 p_b over the non-empty bins, in bits. Eq. 5 of the paper prints no
 * minus sign; the values of its Table 1 are positive, and so are these.
 */

#ifndef TFCHistogram_h
#define TFCHistogram_h

#include "TFCGradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace tfc
{
/**
 * The mapping of values to bins.
 */
struct Binning
{
  double Minimum = 0.;
  double Scale = 0.; ///< bins per unit of value
  Index Bins = 1;

  static Binning Make(double minimum, double maximum, bool integer, Index bins)
  {
    Binning result;
    result.Minimum = minimum;
    if (!(maximum > minimum))
    {
      return result;
    }
    if (integer && maximum - minimum + 1. <= static_cast<double>(bins))
    {
      result.Bins = static_cast<Index>(maximum - minimum) + 1;
      result.Scale = 1.;
      return result;
    }
    result.Bins = bins;
    // The cap keeps 0 * scale from becoming NaN when the range is denormal.
    result.Scale =
      std::min(static_cast<double>(bins) / (maximum - minimum), std::numeric_limits<double>::max());
    return result;
  }

  /**
   * Bin of a value; Bins (one past the last) for NaN.
   */
  Index GetBin(double value) const
  {
    const double q = (value - this->Minimum) * this->Scale;
    const double last = static_cast<double>(this->Bins - 1);
    const double clamped = q < 0. ? 0. : (q > last ? last : q);
    return static_cast<std::int32_t>(value == value ? clamped : last + 1.);
  }
};

/**
 * Histogram under construction. Four interleaved copies keep equal neighbouring values, the normal
 * case in a volume, from waiting for each other's increment.
 */
class Histogram
{
public:
  explicit Histogram(const Binning& binning)
    : Bins(binning)
    , Counts(4 * static_cast<size_t>(binning.Bins + 1), 0)
  {
  }

  void Add(const double* values, Index n)
  {
    // First the bins, in a loop that becomes vector code, then the increments.
    constexpr Index block = 512;
    std::array<std::int32_t, block> bins;
    const Index stride = this->Bins.Bins + 1;
    for (Index first = 0; first < n; first += block)
    {
      const Index count = std::min(block, n - first);
      for (Index i = 0; i < count; ++i)
      {
        bins[i] = static_cast<std::int32_t>(this->Bins.GetBin(values[first + i]));
      }
      for (Index i = 0; i < count; ++i)
      {
        ++this->Counts[(i & 3) * stride + bins[i]];
      }
    }
  }

  /**
   * Add the counts to `counts`, which has one entry per bin. The number of NaNs is dropped.
   */
  void AddTo(std::int64_t* counts) const
  {
    const Index stride = this->Bins.Bins + 1;
    for (Index b = 0; b < this->Bins.Bins; ++b)
    {
      counts[b] += this->Counts[b] + this->Counts[stride + b] + this->Counts[2 * stride + b] +
        this->Counts[3 * stride + b];
    }
  }

private:
  Binning Bins;
  std::vector<std::int64_t> Counts;
};

/**
 * Take pairs of neighbouring bins as one.
 */
inline void MergeBins(std::vector<std::int64_t>& counts)
{
  const std::size_t half = (counts.size() + 1) / 2;
  for (std::size_t b = 0; b < half; ++b)
  {
    counts[b] = counts[2 * b] + (2 * b + 1 < counts.size() ? counts[2 * b + 1] : 0);
  }
  counts.resize(half);
}

/**
 * Entropy of a histogram in bits; 0 when it is empty.
 */
inline double Entropy(const std::int64_t* counts, Index bins)
{
  double total = 0.;
  for (Index b = 0; b < bins; ++b)
  {
    total += static_cast<double>(counts[b]);
  }
  double entropy = 0.;
  for (Index b = 0; b < bins; ++b)
  {
    if (counts[b] > 0)
    {
      const double p = static_cast<double>(counts[b]) / total;
      entropy -= p * std::log2(p);
    }
  }
  return entropy;
}
}

#endif
