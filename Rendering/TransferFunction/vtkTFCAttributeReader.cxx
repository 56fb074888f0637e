// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributeReader.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkTFCSamples.h"
#include "vtkTFCThreads.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

namespace
{
//------------------------------------------------------------------------------
std::string Quoted(const std::string& name)
{
  return "'" + name + "'";
}
}

//------------------------------------------------------------------------------
bool vtkTFCAttributeReader::Bind(vtkDataSet* data, const std::vector<vtkTFCAttribute>& attributes,
  std::string& error)
{
  *this = vtkTFCAttributeReader();
  const std::array<vtkDataSetAttributes*, 2> kinds = { { data->GetPointData(),
    data->GetCellData() } };
  const std::array<const char*, 2> words = { { "point", "cell" } };
  const auto has = [&](int kind, const vtkTFCAttribute& attribute)
  { return kinds[kind]->GetArray(attribute.Array.c_str()) != nullptr; };

  int kind = -1;
  for (int k = 1; k >= 0; --k)
  {
    const bool all = std::all_of(attributes.begin(), attributes.end(),
      [&](const vtkTFCAttribute& attribute) { return has(k, attribute); });
    kind = all ? k : kind;
  }
  if (kind < 0)
  {
    for (const vtkTFCAttribute& attribute : attributes)
    {
      if (!has(0, attribute) && !has(1, attribute))
      {
        error = "There is no array " + Quoted(attribute.Array) +
          " in the data. Point arrays: " + vtkTFCSamples::ListArrays(kinds[0]) +
          "; cell arrays: " + vtkTFCSamples::ListArrays(kinds[1]) +
          ". Compute it, or choose one of these in the transfer function.";
        return false;
      }
    }
    error = "All attributes of a transfer function must be point arrays, or all cell arrays:";
    for (const vtkTFCAttribute& attribute : attributes)
    {
      const int k = has(0, attribute) ? 0 : 1;
      error += " " + Quoted(attribute.Array) + " is a " + words[k] + " array (" +
        std::to_string(kinds[k]->GetArray(attribute.Array.c_str())->GetNumberOfTuples()) +
        " values);";
    }
    error += " convert with Cell Data to Point Data or Point Data to Cell Data.";
    return false;
  }

  const vtkIdType expected = kind == 0 ? data->GetNumberOfPoints() : data->GetNumberOfCells();
  std::vector<Source> sources;
  for (const vtkTFCAttribute& attribute : attributes)
  {
    vtkDataArray* array = kinds[kind]->GetArray(attribute.Array.c_str());
    const int components = array->GetNumberOfComponents();
    if (attribute.Component < -1 || attribute.Component >= components)
    {
      error = "Component " + std::to_string(attribute.Component) + " of the array " +
        Quoted(attribute.Array) + " does not exist: it has " + std::to_string(components) +
        (components == 1 ? " component" : " components") + ", counted from 0; -1 is the magnitude.";
      return false;
    }
    if (array->GetNumberOfTuples() != expected)
    {
      error = "The array " + Quoted(attribute.Array) + " has " +
        std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(expected) +
        " " + words[kind] + "s.";
      return false;
    }
    sources.push_back({ array, attribute.Component });
  }

  this->Sources = std::move(sources);
  this->Association = kind == 0 ? vtkDataObject::POINT : vtkDataObject::CELL;
  this->NumberOfTuples = expected;
  this->HiddenBit = vtkTFCSamples::GetHiddenBit(this->Association);
  vtkUnsignedCharArray* ghosts = vtkTFCSamples::GetGhosts(kinds[kind]);
  if (ghosts && ghosts->GetNumberOfValues() == expected)
  {
    this->Ghosts = ghosts->GetPointer(0);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCAttributeReader::Read(int attribute, vtkIdType begin, vtkIdType count, double* out) const
{
  const Source& source = this->Sources[attribute];
  vtkTFCSamples::Read(source.Array, source.Component, begin, count, out);
}

//------------------------------------------------------------------------------
void vtkTFCAttributeReader::ReadAll(vtkIdType begin, vtkIdType count, vtkIdType stride,
  double* out) const
{
  for (size_t a = 0; a < this->Sources.size(); ++a)
  {
    this->Read(static_cast<int>(a), begin, count, out + static_cast<vtkIdType>(a) * stride);
  }
  for (vtkIdType i = 0; this->HasHidden() && i < count; ++i)
  {
    out[i] = this->IsHidden(begin + i) ? std::numeric_limits<double>::quiet_NaN() : out[i];
  }
}

//------------------------------------------------------------------------------
void vtkTFCAttributeReader::FiniteRange(int attribute, double range[2]) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity;
  double high = -infinity;
  std::mutex mutex;
  vtkTFCThreads::For(0, this->NumberOfTuples, 65536,
    [&](vtkIdType begin, vtkIdType end)
    {
      constexpr vtkIdType chunk = 1024;
      std::array<double, chunk> values;
      double localLow = infinity;
      double localHigh = -infinity;
      for (vtkIdType first = begin; first < end; first += chunk)
      {
        const vtkIdType count = std::min(chunk, end - first);
        this->Read(attribute, first, count, values.data());
        for (vtkIdType i = 0; i < count; ++i)
        {
          if (std::isfinite(values[i]) && !this->IsHidden(first + i))
          {
            localLow = std::min(localLow, values[i]);
            localHigh = std::max(localHigh, values[i]);
          }
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      low = std::min(low, localLow);
      high = std::max(high, localHigh);
    });
  range[0] = low;
  range[1] = high;
}
