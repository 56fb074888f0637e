// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCMapDialog.h"

#include "pqTFCDocument.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRescale.h"
#include "vtkTFCTransferFunction.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QRadioButton>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double SAME = 0.01; // of the extent: a time step more or less is no reason to ask
}

//-----------------------------------------------------------------------------
pqTFCMapDialog::pqTFCMapDialog(pqTFCDocument* document, vtkTFCTransferFunction* model,
  QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Model(model)
  , Entries(vtkTFCQuantiles::Load(model))
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
  const auto isMissing = [document](const Name& name)
  { return !document->findAttribute(name.Array, name.Component); };
  const bool anyMissing = std::any_of(this->Names.begin(), this->Names.end(), isMissing);
  auto* label =
    new QLabel(anyMissing ? tr("The data have no such arrays. Which ones stand for them?")
                          : tr("This was made for data with other ranges of the same arrays."),
      this);
  label->setObjectName("Question");
  layout->addRow(label);
  int choices = 0;
  for (Name& name : this->Names)
  {
    if (isMissing(name))
    {
      this->makeChoice(name, choices++);
    }
  }
  this->Keep = new QRadioButton(tr("&Keep the values"), this);
  this->Keep->setObjectName("Keep");
  this->ByRange = new QRadioButton(tr("Rescale by &range"), this);
  this->ByRange->setObjectName("ByRange");
  this->ByRange->setToolTip(tr("Both ends of the old range go to the ends of the new one, all else "
                               "in proportion"));
  this->ByQuantile = new QRadioButton(tr("Rescale by &quantile"), this);
  this->ByQuantile->setObjectName("ByQuantile");
  const bool hasQuantiles = std::any_of(this->Names.begin(), this->Names.end(),
    [](const Name& name) { return !name.Quantiles.empty(); });
  this->ByQuantile->setEnabled(hasQuantiles);
  this->ByQuantile->setToolTip(hasQuantiles
      ? tr(
          "A value below which a tenth of the old data lies goes to the one below which a tenth of "
          "these data lies, and so on")
      : tr("The file does not carry the quantiles of the data that it was made for. Files and "
           "presets that this panel saves do."));
  (anyMissing ? this->ByRange : this->Keep)->setChecked(true);
  layout->addRow(this->Keep);
  layout->addRow(this->ByRange);
  layout->addRow(this->ByQuantile);
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
  const bool known = std::any_of(this->Names.begin(), this->Names.end(),
    [&](const Name& name) { return name.Array == array && name.Component == component; });
  if (!array.empty() && !known)
  {
    this->Names.push_back(
      { array, component, vtkTFCQuantiles::Find(this->Entries, array, component), nullptr });
  }
}

//-----------------------------------------------------------------------------
void pqTFCMapDialog::makeChoice(Name& name, int index)
{
  name.Choice = new QComboBox(this);
  name.Choice->setObjectName(QString("Choice%1").arg(index));
  name.Choice->addItem(tr("Keep (the region or the axis stays empty)"));
  for (const pqTFCAttribute& attribute : this->Document->attributes())
  {
    name.Choice->addItem(attribute.Label);
  }
  QString text = QString::fromStdString(name.Array);
  if (name.Component != 0)
  {
    text += name.Component < 0 ? tr(" Magnitude") : QString(" %1").arg(name.Component);
  }
  name.Choice->setAccessibleName(tr("Array that stands for %1").arg(text));
  static_cast<QFormLayout*>(this->layout())->addRow(text, name.Choice);
}

//-----------------------------------------------------------------------------
bool pqTFCMapDialog::hasOtherExtent(const Name& name) const
{
  const pqTFCAttribute* now = this->Document->findAttribute(name.Array, name.Component);
  if (!now || name.Quantiles.empty())
  {
    return false;
  }
  const double least = SAME * (name.Quantiles.back() - name.Quantiles.front());
  return std::abs(now->Range[0] - name.Quantiles.front()) > least ||
    std::abs(now->Range[1] - name.Quantiles.back()) > least;
}

//-----------------------------------------------------------------------------
bool pqTFCMapDialog::isNeeded() const
{
  return std::any_of(this->Names.begin(), this->Names.end(),
    [this](const Name& name) { return name.Choice || this->hasOtherExtent(name); });
}

//-----------------------------------------------------------------------------
const pqTFCAttribute* pqTFCMapDialog::choice(const Name& name) const
{
  if (!name.Choice)
  {
    return this->Document->findAttribute(name.Array, name.Component);
  }
  const int index = name.Choice->currentIndex() - 1;
  return index < 0 ? nullptr : &this->Document->attributes()[index];
}

//-----------------------------------------------------------------------------
void pqTFCMapDialog::apply()
{
  std::vector<vtkTFCAttributeChange> changes;
  for (const Name& name : this->Names)
  {
    const pqTFCAttribute* attribute = this->choice(name);
    if (!attribute)
    {
      continue;
    }
    vtkTFCAttributeChange change;
    change.Array = name.Array;
    change.Component = name.Component;
    change.NewArray = attribute->Array;
    change.NewComponent = attribute->Component;
    const bool known = !name.Quantiles.empty();
    if (known && this->ByQuantile->isChecked())
    {
      change.From = name.Quantiles;
      change.To = this->Document->quantiles(*attribute, static_cast<int>(name.Quantiles.size()));
    }
    if (change.To.empty() && !this->Keep->isChecked() && attribute->Range[0] < attribute->Range[1])
    {
      change.From = known ? std::vector<double>{ name.Quantiles.front(), name.Quantiles.back() }
                          : std::vector<double>();
      change.To = { attribute->Range[0], attribute->Range[1] };
    }
    // Without old values an attribute of the same name and range would be stretched for nothing.
    if (!known && !name.Choice)
    {
      change.To.clear();
    }
    changes.push_back(change);
  }
  const int vanished = vtkTFCRescale(this->Model, changes);
  if (vanished > 0)
  {
    this->Document->say(
      tr("%n region(s) would have vanished by rescaling and keep their shape.", "", vanished));
  }
}
