// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Mouse: what is under the pointer, and the gestures.
#include "vtkTFCDomainChart.h"

#include "vtkContextMouseEvent.h"
#include "vtkTFCDomainChartDrag.h"
#include "vtkTFCHistogramItem.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionItem.h"
#include "vtkTFCShape.h"
#include "vtkTFCTransferFunction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Point = vtkTFCOutline::Point;

// Points of 1/72 inch: how near a handle or an edge is hit, and how far a click may slip.
constexpr double REACH = 7;
constexpr double SLIP = 3;

Point PositionOf(const vtkContextMouseEvent& mouse)
{
  return { mouse.GetPos().GetX(), mouse.GetPos().GetY() };
}

double Distance(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}
}

bool vtkTFCDomainChart::Hit(const vtkContextMouseEvent& vtkNotUsed(mouse))
{
  return this->GetVisible();
}

int vtkTFCDomainChart::RegionAt(const Point& pixel) const
{
  // The smallest one: what lies inside a large region stays within reach.
  int id = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& item : this->Items)
  {
    const vtkTFCOutline outline = item->GetOutline();
    const double area = outline.GetArea();
    if (area < smallest && outline.Contains(this->Mapping.ToAxis(pixel)))
    {
      id = item->GetRegion()->GetId();
      smallest = area;
    }
  }
  return id;
}

bool vtkTFCDomainChart::HandleAt(const Point& pixel, vtkTFCOutline::Handle& handle,
  DragModes& mode) const
{
  vtkTFCRegionItem* item =
    this->Selection.size() == 1 ? this->FindItem(this->Selection[0]) : nullptr;
  if (!item || item->GetRegion()->GetLocked())
  {
    return false;
  }
  double nearest = REACH * this->Mapping.Scale;
  mode = DragModes::None;
  for (const vtkTFCOutline::Handle& candidate : item->GetHandles())
  {
    const double distance = Distance(pixel, this->Mapping.ToPixel(candidate.Position));
    if (distance < nearest)
    {
      nearest = distance;
      handle = candidate;
      mode = DragModes::Handle;
    }
  }
  Point position;
  if (item->GetWidthHandle(position) && Distance(pixel, this->Mapping.ToPixel(position)) < nearest)
  {
    nearest = Distance(pixel, this->Mapping.ToPixel(position));
    mode = DragModes::Width;
  }
  if (Distance(pixel, item->GetOpacityHandle()) < nearest)
  {
    mode = DragModes::Opacity;
  }
  return mode != DragModes::None;
}

void vtkTFCDomainChart::UpdateHover(const Point& pixel, bool inside)
{
  const int region = inside ? this->RegionAt(pixel) : 0;
  if (region != this->HoverRegion)
  {
    this->Redraw();
  }
  if (inside || this->HoverInside)
  {
    this->HoverPixel = pixel;
    this->HoverInside = inside;
    this->HoverRegion = region;
    this->InvokeEvent(HoverEvent);
  }
}

bool vtkTFCDomainChart::GetHover(double data[2], double& count, int& region) const
{
  if (!this->HoverInside)
  {
    return false;
  }
  const Point p = this->Mapping.ToData(this->Mapping.ToAxis(this->HoverPixel));
  data[0] = p[0];
  data[1] = p[1];
  count = this->Histogram->GetCount(p[0], p[1]);
  region = this->HoverRegion;
  return true;
}

bool vtkTFCDomainChart::MouseButtonPressEvent(const vtkContextMouseEvent& mouse)
{
  const Point pixel = PositionOf(mouse);
  Drag& drag = *this->Gesture;
  if (!this->TransferFunction || !this->Mapping.InPlot(pixel))
  {
    return true;
  }
  const bool clicking = drag.Mode == DragModes::Clicks;
  const bool left = mouse.GetButton() == vtkContextMouseEvent::LEFT_BUTTON;
  const int modifiers = mouse.GetModifiers();
  if (!clicking)
  {
    this->CancelGesture();
  }
  if (mouse.GetButton() == vtkContextMouseEvent::MIDDLE_BUTTON ||
    (left && !clicking && (modifiers & vtkContextMouseEvent::ALT_MODIFIER)))
  {
    if (!clicking)
    {
      drag.Stop(DragModes::Pan);
      drag.Start = drag.Last = pixel;
      drag.View = this->Mapping.View;
    }
    return true;
  }
  if (left)
  {
    drag.Start = drag.Last = pixel;
    this->StartDrag(pixel, modifiers);
    this->Redraw();
  }
  return true;
}

