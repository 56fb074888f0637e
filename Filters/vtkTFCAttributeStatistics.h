// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Ranges, correlations and entropies of several attributes, over all processes.
 */

#ifndef vtkTFCAttributeStatistics_h
#define vtkTFCAttributeStatistics_h

#include "vtkTFCAttributeSamples.h"
#include "vtkTFCFiltersModule.h" // For export macro

#include <limits>
#include <vector>

class vtkAlgorithm;
class vtkTFCDistributedImage;

namespace vtkTFCAttributeStatistics
{
using Attribute = vtkTFCAttributeSamples::Attribute;

/// Of the samples with data.
struct Summary
{
  double Count = 0., Sum = 0.;
  double Minimum = std::numeric_limits<double>::infinity();
  double Maximum = -std::numeric_limits<double>::infinity();
};

struct Result
{
  std::vector<Summary> Summaries;
  std::vector<double> Correlations; ///< row-major matrix; NaN for constant attributes
  std::vector<double> Entropies;    ///< bits; 0 for constant attributes
  /// Entropies with 1, 2, 4 and 8 neighbouring bins taken as one.
  std::vector<std::vector<double>> CoarseEntropies;
};

///@{
/// With 0 bins: most bins of an integer attribute, which has one per value where they fit; and the
/// bins of one that is not integral, and so has no bit depth.
constexpr int LargestDepth = 65536;
constexpr int FloatBins = 256;
///@}

/**
 * Collective. Two threaded passes: range and mean, then sums and histograms. Double precision,
 * reduced in the order of fixed blocks: the result does not depend on the number of threads. The
 * labels must be the same on all processes. Returns false when aborted.
 */
VTKTFCFILTERS_EXPORT bool Compute(const vtkTFCAttributeSamples& samples,
  const vtkTFCDistributedImage& image, const std::vector<Attribute>& attributes, int bins,
  vtkAlgorithm* owner, Result& result);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributeStatistics.h
