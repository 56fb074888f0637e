// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Fits a transfer function that was made for other data: other attributes, and values by
 * range or by quantile.
 */

#ifndef vtkTFCRescale_h
#define vtkTFCRescale_h

#include "vtkTFCChartsModule.h" // For export macro

#include <string> // For names
#include <vector> // For values

class vtkTFCTransferFunction;

/// What becomes of one attribute.
struct VTKTFCCHARTS_EXPORT vtkTFCAttributeChange
{
  std::string Array;
  int Component = 0; ///< -1: magnitude
  std::string NewArray;
  int NewComponent = 0;

  ///@{
  /**
   * From[i] goes to To[i], see vtkTFCValueMap: the extents of the old and the new data (by range),
   * or as many quantiles of both (by quantile). An empty `From` with two values in `To` stands for
   * the range of the axis or the tertiary function, or without one that of its nodes; an axis
   * without a range is not rescaled then. An empty `To` keeps all values.
   */
  std::vector<double> From;
  std::vector<double> To;
  ///@}
};

/**
 * Change the attributes of `model`, and with them axis ranges, shapes, tertiary nodes and ranges.
 * Attributes that are not listed stay.
 *
 * Corners of triangles and polygons are mapped one by one. Ellipses and rectangles stay what they
 * are: the four ends of their axes are mapped; the mean of these becomes the centre, their
 * distances the size, and the direction of the first axis the angle. Exact for maps by range and
 * for rectangles along the axes, else an approximation: a map that is not linear bends an ellipse.
 * Where three nodes or more would get one value, the first and the last stay.
 *
 * Returns the number of regions whose shape would vanish: they keep theirs. Cost: values.
 */
VTKTFCCHARTS_EXPORT int vtkTFCRescale(vtkTFCTransferFunction* model,
  const std::vector<vtkTFCAttributeChange>& changes);

#endif
// VTK-HeaderTest-Exclude: vtkTFCRescale.h
