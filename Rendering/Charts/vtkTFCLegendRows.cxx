// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCLegendRows.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cstdio>

namespace
{

// Heights in font sizes.
constexpr double NAME_HEIGHT = 1.4;
constexpr double LABEL_HEIGHT = 1.45;
constexpr double LARGEST_PLOT = 3.5;
constexpr double SMALLEST_PLOT = 0.8;
constexpr double GAP = 0.5;

constexpr int COLOR_STEPS = 64; // of a function with colours of its own

std::string Format(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

// Piecewise linear through nodes (value, ...) with their ends extended; of two nodes at one value
// the later holds from there on.
template <size_t N>
std::array<double, N> Interpolate(const std::vector<std::array<double, N>>& nodes, double value)
{
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), value,
    [](double v, const std::array<double, N>& node) { return v < node[0]; });
  if (above == nodes.begin() || above == nodes.end())
  {
    return above == nodes.end() ? nodes.back() : nodes.front();
  }
  const auto& a = *(above - 1);
  const auto& b = *above;
  const double t = (value - a[0]) / (b[0] - a[0]);
  std::array<double, N> result;
  for (size_t i = 0; i < N; ++i)
  {
    result[i] = a[i] + t * (b[i] - a[i]);
  }
  return result;
}

template <size_t N>
std::vector<std::array<double, N>> ReadNodes(vtkDoubleArray* array)
{
  std::vector<std::array<double, N>> nodes(array->GetNumberOfTuples());
  for (size_t i = 0; i < nodes.size(); ++i)
  {
    array->GetTypedTuple(static_cast<vtkIdType>(i), nodes[i].data());
  }
  return nodes;
}

void SetText(vtkContext2D* painter, const vtkTFCLegendRows::Style& style)
{
  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontFamilyToArial();
  text->SetFontSize(style.FontSize);
  text->SetBold(false);
  text->SetOrientation(0);
  text->SetOpacity(1);
  text->SetColor(style.Color[0], style.Color[1], style.Color[2]);
}

void Write(vtkContext2D* painter, double x, double top, int justification, const std::string& text)
{
  painter->GetTextProp()->SetJustification(justification);
  painter->GetTextProp()->SetVerticalJustificationToTop();
  painter->DrawString(static_cast<float>(x), static_cast<float>(top), text.c_str());
}

// The text, or its beginning with dots when it is wider than `width` pixels.
std::string Shorten(vtkContext2D* painter, const std::string& text, double width)
{
  std::string shown = text;
  float box[4];
  for (painter->ComputeStringBounds(shown.c_str(), box); box[2] > width && !shown.empty();
       painter->ComputeStringBounds((shown + "...").c_str(), box))
  {
    // A character of UTF-8 and no part of it.
    do
    {
      shown.pop_back();
    } while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xc0) == 0x80);
    if (!shown.empty() && static_cast<unsigned char>(shown.back()) >= 0xc0)
    {
      shown.pop_back();
    }
  }
  return shown.size() == text.size() ? text : shown + "...";
}

}

//------------------------------------------------------------------------------
vtkTFCLegendRows::Row vtkTFCLegendRows::MakeRow(vtkTFCRegion* region)
{
  Row row;
  row.Name = region->GetName();
  region->GetColor(row.Color.data());
  if (region->HasTertiary())
  {
    row.Attribute = region->GetTertiaryArray();
    if (region->GetTertiaryComponent() > 0)
    {
      row.Attribute += " [" + std::to_string(region->GetTertiaryComponent()) + "]";
    }
    vtkNew<vtkDoubleArray> nodes;
    region->GetTertiaryOpacityNodes(nodes);
    row.Opacity = ReadNodes<2>(nodes);
    region->GetTertiaryColorNodes(nodes);
    row.Colors = ReadNodes<4>(nodes);
    if (!region->GetTertiaryRange(row.Range.data()))
    {
      row.Range = { { row.Opacity.front()[0], row.Opacity.back()[0] } };
    }
    if (!(row.Range[0] < row.Range[1]))
    {
      row.Range = { { row.Range[0] - 0.5, row.Range[0] + 0.5 } };
    }
  }
  return row;
}

//------------------------------------------------------------------------------
void vtkTFCLegendRows::Update(vtkTFCTransferFunction* model)
{
  this->Rows.clear();
  for (int i = 0; i < model->GetNumberOfRegions(); ++i)
  {
    vtkTFCRegion* region = model->GetRegion(i);
    if (region->GetVisible() && region->GetOpacity() > 0)
    {
      this->Rows.push_back(MakeRow(region));
    }
  }
}

//------------------------------------------------------------------------------
void vtkTFCLegendRows::PaintName(vtkContext2D* painter, const Row& row, double x, double top,
  double width, const Style& style) const
{
  const double size = style.FontSize * style.Scale;
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColorF(style.Color[0], style.Color[1], style.Color[2]);
  painter->GetPen()->SetWidth(static_cast<float>(style.Scale));
  painter->GetBrush()->SetColorF(row.Color[0], row.Color[1], row.Color[2], 1.0);
  painter->DrawRect(static_cast<float>(x), static_cast<float>(top - size),
    static_cast<float>(0.9 * size), static_cast<float>(0.9 * size));
  Write(painter, x + 1.4 * size, top, VTK_TEXT_LEFT,
    Shorten(painter, row.Name, width - 1.4 * size));
}

