// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCPrimaryTexture.h"

#include "vtkTFCThreads.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <vector>

//------------------------------------------------------------------------------
bool vtkTFCPrimaryTexture::Upload(vtkOpenGLRenderWindow* context, vtkFloatArray* packed,
  const std::array<int, 3>& texels, bool linear)
{
  const bool current =
    this->IsIn(context) && this->Source == packed && this->SourceTime == packed->GetMTime();
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
    this->Source = nullptr;
    if (!this->Create(context, texels, VTK_FLOAT, values.data()))
    {
      return false;
    }
    this->Source = packed;
    this->SourceTime = packed->GetMTime();
  }
  this->SetFilter(linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest);
  return true;
}
