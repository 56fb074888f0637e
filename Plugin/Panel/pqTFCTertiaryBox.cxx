// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCTertiaryBox.h"

#include "pqTFCAdvice.h"
#include "pqTFCDocument.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include <QPainter>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>

namespace
{
constexpr double BALANCE = 0.4;

// The score at the right of the name: the text of the item stays the name alone, which the closed
// box shows and a screen reader reads.
class ScoreDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
    const QModelIndex& index) const override
  {
    this->QStyledItemDelegate::paint(painter, option, index);
    const QString score = index.data(pqTFCTertiaryBox::ScoreRole).toString();
    if (!score.isEmpty())
    {
      const bool selected = option.state & QStyle::State_Selected;
      painter->save();
      painter->setPen(option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
      painter->drawText(option.rect.adjusted(0, 0, -6, 0), Qt::AlignRight | Qt::AlignVCenter,
        score);
      painter->restore();
    }
  }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    const QSize size = this->QStyledItemDelegate::sizeHint(option, index);
    return QSize(size.width() + option.fontMetrics.horizontalAdvance("   -0.000"), size.height());
  }
};
}

//-----------------------------------------------------------------------------
pqTFCTertiaryBox::pqTFCTertiaryBox(pqTFCDocument* document, pqTFCAdvice* advice,
  QWidget* parentObject, int region)
  : Superclass(parentObject)
  , Document(document)
  , Advice(advice)
  , Region(region)
{
  this->setObjectName("Attribute");
  this->setAccessibleName(tr("Tertiary attribute of the region"));
  this->setToolTip(
    tr("The attribute that decides within the region, best first by the score at the right. None: "
       "all voxels of the region show."));
  this->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->setItemDelegate(new ScoreDelegate(this));
  QObject::connect(this, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    [this](int index)
    {
      const int attribute = this->itemData(index, AttributeRole).toInt();
      if (!this->Refreshing && index >= 0 && attribute != MISSING)
      {
        Q_EMIT this->chosen(attribute);
      }
    });
  QObject::connect(document, &pqTFCDocument::attributesChanged, this, &pqTFCTertiaryBox::refresh);
  QObject::connect(document, &pqTFCDocument::selectionChanged, this, &pqTFCTertiaryBox::refresh);
  QObject::connect(document, &pqTFCDocument::changed, this,
    [this](bool live)
    {
      if (!live)
      {
        this->refresh();
      }
    });
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCTertiaryBox::~pqTFCTertiaryBox() = default;

//-----------------------------------------------------------------------------
void pqTFCTertiaryBox::showPopup()
{
  this->Advice->candidates();
  this->refresh();
  this->Superclass::showPopup();
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryBox::refresh()
{
  const QScopedValueRollback<bool> refreshing(this->Refreshing, true);
  const auto& attributes = this->Document->attributes();
  const auto& candidates = this->Advice->knownCandidates();
  this->clear();
  this->addItem(tr("None"), -1);
  std::vector<char> listed(attributes.size(), 0);
  for (const pqTFCAdvice::Candidate& candidate : candidates)
  {
    for (size_t i = 0; i < attributes.size(); ++i)
    {
      if (attributes[i].Array == candidate.Array && attributes[i].Component == candidate.Component)
      {
        this->addItem(attributes[i].Label, static_cast<int>(i));
        this->setItemData(this->count() - 1, QString::number(candidate.Score(BALANCE), 'f', 3),
          ScoreRole);
        listed[i] = 1;
      }
    }
  }
  for (size_t i = 0; i < attributes.size(); ++i)
  {
    if (!listed[i])
    {
      this->addItem(attributes[i].Label, static_cast<int>(i));
    }
  }
  vtkTFCRegion* region = this->Region ? this->Document->model()->GetRegionById(this->Region)
                                      : this->Document->activeRegion();
  int current = 0;
  if (region && region->HasTertiary())
  {
    const QString label =
      this->Document->labelOf(region->GetTertiaryArray(), region->GetTertiaryComponent());
    current = this->findText(label);
    if (current < 0)
    {
      // What the data do not have stays visible, as what is wanted.
      this->addItem(label, MISSING);
      current = this->count() - 1;
    }
  }
  this->setCurrentIndex(current);
}
