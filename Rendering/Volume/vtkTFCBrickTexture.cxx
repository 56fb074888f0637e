// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCBrickTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
bool vtkTFCBrickTexture::Upload(vtkOpenGLRenderWindow* context,
  const std::vector<unsigned char>& distances, const std::array<int, 3>& dimensions,
  unsigned int generation)
{
  if (this->IsIn(context) && this->Generation == generation)
  {
    return true;
  }
  const bool created = this->CreateBytes(context, dimensions, distances.data());
  this->SetFilter(vtkTextureObject::Nearest);
  this->Generation = created ? generation : 0;
  return created;
}
