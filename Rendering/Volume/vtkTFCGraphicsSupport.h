// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a render window's OpenGL has of what vtkTFCRayCastMapper needs.
 *
 * VTK itself draws with OpenGL 3.2, which guarantees 3D textures of 256 texels a side and 16
 * texture units; software and remote drivers do not always keep to it.
 */

#ifndef vtkTFCGraphicsSupport_h
#define vtkTFCGraphicsSupport_h

#include "vtkTFCVolumeModule.h" // For export macro

#include <string> // For what is missing

class vtkRenderWindow;
class vtkVolume;

struct VTKTFCVOLUME_EXPORT vtkTFCGraphicsSupport
{
  /// Seven of VTK's (volume, depth, noise, two functions, coordinates, blanking) and four of ours.
  static constexpr int NeededTextureUnits = 11;
  static constexpr int NeededTextureSide = 64;

  bool HasOpenGL = false;     ///< a window of VTK's OpenGL, version 3.2 or later
  bool HasVolumes = false;    ///< vtkGPUVolumeRayCastMapper::IsRenderSupported()
  int LongestTextureSide = 0; ///< of 3D textures
  int TextureUnits = 0;       ///< of the fragment shader

  /// What `window` has for `vol`. Makes the window's context current.
  static vtkTFCGraphicsSupport Probe(vtkRenderWindow* window, vtkVolume* vol);

  /// What is missing as the end of a sentence, or an empty string.
  std::string FindMissing() const;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCGraphicsSupport.h