void vtkTFCDomainChart::StartDrag(const Point& pixel, int modifiers)
{
  Drag& drag = *this->Gesture;
  const Point axis = this->Mapping.ToAxis(pixel);
  switch (this->Tool)
  {
    case Ellipse:
    case Rectangle:
    case Triangle:
      drag.Stop(DragModes::Box);
      return;
    case Lasso:
      drag.Stop(DragModes::Stroke);
      drag.Points = { pixel };
      return;
    case Polygon:
      if (drag.Mode != DragModes::Clicks)
      {
        drag.Stop(DragModes::Clicks);
      }
      else if (drag.Points.size() >= 3 &&
        Distance(pixel, this->Mapping.ToPixel(drag.Points[0])) < REACH * this->Mapping.Scale)
      {
        this->FinishPolygon();
        return;
      }
      drag.Points.push_back(axis);
      return;
    default:
      break;
  }

  drag.Stop(DragModes::None);
  DragModes onHandle = DragModes::None;
  const int region = this->RegionAt(pixel);
  const bool add =
    (modifiers & (vtkContextMouseEvent::SHIFT_MODIFIER | vtkContextMouseEvent::CONTROL_MODIFIER));
  if (this->HandleAt(pixel, drag.Handle, onHandle))
  {
    drag.Mode = onHandle;
    drag.Opacity = this->ActiveRegion()->GetOpacity();
  }
  else if (region)
  {
    const bool onSelected = std::any_of(this->Selection.begin(), this->Selection.end(),
      [&](int id)
      { return this->FindItem(id) && this->FindItem(id)->GetOutline().Contains(axis); });
    if (add || !onSelected)
    {
      this->SelectRegion(region, add);
    }
    else
    {
      drag.ClickSelects = region;
    }
    drag.Mode = this->Selection.empty() ? DragModes::Finished : DragModes::Move;
  }
  else
  {
    drag.Mode = DragModes::Band;
    if (!add)
    {
      this->SetSelection({});
    }
  }
  for (int id : this->Selection)
  {
    if (vtkTFCRegionItem* item = this->FindItem(id))
    {
      drag.Originals.emplace_back(id, item->GetOutline());
    }
  }
}

bool vtkTFCDomainChart::MouseMoveEvent(const vtkContextMouseEvent& mouse)
{
  const Point pixel = PositionOf(mouse);
  const DragModes mode = this->Gesture->Mode;
  if (mode != DragModes::None && mode != DragModes::Finished)
  {
    this->ContinueDrag(pixel, mouse.GetModifiers());
  }
  this->UpdateHover(pixel, this->Mapping.InPlot(pixel));
  return true;
}

bool vtkTFCDomainChart::MouseLeaveEvent(const vtkContextMouseEvent& mouse)
{
  this->UpdateHover(PositionOf(mouse), false);
  return true;
}

void vtkTFCDomainChart::ContinueDrag(const Point& pixel, int modifiers)
{
  Drag& drag = *this->Gesture;
  const double rise = pixel[1] - (drag.Moved ? drag.Last : drag.Start)[1];
  drag.Last = pixel;
  if (!drag.Moved && Distance(pixel, drag.Start) < SLIP * this->Mapping.Scale &&
    drag.Mode != DragModes::Clicks)
  {
    return;
  }
  drag.Moved = true;
  const Point from = this->Mapping.ToAxis(drag.Start);
  const Point to = this->Mapping.ToAxis(pixel);
  vtkTFCOutline::Constraints constraints;
  constraints.Proportional = modifiers & vtkContextMouseEvent::SHIFT_MODIFIER;
  constraints.Symmetric = modifiers & vtkContextMouseEvent::CONTROL_MODIFIER;
  vtkTFCRegion* region = this->ActiveRegion();
  switch (drag.Mode)
  {
    case DragModes::Pan:
    {
      const Point size = this->Mapping.PixelSize();
      const double dx = (drag.Start[0] - pixel[0]) * size[0];
      const double dy = (drag.Start[1] - pixel[1]) * size[1];
      const double view[4] = { drag.View[0] + dx, drag.View[1] + dx, drag.View[2] + dy,
        drag.View[3] + dy };
      this->SetViewRange(view);
      break;
    }
    case DragModes::Stroke:
      drag.Points.push_back(pixel);
      break;
    case DragModes::Box:
      this->ShowBox(pixel, modifiers);
      break;
    case DragModes::Move:
      this->MoveOriginals({ to[0] - from[0], to[1] - from[1] });
      break;
    case DragModes::Width:
      this->BeginEdit();
      region->SetFalloff(region->GetFalloffType(), this->FindItem(region->GetId())->WidthAt(to));
      this->Changed();
      break;
    case DragModes::Opacity:
    {
      Point zero;
      Point one;
      this->FindItem(region->GetId())->GetOpacitySlider(zero, one);
      const double fine = constraints.Proportional ? 0.1 : 1.0;
      drag.Opacity = std::clamp(drag.Opacity + fine * rise / (one[1] - zero[1]), 0.0, 1.0);
      this->BeginEdit();
      // Numbers that one can read: to a hundredth, with Shift to a thousandth.
      region->SetOpacity(std::round(drag.Opacity * 100 / fine) / (100 / fine));
      this->Changed();
      break;
    }
    case DragModes::Handle:
    {
      this->BeginEdit();
      const Point size = this->Mapping.PixelSize();
      const vtkTFCOutline outline = drag.Originals[0].second.Drag(drag.Handle, from, to,
        constraints, { 2 * size[0], 2 * size[1] });
      if (outline.Store(region->GetShape(), this->Mapping.Ranges))
      {
        this->Changed();
      }
      else
      {
        this->Say("The corners would lie on one line: the shape stays as it was.");
      }
      break;
    }
    default:
      break;
  }
  this->Redraw();
}

