// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCIcons.h"

#include "vtkTFCDomainChart.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

//-----------------------------------------------------------------------------
QIcon pqTFCToolIcon(int tool, const QPalette& palette)
{
  // 24 units, at four times the size for screens of high density.
  QPixmap pixmap(96, 96);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(4, 4);
  const QColor& ink = palette.color(QPalette::WindowText);
  painter.setPen(QPen(ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  QPainterPath path;
  switch (tool)
  {
    case vtkTFCDomainChart::Ellipse:
      path.addEllipse(QRectF(3, 6, 18, 12));
      break;
    case vtkTFCDomainChart::Rectangle:
      path.addRect(QRectF(4, 6, 16, 12));
      break;
    case vtkTFCDomainChart::Triangle:
      path.addPolygon(QPolygonF({ { 12, 4 }, { 21, 19 }, { 3, 19 }, { 12, 4 } }));
      break;
    case vtkTFCDomainChart::Polygon:
      path.addPolygon(
        QPolygonF({ { 5, 9 }, { 13, 4 }, { 20, 10 }, { 17, 19 }, { 7, 19 }, { 5, 9 } }));
      break;
    case vtkTFCDomainChart::Lasso:
      path.moveTo(9, 17);
      path.cubicTo(1, 16, 2, 6, 11, 5);
      path.cubicTo(21, 4, 24, 13, 17, 16);
      path.cubicTo(13, 18, 8, 16, 8, 18);
      path.cubicTo(8, 20, 11, 19, 10, 22);
      break;
    default:
      path.addPolygon(QPolygonF({ { 6, 3 }, { 6, 18 }, { 10, 14.5 }, { 12.5, 20.5 }, { 15, 19.5 },
        { 12.5, 13.5 }, { 18, 13.5 }, { 6, 3 } }));
      painter.setBrush(ink);
  }
  painter.drawPath(path);
  return QIcon(pixmap);
}
