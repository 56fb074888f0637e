// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCRegionList.h"

#include "pqTFCColumnMenu.h"
#include "pqTFCDocument.h"
#include "pqTFCReach.h"
#include "pqTFCRegionDelegate.h"
#include "pqTFCRegionModel.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>

//-----------------------------------------------------------------------------
pqTFCRegionList::pqTFCRegionList(pqTFCDocument* document, pqTFCAdvice* advice,
  QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  this->setObjectName("ListPart");
  this->Model = new pqTFCRegionModel(document, this);
  this->List = new QTableView(this);
  this->List->setObjectName("List");
  this->List->setAccessibleName(tr("Regions"));
  this->List->setModel(this->Model);
  this->List->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->List->setSelectionMode(QAbstractItemView::ExtendedSelection);
  this->List->setTabKeyNavigation(false);
  this->List->setShowGrid(false);
  this->List->setMinimumHeight(60);
  this->List->verticalHeader()->hide();
  this->List->verticalHeader()->setDefaultSectionSize(this->fontMetrics().height() + 6);
  this->List->horizontalHeader()->setHighlightSections(false);
  this->List->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  this->List->setItemDelegate(new pqTFCRegionDelegate(document, advice, this->List));
  this->Columns = new pqTFCColumnMenu(this->List, this);

  this->List->setMouseTracking(true);
  this->List->installEventFilter(this);
  this->List->viewport()->installEventFilter(this);
  QObject::connect(this->List, &QTableView::entered, this,
    [this](const QModelIndex& index)
    {
      vtkTFCRegion* region = this->Model->region(index.row());
      Q_EMIT this->hovered(region ? region->GetId() : 0);
    });
  QObject::connect(this->List, &QTableView::viewportEntered, this,
    [this]() { Q_EMIT this->hovered(0); });

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(this->makeActions());
  layout->addWidget(this->List, 1);
  QObject::connect(this->List->selectionModel(), &QItemSelectionModel::selectionChanged, this,
    &pqTFCRegionList::onListSelection);
  QObject::connect(document, &pqTFCDocument::selectionChanged, this, &pqTFCRegionList::refresh);
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCRegionList::refresh);
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCRegionList::~pqTFCRegionList() = default;

//-----------------------------------------------------------------------------
bool pqTFCRegionList::eventFilter(QObject* watched, QEvent* e)
{
  if (watched == this->List->viewport() && e->type() == QEvent::Leave)
  {
    Q_EMIT this->hovered(0);
  }
  else if (watched == this->List->viewport() && e->type() == QEvent::Resize)
  {
    this->Columns->fit();
    // When the scroll bars know about it.
    QMetaObject::invokeMethod(
      this,
      [this]()
      {
        if (this->Document->activeRegion())
        {
          this->List->scrollTo(this->List->currentIndex());
        }
      },
      Qt::QueuedConnection);
  }
  else if (watched == this->List && e->type() == QEvent::KeyPress)
  {
    const auto* key = static_cast<QKeyEvent*>(e);
    const int by = key->key() == Qt::Key_Up ? -1 : key->key() == Qt::Key_Down ? 1 : 0;
    if (by && key->modifiers() & Qt::AltModifier)
    {
      this->moveRegion(by);
      return true;
    }
  }
  return this->Superclass::eventFilter(watched, e);
}

//-----------------------------------------------------------------------------
QToolBar* pqTFCRegionList::makeActions()
{
  auto* bar = new QToolBar(this);
  bar->setObjectName("RegionTools");
  const auto add = [&](const QString& name, const QString& tip, const std::function<void()>& act)
  {
    QAction* action = bar->addAction(name);
    action->setObjectName(name);
    action->setToolTip(tip);
    this->Actions << action;
    QObject::connect(action, &QAction::triggered, this, act);
  };
  add(tr("Duplicate"), tr("Duplicate the selected regions (Ctrl+D in the chart)"),
    [this]() { Q_EMIT this->duplicate(); });
  add(tr("Delete"), tr("Delete the selected regions (Del in the chart)"),
    [this]() { Q_EMIT this->remove(); });
  add(tr("Up"),
    tr("Move the region up (Alt+Up in the list). The first one may be in front: see Overlaps"),
    [this]() { this->moveRegion(-1); });
  add(tr("Down"), tr("Move the region down (Alt+Down in the list)"),
    [this]() { this->moveRegion(1); });
  this->addBlendMenu(bar);
  auto* columns = new QToolButton(bar);
  columns->setObjectName("ColumnMenu");
  columns->setText(tr("Columns"));
  columns->setToolTip(tr("Which properties of the regions the list shows"));
  columns->setPopupMode(QToolButton::InstantPopup);
  this->Columns->setParent(columns, this->Columns->windowFlags());
  columns->setMenu(this->Columns);
  bar->addWidget(columns);
  pqTFCLetTabReach(bar);
  return bar;
}

