// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The primary attribute alone as a 3D float texture of one OpenGL context, for gradients.
 *
 * A gradient takes six fetches; of the packed texture each would bring all channels. Only made when
 * there is shading. Memory: 4 bytes a voxel on the GPU, and on the CPU during the upload.
 */

#ifndef vtkTFCPrimaryTexture_h
#define vtkTFCPrimaryTexture_h

#include "vtkTFCTexture3D.h"
#include "vtkType.h" // For vtkMTimeType

#include <array> // For sizes

class vtkFloatArray;
class vtkOpenGLRenderWindow;

class vtkTFCPrimaryTexture : public vtkTFCTexture3D
{
public:
  /// Upload the first component of `packed`, as many tuples as `texels` says, when it or the
  /// context has changed. The context must be current. Returns false when the driver refuses.
  bool Upload(vtkOpenGLRenderWindow* context, vtkFloatArray* packed,
    const std::array<int, 3>& texels, bool linear);

private:
  vtkFloatArray* Source = nullptr; // only compared
  vtkMTimeType SourceTime = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCPrimaryTexture.h
