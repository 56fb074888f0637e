// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTexture3D.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
vtkTFCTexture3D::vtkTFCTexture3D() = default;

//------------------------------------------------------------------------------
vtkTFCTexture3D::~vtkTFCTexture3D() = default;

//------------------------------------------------------------------------------
bool vtkTFCTexture3D::IsIn(vtkOpenGLRenderWindow* context) const
{
  return this->Texture && this->Texture->GetContext() == context && this->Texture->GetHandle() != 0;
}

//------------------------------------------------------------------------------
bool vtkTFCTexture3D::Create(vtkOpenGLRenderWindow* context, const std::array<int, 3>& texels,
  int dataType, const void* values)
{
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Texture->SetContext(context);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  // Create3DFromRaw() takes a non-const pointer and only reads.
  return this->Texture->Create3DFromRaw(static_cast<unsigned int>(texels[0]),
    static_cast<unsigned int>(texels[1]), static_cast<unsigned int>(texels[2]), 1, dataType,
    const_cast<void*>(values));
}

//------------------------------------------------------------------------------
void vtkTFCTexture3D::SetFilter(int filter)
{
  this->Texture->SetMinificationFilter(filter);
  this->Texture->SetMagnificationFilter(filter);
}

//------------------------------------------------------------------------------
void vtkTFCTexture3D::Activate()
{
  this->Texture->Activate();
}

//------------------------------------------------------------------------------
void vtkTFCTexture3D::Deactivate()
{
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
int vtkTFCTexture3D::GetTextureUnit()
{
  return this->Texture->GetTextureUnit();
}

//------------------------------------------------------------------------------
void vtkTFCTexture3D::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}
