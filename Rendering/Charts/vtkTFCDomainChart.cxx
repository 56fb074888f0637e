// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCDomainChart.h"

#include "vtkAxis.h"
#include "vtkContextClip.h"
#include "vtkContextScene.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkTFCCompiledModel.h"
#include "vtkTFCDomainChartDrag.h"
#include "vtkTFCHistogramItem.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionItem.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTFCDomainChart);

namespace
{
// So that one cannot get lost, and float coordinates of the graphics stay exact.
constexpr double SMALLEST_VIEW = 1e-6;
constexpr double FARTHEST = 1;
}

vtkTFCDomainChart::vtkTFCDomainChart()
  : Gesture(new Drag)
{
  for (int i = 0; i < 2; ++i)
  {
    this->Axes[i]->SetPosition(i == 0 ? vtkAxis::BOTTOM : vtkAxis::LEFT);
    this->Axes[i]->SetBehavior(vtkAxis::FIXED);
    this->Axes[i]->SetNotation(vtkAxis::PRINTF_NOTATION);
    this->Axes[i]->SetLabelFormat("%.7g");
    this->Axes[i]->SetInteractive(false);
    this->Axes[i]->SetGridVisible(false);
    this->Axes[i]->SetTitle("");
    this->Axes[i]->GetLabelProperties()->SetFontSize(10);
    this->AddItem(this->Axes[i]);
  }
  this->Histogram->SetMapping(&this->Mapping);
  this->Clip->SetInteractive(false);
  this->AddItem(this->Clip);
  this->SetDark(false);
}

vtkTFCDomainChart::~vtkTFCDomainChart() = default;

void vtkTFCDomainChart::SetTransferFunction(vtkTFCTransferFunction* tf)
{
  if (tf != this->TransferFunction)
  {
    this->Gesture->Stop(DragModes::None);
    this->Gesture->Editing = false;
    this->TransferFunction = tf;
    this->Items.clear();
    this->ItemsValid = false;
    this->SetSelection({});
    this->Redraw();
  }
}

vtkTFCTransferFunction* vtkTFCDomainChart::GetTransferFunction() const
{
  return this->TransferFunction;
}

void vtkTFCDomainChart::SetAxisRanges(const double ranges[4])
{
  if (ranges[0] < ranges[1] && ranges[2] < ranges[3] &&
    !std::equal(ranges, ranges + 4, this->Mapping.Ranges.begin()))
  {
    std::copy(ranges, ranges + 4, this->Mapping.Ranges.begin());
    this->ItemsValid = false;
    this->Redraw();
  }
}

void vtkTFCDomainChart::GetAxisRanges(double ranges[4]) const
{
  std::copy(this->Mapping.Ranges.begin(), this->Mapping.Ranges.end(), ranges);
}

void vtkTFCDomainChart::SetAxisTitles(const std::string& primary, const std::string& secondary)
{
  this->Titles[0] = primary;
  this->Titles[1] = secondary;
  this->Redraw();
}

vtkTFCHistogramItem* vtkTFCDomainChart::GetHistogram() const
{
  return this->Histogram;
}

void vtkTFCDomainChart::SetViewRange(const double view[4])
{
  std::array<double, 4> wanted;
  for (int i = 0; i < 2; ++i)
  {
    const double low = -FARTHEST;
    const double high = 1 + FARTHEST;
    const double size = std::clamp(view[2 * i + 1] - view[2 * i], SMALLEST_VIEW, high - low);
    // A view that is too small or too large keeps its centre.
    const double center = (view[2 * i] + view[2 * i + 1]) / 2;
    const double start = std::clamp(center - size / 2, low, high - size);
    wanted[2 * i] = start;
    wanted[2 * i + 1] = start + size;
    if (!std::isfinite(start))
    {
      return;
    }
  }
  if (wanted != this->Mapping.View)
  {
    this->Mapping.View = wanted;
    this->Redraw();
    this->InvokeEvent(ViewChangedEvent);
  }
}

void vtkTFCDomainChart::GetViewRange(double view[4]) const
{
  std::copy(this->Mapping.View.begin(), this->Mapping.View.end(), view);
}

void vtkTFCDomainChart::FitAll()
{
  const double all[4] = { 0, 1, 0, 1 };
  this->SetViewRange(all);
}

void vtkTFCDomainChart::FitRegions(bool selected)
{
  this->UpdateItems();
  std::array<double, 4> all = { { 1e300, -1e300, 1e300, -1e300 } };
  for (const auto& item : this->Items)
  {
    const int id = item->GetRegion()->GetId();
    if (selected &&
      std::find(this->Selection.begin(), this->Selection.end(), id) == this->Selection.end())
    {
      continue;
    }
    const auto bounds = item->GetOutline().GetBounds();
    for (int i = 0; i < 4; i += 2)
    {
      all[i] = std::min(all[i], bounds[i]);
      all[i + 1] = std::max(all[i + 1], bounds[i + 1]);
    }
  }
  if (all[0] > all[1])
  {
    this->FitAll();
    return;
  }
  // Room for the handles around.
  for (int i = 0; i < 4; i += 2)
  {
    const double margin = 0.2 * (all[i + 1] - all[i]);
    all[i] -= margin;
    all[i + 1] += margin;
  }
  this->SetViewRange(all.data());
}

