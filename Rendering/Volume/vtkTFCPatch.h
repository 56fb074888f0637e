// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Many overlapping regions in a small cell of attribute space as one bilinear patch.
 *
 * Where regions without tertiary functions overlap, their blend is a function of the two axes
 * alone. In a cell in which it is smooth enough, Nodes x Nodes values, interpolated, stand for all
 * of them: the cost of a sample then does not grow with their number. Cells with an outline of a
 * constant fall-off, a kink or a narrow region are not smooth, and keep their regions.
 */

#ifndef vtkTFCPatch_h
#define vtkTFCPatch_h

#include "vtkTFCVolumeModule.h" // For export macro

#include "vtkTFCCompiledModel.h" // For vtkTFCCompiledModel

#include <array>  // For boxes
#include <vector> // For the regions

struct VTKTFCVOLUME_EXPORT vtkTFCPatch
{
  static constexpr int Nodes = 4;
  /// Fewer regions are evaluated one by one as fast.
  static constexpr int FewestRegions = 4;
  /// Largest difference to the blend in the middle between nodes, relative to the cell's largest
  /// opacity.
  static constexpr double Tolerance = 2e-3;

  /// Colour times opacity, and opacity, x fastest. The outer nodes lie on the cell's corners.
  std::array<std::array<float, 4>, Nodes * Nodes> Values;

  /**
   * Fill Values for some regions of a model, in list order, in a box (xmin, xmax, ymin, ymax) in
   * axis units. Returns false when the regions cannot be had this way.
   */
  bool Fit(const vtkTFCCompiledModel& model, const std::vector<int>& regions,
    const std::array<double, 4>& box);
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCPatch.h
