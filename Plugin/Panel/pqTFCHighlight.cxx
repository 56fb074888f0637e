// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCHighlight.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqSettings.h"
#include "pqTFCDocument.h"
#include "pqTFCStateLink.h"
#include "pqView.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

namespace
{
const char* const PROPERTY = "HighlightedRegion";
const char* const SETTING = "TransferFunctionCombinations/HighlightRegions";

// ms. A pointer that crosses a region on its way elsewhere shall not make the view flicker; from
// region to region the view may follow at once.
constexpr int FIRST_REST = 200;
constexpr int NEXT_REST = 30;
// ms, until what was drawn quickly is drawn well.
constexpr int STILL = 300;
}

//-----------------------------------------------------------------------------
pqTFCHighlight::pqTFCHighlight(pqTFCDocument* document, QObject* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Enabled(pqApplicationCore::instance()->settings()->value(SETTING, true).toBool())
{
  this->Rest.setSingleShot(true);
  this->Still.setSingleShot(true);
  this->Still.setInterval(STILL);
  QObject::connect(&this->Rest, &QTimer::timeout, this, &pqTFCHighlight::showWanted);
  QObject::connect(&this->Still, &QTimer::timeout, this, &pqTFCHighlight::renderStill);
  // What an edit does must be seen as it is.
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCHighlight::clear);
  QObject::connect(document, &pqTFCDocument::targetChanged, this, &pqTFCHighlight::clear);
}

//-----------------------------------------------------------------------------
pqTFCHighlight::~pqTFCHighlight() = default;

//-----------------------------------------------------------------------------
int pqTFCHighlight::region()
{
  if (this->Rest.isActive())
  {
    this->showWanted();
  }
  return this->Shown;
}

//-----------------------------------------------------------------------------
void pqTFCHighlight::setEnabled(bool enabled)
{
  this->Enabled = enabled;
  pqApplicationCore::instance()->settings()->setValue(SETTING, enabled);
  this->clear();
}

//-----------------------------------------------------------------------------
void pqTFCHighlight::hover(int region)
{
  if (!this->Enabled || region == 0 || this->Document->link()->isEditing())
  {
    this->clear();
  }
  else if (region != this->Wanted)
  {
    this->Wanted = region;
    this->Rest.start(this->Shown ? NEXT_REST : FIRST_REST);
  }
}

//-----------------------------------------------------------------------------
void pqTFCHighlight::clear()
{
  this->Wanted = 0;
  this->showWanted();
}

//-----------------------------------------------------------------------------
void pqTFCHighlight::showWanted()
{
  this->Rest.stop();
  if (this->Document->link()->isEditing() || !this->Document->isReady())
  {
    this->Wanted = 0;
  }
  if (this->Wanted == this->Shown)
  {
    return;
  }
  if (this->Shown == 0)
  {
    this->Representation = this->Document->link()->representation();
  }
  this->Shown = this->Wanted;
  vtkSMProxy* proxy = this->Representation ? this->Representation->getProxy() : nullptr;
  // A server with an older plugin has no such property.
  if (proxy && proxy->GetProperty(PROPERTY))
  {
    vtkSMPropertyHelper(proxy, PROPERTY).Set(this->Shown);
    proxy->UpdateVTKObjects();
    if (this->Shown)
    {
      this->Document->link()->render(true);
      this->Still.start();
    }
    else
    {
      this->renderStill();
    }
  }
}

//-----------------------------------------------------------------------------
void pqTFCHighlight::renderStill()
{
  this->Still.stop();
  if (pqView* view = this->Representation ? this->Representation->getView() : nullptr)
  {
    view->render();
  }
}