void vtkTFCDomainChart::Zoom(double factor)
{
  const auto& v = this->Mapping.View;
  const double x = (v[1] - v[0]) / 2;
  const double y = (v[3] - v[2]) / 2;
  const double view[4] = { v[0] + x - x / factor, v[0] + x + x / factor, v[2] + y - y / factor,
    v[2] + y + y / factor };
  this->SetViewRange(view);
}

void vtkTFCDomainChart::SetDark(bool dark)
{
  this->Mapping.Dark = dark;
  const double ink = dark ? 0.9 : 0.1;
  for (auto& axis : this->Axes)
  {
    axis->GetPen()->SetColorF(ink, ink, ink, 1.0);
    axis->GetLabelProperties()->SetColor(ink, ink, ink);
  }
  this->Redraw();
}

void vtkTFCDomainChart::SetMessage(const std::string& message)
{
  if (message != this->Message)
  {
    this->Message = message;
    this->Redraw();
  }
}

void vtkTFCDomainChart::SetProbe(double x, double y)
{
  this->Probe = { x, y };
  this->ProbeShown = true;
  this->Redraw();
}

void vtkTFCDomainChart::ClearProbe()
{
  this->ProbeShown = false;
  this->Redraw();
}

void vtkTFCDomainChart::Redraw()
{
  this->Modified();
  if (this->Scene)
  {
    this->Scene->SetDirty(true);
  }
}

void vtkTFCDomainChart::Say(const char* message)
{
  if (!this->Gesture->Said)
  {
    this->Gesture->Said = true;
    this->InvokeEvent(MessageEvent, const_cast<char*>(message));
  }
}

void vtkTFCDomainChart::UpdateItems()
{
  const int count = this->TransferFunction ? this->TransferFunction->GetNumberOfRegions() : 0;
  const vtkMTimeType time = this->TransferFunction ? this->TransferFunction->GetMTime() : 0;
  if (!this->ItemsValid || time != this->ItemsTime)
  {
    const auto& r = this->Mapping.Ranges;
    const double used[4] = { r[0], r[1], r[2], r[3] };
    vtkTFCCompiledModel compiled;
    if (count)
    {
      compiled = this->TransferFunction->Compile(used);
    }
    std::vector<vtkSmartPointer<vtkTFCRegionItem>> items;
    for (int i = 0; i < count; ++i)
    {
      vtkTFCRegion* region = this->TransferFunction->GetRegion(i);
      vtkSmartPointer<vtkTFCRegionItem> item;
      for (const auto& old : this->Items)
      {
        if (old->GetRegion() == region)
        {
          item = old;
        }
      }
      const bool changed = !item || !this->ItemsValid || region->GetMTime() > this->ItemsTime;
      if (!item)
      {
        item = vtkSmartPointer<vtkTFCRegionItem>::New();
        item->SetMapping(&this->Mapping);
        item->SetRegion(region);
      }
      if (changed)
      {
        const auto found = std::find_if(compiled.Regions.begin(), compiled.Regions.end(),
          [&](const vtkTFCCompiledRegion& c) { return c.Id == region->GetId(); });
        item->SetCompiled(&compiled, found == compiled.Regions.end() ? nullptr : &*found);
      }
      items.push_back(item);
    }
    this->Items = std::move(items);
    this->ItemsTime = time;
    this->ItemsValid = true;

    std::vector<int> selection = this->Selection;
    selection.erase(std::remove_if(selection.begin(), selection.end(),
                      [&](int id) { return this->FindItem(id) == nullptr; }),
      selection.end());
    this->SetSelection(selection);
  }
  // The first region of the list is in front, selected ones before all others.
  this->Clip->ClearItems();
  this->Clip->AddItem(this->Histogram);
  for (bool selected : { false, true })
  {
    for (auto item = this->Items.rbegin(); item != this->Items.rend(); ++item)
    {
      const int id = (*item)->GetRegion()->GetId();
      const bool isSelected =
        std::find(this->Selection.begin(), this->Selection.end(), id) != this->Selection.end();
      if (isSelected == selected)
      {
        (*item)->SetLook(isSelected, isSelected && this->Selection.size() == 1,
          id == this->HoverRegion && this->Gesture->Mode == DragModes::None);
        this->Clip->AddItem(*item);
      }
    }
  }
}

void vtkTFCDomainChart::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->Tool << "\n";
  os << indent << "Selected regions: " << this->Selection.size() << "\n";
  os << indent << "View:";
  for (double v : this->Mapping.View)
  {
    os << " " << v;
  }
  os << "\n" << indent << "Dark: " << this->Mapping.Dark << "\n";
}
