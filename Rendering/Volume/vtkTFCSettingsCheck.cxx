// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCSettingsCheck.h"

#include "vtkTFCRayCastMapper.h"

#include "vtkMultiBlockVolumeMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkVolumeProperty.h"

//------------------------------------------------------------------------------
std::string vtkTFCSettingsCheck::FindError(vtkMultiBlockVolumeMapper* mapper,
  vtkVolumeProperty* property, int blocks, bool distributed)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  if (planes && planes->GetNumberOfItems() > vtkTFCRayCastMapper::MaximumNumberOfClippingPlanes)
  {
    return "more than 16 clipping planes.";
  }
  switch (mapper->GetBlendMode())
  {
    case vtkVolumeMapper::COMPOSITE_BLEND:
      return "";
    case vtkVolumeMapper::SLICE_BLEND:
      return vtkPlane::SafeDownCast(property->GetSliceFunction())
        ? ""
        : "slice blending needs a vtkPlane as the SliceFunction of the volume's property.";
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
    case vtkVolumeMapper::ADDITIVE_BLEND:
      break;
    default:
      return "the blend mode must be composite, maximum, average, additive or slice; minimum and "
             "isosurface show one scalar, and a combined transfer function has several.";
  }
  if (distributed)
  {
    return "this blend mode needs whole rays, and the data is distributed over processes. Use "
           "composite blending, or run with one process.";
  }
  if (blocks > 1)
  {
    return "this blend mode needs whole rays, and the volume is drawn in " +
      std::to_string(blocks) +
      " blocks. Use composite blending, resample the blocks to one image, or raise MemoryLimit.";
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkTFCSettingsCheck::FindErrorOnCPU(vtkMultiBlockVolumeMapper* mapper, int blocks,
  bool distributed)
{
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return "on the CPU only composite blending is available. Set the blend mode to composite, or "
           "Renderer to GPU.";
  }
  if (distributed)
  {
    // ParaView's "Ray Cast Only" loses the parts of all processes but one, too (5.11).
    return "on the CPU the data must be in one process: pictures of VTK's ray caster cannot be "
           "composited over several. Set Renderer to GPU, or run with one process.";
  }
  if (blocks > 1)
  {
    return "the CPU renders a single grid, and the input has " + std::to_string(blocks) +
      ". Resample them to one image, show one of them, or set Renderer to GPU.";
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkTFCSettingsCheck::FindOmission(vtkMultiBlockVolumeMapper* mapper, bool onCPU,
  const std::string& shadingArray, int peeledBlocks)
{
  if (peeledBlocks > 1)
  {
    // vtkDualDepthPeelingPass takes the maximum of all volumes between two layers.
    return "VTK's depth peeling cannot tell which of the " + std::to_string(peeledBlocks) +
      " blocks of this volume is in front; where they cover each other the picture is wrong. "
      "Switch off UseDepthPeelingForVolumes, raise MemoryLimit, or resample to one image.";
  }
  if (mapper->GetVolumetricScatteringBlending() > 0.0f)
  {
    return "volumetric scattering is not available for a combined transfer function, and is left "
           "out. Set VolumetricScatteringBlending to 0 to be rid of this message.";
  }
  if (onCPU && !shadingArray.empty())
  {
    return "on the CPU, shading is by the gradient of the opacity; the ShadingArray '" +
      shadingArray + "' is not used.";
  }
  return "";
}
