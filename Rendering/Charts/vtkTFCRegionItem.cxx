// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRegionItem.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkRect.h"
#include "vtkTFCClassifier.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTFCRegionItem);

namespace
{
using Point = vtkTFCOutline::Point;

// Samples of the weight along one side: finer than anybody sees in a soft edge.
constexpr int LARGEST_PICTURE = 160;
// Points of 1/72 inch.
constexpr double ROOM_FOR_SIDES = 14;
constexpr double SLIDER_LENGTH = 64;
constexpr double SLIDER_DISTANCE = 18; // from the region
constexpr double SLIDER_MARGIN = 12;   // to the border of the plot

double FalloffPosition(const vtkTFCRegion* region)
{
  const double width = region->GetFalloffWidth();
  return region->GetFalloffType() == vtkTFCRegion::Gaussian ? width : 1 - width;
}
}

vtkTFCRegionItem::vtkTFCRegionItem() = default;

vtkTFCRegionItem::~vtkTFCRegionItem() = default;

void vtkTFCRegionItem::SetRegion(vtkTFCRegion* region)
{
  this->Region = region;
  this->PictureValid = false;
}

vtkTFCRegion* vtkTFCRegionItem::GetRegion() const
{
  return this->Region;
}

void vtkTFCRegionItem::SetLook(bool selected, bool active, bool hovered)
{
  this->Selected = selected;
  this->Active = active;
  this->Hovered = hovered;
}

void vtkTFCRegionItem::SetCompiled(const vtkTFCCompiledModel* model,
  const vtkTFCCompiledRegion* region)
{
  this->Drawn = region != nullptr;
  this->PictureValid = false;
  if (region)
  {
    // The weight alone: opacity 1 and no tertiary function.
    this->Compiled = std::make_unique<vtkTFCCompiledModel>();
    this->Compiled->Attributes.resize(2);
    this->Compiled->Range = model->Range;
    this->Compiled->Regions = { *region };
    this->Compiled->Regions[0].Opacity = 1;
    this->Compiled->Regions[0].Tertiary = -1;
  }
}

vtkTFCOutline vtkTFCRegionItem::GetOutline() const
{
  return vtkTFCOutline::FromShape(this->Region->GetShape(), this->Mapping->Ranges);
}

std::vector<vtkTFCOutline::Handle> vtkTFCRegionItem::GetHandles() const
{
  const Point pixel = this->Mapping->PixelSize();
  const double margin = 16 * this->Mapping->Scale;
  const vtkTFCOutline outline = this->GetOutline();
  auto handles = outline.GetHandles({ margin * pixel[0], margin * pixel[1] });
  if (outline.IsBox() &&
    std::min(outline.HalfSize[0] / pixel[0], outline.HalfSize[1] / pixel[1]) <
      ROOM_FOR_SIDES * this->Mapping->Scale)
  {
    // On a small region the handles would cover each other: the corners do all that sides do.
    handles.erase(std::remove_if(handles.begin(), handles.end(),
                    [](const vtkTFCOutline::Handle& handle)
                    { return handle.Kind == vtkTFCOutline::Handles::Side; }),
      handles.end());
  }
  return handles;
}

bool vtkTFCRegionItem::GetWidthHandle(Point& position) const
{
  if (this->Region->GetFalloffType() == vtkTFCRegion::Constant)
  {
    return false;
  }
  Point inner;
  Point outer;
  this->GetOutline().GetFalloffLine(inner, outer);
  const double d = FalloffPosition(this->Region);
  position = { inner[0] + d * (outer[0] - inner[0]), inner[1] + d * (outer[1] - inner[1]) };
  return true;
}

double vtkTFCRegionItem::WidthAt(const Point& position) const
{
  Point inner;
  Point outer;
  this->GetOutline().GetFalloffLine(inner, outer);
  const Point a = this->Mapping->ToPixel(inner);
  const Point b = this->Mapping->ToPixel(outer);
  const Point p = this->Mapping->ToPixel(position);
  const Point line = { b[0] - a[0], b[1] - a[1] };
  const double length = line[0] * line[0] + line[1] * line[1];
  const double d = length > 0 ? ((p[0] - a[0]) * line[0] + (p[1] - a[1]) * line[1]) / length : 0.5;
  const double width = this->Region->GetFalloffType() == vtkTFCRegion::Gaussian ? d : 1 - d;
  return std::clamp(width, 0.01, 1.0);
}

