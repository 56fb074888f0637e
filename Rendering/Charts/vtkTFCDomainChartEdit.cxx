// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Selection, edits of the model with their events, and keys.
#include "vtkTFCDomainChart.h"

#include "vtkContextKeyEvent.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTFCDomainChartDrag.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionItem.h"
#include "vtkTFCShape.h"
#include "vtkTFCTransferFunction.h"

#include <algorithm>
#include <cmath>

namespace
{
using Point = vtkTFCOutline::Point;

bool Has(const std::vector<int>& list, int value)
{
  return std::find(list.begin(), list.end(), value) != list.end();
}
}

vtkTFCRegionItem* vtkTFCDomainChart::FindItem(int id) const
{
  for (const auto& item : this->Items)
  {
    if (item->GetRegion()->GetId() == id)
    {
      return item;
    }
  }
  return nullptr;
}

vtkTFCRegion* vtkTFCDomainChart::ActiveRegion() const
{
  return this->Selection.size() == 1 && this->FindItem(this->Selection[0])
    ? this->TransferFunction->GetRegionById(this->Selection[0])
    : nullptr;
}

std::vector<vtkTFCRegion*> vtkTFCDomainChart::EditableSelection()
{
  std::vector<vtkTFCRegion*> regions;
  this->Gesture->Said = false;
  for (int id : this->Selection)
  {
    vtkTFCRegion* region =
      this->TransferFunction ? this->TransferFunction->GetRegionById(id) : nullptr;
    if (region && region->GetLocked())
    {
      this->Say("The region is locked: unlock it in the list to edit it.");
    }
    else if (region)
    {
      regions.push_back(region);
    }
  }
  return regions;
}

void vtkTFCDomainChart::SetSelection(const std::vector<int>& ids)
{
  if (ids != this->Selection)
  {
    this->Selection = ids;
    this->Redraw();
    this->InvokeEvent(vtkCommand::SelectionChangedEvent);
  }
}

void vtkTFCDomainChart::SelectAll()
{
  std::vector<int> all;
  for (int i = 0; this->TransferFunction && i < this->TransferFunction->GetNumberOfRegions(); ++i)
  {
    all.push_back(this->TransferFunction->GetRegion(i)->GetId());
  }
  this->SetSelection(all);
}

void vtkTFCDomainChart::SelectRegion(int id, bool add)
{
  std::vector<int> selection = { id };
  if (add)
  {
    selection = this->Selection;
    if (Has(selection, id))
    {
      selection.erase(std::remove(selection.begin(), selection.end(), id), selection.end());
    }
    else
    {
      selection.push_back(id);
    }
  }
  this->SetSelection(selection);
}

void vtkTFCDomainChart::SelectInBand()
{
  const Point a = this->Mapping.ToAxis(this->Gesture->Start);
  const Point b = this->Mapping.ToAxis(this->Gesture->Last);
  std::vector<int> selection = this->Selection;
  for (const auto& item : this->Items)
  {
    const auto bounds = item->GetOutline().GetBounds();
    const int id = item->GetRegion()->GetId();
    if (bounds[0] >= std::min(a[0], b[0]) && bounds[1] <= std::max(a[0], b[0]) &&
      bounds[2] >= std::min(a[1], b[1]) && bounds[3] <= std::max(a[1], b[1]) && !Has(selection, id))
    {
      selection.push_back(id);
    }
  }
  this->SetSelection(selection);
}

void vtkTFCDomainChart::SetTool(int tool)
{
  tool = std::clamp(tool, static_cast<int>(Select), static_cast<int>(Lasso));
  if (tool != this->Tool)
  {
    if (this->Gesture->Mode == DragModes::Clicks)
    {
      this->Gesture->Stop(DragModes::None);
    }
    this->Tool = tool;
    this->Redraw();
    this->InvokeEvent(ToolChangedEvent);
  }
}

bool vtkTFCDomainChart::IsDragging() const
{
  return this->Gesture->Editing;
}

void vtkTFCDomainChart::BeginEdit()
{
  if (!this->Gesture->Editing)
  {
    this->Gesture->Editing = true;
    this->Gesture->Before = this->TransferFunction->GetState();
    this->InvokeEvent(vtkCommand::StartInteractionEvent);
    this->TransferFunction->SetProposal(false);
  }
}

