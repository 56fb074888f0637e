// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCStateLink.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyLocator.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"

namespace
{
const char* const TYPE = "Combined Volume";
const char* const PROPERTY = "TransferFunction";

bool IsCombinedVolume(pqDataRepresentation* representation)
{
  vtkSMProxy* proxy = representation ? representation->getProxy() : nullptr;
  // The property exists whatever the type is, because it is exposed.
  return proxy && proxy->GetProperty(PROPERTY) && proxy->GetProperty("Representation") &&
    QString(vtkSMPropertyHelper(proxy, "Representation").GetAsString()) == TYPE;
}
}

//-----------------------------------------------------------------------------
pqTFCStateLink::pqTFCStateLink(QObject* parentObject)
  : Superclass(parentObject)
{
  this->RenderTimer.setSingleShot(true);
  this->RenderTimer.setInterval(0);
  QObject::connect(&this->RenderTimer, &QTimer::timeout, this, &pqTFCStateLink::renderNow);

  pqActiveObjects& active = pqActiveObjects::instance();
  QObject::connect(&active,
    QOverload<pqDataRepresentation*>::of(&pqActiveObjects::representationChanged), this,
    &pqTFCStateLink::updateTarget);
  QObject::connect(&active, &pqActiveObjects::viewChanged, this, &pqTFCStateLink::updateTarget);
  QObject::connect(&active, &pqActiveObjects::portChanged, this, &pqTFCStateLink::updateTarget);
  QObject::connect(&active, &pqActiveObjects::dataUpdated, this, &pqTFCStateLink::updateTarget);
  // After a state file was loaded nothing is active.
  QObject::connect(pqApplicationCore::instance(),
    QOverload<vtkPVXMLElement*, vtkSMProxyLocator*>::of(&pqApplicationCore::stateLoaded), this,
    &pqTFCStateLink::updateTarget, Qt::QueuedConnection);
  this->updateTarget();
}

//-----------------------------------------------------------------------------
pqTFCStateLink::~pqTFCStateLink() = default;

//-----------------------------------------------------------------------------
vtkSMProxy* pqTFCStateLink::proxy() const
{
  return this->Representation ? this->Representation->getProxy() : nullptr;
}

//-----------------------------------------------------------------------------
pqDataRepresentation* pqTFCStateLink::representation() const
{
  return this->Representation;
}

//-----------------------------------------------------------------------------
pqOutputPort* pqTFCStateLink::input() const
{
  return this->Representation ? this->Representation->getOutputPortFromInput() : nullptr;
}

//-----------------------------------------------------------------------------
vtkPVDataInformation* pqTFCStateLink::dataInformation() const
{
  return this->Representation ? this->Representation->getInputDataInformation() : nullptr;
}

//-----------------------------------------------------------------------------
pqDataRepresentation* pqTFCStateLink::findTarget() const
{
  pqActiveObjects& active = pqActiveObjects::instance();
  if (active.activeRepresentation())
  {
    return active.activeRepresentation();
  }
  pqView* view = active.activeView();
  if (view && !active.activePort())
  {
    for (pqRepresentation* candidate : view->getRepresentations())
    {
      auto* representation = qobject_cast<pqDataRepresentation*>(candidate);
      if (representation && representation->isVisible() && IsCombinedVolume(representation))
      {
        return representation;
      }
    }
  }
  return nullptr;
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::updateTarget()
{
  pqDataRepresentation* target = this->findTarget();
  const bool other = target != this->Representation;
  if (other)
  {
    this->Events->Disconnect();
    this->Editing = false;
    if (this->Source)
    {
      QObject::disconnect(this->Source, nullptr, this, nullptr);
    }
    this->Representation = target;
    // Not that of pqActiveObjects: after a state file was loaded, no source is active.
    this->Source = target ? target->getInput() : nullptr;
    if (this->Source)
    {
      QObject::connect(this->Source.data(),
        QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), this,
        &pqTFCStateLink::dataChanged);
    }
    if (target && target->getProxy()->GetProperty(PROPERTY))
    {
      this->Events->Connect(target->getProxy()->GetProperty(PROPERTY), vtkCommand::ModifiedEvent,
        this, SLOT(onPropertyModified()));
    }
    if (target && target->getProxy()->GetProperty("Representation"))
    {
      this->Events->Connect(target->getProxy()->GetProperty("Representation"),
        vtkCommand::ModifiedEvent, this, SLOT(updateTarget()));
    }
  }
  const Situation now = this->situation();
  if (other || now != this->LastSituation)
  {
    this->LastSituation = now;
    Q_EMIT this->targetChanged();
  }
}

