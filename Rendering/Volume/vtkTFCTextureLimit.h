// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How large a 3D texture the graphics driver takes.
 */

#ifndef vtkTFCTextureLimit_h
#define vtkTFCTextureLimit_h

#include "vtkType.h" // For vtkIdType

class vtkDataObject;
class vtkOpenGLRenderWindow;

namespace vtkTFCTextureLimit
{
/// Longest side in voxels.
int FindLongestSide(vtkOpenGLRenderWindow* window);

/**
 * Voxels that a slab of the largest image in `data` may have as a texture of `channels` floats (2
 * or 4): halved until the driver accepts its proxy (OpenGL 3.2, section 3.8.12); VTK_ID_MAX when it
 * takes the image as a whole. The window must be current.
 */
vtkIdType FindMostVoxels(vtkOpenGLRenderWindow* window, vtkDataObject* data, int channels);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCTextureLimit.h
