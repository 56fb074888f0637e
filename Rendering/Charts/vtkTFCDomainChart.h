// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCDomainChart
 * @brief The plane of the primary and the secondary attribute with its joint histogram and regions,
 * which are drawn, selected and edited with mouse and keys.
 *
 * The chart fills its scene and edits the vtkTFCTransferFunction that it is given, in place. It
 * knows neither ParaView nor Qt: who hosts it listens to its events.
 *
 * Events: StartInteractionEvent when an edit begins, InteractionEvent after every change of the
 * model within it, EndInteractionEvent when it is complete (a created region, a released handle, a
 * key); every InteractionEvent lies between the two. An edit that is cancelled (Escape) puts the
 * model back and ends as well. SelectionChangedEvent; ToolChangedEvent; HoverEvent when what
 * GetHover() returns changes; ViewChangedEvent after zooming and panning; MessageEvent with a
 * const char* that says why a gesture did nothing.
 *
 * Mouse: left selects and drags what it is on (handles of the selected region first), adds to the
 * selection with Shift or Control, and spans a selecting rectangle on empty ground; middle, or left
 * with Alt, pans; the wheel zooms around the pointer. With a tool it draws a new region. While a
 * handle is dragged, Shift keeps proportions (turns in steps of 15 degrees) and Control keeps the
 * centre. The slider beside the selected region changes its opacity, with Shift ten times as
 * finely. A double click on an edge of a polygon inserts a vertex, on a vertex removes it. Keys:
 * see HandleKey().
 */

#ifndef vtkTFCDomainChart_h
#define vtkTFCDomainChart_h

#include "vtkCommand.h" // For event ids
#include "vtkContextItem.h"
#include "vtkNew.h"              // For items
#include "vtkSmartPointer.h"     // For items
#include "vtkTFCChartsModule.h"  // For export macro
#include "vtkTFCDomainMapping.h" // For the mapping
#include "vtkWrappingHints.h"    // For VTK_WRAPEXCLUDE

#include <memory> // For the drag
#include <string> // For names
#include <vector> // For regions

class vtkAxis;
class vtkContextClip;
class vtkTFCHistogramItem;
class vtkTFCRegion;
class vtkTFCRegionItem;
class vtkTFCTransferFunction;

class VTKTFCCHARTS_EXPORT vtkTFCDomainChart : public vtkContextItem
{
public:
  static vtkTFCDomainChart* New();
  vtkTypeMacro(vtkTFCDomainChart, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    ToolChangedEvent = vtkCommand::UserEvent + 1,
    HoverEvent,
    ViewChangedEvent,
    MessageEvent
  };

  ///@{
  /**
   * The model that is shown and edited. Null: an empty chart.
   */
  void SetTransferFunction(vtkTFCTransferFunction* tf);
  vtkTFCTransferFunction* GetTransferFunction() const;
  ///@}

  ///@{
  /**
   * Data units at the two ends of the axes: what vtkTFCTransferFunction::ResolveRanges() returns.
   * low < high. Default 0, 1.
   */
  void SetAxisRanges(const double ranges[4]);
  void GetAxisRanges(double ranges[4]) const;
  ///@}

  void SetAxisTitles(const std::string& primary, const std::string& secondary);

  /**
   * The joint histogram behind the regions.
   */
  vtkTFCHistogramItem* GetHistogram() const;

  ///@{
  /**
   * What is shown, in axis units {xmin, xmax, ymin, ymax}; kept within [-1, 2] and not smaller than
   * 1e-6. Default all of the axes. FitRegions() shows all regions, or the selected ones.
   */
  void SetViewRange(const double view[4]);
  void GetViewRange(double view[4]) const;
  void FitAll();
  void FitRegions(bool selected);
  void Zoom(double factor);
  ///@}

  ///@{
  /**
   * What the left button draws. Tools other than Select become Select again after one region,
   * unless KeepTool. Default Select.
   */
  enum Tools
  {
    Select,
    Ellipse,
    Rectangle,
    Triangle,
    Polygon,
    Lasso
  };
  void SetTool(int tool);
  int GetTool() const { return this->Tool; }
  void SetKeepTool(bool keep) { this->KeepTool = keep; }
  bool GetKeepTool() const { return this->KeepTool; }
  ///@}

  ///@{
  /**
   * Ids of the selected regions, the one that was selected last at the end.
   */
  VTK_WRAPEXCLUDE void SetSelection(const std::vector<int>& ids);
  VTK_WRAPEXCLUDE const std::vector<int>& GetSelection() const { return this->Selection; }
  void SelectAll();
  ///@}

  ///@{
  /**
   * Edits of the selected regions that are not locked, each with its events. Offsets in pixels.
   * They return how many regions changed.
   */
  int MoveSelection(double dx, double dy);
  int ChangeOpacity(double by);
  int DeleteSelection();
  int DuplicateSelection();
  ///@}

