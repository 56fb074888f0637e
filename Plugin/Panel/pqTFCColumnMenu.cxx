// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCColumnMenu.h"

#include "pqApplicationCore.h"
#include "pqSettings.h"
#include "pqTFCRegionModel.h"

#include <QAction>
#include <QHeaderView>
#include <QStringList>
#include <QTableView>

#include <algorithm>

namespace
{
const char* const SETTING = "TransferFunctionCombinations/RegionColumns";

// What most people edit; all else is in the form below the list as well.
QStringList DefaultColumns()
{
  QStringList names;
  for (int column = 0; column <= pqTFCRegionModel::Lock; ++column)
  {
    names << pqTFCRegionModel::columnName(column);
  }
  return names;
}
}

//-----------------------------------------------------------------------------
pqTFCColumnMenu::pqTFCColumnMenu(QTableView* view, QWidget* parentObject)
  : Superclass(parentObject)
  , View(view)
{
  this->setObjectName("ColumnMenu");
  const QStringList shown =
    pqApplicationCore::instance()->settings()->value(SETTING, DefaultColumns()).toStringList();
  QHeaderView* header = view->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  // The colour beside the name, the lock at the end.
  header->moveSection(pqTFCRegionModel::Color, 1);
  header->moveSection(header->visualIndex(pqTFCRegionModel::Lock), header->count() - 1);
  for (int visual = 1; visual < header->count(); ++visual)
  {
    const int column = header->logicalIndex(visual);
    const QString name = pqTFCRegionModel::columnName(column);
    QAction* action = this->addAction(view->model()->headerData(column, Qt::Horizontal).toString());
    action->setObjectName(name);
    action->setCheckable(true);
    action->setData(column);
    action->setChecked(shown.contains(name));
    view->setColumnHidden(column, !action->isChecked());
    QObject::connect(action, &QAction::toggled, this, &pqTFCColumnMenu::choose);
  }
  header->setContextMenuPolicy(Qt::CustomContextMenu);
  QObject::connect(header, &QWidget::customContextMenuRequested, this,
    [this, header](const QPoint& place) { this->popup(header->mapToGlobal(place)); });
}

//-----------------------------------------------------------------------------
pqTFCColumnMenu::~pqTFCColumnMenu() = default;

//-----------------------------------------------------------------------------
void pqTFCColumnMenu::choose()
{
  QStringList shown;
  for (const QAction* action : this->actions())
  {
    this->View->setColumnHidden(action->data().toInt(), !action->isChecked());
    if (action->isChecked())
    {
      shown << action->objectName();
    }
  }
  pqApplicationCore::instance()->settings()->setValue(SETTING, shown);
  this->fit();
}

//-----------------------------------------------------------------------------
void pqTFCColumnMenu::fit()
{
  QHeaderView* header = this->View->horizontalHeader();
  header->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  const bool isRoom = header->length() <= this->View->viewport()->width();
  // Else it would be squeezed to nothing.
  header->setSectionResizeMode(0, isRoom ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
}
