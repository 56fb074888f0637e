// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gradients of an attribute as a 3D texture of one OpenGL context, for shading.
 *
 * Central differences over a voxel to each side, one-sided at the border of the image and beside a
 * voxel without data, 0 where both neighbours are missing. In between, the interpolated gradient is
 * that of the interpolated attribute. One fetch instead of six, which is what shading costs.
 *
 * Channels: the derivatives along x, y and z of texture coordinates in common, arbitrary units, as
 * half floats (relative error 5e-4): light needs the direction only. Only made when there is
 * shading. Memory: 8 bytes a voxel on the GPU, and on the CPU during the upload. Cost: one pass
 * over the image, threaded.
 */

#ifndef vtkTFCGradientTexture_h
#define vtkTFCGradientTexture_h

#include "vtkTFCTexture3D.h"
#include "vtkTFCVolumeModule.h" // For export macro
#include "vtkType.h"            // For vtkMTimeType

#include <array>   // For sizes
#include <cstdint> // For half floats
#include <vector>  // For the texels

class vtkFloatArray;
class vtkOpenGLRenderWindow;

class vtkTFCGradientTexture : public vtkTFCTexture3D
{
public:
  /// Upload the gradients of the first component of `packed`, which has values from 0 to 1 and as
  /// many tuples as `texels` says, when it or the context has changed. The context must be current.
  /// Returns false when the driver refuses.
  bool Upload(vtkOpenGLRenderWindow* context, vtkFloatArray* packed,
    const std::array<int, 3>& texels, bool linear);

  /// The texels, four half floats each, of which the last is 0. `channels`: floats per tuple.
  VTKTFCVOLUME_EXPORT static std::vector<std::uint16_t> MakeTexels(const float* packed,
    int channels, const std::array<int, 3>& texels);

private:
  vtkFloatArray* Source = nullptr; // only compared
  vtkMTimeType SourceTime = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCGradientTexture.h
