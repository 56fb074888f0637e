// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which settings of VTK's volume mappers a combined transfer function is not drawn with.
 *
 * Texts for the user: what is wrong and what to do, or empty.
 */

#ifndef vtkTFCSettingsCheck_h
#define vtkTFCSettingsCheck_h

#include <string> // For the texts

class vtkMultiBlockVolumeMapper;
class vtkVolumeProperty;

namespace vtkTFCSettingsCheck
{

/// Why nothing can be drawn in `blocks` blocks, of a dataset that is `distributed` over processes
/// or not: more than 16 clipping planes, a blend mode that is not known, lacks its plane or needs
/// whole rays.
std::string FindError(vtkMultiBlockVolumeMapper* mapper, vtkVolumeProperty* property, int blocks,
  bool distributed);

/// The same for the CPU, which draws one block with composite blending, in one process.
std::string FindErrorOnCPU(vtkMultiBlockVolumeMapper* mapper, int blocks, bool distributed);

/// What is left out of the picture: volumetric scattering, and on the CPU the `shadingArray`; or is
/// wrong in it: the order of `peeledBlocks` blocks that take part in depth peeling.
std::string FindOmission(vtkMultiBlockVolumeMapper* mapper, bool onCPU,
  const std::string& shadingArray, int peeledBlocks);

}

#endif
// VTK-HeaderTest-Exclude: vtkTFCSettingsCheck.h