  /**
   * A key without a mouse: `key` as Qt or X name it. Arrows move the selection by 1 pixel (10 with
   * Shift), PageUp and PageDown change its opacity by 0.05 (0.01 with Shift), Delete and BackSpace
   * remove it, Tab and Backtab go through the regions, Escape cancels, Return draws a box, ellipse
   * or triangle in the middle with its tool and closes a polygon and BackSpace takes back its last
   * point; v e r t p l choose tools; + - 0 zoom in, out and fit; a with Control selects all, d with
   * Control duplicates. True when the key did something.
   */
  bool HandleKey(const std::string& key, bool shift, bool control);

  /**
   * What the pointer is on: data values, count (-1 where there is no histogram) and region id (0
   * for none). False while it is not in the plot.
   */
  bool GetHover(double data[2], double& count, int& region) const;

  ///@{
  /**
   * A mark at a point in data units, e.g. of a voxel picked in a view.
   */
  void SetProbe(double x, double y);
  void ClearProbe();
  bool HasProbe() const { return this->ProbeShown; }
  ///@}

  /**
   * A new region of the size that a click makes, around the probe's mark where it is in the plot
   * and else in the middle: of the tool's shape, an ellipse while there is none. One edit. False,
   * and nothing new, without a transfer function or during a gesture.
   */
  bool AddRegion();

  ///@{
  /**
   * Look: light on dark, and what is written in an empty chart.
   */
  void SetDark(bool dark);
  bool GetDark() const { return this->Mapping.Dark; }
  void SetMessage(const std::string& message);
  ///@}

  /**
   * Size of the plot, and where data are in it, as of the last Paint(). Pixels of the scene.
   */
  VTK_WRAPEXCLUDE const vtkTFCDomainMapping& GetMapping() const { return this->Mapping; }

  bool IsDragging() const;

  bool Paint(vtkContext2D* painter) override;
  bool Hit(const vtkContextMouseEvent& mouse) override;
  bool MouseMoveEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseLeaveEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseButtonPressEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseButtonReleaseEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseDoubleClickEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseWheelEvent(const vtkContextMouseEvent& mouse, int delta) override;
  bool KeyPressEvent(const vtkContextKeyEvent& key) override;

protected:
  vtkTFCDomainChart();
  ~vtkTFCDomainChart() override;

private:
  vtkTFCDomainChart(const vtkTFCDomainChart&) = delete;
  void operator=(const vtkTFCDomainChart&) = delete;

  using Point = vtkTFCOutline::Point;
  enum class DragModes;
  struct Drag;

  void Layout(vtkContext2D* painter);
  void UpdateItems();
  void PaintTitles(vtkContext2D* painter);
  void PaintGesture(vtkContext2D* painter);
  void PaintOpacity(vtkContext2D* painter);
  void PaintProbe(vtkContext2D* painter);
  void PaintMessage(vtkContext2D* painter);
  void Redraw();
  void Say(const char* message);

  vtkTFCRegionItem* FindItem(int id) const;
  vtkTFCRegion* ActiveRegion() const;
  std::vector<vtkTFCRegion*> EditableSelection();
  int RegionAt(const Point& pixel) const;
  bool HandleAt(const Point& pixel, vtkTFCOutline::Handle& handle, DragModes& mode) const;
  void UpdateHover(const Point& pixel, bool inside);
  void SelectRegion(int id, bool add);
  void SelectInBand();

  void BeginEdit();
  void Changed();
  void EndEdit();
  void CancelGesture();
  void StartDrag(const Point& pixel, int modifiers);
  void ContinueDrag(const Point& pixel, int modifiers);
  void FinishDrag();
  void MoveOriginals(const Point& offset);
  void ShowBox(const Point& pixel, int modifiers);
  void FinishPolygon();
  void FinishLasso();
  vtkTFCRegion* CreateRegion(const vtkTFCOutline& outline);

  vtkSmartPointer<vtkTFCTransferFunction> TransferFunction;
  vtkNew<vtkAxis> Axes[2];
  vtkNew<vtkContextClip> Clip;
  vtkNew<vtkTFCHistogramItem> Histogram;
  std::vector<vtkSmartPointer<vtkTFCRegionItem>> Items; ///< in list order
  vtkMTimeType ItemsTime = 0;                           ///< of the model when they were made
  bool ItemsValid = false;

  vtkTFCDomainMapping Mapping;
  std::vector<int> Selection;
  int Tool = Select;
  bool KeepTool = false;
  std::unique_ptr<Drag> Gesture;
  std::string Message;
  std::string Titles[2];
  double TitleBorders[2] = { 0, 0 }; ///< bottom and left: pixels from the plot to the titles
  Point Probe = { 0, 0 };
  bool ProbeShown = false;
  bool HoverInside = false;
  Point HoverPixel = { 0, 0 };
  int HoverRegion = 0;
};

#endif
