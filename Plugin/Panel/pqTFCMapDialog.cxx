// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCMapDialog.h"

#include "pqTFCDocument.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTFCOutline.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTFCTransferFunction.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>

#include <algorithm>

namespace
{
void MapNodes(vtkDoubleArray* nodes, const double from[2], const double to[2])
{
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
  {
    const double v = nodes->GetComponent(i, 0);
    nodes->SetComponent(i, 0, to[0] + (v - from[0]) / (from[1] - from[0]) * (to[1] - to[0]));
  }
}
}

//-----------------------------------------------------------------------------
pqTFCMapDialog::pqTFCMapDialog(pqTFCDocument* document, vtkTFCTransferFunction* model,
  QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Model(model)
{
  this->setObjectName("MapAttributes");
  this->setWindowTitle(tr("Transfer Function of Other Data"));
  for (int axis = 0; axis < 2; ++axis)
  {
    this->collect(model->GetAxisArray(axis), model->GetAxisComponent(axis));
  }
  for (int i = 0; i < model->GetNumberOfRegions(); ++i)
  {
    vtkTFCRegion* region = model->GetRegion(i);
    this->collect(region->GetTertiaryArray(), region->GetTertiaryComponent());
  }
  auto* layout = new QFormLayout(this);
  auto* label = new QLabel(tr("The data have no such arrays. Which ones stand for them?"), this);
  layout->addRow(label);
  for (const Name& name : this->Missing)
  {
    auto* choice = new QComboBox(this);
    choice->setObjectName(QString("Choice%1").arg(this->Choices.size()));
    choice->addItem(tr("Keep (the region or the axis stays empty)"));
    for (const pqTFCAttribute& attribute : document->attributes())
    {
      choice->addItem(attribute.Label);
    }
    this->Choices.push_back(choice);
    QString text = QString::fromStdString(name.first);
    if (name.second != 0)
    {
      text += name.second < 0 ? tr(" Magnitude") : QString(" %1").arg(name.second);
    }
    choice->setAccessibleName(tr("Array that stands for %1").arg(text));
    layout->addRow(text, choice);
  }
  this->Rescale = new QCheckBox(tr("&Rescale to the ranges of the data"), this);
  this->Rescale->setObjectName("Rescale");
  this->Rescale->setChecked(true);
  layout->addRow(this->Rescale);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->setObjectName("Buttons");
  layout->addRow(buttons);
  QObject::connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

//-----------------------------------------------------------------------------
pqTFCMapDialog::~pqTFCMapDialog() = default;

//-----------------------------------------------------------------------------
void pqTFCMapDialog::collect(const std::string& array, int component)
{
  const Name name(array, component);
  if (!array.empty() && !this->Document->findAttribute(array, component) &&
    std::find(this->Missing.begin(), this->Missing.end(), name) == this->Missing.end())
  {
    this->Missing.push_back(name);
  }
}

//-----------------------------------------------------------------------------
int pqTFCMapDialog::choice(const std::string& array, int component) const
{
  const auto found = std::find(this->Missing.begin(), this->Missing.end(), Name(array, component));
  return found == this->Missing.end()
    ? -1
    : this->Choices[found - this->Missing.begin()]->currentIndex() - 1;
}

//-----------------------------------------------------------------------------
void pqTFCMapDialog::mapAxes()
{
  vtkTFCOutline::Ranges from = { { 0, 1, 0, 1 } };
  vtkTFCOutline::Ranges to = { { 0, 1, 0, 1 } };
  for (int axis = 0; axis < 2; ++axis)
  {
    const int index =
      this->choice(this->Model->GetAxisArray(axis), this->Model->GetAxisComponent(axis));
    double range[2];
    if (index < 0)
    {
      continue;
    }
    const pqTFCAttribute& attribute = this->Document->attributes()[index];
    this->Model->SetAxis(axis, attribute.Array.c_str(), attribute.Component);
    if (this->Rescale->isChecked() && this->Model->GetAxisRange(axis, range) &&
      attribute.Range[0] < attribute.Range[1])
    {
      std::copy(range, range + 2, from.begin() + 2 * axis);
      std::copy(attribute.Range, attribute.Range + 2, to.begin() + 2 * axis);
      this->Model->SetAxisRange(axis, attribute.Range[0], attribute.Range[1]);
    }
  }
  for (int i = 0; i < this->Model->GetNumberOfRegions() && from != to; ++i)
  {
    vtkTFCShape* shape = this->Model->GetRegion(i)->GetShape();
    vtkTFCOutline::FromShape(shape, from).Store(shape, to);
  }
}

//-----------------------------------------------------------------------------
void pqTFCMapDialog::mapTertiaries()
{
  for (int i = 0; i < this->Model->GetNumberOfRegions(); ++i)
  {
    vtkTFCRegion* region = this->Model->GetRegion(i);
    const int index = this->choice(region->GetTertiaryArray(), region->GetTertiaryComponent());
    if (!region->HasTertiary() || index < 0)
    {
      continue;
    }
    const pqTFCAttribute& attribute = this->Document->attributes()[index];
    vtkNew<vtkDoubleArray> nodes;
    vtkNew<vtkDoubleArray> colors;
    region->GetTertiaryOpacityNodes(nodes);
    region->GetTertiaryColorNodes(colors);
    double from[2];
    if (!region->GetTertiaryRange(from))
    {
      from[0] = nodes->GetComponent(0, 0);
      from[1] = nodes->GetComponent(nodes->GetNumberOfTuples() - 1, 0);
    }
    if (this->Rescale->isChecked() && from[0] < from[1] && attribute.Range[0] < attribute.Range[1])
    {
      MapNodes(nodes, from, attribute.Range);
      MapNodes(colors, from, attribute.Range);
      region->ClearTertiaryRange();
    }
    region->SetTertiary(attribute.Array.c_str(), attribute.Component, nodes,
      colors->GetNumberOfTuples() > 0 ? colors.Get() : nullptr);
  }
}

//-----------------------------------------------------------------------------
void pqTFCMapDialog::apply()
{
  this->mapAxes();
  this->mapTertiaries();
}
