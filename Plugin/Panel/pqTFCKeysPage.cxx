// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCKeysPage.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QStringList>

//-----------------------------------------------------------------------------
void pqTFCShowKeysPage(QWidget* parent)
{
  const QList<QStringList> rows = {
    { QCoreApplication::translate("pqTFCKeysPage", "V E R T P L"),
      QCoreApplication::translate("pqTFCKeysPage",
        "select, ellipse, rectangle, triangle, polygon, lasso") },
    { QCoreApplication::translate("pqTFCKeysPage", "arrows, with Shift"),
      QCoreApplication::translate("pqTFCKeysPage", "move the selected regions by 1 pixel, by 10") },
    { QCoreApplication::translate("pqTFCKeysPage", "Page Up, Page Down, with Shift"),
      QCoreApplication::translate("pqTFCKeysPage",
        "opacity of the selected regions up, down by 0.05, by 0.01") },
    { QCoreApplication::translate("pqTFCKeysPage", "Tab, Shift+Tab"),
      QCoreApplication::translate("pqTFCKeysPage", "next and previous region") },
    { QCoreApplication::translate("pqTFCKeysPage", "Ctrl+A, Ctrl+D, Delete"),
      QCoreApplication::translate("pqTFCKeysPage", "select all, duplicate, delete") },
    { QCoreApplication::translate("pqTFCKeysPage", "Return, Backspace"),
      QCoreApplication::translate("pqTFCKeysPage", "close a polygon, take back its last corner") },
    { QCoreApplication::translate("pqTFCKeysPage", "Escape"),
      QCoreApplication::translate("pqTFCKeysPage", "put back what is being dragged") },
    { QCoreApplication::translate("pqTFCKeysPage", "+ - 0, wheel"),
      QCoreApplication::translate("pqTFCKeysPage", "zoom in, out, show all of the axes") },
    { QCoreApplication::translate("pqTFCKeysPage", "middle button, Alt+left"),
      QCoreApplication::translate("pqTFCKeysPage", "pan") },
    { QCoreApplication::translate("pqTFCKeysPage", "Shift while dragging"),
      QCoreApplication::translate("pqTFCKeysPage",
        "keep proportions, turn in steps of 15 degrees, change the opacity finely") },
    { QCoreApplication::translate("pqTFCKeysPage", "Ctrl while dragging"),
      QCoreApplication::translate("pqTFCKeysPage", "keep the centre") },
    { QCoreApplication::translate("pqTFCKeysPage", "double click"),
      QCoreApplication::translate("pqTFCKeysPage",
        "on an edge: new corner; on a corner: remove it") },
    { QCoreApplication::translate("pqTFCKeysPage", "in the list: F2, space bar"),
      QCoreApplication::translate("pqTFCKeysPage", "edit a value; show, hide, lock") },
    { QCoreApplication::translate("pqTFCKeysPage", "in the list: Alt+Up, Alt+Down"),
      QCoreApplication::translate("pqTFCKeysPage", "move the region up, down") },
  };
  QString text = "<table cellpadding=3>";
  for (const QStringList& row : rows)
  {
    text += "<tr><td><b>" + row[0].toHtmlEscaped() + "</b></td><td>" + row[1].toHtmlEscaped() +
      "</td></tr>";
  }
  QMessageBox box(QMessageBox::NoIcon,
    QCoreApplication::translate("pqTFCKeysPage", "Keys and Mouse"), text + "</table>",
    QMessageBox::Close, parent);
  box.setObjectName("Keys");
  box.exec();
}
