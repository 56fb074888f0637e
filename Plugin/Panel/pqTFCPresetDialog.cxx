// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCPresetDialog.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>

namespace
{
const QSize PICTURE(112, 84);

// The same when selected: its colours are what one looks for.
QIcon MakeIcon(const QPixmap& pixmap)
{
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}
}

//-----------------------------------------------------------------------------
pqTFCPresetDialog::pqTFCPresetDialog(pqTFCPresetFolder* folder, QWidget* parentObject)
  : Superclass(parentObject)
  , Folder(folder)
{
  this->setObjectName("PresetDialog");
  this->setWindowTitle(tr("Presets of Combined Transfer Functions"));
  this->resize(560, 420);
  auto* layout = new QVBoxLayout(this);
  this->List = new QListWidget(this);
  this->List->setObjectName("List");
  this->List->setAccessibleName(tr("Presets"));
  this->List->setViewMode(QListView::IconMode);
  this->List->setIconSize(PICTURE);
  this->List->setGridSize(PICTURE + QSize(20, 32));
  this->List->setResizeMode(QListView::Adjust);
  this->List->setMovement(QListView::Static);
  this->List->setEditTriggers(QAbstractItemView::EditKeyPressed);
  layout->addWidget(this->List, 1);
  this->Message = new QLabel(this);
  this->Message->setObjectName("Message");
  this->Message->setWordWrap(true);
  this->Message->setTextFormat(Qt::PlainText);
  this->Message->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(this->Message);

  const auto makeButton = [this](const QString& text, const QString& name)
  {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setAutoDefault(false);
    return button;
  };
  auto* row = new QHBoxLayout;
  this->Apply = makeButton(tr("&Apply"), "Apply");
  this->Rename = makeButton(tr("&Rename"), "Rename");
  this->Delete = makeButton(tr("&Delete ..."), "Delete");
  auto* close = makeButton(tr("&Close"), "Close");
  row->addWidget(this->Apply);
  row->addWidget(this->Rename);
  row->addWidget(this->Delete);
  row->addStretch(1);
  row->addWidget(close);
  layout->addLayout(row);
  auto* saveRow = new QHBoxLayout;
  auto* label = new QLabel(tr("&Save the current transfer function as"), this);
  this->Name = new QLineEdit(this);
  this->Name->setObjectName("Name");
  label->setBuddy(this->Name);
  auto* save = makeButton(tr("Sa&ve"), "Save");
  saveRow->addWidget(label);
  saveRow->addWidget(this->Name, 1);
  saveRow->addWidget(save);
  layout->addLayout(saveRow);

  QObject::connect(this->List, &QListWidget::currentItemChanged, this,
    &pqTFCPresetDialog::onSelection);
  QObject::connect(this->List, &QListWidget::itemChanged, this, &pqTFCPresetDialog::onRenamed);
  const auto apply = [this]()
  {
    if (this->current() && this->current()->Problem.isEmpty())
    {
      this->say(QString());
      Q_EMIT this->applied(this->current()->Path);
    }
  };
  QObject::connect(this->Apply, &QPushButton::clicked, this, apply);
  QObject::connect(this->List, &QListWidget::itemDoubleClicked, this, apply);
  QObject::connect(this->Rename, &QPushButton::clicked, this,
    [this]() { this->List->editItem(this->List->currentItem()); });
  QObject::connect(this->Delete, &QPushButton::clicked, this, &pqTFCPresetDialog::onDelete);
  QObject::connect(close, &QPushButton::clicked, this, &QDialog::reject);
  const auto saveName = [this]() { Q_EMIT this->saved(this->Name->text()); };
  QObject::connect(save, &QPushButton::clicked, this, saveName);
  QObject::connect(this->Name, &QLineEdit::returnPressed, this, saveName);
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCPresetDialog::~pqTFCPresetDialog() = default;

//-----------------------------------------------------------------------------
const pqTFCPresetFolder::Preset* pqTFCPresetDialog::current() const
{
  const int row = this->List->currentRow();
  return row >= 0 && row < this->Presets.size() ? &this->Presets[row] : nullptr;
}

//-----------------------------------------------------------------------------
void pqTFCPresetDialog::refresh(const QString& select)
{
  {
    const QSignalBlocker blocker(this->List);
    this->Presets = this->Folder->list(PICTURE, this->palette());
    this->List->clear();
    for (const pqTFCPresetFolder::Preset& preset : this->Presets)
    {
      auto* item = new QListWidgetItem(preset.Name, this->List);
      item->setFlags(item->flags() | Qt::ItemIsEditable);
      QPixmap picture(PICTURE);
      picture.fill(Qt::transparent);
      QPainter painter(&picture);
      if (preset.Problem.isEmpty())
      {
        painter.drawImage(0, 0, preset.Picture);
      }
      else
      {
        this->style()
          ->standardIcon(QStyle::SP_MessageBoxWarning)
          .paint(&painter, QRect(QPoint(0, 0), PICTURE));
      }
      painter.end();
      item->setIcon(MakeIcon(picture));
      item->setToolTip(preset.Problem.isEmpty() ? preset.Path : preset.Problem);
      if (preset.Name == select)
      {
        this->List->setCurrentItem(item);
      }
    }
  }
  if (this->Presets.isEmpty())
  {
    this->say(tr("No presets yet. They are kept in %1.").arg(pqTFCPresetFolder::path()));
  }
  this->onSelection();
}

//-----------------------------------------------------------------------------
void pqTFCPresetDialog::onSelection()
{
  const pqTFCPresetFolder::Preset* preset = this->current();
  this->Apply->setEnabled(preset && preset->Problem.isEmpty());
  this->Rename->setEnabled(preset != nullptr);
  this->Delete->setEnabled(preset != nullptr);
  if (preset)
  {
    this->say(preset->Problem.isEmpty()
        ? QString()
        : tr("%1 cannot be read. %2 Correct the file %3, or delete the preset.")
            .arg(preset->Name, preset->Problem, QFileInfo(preset->Path).fileName()));
  }
}

//-----------------------------------------------------------------------------
void pqTFCPresetDialog::onRenamed(QListWidgetItem* item)
{
  const int row = this->List->row(item);
  if (row < 0 || row >= this->Presets.size() || item->text() == this->Presets[row].Name)
  {
    return;
  }
  const QString problem = this->Folder->rename(this->Presets[row], item->text());
  const QString name = problem.isEmpty() ? item->text().trimmed() : this->Presets[row].Name;
  // Not while the list is in the middle of this edit.
  QMetaObject::invokeMethod(
    this,
    [this, name, problem]()
    {
      this->refresh(name);
      if (!problem.isEmpty())
      {
        this->say(problem);
      }
    },
    Qt::QueuedConnection);
}

//-----------------------------------------------------------------------------
void pqTFCPresetDialog::onDelete()
{
  if (!this->current())
  {
    return;
  }
  const pqTFCPresetFolder::Preset preset = *this->current();
  QMessageBox question(QMessageBox::Question, this->windowTitle(),
    tr("Delete the preset %1? This cannot be undone.").arg(preset.Name),
    QMessageBox::Yes | QMessageBox::No, this);
  question.setObjectName("DeletePreset");
  question.setTextFormat(Qt::PlainText);
  question.setDefaultButton(QMessageBox::No);
  if (question.exec() == QMessageBox::Yes)
  {
    const QString problem = this->Folder->remove(preset);
    this->refresh();
    this->say(problem);
  }
}

//-----------------------------------------------------------------------------
void pqTFCPresetDialog::say(const QString& text)
{
  this->Message->setText(text);
}

//-----------------------------------------------------------------------------
QString pqTFCPresetDialog::presets() const
{
  QStringList names;
  for (const pqTFCPresetFolder::Preset& preset : this->Presets)
  {
    names << preset.Name + (preset.Problem.isEmpty() ? "" : " (unreadable)");
  }
  return names.join("; ");
}

//-----------------------------------------------------------------------------
QString pqTFCPresetDialog::message() const
{
  return this->Message->text();
}

//-----------------------------------------------------------------------------
QString pqTFCPresetDialog::pictureColor() const
{
  const pqTFCPresetFolder::Preset* preset = this->current();
  return preset && !preset->Picture.isNull()
    ? preset->Picture.pixelColor(PICTURE.width() / 2, PICTURE.height() / 2).name()
    : QString();
}
