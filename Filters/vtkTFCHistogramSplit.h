// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether a histogram has two parts and where to cut, for the layers above: what the fields
 * mean, the formulas and the sources are in Kernels/TFCSplit.h.
 */

#ifndef vtkTFCHistogramSplit_h
#define vtkTFCHistogramSplit_h

#include "vtkTFCFiltersModule.h" // For export macro

#include <vector>

struct VTKTFCFILTERS_EXPORT vtkTFCHistogramSplit
{
  double Weight = 0.;
  double Separability = 0.;
  double Threshold = 0.; ///< in bins from the lower end
  double Valley = 0.;
  double Power = 0.;
  double Cut = 0.; ///< in bins from the lower end
  double Below = 0.;

  /**
   * Look for two parts. `counts` are weights of bins of about that many samples.
   */
  static vtkTFCHistogramSplit Find(const std::vector<double>& counts, double samples);
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCHistogramSplit.h
