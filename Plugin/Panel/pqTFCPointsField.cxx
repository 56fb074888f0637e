// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCPointsField.h"

#include "pqTFCDocument.h"
#include "pqTFCRegionText.h"
#include "vtkTFCRegion.h"

//-----------------------------------------------------------------------------
pqTFCPointsField::pqTFCPointsField(pqTFCDocument* document, Kinds kind, QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Kind(kind)
{
  if (kind == Opacities)
  {
    this->setObjectName("Points");
    this->setAccessibleName(tr("Points of the opacity: value and opacity"));
    this->setToolTip(tr("Value opacity; value opacity; ... with increasing values in data units "
                        "and opacities from 0 to 1"));
  }
  else
  {
    this->setObjectName("ColorPoints");
    this->setAccessibleName(tr("Points of the colour: value and colour"));
    this->setToolTip(tr("Value #rrggbb; value #rrggbb; ... with increasing values in data units, "
                        "or names of colours. Nothing: the colour of the region."));
  }
  QObject::connect(this, &pqTFCField::editingFinished, this, &pqTFCPointsField::onTyped);
  QObject::connect(document, &pqTFCDocument::changed, this, [this]() { this->refresh(); });
  QObject::connect(document, &pqTFCDocument::selectionChanged, this, [this]() { this->refresh(); });
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCPointsField::~pqTFCPointsField() = default;

//-----------------------------------------------------------------------------
void pqTFCPointsField::refresh(bool force)
{
  vtkTFCRegion* region = this->Document->activeRegion();
  QString text;
  if (region && region->HasTertiary())
  {
    text = this->Kind == Opacities ? pqTFCOpacityPointsText(region) : pqTFCColorPointsText(region);
  }
  this->setVisible(this->Kind == Opacities || !text.isEmpty());
  this->show(text, force);
}

//-----------------------------------------------------------------------------
void pqTFCPointsField::onTyped()
{
  vtkTFCRegion* region = this->Document->activeRegion();
  if (!this->typed() || !region)
  {
    return;
  }
  const QString text = this->text();
  // Before the edit, which shows it as it was read.
  this->accept();
  const bool done = this->Kind == Opacities ? pqTFCSetOpacityPoints(this->Document, region, text)
                                            : pqTFCSetColorPoints(this->Document, region, text);
  if (!done)
  {
    this->refresh(true);
  }
}
