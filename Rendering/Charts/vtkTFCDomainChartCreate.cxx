// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// New regions from what was drawn.
#include "vtkTFCDomainChart.h"

#include "vtkContextMouseEvent.h"
#include "vtkTFCDomainChartDrag.h"
#include "vtkTFCLasso.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTFCTransferFunction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Point = vtkTFCOutline::Point;

// Points of 1/72 inch: how far a lasso may be from what was drawn, and the side of the square that
// it must enclose at least.
constexpr double LASSO_TOLERANCE = 1.5;
constexpr double LASSO_SIDE = 3;

vtkTFCOutline::Types BoxType(int tool)
{
  return tool == vtkTFCDomainChart::Ellipse
    ? vtkTFCOutline::Types::Ellipse
    : (tool == vtkTFCDomainChart::Rectangle ? vtkTFCOutline::Types::Rectangle
                                            : vtkTFCOutline::Types::Triangle);
}
}

void vtkTFCDomainChart::ShowBox(const Point& pixel, int modifiers)
{
  Drag& drag = *this->Gesture;
  Point start = drag.Start;
  Point end = pixel;
  if (modifiers & vtkContextMouseEvent::SHIFT_MODIFIER)
  {
    // As wide as high, in pixels.
    const double size = std::max(std::abs(end[0] - start[0]), std::abs(end[1] - start[1]));
    end = { start[0] + std::copysign(size, end[0] - start[0]),
      start[1] + std::copysign(size, end[1] - start[1]) };
  }
  if (modifiers & vtkContextMouseEvent::CONTROL_MODIFIER)
  {
    start = { 2 * start[0] - end[0], 2 * start[1] - end[1] };
  }
  const vtkTFCOutline outline = vtkTFCOutline::Between(BoxType(this->Tool),
    this->Mapping.ToAxis(start), this->Mapping.ToAxis(end));
  vtkTFCRegion* region =
    drag.Created ? this->TransferFunction->GetRegionById(drag.Created) : nullptr;
  if (!outline.IsValid())
  {
    return;
  }
  this->BeginEdit();
  if (region)
  {
    outline.Store(region->GetShape(), this->Mapping.Ranges);
  }
  else if ((region = this->CreateRegion(outline)))
  {
    drag.Created = region->GetId();
  }
  this->Changed();
}

bool vtkTFCDomainChart::AddRegion()
{
  if (!this->TransferFunction || this->Gesture->Editing)
  {
    return false;
  }
  // As a click there: drawing without a mouse.
  const auto& plot = this->Mapping.Plot;
  const Point probe = this->Mapping.ToPixel(this->Mapping.FromData(this->Probe));
  const Point middle = { plot[0] + plot[2] / 2, plot[1] + plot[3] / 2 };
  this->CancelGesture();
  const int tool = this->Tool;
  const bool draws = tool >= Ellipse && tool <= Triangle;
  if (!draws)
  {
    this->SetTool(Ellipse);
  }
  this->Gesture->Stop(DragModes::Box);
  this->Gesture->Start = this->ProbeShown && this->Mapping.InPlot(probe) ? probe : middle;
  this->FinishDrag();
  if (!draws)
  {
    this->SetTool(tool);
  }
  return true;
}

void vtkTFCDomainChart::FinishLasso()
{
  const double scale = this->Mapping.Scale;
  std::vector<Point> points = vtkTFCSimplifyLasso(this->Gesture->Points, LASSO_TOLERANCE * scale,
    LASSO_SIDE * LASSO_SIDE * scale * scale);
  if (points.empty())
  {
    this->Say("The lasso encloses nothing: draw around what the region shall hold.");
    return;
  }
  for (Point& p : points)
  {
    p = this->Mapping.ToAxis(p);
  }
  this->BeginEdit();
  this->CreateRegion(vtkTFCOutline::FromPoints(points));
  this->Changed();
  if (!this->KeepTool)
  {
    this->SetTool(Select);
  }
}

void vtkTFCDomainChart::FinishPolygon()
{
  Drag& drag = *this->Gesture;
  const vtkTFCOutline outline = vtkTFCOutline::FromPoints(drag.Points);
  const bool valid = outline.IsValid();
  // The button may still be down.
  drag.Stop(DragModes::Finished);
  if (!valid)
  {
    this->Say(
      "A polygon needs three corners that are not on one line: click at least three times.");
    return;
  }
  this->BeginEdit();
  this->CreateRegion(outline);
  this->Changed();
  this->EndEdit();
  if (!this->KeepTool)
  {
    this->SetTool(Select);
  }
}

vtkTFCRegion* vtkTFCDomainChart::CreateRegion(const vtkTFCOutline& outline)
{
  vtkSmartPointer<vtkTFCShape> shape = outline.NewShape(this->Mapping.Ranges);
  if (!shape)
  {
    this->Say("The shape encloses nothing.");
    return nullptr;
  }
  // The palette's colour that the fewest regions have.
  double color[3];
  int best = 0;
  int fewest = std::numeric_limits<int>::max();
  for (int n = 0; n < 8; ++n)
  {
    double used[3];
    int count = 0;
    vtkTFCRegion::GetPaletteColor(n, color);
    for (int i = 0; i < this->TransferFunction->GetNumberOfRegions(); ++i)
    {
      this->TransferFunction->GetRegion(i)->GetColor(used);
      count += std::equal(used, used + 3, color);
    }
    if (count < fewest)
    {
      fewest = count;
      best = n;
    }
  }
  vtkTFCRegion::GetPaletteColor(best, color);
  vtkNew<vtkTFCRegion> region;
  region->SetShape(shape);
  region->SetColor(color[0], color[1], color[2]);
  region->SetOpacity(0.5);
  const int id = this->TransferFunction->AddRegion(region);
  this->UpdateItems();
  this->SetSelection({ id });
  return id ? this->TransferFunction->GetRegionById(id) : nullptr;
}
