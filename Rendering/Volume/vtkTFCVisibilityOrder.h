// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief In which order boxes must be drawn so that nearer ones cover farther ones.
 */

#ifndef vtkTFCVisibilityOrder_h
#define vtkTFCVisibilityOrder_h

#include "vtkTFCVolumeModule.h" // For export macro

#include <array>  // For boxes
#include <vector> // For lists

namespace vtkTFCVisibilityOrder
{
using Box = std::array<double, 6>;

/// From where boxes are seen, in their coordinates: a place, or a direction where Parallel.
struct Eye
{
  std::array<double, 3> Place;
  bool Parallel; ///< Place is the direction of view, away from the eye
};

/**
 * Indices of the boxes, farthest first. For every pair that a plane along the axes separates, also
 * when they touch, the one on the eye's side comes later. Boxes that overlap, or that cover each
 * other in a circle, come in the order of their centres. O(n^2) comparisons for n boxes.
 */
VTKTFCVOLUME_EXPORT std::vector<int> Find(const std::vector<Box>& boxes, const Eye& eye);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCVisibilityOrder.h
