// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCLocalStatistics
 * @brief Local mean and deviation of a volume, from spheres that grow as far as the data allow.
 *
 * Section 4.3 of Zhou, Schott and Hansen (2012), after Haidacher et al. (2010). Around every voxel
 * spheres S_1, S_2, ... of growing radius are tried. S_1 is accepted as it is. S_k is accepted if
 * its samples pass D'Agostino's K-squared test of normality, K^2 < -2 ln(alpha), and if those that
 * it adds to S_(k-1) pass Welch's t-test of having the mean of those in S_(k-1), both at the level
 * alpha = ConfidenceLevel. Growth ends at the first failure or at MaximumRadius. The results are
 * those of the last accepted sphere:
 *
 * - `<a>_mean`, in data units;
 * - `<a>_stddev`, in data units: with n - 1, 0 in a constant region and for a single sample;
 * - `<a>_radius`, in LengthUnit;
 * - with Moments also `<a>_skewness`, m3 / m2^1.5, and `<a>_kurtosis`, m4 / m2^2: not the excess, 3
 *   for a normal distribution. In a constant region they are 0 and 3.
 *
 * The radius grows by one voxel; with LengthUnit WORLD by the smallest spacing of the axes with
 * more than one sample, and spheres are round in space. At the border and next to invalid voxels a
 * sphere has the samples that exist: all tests are those of their number. Fewer than 8 are not
 * tested for normality; a constant sphere passes; a shell without samples is accepted; one with a
 * single sample is taken to vary as the sphere does; two constant parts are similar if they are
 * equal. An invalid voxel gets NaN in all outputs. See vtkTFCPropertyFilter for what is invalid and
 * for the rest.
 *
 * Errors: a radius below the first step, or one beyond the largest side of the volume; a level
 * outside of (0, 1).
 *
 * Cost: see TFCGrowingSpheres.h. The first three spheres are summed up sample by sample; larger
 * ones share the sums of their slices with the voxels above and below, so that in homogeneous
 * regions a radius of 10 takes about twice as long as 6, and 20 about three times as long as 10.
 * Temporary memory: about 60 bytes per sample of the largest sphere, and for each thread a padded
 * block of (64 + 2 r) (8 + 2 r) (64 + 2 r) samples and 120 kB.
 *
 * Results have the same bits for any number of threads and processes and any instruction set.
 */

#ifndef vtkTFCLocalStatistics_h
#define vtkTFCLocalStatistics_h

#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTFCPropertyFilter.h"

class VTKTFCFILTERS_EXPORT vtkTFCLocalStatistics : public vtkTFCPropertyFilter
{
public:
  static vtkTFCLocalStatistics* New();
  vtkTypeMacro(vtkTFCLocalStatistics, vtkTFCPropertyFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where growth ends, in LengthUnit: at least one step (1 voxel), at most the largest side of the
   * volume. The last step that does not exceed it is the last one tried. Default 6.
   */
  vtkSetMacro(MaximumRadius, double);
  vtkGetMacro(MaximumRadius, double);
  ///@}

  ///@{
  /**
   * Alpha: how probable it is for a test to stop growth in a homogeneous region, inside (0, 1).
   * Smaller values give larger spheres. Default 0.001, the paper's; for noise-free data up to 0.1.
   */
  vtkSetMacro(ConfidenceLevel, double);
  vtkGetMacro(ConfidenceLevel, double);
  ///@}

  ///@{
  /**
   * Whether skewness and kurtosis are added. Default off.
   */
  vtkSetMacro(Moments, bool);
  vtkGetMacro(Moments, bool);
  vtkBooleanMacro(Moments, bool);
  ///@}

protected:
  vtkTFCLocalStatistics() = default;
  ~vtkTFCLocalStatistics() override = default;

  std::string CheckParameters() const override;
  std::string CheckField(const Field& field) const override;
  int GetHaloWidth(const Field& field) const override;
  std::vector<std::string> GetSuffixes() const override;
  double GetTemporaryBytes(const Field& field) const override;
  bool ComputeProperties(const Field& field, const std::vector<float*>& outputs) override;

  double MaximumRadius = 6.;
  double ConfidenceLevel = 0.001;
  bool Moments = false;

private:
  vtkTFCLocalStatistics(const vtkTFCLocalStatistics&) = delete;
  void operator=(const vtkTFCLocalStatistics&) = delete;
};

#endif