void vtkTFCDomainChart::Changed()
{
  this->UpdateItems();
  this->Redraw();
  this->InvokeEvent(vtkCommand::InteractionEvent);
}

void vtkTFCDomainChart::EndEdit()
{
  if (this->Gesture->Editing)
  {
    this->Gesture->Editing = false;
    this->InvokeEvent(vtkCommand::EndInteractionEvent);
  }
}

void vtkTFCDomainChart::CancelGesture()
{
  if (this->Gesture->Editing)
  {
    this->TransferFunction->SetState(this->Gesture->Before.c_str());
    this->Changed();
  }
  this->Gesture->Stop(DragModes::None);
  this->EndEdit();
  this->Redraw();
}

void vtkTFCDomainChart::MoveOriginals(const Point& offset)
{
  // Their centres stay on the axes, or where they were beyond them: nothing gets lost outside.
  Point moved = offset;
  std::vector<vtkTFCRegion*> regions = this->EditableSelection();
  for (const auto& [id, outline] : this->Gesture->Originals)
  {
    const auto bounds = outline.GetBounds();
    for (int i = 0; i < 2; ++i)
    {
      const double center = (bounds[2 * i] + bounds[2 * i + 1]) / 2;
      moved[i] = std::clamp(moved[i], std::min(0.0, -center), std::max(0.0, 1 - center));
    }
  }
  if (regions.empty())
  {
    return;
  }
  if (moved != offset)
  {
    this->Say("The centre of a region stays on the axes: widen the range of the axis.");
  }
  this->BeginEdit();
  for (const auto& [id, outline] : this->Gesture->Originals)
  {
    const auto found = std::find_if(regions.begin(), regions.end(),
      [region = id](const vtkTFCRegion* r) { return r->GetId() == region; });
    if (found != regions.end())
    {
      outline.Moved(moved).Store((*found)->GetShape(), this->Mapping.Ranges);
    }
  }
  this->Changed();
}

int vtkTFCDomainChart::MoveSelection(double dx, double dy)
{
  this->UpdateItems();
  const Point size = this->Mapping.PixelSize();
  this->Gesture->Stop(DragModes::None);
  for (vtkTFCRegion* region : this->EditableSelection())
  {
    this->Gesture->Originals.emplace_back(region->GetId(),
      this->FindItem(region->GetId())->GetOutline());
  }
  const int count = static_cast<int>(this->Gesture->Originals.size());
  this->MoveOriginals({ dx * size[0], dy * size[1] });
  this->Gesture->Stop(DragModes::None);
  this->EndEdit();
  return count;
}

int vtkTFCDomainChart::ChangeOpacity(double by)
{
  const std::vector<vtkTFCRegion*> regions = this->EditableSelection();
  if (!regions.empty())
  {
    this->BeginEdit();
    for (vtkTFCRegion* region : regions)
    {
      // To a thousandth: sums of 0.05 should not become 0.15000000000000002.
      region->SetOpacity(std::round(1000 * std::clamp(region->GetOpacity() + by, 0.0, 1.0)) / 1000);
    }
    this->Changed();
    this->EndEdit();
  }
  return static_cast<int>(regions.size());
}

int vtkTFCDomainChart::DeleteSelection()
{
  const std::vector<vtkTFCRegion*> regions = this->EditableSelection();
  if (!regions.empty())
  {
    this->BeginEdit();
    for (vtkTFCRegion* region : regions)
    {
      this->TransferFunction->RemoveRegion(region);
    }
    this->Changed();
    this->EndEdit();
  }
  return static_cast<int>(regions.size());
}

int vtkTFCDomainChart::DuplicateSelection()
{
  this->UpdateItems();
  std::vector<int> copies;
  const std::vector<int> originals = this->Selection;
  for (int id : originals)
  {
    vtkTFCRegion* region = this->TransferFunction->GetRegionById(id);
    if (!region)
    {
      continue;
    }
    this->BeginEdit();
    vtkNew<vtkTFCRegion> copy;
    copy->DeepCopy(region);
    copy->SetLocked(false);
    copy->SetName((region->GetName() + " copy").c_str());
    const Point size = this->Mapping.PixelSize();
    const double offset = 12 * this->Mapping.Scale;
    vtkTFCOutline::FromShape(copy->GetShape(), this->Mapping.Ranges)
      .Moved({ offset * size[0], -offset * size[1] })
      .Store(copy->GetShape(), this->Mapping.Ranges);
    copies.push_back(this->TransferFunction->AddRegion(copy));
  }
  if (!copies.empty())
  {
    this->Changed();
    this->SetSelection(copies);
    this->EndEdit();
  }
  return static_cast<int>(copies.size());
}

