// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCRegionDelegate.h"

#include "pqTFCRegionModel.h"
#include "pqTFCTertiaryBox.h"
#include "vtkTFCRegion.h"

#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QPersistentModelIndex>
#include <QPointer>
#include <QWidget>

#include <algorithm>

namespace
{
constexpr int LONGEST = 30; // characters
}

//-----------------------------------------------------------------------------
pqTFCRegionDelegate::pqTFCRegionDelegate(pqTFCDocument* document, pqTFCAdvice* advice,
  QObject* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Advice(advice)
{
}

//-----------------------------------------------------------------------------
pqTFCRegionDelegate::~pqTFCRegionDelegate() = default;

//-----------------------------------------------------------------------------
void pqTFCRegionDelegate::finish(QWidget* editor)
{
  Q_EMIT this->commitData(editor);
  Q_EMIT this->closeEditor(editor);
}

//-----------------------------------------------------------------------------
QWidget* pqTFCRegionDelegate::createEditor(QWidget* parentObject,
  const QStyleOptionViewItem& option, const QModelIndex& index) const
{
  QComboBox* box = nullptr;
  if (index.column() == pqTFCRegionModel::Falloff)
  {
    box = new QComboBox(parentObject);
    box->addItems(pqTFCRegionModel::falloffs());
  }
  else if (index.column() == pqTFCRegionModel::Tertiary)
  {
    const auto* model = qobject_cast<const pqTFCRegionModel*>(index.model());
    vtkTFCRegion* region = model ? model->region(index.row()) : nullptr;
    box = new pqTFCTertiaryBox(this->Document, this->Advice, parentObject,
      region ? region->GetId() : 0);
  }
  QWidget* editor = box ? box : this->Superclass::createEditor(parentObject, option, index);
  if (box)
  {
    // What is chosen counts at once, as in the boxes below the list; after the box's own event.
    auto* self = const_cast<pqTFCRegionDelegate*>(this);
    QObject::connect(
      box, QOverload<int>::of(&QComboBox::activated), box, [self, box]() { self->finish(box); },
      Qt::QueuedConnection);
    box->setFocusPolicy(Qt::StrongFocus);
  }
  if (editor)
  {
    editor->setObjectName("Editor");
    editor->setAutoFillBackground(true);
    editor->setAccessibleName(
      index.model()->headerData(index.column(), Qt::Horizontal, Qt::AccessibleTextRole).toString());
    editor->setToolTip(
      index.model()->headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole).toString());
  }
  return editor;
}

//-----------------------------------------------------------------------------
void pqTFCRegionDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
  // The box of attributes shows by itself what the region has.
  if (!qobject_cast<pqTFCTertiaryBox*>(editor))
  {
    this->Superclass::setEditorData(editor, index);
  }
}

//-----------------------------------------------------------------------------
void pqTFCRegionDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
  const QModelIndex& index) const
{
  if (auto* box = qobject_cast<pqTFCTertiaryBox*>(editor))
  {
    // Not the label: two attributes may share one.
    model->setData(index, box->currentData(pqTFCTertiaryBox::AttributeRole).toInt());
    return;
  }
  this->Superclass::setModelData(editor, model, index);
}

//-----------------------------------------------------------------------------
bool pqTFCRegionDelegate::editorEvent(QEvent* e, QAbstractItemModel* model,
  const QStyleOptionViewItem& option, const QModelIndex& index)
{
  if (e->type() == QEvent::MouseButtonDblClick && index.column() == pqTFCRegionModel::Color &&
    index.flags() & Qt::ItemIsEditable)
  {
    // The view first finishes with the click: the dialog waits for its answer.
    const QPersistentModelIndex cell(index);
    QPointer<QWidget> view(const_cast<QWidget*>(option.widget));
    QMetaObject::invokeMethod(
      this,
      [model, cell, view]()
      {
        const QColor before(cell.data(Qt::EditRole).toString());
        const QColor color =
          QColorDialog::getColor(before, view, pqTFCRegionDelegate::tr("Colour of the region"));
        if (color.isValid() && cell.isValid())
        {
          model->setData(cell, color.name());
        }
      },
      Qt::QueuedConnection);
    return true;
  }
  return this->Superclass::editorEvent(e, model, option, index);
}

//-----------------------------------------------------------------------------
QSize pqTFCRegionDelegate::sizeHint(const QStyleOptionViewItem& option,
  const QModelIndex& index) const
{
  const QSize size = this->Superclass::sizeHint(option, index);
  return QSize(std::min(size.width(), LONGEST * option.fontMetrics.averageCharWidth()),
    size.height());
}
