// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCValueMark.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChart.h"
#include "vtkContext2D.h"
#include "vtkContextScene.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

vtkStandardNewMacro(vtkTFCValueMark);

vtkTFCValueMark::vtkTFCValueMark() = default;

vtkTFCValueMark::~vtkTFCValueMark() = default;

void vtkTFCValueMark::SetChart(vtkChart* chart)
{
  if (chart != this->Chart)
  {
    this->Chart = chart;
    this->Modified();
  }
}

bool vtkTFCValueMark::SetValue(double value)
{
  if (value == this->Value || (std::isnan(value) && std::isnan(this->Value)))
  {
    return false;
  }
  this->Value = value;
  this->Modified();
  if (this->Scene)
  {
    this->Scene->SetDirty(true);
  }
  return true;
}

bool vtkTFCValueMark::Paint(vtkContext2D* painter)
{
  this->Position = std::numeric_limits<double>::quiet_NaN();
  vtkAxis* axis = this->Chart ? this->Chart->GetAxis(vtkAxis::BOTTOM) : nullptr;
  const double low = axis ? axis->GetUnscaledMinimum() : 0;
  const double high = axis ? axis->GetUnscaledMaximum() : 0;
  // False for NaN as well.
  if (!(low < high && this->Value >= low && this->Value <= high))
  {
    return false;
  }
  vtkRenderer* renderer = this->Scene ? this->Scene->GetRenderer() : nullptr;
  const double scale = renderer && renderer->GetRenderWindow()
    ? std::max(1.0, renderer->GetRenderWindow()->GetDPI() / 72.0)
    : 1.0;
  const int* first = this->Chart->GetPoint1();
  const int* last = this->Chart->GetPoint2();
  this->Position = first[0] + (this->Value - low) / (high - low) * (last[0] - first[0]);
  const auto x = static_cast<float>(this->Position);
  const auto bottom = static_cast<float>(first[1]);
  const auto top = static_cast<float>(last[1]);

  // A halo, because what is below has the region's colour, which may be red.
  vtkPen* pen = painter->GetPen();
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetColorF(1, 1, 1);
  pen->SetOpacityF(0.8);
  pen->SetWidth(static_cast<float>(3.5 * scale));
  painter->DrawLine(x, bottom, x, top);
  pen->SetColorF(0.85, 0.1, 0.1);
  pen->SetOpacityF(1);
  pen->SetWidth(static_cast<float>(1.5 * scale));
  painter->DrawLine(x, bottom, x, top);

  std::array<char, 32> label;
  std::snprintf(label.data(), label.size(), "%.4g", this->Value);
  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontFamilyToArial();
  text->SetFontSize(10);
  text->SetBold(false);
  text->SetItalic(false);
  text->SetOrientation(0);
  text->SetColor(0.65, 0.05, 0.05);
  text->SetOpacity(1);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToCentered();
  std::array<float, 4> box;
  painter->ComputeStringBounds(label.data(), box.data());
  const auto width = static_cast<float>(box[2] + 6 * scale);
  const auto height = static_cast<float>(box[3] + 4 * scale);
  const auto gap = static_cast<float>(3 * scale);
  // At the side where there is more room.
  const bool right = x < 0.5F * static_cast<float>(first[0] + last[0]);
  const float left = right ? x + gap : x - gap - width;
  pen->SetOpacityF(0);
  painter->GetBrush()->SetColorF(1, 1, 1, 0.8);
  painter->DrawRect(left, top - height - gap, width, height);
  pen->SetOpacityF(1);
  painter->DrawString(left + width / 2, top - gap - height / 2, label.data());
  return true;
}

void vtkTFCValueMark::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Value: " << this->Value << "\n";
  os << indent << "Position: " << this->Position << "\n";
}
