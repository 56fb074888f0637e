// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The attributes of a transfer function as one float image for the GPU.
 *
 * One fetch of the packed texture gives the primary and the secondary attribute, in the first two
 * channels, and up to two tertiary attributes. There are two channels, or four with a tertiary. Up
 * to four tertiary attributes more are in a second array, for a texture of its own.
 * Values are stored as (value - Offset) / Scale with the finite range of the array in this block,
 * in double precision before rounding to float, so that any scalar type and any offset keeps 24
 * bits of its own range. Offset and Scale are undone exactly in the tables: a block's range is not
 * visible.
 *
 * - Point or cell data, whichever holds the attributes; all of them in the same.
 * - NaN stays NaN and makes every interpolated value it touches NaN, which is in no region. Blanked
 *   points (HIDDENPOINT) and, for cell data, blanked cells (HIDDENCELL) become NaN. For point data
 *   with blanked cells the packed image carries a ghost array that VTK's shader honours.
 * - Ghost cells (DUPLICATECELL) are kept, for gradients at the border; OwnedExtent says what to
 * draw.
 * - An axis with a single layer of voxels becomes a slab one voxel thick, centred on the layer.
 *
 * Memory: 8 bytes a voxel on the CPU (freed with the packer's image) and 8 on the GPU with two
 * channels, twice that with up to four, four times that with more.
 */

#ifndef vtkTFCAttributePacker_h
#define vtkTFCAttributePacker_h

#include "vtkTFCShaderTables.h" // For vtkTFCStoredAttribute
#include "vtkTFCVolumeModule.h" // For export macro

#include "vtkFloatArray.h"   // For arrays
#include "vtkSmartPointer.h" // For the image

#include <array>  // For ranges
#include <string> // For error messages
#include <vector> // For lists

class vtkImageData;
class vtkTFCAttributeReader;

class VTKTFCVOLUME_EXPORT vtkTFCAttributePacker
{
public:
  static constexpr int TextureChannels = 4; ///< of one texture
  static constexpr int MaximumNumberOfChannels = 8;

  /**
   * Make the image hold `attributes` of `source`. Nothing is done when it already does: the same
   * arrays, unmodified, on the same grid, and every attribute in some channel. Returns false and
   * fills `error` when an attribute is missing (the message lists the arrays there are), differs in
   * association or size, or when there are more than MaximumNumberOfChannels distinct ones.
   */
  bool Update(vtkImageData* source, const std::vector<vtkTFCAttribute>& attributes,
    std::string& error);

  /// Whether the image holds what its channels were packed from, unmodified, in `source`.
  bool IsCurrent(vtkImageData* source) const;

  /// What packing `attributes` of `source` reads, by identity and modification time: equal as long
  /// as nothing of it has changed.
  static std::string MakeFingerprint(vtkImageData* source,
    const std::vector<vtkTFCAttribute>& attributes);

  /// The packed image: same geometry as the source but for one-voxel-thick axes. Null before
  /// Update().
  vtkImageData* GetImage() const { return this->Image; }
  /// Channels 4 to 7 of the image's texels; null where there are no more than four.
  vtkFloatArray* GetMore() const { return this->More; }
  /// Whether the attributes are cell data.
  bool IsCellData() const { return this->CellData; }
  /// The part of the image's point extent that this block draws: without ghost cells.
  const int* GetOwnedExtent() const { return this->OwnedExtent; }
  /// Finite values of axis 0 or 1; (1, 0) where there are none.
  std::array<double, 2> GetRange(int axis) const { return this->AxisRanges[axis]; }
  /// How attribute i of the last Update() is stored.
  const std::vector<vtkTFCStoredAttribute>& GetStored() const { return this->Stored; }
  /// Grows whenever Image is packed anew.
  unsigned int GetGeneration() const { return this->Generation; }

private:
  bool MapToChannels(const std::vector<vtkTFCAttribute>& attributes);
  void CopyGeometry(vtkImageData* source);

  vtkSmartPointer<vtkFloatArray> Pack(const vtkTFCAttributeReader& reader, int first, int channels,
    vtkImageData* source);

  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkFloatArray> More;
  std::string Fingerprint; // of the grid and the arrays in Channels, as packed
  std::vector<vtkTFCAttribute> Channels;
  std::vector<vtkTFCStoredAttribute> ChannelStorage;
  std::vector<vtkTFCStoredAttribute> Stored;
  std::array<std::array<double, 2>, 2> AxisRanges = {};
  int OwnedExtent[6] = { 0, -1, 0, -1, 0, -1 };
  bool CellData = false;
  unsigned int Generation = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributePacker.h