//-----------------------------------------------------------------------------
pqTFCStateLink::Situation pqTFCStateLink::situation() const
{
  if (IsCombinedVolume(this->Representation))
  {
    return Ready;
  }
  if (!this->Representation)
  {
    pqActiveObjects& active = pqActiveObjects::instance();
    if (!active.activePort())
    {
      return NoData;
    }
    return qobject_cast<pqRenderView*>(active.activeView()) ? NotShown : NotHere;
  }
  vtkSMProperty* type = this->proxy()->GetProperty("Representation");
  auto* types = type ? type->FindDomain<vtkSMStringListDomain>() : nullptr;
  unsigned int index = 0;
  if (types && types->IsInDomain(TYPE, index))
  {
    return OtherType;
  }
  vtkPVDataInformation* data = this->dataInformation();
  const bool image = data && data->DataSetTypeIsA("vtkImageData");
  return image && types ? NoPlugin : NotAnImage;
}

//-----------------------------------------------------------------------------
QString pqTFCStateLink::state() const
{
  return this->situation() == Ready
    ? QString::fromUtf8(vtkSMPropertyHelper(this->proxy(), PROPERTY).GetAsString())
    : QString();
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::write(const QString& state)
{
  this->Writing = true;
  vtkSMPropertyHelper(this->proxy(), PROPERTY).Set(state.toUtf8().constData());
  this->proxy()->UpdateVTKObjects();
  this->Writing = false;
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::begin()
{
  if (!this->Editing)
  {
    this->Editing = true;
    this->Before = this->state();
  }
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::live(const QString& state)
{
  if (this->situation() == Ready && state != this->state())
  {
    this->begin();
    SCOPED_UNDO_EXCLUDE();
    this->write(state);
    this->render(true);
  }
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::commit(const QString& state, const QString& label)
{
  if (this->situation() != Ready)
  {
    return;
  }
  this->begin();
  this->Editing = false;
  if (this->state() != this->Before)
  {
    // What an undo step takes as the state before is the one that was pushed last
    // (vtkSMSession.cxx of ParaView 5.11, line 133).
    SCOPED_UNDO_EXCLUDE();
    this->write(this->Before);
  }
  if (state != this->Before)
  {
    SCOPED_UNDO_SET(label);
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->proxy());
    this->write(state);
  }
  this->render(false);
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::show()
{
  pqActiveObjects& active = pqActiveObjects::instance();
  pqOutputPort* port = active.activePort();
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->Show(vtkSMSourceProxy::SafeDownCast(port->getSource()->getProxy()),
    port->getPortNumber(), active.activeView()->getViewProxy());
  active.activeView()->resetDisplay();
  this->updateTarget();
}

//-----------------------------------------------------------------------------
bool pqTFCStateLink::makeCombinedVolume()
{
  // With what show() does, one step of undo.
  SCOPED_UNDO_SET(tr("Show as Combined Volume"));
  if (this->situation() == NotShown)
  {
    this->show();
  }
  if (this->situation() != OtherType)
  {
    return this->situation() == Ready;
  }
  vtkSMProxy* target = this->proxy();
  {
    SM_SCOPED_TRACE(CallMethod).arg(target).arg("SetRepresentationType").arg(TYPE);
    vtkSMRepresentationProxy::SetRepresentationType(target, TYPE);
    vtkSMPropertyHelper(target, "Visibility").Set(1);
    target->UpdateVTKObjects();
  }
  this->updateTarget();
  this->render(false);
  return this->situation() == Ready;
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::onPropertyModified()
{
  if (!this->Writing && this->situation() == Ready)
  {
    this->Editing = false;
    Q_EMIT this->stateChanged();
  }
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::render(bool interactive)
{
  this->RenderInteractive = interactive;
  // Once per round of the event loop: a mouse sends more events than a view can draw.
  this->RenderTimer.start();
}

//-----------------------------------------------------------------------------
void pqTFCStateLink::renderNow()
{
  pqView* view = this->Representation ? this->Representation->getView() : nullptr;
  if (view && this->RenderInteractive)
  {
    view->getViewProxy()->InteractiveRender();
  }
  else if (view)
  {
    view->render();
  }
}
