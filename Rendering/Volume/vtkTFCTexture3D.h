// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A 3D texture in one OpenGL context: what the mapper's own have in common.
 *
 * One texture unit, only while active. Derived classes say what is in it and when it is outdated.
 */

#ifndef vtkTFCTexture3D_h
#define vtkTFCTexture3D_h

#include "vtkSmartPointer.h" // For the texture

#include <array>   // For sizes
#include <cstdint> // For values

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

  ///@{
  /// Make it from bytes, one channel, or from floats or half floats, four channels, x fastest;
  /// outside of it its border repeats. The context must be current. Returns false when the driver
  /// refuses.
  bool CreateBytes(vtkOpenGLRenderWindow* context, const std::array<int, 3>& texels,
    const std::uint8_t* values);
  bool CreateFloats(vtkOpenGLRenderWindow* context, const std::array<int, 3>& texels,
    const float* values);
  bool CreateHalfFloats(vtkOpenGLRenderWindow* context, const std::array<int, 3>& texels,
    const std::uint16_t* values);
  ///@}

  /// A filter of vtkTextureObject.
  void SetFilter(int filter);

private:
  void Prepare(vtkOpenGLRenderWindow* context);

  vtkSmartPointer<vtkTextureObject> Texture;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCTexture3D.h
