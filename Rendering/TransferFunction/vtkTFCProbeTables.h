// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The tables of vtkTFCRayProbe, which documents their columns.
 */

#ifndef vtkTFCProbeTables_h
#define vtkTFCProbeTables_h

#include <array>  // For points
#include <vector> // For values

class vtkTFCClassifier;
class vtkTFCRaySampler;
class vtkTFCTransferFunction;
class vtkTable;

namespace vtkTFCProbeTables
{
struct Location
{
  std::array<double, 3> Place; ///< world coordinates
  double Distance;             ///< from the eye
  int Block;
  bool Reached;
  double Opacity;      ///< accumulated
  double TotalOpacity; ///< of the whole line
  std::array<double, 4> Color;
  std::array<double, 2> Axes; ///< primary and secondary value
};

/// The row of table "Location".
void FillLocation(vtkTable* table, const vtkTFCRaySampler& sampler, const Location& location);

/// The rows of table "Regions" for a sample whose attributes have `values`.
void FillRegions(vtkTable* table, const vtkTFCClassifier& classifier,
  const vtkTFCTransferFunction* names, const std::vector<double>& values);
}

#endif
