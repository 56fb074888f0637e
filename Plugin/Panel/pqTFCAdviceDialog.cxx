// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCAdviceDialog.h"

#include "pqDoubleRangeWidget.h"
#include "pqTFCAdvice.h"
#include "pqTFCDocument.h"
#include "pqTFCReach.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int AFTER_HISTOGRAMS = 200; // ms

QTableWidgetItem* Cell(const QString& text)
{
  return new QTableWidgetItem(text);
}

QTableWidgetItem* Cell(double value)
{
  auto* item = new QTableWidgetItem(QString::number(value, 'g', 4));
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}
}

//-----------------------------------------------------------------------------
pqTFCAdviceDialog::pqTFCAdviceDialog(pqTFCDocument* document, pqTFCAdvice* advice,
  QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Advice(advice)
{
  this->setObjectName("AdviceDialog");
  this->setWindowTitle(tr("Advice"));
  this->resize(560, 620);
  auto* layout = new QVBoxLayout(this);
  this->AxesTitle = new QLabel(this);
  this->AxesTitle->setObjectName("AxesTitle");
  layout->addWidget(this->AxesTitle);
  this->Axes =
    this->makeTable("Axes", { tr("Primary"), tr("Secondary"), tr("Kind"), tr("Score"), "" });
  layout->addWidget(this->Axes);
  layout->addWidget(new QLabel(tr("<b>Tertiary attribute</b>: score = \xE2\x88\x92"
                                  "a |correlation| + (1 \xE2\x88\x92 a) "
                                  "entropy / largest entropy"),
    this));
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(tr("&Balance a"), this);
  this->Balance = new pqDoubleRangeWidget(this);
  this->Balance->setObjectName("Balance");
  this->Balance->setAccessibleName(tr("Balance between correlation and entropy"));
  pqTFCNameParts(this->Balance);
  this->Balance->setMinimum(0);
  this->Balance->setMaximum(1);
  this->Balance->setValue(0.4);
  label->setBuddy(this->Balance);
  row->addWidget(label);
  row->addWidget(this->Balance);
  layout->addLayout(row);
  this->Scores = this->makeTable("Scores",
    { tr("Attribute"), tr("Correlation"), tr("Entropy"), tr("Score"), "" });
  layout->addWidget(this->Scores);
  this->Region = new QLabel(this);
  this->Region->setObjectName("Region");
  layout->addWidget(this->Region);
  this->Splits =
    this->makeTable("Splits", { tr("Attribute"), tr("Power"), tr("Cut at"), tr("Below"), "", "" });
  layout->addWidget(this->Splits);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  layout->addWidget(buttons);
  QObject::connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  QObject::connect(this->Balance, &pqDoubleRangeWidget::valueChanged, this,
    &pqTFCAdviceDialog::fillScores);
  // After the event that says so, once for all that it says.
  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqTFCAdviceDialog::follow);
  QObject::connect(document, &pqTFCDocument::targetChanged, this, &pqTFCAdviceDialog::followLater);
  QObject::connect(document, &pqTFCDocument::attributesChanged, this,
    &pqTFCAdviceDialog::followLater);
  QObject::connect(document, &pqTFCDocument::selectionChanged, this,
    &pqTFCAdviceDialog::followLater);
  QObject::connect(document, &pqTFCDocument::changed, this,
    [this](bool live)
    {
      if (!live)
      {
        this->followLater();
      }
    });
  QObject::connect(document, &pqTFCDocument::histogramsChanged, this,
    [this]()
    {
      if (this->Timer.isActive())
      {
        this->followLater();
      }
    });
  this->fill();
}

