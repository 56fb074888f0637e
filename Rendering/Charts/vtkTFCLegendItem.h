// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCLegendItem
 * @brief A picture of a transfer function for publications: its domain and its 1D functions.
 *
 * At the left the plane of the two axes with the visible regions in their colours and fall-offs; at
 * the right a row for each of them, front to back: colour, name and, where it has one, its function
 * over the tertiary attribute, opacity as height, filled with the colours it gives. Put it into the
 * scene of a vtkContextActor to have it in a view; with the scene's renderer set, sizes follow the
 * density of its window. Nothing is drawn without visible regions.
 *
 * Rows share the height. When there are more than fit, the last line says how many are missing.
 *
 * Axes whose range is automatic need SetAutomaticRanges(); else the regions are drawn over [0, 1]
 * as they would be, and the axis has no numbers, as in a legend too small for them. A function
 * without a range of its own runs from its first to its last node.
 */

#ifndef vtkTFCLegendItem_h
#define vtkTFCLegendItem_h

#include "vtkContextItem.h"
#include "vtkNew.h"              // For axes
#include "vtkSmartPointer.h"     // For the model
#include "vtkTFCChartsModule.h"  // For export macro
#include "vtkTFCDomainMapping.h" // For the place of the domain

#include <array>  // For axes
#include <memory> // For the rows

class vtkAxis;
class vtkContextClip;
class vtkTFCLegendRows;
class vtkTFCTransferFunction;

class VTKTFCCHARTS_EXPORT vtkTFCLegendItem : public vtkContextItem
{
public:
  static vtkTFCLegendItem* New();
  vtkTypeMacro(vtkTFCLegendItem, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What to show; it is looked at whenever the legend is drawn. Null: nothing.
   */
  void SetTransferFunction(vtkTFCTransferFunction* model);

  ///@{
  /**
   * Finite extents of the data along the axes, for those without a range. Default: unknown.
   */
  void SetAutomaticRanges(const double primary[2], const double secondary[2]);
  void ClearAutomaticRanges() { this->HasAutomaticRanges = false; }
  ///@}

  enum Locations
  {
    AnyLocation,
    LowerLeftCorner,
    LowerRightCorner,
    LowerCenter,
    UpperLeftCorner,
    UpperRightCorner,
    UpperCenter
  };

  ///@{
  /**
   * Where it is in the scene, as of vtkScalarBarRepresentation: a corner or the middle of an edge,
   * or with AnyLocation the lower left corner as fractions of the scene. Default: LowerRightCorner,
   * (0.6, 0.02).
   */
  vtkSetClampMacro(Location, int, AnyLocation, UpperCenter);
  vtkGetMacro(Location, int);
  vtkSetVector2Macro(Position, double);
  vtkGetVector2Macro(Position, double);
  ///@}

  ///@{
  /**
   * Width and height as fractions of the scene, 0.05 to 1. Default: (0.4, 0.35).
   */
  void SetSize(double width, double height);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Of texts and lines; a light one stands for a dark ground. Default: white.
   */
  vtkSetVector3Macro(TextColor, double);
  vtkGetVector3Macro(TextColor, double);
  ///@}

  ///@{
  /**
   * In points. Default: 12.
   */
  vtkSetClampMacro(FontSize, int, 4, 200);
  vtkGetMacro(FontSize, int);
  ///@}

  ///@{
  /**
   * As of the last Paint(): left, bottom, width, height of the domain in pixels, and the number of
   * rows that did not fit.
   */
  const std::array<double, 4>& GetPlot() const { return this->Mapping.Plot; }
  int GetNumberOfMissingRows() const;
  ///@}

  bool Paint(vtkContext2D* painter) override;

protected:
  vtkTFCLegendItem();
  ~vtkTFCLegendItem() override;

private:
  vtkTFCLegendItem(const vtkTFCLegendItem&) = delete;
  void operator=(const vtkTFCLegendItem&) = delete;

  std::array<double, 4> FindRectangle() const;
  void LayoutDomain(vtkContext2D* painter, const std::array<double, 4>& rectangle, bool numbers);
  void UpdateRegions();
  void PaintDomain(vtkContext2D* painter);

  vtkSmartPointer<vtkTFCTransferFunction> Model;
  vtkNew<vtkAxis> Axes[2];
  vtkNew<vtkContextClip> Regions; // what the domain shows
  vtkMTimeType RegionsTime = 0;
  std::array<double, 4> RegionsRanges = { { 0, 0, 0, 0 } };
  vtkTFCDomainMapping Mapping;
  std::unique_ptr<vtkTFCLegendRows> Rows;
  bool HasAutomaticRanges = false;
  double AutomaticRanges[2][2] = { { 0, 1 }, { 0, 1 } };
  int Location = LowerRightCorner;
  double Position[2] = { 0.6, 0.02 };
  double Size[2] = { 0.4, 0.35 };
  double TextColor[3] = { 1, 1, 1 };
  int FontSize = 12;
};

#endif
