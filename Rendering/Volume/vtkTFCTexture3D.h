// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A 3D texture with one channel in one OpenGL context: what the mapper's own have in common.
 *
 * One texture unit, only while active. Derived classes say what is in it and when it is outdated.
 */

#ifndef vtkTFCTexture3D_h
#define vtkTFCTexture3D_h

#include "vtkSmartPointer.h" // For the texture

#include <array> // For sizes

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkTFCTexture3D
{
public:
  void Activate();
  void Deactivate();
  /// Texture unit while active.
  int GetTextureUnit();

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkTFCTexture3D();
  ~vtkTFCTexture3D();

  /// Whether there is a texture in this context.
  bool IsIn(vtkOpenGLRenderWindow* context) const;

  /// Make it from values of a VTK type, x fastest; outside of it its border repeats. The context
  /// must be current. Returns false when the driver refuses.
  bool Create(vtkOpenGLRenderWindow* context, const std::array<int, 3>& texels, int dataType,
    const void* values);

  /// A filter of vtkTextureObject.
  void SetFilter(int filter);

private:
  vtkSmartPointer<vtkTextureObject> Texture;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCTexture3D.h