bool vtkTFCDomainChart::HandleKey(const std::string& key, bool shift, bool control)
{
  static const std::string tools = "vertpl";
  const double step = shift ? 10 : 1;
  const bool clicking = this->Gesture->Mode == DragModes::Clicks;
  if (key == "Escape")
  {
    if (this->Gesture->Mode == DragModes::None && this->Tool == Select)
    {
      this->SetSelection({});
    }
    const bool idle = this->Gesture->Mode == DragModes::None;
    this->CancelGesture();
    if (idle)
    {
      this->SetTool(Select);
    }
    return true;
  }
  if (!this->TransferFunction || this->Gesture->Editing)
  {
    return false;
  }
  if (clicking && (key == "Return" || key == "Enter"))
  {
    this->FinishPolygon();
    this->Gesture->Stop(DragModes::None);
    return true;
  }
  if (key == "Return" && this->Tool >= Ellipse && this->Tool <= Triangle)
  {
    return this->AddRegion();
  }
  if (clicking && (key == "BackSpace" || key == "Backspace"))
  {
    this->Gesture->Points.pop_back();
    if (this->Gesture->Points.empty())
    {
      this->Gesture->Stop(DragModes::None);
    }
    this->Redraw();
    return true;
  }
  if (key == "Left" || key == "Right" || key == "Up" || key == "Down")
  {
    const double dx = key == "Left" ? -step : (key == "Right" ? step : 0);
    const double dy = key == "Down" ? -step : (key == "Up" ? step : 0);
    return this->MoveSelection(dx, dy) > 0;
  }
  if (key == "PageUp" || key == "Prior" || key == "PageDown" || key == "Next")
  {
    const double change = shift ? 0.01 : 0.05;
    return this->ChangeOpacity(key == "PageUp" || key == "Prior" ? change : -change) > 0;
  }
  if (key == "Delete" || key == "BackSpace" || key == "Backspace")
  {
    return this->DeleteSelection() > 0;
  }
  if (key == "Tab" || key == "Backtab" || key == "ISO_Left_Tab")
  {
    const int count = this->TransferFunction->GetNumberOfRegions();
    int index = key == "Tab" && !shift ? -1 : count;
    for (int i = 0; i < count && !this->Selection.empty(); ++i)
    {
      if (this->TransferFunction->GetRegion(i)->GetId() == this->Selection.back())
      {
        index = i;
      }
    }
    index += key == "Tab" && !shift ? 1 : -1;
    // Beyond the last one the key is not ours: the focus moves on to the next widget.
    if (index < 0 || index >= count)
    {
      return false;
    }
    this->SetSelection({ this->TransferFunction->GetRegion(index)->GetId() });
    return true;
  }
  if (control)
  {
    if (key == "a" || key == "A")
    {
      this->SelectAll();
      return true;
    }
    return (key == "d" || key == "D") && this->DuplicateSelection() > 0;
  }
  if (key.size() == 1)
  {
    const char c = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
    const size_t tool = tools.find(c);
    if (tool != std::string::npos)
    {
      this->SetTool(static_cast<int>(tool));
      return true;
    }
    if (c == '+' || c == '=' || c == '-')
    {
      this->Zoom(c == '-' ? 1 / 1.2 : 1.2);
      return true;
    }
    if (c == '0')
    {
      this->FitAll();
      return true;
    }
  }
  return false;
}

bool vtkTFCDomainChart::KeyPressEvent(const vtkContextKeyEvent& key)
{
  vtkRenderWindowInteractor* interactor = key.GetInteractor();
  const char* sym = interactor ? interactor->GetKeySym() : nullptr;
  return sym && this->HandleKey(sym, interactor->GetShiftKey(), interactor->GetControlKey());
}
