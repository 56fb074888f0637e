// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The values of an array that is not packed, for shading by its gradient.
 *
 * One float per texel of the packed attributes, (value - least) / (greatest - least) with the
 * finite range in the block, as vtkTFCGradientTexture wants them; NaN and blanked values stay NaN.
 * Memory: 4 bytes a voxel. Cost: one threaded pass, when the array has changed.
 */

#ifndef vtkTFCShadingValues_h
#define vtkTFCShadingValues_h

#include "vtkSmartPointer.h" // For the values

#include <array>  // For sizes
#include <string> // For names

class vtkFloatArray;
class vtkImageData;

class vtkTFCShadingValues
{
public:
  /// Take component 0 of the array with this name, of the same kind (points or cells) as the packed
  /// attributes, which have `texels`: those of `source` but for single layers, which are two. An
  /// empty name stands for no array. Returns false with `error`, and no values, when there is none.
  bool Update(vtkImageData* source, const std::string& name, bool cells,
    const std::array<int, 3>& texels, std::string& error);

  /// Null without an array.
  vtkFloatArray* Get() const { return this->Values; }

private:
  vtkSmartPointer<vtkFloatArray> Values;
  std::string Fingerprint;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCShadingValues.h
