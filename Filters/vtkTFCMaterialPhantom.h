// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCMaterialPhantom
 * @brief The paper's synthetic volume with the truth beside it.
 *
 * Output: vtkImageData with origin 0 and spacing 1 and the point arrays
 * - `intensity` (float): mean of the material plus noise, not clamped;
 * - `material` (unsigned char, 0..5): 0 environment, 1 outer hull, 2 filling, 3 to 5 the spheres A,
 * B and C (see Kernels/TFCPhantom.h for geometry, means and deviations).
 *
 * The cube [-1, 1]^3 of the geometry covers the volume: sample i of n lies at 2 (i + 0.5) / n - 1.
 * Any part of the extent can be requested, and every sample is the same for any part, thread count
 * or number of processes. Threaded; two logarithms, roots and cosines a
 * sample; memory 5 bytes a sample.
 */

#ifndef vtkTFCMaterialPhantom_h
#define vtkTFCMaterialPhantom_h

#include "vtkImageAlgorithm.h"
#include "vtkTFCFiltersModule.h" // For export macro

class VTKTFCFILTERS_EXPORT vtkTFCMaterialPhantom : public vtkImageAlgorithm
{
public:
  static vtkTFCMaterialPhantom* New();
  vtkTypeMacro(vtkTFCMaterialPhantom, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of samples along each axis, each at least 1. Default: 128, 128, 128.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Which noise: 0 to 16777215. Default: 1.
   */
  vtkSetClampMacro(Seed, int, 0, 16777215);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Factor of the noise, at least 0; 0 gives the plain means. Default: 1.
   */
  vtkSetClampMacro(NoiseScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NoiseScale, double);
  ///@}

  ///@{
  /**
   * Factor of the centres and radii of the balls, in [0.01, 1.15]. Default: 1.
   */
  vtkSetClampMacro(GeometryScale, double, 0.01, 1.15);
  vtkGetMacro(GeometryScale, double);
  ///@}

protected:
  vtkTFCMaterialPhantom();
  ~vtkTFCMaterialPhantom() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTFCMaterialPhantom(const vtkTFCMaterialPhantom&) = delete;
  void operator=(const vtkTFCMaterialPhantom&) = delete;

  int Dimensions[3] = { 128, 128, 128 };
  int Seed = 1;
  double NoiseScale = 1;
  double GeometryScale = 1;
};

#endif
