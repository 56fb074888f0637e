// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Keeps the brick distances of vtkTFCBrickActivity in a 3D texture of one OpenGL context.
 *
 * One byte a brick, not filtered. One texture unit, only while active.
 */

#ifndef vtkTFCBrickTexture_h
#define vtkTFCBrickTexture_h

#include "vtkSmartPointer.h" // For the texture

#include <array>  // For sizes
#include <vector> // For the distances

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkTFCBrickTexture
{
public:
  vtkTFCBrickTexture();
  ~vtkTFCBrickTexture();

  /// Upload `distances` when `generation` differs from the last upload or the context has changed.
  /// The context must be current. Returns false when the driver refuses.
  bool Upload(vtkOpenGLRenderWindow* context, const std::vector<unsigned char>& distances,
    const std::array<int, 3>& dimensions, unsigned int generation);

  void Activate();
  void Deactivate();
  /// Texture unit while active.
  int GetTextureUnit();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkTextureObject> Texture;
  unsigned int Generation = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCBrickTexture.h
