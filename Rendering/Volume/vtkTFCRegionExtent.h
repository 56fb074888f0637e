// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where a region can be non-zero: conservative tests for parts of attribute space.
 *
 * "May" is never wrong when it says no. For ellipses, rectangles and their tertiary functions it is
 * nearly exact; polygons are taken for their bounding boxes.
 */

#ifndef vtkTFCRegionExtent_h
#define vtkTFCRegionExtent_h

#include "vtkTFCVolumeModule.h" // For export macro

#include "vtkTFCCompiledModel.h" // For vtkTFCCompiledRegion

#include <array>  // For boxes
#include <vector> // For intervals

/**
 * Whether the 2D weight of a region may be non-zero in a box (xmin, xmax, ymin, ymax) in axis
 * units.
 */
VTKTFCVOLUME_EXPORT bool vtkTFCMayOverlap(const vtkTFCCompiledRegion& region,
  const std::array<double, 4>& box);

/**
 * Disjoint closed intervals of tertiary values, in data units and increasing, outside of which the
 * region's tertiary opacity is zero. Everything for a region without a tertiary function.
 */
VTKTFCVOLUME_EXPORT std::vector<std::array<double, 2>> vtkTFCPositiveIntervals(
  const vtkTFCCompiledRegion& region);

#endif
// VTK-HeaderTest-Exclude: vtkTFCRegionExtent.h
