// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What every attribute shares with two others, and adds to them, over all processes.
 */

#ifndef vtkTFCAttributeInformation_h
#define vtkTFCAttributeInformation_h

#include "Kernels/TFCInformation.h"
#include "vtkTFCAttributeStatistics.h"

#include <vector>

class vtkAlgorithm;
class vtkTFCAttributeSamples;
class vtkTFCDistributedImage;

namespace vtkTFCAttributeInformation
{
/**
 * Collective. One threaded pass, in integers: the result depends on neither threads nor processes.
 * The axes are the attributes `primary` and `secondary`, -1 for no secondary one; histograms reach
 * from minimum to maximum of each attribute and count the samples where all three have data. For
 * the axes themselves nothing is computed. Memory: 256 KiB per attribute and thread at 32 bins.
 * Returns false when aborted.
 */
bool Compute(const vtkTFCAttributeSamples& samples, const vtkTFCDistributedImage& image,
  const std::vector<vtkTFCAttributeStatistics::Summary>& summaries, int primary, int secondary,
  vtkAlgorithm* owner, std::vector<tfc::Information>& result);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributeInformation.h