void vtkTFCRegionItem::GetOpacitySlider(Point& zero, Point& one) const
{
  // At the right, where no other handle is; at the left where there is no room.
  const vtkTFCDomainMapping& map = *this->Mapping;
  const auto bounds = this->GetOutline().GetBounds();
  Point low = map.ToPixel({ bounds[0], bounds[2] });
  Point high = map.ToPixel({ bounds[1], bounds[3] });
  for (const vtkTFCOutline::Handle& handle : this->GetHandles())
  {
    const double x = map.ToPixel(handle.Position)[0];
    low[0] = std::min(low[0], x);
    high[0] = std::max(high[0], x);
  }
  const double margin = SLIDER_MARGIN * map.Scale;
  const double first = map.Plot[0] + margin;
  const double last = std::max(first, map.Plot[0] + map.Plot[2] - margin);
  double x = high[0] + SLIDER_DISTANCE * map.Scale;
  if (x > last && low[0] - SLIDER_DISTANCE * map.Scale >= first)
  {
    x = low[0] - SLIDER_DISTANCE * map.Scale;
  }
  x = std::clamp(x, first, last);
  const double length =
    std::min(SLIDER_LENGTH * map.Scale, std::max(8.0, map.Plot[3] - 2 * margin));
  const double bottom = map.Plot[1] + margin;
  const double y = std::clamp((low[1] + high[1] - length) / 2, bottom,
    std::max(bottom, map.Plot[1] + map.Plot[3] - margin - length));
  zero = { x, y };
  one = { x, y + length };
}

Point vtkTFCRegionItem::GetOpacityHandle() const
{
  Point zero;
  Point one;
  this->GetOpacitySlider(zero, one);
  return { zero[0], zero[1] + this->Region->GetOpacity() * (one[1] - zero[1]) };
}

void vtkTFCRegionItem::UpdatePicture()
{
  const vtkTFCDomainMapping& map = *this->Mapping;
  std::array<double, 8> key;
  std::copy(map.View.begin(), map.View.end(), key.begin());
  std::copy(map.Plot.begin(), map.Plot.end(), key.begin() + 4);
  if (this->PictureValid && key == this->PictureKey)
  {
    return;
  }
  this->PictureValid = true;
  this->PictureKey = key;
  this->Picture = nullptr;

  const auto& bounds = this->Compiled->Regions[0].Bounds;
  auto& cut = this->PictureBounds;
  cut = { { std::max(bounds[0], map.View[0]), std::min(bounds[1], map.View[1]),
    std::max(bounds[2], map.View[2]), std::min(bounds[3], map.View[3]) } };
  if (!(cut[0] < cut[1] && cut[2] < cut[3]))
  {
    return;
  }
  const Point pixel = map.PixelSize();
  const int nx = std::clamp(static_cast<int>((cut[1] - cut[0]) / pixel[0]), 2, LARGEST_PICTURE);
  const int ny = std::clamp(static_cast<int>((cut[3] - cut[2]) / pixel[1]), 2, LARGEST_PICTURE);
  std::vector<double> x(static_cast<size_t>(nx) * ny);
  std::vector<double> y(x.size());
  for (int j = 0; j < ny; ++j)
  {
    for (int i = 0; i < nx; ++i)
    {
      const Point data = map.ToData({ cut[0] + (cut[1] - cut[0]) * (i + 0.5) / nx,
        cut[2] + (cut[3] - cut[2]) * (j + 0.5) / ny });
      x[static_cast<size_t>(j) * nx + i] = data[0];
      y[static_cast<size_t>(j) * nx + i] = data[1];
    }
  }
  const double* attributes[2] = { x.data(), y.data() };
  std::vector<float> weights(x.size());
  vtkTFCClassifier(*this->Compiled)
    .Classify(x.size(), attributes, nullptr, nullptr, weights.data());

  this->Picture = vtkSmartPointer<vtkImageData>::New();
  this->Picture->SetDimensions(nx, ny, 1);
  this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* out = static_cast<unsigned char*>(this->Picture->GetScalarPointer());
  double color[3];
  this->Region->GetColor(color);
  // Faint regions stay visible in the chart, opaque ones let the histogram through.
  const double strength = 0.25 + 0.45 * this->Region->GetOpacity();
  for (float weight : weights)
  {
    for (double c : color)
    {
      *out++ = static_cast<unsigned char>(std::lround(255 * c));
    }
    *out++ = static_cast<unsigned char>(std::lround(255 * strength * weight));
  }
}

