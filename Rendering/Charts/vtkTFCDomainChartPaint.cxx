// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Where things are, and what is drawn over the items.
#include "vtkTFCDomainChart.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkContextClip.h"
#include "vtkContextScene.h"
#include "vtkPen.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTFCDomainChartDrag.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionItem.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace
{
constexpr int TITLE_SIZE = 12;  // points
constexpr int LABEL_OFFSET = 8; // points, from the axis
}

void vtkTFCDomainChart::Layout(vtkContext2D* painter)
{
  vtkTFCDomainMapping& map = this->Mapping;
  const double width = this->Scene->GetSceneWidth();
  const double height = this->Scene->GetSceneHeight();
  vtkRenderer* renderer = this->Scene->GetRenderer();
  if (renderer && renderer->GetRenderWindow())
  {
    map.Scale = std::max(1.0, renderer->GetRenderWindow()->GetDPI() / 72.0);
  }
  const double margin = 10 * map.Scale;
  double border[2] = { 0, 0 }; // left, bottom
  // Twice: the place of an axis decides on its labels, and their size on its place.
  for (int pass = 0; pass < 2; ++pass)
  {
    map.Plot = { { margin + border[0], margin + border[1],
      // At the right, room for half of the last label.
      std::max(8.0, width - 3 * margin - border[0]),
      std::max(8.0, height - 2 * margin - border[1]) } };
    for (int i = 0; i < 2; ++i)
    {
      const double* view = &map.View[2 * i];
      const double low = map.Ranges[2 * i];
      const double size = map.Ranges[2 * i + 1] - low;
      vtkAxis* axis = this->Axes[i];
      axis->GetPen()->SetWidth(static_cast<float>(map.Scale));
      axis->SetTickLength(static_cast<float>(3 * map.Scale));
      axis->SetLabelOffset(static_cast<float>(LABEL_OFFSET * map.Scale));
      axis->SetMargins(static_cast<int>(6 * map.Scale), static_cast<int>(6 * map.Scale));
      axis->SetPoint1(static_cast<float>(map.Plot[0]), static_cast<float>(map.Plot[1]));
      axis->SetPoint2(static_cast<float>(map.Plot[0] + (i == 0 ? map.Plot[2] : 0)),
        static_cast<float>(map.Plot[1] + (i == 1 ? map.Plot[3] : 0)));
      axis->SetRange(low + view[0] * size, low + view[1] * size);
      axis->Update();
      // Not GetBoundingRect(), which ignores the offset of the labels.
      double label = 0;
      painter->ApplyTextProp(axis->GetLabelProperties());
      for (vtkIdType tick = 0; tick < axis->GetTickLabels()->GetNumberOfValues(); ++tick)
      {
        float box[4];
        painter->ComputeStringBounds(axis->GetTickLabels()->GetValue(tick), box);
        label = std::max(label, static_cast<double>(i == 0 ? box[3] : box[2]));
      }
      this->TitleBorders[i] = label + (LABEL_OFFSET + 3) * map.Scale;
      border[1 - i] = this->TitleBorders[i] + TITLE_SIZE * 1.4 * map.Scale;
    }
  }
  this->Clip->SetClip(static_cast<float>(map.Plot[0]), static_cast<float>(map.Plot[1]),
    static_cast<float>(map.Plot[2]), static_cast<float>(map.Plot[3]));
}

// Not by vtkAxis: its distance between labels and title is in pixels, so that they overlap on
// screens of high density (VTK 9.2, Charts/Core/vtkAxis.cxx, CalculateTitlePosition()).
void vtkTFCDomainChart::PaintTitles(vtkContext2D* painter)
{
  const auto& plot = this->Mapping.Plot;
  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontFamilyToArial();
  text->SetFontSize(TITLE_SIZE);
  text->SetBold(false);
  text->SetOpacity(1);
  const double ink = this->Mapping.Dark ? 0.9 : 0.1;
  text->SetColor(ink, ink, ink);
  text->SetJustificationToCentered();
  for (int i = 0; i < 2; ++i)
  {
    text->SetOrientation(i == 0 ? 0 : 90);
    i == 0 ? text->SetVerticalJustificationToTop() : text->SetVerticalJustificationToBottom();
    const double x = i == 0 ? plot[0] + plot[2] / 2 : plot[0] - this->TitleBorders[1];
    const double y = i == 0 ? plot[1] - this->TitleBorders[0] : plot[1] + plot[3] / 2;
    painter->DrawString(static_cast<float>(x), static_cast<float>(y), this->Titles[i].c_str());
  }
  text->SetOrientation(0);
}

void vtkTFCDomainChart::PaintGesture(vtkContext2D* painter)
{
  const Drag& drag = *this->Gesture;
  std::vector<float> line;
  const auto add = [&line](const Point& p)
  {
    line.push_back(static_cast<float>(p[0]));
    line.push_back(static_cast<float>(p[1]));
  };
  switch (drag.Mode)
  {
    case DragModes::Band:
      add(drag.Start);
      add({ drag.Last[0], drag.Start[1] });
      add(drag.Last);
      add({ drag.Start[0], drag.Last[1] });
      add(drag.Start);
      break;
    case DragModes::Stroke:
      std::for_each(drag.Points.begin(), drag.Points.end(), add);
      add(drag.Start);
      break;
    case DragModes::Clicks:
      for (const Point& p : drag.Points)
      {
        add(this->Mapping.ToPixel(p));
      }
      add(drag.Last);
      break;
    default:
      return;
  }
  const double ink = this->Mapping.Dark ? 1.0 : 0.0;
  vtkPen* pen = painter->GetPen();
  pen->SetOpacityF(1);
  pen->SetColorF(1 - ink, 1 - ink, 1 - ink);
  pen->SetWidth(static_cast<float>(3 * this->Mapping.Scale));
  pen->SetLineType(vtkPen::SOLID_LINE);
  painter->DrawPoly(line.data(), static_cast<int>(line.size() / 2));
  pen->SetColorF(ink, ink, ink);
  pen->SetWidth(static_cast<float>(1.3 * this->Mapping.Scale));
  painter->DrawPoly(line.data(), static_cast<int>(line.size() / 2));
  if (drag.Mode == DragModes::Clicks)
  {
    // The first point: a click on it closes the polygon.
    painter->GetBrush()->SetColorF(1 - ink, 1 - ink, 1 - ink, 1.0);
    painter->DrawEllipse(line[0], line[1], static_cast<float>(4 * this->Mapping.Scale),
      static_cast<float>(4 * this->Mapping.Scale));
  }
}

