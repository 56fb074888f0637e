// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributeTexture.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
bool vtkTFCAttributeTexture::Upload(vtkOpenGLRenderWindow* context, vtkFloatArray* array,
  const std::array<int, 3>& texels, bool linear)
{
  const bool current =
    this->IsIn(context) && this->Source == array && this->SourceTime == array->GetMTime();
  if (!current)
  {
    this->Source = nullptr;
    if (!this->CreateFloats(context, texels, array->GetPointer(0)))
    {
      return false;
    }
    this->Source = array;
    this->SourceTime = array->GetMTime();
  }
  this->SetFilter(linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest);
  return true;
}
