// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCHistogramCache.h"

#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkPVSession.h"
#include "vtkSMInputProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkTFCHistogramInformation.h"
#include "vtkTFCSparseHistogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace
{
// A plane of 256 x 256 is finer than the chart. With a third axis there are more cells to send and
// to sum over while a region is dragged, so it is coarser.
constexpr int PLANE_BINS = 256;
constexpr int JOINT_BINS = 128;
constexpr int TERTIARY_BINS = 64;
constexpr int FINE_BINS = 4096;
constexpr size_t MOST_ENTRIES = 12;
constexpr int DELAY = 150; // ms: after the view was drawn
constexpr int PAUSE = 10;  // ms: between two, for events
constexpr int MOST_AT_ONCE = 8;

// Bins of whole numbers hold equally many of them, where a number of bins near the wanted one
// allows that: otherwise the histogram has stripes.
int BinsOf(const pqTFCAxis& axis, int wanted)
{
  const double size = axis.Range[1] - axis.Range[0];
  for (double width = std::ceil(size / wanted);
       axis.Integral && size > wanted && width <= 3 * size / wanted; ++width)
  {
    if (std::fmod(size, width) == 0)
    {
      return std::max(1, static_cast<int>(size / width));
    }
  }
  return wanted;
}

void SetAxis(vtkSMProxy* filter, int axis, const pqTFCAxis& values, int bins)
{
  static const std::array<std::string, 3> names = { { "Primary", "Secondary", "Tertiary" } };
  const std::string& name = names[axis];
  vtkSMPropertyHelper array(filter, name.c_str());
  array.Set(0, std::to_string(axis).c_str());
  array.Set(1, values.Array.c_str());
  array.Set(2, std::to_string(values.Component).c_str());
  vtkSMPropertyHelper range(filter, (name + "Range").c_str());
  range.Set(0, std::to_string(axis).c_str());
  // 17 digits: the server must count in the very bins that the client asks for.
  range.Set(1, QString::number(values.Range[0], 'g', 17).toUtf8().constData());
  range.Set(2, QString::number(values.Range[1], 'g', 17).toUtf8().constData());
  vtkSMPropertyHelper count(filter, (name + "Bins").c_str());
  count.Set(0, axis);
  count.Set(1, BinsOf(values, bins));
}
}

//-----------------------------------------------------------------------------
bool pqTFCAxis::operator<(const pqTFCAxis& other) const
{
  return std::tie(this->Array, this->Component, this->Range[0], this->Range[1]) <
    std::tie(other.Array, other.Component, other.Range[0], other.Range[1]);
}

//-----------------------------------------------------------------------------
pqTFCHistogramCache::pqTFCHistogramCache(QObject* parentObject)
  : Superclass(parentObject)
{
  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqTFCHistogramCache::fetch);
  // The hidden filter must not keep alive what the user deletes.
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::preServerRemoved, this,
    [this](pqServer*) { this->clear(); });
  QObject::connect(model, &pqServerManagerModel::preSourceRemoved, this,
    [this](pqPipelineSource* source)
    {
      if (this->Port && this->Port->getSource() == source)
      {
        this->clear();
      }
    });
}

//-----------------------------------------------------------------------------
pqTFCHistogramCache::~pqTFCHistogramCache() = default;

//-----------------------------------------------------------------------------
void pqTFCHistogramCache::clear()
{
  this->Timer.stop();
  this->Entries.clear();
  this->Wanted.clear();
  this->Port = nullptr;
  if (this->Filter)
  {
    SCOPED_UNDO_EXCLUDE();
    this->Filter = nullptr;
  }
}

//-----------------------------------------------------------------------------
void pqTFCHistogramCache::setInput(pqOutputPort* port, double time)
{
  if (port != this->Port)
  {
    this->clear();
    this->Port = port;
  }
  if (time != this->Time)
  {
    this->Time = time;
    this->setStale();
  }
}

//-----------------------------------------------------------------------------
void pqTFCHistogramCache::setStale()
{
  for (auto& entry : this->Entries)
  {
    entry.second.Stale = true;
  }
  if (this->Timer.isActive())
  {
    // An animation: not before it rests.
    this->Timer.start(DELAY);
  }
}

//-----------------------------------------------------------------------------
bool pqTFCHistogramCache::isWanted(const Key& key) const
{
  return std::any_of(this->Wanted.begin(), this->Wanted.end(),
    [&key](const Key& other) { return !(key < other) && !(other < key); });
}

