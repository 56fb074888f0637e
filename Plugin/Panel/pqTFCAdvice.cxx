// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCAdvice.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqTFCCancelableUpdate.h"
#include "pqTFCDataProblem.h"
#include "pqTFCDocument.h"
#include "pqUndoStack.h"
#include "vtkPVSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkTFCTableInformation.h"
#include "vtkTFCTransferFunction.h"

#include <QCursor>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
constexpr double BALANCE = 0.4; // the paper's

// The advice's names: "name", "name:2" or "name:magnitude".
std::string NameOf(const std::string& array, int component, bool single)
{
  return single ? array : array + ":" + (component < 0 ? "magnitude" : std::to_string(component));
}
}

//-----------------------------------------------------------------------------
double pqTFCAdvice::Candidate::Score(double balance) const
{
  return -balance * std::abs(this->Correlation) +
    (1 - balance) * this->Entropy / this->LargestEntropy;
}

//-----------------------------------------------------------------------------
pqTFCAdvice::pqTFCAdvice(pqTFCDocument* document, QObject* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  QObject::connect(document, &pqTFCDocument::attributesChanged, this, &pqTFCAdvice::forget);
  QObject::connect(document, &pqTFCDocument::targetChanged, this, &pqTFCAdvice::forget);
  QObject::connect(document->link(), &pqTFCStateLink::dataChanged, this, &pqTFCAdvice::forget);
}

//-----------------------------------------------------------------------------
pqTFCAdvice::~pqTFCAdvice() = default;

//-----------------------------------------------------------------------------
void pqTFCAdvice::forget()
{
  this->Candidates.clear();
  this->CandidatesAxes.clear();
  this->Pairs.clear();
  this->HasPairs = false;
  this->releaseSplits();
}

//-----------------------------------------------------------------------------
void pqTFCAdvice::releaseSplits()
{
  this->Splits.clear();
  this->SplitsState.clear();
  if (this->SplitFilter)
  {
    SCOPED_UNDO_EXCLUDE();
    this->SplitFilter = nullptr;
  }
}

//-----------------------------------------------------------------------------
vtkSmartPointer<vtkSMSourceProxy> pqTFCAdvice::makeFilter(const char* name) const
{
  vtkSmartPointer<vtkSMSourceProxy> filter;
  if (pqOutputPort* port = this->Document->link()->input())
  {
    filter.TakeReference(
      vtkSMSourceProxy::SafeDownCast(port->getServer()->proxyManager()->NewProxy("filters", name)));
    if (filter)
    {
      vtkSMPropertyHelper(filter, "Input")
        .Set(port->getSource()->getProxy(), port->getPortNumber());
    }
  }
  return filter;
}

//-----------------------------------------------------------------------------
vtkSmartPointer<vtkTFCTableInformation> pqTFCAdvice::gather(vtkSMSourceProxy* filter,
  vtkTFCTableInformation* second) const
{
  auto table = vtkSmartPointer<vtkTFCTableInformation>::New();
  QGuiApplication::setOverrideCursor(QCursor(Qt::BusyCursor));
  filter->UpdateVTKObjects();
  const QString label = QString(filter->GetXMLLabel()) + "...";
  if (pqTFCCancelableUpdate::run(filter, this->Document->time(), label))
  {
    filter->GatherInformation(table, vtkPVSession::DATA_SERVER);
    if (second)
    {
      filter->GatherInformation(second, vtkPVSession::DATA_SERVER);
    }
  }
  QGuiApplication::restoreOverrideCursor();
  return table;
}

//-----------------------------------------------------------------------------
vtkSmartPointer<vtkTFCTableInformation> pqTFCAdvice::run(const char* name,
  const std::function<void(vtkSMProxy*)>& prepare, vtkTFCTableInformation* second)
{
  SCOPED_UNDO_EXCLUDE();
  const vtkSmartPointer<vtkSMSourceProxy> filter = this->makeFilter(name);
  if (!filter)
  {
    return vtkSmartPointer<vtkTFCTableInformation>::New();
  }
  prepare(filter);
  return this->gather(filter, second);
}

//-----------------------------------------------------------------------------
const std::vector<pqTFCAdvice::Candidate>& pqTFCAdvice::candidates()
{
  vtkTFCTransferFunction* model = this->Document->model();
  std::string axes;
  std::string names[2];
  for (int i = 0; i < 2; ++i)
  {
    const std::string& array = model->GetAxisArray(i);
    const int component = model->GetAxisComponent(i);
    // Arrays with several components have a magnitude.
    names[i] = NameOf(array, component, !this->Document->findAttribute(array, -1));
    axes += names[i] + "\n";
  }
  if (axes == this->CandidatesAxes || !model->HasAxes() || !this->Document->isReady())
  {
    return this->Candidates;
  }
  // The message bar says what is wrong with the data: no filter has to.
  if (pqTFCDataProblem::find(this->Document).Kind != pqTFCDataProblem::None)
  {
    this->Candidates.clear();
    this->CandidatesAxes.clear();
    return this->Candidates;
  }
  this->CandidatesAxes = axes;
  this->Candidates.clear();
  const auto table = this->run("CombinationScore",
    [&](vtkSMProxy* filter)
    {
      vtkSMPropertyHelper(filter, "Primary").Set(names[0].c_str());
      vtkSMPropertyHelper(filter, "Secondary").Set(names[1].c_str());
      vtkSMPropertyHelper(filter, "Balance").Set(BALANCE);
    });
  double largest = 0;
  for (int row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const double entropy = table->GetNumber("entropy", row);
    largest = std::isfinite(entropy) ? std::max(largest, entropy) : largest;
  }
  for (int row = 0; row < table->GetNumberOfRows() && largest > 0; ++row)
  {
    Candidate candidate;
    const std::string name = table->GetText("attribute", row);
    candidate.Correlation = table->GetNumber("correlation", row);
    candidate.Entropy = table->GetNumber("entropy", row);
    candidate.LargestEntropy = largest;
    if (!(table->GetNumber("rank", row) > 0))
    {
      continue;
    }
    for (const pqTFCAttribute& attribute : this->Document->attributes())
    {
      const bool single = !this->Document->findAttribute(attribute.Array, -1);
      if (NameOf(attribute.Array, attribute.Component, single) == name)
      {
        candidate.Array = attribute.Array;
        candidate.Component = attribute.Component;
        candidate.Label = attribute.Label;
        this->Candidates.push_back(candidate);
      }
    }
  }
  return this->Candidates;
}

