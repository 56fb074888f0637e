// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCDocument.h"

#include "pqDataRepresentation.h"
#include "pqView.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkTFCQuantiles.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionHistograms.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <set>

//-----------------------------------------------------------------------------
pqTFCDocument::pqTFCDocument(QObject* parentObject)
  : Superclass(parentObject)
{
  // With an observer, errors of the model are shown in the panel instead of the message window.
  this->Events->Connect(this->Model, vtkCommand::ErrorEvent, this, SLOT(onModelError()));
  QObject::connect(&this->Link, &pqTFCStateLink::targetChanged, this,
    &pqTFCDocument::onTargetChanged);
  QObject::connect(&this->Link, &pqTFCStateLink::dataChanged, this, &pqTFCDocument::onDataChanged);
  QObject::connect(&this->Link, &pqTFCStateLink::stateChanged, this, &pqTFCDocument::readState);
  QObject::connect(&this->Cache, &pqTFCHistogramCache::arrived, this,
    &pqTFCDocument::histogramsChanged);
  this->onTargetChanged();
}

//-----------------------------------------------------------------------------
pqTFCDocument::~pqTFCDocument() = default;

//-----------------------------------------------------------------------------
vtkTFCTransferFunction* pqTFCDocument::model() const
{
  return this->Model;
}

//-----------------------------------------------------------------------------
QString pqTFCDocument::state() const
{
  return this->Link.state();
}

//-----------------------------------------------------------------------------
void pqTFCDocument::onModelError()
{
  const std::string& error = this->Model->GetLastError();
  this->say(error.empty() ? tr("The value is not valid; nothing was changed.")
                          : QString::fromStdString(error));
}

//-----------------------------------------------------------------------------
void pqTFCDocument::onTargetChanged()
{
  this->collectAttributes();
  this->readState();
  Q_EMIT this->targetChanged();
}

//-----------------------------------------------------------------------------
void pqTFCDocument::onDataChanged()
{
  this->Cache.setStale();
  this->collectAttributes();
  Q_EMIT this->changed(false);
}

//-----------------------------------------------------------------------------
void pqTFCDocument::readState()
{
  this->Model->SetState(this->state().toUtf8().constData());
  std::vector<int> kept;
  for (int id : this->Selection)
  {
    if (this->Model->GetRegionById(id))
    {
      kept.push_back(id);
    }
  }
  this->setSelection(kept);
  Q_EMIT this->changed(false);
}

//-----------------------------------------------------------------------------
void pqTFCDocument::begin()
{
  if (!this->Link.isEditing())
  {
    this->LiveTime = this->LiveEvents = 0;
  }
  this->Cache.setPaused(true);
  this->Link.begin();
}

//-----------------------------------------------------------------------------
void pqTFCDocument::live()
{
  this->begin();
  QElapsedTimer timer;
  timer.start();
  this->Link.live(QString::fromStdString(this->Model->GetState()));
  Q_EMIT this->changed(true);
  this->LiveTime += timer.nsecsElapsed() * 1e-6;
  ++this->LiveEvents;
}

//-----------------------------------------------------------------------------
double pqTFCDocument::millisecondsPerEvent() const
{
  return this->LiveTime / std::max(1, this->LiveEvents);
}

//-----------------------------------------------------------------------------
void pqTFCDocument::commit(const QString& label)
{
  this->Link.commit(QString::fromStdString(this->Model->GetState()), label);
  this->Cache.setPaused(false);
  Q_EMIT this->changed(false);
}

//-----------------------------------------------------------------------------
void pqTFCDocument::edit(const QString& label, const std::function<void()>& change)
{
  if (this->isReady())
  {
    const std::string before = this->Model->GetState();
    change();
    if (this->Model->GetState() != before)
    {
      this->Model->SetProposal(false);
      this->commit(label);
      return;
    }
  }
  // What a field shows may not be what was accepted.
  Q_EMIT this->changed(false);
}

//-----------------------------------------------------------------------------
bool pqTFCDocument::replace(const QString& label, const QString& json)
{
  if (!this->isReady() || !this->Model->SetState(json.toUtf8().constData()))
  {
    return false;
  }
  this->commit(label);
  return true;
}

//-----------------------------------------------------------------------------
void pqTFCDocument::setSelection(const std::vector<int>& ids)
{
  if (ids != this->Selection)
  {
    this->Selection = ids;
    Q_EMIT this->selectionChanged();
  }
}

//-----------------------------------------------------------------------------
vtkTFCRegion* pqTFCDocument::activeRegion() const
{
  return this->Selection.size() == 1 ? this->Model->GetRegionById(this->Selection[0]) : nullptr;
}

