// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which bricks of a packed image a transfer function can show.
 *
 * A brick is active when some region's 2D weight may be non-zero over the brick's range of the two
 * axes and the region's tertiary opacity may be non-zero over its range of the tertiary attribute.
 * No visible sample lies in an inactive brick; a few active bricks may turn out empty.
 *
 * Cost: a few comparisons per brick and region that is near; summed-area tables over the cells of
 * the axes' unit square decide most bricks at once. Threaded. Memory: 1 byte a brick.
 */

#ifndef vtkTFCBrickActivity_h
#define vtkTFCBrickActivity_h

#include "vtkTFCBrickRanges.h"
#include "vtkTFCCompiledModel.h"
#include "vtkTFCShaderTables.h" // For vtkTFCStoredAttribute
#include "vtkTFCVolumeModule.h" // For export macro

#include <vector> // For the bricks

namespace vtkTFCBrickActivity
{
/**
 * For every brick 1 when it is active, else 0. `stored` says how the attributes of `model` are
 * stored in the channels that `ranges` were taken of, those beyond the fourth in `moreRanges`,
 * which is empty where there are none.
 */
VTKTFCVOLUME_EXPORT std::vector<unsigned char> Find(const vtkTFCBrickRanges& ranges,
  const vtkTFCBrickRanges& moreRanges, const vtkTFCCompiledModel& model,
  const std::vector<vtkTFCStoredAttribute>& stored);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCBrickActivity.h
