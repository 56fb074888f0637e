// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Smallest and largest value of every channel in every brick of a packed image.
 *
 * Brick (i, j, k) holds the texels that a linearly interpolated sample between the centres of
 * texels S i and S (i + 1) can touch: S + 1 along each axis, the last ones shared with the next
 * brick. S is 4, or the next power of two that makes at most LargestNumberOfBricks, so that finding
 * the active ones takes the same few milliseconds for large volumes. NaN does not count; a channel
 * without any other value in a brick has Minimum > Maximum there. Bricks at the far end may be
 * smaller.
 *
 * Threaded; one pass over the values. Memory: 32 bytes a brick: 0.5 bytes a voxel up to 320^3
 * voxels, at most 16 MB.
 */

#ifndef vtkTFCBrickRanges_h
#define vtkTFCBrickRanges_h

#include "vtkTFCVolumeModule.h" // For export macro

#include "vtkType.h" // For vtkIdType

#include <array>  // For sizes
#include <vector> // For the bricks

class VTKTFCVOLUME_EXPORT vtkTFCBrickRanges
{
public:
  static constexpr vtkIdType LargestNumberOfBricks = 1 << 19;
  static constexpr int MaximumNumberOfChannels = 4;

  struct Range
  {
    std::array<float, MaximumNumberOfChannels> Minimum;
    std::array<float, MaximumNumberOfChannels> Maximum;
  };

  /// Of `channels` (at most MaximumNumberOfChannels) interleaved values per texel.
  void Compute(const float* values, const std::array<int, 3>& texels, int channels);

  /// S: texels from one brick to the next.
  int GetBrickSize() const { return this->BrickSize; }
  /// Number of bricks along each axis.
  const std::array<int, 3>& GetDimensions() const { return this->Dimensions; }
  /// x fastest.
  const std::vector<Range>& GetRanges() const { return this->Ranges; }

private:
  int BrickSize = 4;
  std::array<int, 3> Dimensions = { 0, 0, 0 };
  std::vector<Range> Ranges;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCBrickRanges.h