//-----------------------------------------------------------------------------
pqTFCAdviceDialog::~pqTFCAdviceDialog()
{
  this->Advice->releaseSplits();
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::followLater()
{
  // Histograms are seen first and come first; while an animation plays, they wait as well.
  this->Timer.start(this->Document->isFetching() ? AFTER_HISTOGRAMS : 0);
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::follow()
{
  if (this->Document->isFetching())
  {
    this->followLater();
  }
  // The end of an edit is told.
  else if (!this->Document->link()->isEditing())
  {
    this->fill();
  }
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::fill()
{
  this->fillAxes();
  this->fillScores();
  this->fillSplits();
}

//-----------------------------------------------------------------------------
QTableWidget* pqTFCAdviceDialog::makeTable(const QString& name, const QStringList& columns)
{
  auto* table = new QTableWidget(0, columns.size(), this);
  table->setObjectName(name);
  table->setAccessibleName(name);
  table->setHorizontalHeaderLabels(columns);
  for (int column = 0; column < columns.size(); ++column)
  {
    if (columns[column].isEmpty())
    {
      table->horizontalHeaderItem(column)->setData(Qt::AccessibleTextRole, tr("Button"));
    }
  }
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->verticalHeader()->hide();
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  return table;
}

//-----------------------------------------------------------------------------
QPushButton* pqTFCAdviceDialog::button(QTableWidget* table, int row, int column,
  const QString& text, const QString& name)
{
  auto* button = qobject_cast<QPushButton*>(table->cellWidget(row, column));
  if (!button)
  {
    button = new QPushButton(text, table);
    button->setObjectName(name + QString::number(row));
    table->setCellWidget(row, column, button);
  }
  return button;
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::fillAxes()
{
  const bool ready = this->Document->isReady();
  this->AxesTitle->setText(ready
      ? tr("<b>Axes</b>: pairs that belong together, best first")
      : tr("<b>Axes</b>: select data that are shown as <i>Combined Volume</i>"));
  this->Pairs = ready ? this->Advice->pairs() : std::vector<pqTFCAdvice::Pair>();
  this->Axes->setRowCount(static_cast<int>(this->Pairs.size()));
  for (int row = 0; row < this->Axes->rowCount(); ++row)
  {
    const pqTFCAdvice::Pair& pair = this->Pairs[row];
    this->Axes->setItem(row, 0, Cell(QString::fromStdString(pair.Primary)));
    this->Axes->setItem(row, 1, Cell(QString::fromStdString(pair.Secondary)));
    this->Axes->setItem(row, 2, Cell(pair.Kind));
    this->Axes->setItem(row, 3, Cell(pair.Score));
    const bool isNew = !this->Axes->cellWidget(row, 4);
    QPushButton* use = this->button(this->Axes, row, 4, tr("Use"), "Use");
    // Names of components have no place in a state's axis.
    use->setEnabled(this->Document->findAttribute(pair.Primary, 0) &&
      this->Document->findAttribute(pair.Secondary, 0));
    if (isNew)
    {
      use->setToolTip(tr("As primary and secondary attribute"));
      QObject::connect(use, &QPushButton::clicked, this, [this, row]() { this->useAxes(row); });
    }
  }
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::useAxes(int row)
{
  const std::string names[2] = { this->Pairs[row].Primary, this->Pairs[row].Secondary };
  vtkTFCTransferFunction* model = this->Document->model();
  this->Document->edit(tr("Change axes"),
    [&]()
    {
      for (int i = 0; i < 2; ++i)
      {
        if (model->GetAxisArray(i) != names[i])
        {
          model->SetAxis(i, names[i].c_str(), 0);
          model->ClearAxisRange(i);
        }
      }
    });
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::fillScores()
{
  this->Candidates =
    this->Document->isReady() ? this->Advice->candidates() : std::vector<pqTFCAdvice::Candidate>();
  const double a = this->Balance->value();
  std::stable_sort(this->Candidates.begin(), this->Candidates.end(),
    [a](const auto& x, const auto& y) { return x.Score(a) > y.Score(a); });
  this->Scores->setRowCount(static_cast<int>(this->Candidates.size()));
  for (int row = 0; row < this->Scores->rowCount(); ++row)
  {
    const pqTFCAdvice::Candidate& candidate = this->Candidates[row];
    this->Scores->setItem(row, 0, Cell(candidate.Label));
    this->Scores->setItem(row, 1, Cell(candidate.Correlation));
    this->Scores->setItem(row, 2, Cell(candidate.Entropy));
    this->Scores->setItem(row, 3, Cell(candidate.Score(a)));
    if (!this->Scores->cellWidget(row, 4))
    {
      QPushButton* use = this->button(this->Scores, row, 4, tr("Use"), "Tertiary");
      use->setToolTip(tr("As the tertiary attribute of the selected region"));
      QObject::connect(use, &QPushButton::clicked, this, [this, row]() { this->useTertiary(row); });
    }
  }
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::useTertiary(int row)
{
  const pqTFCAdvice::Candidate& candidate = this->Candidates[row];
  vtkTFCRegion* region = this->Document->activeRegion();
  if (!region || region->GetLocked())
  {
    this->Document->say(region ? tr("The selected region is locked.")
                               : tr("Select the region that shall have this attribute first."));
    return;
  }
  // The list may have changed since the table was filled.
  const pqTFCAttribute* attribute =
    this->Document->findAttribute(candidate.Array, candidate.Component);
  if (attribute)
  {
    this->Document->setTertiary(region,
      static_cast<int>(attribute - this->Document->attributes().data()));
  }
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::fillSplits()
{
  vtkTFCRegion* region = this->Document->isReady() ? this->Document->activeRegion() : nullptr;
  this->Splits->setVisible(region != nullptr);
  this->Shown.clear();
  if (region)
  {
    this->Shown = this->Advice->splits(region->GetId());
    const QString name = QString::fromStdString(region->GetName()).toHtmlEscaped();
    this->Region->setText(region->GetVisible()
        ? tr("<b>Splits of %1</b>: 1 is two separate parts, 0 a single one").arg(name)
        : tr("<b>Splits of %1</b>: the region is hidden, show it to see them").arg(name));
  }
  else
  {
    this->Region->setText(tr("<b>Splits</b>: select one region to see which attribute splits it"));
  }
  this->Splits->setRowCount(static_cast<int>(this->Shown.size()));
  for (int row = 0; row < this->Splits->rowCount(); ++row)
  {
    const pqTFCAdvice::Split& split = this->Shown[row];
    this->Splits->setItem(row, 0, Cell(split.Attribute));
    this->Splits->setItem(row, 1, Cell(split.Power));
    this->Splits->setItem(row, 2, Cell(split.Cut));
    this->Splits->setItem(row, 3, Cell(QString("%1 %").arg(100 * split.Below, 0, 'f', 0)));
    this->Splits->item(row, 3)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (const bool above : { false, true })
    {
      const int column = above ? 5 : 4;
      const bool isNew = !this->Splits->cellWidget(row, column);
      QPushButton* button = this->button(this->Splits, row, column,
        above ? tr("Keep above") : tr("Keep below"), above ? "KeepAbove" : "KeepBelow");
      button->setEnabled(
        !(above ? split.KeepAbove : split.KeepBelow).isEmpty() && !region->GetLocked());
      if (isNew)
      {
        button->setToolTip(
          above ? tr("Show what is above the cut alone") : tr("Show what is below the cut alone"));
        QObject::connect(button, &QPushButton::clicked, this,
          [this, row, above]() { this->keep(row, above); });
      }
    }
  }
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::keep(int row, bool above)
{
  const pqTFCAdvice::Split& split = this->Shown[row];
  this->Advice->apply(split.Region, above ? split.KeepAbove : split.KeepBelow);
}
