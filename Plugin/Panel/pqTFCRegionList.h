// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCRegionList
 * @brief The table of regions with its buttons; selects what the chart selects.
 *
 * Every property of a region is a column (pqTFCRegionModel); a menu says which of them show. Alt
 * with the arrows up and down changes the order.
 */

#ifndef pqTFCRegionList_h
#define pqTFCRegionList_h

#include <QList>
#include <QWidget>

class QAction;
class QTableView;
class QToolBar;
class pqTFCAdvice;
class pqTFCColumnMenu;
class pqTFCDocument;
class pqTFCRegionModel;

class pqTFCRegionList : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  pqTFCRegionList(pqTFCDocument* document, pqTFCAdvice* advice, QWidget* parent = nullptr);
  ~pqTFCRegionList() override;

Q_SIGNALS:
  /// Buttons whose work the chart does.
  void duplicate();
  void remove();
  /// Id of the region under the pointer, 0 for none.
  void hovered(int region);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private Q_SLOTS:
  void refresh();
  void onListSelection();

private:
  Q_DISABLE_COPY(pqTFCRegionList)

  QToolBar* makeActions();
  void addBlendMenu(QToolBar* bar);
  void moveRegion(int by);

  pqTFCDocument* Document;
  pqTFCRegionModel* Model;
  QTableView* List;
  pqTFCColumnMenu* Columns;
  QList<QAction*> Actions;
  QList<QAction*> Blends; ///< by vtkTFCTransferFunction::BlendTypes
  bool Synchronizing = false;
};

#endif
