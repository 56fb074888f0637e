// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Correlations and entropies of several point attributes, over all processes.
 *
 * An attribute is a point array, `name`, a component of it, `name:2`, or its norm,
 * `name:magnitude`. No data are NaN, infinities, blanked points and fill values.
 */

#ifndef vtkTFCAttributeStatistics_h
#define vtkTFCAttributeStatistics_h

#include "vtkTFCFiltersModule.h" // For export macro

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;
class vtkPointData;
class vtkTFCDistributedImage;

namespace vtkTFCAttributeStatistics
{
struct Attribute
{
  std::string Label;
  vtkDataArray* Array = nullptr; ///< null on a process without points
  int Component = 0;
  bool Integer = false; ///< whether all values are integers
};

/**
 * The attribute that `text` names. Returns what is wrong and what to do; empty when nothing is.
 */
VTKTFCFILTERS_EXPORT std::string Find(vtkPointData* points, const std::string& text,
  Attribute& found);

/**
 * All single-component numeric arrays but the ghost array.
 */
VTKTFCFILTERS_EXPORT std::vector<Attribute> FindAll(vtkPointData* points);

struct Result
{
  std::vector<double> Correlations; ///< row-major matrix; NaN for constant attributes
  std::vector<double> Entropies;    ///< bits; 0 for constant attributes
};

/**
 * Collective. Two threaded passes: range and mean, then sums and histograms. Double precision,
 * reduced in the order of fixed blocks: the result does not depend on the number of threads. The
 * labels must be the same on all processes. Returns false when aborted.
 */
VTKTFCFILTERS_EXPORT bool Compute(vtkDataSet* data, const vtkTFCDistributedImage& image,
  const std::vector<Attribute>& attributes, const std::vector<double>& fillValues, int bins,
  vtkAlgorithm* owner, Result& result);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributeStatistics.h
