// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCRegionForm.h"

#include "pqColorChooserButton.h"
#include "pqDoubleRangeWidget.h"
#include "pqTFCDocument.h"
#include "pqTFCField.h"
#include "pqTFCReach.h"
#include "pqTFCRegionText.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTFCTransferFunction.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

//-----------------------------------------------------------------------------
pqTFCRegionForm::pqTFCRegionForm(pqTFCDocument* document, QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  this->setObjectName("RegionForm");
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(4);
  layout->setVerticalSpacing(2);

  this->Color = new pqColorChooserButton(this);
  this->Color->setObjectName("Color");
  this->Color->setText(tr("Colour"));
  this->Color->setShowAlphaChannel(false);
  this->Color->setAccessibleName(tr("Colour of the region"));
  this->Opacity = new pqDoubleRangeWidget(this);
  this->Opacity->setObjectName("Opacity");
  this->Opacity->setMinimum(0);
  this->Opacity->setMaximum(1);
  this->Opacity->setAccessibleName(tr("Opacity of the region"));
  this->Opacity->setToolTip(tr("Opacity per unit distance where fall-off and tertiary are 1"));
  this->Falloff = new QComboBox(this);
  this->Falloff->setObjectName("Falloff");
  this->Falloff->addItems({ tr("constant"), tr("linear"), tr("smooth"), tr("gaussian") });
  this->Falloff->setAccessibleName(tr("Fall-off of the region"));
  this->Falloff->setToolTip(tr("How the weight goes from the middle of the region to its outline"));
  this->Width = new pqDoubleRangeWidget(this);
  this->Width->setObjectName("Width");
  this->Width->setMinimum(0.01);
  this->Width->setMaximum(1);
  this->Width->setAccessibleName(tr("Width of the fall-off"));
  this->Width->setToolTip(tr("Part of the region in which the weight falls off"));
  pqTFCNameParts(this->Opacity);
  pqTFCNameParts(this->Width);
  this->GeometryLabel = new QLabel(this);
  this->Geometry = new pqTFCField(this);
  this->Geometry->setObjectName("Geometry");
  this->Geometry->setAccessibleName(tr("Geometry of the region"));

  layout->addWidget(this->Color, 0, 0);
  layout->addWidget(this->Opacity, 0, 1);
  layout->addWidget(this->Falloff, 1, 0);
  layout->addWidget(this->Width, 1, 1);
  layout->addWidget(this->GeometryLabel, 2, 0);
  layout->addWidget(this->Geometry, 2, 1);
  layout->setColumnStretch(1, 1);

  QObject::connect(this->Color, &pqColorChooserButton::validColorChosen, this,
    &pqTFCRegionForm::onColor);
  QObject::connect(this->Falloff, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    &pqTFCRegionForm::onFalloff);
  QObject::connect(this->Geometry, &pqTFCField::editingFinished, this,
    &pqTFCRegionForm::onGeometry);
  const auto connectSlider =
    [this](pqDoubleRangeWidget* slider, const QString& label, void (*set)(vtkTFCRegion*, double))
  {
    // Live while the slider moves; one undo step when it is let go or a number was typed.
    QObject::connect(slider, &pqDoubleRangeWidget::valueChanged, this,
      [this, slider, set](double value)
      {
        vtkTFCRegion* region = this->Document->activeRegion();
        // The beginning of a number need not be one that is allowed: 0 of 0.25.
        if (region && !this->Refreshing && value >= slider->minimum() && value <= slider->maximum())
        {
          this->Document->begin();
          this->Document->model()->SetProposal(false);
          set(region, value);
          this->Document->live();
        }
      });
    QObject::connect(slider, &pqDoubleRangeWidget::valueEdited, this,
      [this, label]()
      {
        if (this->Document->activeRegion() && !this->Refreshing)
        {
          this->Document->commit(label);
        }
      });
  };
  connectSlider(this->Opacity, tr("Change opacity"),
    [](vtkTFCRegion* region, double value) { region->SetOpacity(value); });
  connectSlider(this->Width, tr("Change fall-off"),
    [](vtkTFCRegion* region, double value)
    { region->SetFalloff(region->GetFalloffType(), value); });
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCRegionForm::refresh);
  QObject::connect(document, &pqTFCDocument::selectionChanged, this, &pqTFCRegionForm::refresh);
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCRegionForm::~pqTFCRegionForm() = default;

//-----------------------------------------------------------------------------
void pqTFCRegionForm::refresh()
{
  vtkTFCRegion* region = this->Document->activeRegion();
  this->setEnabled(region && !region->GetLocked() && this->Document->isReady());
  if (!region)
  {
    this->Geometry->show(QString(), true);
    this->GeometryLabel->setText(tr("Geometry"));
    return;
  }
  this->Refreshing = true;
  double color[3];
  region->GetColor(color);
  this->Color->setChosenColor(QColor::fromRgbF(color[0], color[1], color[2]));
  this->Opacity->setValue(region->GetOpacity());
  this->Falloff->setCurrentIndex(region->GetFalloffType());
  this->Width->setValue(region->GetFalloffWidth());
  this->Width->setEnabled(region->GetFalloffType() != vtkTFCRegion::Constant);
  const QString type = region->GetShape()->GetTypeName();
  const bool box = type == "ellipse" || type == "rectangle";
  this->GeometryLabel->setText(type.left(1).toUpper() + type.mid(1));
  this->Geometry->setToolTip(box
      ? tr("Centre x y; half of width and height; angle in degrees. In data units.")
      : tr("Corners x y; x y; ... in data units."));
  this->Geometry->show(pqTFCGeometryText(region), false);
  this->Refreshing = false;
}

//-----------------------------------------------------------------------------
void pqTFCRegionForm::onColor()
{
  vtkTFCRegion* region = this->Document->activeRegion();
  const QColor color = this->Color->chosenColor();
  if (region && !this->Refreshing)
  {
    this->Document->edit(tr("Change colour"),
      [&]() { region->SetColor(color.redF(), color.greenF(), color.blueF()); });
  }
}

//-----------------------------------------------------------------------------
void pqTFCRegionForm::onFalloff(int type)
{
  vtkTFCRegion* region = this->Document->activeRegion();
  if (region && !this->Refreshing)
  {
    this->Document->edit(tr("Change fall-off"),
      [&]() { region->SetFalloff(type, region->GetFalloffWidth()); });
  }
}

//-----------------------------------------------------------------------------
void pqTFCRegionForm::onGeometry()
{
  vtkTFCRegion* region = this->Document->activeRegion();
  if (!region || !this->Geometry->typed())
  {
    return;
  }
  const QString text = this->Geometry->text();
  // Before the edit, which shows it as it was read.
  this->Geometry->accept();
  if (!pqTFCSetGeometry(this->Document, region, text))
  {
    this->Geometry->show(pqTFCGeometryText(region), true);
  }
}
