// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCRayProbe
 * @brief What a line of sight meets first in a volume with a combined transfer function, and why.
 *
 * Input: vtkImageData, vtkRectilinearGrid or a composite of them, as the volume mapper draws it.
 * The line from StartPoint (the eye) towards EndPoint, and beyond neither, is cut at multiples of
 * SampleDistance from StartPoint; each piece is classified at its middle (vtkTFCClassifier) and has
 * the opacity 1 - (1 - alpha)^(length / UnitDistance). Pieces are accumulated front to back, as in
 * the picture.
 * Light, clipping planes and opaque geometry play no part.
 *
 * Port 0, table "Location": no row where nothing is visible along the line, else one for the first
 * place where the accumulated opacity reaches Threshold or, where it never does, for the piece that
 * contributes most to the picture:
 * - `x`, `y`, `z`: the middle of the piece, world coordinates; `distance` from StartPoint
 * - `i`, `j`, `k`: the nearest point, or the cell, of its image
 * - `block`: which image of a composite, counted from 0 on the process that has it
 * - `reached`: 1 or 0, whether the threshold was; `opacity`: accumulated there, and
 *   `total_opacity` along the whole line; `red`, `green`, `blue` and `alpha` of the sample;
 *   `primary` and `secondary`: its values of the two axes
 * - every numeric array of the attributes' kind, interpolated there; components as `name_0`, ...
 *
 * Port 1, table "Regions": a row for each visible region, in list order: `id`, `name`; `weight`, of
 * shape and fall-off at the place; `tertiary`, the factor of the third attribute (1 without one);
 * `opacity` = its alpha, opacity * weight * tertiary; `contribution`: its share in the colour of
 * the sample, 0 to 1.
 *
 * On several processes each has its part of the volume; the tables are on the first. An empty
 * transfer function, an unknown array and a line without length are errors. Cost: the samples along
 * the line.
 *
 * @sa vtkTFCClassify vtkTFCRaySampler
 */

#ifndef vtkTFCRayProbe_h
#define vtkTFCRayProbe_h

#include "vtkNew.h"                       // For the model
#include "vtkTFCTransferFunctionModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For the state
#include <vector> // For samplers

class vtkMultiProcessController;
class vtkTFCDistributedImage;
class vtkTFCRaySampler;
class vtkTFCTransferFunction;
struct vtkTFCProbeCropping;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCRayProbe : public vtkTableAlgorithm
{
public:
  static vtkTFCRayProbe* New();
  vtkTypeMacro(vtkTFCRayProbe, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The transfer function as JSON text (see vtkTFCTransferFunction). A text that cannot be read
   * raises an error and leaves the previous one in force.
   */
  void SetTransferFunction(const char* json);
  std::string GetTransferFunction() const;
  ///@}

  ///@{
  /**
   * Ends of the line of sight, world coordinates. Default: (0, 0, 0) and (0, 0, 1).
   */
  vtkSetVector3Macro(StartPoint, double);
  vtkGetVector3Macro(StartPoint, double);
  vtkSetVector3Macro(EndPoint, double);
  vtkGetVector3Macro(EndPoint, double);
  ///@}

  ///@{
  /**
   * World distance between samples, or 0 for half the smallest mean spacing. Default: 0.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * World length over which the model's opacities hold; positive. Default: 1.
   */
  vtkSetMacro(UnitDistance, double);
  vtkGetMacro(UnitDistance, double);
  ///@}

  ///@{
  /**
   * Accumulated opacity to look for, above 0 and at most 1. Default: 0.5.
   */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /**
   * From the coordinates of the data to the world, 16 numbers by rows: the transform of the volume
   * in a view. Default: identity.
   */
  vtkSetVectorMacro(Transform, double, 16);
  vtkGetVectorMacro(Transform, double, 16);
  ///@}

  ///@{
  /**
   * Cropping of the display: planes at CroppingOrigin + CroppingScale * bounds of the data along
   * its axes, and what they leave visible as of vtkVolumeMapper::SetCroppingRegionFlags(). A piece
   * of the line is cropped by its middle. Default: off, (0, 0, 0), (1, 1, 1), the inside.
   */
  vtkSetMacro(UseCropping, bool);
  vtkGetMacro(UseCropping, bool);
  vtkBooleanMacro(UseCropping, bool);
  vtkSetVector3Macro(CroppingOrigin, double);
  vtkGetVector3Macro(CroppingOrigin, double);
  vtkSetVector3Macro(CroppingScale, double);
  vtkGetVector3Macro(CroppingScale, double);
  vtkSetMacro(CroppingRegionFlags, int);
  vtkGetMacro(CroppingRegionFlags, int);
  ///@}

  ///@{
  /**
   * Default: the global controller.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkTFCRayProbe();
  ~vtkTFCRayProbe() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTFCRayProbe(const vtkTFCRayProbe&) = delete;
  void operator=(const vtkTFCRayProbe&) = delete;

  std::string CheckSettings() const;
  vtkTFCProbeCropping FindCropping(const std::vector<vtkTFCRaySampler>& samplers,
    const vtkTFCDistributedImage& peers) const;

  vtkNew<vtkTFCTransferFunction> Model;
  vtkMultiProcessController* Controller = nullptr;
  double StartPoint[3] = { 0, 0, 0 };
  double EndPoint[3] = { 0, 0, 1 };
  double SampleDistance = 0;
  double UnitDistance = 1;
  double Threshold = 0.5;
  double Transform[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  bool UseCropping = false;
  double CroppingOrigin[3] = { 0, 0, 0 };
  double CroppingScale[3] = { 1, 1, 1 };
  int CroppingRegionFlags = 0x2000;
};

#endif
