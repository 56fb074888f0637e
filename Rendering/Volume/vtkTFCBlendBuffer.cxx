// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCBlendBuffer.h"

#include "vtkTFCBlendBuffer_glsl.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include "vtk_glew.h"

//------------------------------------------------------------------------------
vtkTFCBlendBuffer::vtkTFCBlendBuffer() = default;

//------------------------------------------------------------------------------
vtkTFCBlendBuffer::~vtkTFCBlendBuffer() = default;

//------------------------------------------------------------------------------
bool vtkTFCBlendBuffer::Begin(vtkRenderer* ren)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  int size[2];
  int origin[2];
  ren->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  // Pixels keep their places in the window, so that viewports and the depth picture fit.
  const unsigned int width = origin[0] + size[0];
  const unsigned int height = origin[1] + size[1];

  this->Picture->SetContext(window);
  this->Framebuffer->SetContext(window);
  if (this->Picture->GetWidth() != width || this->Picture->GetHeight() != height ||
    !this->Picture->GetHandle())
  {
    this->Picture->ReleaseGraphicsResources(window);
    this->Picture->SetContext(window);
    this->Picture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Picture->SetMagnificationFilter(vtkTextureObject::Nearest);
    if (!this->Picture->Create2D(width, height, 4, VTK_FLOAT, false))
    {
      return false;
    }
  }
  // The window stays what depths are read from.
  state->PushDrawFramebufferBinding();
  this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
  this->Framebuffer->AddColorAttachment(0, this->Picture);
  this->Framebuffer->ActivateDrawBuffers(1);
  const char* description = nullptr;
  if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(vtkOpenGLFramebufferObject::GetDrawMode(),
        description))
  {
    state->PopDrawFramebufferBinding();
    return false;
  }
  state->vtkglClearColor(0.0, 0.0, 0.0, 0.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCBlendBuffer::End(vtkRenderer* ren)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  state->PopDrawFramebufferBinding();
  if (!this->Quad)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, vtkTFCBlendBuffer_glsl, "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  if (!this->Quad->Program)
  {
    return;
  }
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blending(state, GL_BLEND);
  vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->Picture->Activate();
  int size[2];
  int origin[2];
  ren->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const auto width = static_cast<float>(this->Picture->GetWidth());
  const auto height = static_cast<float>(this->Picture->GetHeight());
  const float place[2] = { static_cast<float>(origin[0]) / width,
    static_cast<float>(origin[1]) / height };
  const float extent[2] = { static_cast<float>(size[0]) / width,
    static_cast<float>(size[1]) / height };
  this->Quad->Program->SetUniformi("picture", this->Picture->GetTextureUnit());
  this->Quad->Program->SetUniform2f("origin", place);
  this->Quad->Program->SetUniform2f("size", extent);
  this->Quad->Render();
  this->Picture->Deactivate();
}

//------------------------------------------------------------------------------
void vtkTFCBlendBuffer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Picture->ReleaseGraphicsResources(window);
}