//------------------------------------------------------------------------------
void vtkTFCLegendRows::PaintFunction(vtkContext2D* painter, const Row& row,
  const std::array<double, 4>& box, const Style& style) const
{
  const auto toX = [&](double value)
  {
    const double t = (value - row.Range[0]) / (row.Range[1] - row.Range[0]);
    return static_cast<float>(box[0] + std::clamp(t, 0.0, 1.0) * box[2]);
  };
  const auto toY = [&](double opacity) { return static_cast<float>(box[1] + opacity * box[3]); };
  // Corners of the function within the range; steps have two at one place.
  std::vector<Node> corners;
  corners.push_back({ { row.Range[0], Interpolate(row.Opacity, row.Range[0])[1] } });
  for (const Node& node : row.Opacity)
  {
    if (node[0] > row.Range[0] && node[0] < row.Range[1])
    {
      corners.push_back(node);
    }
  }
  corners.push_back({ { row.Range[1], Interpolate(row.Opacity, row.Range[1])[1] } });

  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  const auto fill = [&](const Node& a, const Node& b, const std::array<double, 3>& color)
  {
    painter->GetBrush()->SetColorF(color[0], color[1], color[2], 0.8);
    painter->DrawQuad(toX(a[0]), toY(0), toX(a[0]), toY(a[1]), toX(b[0]), toY(b[1]), toX(b[0]),
      toY(0));
  };
  for (size_t i = 0; i + 1 < corners.size(); ++i)
  {
    const Node& a = corners[i];
    const Node& b = corners[i + 1];
    if (row.Colors.empty())
    {
      fill(a, b, row.Color);
      continue;
    }
    const double share = (b[0] - a[0]) / (row.Range[1] - row.Range[0]);
    const int steps = std::max(1, static_cast<int>(share * COLOR_STEPS));
    for (int k = 0; k < steps; ++k)
    {
      const double t[2] = { static_cast<double>(k) / steps, (k + 1.0) / steps };
      const Node from = { { a[0] + t[0] * (b[0] - a[0]), a[1] + t[0] * (b[1] - a[1]) } };
      const Node to = { { a[0] + t[1] * (b[0] - a[0]), a[1] + t[1] * (b[1] - a[1]) } };
      const ColorNode color = Interpolate(row.Colors, (from[0] + to[0]) / 2);
      fill(from, to, { { color[1], color[2], color[3] } });
    }
  }

  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColorF(style.Color[0], style.Color[1], style.Color[2]);
  painter->GetPen()->SetWidth(static_cast<float>(style.Scale));
  for (size_t i = 0; i + 1 < corners.size(); ++i)
  {
    painter->DrawLine(toX(corners[i][0]), toY(corners[i][1]), toX(corners[i + 1][0]),
      toY(corners[i + 1][1]));
  }
  painter->DrawLine(toX(row.Range[0]), toY(0), toX(row.Range[1]), toY(0));

  const double top = box[1] - 0.35 * style.FontSize * style.Scale;
  const std::string ends[2] = { Format(row.Range[0]), Format(row.Range[1]) };
  double used = style.FontSize * style.Scale;
  for (int i = 0; i < 2; ++i)
  {
    float bounds[4];
    painter->ComputeStringBounds(ends[i].c_str(), bounds);
    used += bounds[2];
    Write(painter, box[0] + i * box[2], top, i ? VTK_TEXT_RIGHT : VTK_TEXT_LEFT, ends[i]);
  }
  Write(painter, box[0] + box[2] / 2, top, VTK_TEXT_CENTERED,
    Shorten(painter, row.Attribute, box[2] - used));
}

//------------------------------------------------------------------------------
void vtkTFCLegendRows::Paint(vtkContext2D* painter, const std::array<double, 4>& rectangle,
  const Style& style)
{
  const double size = style.FontSize * style.Scale;
  const double bottom = rectangle[1];
  double top = rectangle[1] + rectangle[3];

  // What is left beside texts goes to the functions; with too little of it, rows are left out.
  size_t shown = this->Rows.size();
  double plot = 0;
  for (;; --shown)
  {
    const auto functions = static_cast<double>(
      std::count_if(this->Rows.begin(), this->Rows.begin() + static_cast<std::ptrdiff_t>(shown),
        [](const Row& row) { return !row.Attribute.empty(); }));
    double rest = rectangle[3] - static_cast<double>(shown) * (NAME_HEIGHT + GAP) * size -
      functions * LABEL_HEIGHT * size;
    rest -= shown < this->Rows.size() ? NAME_HEIGHT * size : 0;
    plot = functions > 0 ? std::min(LARGEST_PLOT * size, rest / functions) : 0;
    if (shown == 0 || (functions > 0 ? plot >= SMALLEST_PLOT * size : rest >= -GAP * size))
    {
      break;
    }
  }
  this->Missing = static_cast<int>(this->Rows.size() - shown);

  SetText(painter, style);
  for (size_t i = 0; i < shown; ++i)
  {
    const Row& row = this->Rows[i];
    this->PaintName(painter, row, rectangle[0], top, rectangle[2], style);
    top -= NAME_HEIGHT * size;
    if (!row.Attribute.empty())
    {
      this->PaintFunction(painter, row, { { rectangle[0], top - plot, rectangle[2], plot } },
        style);
      top -= plot + LABEL_HEIGHT * size;
    }
    top -= GAP * size;
  }
  if (this->Missing > 0 && top - size >= bottom - size)
  {
    Write(painter, rectangle[0], top, VTK_TEXT_LEFT,
      "and " + std::to_string(this->Missing) + " more");
  }
}
