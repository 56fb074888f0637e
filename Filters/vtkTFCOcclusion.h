// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCOcclusion
 * @brief Occlusion of a volume's samples by their surroundings: array `<a>_occlusion`, data units.
 *
 * The mean over a neighbourhood of a sample, as far as it lies inside the volume and is valid.
 * Metric chooses between two definitions:
 *
 * BOUNDARY_PRESERVING (Zhou, Schott and Hansen 2012, Eqs. 6 to 9): the mean intensity, times the
 * boundary factor g_x = eta^2 / (|grad I|^2 + eta^2) if BoundaryTerm is on, with the gradient per
 * voxel of the intensity scaled to [0, 1] by its global range. g_x is 1 in homogeneous regions (and
 * everywhere in a constant volume) and falls to 0 at boundaries, for which the ambient mean of
 * either side would be misleading. For noisy data choose BoundaryParameter near the noise's
 * gradient, up to 1; else g_x suppresses everything.
 *
 * SPECTRUM (Correa and Ma 2009, "The occlusion spectrum for volume classification and
 * visualization"): sum_p w(|p - x|) M(I(p)) / sum_p w(|p - x|), M the Mapping: the intensity
 * (linear ramp), or the intensity inside MappingRange and 0 outside (truncated ramp). The weights
 * DistanceWeight are normalised, so that the result is in data units for any of them.
 *
 * The neighbourhood is a box of Radius to either side of each axis, in running sums whose cost does
 * not depend on Radius, or the ball of samples within Radius, exact, in Fourier transforms of the
 * volume padded by Radius. In world units boxes and balls are as flat in samples as the voxels are
 * long. Distance weights need the ball.
 *
 * AutoRadius picks the radius of AutoRadiusRange that maximises the variance of the result (the
 * criterion of Correa and Ma): ten candidates in geometric steps, then the best one's vicinity. The
 * mean over more varies less, so that without a boundary term the maximum is often the smallest
 * radius: the range matters. The radius that was used is reported by GetUsedRadius() and as the
 * one-value field data array `<a>_occlusion_radius`.
 *
 * An invalid voxel gets NaN. See vtkTFCPropertyFilter for what is invalid and for the rest. It is
 * an error if Radius is shorter than the smallest spacing or longer than the longest side of the
 * volume. Temporary memory per sample: box 4 bytes, 8 with invalid samples; ball 4 (1 + R / n)
 * bytes on n^3 samples, four times that with invalid ones; 4 more for a truncated ramp and for
 * AutoRadius.
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

  enum MetricType
  {
    BOUNDARY_PRESERVING = 0,
    SPECTRUM = 1
  };
  enum NeighborhoodType
  {
    BOX = 0,
    SPHERE = 1
  };
  enum MappingType
  {
    LINEAR_RAMP = 0,
    TRUNCATED_RAMP = 1
  };
  enum DistanceWeightType
  {
    CONSTANT = 0, ///< 1
    LINEAR = 1,   ///< falls linearly, to 0 one spacing beyond Radius
    GAUSSIAN = 2  ///< standard deviation Radius / 2
  };

  ///@{
  /**
   * Which definition. Default BOUNDARY_PRESERVING.
   */
  vtkSetClampMacro(Metric, int, BOUNDARY_PRESERVING, SPECTRUM);
  vtkGetMacro(Metric, int);
  ///@}

  ///@{
  /**
   * Box or ball. Default BOX.
   */
  vtkSetClampMacro(Neighborhood, int, BOX, SPHERE);
  vtkGetMacro(Neighborhood, int);
  ///@}

  ///@{
  /**
   * Half the width of the neighbourhood in LengthUnit (voxels or world units), at least 1 voxel.
   * Default 40.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Choose the radius between AutoRadiusRange's ends (same unit, default 4 and 64, which are cut at
   * the smallest spacing and at half of the longest side) instead of Radius. Default off.
   */
  vtkSetMacro(AutoRadius, bool);
  vtkGetMacro(AutoRadius, bool);
  vtkBooleanMacro(AutoRadius, bool);
  vtkSetVector2Macro(AutoRadiusRange, double);
  vtkGetVector2Macro(AutoRadiusRange, double);
  ///@}

  /**
   * The radius of the last update, for its last array; 0 before.
   */
  vtkGetMacro(UsedRadius, double);

  ///@{
  /**
   * Whether g_x is multiplied in. Only BOUNDARY_PRESERVING. Default on.
   */
  vtkSetMacro(BoundaryTerm, bool);
  vtkGetMacro(BoundaryTerm, bool);
  vtkBooleanMacro(BoundaryTerm, bool);
  ///@}

  ///@{
  /**
   * Eta of the boundary factor: the gradient, per voxel and relative to the global range, at which
   * g_x is one half. Positive. Default 0.005.
   */
  vtkSetMacro(BoundaryParameter, double);
  vtkGetMacro(BoundaryParameter, double);
  ///@}

  ///@{
  /**
   * What is averaged. Only SPECTRUM. Default LINEAR_RAMP.
   */
  vtkSetClampMacro(Mapping, int, LINEAR_RAMP, TRUNCATED_RAMP);
  vtkGetMacro(Mapping, int);
  ///@}

  ///@{
  /**
   * Open interval of intensities that TRUNCATED_RAMP keeps, in data units. Default 0 and 1.
   */
  vtkSetVector2Macro(MappingRange, double);
  vtkGetVector2Macro(MappingRange, double);
  ///@}

  ///@{
  /**
   * Weight by distance. Only SPECTRUM, and only with SPHERE unless CONSTANT. Default CONSTANT.
   */
  vtkSetClampMacro(DistanceWeight, int, CONSTANT, GAUSSIAN);
  vtkGetMacro(DistanceWeight, int);
  ///@}

protected:
  vtkTFCOcclusion() = default;
  ~vtkTFCOcclusion() override = default;

  std::string CheckParameters() const override;
  std::string CheckField(const Field& field) const override;
  int GetHaloWidth(const Field& field) const override;
  std::vector<std::string> GetSuffixes() const override { return { "_occlusion" }; }
  double GetTemporaryBytes(const Field& field) const override;
  bool Prepare(const Field& field, const vtkTFCDistributedImage& image) override;
  bool ComputeProperties(const Field& field, const std::vector<float*>& outputs) override;
  void AddFieldData(const Field& field, vtkFieldData* data) override;

private:
  vtkTFCOcclusion(const vtkTFCOcclusion&) = delete;
  void operator=(const vtkTFCOcclusion&) = delete;

  void GetRadii(const Field& field, double radii[2]) const;
  bool Compute(const Field& field, double radius, double from, double to, float* out);

  int Metric = BOUNDARY_PRESERVING;
  int Neighborhood = BOX;
  double Radius = 40.;
  bool AutoRadius = false;
  double AutoRadiusRange[2] = { 4., 64. };
  double UsedRadius = 0.;
  bool BoundaryTerm = true;
  double BoundaryParameter = 0.005;
  int Mapping = LINEAR_RAMP;
  double MappingRange[2] = { 0., 1. };
  int DistanceWeight = CONSTANT;
};

#endif
