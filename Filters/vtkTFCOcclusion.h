// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCOcclusion
 * @brief Occlusion metric of Zhou, Schott and Hansen (2012): array `<a>_occlusion`, in data units.
 *
 * The mean of the intensity over the cube of 2 Radius + 1 voxels around a voxel, as far as it lies
 * inside the volume and is valid, times the boundary factor
 * g_x = eta^2 / (|grad I|^2 + eta^2), with the gradient per voxel of the intensity scaled to [0, 1]
 * by its global range. g_x is 1 in homogeneous regions (and everywhere in a constant volume) and
 * falls to 0 at boundaries, for which the ambient mean of either side would be misleading. For
 * noisy data choose BoundaryParameter near the noise's gradient, up to 1; else g_x suppresses
 * everything.
 *
 * The cost per voxel does not depend on Radius, nor does a radius larger than the volume hurt. An
 * invalid voxel gets NaN. See vtkTFCPropertyFilter for what is invalid and for the rest. Temporary
 * memory: 4 bytes per sample, 8 with invalid samples.
 */

#ifndef vtkTFCOcclusion_h
#define vtkTFCOcclusion_h

#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTFCPropertyFilter.h"

class VTKTFCFILTERS_EXPORT vtkTFCOcclusion : public vtkTFCPropertyFilter
{
public:
  static vtkTFCOcclusion* New();
  vtkTypeMacro(vtkTFCOcclusion, vtkTFCPropertyFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Half the width of the neighbourhood in voxels, at least 1. Default 40.
   */
  vtkSetMacro(Radius, int);
  vtkGetMacro(Radius, int);
  ///@}

  ///@{
  /**
   * Eta of the boundary factor: the gradient, per voxel and relative to the global range, at which
   * g_x is one half. Positive. Default 0.005.
   */
  vtkSetMacro(BoundaryParameter, double);
  vtkGetMacro(BoundaryParameter, double);
  ///@}

protected:
  vtkTFCOcclusion() = default;
  ~vtkTFCOcclusion() override = default;

  std::string CheckParameters() const override;
  int GetHaloWidth(const Field&) const override { return this->Radius; }
  std::vector<std::string> GetSuffixes() const override { return { "_occlusion" }; }
  bool ComputeProperties(const Field& field, const std::vector<float*>& outputs) override;

  int Radius = 40;
  double BoundaryParameter = 0.005;

private:
  vtkTFCOcclusion(const vtkTFCOcclusion&) = delete;
  void operator=(const vtkTFCOcclusion&) = delete;
};

#endif
