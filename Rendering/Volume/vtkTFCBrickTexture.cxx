// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCBrickTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
vtkTFCBrickTexture::vtkTFCBrickTexture() = default;

//------------------------------------------------------------------------------
vtkTFCBrickTexture::~vtkTFCBrickTexture() = default;

//------------------------------------------------------------------------------
bool vtkTFCBrickTexture::Upload(vtkOpenGLRenderWindow* context,
  const std::vector<unsigned char>& distances, const std::array<int, 3>& dimensions,
  unsigned int generation)
{
  if (this->Texture && this->Texture->GetContext() == context && this->Texture->GetHandle() != 0 &&
    this->Generation == generation)
  {
    return true;
  }
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Texture->SetContext(context);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  // Create3DFromRaw() takes a non-const pointer and only reads.
  void* data = const_cast<unsigned char*>(distances.data());
  const bool created = this->Texture->Create3DFromRaw(static_cast<unsigned int>(dimensions[0]),
    static_cast<unsigned int>(dimensions[1]), static_cast<unsigned int>(dimensions[2]), 1,
    VTK_UNSIGNED_CHAR, data);
  this->Generation = created ? generation : 0;
  return created;
}

//------------------------------------------------------------------------------
void vtkTFCBrickTexture::Activate()
{
  this->Texture->Activate();
}

//------------------------------------------------------------------------------
void vtkTFCBrickTexture::Deactivate()
{
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
int vtkTFCBrickTexture::GetTextureUnit()
{
  return this->Texture->GetTextureUnit();
}

//------------------------------------------------------------------------------
void vtkTFCBrickTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}