bool vtkTFCDomainChart::MouseButtonReleaseEvent(const vtkContextMouseEvent& mouse)
{
  if (this->Gesture->Mode != DragModes::Clicks)
  {
    this->Gesture->Last = PositionOf(mouse);
    this->FinishDrag();
    this->Redraw();
  }
  return true;
}

void vtkTFCDomainChart::FinishDrag()
{
  Drag& drag = *this->Gesture;
  switch (drag.Mode)
  {
    case DragModes::Band:
      if (drag.Moved)
      {
        this->SelectInBand();
      }
      break;
    case DragModes::Move:
      if (!drag.Moved && drag.ClickSelects)
      {
        this->SelectRegion(drag.ClickSelects, false);
      }
      break;
    case DragModes::Stroke:
      this->FinishLasso();
      break;
    case DragModes::Box:
      if (!drag.Created)
      {
        // A click instead of a drag: a region of an eighth of the view.
        const double x = this->Mapping.Plot[2] / 16;
        const double y = this->Mapping.Plot[3] / 16;
        const Point center = drag.Start;
        drag.Start = { center[0] - x, center[1] - y };
        this->ShowBox({ center[0] + x, center[1] + y }, 0);
      }
      if (!this->KeepTool)
      {
        this->SetTool(Select);
      }
      break;
    default:
      break;
  }
  drag.Stop(DragModes::None);
  this->EndEdit();
}

bool vtkTFCDomainChart::MouseDoubleClickEvent(const vtkContextMouseEvent& mouse)
{
  if (mouse.GetButton() != vtkContextMouseEvent::LEFT_BUTTON || !this->TransferFunction)
  {
    return true;
  }
  const Point pixel = PositionOf(mouse);
  Drag& drag = *this->Gesture;
  if (drag.Mode == DragModes::Clicks)
  {
    this->FinishPolygon();
    this->Redraw();
    return true;
  }
  vtkTFCRegion* region = this->ActiveRegion();
  vtkTFCOutline::Handle handle;
  DragModes kind = DragModes::None;
  if (this->Tool != Select || !region || region->GetLocked())
  {
    return true;
  }
  vtkTFCOutline outline = this->FindItem(region->GetId())->GetOutline();
  if (outline.IsBox())
  {
    return true;
  }
  const bool onHandle = this->HandleAt(pixel, handle, kind);
  double distance;
  const int edge =
    outline.NearestEdge(this->Mapping.ToAxis(pixel), this->Mapping.PixelSize(), &distance);
  bool changed = false;
  if (kind == DragModes::Handle && handle.Kind == vtkTFCOutline::Handles::Vertex)
  {
    changed = outline.RemoveVertex(handle.Index);
    if (!changed)
    {
      this->Say("A polygon keeps at least three corners that are not on one line.");
    }
  }
  else if (!onHandle && distance < REACH * this->Mapping.Scale)
  {
    changed = outline.InsertVertex(edge, this->Mapping.ToAxis(pixel));
  }
  if (changed)
  {
    this->BeginEdit();
    region->SetShape(outline.NewShape(this->Mapping.Ranges));
    this->Changed();
    this->EndEdit();
  }
  this->Gesture->Stop(DragModes::Finished);
  return true;
}

bool vtkTFCDomainChart::MouseWheelEvent(const vtkContextMouseEvent& mouse, int delta)
{
  const Point pixel = PositionOf(mouse);
  if (this->Mapping.InPlot(pixel))
  {
    const Point p = this->Mapping.ToAxis(pixel);
    const double factor = std::pow(1.2, -delta);
    const auto& v = this->Mapping.View;
    const double view[4] = { p[0] + (v[0] - p[0]) * factor, p[0] + (v[1] - p[0]) * factor,
      p[1] + (v[2] - p[1]) * factor, p[1] + (v[3] - p[1]) * factor };
    this->SetViewRange(view);
  }
  return true;
}