//-----------------------------------------------------------------------------
const std::vector<pqTFCAdvice::Pair>& pqTFCAdvice::pairs()
{
  if (this->HasPairs || this->Document->attributes().empty())
  {
    return this->Pairs;
  }
  this->HasPairs = true;
  const auto table = this->run("AxisSuggestion", [](vtkSMProxy*) {});
  for (int row = 0; row < table->GetNumberOfRows(); ++row)
  {
    // One row per pair and tertiary attribute.
    const Pair pair = { table->GetText("primary", row), table->GetText("secondary", row),
      QString::fromStdString(table->GetText("kind", row)), table->GetNumber("pair_score", row) };
    const auto same = [&pair](const Pair& other)
    { return other.Primary == pair.Primary && other.Secondary == pair.Secondary; };
    if (!pair.Primary.empty() && std::none_of(this->Pairs.begin(), this->Pairs.end(), same))
    {
      this->Pairs.push_back(pair);
    }
  }
  return this->Pairs;
}

//-----------------------------------------------------------------------------
bool pqTFCAdvice::hasMoreThanAxes() const
{
  const vtkTFCTransferFunction* model = this->Document->model();
  const auto isOther = [model](const pqTFCAttribute& attribute)
  {
    bool other = true;
    for (int i = 0; i < 2; ++i)
    {
      other = other &&
        (attribute.Array != model->GetAxisArray(i) ||
          attribute.Component != model->GetAxisComponent(i));
    }
    return other;
  };
  const auto& attributes = this->Document->attributes();
  return this->Document->isReady() && model->HasAxes() &&
    pqTFCDataProblem::find(this->Document).Kind == pqTFCDataProblem::None &&
    std::any_of(attributes.begin(), attributes.end(), isOther);
}

//-----------------------------------------------------------------------------
void pqTFCAdvice::computeSplits()
{
  const QString text = this->Document->state();
  const QJsonObject state = QJsonDocument::fromJson(text.toUtf8()).object();
  QJsonArray needed = { state["primary"], state["secondary"] };
  for (const QJsonValue value : state["regions"].toArray())
  {
    const QJsonObject region = value.toObject();
    needed.append(
      QJsonArray{ region["id"], region["visible"], region["shape"], region["falloff"] });
  }
  const QByteArray key = QJsonDocument(needed).toJson(QJsonDocument::Compact);
  if (key == this->SplitsState)
  {
    return;
  }
  SCOPED_UNDO_EXCLUDE();
  this->SplitsState = key;
  this->Splits.clear();
  if (!this->SplitFilter)
  {
    this->SplitFilter = this->makeFilter("RegionSplit");
  }
  if (!this->SplitFilter || !this->hasMoreThanAxes() || state["regions"].toArray().isEmpty())
  {
    return;
  }
  vtkSMPropertyHelper(this->SplitFilter, "TransferFunction").Set(text.toUtf8().constData());
  const auto table = this->gather(this->SplitFilter);
  for (int row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (table->GetNumber("rank", row) > 0)
    {
      this->Splits.push_back({ static_cast<int>(table->GetNumber("region", row)),
        QString::fromStdString(table->GetText("attribute", row)), table->GetNumber("power", row),
        table->GetNumber("cut", row), table->GetNumber("below", row),
        QString::fromStdString(table->GetText("keep_above", row)),
        QString::fromStdString(table->GetText("keep_below", row)) });
    }
  }
}

//-----------------------------------------------------------------------------
std::vector<pqTFCAdvice::Split> pqTFCAdvice::splits(int region)
{
  this->computeSplits();
  std::vector<Split> splits;
  std::copy_if(this->Splits.begin(), this->Splits.end(), std::back_inserter(splits),
    [region](const Split& split) { return split.Region == region; });
  return splits;
}

//-----------------------------------------------------------------------------
void pqTFCAdvice::apply(int region, const QString& tertiary)
{
  const QJsonObject function = QJsonDocument::fromJson(tertiary.toUtf8()).object();
  QJsonObject state = QJsonDocument::fromJson(this->Document->state().toUtf8()).object();
  QJsonArray regions;
  for (const QJsonValue value : state["regions"].toArray())
  {
    QJsonObject object = value.toObject();
    if (object["id"].toInt() == region && !function.isEmpty())
    {
      object["tertiary"] = function;
    }
    regions.append(object);
  }
  state["regions"] = regions;
  state.remove("x-proposal");
  this->Document->replace(tr("Follow advice"),
    QString::fromUtf8(QJsonDocument(state).toJson(QJsonDocument::Compact)));
}
