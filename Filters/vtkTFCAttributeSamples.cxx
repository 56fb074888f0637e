// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributeSamples.h"

#include "vtkTFCSamples.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

namespace
{
using Attribute = vtkTFCAttributeSamples::Attribute;
using Request = vtkTFCAttributeSamples::Request;

//------------------------------------------------------------------------------
/**
 * Points or cells, and how messages speak of them.
 */
struct Kind
{
  int Association;
  vtkDataSetAttributes* Arrays;
  vtkIdType Count;
  std::string Word;
};

//------------------------------------------------------------------------------
void Describe(Attribute& attribute)
{
  const int type = attribute.Array->GetDataType();
  attribute.Integer = attribute.Component >= 0 && type != VTK_FLOAT && type != VTK_DOUBLE;
  attribute.Bits = type == VTK_BIT ? 1 : 8 * attribute.Array->GetDataTypeSize();
}

//------------------------------------------------------------------------------
/**
 * The array and component texts of a request. The whole text first: a name may contain a colon.
 */
std::pair<std::string, std::string> Split(const Request& request, vtkDataSetAttributes* arrays)
{
  if (request.Component != Request::FromText)
  {
    return { request.Name,
      request.Component < 0 ? "magnitude" : std::to_string(request.Component) };
  }
  const size_t colon = request.Name.rfind(':');
  if (arrays->HasArray(request.Name.c_str()) || colon == std::string::npos)
  {
    return { request.Name, "" };
  }
  return { request.Name.substr(0, colon), request.Name.substr(colon + 1) };
}

//------------------------------------------------------------------------------
bool Has(const Kind& kind, const Request& request)
{
  return kind.Arrays->HasArray(Split(request, kind.Arrays).first.c_str()) != 0;
}

//------------------------------------------------------------------------------
std::string FindOne(const Kind& kind, const Request& request, Attribute& found)
{
  const auto [name, component] = Split(request, kind.Arrays);
  found.Array = kind.Arrays->GetArray(name.c_str());
  if (!found.Array)
  {
    return "The array '" + name + "' holds text, not numbers. Choose from " +
      vtkTFCSamples::ListArrays(kind.Arrays) + ".";
  }
  const int components = found.Array->GetNumberOfComponents();
  const std::string last = std::to_string(components - 1);
  found.Component = 0;
  if (component == "magnitude")
  {
    found.Component = vtkTFCSamples::Magnitude;
  }
  else if (!component.empty())
  {
    char* end = nullptr;
    const long number = std::strtol(component.c_str(), &end, 10);
    if (*end || number < 0 || number >= components)
    {
      return "The array '" + name + "' has no component '" + component + "'. Use '" + name +
        ":0' to '" + name + ":" + last + "', or '" + name + ":magnitude'.";
    }
    found.Component = static_cast<int>(number);
  }
  else if (components != 1)
  {
    return "The array '" + name + "' has " + std::to_string(components) + " components. Use '" +
      name + ":0' to '" + name + ":" + last + "', or '" + name + ":magnitude'.";
  }
  if (found.Array->GetNumberOfTuples() != kind.Count)
  {
    return "The array '" + name + "' has " + std::to_string(found.Array->GetNumberOfTuples()) +
      " values for " + std::to_string(kind.Count) + " " + kind.Word +
      "s. Remove it, or compute it again on this dataset.";
  }
  found.Label = request.Component == 0 && components == 1 ? name
    : request.Component == Request::FromText              ? request.Name
                                                          : name + ":" + component;
  Describe(found);
  return {};
}

//------------------------------------------------------------------------------
/**
 * All single-component numeric arrays but the ghost array.
 */
std::string FindAll(const Kind& kind, std::vector<Attribute>& found)
{
  for (int i = 0; i < kind.Arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = kind.Arrays->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
      std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) != 0)
    {
      Attribute attribute;
      std::string problem = FindOne(kind, { array->GetName(), 0 }, attribute);
      if (!problem.empty())
      {
        return problem;
      }
      found.push_back(attribute);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
/**
 * Why neither points nor cells have all that is wanted.
 */
std::string ExplainMissing(const Kind& points, const Kind& cells,
  const std::vector<Request>& requests)
{
  for (const Request& request : requests)
  {
    if (!Has(points, request) && !Has(cells, request))
    {
      return "There is no array '" + Split(request, points.Arrays).first +
        "'. Choose from the point arrays " + vtkTFCSamples::ListArrays(points.Arrays) +
        ", or from the cell arrays " + vtkTFCSamples::ListArrays(cells.Arrays) + ".";
    }
  }
  std::string text = "The attributes must be all of points, or all of cells:";
  for (const Request& request : requests)
  {
    text += " '" + request.Name + "' is a " + (Has(points, request) ? "point" : "cell") + " array;";
  }
  return text + " apply the filter Cell Data to Point Data first.";
}
}

//------------------------------------------------------------------------------
std::string vtkTFCAttributeSamples::Find(vtkDataSet* data, const std::vector<Request>& requests,
  std::vector<Attribute>& found, int& association)
{
  found.clear();
  const Kind points{ vtkDataObject::FIELD_ASSOCIATION_POINTS, data->GetPointData(),
    data->GetNumberOfPoints(), "point" };
  const Kind cells{ vtkDataObject::FIELD_ASSOCIATION_CELLS, data->GetCellData(),
    data->GetNumberOfCells(), "cell" };
  for (const Kind& kind : { points, cells })
  {
    association = kind.Association;
    if (requests.empty())
    {
      std::string problem = FindAll(kind, found);
      if (!problem.empty() || !found.empty())
      {
        return problem;
      }
    }
    else if (std::all_of(requests.begin(), requests.end(),
               [&](const Request& request) { return Has(kind, request); }))
    {
      for (const Request& request : requests)
      {
        Attribute attribute;
        std::string problem = FindOne(kind, request, attribute);
        if (!problem.empty())
        {
          return problem;
        }
        found.push_back(attribute);
      }
      return {};
    }
  }
  return requests.empty() ? "The input has no numeric single-component array of points or cells. "
                            "Compute one, or name components of others, such as 'velocity:0'."
                          : ExplainMissing(points, cells, requests);
}

//------------------------------------------------------------------------------
void vtkTFCAttributeSamples::Add(vtkDataSet* data, int association,
  const std::vector<Attribute>& attributes, std::vector<unsigned char> owned,
  const std::vector<double>& fillValues)
{
  Part part;
  part.Attributes = attributes;
  part.Owned = std::move(owned);
  part.Fill = fillValues;
  part.Hidden = vtkTFCSamples::GetHiddenBit(association);
  const bool cells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  part.First = this->GetNumberOfBlocks() * BlockSize;
  part.Count = cells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  auto* ghosts = vtkTFCSamples::GetGhosts(data->GetAttributes(association));
  if (ghosts && ghosts->GetNumberOfValues() == part.Count)
  {
    part.Ghosts = ghosts->GetPointer(0);
  }
  for (const Attribute& attribute : attributes)
  {
    auto* floats = vtkFloatArray::SafeDownCast(attribute.Array);
    const bool plain = floats && floats->GetNumberOfComponents() == 1 && attribute.Component == 0;
    part.Floats.push_back(plain ? floats->GetPointer(0) : nullptr);
  }
  for (const double value : fillValues)
  {
    part.FloatFill.push_back(static_cast<double>(static_cast<float>(value)));
  }
  const vtkIdType blocks = (part.Count + BlockSize - 1) / BlockSize;
  this->PartOfBlock.insert(this->PartOfBlock.end(), static_cast<size_t>(blocks),
    static_cast<std::uint32_t>(this->Parts.size()));
  this->Parts.push_back(std::move(part));
}

//------------------------------------------------------------------------------
void vtkTFCAttributeSamples::ReadRaw(const Part& part, size_t i, vtkIdType first, vtkIdType count,
  double* out)
{
  const Attribute& attribute = part.Attributes[i];
  vtkTFCSamples::Read(attribute.Array, attribute.Component, first, count, out);
}

//------------------------------------------------------------------------------
void vtkTFCAttributeSamples::RemoveOthers(const Part& part, size_t i, vtkIdType first,
  vtkIdType count, double* out)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const bool isFloat = part.Attributes[i].Array->GetDataType() == VTK_FLOAT;
  for (const double fill : isFloat ? part.FloatFill : part.Fill)
  {
    for (vtkIdType s = 0; s < count; ++s)
    {
      out[s] = out[s] == fill ? nan : out[s];
    }
  }
  for (vtkIdType s = 0; part.Ghosts && s < count; ++s)
  {
    out[s] = (part.Ghosts[first + s] & part.Hidden) ? nan : out[s];
  }
  for (vtkIdType s = 0; !part.Owned.empty() && s < count; ++s)
  {
    out[s] = part.Owned[first + s] ? out[s] : nan;
  }
}
