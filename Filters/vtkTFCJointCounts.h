// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The passes over the data of vtkTFCJointHistogram: ranges of attributes, occupied cells.
 *
 * Threaded, in chunks without allocations. Counts are integers: sums are exact in any order.
 */

#ifndef vtkTFCJointCounts_h
#define vtkTFCJointCounts_h

#include "Kernels/TFCKeyCounter.h"

#include "vtkType.h" // For vtkIdType

#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkTFCAttributeSamples;
class vtkTFCDistributedImage;
class vtkTFCSparseHistogram;

namespace vtkTFCJointCounts
{
/// A key is cell * 2^TertiaryBits + tertiary bin.
constexpr int TertiaryBits = 16;

/**
 * Smallest and largest value of an attribute; infinities the other way round when there is none.
 */
std::pair<double, double> FindRange(const vtkTFCAttributeSamples& samples, size_t attribute);

/**
 * Count the samples, whose first two or three attributes are the axes: a merged list. `axes` has
 * the ranges and bins. Returns false when the owner was aborted.
 */
bool Count(const vtkTFCAttributeSamples& samples, const vtkTFCSparseHistogram* axes,
  bool hasTertiary, vtkAlgorithm* owner, std::vector<tfc::KeyCount>& list);

/**
 * Collective. Replace the counts of this process by those of all.
 */
void Reduce(const vtkTFCDistributedImage& peers, std::vector<tfc::KeyCount>& list);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCJointCounts.h
