// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCPanel.h"

#include "pqTFCAdvice.h"
#include "pqTFCAdviceDialog.h"
#include "pqTFCAxisBar.h"
#include "pqTFCChartWidget.h"
#include "pqTFCComputeMenu.h"
#include "pqTFCDocument.h"
#include "pqTFCIcons.h"
#include "pqTFCKeysPage.h"
#include "pqTFCMessageBar.h"
#include "pqTFCPresets.h"
#include "pqTFCProbe.h"
#include "pqTFCProposal.h"
#include "pqTFCRegionForm.h"
#include "pqTFCRegionList.h"
#include "pqTFCTertiaryEditor.h"
#include "vtkTFCDomainChart.h"
#include "vtkTFCHistogramItem.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

#include <QAction>
#include <QActionGroup>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSplitter>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <cmath>

//-----------------------------------------------------------------------------
pqTFCPanel::pqTFCPanel(QWidget* parentObject)
  : Superclass(tr("Combined Transfer Functions"), parentObject)
  , Document(new pqTFCDocument(this))
  , Advice(new pqTFCAdvice(this->Document, this))
  , Probe(new pqTFCProbe(this->Document, this->Advice, this))
{
  auto* contents = new QWidget(this);
  contents->setObjectName("contents");
  auto* layout = new QVBoxLayout(contents);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(4);

  this->Messages = new pqTFCMessageBar(this->Document, contents);
  this->Axes = new pqTFCAxisBar(this->Document, contents);
  this->Chart = new pqTFCChartWidget(contents);
  this->Status = new QLabel(contents);
  this->Status->setObjectName("Status");
  auto* list = new pqTFCRegionList(this->Document, contents);
  auto* form = new pqTFCRegionForm(this->Document, contents);
  this->Tertiary = new pqTFCTertiaryEditor(this->Document, this->Advice, contents);

  // Above the chart and what belongs to it, below the regions; the user decides on the parts.
  auto* top = new QWidget(contents);
  top->setObjectName("ChartPart");
  auto* topLayout = new QVBoxLayout(top);
  topLayout->setContentsMargins(0, 0, 0, 0);
  topLayout->setSpacing(2);
  topLayout->addWidget(this->makeTools());
  topLayout->addWidget(this->Chart, 1);
  topLayout->addWidget(this->Status);
  topLayout->addWidget(this->Axes);
  auto* bottom = new QWidget(contents);
  bottom->setObjectName("RegionPart");
  auto* bottomLayout = new QVBoxLayout(bottom);
  bottomLayout->setContentsMargins(0, 0, 0, 0);
  bottomLayout->setSpacing(4);
  bottomLayout->addWidget(form);
  bottomLayout->addWidget(this->Tertiary, 1);
  auto* splitter = new QSplitter(Qt::Vertical, contents);
  splitter->setObjectName("Splitter");
  splitter->addWidget(top);
  splitter->addWidget(list);
  splitter->addWidget(bottom);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 1);
  splitter->setStretchFactor(2, 1);
  splitter->setChildrenCollapsible(false);
  layout->addWidget(this->Messages);
  layout->addWidget(splitter, 1);
  this->setWidget(contents);
  this->setAcceptDrops(true);

  this->Chart->chart()->SetTransferFunction(this->Document->model());
  this->updateIcons();

  vtkTFCDomainChart* chart = this->Chart->chart();
  QObject::connect(list, &pqTFCRegionList::duplicate, this,
    [chart]() { chart->DuplicateSelection(); });
  QObject::connect(list, &pqTFCRegionList::remove, this, [chart]() { chart->DeleteSelection(); });
  QObject::connect(this->Chart, &pqTFCChartWidget::editStarted, this,
    [this]()
    {
      this->EditLabel = this->Chart->chart()->GetTool() == vtkTFCDomainChart::Select
        ? tr("Edit region")
        : tr("Create region");
      this->Document->begin();
    });
  QObject::connect(this->Chart, &pqTFCChartWidget::edited, this,
    [this]() { this->Document->live(); });
  QObject::connect(this->Chart, &pqTFCChartWidget::editFinished, this,
    [this]() { this->Document->commit(this->EditLabel); });
  QObject::connect(this->Chart, &pqTFCChartWidget::selectionChanged, this,
    [this, chart]() { this->Document->setSelection(chart->GetSelection()); });
  QObject::connect(this->Chart, &pqTFCChartWidget::hovered, this, &pqTFCPanel::onHover);
  QObject::connect(this->Chart, &pqTFCChartWidget::said, this->Document, &pqTFCDocument::say);
  QObject::connect(this->Chart, &pqTFCChartWidget::toolChanged, this,
    [this]() { this->Tools[this->Chart->chart()->GetTool()]->setChecked(true); });
  QObject::connect(this->Document, &pqTFCDocument::selectionChanged, this,
    [this, chart]() { chart->SetSelection(this->Document->selection()); });
  QObject::connect(this->Document, &pqTFCDocument::targetChanged, this,
    &pqTFCPanel::onTargetChanged);
  QObject::connect(this->Document, &pqTFCDocument::changed, this, &pqTFCPanel::onChanged);
  QObject::connect(this->Document, &pqTFCDocument::histogramsChanged, this,
    &pqTFCPanel::onHistograms);
  QObject::connect(this->Probe, &pqTFCProbe::found, this,
    [this, chart](double x, double y)
    {
      chart->SetProbe(x, y);
      this->Chart->renderLater();
    });
  QObject::connect(this->Probe, &pqTFCProbe::lost, this,
    [this, chart]()
    {
      chart->ClearProbe();
      this->Chart->renderLater();
    });
  QObject::connect(this->Probe, &pqTFCProbe::told, this, &pqTFCPanel::onHover);
  new pqTFCProposal(this->Document, this->Advice, this);
  this->onTargetChanged();
}

