// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCTertiaryEditor.h"

#include "pqTFCDocument.h"
#include "pqTFCFunctionLook.h"
#include "pqTFCPointsField.h"
#include "pqTFCTertiaryBox.h"
#include "pqTransferFunctionWidget.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTable.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
// The part of ParaView's widget that gets the mouse events (ParaView 5.11).
const char* const CANVAS = "1QVTKWidget0";

void MakeOpacityNodes(vtkPiecewiseFunction* function, vtkDoubleArray* nodes)
{
  nodes->SetNumberOfComponents(2);
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    nodes->InsertNextTuple(node);
  }
}

void MakeColorNodes(vtkColorTransferFunction* function, vtkDoubleArray* nodes)
{
  nodes->SetNumberOfComponents(4);
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6];
    function->GetNodeValue(i, node);
    nodes->InsertNextTuple(node);
  }
}

bool AreSame(vtkDoubleArray* a, vtkDoubleArray* b)
{
  const vtkIdType size = a->GetNumberOfValues();
  return size == b->GetNumberOfValues() &&
    std::equal(a->GetPointer(0), a->GetPointer(0) + size, b->GetPointer(0));
}
}

//-----------------------------------------------------------------------------
pqTFCTertiaryEditor::pqTFCTertiaryEditor(pqTFCDocument* document, pqTFCAdvice* advice,
  QWidget* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  this->setObjectName("TertiaryEditor");
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(4);
  layout->setVerticalSpacing(2);

  auto* label = new QLabel(tr("&Tertiary"), this);
  this->Attribute = new pqTFCTertiaryBox(document, advice, this);
  label->setBuddy(this->Attribute);
  // Its own hint cuts the last letter where a pixel of the screen is less than one of Qt's.
  label->setMinimumWidth(this->fontMetrics().horizontalAdvance(tr("Tertiary")) + 4);
  this->UseColors = new QCheckBox(tr("Co&lours"), this);
  this->UseColors->setObjectName("UseColors");
  this->UseColors->setToolTip(tr("Colour the region by its tertiary attribute"));

  this->Functions = new QWidget(this);
  this->Functions->setObjectName("Functions");
  auto* stack = new QGridLayout(this->Functions);
  stack->setContentsMargins(0, 0, 0, 0);
  stack->setSpacing(2);
  this->Opacity = new pqTransferFunctionWidget(this->Functions);
  this->Opacity->setObjectName("Opacity");
  this->Opacity->setAccessibleName(tr("Opacity over the tertiary attribute"));
  this->Opacity->setMinimumHeight(110);
  this->Colors = new pqTransferFunctionWidget(this->Functions);
  this->Colors->setObjectName("Colors");
  this->Colors->setAccessibleName(tr("Colours over the tertiary attribute"));
  this->Colors->setFixedHeight(40);
  this->Ends[0] = new QLabel(this->Functions);
  this->Ends[1] = new QLabel(this->Functions);
  this->Ends[1]->setAlignment(Qt::AlignRight);
  this->Caption = new QLabel(this->Functions);
  this->Caption->setAlignment(Qt::AlignCenter);
  this->Caption->setObjectName("Caption");
  stack->addWidget(this->Opacity, 0, 0, 1, 3);
  stack->addWidget(this->Colors, 1, 0, 1, 3);
  stack->addWidget(this->Ends[0], 2, 0);
  stack->addWidget(this->Caption, 2, 1);
  stack->addWidget(this->Ends[1], 2, 2);
  stack->addWidget(new pqTFCPointsField(document, pqTFCPointsField::Opacities, this->Functions), 3,
    0, 1, 3);
  stack->addWidget(new pqTFCPointsField(document, pqTFCPointsField::Colors, this->Functions), 4, 0,
    1, 3);
  stack->setRowStretch(0, 1);
  stack->setColumnStretch(1, 1);

  layout->addWidget(label, 0, 0);
  layout->addWidget(this->Attribute, 0, 1);
  layout->addWidget(this->UseColors, 0, 2);
  layout->addWidget(this->Functions, 1, 0, 1, 3);
  layout->setColumnStretch(1, 1);

  for (pqTransferFunctionWidget* widget : { this->Opacity, this->Colors })
  {
    if (auto* canvas = widget->findChild<QWidget*>(CANVAS))
    {
      canvas->installEventFilter(this);
      canvas->setAccessibleName(widget->accessibleName());
    }
    QObject::connect(widget, &pqTransferFunctionWidget::controlPointsModified, this,
      &pqTFCTertiaryEditor::onPointsModified);
  }
  QObject::connect(this->Attribute, &pqTFCTertiaryBox::chosen, document,
    [document](int attribute) { document->setTertiary(document->activeRegion(), attribute); });
  QObject::connect(this->UseColors, &QCheckBox::toggled, this, &pqTFCTertiaryEditor::onUseColors);
  QObject::connect(document, &pqTFCDocument::attributesChanged, this,
    &pqTFCTertiaryEditor::refresh);
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCTertiaryEditor::refresh);
  QObject::connect(document, &pqTFCDocument::selectionChanged, this, [this]() { this->refresh(); });
  QObject::connect(document, &pqTFCDocument::histogramsChanged, this,
    [this]() { this->refresh(); });
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCTertiaryEditor::~pqTFCTertiaryEditor() = default;

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::refresh()
{
  vtkTFCRegion* region = this->Document->activeRegion();
  const bool editable = region && this->Document->isReady();
  const bool hasTertiary = editable && region->HasTertiary();
  this->Refreshing = true;
  this->setEnabled(editable && !region->GetLocked());
  this->Functions->setVisible(hasTertiary);
  this->UseColors->setVisible(hasTertiary);
  this->Total = -1;
  this->Histogram = nullptr;
  if (hasTertiary)
  {
    // Not while a point of the function itself is dragged: that would let go of it.
    if (!this->Pressed)
    {
      this->showFunctions(region);
    }
    this->showHistogram(region);
  }
  this->Refreshing = false;
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::showFunctions(vtkTFCRegion* region)
{
  double range[2];
  double color[3];
  this->Document->tertiaryRange(region, range);
  region->GetColor(color);
  vtkNew<vtkDoubleArray> opacities;
  vtkNew<vtkDoubleArray> colors;
  region->GetTertiaryOpacityNodes(opacities);
  region->GetTertiaryColorNodes(colors);

  // Nodes at both ends, where the function goes on level, so that the chart shows all of the range.
  vtkNew<vtkDoubleArray> wanted;
  wanted->SetNumberOfComponents(2);
  const vtkIdType last = opacities->GetNumberOfTuples() - 1;
  if (last >= 0 && opacities->GetComponent(0, 0) > range[0])
  {
    wanted->InsertNextTuple2(range[0], opacities->GetComponent(0, 1));
  }
  for (vtkIdType i = 0; i <= last; ++i)
  {
    wanted->InsertNextTuple(opacities->GetTuple2(i));
  }
  if (last >= 0 && opacities->GetComponent(last, 0) < range[1])
  {
    wanted->InsertNextTuple2(range[1], opacities->GetComponent(last, 1));
  }

  // What ParaView's widget made itself stays, and with it the point that is selected there.
  const bool hasColors = colors->GetNumberOfTuples() > 0;
  const std::vector<double> base = { static_cast<double>(region->GetId()), range[0], range[1],
    color[0], color[1], color[2], static_cast<double>(hasColors) };
  vtkNew<vtkDoubleArray> opacityNodes;
  vtkNew<vtkDoubleArray> colorNodes;
  MakeOpacityNodes(this->OpacityFunction, opacityNodes);
  MakeColorNodes(this->ColorFunction, colorNodes);
  if (base == this->Shown && AreSame(wanted, opacityNodes) &&
    (!hasColors || AreSame(colors, colorNodes)))
  {
    return;
  }
  this->Shown = base;

  vtkPiecewiseFunction* opacity = this->OpacityFunction;
  opacity->RemoveAllPoints();
  opacity->SetAllowDuplicateScalars(true);
  for (vtkIdType i = 0; i < wanted->GetNumberOfTuples(); ++i)
  {
    opacity->AddPoint(wanted->GetComponent(i, 0), wanted->GetComponent(i, 1));
  }
  const double* extent = opacity->GetRange();

  this->RegionColor->RemoveAllPoints();
  this->RegionColor->AddRGBPoint(extent[0], color[0], color[1], color[2]);
  this->RegionColor->AddRGBPoint(extent[1], color[0], color[1], color[2]);
  this->ColorFunction->RemoveAllPoints();
  this->ColorFunction->SetAllowDuplicateScalars(true);
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    const double* c = colors->GetTuple4(i);
    this->ColorFunction->AddRGBPoint(c[0], c[1], c[2], c[3]);
  }
  this->Opacity->initialize(hasColors ? this->ColorFunction : this->RegionColor, false, opacity,
    true);
  if (hasColors)
  {
    this->Colors->initialize(this->ColorFunction, true, nullptr, false);
  }
  this->Colors->setVisible(hasColors);
  this->UseColors->setChecked(hasColors);
  this->Ends[0]->setText(QString::number(extent[0], 'g', 5));
  this->Ends[1]->setText(QString::number(extent[1], 'g', 5));
  this->followPalette();
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::followPalette()
{
  for (pqTransferFunctionWidget* widget : { this->Opacity, this->Colors })
  {
    // Not the palette of the widget, which gets the new one after its parent.
    pqTFCFollowPalette(widget, this->palette());
    widget->render();
  }
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::changeEvent(QEvent* e)
{
  this->Superclass::changeEvent(e);
  if (e->type() == QEvent::PaletteChange)
  {
    this->followPalette();
  }
}

//-----------------------------------------------------------------------------
QString pqTFCTertiaryEditor::colors() const
{
  return pqTFCFunctionColors(this->Opacity);
}

//-----------------------------------------------------------------------------
QString pqTFCTertiaryEditor::histogram() const
{
  const vtkIdType bins = this->Histogram ? this->Histogram->GetNumberOfRows() : 0;
  QStringList numbers;
  for (vtkIdType i = 0; i < bins; ++i)
  {
    numbers << QString::number(this->Histogram->GetValue(i, 0).ToDouble(), 'g', 17)
            << QString::number(this->Histogram->GetValue(i, 1).ToDouble(), 'g', 17);
  }
  return numbers.join(' ');
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::showHistogram(vtkTFCRegion* region)
{
  std::vector<double> counts;
  double range[2];
  if (!this->Document->conditional(region, counts, range))
  {
    this->Caption->setText(this->Document->hasArrays(region) ? tr("histogram follows ...")
                                                             : tr("no histogram of this array"));
    this->Histogram = nullptr;
    this->Opacity->setHistogramTable(nullptr);
    return;
  }
  this->Total = std::accumulate(counts.begin(), counts.end(), 0.0);
  // Column 0 must be a vtkDoubleArray (vtkScalarsToColorsItem.cxx:236 of VTK 9.2).
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkNew<vtkDoubleArray> centers;
  vtkNew<vtkDoubleArray> values;
  centers->SetName("bin_extents");
  values->SetName("bin_values");
  const double width = (range[1] - range[0]) / counts.size();
  for (size_t i = 0; i < counts.size(); ++i)
  {
    centers->InsertNextValue(range[0] + (i + 0.5) * width);
    values->InsertNextValue(counts[i]);
  }
  table->AddColumn(centers);
  table->AddColumn(values);
  this->Histogram = table;
  this->Opacity->setHistogramTable(table);
  const QString voxels = tr("%L1 voxels").arg(std::round(this->Total), 0, 'f', 0);
  this->Caption->setText(
    this->Document->isStale(region) ? tr("%1 (out of date)").arg(voxels) : voxels);
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::write(vtkTFCRegion* region)
{
  vtkNew<vtkDoubleArray> opacities;
  vtkNew<vtkDoubleArray> colors;
  vtkNew<vtkDoubleArray> before;
  MakeOpacityNodes(this->OpacityFunction, opacities);
  region->GetTertiaryColorNodes(before);
  if (before->GetNumberOfTuples() > 0)
  {
    MakeColorNodes(this->ColorFunction, colors);
  }
  const std::string array = region->GetTertiaryArray();
  region->SetTertiary(array.c_str(), region->GetTertiaryComponent(), opacities,
    colors->GetNumberOfTuples() > 0 ? colors.Get() : nullptr);
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::onPointsModified()
{
  vtkTFCRegion* region = this->Document->activeRegion();
  if (this->Refreshing || !region || !region->HasTertiary() || region->GetLocked())
  {
    return;
  }
  if (this->Pressed)
  {
    this->writeLive(region);
    return;
  }
  // By a key: ParaView's widget is in the middle of its change and must not get new functions yet.
  const int id = region->GetId();
  QMetaObject::invokeMethod(
    this,
    [this, id]()
    {
      vtkTFCRegion* active = this->Document->activeRegion();
      if (active && active->GetId() == id && active->HasTertiary())
      {
        this->writeLive(active);
        this->Document->commit(tr("Change tertiary function"));
      }
    },
    Qt::QueuedConnection);
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::writeLive(vtkTFCRegion* region)
{
  this->Document->begin();
  this->Document->model()->SetProposal(false);
  this->write(region);
  this->Document->live();
}

//-----------------------------------------------------------------------------
bool pqTFCTertiaryEditor::onKey(QObject* function, int key)
{
  auto* widget = qobject_cast<pqTransferFunctionWidget*>(function);
  if (!widget)
  {
    return false;
  }
  if (key == Qt::Key_Delete || key == Qt::Key_Backspace)
  {
    // VTK reports an error when there is no point to remove.
    return widget->currentPoint() < 0;
  }
  if (widget == this->Colors && (key == Qt::Key_Return || key == Qt::Key_Enter))
  {
    this->chooseColor();
    return true;
  }
  return false;
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::chooseColor()
{
  // What ParaView's widget does after a double click; but the style of VTK's charts passes none on
  // (VTK 9.2: vtkContextInteractorStyle has no OnLeftButtonDoubleClick()).
  QMetaObject::invokeMethod(this->Colors, "editColorAtCurrentControlPoint", Qt::QueuedConnection);
}

//-----------------------------------------------------------------------------
bool pqTFCTertiaryEditor::eventFilter(QObject* watched, QEvent* e)
{
  if (e->type() == QEvent::KeyPress &&
    this->onKey(watched->parent(), static_cast<QKeyEvent*>(e)->key()))
  {
    return true;
  }
  if (e->type() == QEvent::MouseButtonPress || e->type() == QEvent::MouseButtonDblClick)
  {
    this->Pressed = true;
    this->DoubleClicked =
      e->type() == QEvent::MouseButtonDblClick && watched->parent() == this->Colors;
  }
  else if (e->type() == QEvent::MouseButtonRelease && this->Pressed)
  {
    // ParaView's widget says nothing when the mouse is let go; it still has to see this event.
    QMetaObject::invokeMethod(
      this,
      [this]()
      {
        this->Pressed = false;
        if (this->Document->link()->isEditing())
        {
          this->Document->commit(tr("Change tertiary function"));
        }
        if (this->DoubleClicked)
        {
          this->DoubleClicked = false;
          this->chooseColor();
        }
      },
      Qt::QueuedConnection);
  }
  return this->Superclass::eventFilter(watched, e);
}

//-----------------------------------------------------------------------------
void pqTFCTertiaryEditor::onUseColors(bool use)
{
  vtkTFCRegion* region = this->Document->activeRegion();
  if (this->Refreshing || !region || !region->HasTertiary())
  {
    return;
  }
  vtkNew<vtkDoubleArray> opacities;
  vtkNew<vtkDoubleArray> colors;
  region->GetTertiaryOpacityNodes(opacities);
  colors->SetNumberOfComponents(4);
  if (use)
  {
    // From the region's colour to a light tint of it: a start that shows what it does.
    double range[2];
    double c[3];
    this->Document->tertiaryRange(region, range);
    region->GetColor(c);
    colors->InsertNextTuple4(range[0], c[0], c[1], c[2]);
    colors->InsertNextTuple4(range[1], (1 + c[0]) / 2, (1 + c[1]) / 2, (1 + c[2]) / 2);
  }
  const std::string array = region->GetTertiaryArray();
  this->Document->edit(tr("Change tertiary colours"),
    [&]()
    {
      region->SetTertiary(array.c_str(), region->GetTertiaryComponent(), opacities,
        use ? colors.Get() : nullptr);
    });
}
