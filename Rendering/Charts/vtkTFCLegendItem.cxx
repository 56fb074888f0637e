// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCLegendItem.h"

#include "vtkTFCLegendRows.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionItem.h"
#include "vtkTFCTransferFunction.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkContextClip.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cstdio>

namespace
{

constexpr double MARGIN = 0.02;       // of the scene, at its borders
constexpr double DOMAIN_SHARE = 0.55; // of the width, at most
constexpr double SMALLEST_PLOT = 5;   // font sizes; below there is no room for numbers

//------------------------------------------------------------------------------
// Numbers at both ends: a small axis has too few round ones to read a value from.
void MarkEnds(vtkAxis* axis)
{
  double ends[2];
  axis->GetRange(ends);
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const double value : ends)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    positions->InsertNextValue(value);
    labels->InsertNextValue(text);
  }
  axis->SetCustomTickPositions(positions, labels);
  axis->Update();
}

}

vtkStandardNewMacro(vtkTFCLegendItem);

//------------------------------------------------------------------------------
vtkTFCLegendItem::vtkTFCLegendItem()
  : Rows(new vtkTFCLegendRows)
{
  for (int i = 0; i < 2; ++i)
  {
    this->Axes[i]->SetPosition(i == 0 ? vtkAxis::BOTTOM : vtkAxis::LEFT);
    this->Axes[i]->SetBehavior(vtkAxis::FIXED);
    this->Axes[i]->SetNotation(vtkAxis::PRINTF_NOTATION);
    this->Axes[i]->SetLabelFormat("%.4g");
    this->Axes[i]->SetGridVisible(false);
    this->Axes[i]->SetTitle("");
  }
}

//------------------------------------------------------------------------------
vtkTFCLegendItem::~vtkTFCLegendItem() = default;

