// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the mouse is doing in the domain chart. Private to this module.
 */

#ifndef vtkTFCDomainChartDrag_h
#define vtkTFCDomainChartDrag_h

#include "vtkTFCDomainChart.h"

#include <utility>

enum class vtkTFCDomainChart::DragModes
{
  None,
  Pan,
  Band,    ///< rectangle that selects
  Move,    ///< of the selected regions
  Handle,  ///< of the active region
  Width,   ///< of its fall-off
  Opacity, ///< of the active region
  Box,     ///< drawing an ellipse, rectangle or triangle
  Stroke,  ///< drawing a lasso
  Clicks,  ///< drawing a polygon; goes on between the clicks
  Finished ///< until the button is released
};

struct vtkTFCDomainChart::Drag
{
  DragModes Mode = DragModes::None;
  Point Start = { 0, 0 }; ///< pixels
  Point Last = { 0, 0 };  ///< pixels
  bool Moved = false;     ///< farther than a click
  int ClickSelects = 0;   ///< region to select when it was a click after all
  vtkTFCOutline::Handle Handle;
  std::vector<std::pair<int, vtkTFCOutline>> Originals; ///< region id and outline at the start
  std::array<double, 4> View = { { 0, 1, 0, 1 } };      ///< at the start of panning
  std::vector<Point> Points;                            ///< lasso: pixels; polygon: axis units
  int Created = 0;                                      ///< region that is being drawn
  double Opacity = 0;                                   ///< that the slider has come to
  bool Said = false;                                    ///< one message per gesture
  bool Editing = false; ///< between StartInteractionEvent and EndInteractionEvent
  std::string Before;   ///< state at the start of the edit

  /// Everything but the edit that may be going on.
  void Stop(DragModes mode)
  {
    this->Mode = mode;
    this->Moved = false;
    this->ClickSelects = 0;
    this->Originals.clear();
    this->Points.clear();
    this->Created = 0;
    this->Said = false;
  }
};

#endif
