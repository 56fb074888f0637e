// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCMessageBar.h"

#include "pqCoreUtilities.h"
#include "pqTFCAttributeFilter.h"
#include "pqTFCDataProblem.h"
#include "pqTFCDocument.h"
#include "pqTFCMapDialog.h"
#include "vtkTFCTransferFunction.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>

namespace
{
constexpr int READING_TIME = 8000; // ms
}

//-----------------------------------------------------------------------------
pqTFCMessageBar::pqTFCMessageBar(pqTFCDocument* document, QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  this->setObjectName("MessageBar");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Message = new QLabel(this);
  this->Message->setObjectName("Message");
  this->Message->setWordWrap(true);
  this->MessageButton = new QPushButton(this);
  this->MessageButton->setObjectName("MessageButton");
  layout->addWidget(this->Message, 1);
  layout->addWidget(this->MessageButton);
  QObject::connect(this->MessageButton, &QPushButton::clicked, this, &pqTFCMessageBar::act);
  QObject::connect(document, &pqTFCDocument::changed, this,
    [this]()
    {
      this->Said.clear();
      this->refresh();
    });
  QObject::connect(document, &pqTFCDocument::targetChanged, this, &pqTFCMessageBar::refresh);
  QObject::connect(document, &pqTFCDocument::attributesChanged, this, &pqTFCMessageBar::refresh);
  QObject::connect(document, &pqTFCDocument::said, this, &pqTFCMessageBar::say);
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCMessageBar::~pqTFCMessageBar() = default;

//-----------------------------------------------------------------------------
QString pqTFCMessageBar::text() const
{
  return this->isHidden() ? QString() : this->Message->text();
}

//-----------------------------------------------------------------------------
bool pqTFCMessageBar::isDiagonal() const
{
  vtkTFCTransferFunction* model = this->Document->model();
  return model->HasAxes() && model->GetAxisArray(0) == model->GetAxisArray(1) &&
    model->GetAxisComponent(0) == model->GetAxisComponent(1);
}

//-----------------------------------------------------------------------------
void pqTFCMessageBar::refresh()
{
  QString text;
  QString button;
  this->Problem = pqTFCDataProblem::find(this->Document);
  switch (this->Document->link()->situation())
  {
    case pqTFCStateLink::NoData:
      text = tr("Select a volume in the Pipeline Browser to edit its transfer function.");
      break;
    case pqTFCStateLink::NotHere:
      text = tr("Click on a render view, or make one, to show the selected data in it.");
      break;
    case pqTFCStateLink::NotShown:
      text = tr("The selected data are not shown in this view.");
      button = tr("Show as Combined Volume");
      break;
    case pqTFCStateLink::NotAnImage:
      text = tr("Combined transfer functions draw uniform grids. This makes one of the data:");
      button = tr("Resample To Image");
      break;
    case pqTFCStateLink::NoPlugin:
      text = tr("The server does not offer Combined Volume: load the plugin there "
                "(Tools > Manage Plugins), then open the data again.");
      break;
    case pqTFCStateLink::OtherType:
      text = tr("The data are not shown with a combined transfer function yet.");
      button = tr("Show as Combined Volume");
      break;
    case pqTFCStateLink::Ready:
      if (!this->Problem.Text.isEmpty())
      {
        text = this->Problem.Text;
        button = this->Problem.Kind == pqTFCDataProblem::Missing ? tr("Replace Arrays ...")
          : this->Problem.Kind == pqTFCDataProblem::Mixed        ? tr("Cell Data to Point Data")
                                                                 : QString();
      }
      else if (this->isDiagonal())
      {
        text = tr("Both axes show the same. A second attribute tells materials from boundaries:");
        button = tr("Compute Gradient Magnitude");
      }
      else if (this->Document->model()->GetProposal())
      {
        text = tr("A proposal from the peaks of the histogram: edit it, or");
        button = tr("Start Empty");
      }
      else if (!this->Document->model()->HasAxes())
      {
        text = tr("Choose the two axes below the chart.");
      }
      break;
  }
  if (!this->Said.isEmpty())
  {
    text = this->Said;
    button.clear();
  }
  this->Message->setText(text);
  this->MessageButton->setText(button);
  this->MessageButton->setVisible(!button.isEmpty());
  this->setVisible(!text.isEmpty());
}

//-----------------------------------------------------------------------------
void pqTFCMessageBar::act()
{
  switch (this->Document->link()->situation())
  {
    case pqTFCStateLink::NotShown:
    case pqTFCStateLink::OtherType:
      this->Document->link()->makeCombinedVolume();
      break;
    case pqTFCStateLink::NotAnImage:
      pqTFCAttributeFilter::resampleToImage();
      break;
    default:
      if (this->Problem.Kind == pqTFCDataProblem::Missing)
      {
        this->replaceArrays();
        break;
      }
      if (this->Problem.Kind == pqTFCDataProblem::Mixed)
      {
        pqTFCAttributeFilter::cellsToPoints(this->Document);
        break;
      }
      if (this->isDiagonal())
      {
        pqTFCAttributeFilter::computeGradient(this->Document);
        break;
      }
      this->Document->edit(tr("Remove proposal"),
        [this]()
        {
          this->Document->model()->RemoveAllRegions();
          this->Document->model()->SetProposal(false);
        });
  }
}

//-----------------------------------------------------------------------------
void pqTFCMessageBar::replaceArrays()
{
  vtkNew<vtkTFCTransferFunction> model;
  model->SetState(this->Document->state().toUtf8().constData());
  pqTFCMapDialog dialog(this->Document, model, pqCoreUtilities::mainWidget());
  if (dialog.isNeeded() && dialog.exec() == QDialog::Accepted)
  {
    dialog.apply();
    this->Document->replace(tr("Replace arrays"), QString::fromStdString(model->GetState()));
  }
}

//-----------------------------------------------------------------------------
void pqTFCMessageBar::say(const QString& message)
{
  this->Said = message;
  this->refresh();
  // Long enough to be read, then what is always true shows again.
  QTimer::singleShot(READING_TIME, this,
    [this, message]()
    {
      if (this->Said == message)
      {
        this->Said.clear();
        this->refresh();
      }
    });
}
