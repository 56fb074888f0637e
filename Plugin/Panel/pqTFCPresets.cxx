// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCPresets.h"

#include "pqCoreUtilities.h"
#include "pqFileDialog.h"
#include "pqTFCDocument.h"
#include "pqTFCMapDialog.h"
#include "pqTFCPresetDialog.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkTFCQuantiles.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>

namespace
{
const char* const FILTERS = "Combined transfer functions (*.tfc.json *.json)";
}

//-----------------------------------------------------------------------------
pqTFCPresets::pqTFCPresets(pqTFCDocument* document, QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  this->setObjectName("FileMenu");
  const QString filters = tr(FILTERS);
  QAction* openAction = this->addAction(tr("Open ..."));
  openAction->setObjectName("Open");
  QObject::connect(openAction, &QAction::triggered, this,
    [this, filters]()
    {
      pqFileDialog dialog(nullptr, pqCoreUtilities::mainWidget(), tr("Open Transfer Function"),
        QString(), filters);
      dialog.setObjectName("OpenTransferFunction");
      dialog.setFileMode(pqFileDialog::ExistingFile);
      if (dialog.exec() == QDialog::Accepted)
      {
        this->open(dialog.getSelectedFiles()[0]);
      }
    });
  QAction* saveAction = this->addAction(tr("Save As ..."));
  saveAction->setObjectName("SaveAs");
  QObject::connect(saveAction, &QAction::triggered, this,
    [this, filters]()
    {
      pqFileDialog dialog(nullptr, pqCoreUtilities::mainWidget(), tr("Save Transfer Function"),
        QString(), filters);
      dialog.setObjectName("SaveTransferFunction");
      dialog.setFileMode(pqFileDialog::AnyFile);
      if (dialog.exec() == QDialog::Accepted)
      {
        this->save(dialog.getSelectedFiles()[0]);
      }
    });
  this->addSeparator();
  QAction* presets = this->addAction(tr("Presets ..."));
  presets->setObjectName("Presets");
  QObject::connect(presets, &QAction::triggered, this, &pqTFCPresets::showPresets);
  this->addSeparator();
  QAction* copy = this->addAction(tr("Copy Regions"));
  copy->setObjectName("Copy");
  QObject::connect(copy, &QAction::triggered, this, &pqTFCPresets::copyRegions);
  QAction* paste = this->addAction(tr("Paste Regions"));
  paste->setObjectName("Paste");
  QObject::connect(paste, &QAction::triggered, this, &pqTFCPresets::pasteRegions);
}

//-----------------------------------------------------------------------------
pqTFCPresets::~pqTFCPresets() = default;

//-----------------------------------------------------------------------------
bool pqTFCPresets::open(const QString& path)
{
  if (!this->Document->isReady())
  {
    this->Document->say(tr("Show the data as Combined Volume first."));
    return false;
  }
  // In a model of its own first: what it names may not be in these data.
  vtkNew<vtkTFCTransferFunction> model;
  const QString problem = pqTFCPresetFolder::read(path, model);
  if (!problem.isEmpty())
  {
    this->Document->say(tr("%1 cannot be read. %2 Nothing was changed: correct the file, or choose "
                           "another one.")
                          .arg(QFileInfo(path).fileName(), problem));
    return false;
  }
  pqTFCMapDialog dialog(this->Document, model, pqCoreUtilities::mainWidget());
  if (dialog.isNeeded())
  {
    if (dialog.exec() != QDialog::Accepted)
    {
      return false;
    }
    dialog.apply();
  }
  // They are those of other data.
  vtkTFCQuantiles::Store(model, {});
  return this->Document->replace(tr("Open transfer function"),
    QString::fromStdString(model->GetState()));
}

