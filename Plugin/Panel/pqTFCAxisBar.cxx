// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCAxisBar.h"

#include "pqTFCDocument.h"
#include "pqTFCField.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTFCEllipseShape.h"
#include "vtkTFCPolygonShape.h"
#include "vtkTFCRectangleShape.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTFCTriangleShape.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include <cmath>

namespace
{
// The mirror image at the diagonal. In axis units an angle becomes its complement, which is the
// same as exchanging the half sizes and changing the angle's sign.
void MirrorShape(vtkTFCShape* shape)
{
  double center[2];
  double half[2];
  double p[3][2];
  if (auto* ellipse = vtkTFCEllipseShape::SafeDownCast(shape))
  {
    ellipse->GetCenter(center);
    ellipse->GetRadii(half);
    ellipse->SetCenter(center[1], center[0]);
    ellipse->SetRadii(half[1], half[0]);
    ellipse->SetAngle(-ellipse->GetAngle());
  }
  else if (auto* rectangle = vtkTFCRectangleShape::SafeDownCast(shape))
  {
    rectangle->GetCenter(center);
    rectangle->GetHalfSize(half);
    rectangle->SetCenter(center[1], center[0]);
    rectangle->SetHalfSize(half[1], half[0]);
    rectangle->SetAngle(-rectangle->GetAngle());
  }
  else if (auto* triangle = vtkTFCTriangleShape::SafeDownCast(shape))
  {
    for (int i = 0; i < 3; ++i)
    {
      triangle->GetPoint(i, p[i]);
    }
    triangle->SetPoints(p[0][1], p[0][0], p[1][1], p[1][0], p[2][1], p[2][0]);
  }
  else if (auto* polygon = vtkTFCPolygonShape::SafeDownCast(shape))
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i < polygon->GetNumberOfPoints(); ++i)
    {
      polygon->GetPoint(i, p[0]);
      points->InsertNextPoint(p[0][1], p[0][0], 0);
    }
    polygon->SetPoints(points);
  }
}
}

//-----------------------------------------------------------------------------
pqTFCAxisBar::pqTFCAxisBar(pqTFCDocument* document, QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  this->setObjectName("AxisBar");
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(4);
  layout->setVerticalSpacing(2);
  const QString names[2] = { tr("Primary"), tr("Secondary") };
  for (int i = 0; i < 2; ++i)
  {
    auto* label = new QLabel(i == 0 ? tr("&X") : tr("&Y"), this);
    label->setToolTip(tr("%1 attribute").arg(names[i]));
    this->Attributes[i] = new QComboBox(this);
    this->Attributes[i]->setObjectName(names[i]);
    this->Attributes[i]->setAccessibleName(tr("%1 attribute").arg(names[i]));
    this->Attributes[i]->setToolTip(label->toolTip());
    this->Attributes[i]->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    this->Attributes[i]->setMinimumContentsLength(8);
    label->setBuddy(this->Attributes[i]);
    layout->addWidget(label, i, 0);
    layout->addWidget(this->Attributes[i], i, 1);
    for (int end = 0; end < 2; ++end)
    {
      auto* edit = new pqTFCField(this);
      edit->setObjectName(names[i] + (end == 0 ? "Minimum" : "Maximum"));
      edit->setAccessibleName(
        (end == 0 ? tr("Minimum of the %1 axis") : tr("Maximum of the %1 axis"))
          .arg(names[i].toLower()));
      edit->setToolTip(tr("%1. Empty: the range of the data.").arg(edit->accessibleName()));
      edit->setMinimumWidth(50);
      this->Ends[i][end] = edit;
      layout->addWidget(edit, i, 2 + end);
      QObject::connect(edit, &pqTFCField::editingFinished, this, [this, i]() { this->onRange(i); });
    }
    QObject::connect(this->Attributes[i], QOverload<int>::of(&QComboBox::activated), this,
      [this, i](int index) { this->onAttribute(i, index); });
    // Playback and screen readers change the index without "activating" it.
    QObject::connect(this->Attributes[i], QOverload<int>::of(&QComboBox::currentIndexChanged), this,
      [this, i](int index) { this->onAttribute(i, index); });
  }
  this->Swap = new QToolButton(this);
  this->Swap->setObjectName("Swap");
  this->Swap->setText(QString(QChar(0x21C5)));
  this->Swap->setAccessibleName(tr("Swap the axes"));
  this->Swap->setToolTip(tr("Swap the axes; the regions go with them"));
  this->Swap->setAutoRaise(true);
  layout->addWidget(this->Swap, 0, 4, 2, 1);
  layout->setColumnStretch(1, 3);
  layout->setColumnStretch(2, 1);
  layout->setColumnStretch(3, 1);
  QObject::connect(this->Swap, &QToolButton::clicked, this, &pqTFCAxisBar::swap);
  QObject::connect(document, &pqTFCDocument::attributesChanged, this,
    &pqTFCAxisBar::fillAttributes);
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCAxisBar::refresh);
  this->fillAttributes();
}

//-----------------------------------------------------------------------------
pqTFCAxisBar::~pqTFCAxisBar() = default;

//-----------------------------------------------------------------------------
void pqTFCAxisBar::fillAttributes()
{
  for (QComboBox* combo : this->Attributes)
  {
    const QSignalBlocker blocker(combo);
    combo->clear();
    for (const pqTFCAttribute& attribute : this->Document->attributes())
    {
      combo->addItem(attribute.Label);
    }
  }
  this->refresh();
}

