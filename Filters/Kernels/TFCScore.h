// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Score of the candidates for the tertiary attribute (Eq. 3 of the paper), their ranks, and
 * how these depend on the balance of the score.
 *
 * s_i = -a |R_pi| + (1 - a) E_i / max E, with p the primary attribute and a in [0, 1). The maximum
 * runs over all properties, the primary and secondary ones included ("vector E of size l contains
 * all properties"). The primary and secondary attributes are no candidates; nor is a property whose
 * correlation with the primary is undefined (NaN: one of the two is constant).
 */

#ifndef TFCScore_h
#define TFCScore_h

#include "TFCGradient.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace tfc
{
struct Scores
{
  std::vector<double> Score; ///< NaN for what is not a candidate
  std::vector<int> Rank;     ///< 1 = best; 0 for what is not a candidate
};

/**
 * Scores of the l = entropies.size() properties from their correlation matrix (l x l, row-major).
 * `secondary` is -1 when there is none. Equal scores keep the order of the properties.
 */
inline Scores CombinationScores(const std::vector<double>& correlations,
  const std::vector<double>& entropies, double balance, int primary, int secondary)
{
  const size_t l = entropies.size();
  Scores result;
  result.Score.assign(l, std::numeric_limits<double>::quiet_NaN());
  result.Rank.assign(l, 0);
  const double largest = l ? *std::max_element(entropies.begin(), entropies.end()) : 0.;

  std::vector<int> order;
  for (size_t i = 0; i < l; ++i)
  {
    const int index = static_cast<int>(i);
    const double r = correlations[primary * l + i];
    if (index == primary || index == secondary || std::isnan(r))
    {
      continue;
    }
    const double information = largest > 0. ? entropies[i] / largest : 0.;
    result.Score[i] = -balance * std::abs(r) + (1. - balance) * information;
    order.push_back(index);
  }
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b) { return result.Score[a] > result.Score[b]; });
  for (size_t rank = 0; rank < order.size(); ++rank)
  {
    result.Rank[order[rank]] = static_cast<int>(rank) + 1;
  }
  return result;
}

/**
 * Candidates in the order of their scores, best first, while the balance a is in [From, To).
 */
struct RankingInterval
{
  double From, To;
  std::vector<int> Order;
};

/**
 * How the ranking depends on the balance: the intervals of [0, 1) in which it stays the same. Each
 * score is linear in a, s_i(a) = e_i - a (|R_pi| + e_i) with e_i = E_i / max E, so rankings change
 * where two lines cross. Arguments as for CombinationScores(). No intervals without candidates.
 * Cost: O(l^3 log l) for l properties.
 */
inline std::vector<RankingInterval> RankingIntervals(const std::vector<double>& correlations,
  const std::vector<double>& entropies, int primary, int secondary)
{
  const size_t l = entropies.size();
  const double largest = l ? *std::max_element(entropies.begin(), entropies.end()) : 0.;
  std::vector<double> start(l, 0.), slope(l, 0.);
  const Scores atZero = CombinationScores(correlations, entropies, 0., primary, secondary);
  for (size_t i = 0; i < l; ++i)
  {
    start[i] = largest > 0. ? entropies[i] / largest : 0.;
    slope[i] = -std::abs(correlations[primary * l + i]) - start[i];
  }
  std::vector<double> ends{ 0., 1. };
  for (size_t i = 0; i < l; ++i)
  {
    for (size_t j = 0; j < i; ++j)
    {
      const double a = (start[i] - start[j]) / (slope[j] - slope[i]);
      if (atZero.Rank[i] > 0 && atZero.Rank[j] > 0 && a > 0. && a < 1.)
      {
        ends.push_back(a);
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  std::vector<RankingInterval> intervals;
  for (size_t e = 0; e + 1 < ends.size(); ++e)
  {
    const Scores scores =
      CombinationScores(correlations, entropies, 0.5 * (ends[e] + ends[e + 1]), primary, secondary);
    RankingInterval interval{ ends[e], ends[e + 1], {} };
    const auto best = std::max_element(scores.Rank.begin(), scores.Rank.end());
    interval.Order.resize(best == scores.Rank.end() ? 0 : static_cast<size_t>(*best));
    for (size_t i = 0; i < l; ++i)
    {
      if (scores.Rank[i] > 0)
      {
        interval.Order[static_cast<size_t>(scores.Rank[i]) - 1] = static_cast<int>(i);
      }
    }
    if (interval.Order.empty() || interval.To - interval.From < 1e-12)
    {
      continue;
    }
    if (!intervals.empty() && intervals.back().Order == interval.Order)
    {
      intervals.back().To = interval.To;
    }
    else
    {
      intervals.push_back(interval);
    }
  }
  return intervals;
}
}

#endif
