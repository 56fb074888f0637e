// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCAdviceDialog.h"

#include "pqDoubleRangeWidget.h"
#include "pqTFCAdvice.h"
#include "pqTFCDocument.h"
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
  layout->addWidget(new QLabel(tr("<b>Axes</b>: pairs that belong together, best first"), this));
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
  layout->addWidget(this->Region);
  this->Splits =
    this->makeTable("Splits", { tr("Attribute"), tr("Power"), tr("Cut at"), tr("Below"), "", "" });
  layout->addWidget(this->Splits);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  layout->addWidget(buttons);
  QObject::connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  QObject::connect(this->Balance, &pqDoubleRangeWidget::valueChanged, this,
    &pqTFCAdviceDialog::fillScores);
  this->fillAxes();
  this->fillScores();
  this->fillSplits();
}

//-----------------------------------------------------------------------------
pqTFCAdviceDialog::~pqTFCAdviceDialog() = default;

//-----------------------------------------------------------------------------
QTableWidget* pqTFCAdviceDialog::makeTable(const QString& name, const QStringList& columns)
{
  auto* table = new QTableWidget(0, columns.size(), this);
  table->setObjectName(name);
  table->setAccessibleName(name);
  table->setHorizontalHeaderLabels(columns);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->verticalHeader()->hide();
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  return table;
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::fillAxes()
{
  const auto pairs = this->Advice->pairs();
  this->Axes->setRowCount(static_cast<int>(pairs.size()));
  for (int row = 0; row < static_cast<int>(pairs.size()); ++row)
  {
    const pqTFCAdvice::Pair& pair = pairs[row];
    this->Axes->setItem(row, 0, Cell(QString::fromStdString(pair.Primary)));
    this->Axes->setItem(row, 1, Cell(QString::fromStdString(pair.Secondary)));
    this->Axes->setItem(row, 2, Cell(pair.Kind));
    this->Axes->setItem(row, 3, Cell(pair.Score));
    auto* use = new QPushButton(tr("Use"), this->Axes);
    use->setObjectName(QString("Use%1").arg(row));
    // Names of components have no place in a state's axis.
    use->setEnabled(this->Document->findAttribute(pair.Primary, 0) &&
      this->Document->findAttribute(pair.Secondary, 0));
    this->Axes->setCellWidget(row, 4, use);
    QObject::connect(use, &QPushButton::clicked, this,
      [this, pair]()
      {
        vtkTFCTransferFunction* model = this->Document->model();
        this->Document->edit(tr("Change axes"),
          [&]()
          {
            const std::string names[2] = { pair.Primary, pair.Secondary };
            for (int i = 0; i < 2; ++i)
            {
              if (model->GetAxisArray(i) != names[i])
              {
                model->SetAxis(i, names[i].c_str(), 0);
                model->ClearAxisRange(i);
              }
            }
          });
        this->fillScores();
        this->fillSplits();
      });
  }
}

//-----------------------------------------------------------------------------
void pqTFCAdviceDialog::fillScores()
{
  std::vector<pqTFCAdvice::Candidate>& candidates = this->Candidates;
  candidates = this->Advice->candidates();
  const double a = this->Balance->value();
  std::stable_sort(candidates.begin(), candidates.end(),
    [a](const auto& x, const auto& y) { return x.Score(a) > y.Score(a); });
  this->Scores->setRowCount(static_cast<int>(candidates.size()));
  for (int row = 0; row < static_cast<int>(candidates.size()); ++row)
  {
    this->Scores->setItem(row, 0, Cell(candidates[row].Label));
    this->Scores->setItem(row, 1, Cell(candidates[row].Correlation));
    this->Scores->setItem(row, 2, Cell(candidates[row].Entropy));
    this->Scores->setItem(row, 3, Cell(candidates[row].Score(a)));
    // One button per row for good: the slider may be under way in the middle of this.
    if (!this->Scores->cellWidget(row, 4))
    {
      auto* use = new QPushButton(tr("Use"), this->Scores);
      use->setObjectName(QString("Tertiary%1").arg(row));
      use->setToolTip(tr("As the tertiary attribute of the selected region"));
      this->Scores->setCellWidget(row, 4, use);
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
  vtkTFCRegion* region = this->Document->activeRegion();
  this->Splits->setVisible(region != nullptr);
  if (!region)
  {
    this->Region->setText(tr("<b>Splits</b>: select one region to see which attribute splits it"));
    return;
  }
  const int id = region->GetId();
  this->Region->setText(tr("<b>Splits of %1</b>: 1 is two separate parts, 0 a single one")
                          .arg(QString::fromStdString(region->GetName()).toHtmlEscaped()));
  const auto splits = this->Advice->splits(id);
  this->Splits->setRowCount(static_cast<int>(splits.size()));
  for (int row = 0; row < static_cast<int>(splits.size()); ++row)
  {
    const pqTFCAdvice::Split& split = splits[row];
    this->Splits->setItem(row, 0, Cell(split.Attribute));
    this->Splits->setItem(row, 1, Cell(split.Power));
    this->Splits->setItem(row, 2, Cell(split.Cut));
    this->Splits->setItem(row, 3, Cell(QString("%1 %").arg(100 * split.Below, 0, 'f', 0)));
    const QString names[2] = { tr("Keep below"), tr("Keep above") };
    const QString states[2] = { split.KeepBelow, split.KeepAbove };
    for (int i = 0; i < 2; ++i)
    {
      auto* keep = new QPushButton(names[i], this->Splits);
      keep->setObjectName(QString(i == 0 ? "KeepBelow%1" : "KeepAbove%1").arg(row));
      keep->setEnabled(!states[i].isEmpty() && !region->GetLocked());
      this->Splits->setCellWidget(row, 4 + i, keep);
      QObject::connect(keep, &QPushButton::clicked, this,
        [this, id, state = states[i]]() { this->Advice->apply(id, state); });
    }
  }
}
