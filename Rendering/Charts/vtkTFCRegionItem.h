// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCRegionItem
 * @brief One region in the domain chart: colour, weight and fall-off, outline, name, and handles
 * while it is selected.
 *
 * The filling is the model's own weight function in the region's colour, sampled at most 160 times
 * along each side of what is visible and only when region, view or size changed. A region that is
 * not visible or has opacity 0 is only an outline, dashed; a locked one has no handles.
 */

#ifndef vtkTFCRegionItem_h
#define vtkTFCRegionItem_h

#include "vtkContextItem.h"
#include "vtkSmartPointer.h"     // For the region and the picture
#include "vtkTFCChartsModule.h"  // For export macro
#include "vtkTFCDomainMapping.h" // For the mapping
#include "vtkWrappingHints.h"    // For VTK_WRAPEXCLUDE

#include <memory> // For the compiled region
#include <vector> // For handles

class vtkImageData;
class vtkTFCRegion;
struct vtkTFCCompiledModel;
struct vtkTFCCompiledRegion;

class VTKTFCCHARTS_EXPORT vtkTFCRegionItem : public vtkContextItem
{
public:
  static vtkTFCRegionItem* New();
  vtkTypeMacro(vtkTFCRegionItem, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetRegion(vtkTFCRegion* region);
  vtkTFCRegion* GetRegion() const;
  VTK_WRAPEXCLUDE void SetMapping(const vtkTFCDomainMapping* mapping) { this->Mapping = mapping; }

  ///@{
  /**
   * Selected regions have a stronger outline, those that are `Active` (the only selected one)
   * handles; hovered ones show their name.
   */
  void SetLook(bool selected, bool active, bool hovered);
  ///@}

  /**
   * The region as the chart compiled it; null when it takes no part in classification.
   */
  VTK_WRAPEXCLUDE void SetCompiled(const vtkTFCCompiledModel* model,
    const vtkTFCCompiledRegion* region);

  ///@{
  /**
   * Outline and handles now, in axis units. GetWidthHandle() is where the handle of the fall-off's
   * width lies; false for fall-offs without a width.
   */
  VTK_WRAPEXCLUDE vtkTFCOutline GetOutline() const;
  VTK_WRAPEXCLUDE std::vector<vtkTFCOutline::Handle> GetHandles() const;
  VTK_WRAPEXCLUDE bool GetWidthHandle(vtkTFCOutline::Point& position) const;
  /// The width that puts that handle nearest to a point, 0.01 to 1.
  VTK_WRAPEXCLUDE double WidthAt(const vtkTFCOutline::Point& position) const;
  ///@}

  ///@{
  /**
   * The slider of the opacity beside the region, in pixels: where opacities 0 and 1 are, and where
   * the region's own is. It stays within the plot.
   */
  VTK_WRAPEXCLUDE void GetOpacitySlider(vtkTFCOutline::Point& zero,
    vtkTFCOutline::Point& one) const;
  VTK_WRAPEXCLUDE vtkTFCOutline::Point GetOpacityHandle() const;
  ///@}

  bool Paint(vtkContext2D* painter) override;

protected:
  vtkTFCRegionItem();
  ~vtkTFCRegionItem() override;

private:
  vtkTFCRegionItem(const vtkTFCRegionItem&) = delete;
  void operator=(const vtkTFCRegionItem&) = delete;

  void UpdatePicture();
  void PaintOutline(vtkContext2D* painter);
  void PaintHandles(vtkContext2D* painter);
  void PaintSlider(vtkContext2D* painter);
  void PaintName(vtkContext2D* painter);

  const vtkTFCDomainMapping* Mapping = nullptr;
  vtkSmartPointer<vtkTFCRegion> Region;
  bool Selected = false;
  bool Active = false;
  bool Hovered = false;
  bool Drawn = false; ///< takes part in classification
  std::unique_ptr<vtkTFCCompiledModel> Compiled;

  vtkSmartPointer<vtkImageData> Picture;
  std::array<double, 4> PictureBounds = { { 0, 0, 0, 0 } }; ///< axis units
  std::array<double, 8> PictureKey = { {} };                ///< view and plot of the picture
  bool PictureValid = false;
};

#endif
