// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The images that a volume mapper draws one after the other.
 *
 * An input is an image, a rectilinear grid, or any composite of them. Rectilinear grids are
 * resampled to images with the grid's smallest spacing along each axis, or a larger one where that
 * would be more than eight times as many points. An image that is too large for one texture, or for
 * the memory it may take, is cut into pieces: slabs along z first, which share the arrays of the
 * image, and along the other axes, which are copies, only where a side is too long for a texture.
 * Pieces overlap by a layer of voxels, for interpolation and gradients; Drawn says which part each
 * draws.
 *
 * Blocks are made anew only when an array, a grid or a limit has changed, so that what is on the
 * GPU stays there.
 */

#ifndef vtkTFCImageBlocks_h
#define vtkTFCImageBlocks_h

#include "vtkTFCCompiledModel.h" // For vtkTFCAttribute
#include "vtkTFCVolumeModule.h"  // For export macro

#include "vtkSmartPointer.h" // For images
#include "vtkType.h"         // For vtkIdType

#include <array>  // For extents
#include <string> // For errors
#include <vector> // For blocks

class vtkDataObject;
class vtkDataSet;
class vtkImageData;

class VTKTFCVOLUME_EXPORT vtkTFCImageBlocks
{
public:
  struct Block
  {
    vtkSmartPointer<vtkImageData> Image;
    std::array<int, 6> Drawn; ///< part of the image's point extent
  };

  struct Limits
  {
    int LongestSide = VTK_INT_MAX;     ///< of a texture, in voxels
    vtkIdType MostVoxels = VTK_ID_MAX; ///< of a block without its overlap
  };

  /**
   * The blocks of `input` with the arrays that `attributes` names. `error` is set when the input,
   * or a part of it, cannot be drawn; the blocks are what can.
   */
  const std::vector<Block>& Update(vtkDataObject* input,
    const std::vector<vtkTFCAttribute>& attributes, const Limits& limits, std::string& error);

  const std::vector<Block>& GetBlocks() const { return this->Blocks; }
  /// Grows whenever the blocks are made anew.
  unsigned int GetGeneration() const { return this->Generation; }

private:
  std::vector<Block> Blocks;
  std::string Fingerprint;
  unsigned int Generation = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCImageBlocks.h
