// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributeReader.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
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
// `get(tuple, component)` is inlined, so that each instance is one tight typed loop.
template <typename Get>
void ReadValues(const Get& get, int components, int component, vtkIdType begin, vtkIdType count,
  double* out)
{
  if (component >= 0)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      out[i] = static_cast<double>(get(begin + i, component));
    }
    return;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    double sum = 0;
    for (int c = 0; c < components; ++c)
    {
      const double value = static_cast<double>(get(begin + i, c));
      sum += value * value;
    }
    out[i] = std::sqrt(sum);
  }
}

//------------------------------------------------------------------------------
template <typename T>
void ReadAOS(vtkDataArray* array, int component, vtkIdType begin, vtkIdType count, double* out)
{
  const T* values = static_cast<vtkAOSDataArrayTemplate<T>*>(array)->GetPointer(0);
  const int components = array->GetNumberOfComponents();
  ReadValues([values, components](vtkIdType tuple, int c)
    { return values[tuple * components + c]; },
    components, component, begin, count, out);
}

//------------------------------------------------------------------------------
template <typename T>
void ReadSOA(vtkDataArray* array, int component, vtkIdType begin, vtkIdType count, double* out)
{
  const auto* typed = static_cast<vtkSOADataArrayTemplate<T>*>(array);
  ReadValues([typed](vtkIdType tuple, int c) { return typed->GetTypedComponent(tuple, c); },
    array->GetNumberOfComponents(), component, begin, count, out);
}

//------------------------------------------------------------------------------
// Bit arrays and implicit ones. GetComponent() only reads, for all of VTK's arrays.
void ReadAny(vtkDataArray* array, int component, vtkIdType begin, vtkIdType count, double* out)
{
  ReadValues([array](vtkIdType tuple, int c) { return array->GetComponent(tuple, c); },
    array->GetNumberOfComponents(), component, begin, count, out);
}

//------------------------------------------------------------------------------
std::string ListArrays(vtkDataSetAttributes* data)
{
  std::string list;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array && array->GetName())
    {
      list += (list.empty() ? "" : ", ") + std::string(array->GetName());
    }
  }
  return list.empty() ? "none" : list;
}

//------------------------------------------------------------------------------
std::string Quoted(const std::string& name)
{
  return "'" + name + "'";
}
}

//------------------------------------------------------------------------------
vtkTFCAttributeReader::ReadFunction vtkTFCAttributeReader::FindFunction(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    vtkTemplateMacro(
      if (vtkAOSDataArrayTemplate<VTK_TT>::FastDownCast(array)) return &ReadAOS<VTK_TT>;
      if (vtkSOADataArrayTemplate<VTK_TT>::FastDownCast(array)) return &ReadSOA<VTK_TT>);
    default:
      break;
  }
  return &ReadAny;
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
          " in the data. Point arrays: " + ListArrays(kinds[0]) +
          "; cell arrays: " + ListArrays(kinds[1]) +
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
    sources.push_back({ array, attribute.Component, FindFunction(array) });
  }

  this->Sources = std::move(sources);
  this->Association = kind == 0 ? vtkDataObject::POINT : vtkDataObject::CELL;
  this->NumberOfTuples = expected;
  this->HiddenBit =
    kind == 0 ? int(vtkDataSetAttributes::HIDDENPOINT) : int(vtkDataSetAttributes::HIDDENCELL);
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    kinds[kind]->GetArray(vtkDataSetAttributes::GhostArrayName()));
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
  source.Function(source.Array, source.Component, begin, count, out);
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
