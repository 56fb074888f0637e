// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCProbeMark.h"

#include "pqTFCDocument.h"
#include "pqTFCFunctionChart.h"
#include "pqTFCProbe.h"
#include "pqTransferFunctionWidget.h"
#include "vtkContextScene.h"
#include "vtkTFCRegion.h"
#include "vtkTFCValueMark.h"

#include <limits>

//-----------------------------------------------------------------------------
pqTFCProbeMark::pqTFCProbeMark(pqTFCDocument* document, pqTFCProbe* probe,
  pqTransferFunctionWidget* widget)
  : Superclass(widget)
  , Document(document)
  , Probe(probe)
  , Widget(widget)
{
  if (vtkContextScene* scene = pqTFCFunctionScene(widget))
  {
    this->Mark->SetChart(pqTFCFunctionChart(widget));
    // The mouse goes through to the points of the function.
    this->Mark->SetInteractive(false);
    scene->AddItem(this->Mark);
  }
  QObject::connect(probe, &pqTFCProbe::told, this, &pqTFCProbeMark::refresh);
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCProbeMark::refresh);
  QObject::connect(document, &pqTFCDocument::selectionChanged, this, &pqTFCProbeMark::refresh);
}

//-----------------------------------------------------------------------------
pqTFCProbeMark::~pqTFCProbeMark() = default;

//-----------------------------------------------------------------------------
double pqTFCProbeMark::value() const
{
  return this->Mark->GetValue();
}

//-----------------------------------------------------------------------------
double pqTFCProbeMark::position() const
{
  vtkContextScene* scene = this->Mark->GetScene();
  return scene && this->Widget->isVisible() ? this->Mark->GetPosition() / scene->GetSceneWidth()
                                            : std::numeric_limits<double>::quiet_NaN();
}

//-----------------------------------------------------------------------------
void pqTFCProbeMark::refresh()
{
  vtkTFCRegion* region = this->Document->activeRegion();
  const double value = region && region->HasTertiary()
    ? this->Probe->value(region->GetTertiaryArray(), region->GetTertiaryComponent())
    : std::numeric_limits<double>::quiet_NaN();
  if (this->Mark->SetValue(value))
  {
    this->Widget->render();
  }
}
