// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Four more attributes as a 3D float texture of one OpenGL context.
 *
 * VTK's mapper uploads the first four channels; this is for the others (vtkTFCAttributePacker).
 * Memory: 16 bytes a voxel on the GPU.
 */

#ifndef vtkTFCAttributeTexture_h
#define vtkTFCAttributeTexture_h

#include "vtkTFCTexture3D.h"
#include "vtkType.h" // For vtkMTimeType

#include <array> // For sizes

class vtkFloatArray;
class vtkOpenGLRenderWindow;

class vtkTFCAttributeTexture : public vtkTFCTexture3D
{
public:
  /// Upload an array of four components, as many tuples as `texels` says, when it or the context
  /// has changed. The context must be current. Returns false when the driver refuses.
  bool Upload(vtkOpenGLRenderWindow* context, vtkFloatArray* array,
    const std::array<int, 3>& texels, bool linear);

private:
  vtkFloatArray* Source = nullptr; // only compared
  vtkMTimeType SourceTime = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributeTexture.h
