// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCFunctionLook.h"

#include "pqTFCFunctionChart.h"
#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChart.h"
#include "vtkControlPointsItem.h"
#include "vtkPen.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColorsItem.h"
#include "vtkTextProperty.h"

#include <QPalette>
#include <QWidget>

namespace
{
void SetColor(vtkPen* pen, const QColor& color)
{
  // Without opacity, which says more than a look: some lines are hidden by it.
  pen->SetColor(static_cast<unsigned char>(color.red()), static_cast<unsigned char>(color.green()),
    static_cast<unsigned char>(color.blue()));
}
}

//-----------------------------------------------------------------------------
void pqTFCFollowPalette(QWidget* widget, const QPalette& palette)
{
  vtkRenderer* renderer = pqTFCFunctionRenderer(widget);
  vtkChart* chart = pqTFCFunctionChart(widget);
  if (!chart)
  {
    return;
  }
  const QColor& ground = palette.color(QPalette::Base);
  const QColor& ink = palette.color(QPalette::Text);
  renderer->SetBackground(ground.redF(), ground.greenF(), ground.blueF());
  chart->GetBackgroundBrush()->SetColorF(ground.redF(), ground.greenF(), ground.blueF(),
    chart->GetBackgroundBrush()->GetOpacity() / 255.0);
  for (int i = 0; i < 4; ++i)
  {
    vtkAxis* axis = chart->GetAxis(i);
    SetColor(axis->GetPen(), ink);
    axis->GetLabelProperties()->SetColor(ink.redF(), ink.greenF(), ink.blueF());
  }
  for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
  {
    if (auto* curve = vtkScalarsToColorsItem::SafeDownCast(chart->GetPlot(i)))
    {
      SetColor(curve->GetPolyLinePen(), ink);
    }
    else if (auto* points = vtkControlPointsItem::SafeDownCast(chart->GetPlot(i)))
    {
      SetColor(points->GetPen(), ink);
    }
  }
}

//-----------------------------------------------------------------------------
QString pqTFCFunctionColors(QWidget* widget)
{
  vtkRenderer* renderer = pqTFCFunctionRenderer(widget);
  vtkChart* chart = pqTFCFunctionChart(widget);
  QString colors;
  for (vtkIdType i = 0; chart && i < chart->GetNumberOfPlots(); ++i)
  {
    if (auto* curve = vtkScalarsToColorsItem::SafeDownCast(chart->GetPlot(i)))
    {
      double ground[3];
      unsigned char ink[3];
      renderer->GetBackground(ground);
      curve->GetPolyLinePen()->GetColor(ink);
      colors = QColor::fromRgbF(ground[0], ground[1], ground[2]).name() + " " +
        QColor(ink[0], ink[1], ink[2]).name();
    }
  }
  return colors;
}