//-----------------------------------------------------------------------------
pqTFCPanel::~pqTFCPanel() = default;

//-----------------------------------------------------------------------------
QToolBar* pqTFCPanel::makeTools()
{
  auto* bar = new QToolBar(this);
  bar->setObjectName("Tools");
  const int size = this->fontMetrics().height() + 4;
  bar->setIconSize(QSize(size, size));
  auto* group = new QActionGroup(this);
  const QStringList names = { tr("Select"), tr("Ellipse"), tr("Rectangle"), tr("Triangle"),
    tr("Polygon"), tr("Lasso") };
  const QStringList keys = { "V", "E", "R", "T", "P", "L" };
  const QStringList what = { tr("Select and edit regions"), tr("Draw an ellipse"),
    tr("Draw a rectangle"), tr("Draw a triangle"), tr("Click the corners of a polygon"),
    tr("Draw around what the region shall hold") };
  for (int tool = 0; tool < names.size(); ++tool)
  {
    QAction* action = bar->addAction(names[tool]);
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
  bar->addSeparator();
  QAction* fit = bar->addAction(tr("Fit"));
  fit->setObjectName("Fit");
  fit->setToolTip(tr("Show all of the axes (key 0)"));
  QObject::connect(fit, &QAction::triggered, this, [this]() { this->Chart->chart()->FitAll(); });
  auto* view = new QToolButton(bar);
  view->setObjectName("ViewMenu");
  view->setText(tr("View"));
  view->setPopupMode(QToolButton::InstantPopup);
  view->setMenu(this->makeHistogramMenu());
  bar->addWidget(view);
  auto* compute = new QToolButton(bar);
  compute->setObjectName("ComputeMenu");
  compute->setText(tr("Compute"));
  compute->setToolTip(
    tr("Attributes of the primary axis, to be used as axes or tertiary attributes"));
  compute->setPopupMode(QToolButton::InstantPopup);
  compute->setMenu(new pqTFCComputeMenu(this->Document, compute));
  bar->addWidget(compute);
  QAction* advice = bar->addAction(tr("Advice"));
  advice->setObjectName("Advice");
  advice->setToolTip(tr("Axes, tertiary attributes and splits that the data suggest"));
  QObject::connect(advice, &QAction::triggered, this,
    [this]()
    {
      auto* dialog = new pqTFCAdviceDialog(this->Document, this->Advice, this);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
      dialog->show();
    });
  this->ReadyActions << advice;
  QAction* probe = bar->addAction(tr("Probe"));
  probe->setObjectName("Probe");
  probe->setCheckable(true);
  probe->setToolTip(tr("Click into the 3D view: what is visible there, which regions make it so"));
  QObject::connect(probe, &QAction::toggled, this->Probe, &pqTFCProbe::setActive);
  this->ReadyActions << probe;
  auto* file = new QToolButton(bar);
  file->setObjectName("FileMenu");
  file->setText(tr("File"));
  file->setPopupMode(QToolButton::InstantPopup);
  this->Presets = new pqTFCPresets(this->Document, file);
  file->setMenu(this->Presets);
  bar->addWidget(file);
  return bar;
}

//-----------------------------------------------------------------------------
QMenu* pqTFCPanel::makeHistogramMenu()
{
  auto* menu = new QMenu(this);
  menu->setObjectName("ViewMenu");
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
  QObject::connect(menu->addAction(tr("Fit to regions")), &QAction::triggered, this,
    [chart]() { chart->FitRegions(!chart->GetSelection().empty()); });
  QObject::connect(menu->addAction(tr("Ranges of the data")), &QAction::triggered, this,
    [this]() { this->Axes->useDataRanges(); });
  menu->addSeparator();
  QAction* keys = menu->addAction(tr("Keys and Mouse ..."));
  keys->setObjectName("Keys");
  QObject::connect(keys, &QAction::triggered, this, [this]() { pqTFCShowKeysPage(this); });
  return menu;
}

//-----------------------------------------------------------------------------
void pqTFCPanel::updateIcons()
{
  for (int tool = 0; tool < this->Tools.size(); ++tool)
  {
    this->Tools[tool]->setIcon(pqTFCToolIcon(tool, this->palette()));
  }
}

//-----------------------------------------------------------------------------
void pqTFCPanel::changeEvent(QEvent* e)
{
  this->Superclass::changeEvent(e);
  if (e->type() == QEvent::PaletteChange)
  {
    this->updateIcons();
  }
}

//-----------------------------------------------------------------------------
void pqTFCPanel::dragEnterEvent(QDragEnterEvent* e)
{
  const QList<QUrl> urls = e->mimeData()->urls();
  if (urls.size() == 1 && urls[0].toLocalFile().endsWith(".json"))
  {
    e->acceptProposedAction();
  }
}

//-----------------------------------------------------------------------------
void pqTFCPanel::dropEvent(QDropEvent* e)
{
  e->acceptProposedAction();
  this->Presets->open(e->mimeData()->urls()[0].toLocalFile());
}

//-----------------------------------------------------------------------------
QString pqTFCPanel::state() const
{
  return this->Document->state();
}

//-----------------------------------------------------------------------------
int pqTFCPanel::stateNumber()
{
  const QString now = this->state();
  if (!this->States.contains(now))
  {
    this->States << now;
  }
  return this->States.indexOf(now);
}

//-----------------------------------------------------------------------------
QString pqTFCPanel::message() const
{
  return this->Messages->text();
}

//-----------------------------------------------------------------------------
int pqTFCPanel::regions() const
{
  return this->Document->model()->GetNumberOfRegions();
}

//-----------------------------------------------------------------------------
QString pqTFCPanel::selectedShape() const
{
  vtkTFCRegion* region = this->Document->activeRegion();
  return region ? region->GetShape()->GetTypeName() : "";
}

//-----------------------------------------------------------------------------
int pqTFCPanel::voxelsInPlane()
{
  this->Document->plane();
  this->Document->fetchNow();
  vtkTFCSparseHistogram* plane = this->Document->plane();
  return plane ? static_cast<int>(plane->GetTotal()) : -1;
}

//-----------------------------------------------------------------------------
int pqTFCPanel::voxelsInRegion() const
{
  this->Document->fetchNow();
  return static_cast<int>(std::lround(this->Tertiary->total()));
}

//-----------------------------------------------------------------------------
double pqTFCPanel::millisecondsPerEvent() const
{
  return this->Document->millisecondsPerEvent();
}

//-----------------------------------------------------------------------------
QString pqTFCPanel::probe() const
{
  return this->Probe->regions();
}

//-----------------------------------------------------------------------------
void pqTFCPanel::onTargetChanged()
{
  this->Chart->chart()->FitAll();
  this->onChanged(false);
}

//-----------------------------------------------------------------------------
void pqTFCPanel::onChanged(bool live)
{
  const bool ready = this->Document->isReady();
  for (QAction* action : this->Tools)
  {
    action->setEnabled(ready && this->Document->model()->HasAxes());
  }
  if (!live)
  {
    this->updateChart();
  }
  for (QAction* action : this->ReadyActions)
  {
    action->setEnabled(ready);
  }
  this->Chart->renderLater();
}

//-----------------------------------------------------------------------------
void pqTFCPanel::onHistograms()
{
  this->updateChart();
  this->onHover();
}

//-----------------------------------------------------------------------------
void pqTFCPanel::updateChart()
{
  vtkTFCDomainChart* chart = this->Chart->chart();
  vtkTFCTransferFunction* model = this->Document->model();
  double ranges[4] = { 0, 1, 0, 1 };
  const bool ready = this->Document->isReady() && this->Document->axisRanges(ranges);
  chart->SetTransferFunction(ready ? model : nullptr);
  chart->SetAxisRanges(ranges);
  QString titles[2];
  for (int i = 0; i < 2 && ready; ++i)
  {
    titles[i] = this->Document->labelOf(model->GetAxisArray(i), model->GetAxisComponent(i));
  }
  chart->SetAxisTitles(titles[0].toStdString(), titles[1].toStdString());
  vtkTFCSparseHistogram* plane = ready ? this->Document->plane() : nullptr;
  if (plane)
  {
    std::vector<double> counts(
      static_cast<size_t>(plane->GetNumberOfBins(0)) * plane->GetNumberOfBins(1));
    plane->GetPlane(counts.data());
    double x[2];
    double y[2];
    plane->GetRange(0, x);
    plane->GetRange(1, y);
    chart->GetHistogram()->SetCounts(counts.data(), plane->GetNumberOfBins(0),
      plane->GetNumberOfBins(1), { { x[0], x[1], y[0], y[1] } });
  }
  else
  {
    chart->GetHistogram()->SetCounts(nullptr, 0, 0, { { 0, 1, 0, 1 } });
  }
  chart->SetMessage(ready && !plane
      ? (this->Document->isStale() ? "Histogram follows ..." : "No such array in the data")
      : "");
  chart->SetSelection(this->Document->selection());
  this->Chart->renderLater();
}

//-----------------------------------------------------------------------------
void pqTFCPanel::onHover()
{
  double data[2];
  double count;
  int id;
  if (!this->Chart->chart()->GetHover(data, count, id))
  {
    vtkTFCSparseHistogram* plane = this->Document->isReady() ? this->Document->plane() : nullptr;
    if (!this->Probe->text().isEmpty())
    {
      this->Status->setText(this->Probe->text());
      return;
    }
    this->Status->setText(
      plane ? tr("%L1 voxels on these axes").arg(plane->GetTotal(), 0, 'f', 0) : QString(" "));
    return;
  }
  vtkTFCRegion* region = this->Document->model()->GetRegionById(id);
  QString text = QString("%1, %2").arg(data[0], 0, 'g', 5).arg(data[1], 0, 'g', 5);
  if (count >= 0)
  {
    text += tr(": %L1 voxels").arg(count, 0, 'f', 0);
  }
  if (region)
  {
    text += QString("  (%1)").arg(QString::fromStdString(region->GetName()));
  }
  this->Status->setText(text);
}
