// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCQuantiles.h"

#include "vtkTFCJsonFields.h"
#include "vtkTFCState.h"
#include "vtkTFCTransferFunction.h"

#include <algorithm>
#include <numeric>

namespace
{
constexpr const char* KEY = "x-quantiles";
constexpr size_t MOST = 1025; ///< values of one attribute that are read
using Json = vtkTFCJsonFields::Json;

//------------------------------------------------------------------------------
bool ReadEntry(const Json& object, vtkTFCQuantiles::Entry& entry)
{
  const auto array = object.find("array");
  const auto component = object.find("component");
  const auto values = object.find("values");
  if (array == object.end() || !array->is_string() || component == object.end() ||
    !component->is_number_integer() || values == object.end() || !values->is_array() ||
    values->size() < 2 || values->size() > MOST)
  {
    return false;
  }
  entry.Array = array->get<std::string>();
  entry.Component = component->get<int>();
  for (const Json& value : *values)
  {
    if (!value.is_number() || !vtkTFCIsNumber(value.get<double>()))
    {
      return false;
    }
    entry.Values.push_back(value.get<double>());
  }
  return std::is_sorted(entry.Values.begin(), entry.Values.end());
}
}

//------------------------------------------------------------------------------
vtkTFCValueMap::vtkTFCValueMap(const std::vector<double>& from, const std::vector<double>& to)
{
  if (from.size() != to.size() || from.size() < 2 || !(from.front() < from.back()) || from == to)
  {
    return;
  }
  for (size_t i = 0; i < from.size();)
  {
    size_t last = i;
    while (last + 1 < from.size() && from[last + 1] == from[i])
    {
      ++last;
    }
    this->From.push_back(from[i]);
    // The ends stay the ends.
    this->To.push_back(i == 0     ? to.front()
        : last + 1 == from.size() ? to.back()
                                  : to[i] + (to[last] - to[i]) / 2);
    i = last + 1;
  }
}

//------------------------------------------------------------------------------
double vtkTFCValueMap::operator()(double value) const
{
  if (this->IsIdentity())
  {
    return value;
  }
  const auto& x = this->From;
  const auto& y = this->To;
  const double slope = (y.back() - y.front()) / (x.back() - x.front());
  if (!(value >= x.front()))
  {
    return y.front() + (value - x.front()) * slope;
  }
  if (value >= x.back())
  {
    return y.back() + (value - x.back()) * slope;
  }
  const size_t i = std::upper_bound(x.begin(), x.end(), value) - x.begin() - 1;
  return y[i] + (value - x[i]) / (x[i + 1] - x[i]) * (y[i + 1] - y[i]);
}

//------------------------------------------------------------------------------
std::vector<double> vtkTFCQuantiles::FromCounts(const std::vector<double>& counts, double low,
  double high, int number)
{
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  if (!(low < high) || !(total > 0) || number < 2)
  {
    return {};
  }
  std::vector<double> quantiles = { low };
  const double width = (high - low) / static_cast<double>(counts.size());
  double below = 0; // samples in the bins before this one
  size_t bin = 0;
  for (int k = 1; k < number - 1; ++k)
  {
    const double wanted = total * k / (number - 1);
    while (bin + 1 < counts.size() && below + counts[bin] < wanted)
    {
      below += counts[bin];
      ++bin;
    }
    const double part = counts[bin] > 0 ? std::min(1.0, (wanted - below) / counts[bin]) : 0;
    quantiles.push_back(std::min(high, low + (static_cast<double>(bin) + part) * width));
  }
  quantiles.push_back(high);
  return quantiles;
}

//------------------------------------------------------------------------------
std::vector<vtkTFCQuantiles::Entry> vtkTFCQuantiles::Load(const vtkTFCTransferFunction* model)
{
  std::vector<Entry> entries;
  // What the model keeps is valid JSON.
  const std::string text = model->GetNote(KEY);
  const Json list = text.empty() ? Json() : Json::parse(text);
  for (size_t i = 0; list.is_array() && i < list.size(); ++i)
  {
    Entry entry;
    if (list[i].is_object() && ReadEntry(list[i], entry))
    {
      entries.push_back(entry);
    }
  }
  return entries;
}

//------------------------------------------------------------------------------
void vtkTFCQuantiles::Store(vtkTFCTransferFunction* model, const std::vector<Entry>& entries)
{
  std::string text;
  for (const Entry& entry : entries)
  {
    text += (text.empty() ? "[" : ",\n  ") + std::string("{\"array\": ") +
      Json(entry.Array).dump(-1, ' ', false, Json::error_handler_t::replace) +
      ", \"component\": " + std::to_string(entry.Component) + ", \"values\": [";
    for (size_t i = 0; i < entry.Values.size(); ++i)
    {
      text += (i > 0 ? ", " : "") + vtkTFCNumberText(entry.Values[i]);
    }
    text += "]}";
  }
  model->SetNote(KEY, text.empty() ? text : text + "]");
}

//------------------------------------------------------------------------------
std::vector<double> vtkTFCQuantiles::Find(const std::vector<Entry>& entries,
  const std::string& array, int component)
{
  for (const Entry& entry : entries)
  {
    if (entry.Array == array && entry.Component == component)
    {
      return entry.Values;
    }
  }
  return {};
}
