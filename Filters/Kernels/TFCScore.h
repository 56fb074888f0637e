// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Score of the candidates for the tertiary attribute (Eq. 3 of the paper) and their ranks.
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
}

#endif
