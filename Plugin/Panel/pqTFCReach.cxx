// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCReach.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAccessible>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>

namespace
{
QString PathOf(const QWidget* widget, const QWidget* parent)
{
  QStringList names;
  for (; widget && widget != parent; widget = widget->parentWidget())
  {
    names.prepend(
      widget->objectName().isEmpty() ? widget->metaObject()->className() : widget->objectName());
  }
  return names.join("/");
}

bool IsInteractive(const QWidget* widget)
{
  // Qt's own parts of a widget are reached and named through it.
  if (!widget || qobject_cast<const QScrollBar*>(widget) ||
    qobject_cast<const QAbstractScrollArea*>(widget->parentWidget()) ||
    qobject_cast<const QComboBox*>(widget->parentWidget()) ||
    widget->objectName().startsWith("qt_"))
  {
    return false;
  }
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
    qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
    qobject_cast<const QAbstractItemView*>(widget) || widget->focusPolicy() != Qt::NoFocus;
}

bool HasName(QWidget* widget)
{
  QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
  return (interface && !interface->text(QAccessible::Name).trimmed().isEmpty()) ||
    !widget->accessibleName().isEmpty() || !widget->toolTip().isEmpty();
}

// Headers and cells that show.
QStringList NamelessCells(const QTableView* table)
{
  QStringList found;
  const QAbstractItemModel* model = table->model();
  const auto isNamed = [](const QVariant& said, const QVariant& shown)
  { return !said.toString().trimmed().isEmpty() || !shown.toString().trimmed().isEmpty(); };
  for (int column = 0; model && column < model->columnCount(); ++column)
  {
    if (table->isColumnHidden(column))
    {
      continue;
    }
    if (!isNamed(model->headerData(column, Qt::Horizontal, Qt::AccessibleTextRole),
          model->headerData(column, Qt::Horizontal)))
    {
      found << QString("column %1").arg(column);
    }
    for (int row = 0; row < model->rowCount(); ++row)
    {
      const QModelIndex cell = model->index(row, column);
      if (!table->indexWidget(cell) && !isNamed(cell.data(Qt::AccessibleTextRole), cell.data()))
      {
        found << QString("cell %1.%2").arg(row).arg(column);
      }
    }
  }
  return found;
}
}

//-----------------------------------------------------------------------------
void pqTFCLetTabReach(QWidget* toolBar)
{
  for (QToolButton* button : toolBar->findChildren<QToolButton*>())
  {
    // Not the button that shows what has no room: Qt hides and shows it.
    if (!button->objectName().startsWith("qt_"))
    {
      button->setFocusPolicy(Qt::TabFocus);
    }
  }
}

//-----------------------------------------------------------------------------
void pqTFCNameParts(QWidget* widget)
{
  for (QWidget* part : widget->findChildren<QWidget*>())
  {
    if (part->focusPolicy() != Qt::NoFocus)
    {
      part->setAccessibleName(widget->accessibleName());
      part->setToolTip(widget->toolTip());
    }
  }
}

//-----------------------------------------------------------------------------
QStringList pqTFCOutOfReach(QWidget* parent)
{
  QStringList found;
  for (QWidget* widget : parent->findChildren<QWidget*>())
  {
    if (!widget->isVisibleTo(parent) || !IsInteractive(widget))
    {
      continue;
    }
    if (!HasName(widget))
    {
      found << PathOf(widget, parent) + " has no name";
    }
    if (!(widget->focusPolicy() & Qt::TabFocus))
    {
      found << PathOf(widget, parent) + " is not reached with Tab";
    }
    if (const auto* table = qobject_cast<const QTableView*>(widget))
    {
      for (const QString& cell : NamelessCells(table))
      {
        found << PathOf(widget, parent) + " " + cell + " has no name";
      }
    }
  }
  found.sort();
  return found;
}
