// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCVolumeRepresentation
 * @brief ParaView's "Combined Volume": images ray cast with a combined transfer function.
 *
 * Thin: the picture is vtkTFCVolumeMapper's. This class gives the mapper its model and properties,
 * asks the pipeline for one layer of ghost cells (so that shading is the same on both sides of a
 * border between ranks), keeps that layer while telling the view the bounds without it, and finds
 * the range of an axis that the model leaves automatic over all ranks.
 *
 * An edit of TransferFunction does not execute the pipeline.
 */

#ifndef vtkTFCVolumeRepresentation_h
#define vtkTFCVolumeRepresentation_h

#include "vtkImageVolumeRepresentation.h"
#include "vtkNew.h"                      // For the model
#include "vtkTFCRepresentationsModule.h" // For export macro

#include <vector> // For attributes

class vtkContextActor;
class vtkDataObject;
class vtkPolyData;
class vtkTFCLegendItem;
class vtkTFCTransferFunction;
class vtkTFCVolumeMapper;
struct vtkTFCAttribute;

class VTKTFCREPRESENTATIONS_EXPORT vtkTFCVolumeRepresentation : public vtkImageVolumeRepresentation
{
public:
  static vtkTFCVolumeRepresentation* New();
  vtkTypeMacro(vtkTFCVolumeRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * State of the model as JSON. A state that cannot be read is reported and the previous one stays
   * in force. Default: empty, which draws nothing.
   */
  void SetTransferFunction(const char* state);

  /**
   * Id of a region that stands out because the others are nearly transparent, 0 for none, see
   * vtkTFCTransferFunction::SetHighlightedRegion(). Default: 0.
   */
  void SetHighlightedRegion(int id);

  /**
   * World distance between samples along a ray; 0: half the mean spacing. Default: 0.
   */
  void SetSampleDistance(double distance);

  /**
   * MiB of textures on the GPU at a time, 0 for no limit. Default: 0.
   */
  void SetMemoryLimit(int megabytes);

  /**
   * What draws: vtkTFCVolumeMapper::RendererType, 0 Auto, 1 GPU, 2 CPU. Default: 0.
   */
  void SetRenderer(int renderer);

  /**
   * Whether samples are shifted at random along each ray. Default: off.
   */
  void SetUseJittering(bool jittering);

  /**
   * Name of the array whose gradient is the normal of shading; empty: the primary attribute.
   * Default: empty.
   */
  void SetShadingArray(const char* name);

  /**
   * Whether the normal of shading is the gradient of the classified opacity. Default: no.
   */
  void SetShadeByOpacity(bool byOpacity);

  ///@{
  /**
   * How the samples of a ray are blended: vtkVolumeMapper's COMPOSITE_BLEND (0),
   * MAXIMUM_INTENSITY_BLEND (1), AVERAGE_INTENSITY_BLEND (3), ADDITIVE_BLEND (4) or SLICE_BLEND
   * (6), see vtkTFCVolumeMapper. Default: 0. SetBlendMode() is that of ParaView's own volume
   * representation, which has isosurface and slice: anything but composite there is passed on.
   */
  void SetRayBlending(int mode);
  void SetBlendMode(int mode);
  ///@}

  /**
   * A vtkPlane in world coordinates, what slice blending shows, here also where ParaView's own
   * volume representation takes its SliceFunction.
   */
  void SetSlicePlane(vtkImplicitFunction* plane);

  /**
   * 27-bit mask of the cropping regions that stay visible while cropping is on, as
   * vtkVolumeMapper::SetCroppingRegionFlags(). Default: 8192, the inside of the box.
   */
  void SetCroppingRegionFlags(int flags);

  ///@{
  /**
   * A legend in the overlay of the view while the representation is visible: the domain with its
   * regions and their tertiary functions. See vtkTFCLegendItem for location, position and size (as
   * fractions of the view), text colour and font size (points). Default: not shown.
   */
  void SetLegendVisibility(bool visible);
  void SetLegendLocation(int location);
  void SetLegendPosition(double x, double y);
  void SetLegendSize(double width, double height);
  void SetLegendTextColor(double red, double green, double blue);
  void SetLegendFontSize(int points);
  ///@}

  void SetVisibility(bool visible) override;

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* inInfo,
    vtkInformation* outInfo) override;

protected:
  vtkTFCVolumeRepresentation();
  ~vtkTFCVolumeRepresentation() override;

  void UpdateLegendVisibility();
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void UpdateMapperParameters() override;

private:
  vtkTFCVolumeRepresentation(const vtkTFCVolumeRepresentation&) = delete;
  void operator=(const vtkTFCVolumeRepresentation&) = delete;

  vtkTFCVolumeMapper* GetMapper();
  std::vector<vtkTFCAttribute> FindAutomaticAxes();
  void UpdateAutomaticRanges();
  void UseAutomaticRanges(vtkDataObject* delivered);
  void FindWholeBounds(double bounds[6]);

  vtkNew<vtkTFCTransferFunction> Model;
  int RayBlending = 0;
  int SharedBlendMode = 0;
  vtkSmartPointer<vtkImplicitFunction> SlicePlane;
  vtkMTimeType RangesTime = 0;             ///< of the data
  std::vector<vtkTFCAttribute> RangedAxes; ///< whose automatic ranges were computed
  vtkNew<vtkPolyData> AutomaticRanges;     ///< in its field data, for the view to deliver
  vtkTimeStamp DataTime;
  vtkNew<vtkTFCLegendItem> Legend;
  vtkNew<vtkContextActor> LegendActor;
  bool LegendVisibility = false;
};

#endif
