// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCComputeMenu.h"

#include "pqTFCAttributeFilter.h"
#include "pqTFCDocument.h"
#include "vtkTFCTransferFunction.h"

namespace
{

struct Entry
{
  const char* Name;
  const char* Filter;
  const char* Suffix; ///< of the array that it adds
};

const Entry ENTRIES[] = {
  { QT_TRANSLATE_NOOP("pqTFCComputeMenu", "Gradient Magnitude"), "VolumeGradientMagnitude",
    "_gradient" },
  { QT_TRANSLATE_NOOP("pqTFCComputeMenu", "Local Mean and Deviation"), "VolumeLocalStatistics",
    "_stddev" },
  { QT_TRANSLATE_NOOP("pqTFCComputeMenu", "Occlusion"), "VolumeOcclusion", "_occlusion" },
  { QT_TRANSLATE_NOOP("pqTFCComputeMenu", "Feature Size"), "VolumeFeatureSize", "_size" },
};

}

//-----------------------------------------------------------------------------
pqTFCComputeMenu::pqTFCComputeMenu(pqTFCDocument* document, QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  this->setObjectName("ComputeMenu");
  for (const Entry& entry : ENTRIES)
  {
    QAction* action = this->addAction(tr(entry.Name));
    action->setObjectName(entry.Filter);
    QObject::connect(action, &QAction::triggered, this,
      [this, &entry]()
      { pqTFCAttributeFilter::compute(this->Document, entry.Filter, tr(entry.Name)); });
  }
  QObject::connect(this, &QMenu::aboutToShow, this, &pqTFCComputeMenu::refresh);
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCComputeMenu::refresh);
}

//-----------------------------------------------------------------------------
void pqTFCComputeMenu::refresh()
{
  const std::string& primary = this->Document->model()->GetAxisArray(0);
  int i = 0;
  for (QAction* action : this->actions())
  {
    const std::string array = primary + ENTRIES[i++].Suffix;
    action->setEnabled(
      this->Document->isReady() && !primary.empty() && !this->Document->findAttribute(array, 0));
    action->setToolTip(QString::fromStdString(array));
  }
}