void vtkTFCRegionItem::PaintOutline(vtkContext2D* painter)
{
  const vtkTFCDomainMapping& map = *this->Mapping;
  std::vector<float> line;
  for (const Point& p : this->GetOutline().GetPolyline())
  {
    const Point pixel = map.ToPixel(p);
    line.push_back(static_cast<float>(pixel[0]));
    line.push_back(static_cast<float>(pixel[1]));
  }
  line.push_back(line[0]);
  line.push_back(line[1]);
  const int n = static_cast<int>(line.size() / 2);

  // A halo in the colour of the ground, so that any colour can be seen on any histogram.
  const double ground = map.Dark ? 0.1 : 1.0;
  const double width = (this->Selected ? 2.2 : 1.2) * map.Scale;
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColorF(ground, ground, ground);
  painter->GetPen()->SetOpacityF(0.7);
  painter->GetPen()->SetWidth(static_cast<float>(width + 2 * map.Scale));
  painter->DrawPoly(line.data(), n);

  double color[3];
  this->Region->GetColor(color);
  // A colour near the ground's is moved away from it.
  const double light = 0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2];
  const double mix = map.Dark ? std::max(0.0, 0.35 - light) : std::max(0.0, light - 0.6);
  for (double& c : color)
  {
    c = (1 - mix) * c + mix * (map.Dark ? 1.0 : 0.0);
  }
  painter->GetPen()->SetColorF(color[0], color[1], color[2]);
  painter->GetPen()->SetOpacityF(this->Drawn ? 1.0 : 0.7);
  painter->GetPen()->SetLineType(this->Drawn ? vtkPen::SOLID_LINE : vtkPen::DASH_LINE);
  painter->GetPen()->SetWidth(static_cast<float>(width));
  painter->DrawPoly(line.data(), n);
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetOpacityF(1.0);
}

void vtkTFCRegionItem::PaintHandles(vtkContext2D* painter)
{
  const vtkTFCDomainMapping& map = *this->Mapping;
  const auto size = static_cast<float>(7 * map.Scale);
  const double ink = map.Dark ? 0.95 : 0.15;
  const double ground = map.Dark ? 0.15 : 1.0;
  std::vector<float> boxes;
  std::vector<float> rounds;
  for (const vtkTFCOutline::Handle& handle : this->GetHandles())
  {
    const Point p = map.ToPixel(handle.Position);
    std::vector<float>& list = handle.Kind == vtkTFCOutline::Handles::Turn ? rounds : boxes;
    list.push_back(static_cast<float>(p[0]));
    list.push_back(static_cast<float>(p[1]));
  }
  painter->GetPen()->SetColorF(ink, ink, ink);
  painter->GetPen()->SetWidth(static_cast<float>(1.2 * map.Scale));
  painter->GetBrush()->SetColorF(ground, ground, ground, 1.0);
  for (size_t i = 0; i + 1 < boxes.size(); i += 2)
  {
    painter->DrawRect(boxes[i] - size / 2, boxes[i + 1] - size / 2, size, size);
  }
  for (size_t i = 0; i + 1 < rounds.size(); i += 2)
  {
    painter->DrawEllipse(rounds[i], rounds[i + 1], size * 0.65F, size * 0.65F);
  }
  Point width;
  if (this->GetWidthHandle(width))
  {
    const Point p = map.ToPixel(width);
    const auto x = static_cast<float>(p[0]);
    const auto y = static_cast<float>(p[1]);
    double color[3];
    this->Region->GetColor(color);
    painter->GetBrush()->SetColorF(color[0], color[1], color[2], 1.0);
    // A diamond: what it changes is neither size nor place.
    float diamond[8] = { x - 0.8F * size, y, x, y - 0.8F * size, x + 0.8F * size, y, x,
      y + 0.8F * size };
    painter->DrawPolygon(diamond, 4);
    float outline[10];
    std::copy(diamond, diamond + 8, outline);
    outline[8] = diamond[0];
    outline[9] = diamond[1];
    painter->DrawPoly(outline, 5);
  }
}