//-----------------------------------------------------------------------------
vtkTFCSparseHistogram* pqTFCHistogramCache::request(const Key& key)
{
  if (!this->Port)
  {
    return nullptr;
  }
  const auto found = this->Entries.find(key);
  if (found == this->Entries.end() || found->second.Stale)
  {
    if (!this->isWanted(key))
    {
      this->Wanted.push_back(key);
    }
    if (!this->Paused && !this->Timer.isActive())
    {
      this->Timer.start(DELAY);
    }
  }
  if (found == this->Entries.end())
  {
    return nullptr;
  }
  found->second.LastUse = ++this->Uses;
  return found->second.Histogram;
}

//-----------------------------------------------------------------------------
void pqTFCHistogramCache::setPaused(bool paused)
{
  this->Paused = paused;
  if (paused)
  {
    this->Timer.stop();
  }
  else if (!this->Wanted.empty())
  {
    this->Timer.start(DELAY);
  }
}

//-----------------------------------------------------------------------------
void pqTFCHistogramCache::fetchNow()
{
  // What arrives may make others wanted.
  for (int i = 0; i < MOST_AT_ONCE && !this->Wanted.empty() && !this->Paused; ++i)
  {
    this->fetch();
  }
}

//-----------------------------------------------------------------------------
vtkSmartPointer<vtkTFCSparseHistogram> pqTFCHistogramCache::compute(const Key& key)
{
  const int bins = key[2].Array.empty() ? PLANE_BINS : JOINT_BINS;
  return this->compute(key, bins, bins);
}

//-----------------------------------------------------------------------------
std::vector<double> pqTFCHistogramCache::distribution(const pqTFCAxis& axis)
{
  // Against itself in one bin: nothing else plays a part.
  vtkSmartPointer<vtkTFCSparseHistogram> histogram =
    this->Port ? this->compute({ axis, axis, pqTFCAxis() }, FINE_BINS, 1) : nullptr;
  std::vector<double> counts;
  if (histogram)
  {
    counts.resize(
      static_cast<size_t>(histogram->GetNumberOfBins(0)) * histogram->GetNumberOfBins(1));
    histogram->GetPlane(counts.data());
  }
  return counts;
}

//-----------------------------------------------------------------------------
vtkSmartPointer<vtkTFCSparseHistogram> pqTFCHistogramCache::compute(const Key& key, int primaryBins,
  int secondaryBins)
{
  // Helper proxies would make undo steps of their own.
  SCOPED_UNDO_EXCLUDE();
  if (!this->Filter)
  {
    vtkSMSessionProxyManager* manager = this->Port->getServer()->proxyManager();
    this->Filter.TakeReference(
      vtkSMSourceProxy::SafeDownCast(manager->NewProxy("internal_filters", "TFCJointHistogram")));
    if (!this->Filter)
    {
      return nullptr;
    }
    vtkSMPropertyHelper(this->Filter, "Input")
      .Set(this->Port->getSource()->getProxy(), this->Port->getPortNumber());
  }
  SetAxis(this->Filter, 0, key[0], primaryBins);
  SetAxis(this->Filter, 1, key[1], secondaryBins);
  SetAxis(this->Filter, 2, key[2], TERTIARY_BINS);
  this->Filter->UpdateVTKObjects();
  this->Filter->UpdatePipeline(this->Time);
  vtkNew<vtkTFCHistogramInformation> information;
  // Its result says nothing: GatherInformation() returns false in any case (ParaView 5.11,
  // vtkSMSessionClient.cxx:908).
  this->Filter->GatherInformation(information, vtkPVSession::DATA_SERVER);
  return information->GetHistogram();
}

//-----------------------------------------------------------------------------
void pqTFCHistogramCache::fetch()
{
  this->Timer.stop();
  if (!this->Port || this->Paused || this->Wanted.empty())
  {
    return;
  }
  const Key key = this->Wanted.front();
  this->Wanted.erase(this->Wanted.begin());
  if (vtkSmartPointer<vtkTFCSparseHistogram> histogram = this->compute(key))
  {
    this->Entries[key] = { histogram, false, ++this->Uses };
  }
  while (this->Entries.size() > MOST_ENTRIES)
  {
    this->Entries.erase(std::min_element(this->Entries.begin(), this->Entries.end(),
      [](const auto& a, const auto& b) { return a.second.LastUse < b.second.LastUse; }));
  }
  if (!this->Wanted.empty())
  {
    this->Timer.start(PAUSE);
  }
  Q_EMIT this->arrived();
}