//-----------------------------------------------------------------------------
void pqTFCRegionList::addBlendMenu(QToolBar* bar)
{
  auto* menu = new QMenu(bar);
  menu->setObjectName("BlendMenu");
  menu->setToolTipsVisible(true);
  auto* group = new QActionGroup(menu);
  const auto add = [&](int blend, const QString& title, const QString& name, const QString& tip)
  {
    QAction* action = menu->addAction(title);
    action->setObjectName(name);
    action->setToolTip(tip);
    action->setCheckable(true);
    group->addAction(action);
    this->Blends << action;
    QObject::connect(action, &QAction::triggered, this,
      [this, blend]()
      {
        this->Document->edit(tr("Change how regions overlap"),
          [this, blend]() { this->Document->model()->SetBlend(blend); });
      });
  };
  add(vtkTFCTransferFunction::Mix, tr("Mix their Colours"), "Mix",
    tr("Where regions share voxels, their colours mix by opacity; the order plays no part"));
  add(vtkTFCTransferFunction::Over, tr("First in Front"), "Over",
    tr("Where regions share voxels, the first one of the list is in front"));
  auto* button = new QToolButton(bar);
  button->setObjectName("BlendMenu");
  button->setText(tr("Overlaps"));
  button->setToolTip(tr("What voxels show that belong to several regions"));
  button->setPopupMode(QToolButton::InstantPopup);
  menu->setParent(button, menu->windowFlags());
  button->setMenu(menu);
  bar->addWidget(button);
}

//-----------------------------------------------------------------------------
void pqTFCRegionList::moveRegion(int by)
{
  vtkTFCTransferFunction* model = this->Document->model();
  vtkTFCRegion* region = this->Document->activeRegion();
  for (int i = 0; region && i < model->GetNumberOfRegions(); ++i)
  {
    const int to = i + by;
    if (model->GetRegion(i) == region && to >= 0 && to < model->GetNumberOfRegions())
    {
      this->Document->edit(tr("Change order"), [&]() { model->MoveRegion(i, to); });
      this->refresh();
      return;
    }
  }
}

//-----------------------------------------------------------------------------
void pqTFCRegionList::onListSelection()
{
  if (!this->Synchronizing)
  {
    std::vector<int> ids;
    for (const QModelIndex& index : this->List->selectionModel()->selectedRows())
    {
      if (vtkTFCRegion* region = this->Model->region(index.row()))
      {
        ids.push_back(region->GetId());
      }
    }
    this->Document->setSelection(ids);
  }
}

//-----------------------------------------------------------------------------
void pqTFCRegionList::refresh()
{
  if (this->Synchronizing)
  {
    return;
  }
  const QScopedValueRollback<bool> synchronizing(this->Synchronizing, true);
  QItemSelection selection;
  for (int row = 0; row < this->Model->rowCount(); ++row)
  {
    for (int id : this->Document->selection())
    {
      if (this->Model->region(row)->GetId() == id)
      {
        const QModelIndex index = this->Model->index(row, 0);
        selection.select(index, index.siblingAtColumn(pqTFCRegionModel::NumberOfColumns - 1));
        // In the column where the keyboard is.
        const QModelIndex current =
          index.siblingAtColumn(std::max(0, this->List->currentIndex().column()));
        this->List->scrollTo(current);
        if (this->Document->activeRegion() && current.row() != this->List->currentIndex().row())
        {
          this->List->selectionModel()->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
        }
      }
    }
  }
  this->List->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  this->Columns->fit();
  for (QAction* action : this->Actions)
  {
    action->setEnabled(!this->Document->selection().empty());
  }
  for (int blend = 0; blend < this->Blends.size(); ++blend)
  {
    this->Blends[blend]->setEnabled(this->Document->isReady());
    this->Blends[blend]->setChecked(blend == this->Document->model()->GetBlend());
  }
}
