// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far it is from each brick to the next one with something to see.
 *
 * The chessboard distance max(|dx|, |dy|, |dz|) is that of leaps: a ray in a brick at distance n
 * may pass n - 1 bricks in any direction. It separates: from the distances along rows, those in
 * layers are min over k of max(|k|, distance k rows away), and likewise for the volume. Each step
 * takes bytes of whole rows side by side, and ends where nothing nearer can come; threaded.
 */

#ifndef vtkTFCBrickDistances_h
#define vtkTFCBrickDistances_h

#include "vtkTFCVolumeModule.h" // For export macro

#include <array>  // For dimensions
#include <vector> // For the bricks

namespace vtkTFCBrickDistances
{
/// Distances are cut here: a leap over more bricks at a time gains nothing.
constexpr int Largest = 31;

/**
 * For every brick the chessboard distance to the nearest active brick, in bricks: 0 for active
 * ones, at most Largest. `active` holds 1 for active bricks, else 0, x fastest.
 */
VTKTFCVOLUME_EXPORT std::vector<unsigned char> Find(const std::vector<unsigned char>& active,
  const std::array<int, 3>& dimensions);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCBrickDistances.h
