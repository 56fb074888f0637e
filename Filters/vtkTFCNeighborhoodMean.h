// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Means over boxes and balls of a lattice, threaded, with progress.
 *
 * What vtkTFCOcclusion computes for one radius: the mean of the valid samples (not NaN) of the
 * neighbourhood that lie in the lattice, times the boundary factor of Kernels/TFCOcclusion.h. NaN
 * for an invalid sample. Results do not depend on the number of threads.
 */

#ifndef vtkTFCNeighborhoodMean_h
#define vtkTFCNeighborhoodMean_h

#include "Kernels/TFCBallKernel.h"
#include "vtkTFCFiltersModule.h" // For export macro

class vtkAlgorithm;

class VTKTFCFILTERS_NO_EXPORT vtkTFCNeighborhoodMean
{
public:
  /**
   * Means for the block [begin, end) of a lattice of `size` samples, at the distances `spacing` in
   * the unit of the radii. `masked` says whether `values` may hold NaN.
   */
  vtkTFCNeighborhoodMean(const float* values, const tfc::Index size[3], const tfc::Index begin[3],
    const tfc::Index end[3], const double spacing[3], bool masked);

  /**
   * Multiply by the boundary factor: `weight` is tfc::ConductanceWeight(), 0 for none.
   */
  void SetBoundaryWeight(float weight) { this->BoundaryWeight = weight; }

  /**
   * A value near the samples. Default 0.
   */
  void SetMiddle(float middle) { this->Middle = middle; }

  /**
   * Report to `owner`, from progress `from` to `to`; null: to nobody.
   */
  void SetProgress(vtkAlgorithm* owner, double from, double to);

  ///@{
  /**
   * Fill `out`, which holds the block. False when aborted. The box reaches `radius` to either side
   * along each axis, in whole samples.
   */
  bool ComputeBox(double radius, float* out) const;
  bool ComputeBall(double radius, tfc::DistanceWeight weight, float* out) const;
  ///@}

  ///@{
  /**
   * Bytes of temporary memory.
   */
  double GetBoxBytes() const;
  double GetBallBytes(double radius) const;
  ///@}

private:
  template <bool Masked>
  bool RunBox(double radius, float* out) const;
  template <typename Real>
  bool RunBall(const tfc::BallKernel& kernel, float* out) const;
  template <bool Masked>
  void ApplyBoundary(tfc::Index z, float* slice) const;
  tfc::Index GetOffset(tfc::Index z) const;
  double At(double fraction) const { return this->From + fraction * (this->To - this->From); }

  const float* Values;
  tfc::Index Size[3], Begin[3], End[3];
  double Spacing[3];
  bool Masked;
  float BoundaryWeight = 0.f;
  float Middle = 0.f;
  vtkAlgorithm* Owner = nullptr;
  double From = 0., To = 1.;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCNeighborhoodMean.h