//-----------------------------------------------------------------------------
void pqTFCAxisBar::refresh()
{
  vtkTFCTransferFunction* model = this->Document->model();
  this->setEnabled(this->Document->isReady());
  double used[4];
  const bool hasRanges = this->Document->axisRanges(used);
  for (int i = 0; i < 2; ++i)
  {
    const QSignalBlocker blocker(this->Attributes[i]);
    const int known = static_cast<int>(this->Document->attributes().size());
    const QString label = model->GetAxisArray(i).empty()
      ? QString()
      : this->Document->labelOf(model->GetAxisArray(i), model->GetAxisComponent(i));
    // An array that the data do not have stays visible, as what is wanted.
    while (this->Attributes[i]->count() > known)
    {
      this->Attributes[i]->removeItem(known);
    }
    int index = label.isEmpty() ? -1 : this->Attributes[i]->findText(label);
    if (!label.isEmpty() && index < 0)
    {
      this->Attributes[i]->addItem(label);
      index = known;
    }
    this->Attributes[i]->setCurrentIndex(index);
    for (int end = 0; end < 2; ++end)
    {
      pqTFCField* edit = this->Ends[i][end];
      const QString text = hasRanges ? QString::number(used[2 * i + end], 'g', 6) : QString();
      edit->show(model->HasAxisRange(i) ? text : QString(), false);
      edit->setPlaceholderText(text);
    }
  }
}

//-----------------------------------------------------------------------------
void pqTFCAxisBar::onAttribute(int axis, int index)
{
  const auto& attributes = this->Document->attributes();
  vtkTFCTransferFunction* model = this->Document->model();
  if (index < 0 || index >= static_cast<int>(attributes.size()))
  {
    return;
  }
  const pqTFCAttribute& attribute = attributes[index];
  this->Document->edit(tr("Change axis"),
    [&]()
    {
      if (model->GetAxisArray(axis) != attribute.Array ||
        model->GetAxisComponent(axis) != attribute.Component)
      {
        model->SetAxis(axis, attribute.Array.c_str(), attribute.Component);
        model->ClearAxisRange(axis);
      }
      // A second attribute is needed before anything can be drawn.
      if (model->GetAxisArray(1 - axis).empty())
      {
        model->SetAxis(1 - axis, attribute.Array.c_str(), attribute.Component);
      }
    });
}

//-----------------------------------------------------------------------------
void pqTFCAxisBar::onRange(int axis)
{
  vtkTFCTransferFunction* model = this->Document->model();
  double used[4];
  pqTFCField* const* ends = this->Ends[axis];
  if ((!ends[0]->typed() && !ends[1]->typed()) || !this->Document->axisRanges(used))
  {
    return;
  }
  double range[2] = { used[2 * axis], used[2 * axis + 1] };
  bool valid = true;
  bool automatic = true;
  for (int end = 0; end < 2; ++end)
  {
    const QString text = ends[end]->text().trimmed();
    bool isNumber = true;
    if (!text.isEmpty())
    {
      automatic = false;
      // What was not typed keeps all its digits.
      const double value = text.toDouble(&isNumber);
      range[end] = ends[end]->typed() ? value : range[end];
    }
    valid = valid && isNumber;
  }
  if (!valid || !(automatic || (std::isfinite(range[1] - range[0]) && range[0] < range[1])))
  {
    this->Document->say(tr("A range is two numbers, the smaller one first."));
    for (int end = 0; end < 2; ++end)
    {
      ends[end]->show(model->HasAxisRange(axis) ? QString::number(used[2 * axis + end], 'g', 6)
                                                : QString(),
        true);
    }
    return;
  }
  ends[0]->accept();
  ends[1]->accept();
  this->Document->edit(tr("Change range"),
    [&]()
    { automatic ? model->ClearAxisRange(axis) : model->SetAxisRange(axis, range[0], range[1]); });
}

//-----------------------------------------------------------------------------
void pqTFCAxisBar::useDataRanges()
{
  vtkTFCTransferFunction* model = this->Document->model();
  this->Document->edit(tr("Use the ranges of the data"),
    [&]()
    {
      model->ClearAxisRange(0);
      model->ClearAxisRange(1);
    });
}

//-----------------------------------------------------------------------------
void pqTFCAxisBar::swap()
{
  vtkTFCTransferFunction* model = this->Document->model();
  this->Document->edit(tr("Swap axes"),
    [&]()
    {
      double ranges[2][2];
      const bool fixed[2] = { model->GetAxisRange(0, ranges[0]),
        model->GetAxisRange(1, ranges[1]) };
      const std::string arrays[2] = { model->GetAxisArray(0), model->GetAxisArray(1) };
      const int components[2] = { model->GetAxisComponent(0), model->GetAxisComponent(1) };
      for (int i = 0; i < 2; ++i)
      {
        const int from = 1 - i;
        model->SetAxis(i, arrays[from].c_str(), components[from]);
        model->ClearAxisRange(i);
        if (fixed[from])
        {
          model->SetAxisRange(i, ranges[from][0], ranges[from][1]);
        }
      }
      for (int i = 0; i < model->GetNumberOfRegions(); ++i)
      {
        MirrorShape(model->GetRegion(i)->GetShape());
      }
    });
}