//-----------------------------------------------------------------------------
QString pqTFCPresets::stateForFiles() const
{
  vtkNew<vtkTFCTransferFunction> model;
  model->SetState(this->Document->state().toUtf8().constData());
  std::vector<vtkTFCQuantiles::Entry> entries;
  const auto add = [&](const std::string& array, int component)
  {
    const pqTFCAttribute* attribute = this->Document->findAttribute(array, component);
    if (attribute && vtkTFCQuantiles::Find(entries, array, component).empty())
    {
      const auto values = this->Document->quantiles(*attribute, vtkTFCQuantiles::Number);
      if (!values.empty())
      {
        entries.push_back({ array, component, values });
      }
    }
  };
  for (int axis = 0; axis < 2; ++axis)
  {
    add(model->GetAxisArray(axis), model->GetAxisComponent(axis));
  }
  for (int i = 0; i < model->GetNumberOfRegions(); ++i)
  {
    add(model->GetRegion(i)->GetTertiaryArray(), model->GetRegion(i)->GetTertiaryComponent());
  }
  vtkTFCQuantiles::Store(model, entries);
  return QString::fromStdString(model->GetState());
}

//-----------------------------------------------------------------------------
bool pqTFCPresets::save(const QString& path)
{
  if (this->Document->state().isEmpty())
  {
    this->Document->say(tr("There is no transfer function to save."));
    return false;
  }
  const QString problem = pqTFCPresetFolder::write(path, this->stateForFiles());
  if (!problem.isEmpty())
  {
    this->Document->say(tr("%1 cannot be written: %2.").arg(QFileInfo(path).fileName(), problem));
  }
  return problem.isEmpty();
}

//-----------------------------------------------------------------------------
void pqTFCPresets::showPresets()
{
  if (this->Dialog)
  {
    this->Dialog->refresh();
  }
  else
  {
    this->Dialog = new pqTFCPresetDialog(&this->Folder, pqCoreUtilities::mainWidget());
    this->Dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(this->Dialog, &pqTFCPresetDialog::applied, this, &pqTFCPresets::open);
    QObject::connect(this->Dialog, &pqTFCPresetDialog::saved, this,
      [this](const QString& name)
      {
        const QString problem = this->Document->state().isEmpty()
          ? tr("There is no transfer function to save.")
          : this->Folder.save(name, this->stateForFiles());
        this->Dialog->refresh(name.trimmed());
        this->Dialog->say(problem);
      });
  }
  this->Dialog->show();
  this->Dialog->raise();
}

//-----------------------------------------------------------------------------
void pqTFCPresets::copyRegions()
{
  vtkTFCTransferFunction* model = this->Document->model();
  vtkNew<vtkTFCTransferFunction> copies;
  for (int axis = 0; axis < 2; ++axis)
  {
    copies->SetAxis(axis, model->GetAxisArray(axis).c_str(), model->GetAxisComponent(axis));
  }
  for (int id : this->Document->selection())
  {
    vtkNew<vtkTFCRegion> copy;
    copy->DeepCopy(model->GetRegionById(id));
    copies->AddRegion(copy);
  }
  if (copies->GetNumberOfRegions() == 0)
  {
    this->Document->say(tr("Select the regions to copy first."));
    return;
  }
  QApplication::clipboard()->setText(QString::fromStdString(copies->GetState()));
}

//-----------------------------------------------------------------------------
void pqTFCPresets::pasteRegions()
{
  vtkNew<vtkTFCTransferFunction> copies;
  // Its errors are said below.
  vtkNew<vtkCallbackCommand> nothing;
  nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  copies->AddObserver(vtkCommand::ErrorEvent, nothing);
  const QString text = QApplication::clipboard()->text();
  if (text.trimmed().isEmpty() || !copies->SetState(text.toUtf8().constData()))
  {
    this->Document->say(
      tr("The clipboard holds no regions. %1").arg(QString::fromStdString(copies->GetLastError())));
    return;
  }
  std::vector<int> ids;
  this->Document->edit(tr("Paste regions"),
    [&]()
    {
      for (int i = 0; i < copies->GetNumberOfRegions(); ++i)
      {
        vtkNew<vtkTFCRegion> region;
        region->DeepCopy(copies->GetRegion(i));
        ids.push_back(this->Document->model()->AddRegion(region));
      }
    });
  this->Document->setSelection(ids);
}
