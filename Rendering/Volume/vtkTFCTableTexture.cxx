// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTableTexture.h"

#include "vtkTFCShaderTables.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

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
  const auto rows = static_cast<int>(tables.Texels.size() / vtkTFCShaderTables::RowLength);
  if (rows > vtkTextureObject::GetMaximumTextureSize(context))
  {
    return false;
  }
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Texture->SetContext(context);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  // Create2DFromRaw() takes a non-const pointer and only reads.
  void* data = const_cast<float*>(tables.Texels.front().data());
  if (!this->Texture->Create2DFromRaw(vtkTFCShaderTables::RowLength,
        static_cast<unsigned int>(rows), 4, VTK_FLOAT, data))
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
  }
}