// The number, while the slider is dragged.
void vtkTFCDomainChart::PaintOpacity(vtkContext2D* painter)
{
  vtkTFCRegion* region = this->ActiveRegion();
  if (this->Gesture->Mode != DragModes::Opacity || !region)
  {
    return;
  }
  const Point handle = this->FindItem(region->GetId())->GetOpacityHandle();
  const auto& plot = this->Mapping.Plot;
  std::array<char, 16> label;
  std::snprintf(label.data(), label.size(), "%.3g", region->GetOpacity());
  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontFamilyToArial();
  text->SetFontSize(12);
  text->SetBold(true);
  text->SetOrientation(0);
  text->SetOpacity(1);
  const double ink = this->Mapping.Dark ? 0.95 : 0.1;
  text->SetColor(ink, ink, ink);
  const bool right = handle[0] < plot[0] + plot[2] - 50 * this->Mapping.Scale;
  right ? text->SetJustificationToLeft() : text->SetJustificationToRight();
  text->SetVerticalJustificationToCentered();
  const double x = handle[0] + (right ? 11 : -11) * this->Mapping.Scale;
  painter->DrawString(static_cast<float>(x), static_cast<float>(handle[1]), label.data());
  text->SetBold(false);
}

void vtkTFCDomainChart::PaintProbe(vtkContext2D* painter)
{
  const Point p = this->Mapping.ToPixel(this->Mapping.FromData(this->Probe));
  if (!this->ProbeShown || !this->Mapping.InPlot(p))
  {
    return;
  }
  const auto& plot = this->Mapping.Plot;
  const auto x = static_cast<float>(p[0]);
  const auto y = static_cast<float>(p[1]);
  const auto radius = static_cast<float>(6 * this->Mapping.Scale);
  vtkPen* pen = painter->GetPen();
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetColorF(0.85, 0.1, 0.1);
  pen->SetOpacityF(0.9);
  pen->SetWidth(static_cast<float>(1.3 * this->Mapping.Scale));
  painter->DrawLine(static_cast<float>(plot[0]), y, x - radius, y);
  painter->DrawLine(x + radius, y, static_cast<float>(plot[0] + plot[2]), y);
  painter->DrawLine(x, static_cast<float>(plot[1]), x, y - radius);
  painter->DrawLine(x, y + radius, x, static_cast<float>(plot[1] + plot[3]));
  painter->GetBrush()->SetOpacityF(0);
  painter->DrawEllipse(x, y, radius, radius);
}

void vtkTFCDomainChart::PaintMessage(vtkContext2D* painter)
{
  if (this->Message.empty())
  {
    return;
  }
  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontFamilyToArial();
  text->SetFontSize(12);
  text->SetBold(false);
  text->SetOrientation(0);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToCentered();
  const double ink = this->Mapping.Dark ? 0.75 : 0.35;
  text->SetColor(ink, ink, ink);
  const auto& plot = this->Mapping.Plot;
  const auto x = static_cast<float>(plot[0] + plot[2] / 2);
  const auto y = static_cast<float>(plot[1] + plot[3] / 2);
  // On a ground of its own: there may be a histogram below.
  std::array<float, 4> box;
  painter->ComputeStringBounds(this->Message.c_str(), box.data());
  const auto width = static_cast<float>(box[2] + 12 * this->Mapping.Scale);
  const auto height = static_cast<float>(box[3] + 8 * this->Mapping.Scale);
  const double ground = this->Mapping.Dark ? 0.13 : 1.0;
  painter->GetPen()->SetOpacityF(0);
  painter->GetBrush()->SetColorF(ground, ground, ground, 0.8);
  painter->DrawRect(x - width / 2, y - height / 2, width, height);
  painter->GetPen()->SetOpacityF(1);
  painter->DrawString(x, y, this->Message.c_str());
}

bool vtkTFCDomainChart::Paint(vtkContext2D* painter)
{
  this->Layout(painter);
  this->UpdateItems();
  const auto& plot = this->Mapping.Plot;
  const double ground = this->Mapping.Dark ? 0.13 : 1.0;
  painter->GetPen()->SetOpacityF(0);
  painter->GetBrush()->SetColorF(ground, ground, ground, 1.0);
  painter->DrawRect(static_cast<float>(plot[0]), static_cast<float>(plot[1]),
    static_cast<float>(plot[2]), static_cast<float>(plot[3]));
  painter->GetPen()->SetOpacityF(1);
  this->PaintChildren(painter);
  this->PaintTitles(painter);
  this->PaintGesture(painter);
  this->PaintOpacity(painter);
  this->PaintProbe(painter);
  this->PaintMessage(painter);
  return true;
}
