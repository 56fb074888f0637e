// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCToolBar.h"

#include "pqTFCAdvice.h"
#include "pqTFCAdviceDialog.h"
#include "pqTFCChartWidget.h"
#include "pqTFCComputeMenu.h"
#include "pqTFCDocument.h"
#include "pqTFCHighlight.h"
#include "pqTFCIcons.h"
#include "pqTFCKeysPage.h"
#include "pqTFCPresets.h"
#include "pqTFCProbe.h"
#include "vtkTFCDomainChart.h"
#include "vtkTFCHistogramItem.h"
#include "vtkTFCTransferFunction.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QMenu>
#include <QToolButton>

#include <functional>

//-----------------------------------------------------------------------------
pqTFCToolBar::pqTFCToolBar(pqTFCDocument* document, pqTFCChartWidget* chart, QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Chart(chart)
{
  this->setObjectName("Tools");
  const int size = this->fontMetrics().height() + 4;
  this->setIconSize(QSize(size, size));
  this->addTools();
  this->addSeparator();
  QAction* fit = this->addAction(tr("Fit"));
  fit->setObjectName("Fit");
  fit->setToolTip(tr("Show all of the axes (key 0)"));
  QObject::connect(fit, &QAction::triggered, this, [this]() { this->Chart->chart()->FitAll(); });
  this->addViewMenu();
  this->updateIcons();
  QObject::connect(chart, &pqTFCChartWidget::toolChanged, this,
    [this]() { this->Tools[this->Chart->chart()->GetTool()]->setChecked(true); });
  QObject::connect(document, &pqTFCDocument::targetChanged, this, &pqTFCToolBar::refresh);
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCToolBar::refresh);
  this->refresh();
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::addTools()
{
  auto* group = new QActionGroup(this);
  const QStringList names = { tr("Select"), tr("Ellipse"), tr("Rectangle"), tr("Triangle"),
    tr("Polygon"), tr("Lasso") };
  const QStringList keys = { "V", "E", "R", "T", "P", "L" };
  const QStringList what = { tr("Select and edit regions"), tr("Draw an ellipse"),
    tr("Draw a rectangle"), tr("Draw a triangle"), tr("Click the corners of a polygon"),
    tr("Draw around what the region shall hold") };
  for (int tool = 0; tool < names.size(); ++tool)
  {
    QAction* action = this->addAction(names[tool]);
    action->setObjectName(names[tool]);
    action->setCheckable(true);
    action->setChecked(tool == 0);
    action->setToolTip(tr("%1 (key %2 in the chart)").arg(what[tool], keys[tool]));
    group->addAction(action);
    this->Tools << action;
    QObject::connect(action, &QAction::triggered, this,
      [this, tool]()
      {
        this->Chart->chart()->SetTool(tool);
        this->Chart->setFocus();
      });
  }
}

//-----------------------------------------------------------------------------
QMenu* pqTFCToolBar::addMenu(const QString& title, const QString& name, QMenu* menu)
{
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setText(title);
  button->setPopupMode(QToolButton::InstantPopup);
  menu->setParent(button, menu->windowFlags());
  menu->setObjectName(name);
  button->setMenu(menu);
  this->addWidget(button);
  return menu;
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::addViewMenu()
{
  QMenu* menu = this->addMenu(tr("View"), "ViewMenu", new QMenu(this));
  vtkTFCDomainChart* chart = this->Chart->chart();
  const auto addChoice = [&](const QString& title, const QStringList& names, int current,
                           const std::function<void(int)>& set)
  {
    menu->addSection(title);
    auto* group = new QActionGroup(menu);
    for (int i = 0; i < names.size(); ++i)
    {
      QAction* action = menu->addAction(names[i]);
      action->setObjectName(names[i]);
      action->setCheckable(true);
      action->setChecked(i == current);
      group->addAction(action);
      QObject::connect(action, &QAction::triggered, this,
        [this, set, i]()
        {
          set(i);
          this->Chart->renderLater();
        });
    }
  };
  addChoice(tr("Scale of the histogram"), { tr("Linear"), tr("Logarithmic"), tr("Percentile 95") },
    chart->GetHistogram()->GetScale(), [chart](int i) { chart->GetHistogram()->SetScale(i); });
  addChoice(tr("Colours of the histogram"), { tr("Gray"), tr("Viridis"), tr("Inferno") },
    chart->GetHistogram()->GetColorMap(),
    [chart](int i) { chart->GetHistogram()->SetColorMap(i); });
  menu->addSeparator();
  QAction* regions = menu->addAction(tr("Fit to regions"));
  regions->setObjectName("FitRegions");
  regions->setToolTip(tr("Show the selected regions, or all where none is selected"));
  QObject::connect(regions, &QAction::triggered, this,
    [chart]() { chart->FitRegions(!chart->GetSelection().empty()); });
  QAction* ranges = menu->addAction(tr("Ranges of the data"));
  ranges->setObjectName("DataRanges");
  QObject::connect(ranges, &QAction::triggered, this, &pqTFCToolBar::useDataRanges);
  menu->addSeparator();
  QAction* keys = menu->addAction(tr("Keys and Mouse ..."));
  keys->setObjectName("Keys");
  QObject::connect(keys, &QAction::triggered, this, [this]() { pqTFCShowKeysPage(this); });
  this->ViewMenu = menu;
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::addHighlight(pqTFCHighlight* highlight)
{
  auto* action = new QAction(tr("Highlight Region under Pointer"), this->ViewMenu);
  action->setObjectName("Highlight");
  action->setCheckable(true);
  action->setChecked(highlight->isEnabled());
  action->setToolTip(tr("While the pointer rests on a region in the chart or in the list, the "
                        "others are dimmed in the 3D view"));
  QObject::connect(action, &QAction::toggled, highlight, &pqTFCHighlight::setEnabled);
  this->ViewMenu->insertAction(this->ViewMenu->actions().constLast(), action);
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::addComputeMenu()
{
  QMenu* menu =
    this->addMenu(tr("Compute"), "ComputeMenu", new pqTFCComputeMenu(this->Document, this));
  menu->parentWidget()->setToolTip(
    tr("Attributes of the primary axis, to be used as axes or tertiary attributes"));
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::addAdvice(pqTFCAdvice* advice)
{
  QAction* action = this->addAction(tr("Advice"));
  action->setObjectName("Advice");
  action->setToolTip(tr("Axes, tertiary attributes and splits that the data suggest"));
  QObject::connect(action, &QAction::triggered, this,
    [this, advice]()
    {
      auto* dialog = this->findChild<pqTFCAdviceDialog*>();
      if (!dialog)
      {
        dialog = new pqTFCAdviceDialog(this->Document, advice, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
      }
      dialog->show();
      dialog->raise();
      dialog->activateWindow();
    });
  this->ReadyActions << action;
  this->refresh();
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::addProbe(pqTFCProbe* probe)
{
  QAction* action = this->addAction(tr("Probe"));
  action->setObjectName("Probe");
  action->setCheckable(true);
  action->setToolTip(tr("Click into the 3D view: what is visible there, which regions make it so"));
  QObject::connect(action, &QAction::toggled, probe, &pqTFCProbe::setActive);
  this->ReadyActions << action;
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCPresets* pqTFCToolBar::addFileMenu()
{
  auto* presets = new pqTFCPresets(this->Document, this);
  this->addMenu(tr("File"), "FileMenu", presets);
  return presets;
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::refresh()
{
  const bool ready = this->Document->isReady();
  for (QAction* action : this->Tools)
  {
    action->setEnabled(ready && this->Document->model()->HasAxes());
  }
  for (QAction* action : this->ReadyActions)
  {
    action->setEnabled(ready);
  }
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::updateIcons()
{
  for (int tool = 0; tool < this->Tools.size(); ++tool)
  {
    this->Tools[tool]->setIcon(pqTFCToolIcon(tool, this->palette()));
  }
}

//-----------------------------------------------------------------------------
void pqTFCToolBar::changeEvent(QEvent* e)
{
  this->Superclass::changeEvent(e);
  if (e->type() == QEvent::PaletteChange)
  {
    this->updateIcons();
  }
}