//------------------------------------------------------------------------------
void vtkTFCLegendItem::SetTransferFunction(vtkTFCTransferFunction* model)
{
  if (this->Model != model)
  {
    this->Model = model;
    this->RegionsTime = 0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCLegendItem::SetAutomaticRanges(const double primary[2], const double secondary[2])
{
  std::copy(primary, primary + 2, this->AutomaticRanges[0]);
  std::copy(secondary, secondary + 2, this->AutomaticRanges[1]);
  this->HasAutomaticRanges = true;
}

//------------------------------------------------------------------------------
void vtkTFCLegendItem::SetSize(double width, double height)
{
  this->Size[0] = std::clamp(width, 0.05, 1.0);
  this->Size[1] = std::clamp(height, 0.05, 1.0);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkTFCLegendItem::GetNumberOfMissingRows() const
{
  return this->Rows->GetNumberOfMissingRows();
}

//------------------------------------------------------------------------------
std::array<double, 4> vtkTFCLegendItem::FindRectangle() const
{
  const double scene[2] = { static_cast<double>(this->Scene->GetSceneWidth()),
    static_cast<double>(this->Scene->GetSceneHeight()) };
  double place[2] = { this->Position[0], this->Position[1] };
  const bool upper = this->Location >= UpperLeftCorner;
  const bool left = this->Location == LowerLeftCorner || this->Location == UpperLeftCorner;
  const bool right = this->Location == LowerRightCorner || this->Location == UpperRightCorner;
  if (this->Location != AnyLocation)
  {
    place[0] = left ? MARGIN : right ? 1 - MARGIN - this->Size[0] : (1 - this->Size[0]) / 2;
    place[1] = upper ? 1 - MARGIN - this->Size[1] : MARGIN;
  }
  return { { place[0] * scene[0], place[1] * scene[1], this->Size[0] * scene[0],
    this->Size[1] * scene[1] } };
}

//------------------------------------------------------------------------------
// Put the axes where their labels and titles fit into the rectangle.
void vtkTFCLegendItem::LayoutDomain(vtkContext2D* painter, const std::array<double, 4>& rectangle,
  bool numbers)
{
  vtkTFCDomainMapping& map = this->Mapping;
  const double size = this->FontSize * map.Scale;
  double border[2] = { 1.6 * size, 1.6 * size }; // left, bottom: titles
  // Twice: the place of an axis decides on its labels, and their size on its place.
  for (int pass = 0; pass < 2; ++pass)
  {
    // Half a label may stand out at the upper ends.
    map.Plot = { { rectangle[0] + border[0], rectangle[1] + border[1],
      std::max(8.0, rectangle[2] - border[0] - 1.5 * size),
      std::max(8.0, rectangle[3] - border[1] - 0.7 * size) } };
    for (int i = 0; i < 2; ++i)
    {
      vtkAxis* axis = this->Axes[i];
      axis->SetScene(this->Scene);
      const bool known = numbers && (this->HasAutomaticRanges || this->Model->HasAxisRange(i));
      axis->SetLabelsVisible(known);
      axis->SetTicksVisible(known);
      axis->GetLabelProperties()->SetColor(this->TextColor);
      axis->GetLabelProperties()->SetFontSize(this->FontSize);
      axis->GetPen()->SetColorF(this->TextColor);
      axis->GetPen()->SetWidth(static_cast<float>(map.Scale));
      axis->SetTickLength(static_cast<float>(3 * map.Scale));
      axis->SetLabelOffset(static_cast<float>(6 * map.Scale));
      axis->SetPoint1(static_cast<float>(map.Plot[0]), static_cast<float>(map.Plot[1]));
      axis->SetPoint2(static_cast<float>(map.Plot[0] + (i == 0 ? map.Plot[2] : 0)),
        static_cast<float>(map.Plot[1] + (i == 1 ? map.Plot[3] : 0)));
      axis->SetRange(map.Ranges[2 * i], map.Ranges[2 * i + 1]);
      axis->SetCustomTickPositions(nullptr);
      axis->Update();
      if (axis->GetTickLabels()->GetNumberOfValues() < 3)
      {
        MarkEnds(axis);
      }
      double label = 0;
      painter->ApplyTextProp(axis->GetLabelProperties());
      for (vtkIdType tick = 0; known && tick < axis->GetTickLabels()->GetNumberOfValues(); ++tick)
      {
        float box[4];
        painter->ComputeStringBounds(axis->GetTickLabels()->GetValue(tick), box);
        label = std::max(label, static_cast<double>(i == 0 ? box[3] : box[2]));
      }
      border[1 - i] = 1.6 * size + (known ? label + 8 * map.Scale : 0);
    }
  }
}

//------------------------------------------------------------------------------
// An item for each region. They keep their pictures for as long as nothing changes.
void vtkTFCLegendItem::UpdateRegions()
{
  const auto& ranges = this->Mapping.Ranges;
  if (this->RegionsTime == this->Model->GetMTime() && this->RegionsRanges == ranges)
  {
    return;
  }
  this->RegionsTime = this->Model->GetMTime();
  this->RegionsRanges = ranges;
  this->Regions->ClearItems();
  const vtkTFCCompiledModel compiled = this->Model->Compile(ranges.data());
  // The first region of the list is in front: it is drawn last.
  for (auto found = compiled.Regions.rbegin(); found != compiled.Regions.rend(); ++found)
  {
    vtkNew<vtkTFCRegionItem> item;
    item->SetRegion(this->Model->GetRegionById(found->Id));
    item->SetMapping(&this->Mapping);
    item->SetCompiled(&compiled, &*found);
    this->Regions->AddItem(item);
  }
}

//------------------------------------------------------------------------------
void vtkTFCLegendItem::PaintDomain(vtkContext2D* painter)
{
  const auto& plot = this->Mapping.Plot;
  this->UpdateRegions();
  this->Regions->SetClip(static_cast<float>(plot[0]), static_cast<float>(plot[1]),
    static_cast<float>(plot[2]), static_cast<float>(plot[3]));
  this->Regions->SetScene(this->Scene);
  this->Regions->Paint(painter);

  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColorF(this->TextColor);
  painter->GetPen()->SetOpacityF(1);
  painter->GetPen()->SetWidth(static_cast<float>(this->Mapping.Scale));
  const auto left = static_cast<float>(plot[0]);
  const auto right = static_cast<float>(plot[0] + plot[2]);
  const auto bottom = static_cast<float>(plot[1]);
  const auto top = static_cast<float>(plot[1] + plot[3]);
  painter->DrawLine(left, top, right, top);
  painter->DrawLine(right, bottom, right, top);
  for (auto& axis : this->Axes)
  {
    axis->Paint(painter);
  }

  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontFamilyToArial();
  text->SetFontSize(this->FontSize);
  text->SetBold(false);
  text->SetColor(this->TextColor);
  text->SetJustificationToCentered();
  const auto rectangle = this->FindRectangle();
  for (int i = 0; i < 2; ++i)
  {
    std::string title = this->Model->GetAxisArray(i);
    const int component = this->Model->GetAxisComponent(i);
    title += component > 0 ? " [" + std::to_string(component) + "]" : "";
    text->SetOrientation(i == 0 ? 0 : 90);
    i == 0 ? text->SetVerticalJustificationToBottom() : text->SetVerticalJustificationToTop();
    painter->DrawString(i == 0 ? (left + right) / 2 : static_cast<float>(rectangle[0]),
      i == 0 ? static_cast<float>(rectangle[1]) : (bottom + top) / 2, title.c_str());
  }
  text->SetOrientation(0);
}

//------------------------------------------------------------------------------
bool vtkTFCLegendItem::Paint(vtkContext2D* painter)
{
  if (!this->Model || !this->Model->HasAxes())
  {
    return true;
  }
  this->Rows->Update(this->Model);
  if (this->Rows->IsEmpty())
  {
    return true;
  }
  vtkTFCDomainMapping& map = this->Mapping;
  vtkRenderer* renderer = this->Scene->GetRenderer();
  vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr;
  map.Scale = this->Scene->GetLogicalTileScale()[0] * (window ? window->GetDPI() / 72.0 : 1.0);
  // A light text stands on a dark ground.
  map.Dark = this->TextColor[0] + this->TextColor[1] + this->TextColor[2] > 1.5;
  this->Model->ResolveRanges(this->HasAutomaticRanges ? this->AutomaticRanges[0] : nullptr,
    this->HasAutomaticRanges ? this->AutomaticRanges[1] : nullptr, map.Ranges.data());

  const auto rectangle = this->FindRectangle();
  // As high as wide where there is room for both.
  const double width = std::min(DOMAIN_SHARE * rectangle[2], 1.15 * rectangle[3]);
  const std::array<double, 4> place = { { rectangle[0], rectangle[1], width, rectangle[3] } };
  this->LayoutDomain(painter, place, true);
  const double least = SMALLEST_PLOT * this->FontSize * map.Scale;
  if (map.Plot[2] < least || map.Plot[3] < least)
  {
    this->LayoutDomain(painter, place, false);
  }
  this->PaintDomain(painter);

  vtkTFCLegendRows::Style style;
  std::copy(this->TextColor, this->TextColor + 3, style.Color.begin());
  style.FontSize = this->FontSize;
  style.Scale = map.Scale;
  const double gap = this->FontSize * map.Scale;
  this->Rows->Paint(painter,
    { { rectangle[0] + width + gap, rectangle[1], rectangle[2] - width - gap, rectangle[3] } },
    style);
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCLegendItem::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Location: " << this->Location << "\n";
  os << indent << "Position: " << this->Position[0] << " " << this->Position[1] << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "TextColor: " << this->TextColor[0] << " " << this->TextColor[1] << " "
     << this->TextColor[2] << "\n";
  os << indent << "FontSize: " << this->FontSize << "\n";
}
