// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCThumbnail.h"

#include "vtkTFCClassifier.h"
#include "vtkTFCOutline.h"
#include "vtkTFCQuantiles.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTFCTransferFunction.h"

#include <QPainter>
#include <QPalette>
#include <QPolygonF>

#include <algorithm>

namespace
{
constexpr double FAINTEST = 0.25; // filling of a region with opacity 0
constexpr double MARGIN = 0.05;   // around the regions, where the domain is theirs

//-----------------------------------------------------------------------------
vtkTFCOutline::Ranges FindDomain(const vtkTFCTransferFunction* model)
{
  vtkTFCOutline::Ranges domain = { { 0, 1, 0, 1 } };
  const auto quantiles = vtkTFCQuantiles::Load(model);
  for (int axis = 0; axis < 2; ++axis)
  {
    double* range = domain.data() + 2 * axis;
    const std::vector<double> values =
      vtkTFCQuantiles::Find(quantiles, model->GetAxisArray(axis), model->GetAxisComponent(axis));
    if (model->GetAxisRange(axis, range))
    {
      continue;
    }
    if (values.size() >= 2 && values.front() < values.back())
    {
      range[0] = values.front();
      range[1] = values.back();
      continue;
    }
    range[0] = 0;
    range[1] = 1;
    for (int i = 0; i < model->GetNumberOfRegions(); ++i)
    {
      const auto bounds =
        vtkTFCOutline::FromShape(model->GetRegion(i)->GetShape(), { { 0, 1, 0, 1 } }).GetBounds();
      const double margin = MARGIN * (bounds[2 * axis + 1] - bounds[2 * axis]);
      range[0] = std::min(i == 0 ? bounds[2 * axis] : range[0], bounds[2 * axis] - margin);
      range[1] = std::max(i == 0 ? bounds[2 * axis + 1] : range[1], bounds[2 * axis + 1] + margin);
    }
  }
  return domain;
}

//-----------------------------------------------------------------------------
// Over what is there, in the order of the list.
void Fill(QImage& image, const vtkTFCCompiledRegion& region)
{
  const double strength = FAINTEST + (1 - FAINTEST) * region.Opacity;
  for (int y = 0; y < image.height(); ++y)
  {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < image.width(); ++x)
    {
      const double alpha = strength *
        vtkTFCClassifier::RegionWeight(region, (x + 0.5) / image.width(),
          1 - (y + 0.5) / image.height());
      const QColor below(line[x]);
      line[x] = QColor::fromRgbF(below.redF() + alpha * (region.Color[0] - below.redF()),
        below.greenF() + alpha * (region.Color[1] - below.greenF()),
        below.blueF() + alpha * (region.Color[2] - below.blueF()))
                  .rgb();
    }
  }
}
}

//-----------------------------------------------------------------------------
QImage pqTFCThumbnail(const vtkTFCTransferFunction* model, const QSize& size,
  const QPalette& palette)
{
  QImage image(size, QImage::Format_RGB32);
  image.fill(palette.color(QPalette::Base));
  const vtkTFCOutline::Ranges domain = FindDomain(model);
  const vtkTFCCompiledModel compiled = model->Compile(domain.data());
  for (const vtkTFCCompiledRegion& region : compiled.Regions)
  {
    Fill(image, region);
  }
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  for (int i = 0; i < model->GetNumberOfRegions(); ++i)
  {
    vtkTFCRegion* region = model->GetRegion(i);
    QPolygonF polygon;
    for (const auto& p : vtkTFCOutline::FromShape(region->GetShape(), domain).GetPolyline())
    {
      polygon << QPointF(p[0] * size.width(), (1 - p[1]) * size.height());
    }
    double color[3];
    region->GetColor(color);
    painter.setPen(QColor::fromRgbF(color[0], color[1], color[2]));
    if (region->GetVisible())
    {
      painter.drawPolygon(polygon);
    }
  }
  painter.setPen(palette.color(QPalette::Mid));
  painter.drawRect(0, 0, size.width() - 1, size.height() - 1);
  return image;
}