void vtkTFCRegionItem::PaintSlider(vtkContext2D* painter)
{
  const vtkTFCDomainMapping& map = *this->Mapping;
  Point zero;
  Point one;
  this->GetOpacitySlider(zero, one);
  const Point handle = this->GetOpacityHandle();
  const auto scale = static_cast<float>(map.Scale);
  const auto x = static_cast<float>(zero[0]);
  const auto bottom = static_cast<float>(zero[1]);
  const auto top = static_cast<float>(one[1]);
  const auto y = static_cast<float>(handle[1]);
  const double ink = map.Dark ? 0.95 : 0.15;
  const double ground = map.Dark ? 0.15 : 1.0;
  double color[3];
  this->Region->GetColor(color);
  vtkPen* pen = painter->GetPen();
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetOpacityF(1);
  pen->SetColorF(ink, ink, ink);
  pen->SetWidth(1.2F * scale);
  painter->GetBrush()->SetColorF(ground, ground, ground, 1.0);
  painter->DrawRect(x - 2.5F * scale, bottom, 5 * scale, top - bottom);
  // Filled up to the opacity.
  pen->SetOpacityF(0);
  painter->GetBrush()->SetColorF(color[0], color[1], color[2], 1.0);
  painter->DrawRect(x - 2 * scale, bottom, 4 * scale, y - bottom);
  pen->SetOpacityF(1);
  painter->GetBrush()->SetColorF(ground, ground, ground, 1.0);
  painter->DrawRect(x - 7 * scale, y - 2.5F * scale, 14 * scale, 5 * scale);
}

void vtkTFCRegionItem::PaintName(vtkContext2D* painter)
{
  const vtkTFCDomainMapping& map = *this->Mapping;
  const auto bounds = this->GetOutline().GetBounds();
  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontFamilyToArial();
  text->SetFontSize(11);
  text->SetBold(this->Selected);
  text->SetItalic(false);
  text->SetOrientation(0);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToCentered();
  const double ink = map.Dark ? 0.95 : 0.1;
  text->SetColor(ink, ink, ink);
  text->SetOpacity(1);
  float box[4];
  painter->ComputeStringBounds(this->Region->GetName().c_str(), box);
  const double w = box[2] + 8 * map.Scale;
  const double h = box[3] + 4 * map.Scale;
  const Point top = map.ToPixel({ (bounds[0] + bounds[1]) / 2, bounds[3] });
  const Point bottom = map.ToPixel({ (bounds[0] + bounds[1]) / 2, bounds[2] });
  const auto& plot = map.Plot;
  // Below the region, because a handle is above it; where there is no room, above that. Kept inside
  // the plot.
  const double x =
    std::clamp(top[0], plot[0] + w / 2, std::max(plot[0] + w / 2, plot[0] + plot[2] - w / 2));
  const double below = bottom[1] - h / 2 - 8 * map.Scale;
  const double above = top[1] + h / 2 + 28 * map.Scale;
  const double y = std::clamp(below < plot[1] + h / 2 ? above : below, plot[1] + h / 2,
    std::max(plot[1] + h / 2, plot[1] + plot[3] - h / 2));
  const double ground = map.Dark ? 0.12 : 1.0;
  painter->GetPen()->SetOpacityF(0);
  painter->GetBrush()->SetColorF(ground, ground, ground, 0.75);
  painter->DrawRect(static_cast<float>(x - w / 2), static_cast<float>(y - h / 2),
    static_cast<float>(w), static_cast<float>(h));
  painter->GetPen()->SetOpacityF(1);
  painter->DrawString(static_cast<float>(x), static_cast<float>(y),
    this->Region->GetName().c_str());
}

bool vtkTFCRegionItem::Paint(vtkContext2D* painter)
{
  if (!this->Region || !this->Mapping)
  {
    return false;
  }
  if (this->Drawn)
  {
    this->UpdatePicture();
    if (this->Picture)
    {
      const Point low = this->Mapping->ToPixel({ this->PictureBounds[0], this->PictureBounds[2] });
      const Point high = this->Mapping->ToPixel({ this->PictureBounds[1], this->PictureBounds[3] });
      painter->DrawImage(vtkRectf(static_cast<float>(low[0]), static_cast<float>(low[1]),
                           static_cast<float>(high[0] - low[0]),
                           static_cast<float>(high[1] - low[1])),
        this->Picture);
    }
  }
  this->PaintOutline(painter);
  if (this->Active && !this->Region->GetLocked())
  {
    this->PaintSlider(painter);
    this->PaintHandles(painter);
  }
  if (this->Hovered || this->Selected)
  {
    this->PaintName(painter);
  }
  return true;
}

void vtkTFCRegionItem::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Region: " << (this->Region ? this->Region->GetId() : 0) << "\n";
  os << indent << "Selected: " << this->Selected << "\n";
  os << indent << "Hovered: " << this->Hovered << "\n";
}
