// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCFeatureSize
 * @brief Size of the object that a voxel belongs to (Correa and Ma 2008): array `<a>_size`.
 *
 * As in Section 4.1 of Zhou, Schott and Hansen (2012):
 * 1. The intensity is scaled to [0, 1], by its global range or, with UseIntensityRange, inside
 *    IntensityRange and to 0 outside: a small object inside a larger one can so keep its size.
 * 2. A scale space, sigma growing geometrically, by Perona and Malik's nonlinear diffusion or by
 *    Gaussians, and in it the scale-normalised Laplacian sigma^2 Lap(L).
 * 3. Blobs are its extrema in space and scale whose magnitude exceeds Threshold. A blob has the
 *    radius sqrt(D) sigma, D the number of axes with more than one sample: that is the radius of
 *    a ball, whose response is 0.925 times its contrast (a disk's 0.74, a line's 0.48). It must
 *    also be as wide as its scale, with 0.3 of the response half a sigma away: nonlinear diffusion
 *    leaves uneven edges with narrow extrema of their own.
 * 4. Shepard's interpolation with Wendland polynomials of the radii within a scale, and the largest
 *    of the scales' values: the size, in LengthUnit. It is 0 where no blob reaches.
 *
 * Second output: the blobs, vtkPolyData with a vertex each at their place in the world. Point
 * arrays: `size` (radius in LengthUnit), `radius_world` (radius in world units; in VOXELS with
 * uneven spacing that of the ball of equal volume), `scale` (sigma in LengthUnit), `response`
 * (positive for bright, negative for dark ones) and `array` (text: the name of the input array).
 * Each process has those whose maximum is at a sample that it owns.
 *
 * Accuracy: a ball from 4 samples of radius on gets its own within 3 % in the Gaussian and 6 % in
 * the nonlinear scale space, where strong edges (contrast above Conductance) make it up to that
 * much larger.
 *
 * Invalid samples (see vtkTFCPropertyFilter) are walls through which nothing diffuses; they get
 * NaN, and no blob has its maximum there. The volume's border is such a wall, too.
 *
 * Cost: some forty steps of diffusion up to a sigma of four samples, from where on half the
 * resolution suffices, so that larger sizes add an eighth of that per doubling; then the blobs'
 * volumes. Temporary memory: 20 bytes per sample, halo included. On several processes the halo
 * is what a result can depend on, about nine times the largest sigma and 167 samples with the
 * defaults: pieces thinner than that repeat much of the work, and need its memory.
 */

#ifndef vtkTFCFeatureSize_h
#define vtkTFCFeatureSize_h

#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTFCPropertyFilter.h"

#include <memory> // For std::unique_ptr

class vtkPolyData;

class VTKTFCFILTERS_EXPORT vtkTFCFeatureSize : public vtkTFCPropertyFilter
{
public:
  static vtkTFCFeatureSize* New();
  vtkTypeMacro(vtkTFCFeatureSize, vtkTFCPropertyFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether only intensities inside IntensityRange form objects. Default off: all do.
   */
  vtkSetMacro(UseIntensityRange, bool);
  vtkGetMacro(UseIntensityRange, bool);
  vtkBooleanMacro(UseIntensityRange, bool);
  ///@}

  ///@{
  /**
   * The intensities, in data units and including the ends, that are scaled to [0, 1]; all others
   * become 0. The first must be smaller. Default (0, 1).
   */
  vtkSetVector2Macro(IntensityRange, double);
  vtkGetVector2Macro(IntensityRange, double);
  ///@}

  enum ScaleSpaceType
  {
    NONLINEAR = 0, ///< Perona and Malik's: edges stronger than Conductance persist
    GAUSSIAN = 1   ///< linear
  };

  ///@{
  /**
   * The scale space. Default NONLINEAR.
   */
  vtkSetClampMacro(ScaleSpace, int, NONLINEAR, GAUSSIAN);
  vtkGetMacro(ScaleSpace, int);
  ///@}

  ///@{
  /**
   * K of the nonlinear scale space: the gradient, of the intensity in [0, 1] and per smallest
   * spacing, at which diffusion is halved. Positive. About the contrast of the objects (0.25 to 1
   * times) finds them; much less preserves their edges, and noise, so well that they never become
   * blobs. Default 0.5.
   */
  vtkSetMacro(Conductance, double);
  vtkGetMacro(Conductance, double);
  ///@}

  enum PolarityType
  {
    BRIGHT = 0, ///< objects brighter than what surrounds them
    DARK = 1,   ///< darker ones
    BOTH = 2
  };

  ///@{
  /**
   * Which objects are looked for. Default BRIGHT.
   */
  vtkSetClampMacro(Polarity, int, BRIGHT, BOTH);
  vtkGetMacro(Polarity, int);
  ///@}

  ///@{
  /**
   * Number of scales from the smallest to the largest size, 2 to 100. Two more are computed, one on
   * either side. Sizes lie also between scales. Default 12.
   */
  vtkSetMacro(NumberOfScales, int);
  vtkGetMacro(NumberOfScales, int);
  ///@}

  ///@{
  /**
   * Radii of the smallest and largest objects in LengthUnit. The smallest is at least 1.5 of the
   * smallest spacing, the largest at most half the volume's longest side. Default 2.5 and 25.
   */
  vtkSetMacro(SmallestSize, double);
  vtkGetMacro(SmallestSize, double);
  vtkSetMacro(LargestSize, double);
  vtkGetMacro(LargestSize, double);
  ///@}

  ///@{
  /**
   * Magnitude of the response, of the intensity in [0, 1], that a blob exceeds: about 0.9 times the
   * contrast of the faintest object. Positive. Default 0.08.
   */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  /**
   * The second output.
   */
  vtkPolyData* GetBlobs();

protected:
  vtkTFCFeatureSize();
  ~vtkTFCFeatureSize() override;

  std::string CheckParameters() const override;
  std::string CheckField(const Field& field) const override;
  int GetHaloWidth(const Field& field) const override;
  std::vector<std::string> GetSuffixes() const override { return { "_size" }; }
  double GetTemporaryBytes(const Field& field) const override;
  bool Prepare(const Field& field, const vtkTFCDistributedImage& image) override;
  bool ComputeProperties(const Field& field, const std::vector<float*>& outputs) override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool UseIntensityRange = false;
  double IntensityRange[2] = { 0., 1. };
  int ScaleSpace = NONLINEAR;
  double Conductance = 0.5;
  int Polarity = BRIGHT;
  int NumberOfScales = 12;
  double SmallestSize = 2.5;
  double LargestSize = 25.;
  double Threshold = 0.08;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;

  vtkTFCFeatureSize(const vtkTFCFeatureSize&) = delete;
  void operator=(const vtkTFCFeatureSize&) = delete;
};

#endif
