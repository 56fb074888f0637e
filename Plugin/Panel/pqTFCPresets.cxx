// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCPresets.h"

#include "pqCoreUtilities.h"
#include "pqFileDialog.h"
#include "pqTFCDocument.h"
#include "pqTFCMapDialog.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QInputDialog>
#include <QSaveFile>

namespace
{
const char* const SUFFIX = ".tfc.json";
// More than vtkTFCTransferFunction reads: not worth loading.
constexpr qint64 LARGEST_FILE = 8 * 1024 * 1024;

// A model whose errors are the caller's to report.
void Silence(vtkTFCTransferFunction* model)
{
  vtkNew<vtkCallbackCommand> nothing;
  nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  model->AddObserver(vtkCommand::ErrorEvent, nothing);
}
}

//-----------------------------------------------------------------------------
pqTFCPresets::pqTFCPresets(pqTFCDocument* document, QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  this->setObjectName("FileMenu");
  const QString filters = tr("Combined transfer functions (*.tfc.json *.json)");
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
  this->Presets = this->addMenu(tr("Presets"));
  this->Presets->setObjectName("Presets");
  QObject::connect(this->Presets, &QMenu::aboutToShow, this, &pqTFCPresets::fillPresets);
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
QString pqTFCPresets::folder() const
{
  return pqCoreUtilities::getParaViewUserDirectory() + "/CombinedTransferFunctions";
}

//-----------------------------------------------------------------------------
bool pqTFCPresets::open(const QString& path)
{
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly) || file.size() > LARGEST_FILE)
  {
    this->Document->say(tr("%1 cannot be read: %2.")
                          .arg(QFileInfo(path).fileName(),
                            file.isOpen() ? tr("it is too large") : file.errorString()));
    return false;
  }
  // In a model of its own first: what it names may not be in these data.
  vtkNew<vtkTFCTransferFunction> model;
  Silence(model);
  if (!this->Document->isReady() || !model->SetState(file.readAll().constData()))
  {
    this->Document->say(
      tr("%1 is not a transfer function. %2")
        .arg(QFileInfo(path).fileName(), QString::fromStdString(model->GetLastError())));
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
  return this->Document->replace(tr("Open transfer function"),
    QString::fromStdString(model->GetState()));
}

//-----------------------------------------------------------------------------
bool pqTFCPresets::save(const QString& path)
{
  // Whole or not at all: a full disk must not cost the previous file.
  QSaveFile file(path);
  const QByteArray text = this->Document->state().toUtf8();
  if (text.isEmpty() || !file.open(QIODevice::WriteOnly) || file.write(text) != text.size() ||
    !file.commit())
  {
    this->Document->say(text.isEmpty()
        ? tr("There is no transfer function to save.")
        : tr("%1 cannot be written: %2.").arg(QFileInfo(path).fileName(), file.errorString()));
    return false;
  }
  return true;
}

//-----------------------------------------------------------------------------
void pqTFCPresets::fillPresets()
{
  this->Presets->clear();
  QAction* saveAction = this->Presets->addAction(tr("Save as Preset ..."));
  saveAction->setObjectName("SavePreset");
  QObject::connect(saveAction, &QAction::triggered, this,
    [this]()
    {
      bool accepted = false;
      QString name = QInputDialog::getText(pqCoreUtilities::mainWidget(), tr("Save as Preset"),
        tr("Name of the preset:"), QLineEdit::Normal, QString(), &accepted);
      // A name, not a path.
      name.replace('/', '-').replace('\\', '-');
      if (accepted && !name.trimmed().isEmpty() && QDir().mkpath(this->folder()))
      {
        this->save(this->folder() + "/" + name.trimmed() + SUFFIX);
      }
    });
  QAction* show = this->Presets->addAction(tr("Folder: %1").arg(this->folder()));
  show->setEnabled(false);
  this->Presets->addSeparator();
  const QDir directory(this->folder());
  const QFileInfoList files =
    directory.entryInfoList({ QString("*") + SUFFIX }, QDir::Files, QDir::Name | QDir::IgnoreCase);
  for (const QFileInfo& file : files)
  {
    const QString name = file.fileName().chopped(static_cast<int>(qstrlen(SUFFIX)));
    QMenu* preset = this->Presets->addMenu(name);
    QObject::connect(preset->addAction(tr("Apply")), &QAction::triggered, this,
      [this, file]() { this->open(file.filePath()); });
    QObject::connect(preset->addAction(tr("Rename ...")), &QAction::triggered, this,
      [this, file, name]()
      {
        QString text = QInputDialog::getText(pqCoreUtilities::mainWidget(), tr("Rename Preset"),
          tr("New name:"), QLineEdit::Normal, name);
        text.replace('/', '-').replace('\\', '-');
        if (!text.trimmed().isEmpty() && text != name &&
          !QFile::rename(file.filePath(), this->folder() + "/" + text.trimmed() + SUFFIX))
        {
          this->Document->say(tr("There is a preset %1 already.").arg(text));
        }
      });
    QObject::connect(preset->addAction(tr("Delete")), &QAction::triggered, this,
      [this, file]() { QFile::remove(file.filePath()); });
  }
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
  Silence(copies);
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
