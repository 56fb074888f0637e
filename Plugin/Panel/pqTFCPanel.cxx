// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCPanel.h"

#include "pqTFCAdvice.h"
#include "pqTFCAxisBar.h"
#include "pqTFCChartWidget.h"
#include "pqTFCDocument.h"
#include "pqTFCHighlight.h"
#include "pqTFCMessageBar.h"
#include "pqTFCPresets.h"
#include "pqTFCProbe.h"
#include "pqTFCProbeMark.h"
#include "pqTFCProposal.h"
#include "pqTFCReach.h"
#include "pqTFCRegionForm.h"
#include "pqTFCRegionList.h"
#include "pqTFCTertiaryEditor.h"
#include "pqTFCToolBar.h"
#include "vtkTFCDomainChart.h"
#include "vtkTFCHistogramItem.h"
#include "vtkTFCPolygonShape.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QSplitter>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <cmath>

namespace
{
constexpr int LONGEST_WAIT = 10000; // ms
}

//-----------------------------------------------------------------------------
pqTFCPanel::pqTFCPanel(QWidget* parentObject)
  : Superclass(tr("Combined Transfer Functions"), parentObject)
  , Document(new pqTFCDocument(this))
  , Advice(new pqTFCAdvice(this->Document, this))
  , Probe(new pqTFCProbe(this->Document, this->Advice, this))
  , Highlight(new pqTFCHighlight(this->Document, this))
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
  this->AtProbe = new QToolButton(contents);
  this->AtProbe->setObjectName("RegionAtProbe");
  this->AtProbe->setText(tr("Region Here"));
  this->AtProbe->setToolTip(
    tr("A new region around the cross: the values of the place that was clicked at in the view"));
  this->AtProbe->setAutoRaise(true);
  this->AtProbe->hide();
  auto* list = new pqTFCRegionList(this->Document, this->Advice, contents);
  auto* form = new pqTFCRegionForm(this->Document, contents);
  this->Tertiary = new pqTFCTertiaryEditor(this->Document, this->Advice, contents);

  this->Mark = new pqTFCProbeMark(this->Document, this->Probe, this->Tertiary->opacityWidget());
  auto* tools = new pqTFCToolBar(this->Document, this->Chart, contents);
  tools->addHighlight(this->Highlight);
  tools->addComputeMenu();
  tools->addAdvice(this->Advice);
  tools->addProbe(this->Probe);
  this->Presets = tools->addFileMenu();
  pqTFCLetTabReach(tools);

  // Above the chart and what belongs to it, below the regions; the user decides on the parts.
  auto* top = new QWidget(contents);
  top->setObjectName("ChartPart");
  auto* topLayout = new QVBoxLayout(top);
  topLayout->setContentsMargins(0, 0, 0, 0);
  topLayout->setSpacing(2);
  topLayout->addWidget(tools);
  topLayout->addWidget(this->Chart, 1);
  auto* status = new QHBoxLayout();
  status->addWidget(this->Status, 1);
  status->addWidget(this->AtProbe);
  topLayout->addLayout(status);
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
  QObject::connect(tools, &pqTFCToolBar::useDataRanges, this->Axes, &pqTFCAxisBar::useDataRanges);
  QObject::connect(this->Chart, &pqTFCChartWidget::hovered, this, &pqTFCPanel::highlightHovered);
  QObject::connect(list, &pqTFCRegionList::hovered, this->Highlight, &pqTFCHighlight::hover);
  QObject::connect(this, &QDockWidget::visibilityChanged, this->Highlight, &pqTFCHighlight::clear);
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
      this->AtProbe->show();
      this->Chart->renderLater();
    });
  QObject::connect(this->Probe, &pqTFCProbe::lost, this,
    [this, chart]()
    {
      chart->ClearProbe();
      this->AtProbe->hide();
      this->Chart->renderLater();
    });
  QObject::connect(this->AtProbe, &QToolButton::clicked, this->Chart,
    [chart]() { chart->AddRegion(); });
  QObject::connect(this->Probe, &pqTFCProbe::told, this, &pqTFCPanel::onHover);
  new pqTFCProposal(this->Document, this->Advice, this);
  this->onTargetChanged();
}

//-----------------------------------------------------------------------------
pqTFCPanel::~pqTFCPanel() = default;

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
int pqTFCPanel::selectedCorners() const
{
  vtkTFCRegion* region = this->Document->activeRegion();
  auto* polygon = region ? vtkTFCPolygonShape::SafeDownCast(region->GetShape()) : nullptr;
  return polygon ? polygon->GetNumberOfPoints() : 0;
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
bool pqTFCPanel::isFresh() const
{
  const QDeadlineTimer deadline(LONGEST_WAIT);
  while (this->Document->isFetching() && !deadline.hasExpired())
  {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, LONGEST_WAIT);
  }
  return !this->Document->isFetching();
}

//-----------------------------------------------------------------------------
QString pqTFCPanel::probedTertiary() const
{
  return std::isnan(this->Mark->value()) ? QString()
                                         : QString("%1 at %2")
                                             .arg(this->Mark->value(), 0, 'f', 2)
                                             .arg(this->Mark->position(), 0, 'f', 1);
}

//-----------------------------------------------------------------------------
int pqTFCPanel::highlighted() const
{
  return this->Highlight->region();
}

//-----------------------------------------------------------------------------
QString pqTFCPanel::outOfReach() const
{
  return pqTFCOutOfReach(this->widget()).join("; ");
}

//-----------------------------------------------------------------------------
void pqTFCPanel::highlightHovered()
{
  // Not while drawing over what is there.
  double data[2];
  double count;
  int region = 0;
  const bool selecting = this->Chart->chart()->GetTool() == vtkTFCDomainChart::Select;
  const bool inside = this->Chart->chart()->GetHover(data, count, region);
  this->Highlight->hover(selecting && inside ? region : 0);
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
  if (!live)
  {
    this->updateChart();
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
  const bool isWanted = ready && this->Document->isStale(nullptr);
  QString note;
  if (isWanted)
  {
    note = plane ? tr("Out of date: the histogram follows ...") : tr("The histogram follows ...");
  }
  else if (ready && !plane)
  {
    note = tr("No histogram of these arrays");
  }
  this->StaleNotes += isWanted && plane && !this->StaleShown ? 1 : 0;
  this->StaleShown = isWanted && plane;
  chart->SetMessage(note.toStdString());
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
