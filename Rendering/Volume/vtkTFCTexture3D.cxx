// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTexture3D.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

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
void vtkTFCTexture3D::Prepare(vtkOpenGLRenderWindow* context)
{
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Texture->SetContext(context);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
}

//------------------------------------------------------------------------------
bool vtkTFCTexture3D::CreateBytes(vtkOpenGLRenderWindow* context, const std::array<int, 3>& texels,
  const std::uint8_t* values)
{
  this->Prepare(context);
  // Create3DFromRaw() takes a non-const pointer and only reads.
  return this->Texture->Create3DFromRaw(static_cast<unsigned int>(texels[0]),
    static_cast<unsigned int>(texels[1]), static_cast<unsigned int>(texels[2]), 1,
    VTK_UNSIGNED_CHAR, const_cast<std::uint8_t*>(values));
}

//------------------------------------------------------------------------------
bool vtkTFCTexture3D::CreateFloats(vtkOpenGLRenderWindow* context, const std::array<int, 3>& texels,
  const float* values)
{
  this->Prepare(context);
  return this->Texture->Create3DFromRaw(static_cast<unsigned int>(texels[0]),
    static_cast<unsigned int>(texels[1]), static_cast<unsigned int>(texels[2]), 4, VTK_FLOAT,
    const_cast<float*>(values));
}

//------------------------------------------------------------------------------
bool vtkTFCTexture3D::CreateHalfFloats(vtkOpenGLRenderWindow* context,
  const std::array<int, 3>& texels, const std::uint16_t* values)
{
  this->Prepare(context);
  // VTK has no type of its own for half floats; what is set is not asked of the type.
  this->Texture->SetDataType(GL_HALF_FLOAT);
  this->Texture->SetInternalFormat(GL_RGBA16F);
  this->Texture->SetFormat(GL_RGBA);
  return this->Texture->Create3DFromRaw(static_cast<unsigned int>(texels[0]),
    static_cast<unsigned int>(texels[1]), static_cast<unsigned int>(texels[2]), 4, VTK_FLOAT,
    const_cast<std::uint16_t*>(values));
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
