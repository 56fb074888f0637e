// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCColumnMenu
 * @brief Which columns of the list of regions show: an entry per column, kept in ParaView's
 * settings. Also the context menu of the header.
 *
 * The first column stays. Others are as wide as what they hold; the first one takes the room that
 * is left, and the list scrolls where there is none.
 */

#ifndef pqTFCColumnMenu_h
#define pqTFCColumnMenu_h

#include <QMenu>

class QTableView;

class pqTFCColumnMenu : public QMenu
{
  Q_OBJECT
  typedef QMenu Superclass;

public:
  /// For a view of a pqTFCRegionModel.
  pqTFCColumnMenu(QTableView* view, QWidget* parent = nullptr);
  ~pqTFCColumnMenu() override;

public Q_SLOTS:
  /// Again after the view or what it shows has another size.
  void fit();

private Q_SLOTS:
  void choose();

private:
  Q_DISABLE_COPY(pqTFCColumnMenu)

  QTableView* View;
};

#endif
