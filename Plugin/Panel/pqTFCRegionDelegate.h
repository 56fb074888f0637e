// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCRegionDelegate
 * @brief Editors for the cells of pqTFCRegionModel: a list for the fall-off and the tertiary
 * attribute, a dialog for a colour that is double clicked, lines of text for all else.
 */

#ifndef pqTFCRegionDelegate_h
#define pqTFCRegionDelegate_h

#include <QStyledItemDelegate>

class pqTFCAdvice;
class pqTFCDocument;

class pqTFCRegionDelegate : public QStyledItemDelegate
{
  Q_OBJECT
  typedef QStyledItemDelegate Superclass;

public:
  pqTFCRegionDelegate(pqTFCDocument* document, pqTFCAdvice* advice, QObject* parent = nullptr);
  ~pqTFCRegionDelegate() override;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
    const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model,
    const QModelIndex& index) const override;
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
    const QModelIndex& index) override;

  /// Long texts do not make their column longer than that of a name.
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
  Q_DISABLE_COPY(pqTFCRegionDelegate)

  void finish(QWidget* editor);

  pqTFCDocument* Document;
  pqTFCAdvice* Advice;
};

#endif
