// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCFunctionLook.h"

#include "QVTKOpenGLNativeWidget.h"
#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChart.h"
#include "vtkCollectionRange.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkControlPointsItem.h"
#include "vtkPen.h"
#include "vtkPropCollection.h"
#include "vtkRange.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkScalarsToColorsItem.h"
#include "vtkTextProperty.h"

#include <QPalette>
#include <QWidget>

namespace
{
// ParaView's widget has no function for either (ParaView 5.11).
vtkRenderer* FindRenderer(QWidget* widget)
{
  auto* canvas = widget->findChild<QVTKOpenGLNativeWidget*>();
  return canvas ? canvas->renderWindow()->GetRenderers()->GetFirstRenderer() : nullptr;
}

vtkChart* FindChart(vtkRenderer* renderer)
{
  for (vtkObject* prop : vtk::Range(renderer->GetViewProps()))
  {
    auto* actor = vtkContextActor::SafeDownCast(prop);
    vtkContextScene* scene = actor ? actor->GetScene() : nullptr;
    for (unsigned int i = 0; scene && i < scene->GetNumberOfItems(); ++i)
    {
      if (auto* chart = vtkChart::SafeDownCast(scene->GetItem(i)))
      {
        return chart;
      }
    }
  }
  return nullptr;
}

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
  vtkRenderer* renderer = FindRenderer(widget);
  vtkChart* chart = renderer ? FindChart(renderer) : nullptr;
  if (!chart)
  {
    return;
  }
  const QColor ground = palette.color(QPalette::Base);
  const QColor ink = palette.color(QPalette::Text);
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
  vtkRenderer* renderer = FindRenderer(widget);
  vtkChart* chart = renderer ? FindChart(renderer) : nullptr;
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
