// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTableTexture.h"

#include "vtkTFCShaderTables.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

//------------------------------------------------------------------------------
vtkTFCTableTexture::vtkTFCTableTexture() = default;

//------------------------------------------------------------------------------
vtkTFCTableTexture::~vtkTFCTableTexture() = default;

//------------------------------------------------------------------------------
bool vtkTFCTableTexture::Upload(vtkOpenGLRenderWindow* context, const vtkTFCShaderTables& tables,
  unsigned int generation)
{
  if (this->Texture && this->Texture->GetContext() == context && this->Texture->GetHandle() != 0 &&
    this->Generation == generation)
  {
    return true;
  }
  const auto count = static_cast<unsigned int>(tables.Texels.size());
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
  if (count > static_cast<unsigned int>(largest))
  {
    return false;
  }
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Buffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
    this->Buffer->SetType(vtkOpenGLBufferObject::TextureBuffer);
  }
  this->Texture->SetContext(context);
  if (!this->Buffer->Upload(tables.Texels.front().data(), 4 * static_cast<size_t>(count),
        vtkOpenGLBufferObject::TextureBuffer) ||
    !this->Texture->CreateTextureBuffer(count, 4, VTK_FLOAT, this->Buffer))
  {
    return false;
  }
  this->Generation = generation;
  ++this->NumberOfUploads;
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCTableTexture::Activate()
{
  this->Texture->Activate();
}

//------------------------------------------------------------------------------
void vtkTFCTableTexture::Deactivate()
{
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
int vtkTFCTableTexture::GetTextureUnit()
{
  return this->Texture->GetTextureUnit();
}

//------------------------------------------------------------------------------
void vtkTFCTableTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
    this->Buffer->ReleaseGraphicsResources();
    this->Buffer = nullptr;
  }
}
