// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Keeps the texels of vtkTFCShaderTables in a buffer texture of one OpenGL context.
 *
 * Not filtered: the shader reads single texels by their number. One texture unit, only while
 * active.
 */

#ifndef vtkTFCTableTexture_h
#define vtkTFCTableTexture_h

#include "vtkSmartPointer.h" // For the texture

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;
struct vtkTFCShaderTables;

class vtkTFCTableTexture
{
public:
  vtkTFCTableTexture();
  ~vtkTFCTableTexture();

  /// Upload `tables` when `generation` differs from the last upload or the context has changed.
  /// The context must be current. Returns false when the texture would exceed the context's limit.
  bool Upload(vtkOpenGLRenderWindow* context, const vtkTFCShaderTables& tables,
    unsigned int generation);

  void Activate();
  void Deactivate();
  /// Texture unit while active.
  int GetTextureUnit();
  /// Number of uploads since construction.
  int GetNumberOfUploads() const { return this->NumberOfUploads; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkSmartPointer<vtkOpenGLBufferObject> Buffer; // what the texture reads
  unsigned int Generation = 0;
  int NumberOfUploads = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCTableTexture.h
