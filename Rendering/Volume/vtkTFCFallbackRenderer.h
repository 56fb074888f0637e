// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Draws one image with a combined transfer function on the CPU, by VTK's ray caster.
 *
 * For where there is no OpenGL volume rendering. Every point is classified (vtkTFCClassifier, as
 * vtkTFCClassify does), and the colours and opacities are ray cast by
 * vtkFixedPointVolumeRayCastMapper, which takes them as bytes. What differs from
 * vtkTFCRayCastMapper:
 *
 * - Classified before interpolating (pre-classification): equal where the transfer function varies
 *   little between neighbouring points, softer at sharp edges of regions.
 * - An opacity a is stored as 255 sqrt(a / largest) with the largest of the image, for 8 bits would
 *   leave nothing of low opacities per unit distance; interpolation takes place in that number. The
 *   relative step is 2 / byte, 0.8 % at the largest opacity, 8 % at a hundredth of it.
 * - Points where nothing is have the mean colour of their visible neighbours, weighted by opacity,
 *   so that no dark seams appear.
 * - Shading uses the gradient of the classified opacity. Lights are taken for directional ones, and
 *   ambient light is the property's times the lights' (black by default), as VTK does it.
 * - Cell data is averaged to points first. NaN, blanked points and the corners of blanked cells are
 *   transparent; ghost cells are not drawn; a single layer is a slab one voxel thick.
 *
 * Opacities per unit distance become 1 - (1 - a)^(step / unit) per sample, and are stored by VTK in
 * steps of 1 / 32767. Memory: 4 bytes a point while it draws, 16 more while it classifies. Cost:
 * one threaded pass, when the data or the model has changed.
 */

#ifndef vtkTFCFallbackRenderer_h
#define vtkTFCFallbackRenderer_h

#include "vtkTFCImageBlocks.h"
#include "vtkTFCVolumeModule.h" // For export macro

#include "vtkNew.h"          // For the volume
#include "vtkSmartPointer.h" // For the image and the mapper
#include "vtkType.h"         // For vtkMTimeType

#include <array>  // For ranges
#include <string> // For errors
#include <vector> // For attributes

class vtkFixedPointVolumeRayCastMapper;
class vtkImageData;
class vtkRenderer;
class vtkTFCTransferFunction;
class vtkVolume;
class vtkVolumeMapper;
class vtkWindow;

class VTKTFCVOLUME_EXPORT vtkTFCFallbackRenderer
{
public:
  /// Ranges of the two axes where the model gives none.
  using AxisRanges = std::array<std::array<double, 2>, 2>;

  vtkTFCFallbackRenderer();
  ~vtkTFCFallbackRenderer();

  /// Classify the image unless neither it nor the model has changed. `ranges` may be null for those
  /// of the image. Returns whether there is something to draw; with `error` when the model does not
  /// fit the data, which leaves what was drawn of the same data in force.
  bool Update(const vtkTFCImageBlocks::Block& block, vtkTFCTransferFunction* model,
    const AxisRanges* ranges, std::string& error);

  /// Draw `vol`'s place with its property, cropping and clipping planes of `settings`. The distance
  /// between samples is a world length; 0: half the mean spacing.
  void Render(vtkRenderer* ren, vtkVolume* vol, vtkVolumeMapper* settings, double sampleDistance);

  /// The points as colour and encoded opacity, four bytes each; null before Update().
  vtkImageData* GetImage() const { return this->Image; }
  /// The opacity that byte 255 stands for.
  double GetLargestOpacity() const { return this->LargestOpacity; }

  int GetNumberOfClassifications() const { return this->Classifications; }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  class RayCaster;

  bool Classify(vtkImageData* source, const std::array<int, 6>& drawn,
    vtkTFCTransferFunction* model, const AxisRanges* ranges, std::string& error);
  void PlaceVolume(vtkVolume* vol);
  void SetProperty(vtkVolume* vol, double sampleDistance);
  void SetCropping(vtkVolumeMapper* settings);

  vtkSmartPointer<vtkFixedPointVolumeRayCastMapper> Caster;
  vtkNew<vtkVolume> Volume; // its property holds the encoded opacities, the caller's does not
  vtkSmartPointer<vtkImageData> Source;
  vtkSmartPointer<vtkImageData> Image;    // bytes; along an axis with a single layer, two
  std::array<int, 3> First = { 0, 0, 0 }; // index in Source of the first point of Image
  std::array<bool, 3> Flat = { false, false, false }; // a single layer in Source

  std::vector<vtkTFCAttribute> Attributes; // of the model that was classified
  std::string Fingerprint;                 // of its data and axes
  vtkMTimeType ModelTime = 0;
  const vtkTFCTransferFunction* Model = nullptr; // only compared
  double LargestOpacity = 1;
  std::array<double, 3> TabulatedOpacity = { 0, 0, 0 }; // largest, sample distance, unit
  int Classifications = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCFallbackRenderer.h
