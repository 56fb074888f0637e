// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCGraphicsSupport.h"

#include "vtkTFCRayCastMapper.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"
#include "vtkVolume.h"

//------------------------------------------------------------------------------
vtkTFCGraphicsSupport vtkTFCGraphicsSupport::Probe(vtkRenderWindow* window, vtkVolume* vol)
{
  vtkTFCGraphicsSupport support;
  auto* context = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!context)
  {
    return support;
  }
  context->MakeCurrent();
  int version[2] = { 0, 0 };
  context->GetOpenGLVersion(version[0], version[1]);
  support.HasOpenGL = version[0] > 3 || (version[0] == 3 && version[1] >= 2);
  vtkNew<vtkTFCRayCastMapper> mapper;
  vtkGPUVolumeRayCastMapper* asked = mapper; // public there, protected in VTK's OpenGL class
  support.HasVolumes = asked->IsRenderSupported(window, vol->GetProperty()) != 0;
  support.LongestTextureSide = vtkTextureObject::GetMaximumTextureSize3D(context);
  support.TextureUnits = context->GetTextureUnitManager()->GetNumberOfTextureUnits();
  return support;
}

//------------------------------------------------------------------------------
std::string vtkTFCGraphicsSupport::FindMissing() const
{
  if (!this->HasOpenGL)
  {
    return "the window has no OpenGL 3.2";
  }
  if (!this->HasVolumes)
  {
    return "the graphics driver does not support volume rendering";
  }
  if (this->LongestTextureSide < NeededTextureSide)
  {
    return "the graphics driver has 3D textures of at most " +
      std::to_string(this->LongestTextureSide) + " texels a side, and " +
      std::to_string(NeededTextureSide) + " are needed";
  }
  if (this->TextureUnits < NeededTextureUnits)
  {
    return "the graphics driver has " + std::to_string(this->TextureUnits) +
      " texture units, and " + std::to_string(NeededTextureUnits) + " are needed";
  }
  return "";
}
