// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCProposal.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqTFCAdvice.h"
#include "pqTFCDocument.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkDataObject.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkTFCProposal.h"
#include "vtkTFCRegion.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

namespace
{
const char* const TYPE = "Combined Volume";

// Add a filter behind the active port, show its output instead of the input, and make it active.
// The transfer function is set before anybody sees the new representation.
pqPipelineSource* AddFilter(const char* name, const std::string& array, const QString& state)
{
  pqActiveObjects& active = pqActiveObjects::instance();
  pqOutputPort* port = active.activePort();
  pqView* view = active.activeView();
  if (!port || !view)
  {
    return nullptr;
  }
  pqObjectBuilder* builder = pqApplicationCore::instance()->getObjectBuilder();
  pqPipelineSource* filter =
    builder->createFilter("filters", name, port->getSource(), port->getPortNumber());
  if (!filter)
  {
    return nullptr;
  }
  auto* proxy = vtkSMSourceProxy::SafeDownCast(filter->getProxy());
  if (!array.empty())
  {
    vtkSMPropertyHelper(proxy, "InputArray")
      .SetInputArrayToProcess(vtkDataObject::POINT, array.c_str());
  }
  proxy->UpdateVTKObjects();
  proxy->UpdatePipeline(vtkSMPropertyHelper(view->getProxy(), "ViewTime").GetAsDouble());
  filter->setModifiedState(pqProxy::UNMODIFIED);

  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  vtkSMProxy* shown = controller->Show(proxy, 0, view->getViewProxy());
  if (shown && vtkSMRepresentationProxy::SetRepresentationType(shown, TYPE))
  {
    vtkSMPropertyHelper(shown, "TransferFunction").Set(state.toUtf8().constData());
    shown->UpdateVTKObjects();
  }
  controller->Hide(vtkSMSourceProxy::SafeDownCast(port->getSource()->getProxy()),
    port->getPortNumber(), view->getViewProxy());
  active.setActiveSource(filter);
  view->render();
  return filter;
}
}

//-----------------------------------------------------------------------------
pqTFCProposal::pqTFCProposal(pqTFCDocument* document, pqTFCAdvice* advice, QObject* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Advice(advice)
{
  this->Timer.setSingleShot(true);
  this->Timer.setInterval(0);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqTFCProposal::propose);
  QObject::connect(document, &pqTFCDocument::targetChanged, this, &pqTFCProposal::later);
}

//-----------------------------------------------------------------------------
pqTFCProposal::~pqTFCProposal() = default;

//-----------------------------------------------------------------------------
void pqTFCProposal::later()
{
  pqUndoStack* stack = pqApplicationCore::instance()->getUndoStack();
  const bool replaying = stack && (stack->getInUndo() || stack->getInRedo());
  if (this->Document->isReady() && this->Document->state().isEmpty() && !replaying &&
    !pqApplicationCore::instance()->isLoadingState())
  {
    this->Timer.start();
  }
}

//-----------------------------------------------------------------------------
bool pqTFCProposal::proposeAxes()
{
  const auto& attributes = this->Document->attributes();
  vtkTFCTransferFunction* model = this->Document->model();
  if (attributes.empty())
  {
    return false;
  }
  const auto pairs = this->Advice->pairs();
  if (!pairs.empty() && this->Document->findAttribute(pairs[0].Primary, 0) &&
    this->Document->findAttribute(pairs[0].Secondary, 0))
  {
    model->SetAxis(0, pairs[0].Primary.c_str(), 0);
    model->SetAxis(1, pairs[0].Secondary.c_str(), 0);
    return true;
  }
  // No pair: data with a single attribute, or with vectors only.
  const auto usable = [](const pqTFCAttribute& a) { return a.Range[0] < a.Range[1]; };
  const pqTFCAttribute* primary = nullptr;
  pqDataRepresentation* representation = this->Document->link()->representation();
  vtkSMProxy* proxy = representation->getProxy();
  const char* colored = proxy->GetProperty("ColorArrayName")
    ? vtkSMPropertyHelper(proxy, "ColorArrayName").GetInputArrayNameToProcess()
    : nullptr;
  for (const pqTFCAttribute& attribute : attributes)
  {
    if (usable(attribute) &&
      (!primary || (colored && attribute.Array == colored && primary->Array != attribute.Array)))
    {
      primary = &attribute;
    }
  }
  if (!primary)
  {
    primary = &attributes[0];
  }
  const pqTFCAttribute* secondary = this->Document->findAttribute(primary->Array + "_gradient", 0);
  for (const pqTFCAttribute& attribute : attributes)
  {
    if (!secondary && usable(attribute) && attribute.Array != primary->Array &&
      attribute.goesWith(*primary))
    {
      secondary = &attribute;
    }
  }
  if (!secondary)
  {
    secondary = primary;
  }
  model->SetAxis(0, primary->Array.c_str(), primary->Component);
  model->SetAxis(1, secondary->Array.c_str(), secondary->Component);
  return true;
}

//-----------------------------------------------------------------------------
void pqTFCProposal::propose()
{
  if (!this->Document->isReady() || !this->Document->state().isEmpty() || !this->proposeAxes())
  {
    return;
  }
  this->Document->plane();
  this->Document->fetchNow();
  vtkTFCSparseHistogram* plane = this->Document->plane();
  vtkTFCTransferFunction* model = this->Document->model();
  if (plane && model->GetAxisArray(0) != model->GetAxisArray(1))
  {
    vtkNew<vtkTFCProposal> proposal;
    proposal->ProposeRegions(plane, model);
  }
  this->Document->commit(tr("Propose transfer function"));
  if (model->GetNumberOfRegions() > 0)
  {
    this->Document->setSelection({ model->GetRegion(0)->GetId() });
  }
}

//-----------------------------------------------------------------------------
void pqTFCProposal::resampleToImage()
{
  SCOPED_UNDO_SET(tr("Resample To Image"));
  AddFilter("ResampleToImage", "", QString());
}

//-----------------------------------------------------------------------------
void pqTFCProposal::cellsToPoints(pqTFCDocument* document)
{
  SCOPED_UNDO_SET(tr("Cell Data to Point Data"));
  AddFilter("CellDataToPointData", "", document->state());
}

//-----------------------------------------------------------------------------
void pqTFCProposal::computeGradient(pqTFCDocument* document)
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
  SCOPED_UNDO_SET(tr("Compute gradient magnitude"));
  AddFilter("VolumeGradientMagnitude", array,
    diagonal && model->GetNumberOfRegions() == 0 ? QString()
                                                 : QString::fromStdString(model->GetState()));
}

//-----------------------------------------------------------------------------
void pqTFCProposal::compute(pqTFCDocument* document, const char* filter, const QString& title)
{
  const QString state = document->state();
  const std::string array = document->model()->GetAxisArray(0);
  if (!array.empty())
  {
    SCOPED_UNDO_SET(tr("Compute %1").arg(title));
    AddFilter(filter, array, state);
  }
}
