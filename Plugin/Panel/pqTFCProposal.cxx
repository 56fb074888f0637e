// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCProposal.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqTFCAdvice.h"
#include "pqTFCDocument.h"
#include "pqUndoStack.h"
#include "vtkNew.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkTFCProposal.h"
#include "vtkTFCRegion.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

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
