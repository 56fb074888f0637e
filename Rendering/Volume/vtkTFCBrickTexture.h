// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Keeps the distances of vtkTFCBrickDistances in a 3D texture of one OpenGL context.
 *
 * One byte a brick, not filtered. One texture unit, only while active.
 */

#ifndef vtkTFCBrickTexture_h
#define vtkTFCBrickTexture_h

#include "vtkTFCTexture3D.h"

#include <array>  // For sizes
#include <vector> // For the distances

class vtkOpenGLRenderWindow;

class vtkTFCBrickTexture : public vtkTFCTexture3D
{
public:
  /// Upload `distances` when `generation` differs from the last upload or the context has changed.
  /// The context must be current. Returns false when the driver refuses.
  bool Upload(vtkOpenGLRenderWindow* context, const std::vector<unsigned char>& distances,
    const std::array<int, 3>& dimensions, unsigned int generation);

private:
  unsigned int Generation = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCBrickTexture.h
