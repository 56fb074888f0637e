// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether a histogram has two parts, how far apart they are, and where to cut.
 *
 * For an edge e between bins, with w0, w1 the parts of the weight below and above and m0, m1 their
 * means, the between-class variance is w0 w1 (m1 - m0)^2; eta(e) is that over the total variance,
 * in [0, 1], and its maximum is the best threshold (Otsu, "A threshold selection method from
 * gray-level histograms", 1979). A single bell has 2/pi there and a box 3/4: so the valley counts,
 * too. Its depth in bin v is d(v) = 1 - s(v) / min(L, R), at least 0, with s the smoothed histogram
 * and L, R its maxima to the left and to the right of v; 0 where nothing rises again, 1 for a gap.
 * The cut is where eta d is largest; that product is the power of the split. Where it is 0
 * everywhere the cut is the best threshold.
 *
 * Smoothing: repeated binomial weights (1, 2, 1) / 4, reflected at the ends, with the standard
 * deviation 0.9 min(sd, IQR / 1.34) n^(-1/5) for n samples (Silverman, Density Estimation, 1986,
 * eq. 3.31), at most an eighth of the bins: noise in small histograms makes no valleys.
 */

#ifndef TFCSplit_h
#define TFCSplit_h

#include "TFCGradient.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tfc
{
struct Split
{
  double Weight = 0.;       ///< total
  double Separability = 0.; ///< eta at the best threshold, 0 to 1
  double Threshold = 0.;    ///< that threshold, in bins from the lower end
  double Valley = 0.;       ///< depth at the cut, 0 to 1
  double Power = 0.;        ///< eta d at the cut, 0 to 1
  double Cut = 0.;          ///< in bins from the lower end
  double Below = 0.;        ///< part of the weight below the cut
};

/**
 * Position in bins below which the fraction `part` of the weight lies.
 */
inline double FindQuantile(const std::vector<double>& counts, double total, double part)
{
  double sum = 0.;
  for (size_t b = 0; b < counts.size(); ++b)
  {
    if (sum + counts[b] >= part * total && counts[b] > 0.)
    {
      return static_cast<double>(b) + (part * total - sum) / counts[b];
    }
    sum += counts[b];
  }
  return static_cast<double>(counts.size());
}

/**
 * Binomial smoothing with a standard deviation given in bins.
 */
inline std::vector<double> SmoothHistogram(std::vector<double> counts, double sigma)
{
  const size_t n = counts.size();
  const int passes = static_cast<int>(std::lround(2. * sigma * sigma));
  std::vector<double> next(n);
  for (int pass = 0; pass < passes && n > 1; ++pass)
  {
    for (size_t b = 0; b < n; ++b)
    {
      const double left = counts[b > 0 ? b - 1 : 0];
      const double right = counts[b + 1 < n ? b + 1 : n - 1];
      next[b] = 0.25 * left + 0.5 * counts[b] + 0.25 * right;
    }
    counts.swap(next);
  }
  return counts;
}

/**
 * Between-class variance over total variance at every edge: entry e is the edge below bin e.
 */
inline std::vector<double> FindSeparabilities(const std::vector<double>& counts)
{
  const size_t n = counts.size();
  double total = 0., mean = 0., square = 0.;
  for (size_t b = 0; b < n; ++b)
  {
    total += counts[b];
    mean += counts[b] * static_cast<double>(b);
  }
  mean = total > 0. ? mean / total : 0.;
  for (size_t b = 0; b < n; ++b)
  {
    const double d = static_cast<double>(b) - mean;
    square += counts[b] * d * d;
  }
  std::vector<double> result(n + 1, 0.);
  double below = 0., moment = 0.;
  for (size_t e = 1; e < n && square > 0.; ++e)
  {
    below += counts[e - 1];
    moment += counts[e - 1] * (static_cast<double>(e - 1) - mean);
    const double above = total - below;
    // w0 w1 (m1 - m0)^2 = moment^2 / (w0 w1), as the moments of both parts cancel.
    result[e] = below > 0. && above > 0. ? moment * moment * total / (below * above) / square : 0.;
  }
  return result;
}

/**
 * Middle of the run of entries that are the largest, within rounding.
 */
inline double FindMaximum(const std::vector<double>& values)
{
  const auto best = std::max_element(values.begin(), values.end());
  auto last = best;
  while (last + 1 != values.end() && last[1] >= *best * (1. - 1e-12))
  {
    ++last;
  }
  return 0.5 * static_cast<double>((best - values.begin()) + (last - values.begin()));
}

/**
 * `counts` are weights of bins, not negative, of `samples` samples. Cost: bins^3 / 32 at most.
 */
inline Split FindSplit(const std::vector<double>& counts, double samples)
{
  Split split;
  const size_t n = counts.size();
  for (const double count : counts)
  {
    split.Weight += count;
  }
  const std::vector<double> eta = FindSeparabilities(counts);
  split.Separability = n > 0 ? *std::max_element(eta.begin(), eta.end()) : 0.;
  if (!(split.Separability > 0.))
  {
    return split; // empty, or all in one bin
  }
  split.Threshold = FindMaximum(eta);

  double mean = 0., square = 0.;
  for (size_t b = 0; b < n; ++b)
  {
    mean += counts[b] * static_cast<double>(b) / split.Weight;
    square += counts[b] * static_cast<double>(b) * static_cast<double>(b) / split.Weight;
  }
  const double deviation = std::sqrt(std::max(0., square - mean * mean));
  const double quartiles =
    FindQuantile(counts, split.Weight, 0.75) - FindQuantile(counts, split.Weight, 0.25);
  const double spread = std::max(0.5, std::min(deviation, quartiles / 1.34));
  const double sigma =
    std::min(static_cast<double>(n) / 8., 0.9 * spread * std::pow(std::max(1., samples), -0.2));
  const std::vector<double> smooth = SmoothHistogram(counts, sigma);

  std::vector<double> right(n, 0.), depth(n, 0.), power(n, 0.);
  for (size_t b = n - 1; b > 0; --b)
  {
    right[b - 1] = std::max(right[b], smooth[b]);
  }
  double left = 0.;
  for (size_t b = 0; b < n; ++b)
  {
    const double lower = std::min(left, right[b]);
    depth[b] = lower > 0. ? std::max(0., 1. - smooth[b] / lower) : 0.;
    power[b] = depth[b] * std::max(eta[b], eta[b + 1]);
    left = std::max(left, smooth[b]);
  }
  const double best = FindMaximum(power);
  const auto bin = static_cast<size_t>(best);
  split.Power = power[bin];
  split.Valley = split.Power > 0. ? depth[bin] : 0.;
  split.Cut = split.Power > 0. ? best + 0.5 : split.Threshold;
  const auto whole = static_cast<size_t>(split.Cut);
  for (size_t b = 0; b < whole; ++b)
  {
    split.Below += counts[b] / split.Weight;
  }
  split.Below +=
    (split.Cut - static_cast<double>(whole)) * (whole < n ? counts[whole] / split.Weight : 0.);
  return split;
}
}

#endif
