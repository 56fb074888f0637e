// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCFunctionChart.h"

#include "QVTKOpenGLNativeWidget.h"
#include "vtkChart.h"
#include "vtkCollectionRange.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkPropCollection.h"
#include "vtkRange.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

//-----------------------------------------------------------------------------
vtkRenderer* pqTFCFunctionRenderer(QWidget* widget)
{
  auto* canvas = widget->findChild<QVTKOpenGLNativeWidget*>();
  return canvas ? canvas->renderWindow()->GetRenderers()->GetFirstRenderer() : nullptr;
}

//-----------------------------------------------------------------------------
vtkContextScene* pqTFCFunctionScene(QWidget* widget)
{
  if (vtkRenderer* renderer = pqTFCFunctionRenderer(widget))
  {
    for (vtkObject* prop : vtk::Range(renderer->GetViewProps()))
    {
      if (auto* actor = vtkContextActor::SafeDownCast(prop))
      {
        return actor->GetScene();
      }
    }
  }
  return nullptr;
}

//-----------------------------------------------------------------------------
vtkChart* pqTFCFunctionChart(QWidget* widget)
{
  vtkContextScene* scene = pqTFCFunctionScene(widget);
  for (unsigned int i = 0; scene && i < scene->GetNumberOfItems(); ++i)
  {
    if (auto* chart = vtkChart::SafeDownCast(scene->GetItem(i)))
    {
      return chart;
    }
  }
  return nullptr;
}
