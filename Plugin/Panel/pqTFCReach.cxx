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
  }
  found.sort();
  return found;
}
