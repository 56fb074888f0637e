// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A picture in 32-bit floats that the blocks of a volume are blended into, one by one.
 *
 * A window has 8 bits a channel and rounds after each block: with many blocks, one behind the
 * other, thin fog is lost. Between Begin() and End() drawing goes into this buffer; End() blends it
 * over the window once. Colours are multiplied by their opacity. It has no depth buffer: rays end
 * at opaque geometry by themselves. Memory on the GPU: 16 bytes a pixel.
 */

#ifndef vtkTFCBlendBuffer_h
#define vtkTFCBlendBuffer_h

#include "vtkNew.h" // For the texture

#include <memory> // For the quad

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

class vtkTFCBlendBuffer
{
public:
  vtkTFCBlendBuffer();
  ~vtkTFCBlendBuffer();

  /// Returns false, with nothing changed, where the driver cannot draw into such a picture.
  bool Begin(vtkRenderer* ren);
  void End(vtkRenderer* ren);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkTFCBlendBuffer(const vtkTFCBlendBuffer&) = delete;
  void operator=(const vtkTFCBlendBuffer&) = delete;

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Picture;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCBlendBuffer.h
