// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCPrimaryTexture.h"

#include "vtkTFCThreads.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <vector>

//------------------------------------------------------------------------------
vtkTFCPrimaryTexture::vtkTFCPrimaryTexture() = default;

//------------------------------------------------------------------------------
vtkTFCPrimaryTexture::~vtkTFCPrimaryTexture() = default;

//------------------------------------------------------------------------------
bool vtkTFCPrimaryTexture::Upload(vtkOpenGLRenderWindow* context, vtkFloatArray* packed,
  const std::array<int, 3>& texels, bool linear)
{
  const bool current = this->Texture && this->Texture->GetContext() == context &&
    this->Texture->GetHandle() != 0 && this->Source == packed &&
    this->SourceTime == packed->GetMTime();
  if (!current)
  {
    const vtkIdType count = packed->GetNumberOfTuples();
    const int channels = packed->GetNumberOfComponents();
    const float* from = packed->GetPointer(0);
    std::vector<float> values(count);
    vtkTFCThreads::For(0, count, 65536,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          values[i] = from[channels * i];
        }
      });
    if (!this->Texture)
    {
      this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    }
    this->Texture->SetContext(context);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
    this->Source = nullptr;
    if (!this->Texture->Create3DFromRaw(static_cast<unsigned int>(texels[0]),
          static_cast<unsigned int>(texels[1]), static_cast<unsigned int>(texels[2]), 1, VTK_FLOAT,
          values.data()))
    {
      return false;
    }
    this->Source = packed;
    this->SourceTime = packed->GetMTime();
  }
  const int filter = linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  this->Texture->SetMinificationFilter(filter);
  this->Texture->SetMagnificationFilter(filter);
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCPrimaryTexture::Activate()
{
  this->Texture->Activate();
}

//------------------------------------------------------------------------------
void vtkTFCPrimaryTexture::Deactivate()
{
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
int vtkTFCPrimaryTexture::GetTextureUnit()
{
  return this->Texture->GetTextureUnit();
}

//------------------------------------------------------------------------------
void vtkTFCPrimaryTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}
