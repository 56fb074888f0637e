// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCAttributeFilter.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqTFCCancelableUpdate.h"
#include "pqTFCDocument.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUndoStackBuilder.h"
#include "vtkSMViewProxy.h"
#include "vtkTFCTransferFunction.h"

#include <QCoreApplication>

namespace
{
const char* const TYPE = "Combined Volume";

QString Text(const char* text)
{
  return QCoreApplication::translate("pqTFCAttributeFilter", text);
}

//-----------------------------------------------------------------------------
struct Step
{
  const char* Filter;
  std::string Array; ///< empty for a filter that takes all
  QString Title;
};

// The transfer function is set before anybody sees the new representation.
void Show(vtkSMSourceProxy* filter, pqOutputPort* instead, pqView* view, const QString& state)
{
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  vtkSMProxy* shown = controller->Show(filter, 0, view->getViewProxy());
  if (shown && vtkSMRepresentationProxy::SetRepresentationType(shown, TYPE))
  {
    vtkSMPropertyHelper(shown, "TransferFunction").Set(state.toUtf8().constData());
    shown->UpdateVTKObjects();
  }
  controller->Hide(vtkSMSourceProxy::SafeDownCast(instead->getSource()->getProxy()),
    instead->getPortNumber(), view->getViewProxy());
}

// Add a filter behind the active port and make it active.
void AddFilter(const Step& step, const QString& state)
{
  pqActiveObjects& active = pqActiveObjects::instance();
  pqOutputPort* port = active.activePort();
  pqView* view = active.activeView();
  if (!port || !view)
  {
    return;
  }
  SCOPED_UNDO_SET(step.Title);
  pqObjectBuilder* builder = pqApplicationCore::instance()->getObjectBuilder();
  pqPipelineSource* filter =
    builder->createFilter("filters", step.Filter, port->getSource(), port->getPortNumber());
  if (!filter)
  {
    return;
  }
  // Meanwhile the editor goes on showing what it showed: the new filter has no display yet.
  active.setActivePort(port);
  auto* proxy = vtkSMSourceProxy::SafeDownCast(filter->getProxy());
  if (!step.Array.empty())
  {
    vtkSMPropertyHelper(proxy, "InputArray")
      .SetInputArrayToProcess(vtkDataObject::POINT, step.Array.c_str());
  }
  proxy->UpdateVTKObjects();
  const double time = vtkSMPropertyHelper(view->getProxy(), "ViewTime").GetAsDouble();
  if (!pqTFCCancelableUpdate::run(proxy, time, step.Title + "..."))
  {
    builder->destroy(filter);
    // What was made and deleted again is no step.
    if (pqUndoStack* stack = pqApplicationCore::instance()->getUndoStack())
    {
      stack->GetUndoStackBuilder()->Clear();
    }
    return;
  }
  filter->setModifiedState(pqProxy::UNMODIFIED);
  Show(proxy, port, view, state);
  active.setActiveSource(filter);
  view->render();
}
}

//-----------------------------------------------------------------------------
void pqTFCAttributeFilter::resampleToImage()
{
  AddFilter({ "ResampleToImage", "", Text("Resample To Image") }, QString());
}

//-----------------------------------------------------------------------------
void pqTFCAttributeFilter::cellsToPoints(pqTFCDocument* document)
{
  AddFilter({ "CellDataToPointData", "", Text("Cell Data to Point Data") }, document->state());
}

//-----------------------------------------------------------------------------
void pqTFCAttributeFilter::computeGradient(pqTFCDocument* document)
{
  // What was there goes on with the new data; only a diagonal has nothing to keep.
  vtkNew<vtkTFCTransferFunction> model;
  model->SetState(document->state().toUtf8().constData());
  const std::string array = model->GetAxisArray(0);
  if (array.empty())
  {
    return;
  }
  const bool diagonal = model->GetAxisArray(1) == array;
  model->SetAxis(1, (array + "_gradient").c_str(), 0);
  model->ClearAxisRange(1);
  AddFilter({ "VolumeGradientMagnitude", array, Text("Compute gradient magnitude") },
    diagonal && model->GetNumberOfRegions() == 0 ? QString()
                                                 : QString::fromStdString(model->GetState()));
}

//-----------------------------------------------------------------------------
void pqTFCAttributeFilter::compute(pqTFCDocument* document, const char* filter,
  const QString& title)
{
  const QString state = document->state();
  const std::string array = document->model()->GetAxisArray(0);
  if (!array.empty())
  {
    AddFilter({ filter, array, Text("Compute %1").arg(title) }, state);
  }
}
