// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCGradientMagnitude
 * @brief Gradient magnitude of a volume: array `<a>_gradient`, in data units per world unit.
 *
 * Central differences, one-sided at the border of the whole volume, 0 along an axis with a single
 * sample; the spacing may differ per axis, and the orientation of the image does not matter (the
 * magnitude is invariant under rotation). At a voxel with one invalid neighbour along an
 * axis the one-sided difference with the valid neighbour is used, with two the axis contributes 0,
 * and an invalid voxel gets NaN. See vtkTFCPropertyFilter for what is invalid and for the rest.
 */

#ifndef vtkTFCGradientMagnitude_h
#define vtkTFCGradientMagnitude_h

#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTFCPropertyFilter.h"

class VTKTFCFILTERS_EXPORT vtkTFCGradientMagnitude : public vtkTFCPropertyFilter
{
public:
  static vtkTFCGradientMagnitude* New();
  vtkTypeMacro(vtkTFCGradientMagnitude, vtkTFCPropertyFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkTFCGradientMagnitude() = default;
  ~vtkTFCGradientMagnitude() override = default;

  int GetHaloWidth(const Field&) const override { return 1; }
  std::vector<std::string> GetSuffixes() const override { return { "_gradient" }; }
  bool ComputeProperties(const Field& field, const std::vector<float*>& outputs) override;

private:
  vtkTFCGradientMagnitude(const vtkTFCGradientMagnitude&) = delete;
  void operator=(const vtkTFCGradientMagnitude&) = delete;
};

#endif
