// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTextureLimit.h"

#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

#include <vector>

namespace
{

//------------------------------------------------------------------------------
vtkImageData* FindLargestImage(vtkDataObject* data)
{
  if (!vtkCompositeDataSet::SafeDownCast(data))
  {
    return vtkImageData::SafeDownCast(data);
  }
  vtkImageData* largest = nullptr;
  for (vtkDataSet* part : vtkCompositeDataSet::GetDataSets<vtkDataSet>(data))
  {
    auto* image = vtkImageData::SafeDownCast(part);
    if (image && (!largest || image->GetNumberOfPoints() > largest->GetNumberOfPoints()))
    {
      largest = image;
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
bool TakesTexture(const int size[3], int channels)
{
  glTexImage3D(GL_PROXY_TEXTURE_3D, 0, channels > 2 ? GL_RGBA32F : GL_RG32F, size[0], size[1],
    size[2], 0, channels > 2 ? GL_RGBA : GL_RG, GL_FLOAT, nullptr);
  GLint width = 0;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &width);
  // Some drivers report what is too large as an error as well.
  while (glGetError() != GL_NO_ERROR)
  {
  }
  return width > 0;
}

}

//------------------------------------------------------------------------------
int vtkTFCTextureLimit::FindLongestSide(vtkOpenGLRenderWindow* window)
{
  return vtkTextureObject::GetMaximumTextureSize3D(window);
}

//------------------------------------------------------------------------------
vtkIdType vtkTFCTextureLimit::FindMostVoxels(vtkOpenGLRenderWindow* window, vtkDataObject* data,
  int channels)
{
  vtkImageData* image = FindLargestImage(data);
  const int longest = FindLongestSide(window);
  if (!image || image->GetNumberOfPoints() < 1)
  {
    return VTK_ID_MAX;
  }
  int size[3];
  image->GetDimensions(size);
  if (size[0] > longest || size[1] > longest)
  {
    return VTK_ID_MAX; // cut along these sides as well, which makes small pieces
  }
  const int whole = size[2];
  size[2] = whole < longest ? whole : longest;
  while (size[2] > 8 && !TakesTexture(size, channels))
  {
    size[2] /= 2;
  }
  // A slab has three layers more than its part of the image.
  return size[2] == whole ? VTK_ID_MAX : static_cast<vtkIdType>(size[0]) * size[1] * (size[2] - 3);
}