//-----------------------------------------------------------------------------
void pqTFCDocument::collectAttributes()
{
  std::vector<pqTFCAttribute> attributes;
  std::set<std::string> names;
  vtkPVDataInformation* data = this->Link.dataInformation();
  for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkPVDataSetAttributesInformation* arrays =
      data ? data->GetAttributeInformation(association) : nullptr;
    for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkPVArrayInformation* array = arrays->GetArrayInformation(i);
      const int components = array->GetNumberOfComponents();
      if (!array->GetName() || array->GetIsPartial() ||
        QString(array->GetName()).startsWith("vtk") || array->GetDataType() == VTK_STRING ||
        !names.insert(array->GetName()).second)
      {
        if (association == vtkDataObject::CELL && array->GetName())
        {
          for (pqTFCAttribute& attribute : attributes)
          {
            attribute.OnCells = attribute.OnCells || attribute.Array == array->GetName();
          }
        }
        continue;
      }
      for (int c = components > 1 ? -1 : 0; c < components; ++c)
      {
        pqTFCAttribute attribute;
        attribute.Array = array->GetName();
        attribute.Component = c;
        attribute.Label = QString::fromUtf8(array->GetName());
        if (components > 1)
        {
          const char* name = array->GetComponentName(c);
          attribute.Label += " " +
            (c < 0     ? tr("Magnitude")
                : name ? QString(name)
                       : QString::number(c));
        }
        if (association == vtkDataObject::CELL)
        {
          attribute.Label += tr(" (cells)");
        }
        attribute.OnPoints = association == vtkDataObject::POINT;
        attribute.OnCells = association == vtkDataObject::CELL;
        array->GetComponentFiniteRange(c, attribute.Range);
        attribute.Integral =
          c >= 0 && array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
        attributes.push_back(attribute);
      }
    }
  }
  const auto same = [](const pqTFCAttribute& a, const pqTFCAttribute& b)
  {
    return a.Array == b.Array && a.Component == b.Component && a.Label == b.Label &&
      a.OnPoints == b.OnPoints && a.OnCells == b.OnCells &&
      std::equal(a.Range, a.Range + 2, b.Range);
  };
  if (!std::equal(attributes.begin(), attributes.end(), this->Attributes.begin(),
        this->Attributes.end(), same))
  {
    this->Attributes = std::move(attributes);
    Q_EMIT this->attributesChanged();
  }
  this->Cache.setInput(this->isReady() ? this->Link.input() : nullptr, this->time());
}

//-----------------------------------------------------------------------------
void pqTFCDocument::setTertiary(vtkTFCRegion* region, int index)
{
  if (!region || index >= static_cast<int>(this->Attributes.size()))
  {
    return;
  }
  this->edit(tr("Change tertiary attribute"),
    [&]()
    {
      if (index < 0)
      {
        region->RemoveTertiary();
        return;
      }
      const pqTFCAttribute& attribute = this->Attributes[index];
      if (region->HasTertiary() && region->GetTertiaryArray() == attribute.Array &&
        region->GetTertiaryComponent() == attribute.Component)
      {
        return;
      }
      double low = attribute.Range[0];
      double high = attribute.Range[1];
      if (!(low < high))
      {
        const double half = std::max(0.5, std::abs(low) / 2);
        high = low + half;
        low -= half;
      }
      vtkNew<vtkDoubleArray> nodes;
      nodes->SetNumberOfComponents(2);
      nodes->InsertNextTuple2(low, 1);
      nodes->InsertNextTuple2(high, 1);
      region->ClearTertiaryRange();
      region->SetTertiary(attribute.Array.c_str(), attribute.Component, nodes);
    });
}

//-----------------------------------------------------------------------------
double pqTFCDocument::time() const
{
  pqDataRepresentation* representation = this->Link.representation();
  pqView* view = representation ? representation->getView() : nullptr;
  return view ? vtkSMPropertyHelper(view->getProxy(), "ViewTime", true).GetAsDouble() : 0;
}

//-----------------------------------------------------------------------------
const pqTFCAttribute* pqTFCDocument::findAttribute(const std::string& array, int component) const
{
  for (const pqTFCAttribute& attribute : this->Attributes)
  {
    if (attribute.Array == array && attribute.Component == component)
    {
      return &attribute;
    }
  }
  return nullptr;
}

//-----------------------------------------------------------------------------
QString pqTFCDocument::labelOf(const std::string& array, int component) const
{
  const pqTFCAttribute* attribute = this->findAttribute(array, component);
  return attribute ? attribute->Label : tr("%1 (missing)").arg(QString::fromStdString(array));
}

//-----------------------------------------------------------------------------
bool pqTFCDocument::axisRanges(double ranges[4]) const
{
  double data[2][2] = { { 1, 0 }, { 1, 0 } };
  if (!this->Model->HasAxes())
  {
    return false;
  }
  for (int i = 0; i < 2; ++i)
  {
    const pqTFCAttribute* attribute =
      this->findAttribute(this->Model->GetAxisArray(i), this->Model->GetAxisComponent(i));
    if (attribute)
    {
      std::copy(attribute->Range, attribute->Range + 2, data[i]);
    }
  }
  this->Model->ResolveRanges(data[0], data[1], ranges);
  return true;
}

