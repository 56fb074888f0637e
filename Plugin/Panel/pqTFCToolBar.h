// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCToolBar
 * @brief The buttons above the chart: what the left button draws, and the menus.
 */

#ifndef pqTFCToolBar_h
#define pqTFCToolBar_h

#include <QToolBar>

class QMenu;
class pqTFCAdvice;
class pqTFCChartWidget;
class pqTFCDocument;
class pqTFCHighlight;
class pqTFCPresets;
class pqTFCProbe;

class pqTFCToolBar : public QToolBar
{
  Q_OBJECT
  typedef QToolBar Superclass;

public:
  pqTFCToolBar(pqTFCDocument* document, pqTFCChartWidget* chart, QWidget* parent = nullptr);

  ///@{
  /// Buttons that other parts do the work of.
  void addComputeMenu();
  void addAdvice(pqTFCAdvice* advice);
  void addProbe(pqTFCProbe* probe);
  pqTFCPresets* addFileMenu();
  ///@}

  /// To be switched on and off in the menu of the view.
  void addHighlight(pqTFCHighlight* highlight);

Q_SIGNALS:
  void useDataRanges();

protected:
  void changeEvent(QEvent* event) override;

private:
  Q_DISABLE_COPY(pqTFCToolBar)

  void addTools();
  void addViewMenu();
  QMenu* addMenu(const QString& title, const QString& name, QMenu* menu);
  void updateIcons();
  void refresh();

  pqTFCDocument* Document;
  pqTFCChartWidget* Chart;
  QMenu* ViewMenu = nullptr;
  QList<QAction*> Tools;        ///< by vtkTFCDomainChart::Tools
  QList<QAction*> ReadyActions; ///< need something to edit
};

#endif
