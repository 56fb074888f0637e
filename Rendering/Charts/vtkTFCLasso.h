// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From a line drawn by hand to a polygon with few vertices.
 */

#ifndef vtkTFCLasso_h
#define vtkTFCLasso_h

#include "vtkTFCChartsModule.h" // For export macro
#include "vtkTFCOutline.h"      // For points

/**
 * The closed polygon of a stroke, in the units of the stroke (pixels of a chart).
 *
 * 1. Points that repeat their predecessor are dropped.
 * 2. Where the end of the stroke crosses its beginning (within the first and the last quarter),
 * what sticks out beyond the crossing is cut off; otherwise the ends are joined by a straight line.
 * 3. Vertices are removed by the method of Ramer (1972) and of Douglas and Peucker (1973): the
 *    result stays within `tolerance` of the stroke. The tolerance is doubled until at most
 *    `most` vertices are left.
 *
 * Empty when the stroke encloses less than `smallestArea` (the even-odd rule decides what is
 * inside, so crossings elsewhere are kept). Cost: n log n for usual strokes, at most n^2.
 */
VTKTFCCHARTS_EXPORT std::vector<vtkTFCOutline::Point> vtkTFCSimplifyLasso(
  std::vector<vtkTFCOutline::Point> stroke, double tolerance, double smallestArea,
  std::size_t most = 64);

#endif
// VTK-HeaderTest-Exclude: vtkTFCLasso.h