//-----------------------------------------------------------------------------
void pqTFCDocument::tertiaryRange(vtkTFCRegion* region, double range[2]) const
{
  const pqTFCAttribute* attribute =
    this->findAttribute(region->GetTertiaryArray(), region->GetTertiaryComponent());
  if (region->GetTertiaryRange(range))
  {
    return;
  }
  range[0] = attribute ? attribute->Range[0] : 0;
  range[1] = attribute ? attribute->Range[1] : 1;
  // Nodes beyond the data must stay reachable.
  vtkNew<vtkDoubleArray> nodes;
  region->GetTertiaryOpacityNodes(nodes);
  if (!attribute && nodes->GetNumberOfTuples() > 0)
  {
    range[0] = nodes->GetComponent(0, 0);
    range[1] = nodes->GetComponent(nodes->GetNumberOfTuples() - 1, 0);
  }
  if (!(range[0] < range[1]))
  {
    const double half = std::max(0.5, std::abs(range[0]) / 2);
    range[1] = range[0] + half;
    range[0] -= half;
  }
}

//-----------------------------------------------------------------------------
pqTFCAxis pqTFCDocument::axis(int index, const double ranges[4]) const
{
  pqTFCAxis axis;
  axis.Array = this->Model->GetAxisArray(index);
  axis.Component = this->Model->GetAxisComponent(index);
  axis.Range[0] = ranges[2 * index];
  axis.Range[1] = ranges[2 * index + 1];
  const pqTFCAttribute* attribute = this->findAttribute(axis.Array, axis.Component);
  axis.Integral = attribute && attribute->Integral;
  return axis;
}

//-----------------------------------------------------------------------------
bool pqTFCDocument::histogramAxes(vtkTFCRegion* region, std::vector<pqTFCAxis>& axes) const
{
  double ranges[4];
  bool onPoints = true;
  bool onCells = true;
  const auto isKnown = [&](const std::string& array, int component)
  {
    const pqTFCAttribute* attribute = this->findAttribute(array, component);
    onPoints = onPoints && attribute && attribute->OnPoints;
    onCells = onCells && attribute && attribute->OnCells;
    return onPoints || onCells;
  };
  if (!this->axisRanges(ranges) ||
    !isKnown(this->Model->GetAxisArray(0), this->Model->GetAxisComponent(0)) ||
    !isKnown(this->Model->GetAxisArray(1), this->Model->GetAxisComponent(1)) ||
    (region &&
      (!region->HasTertiary() ||
        !isKnown(region->GetTertiaryArray(), region->GetTertiaryComponent()))))
  {
    return false;
  }
  axes = { this->axis(0, ranges), this->axis(1, ranges), pqTFCAxis() };
  if (region)
  {
    axes[2].Array = region->GetTertiaryArray();
    axes[2].Component = region->GetTertiaryComponent();
    this->tertiaryRange(region, axes[2].Range);
  }
  return true;
}

//-----------------------------------------------------------------------------
vtkTFCSparseHistogram* pqTFCDocument::plane()
{
  std::vector<pqTFCAxis> axes;
  return this->histogramAxes(nullptr, axes) ? this->Cache.request(axes) : nullptr;
}

//-----------------------------------------------------------------------------
vtkTFCSparseHistogram* pqTFCDocument::joint(vtkTFCRegion* region)
{
  // After the plane: what is seen first comes first.
  std::vector<pqTFCAxis> axes;
  return this->plane() && this->histogramAxes(region, axes) ? this->Cache.request(axes) : nullptr;
}

//-----------------------------------------------------------------------------
bool pqTFCDocument::isStale(vtkTFCRegion* region) const
{
  std::vector<pqTFCAxis> axes;
  return this->histogramAxes(region, axes) && this->Cache.isWanted(axes);
}

//-----------------------------------------------------------------------------
bool pqTFCDocument::hasArrays(vtkTFCRegion* region) const
{
  std::vector<pqTFCAxis> axes;
  return this->histogramAxes(region, axes);
}

//-----------------------------------------------------------------------------
bool pqTFCDocument::conditional(vtkTFCRegion* region, std::vector<double>& counts, double range[2])
{
  vtkTFCSparseHistogram* histogram = this->joint(region);
  double ranges[4];
  if (!histogram || !this->axisRanges(ranges))
  {
    return false;
  }
  counts = vtkTFCRegionHistograms::MakeConditional(histogram, this->Model, region, ranges);
  histogram->GetRange(2, range);
  return true;
}

//-----------------------------------------------------------------------------
std::vector<double> pqTFCDocument::quantiles(const pqTFCAttribute& attribute, int number)
{
  if (!(attribute.Range[0] < attribute.Range[1]))
  {
    return {};
  }
  pqTFCAxis axis;
  axis.Array = attribute.Array;
  axis.Component = attribute.Component;
  std::copy(attribute.Range, attribute.Range + 2, axis.Range);
  return vtkTFCQuantiles::FromCounts(this->Cache.distribution(axis), axis.Range[0], axis.Range[1],
    number);
}
