// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCHistogramItem.h"

#include "vtkContext2D.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkRect.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkTFCHistogramItem);

namespace
{
using Color = std::array<double, 3>;

// Viridis and Inferno: nine equidistant samples of the maps of S. van der Walt and N. Smith (2015,
// CC0, https://bids.github.io/colormap/); linear in between they stay within 0.01 of the originals
// over most of the range.
const std::array<Color, 9> VIRIDIS = { { { 0.267, 0.005, 0.329 }, { 0.283, 0.131, 0.449 },
  { 0.262, 0.242, 0.521 }, { 0.220, 0.343, 0.549 }, { 0.177, 0.438, 0.558 },
  { 0.143, 0.523, 0.556 }, { 0.120, 0.607, 0.540 }, { 0.369, 0.789, 0.383 },
  { 0.993, 0.906, 0.144 } } };
const std::array<Color, 9> INFERNO = { { { 0.001, 0.000, 0.014 }, { 0.118, 0.047, 0.283 },
  { 0.316, 0.071, 0.485 }, { 0.513, 0.149, 0.508 }, { 0.730, 0.213, 0.333 },
  { 0.895, 0.345, 0.198 }, { 0.976, 0.536, 0.044 }, { 0.969, 0.776, 0.248 },
  { 0.988, 0.998, 0.645 } } };

Color Interpolate(const std::array<Color, 9>& map, double s)
{
  const double position = s * (map.size() - 1);
  const size_t i = std::min(static_cast<size_t>(position), map.size() - 2);
  const double t = position - i;
  Color color;
  for (int c = 0; c < 3; ++c)
  {
    color[c] = (1 - t) * map[i][c] + t * map[i + 1][c];
  }
  return color;
}

Color ColorOf(int map, bool dark, double s)
{
  switch (map)
  {
    case vtkTFCHistogramItem::Viridis:
      return Interpolate(VIRIDIS, s);
    case vtkTFCHistogramItem::Inferno:
      return Interpolate(INFERNO, s);
    default:
    {
      // From a little off the ground, so that a single voxel can be seen, to a strong contrast.
      const double gray = dark ? 0.27 + 0.65 * s : 0.88 - 0.72 * s;
      return { { gray, gray, gray } };
    }
  }
}
}

vtkTFCHistogramItem::vtkTFCHistogramItem() = default;

vtkTFCHistogramItem::~vtkTFCHistogramItem() = default;

void vtkTFCHistogramItem::SetCounts(const double* counts, int nx, int ny,
  const vtkTFCOutline::Ranges& ranges)
{
  const size_t size = nx > 0 && ny > 0 ? static_cast<size_t>(nx) * ny : 0;
  this->Counts.assign(counts, counts + size);
  this->Size[0] = size ? nx : 0;
  this->Size[1] = size ? ny : 0;
  this->Ranges = ranges;
  this->Largest = size ? *std::max_element(this->Counts.begin(), this->Counts.end()) : 0;
  this->PercentileCount = 0;
  this->Picture = nullptr;
  this->SetPercentile(this->Percent);
  this->Modified();
}

double vtkTFCHistogramItem::GetCount(double x, double y) const
{
  const auto& r = this->Ranges;
  if (this->Counts.empty() || !(x >= r[0] && x <= r[1] && y >= r[2] && y <= r[3]))
  {
    return -1;
  }
  const auto bin = [](double v, double low, double high, int bins)
  { return std::min(bins - 1, static_cast<int>((v - low) / (high - low) * bins)); };
  const int i = bin(x, r[0], r[1], this->Size[0]);
  const int j = bin(y, r[2], r[3], this->Size[1]);
  return this->Counts[static_cast<size_t>(j) * this->Size[0] + i];
}

void vtkTFCHistogramItem::SetScale(int scale)
{
  scale = std::clamp(scale, static_cast<int>(Linear), static_cast<int>(Percentile));
  if (scale != this->Scale)
  {
    this->Scale = scale;
    this->Picture = nullptr;
    this->Modified();
  }
}

void vtkTFCHistogramItem::SetPercentile(double percent)
{
  this->Percent = std::clamp(percent, 0.0, 100.0);
  std::vector<double> filled;
  std::copy_if(this->Counts.begin(), this->Counts.end(), std::back_inserter(filled),
    [](double count) { return count > 0; });
  if (!filled.empty())
  {
    const auto index = static_cast<size_t>(this->Percent / 100 * (filled.size() - 1));
    std::nth_element(filled.begin(), filled.begin() + index, filled.end());
    this->PercentileCount = filled[index];
  }
  this->Picture = nullptr;
  this->Modified();
}

void vtkTFCHistogramItem::SetColorMap(int map)
{
  map = std::clamp(map, static_cast<int>(Gray), static_cast<int>(Inferno));
  if (map != this->Map)
  {
    this->Map = map;
    this->Picture = nullptr;
    this->Modified();
  }
}

double vtkTFCHistogramItem::GetBrightness(double count) const
{
  if (!(count > 0) || !(this->Largest > 0))
  {
    return 0;
  }
  switch (this->Scale)
  {
    case Linear:
      return count / this->Largest;
    case Percentile:
      return std::min(1.0, count / this->PercentileCount);
    default:
      return std::log1p(count) / std::log1p(this->Largest);
  }
}

void vtkTFCHistogramItem::UpdatePicture()
{
  this->PictureIsDark = this->Mapping->Dark;
  this->Picture = vtkSmartPointer<vtkImageData>::New();
  this->Picture->SetDimensions(this->Size[0], this->Size[1], 1);
  this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(this->Picture->GetScalarPointer());
  for (double count : this->Counts)
  {
    const Color color = ColorOf(this->Map, this->PictureIsDark, this->GetBrightness(count));
    for (int c = 0; c < 3; ++c)
    {
      *pixel++ = static_cast<unsigned char>(std::lround(255 * color[c]));
    }
    *pixel++ = count > 0 ? 255 : 0;
  }
}

bool vtkTFCHistogramItem::Paint(vtkContext2D* painter)
{
  if (this->Counts.empty() || !this->Mapping)
  {
    return false;
  }
  if (!this->Picture || this->PictureIsDark != this->Mapping->Dark)
  {
    this->UpdatePicture();
  }
  const auto low =
    this->Mapping->ToPixel(this->Mapping->FromData({ this->Ranges[0], this->Ranges[2] }));
  const auto high =
    this->Mapping->ToPixel(this->Mapping->FromData({ this->Ranges[1], this->Ranges[3] }));
  painter->DrawImage(vtkRectf(static_cast<float>(low[0]), static_cast<float>(low[1]),
                       static_cast<float>(high[0] - low[0]), static_cast<float>(high[1] - low[1])),
    this->Picture);
  return true;
}

void vtkTFCHistogramItem::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bins: " << this->Size[0] << " x " << this->Size[1] << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Percentile: " << this->Percent << "\n";
  os << indent << "ColorMap: " << this->Map << "\n";
}
