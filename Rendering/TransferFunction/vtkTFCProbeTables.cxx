// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCProbeTables.h"

#include "vtkTFCClassifier.h"
#include "vtkTFCRaySampler.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <string>

namespace
{

using Point = std::array<double, 3>;

//------------------------------------------------------------------------------
void AddNumber(vtkTable* table, const std::string& name, double value)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

//------------------------------------------------------------------------------
void AddInteger(vtkTable* table, const std::string& name, int value)
{
  vtkNew<vtkIntArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

//------------------------------------------------------------------------------
// All numeric arrays of the attributes' kind at a place.
void AddArrays(vtkTable* table, const vtkTFCRaySampler& sampler, const Point& point)
{
  vtkDataSetAttributes* data =
    sampler.GetImage()->GetAttributes(sampler.GetReader().GetAssociation());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (!array || !array->GetName() ||
      array == data->GetArray(vtkDataSetAttributes::GhostArrayName()))
    {
      continue;
    }
    const std::vector<double> values = sampler.SampleArray(array, point);
    for (size_t c = 0; c < values.size(); ++c)
    {
      const std::string name = array->GetName();
      AddNumber(table, values.size() > 1 ? name + "_" + std::to_string(c) : name, values[c]);
    }
  }
}

}

//------------------------------------------------------------------------------
void vtkTFCProbeTables::FillLocation(vtkTable* table, const vtkTFCRaySampler& sampler,
  const Location& location)
{
  const char* const names[] = { "x", "y", "z", "i", "j", "k", "red", "green", "blue", "alpha" };
  for (int axis = 0; axis < 3; ++axis)
  {
    AddNumber(table, names[axis], location.Place[axis]);
  }
  AddNumber(table, "distance", location.Distance);
  const auto voxel = sampler.FindVoxel(location.Place);
  for (int axis = 0; axis < 3; ++axis)
  {
    AddInteger(table, names[3 + axis], voxel[axis]);
  }
  AddInteger(table, "block", location.Block);
  AddInteger(table, "reached", location.Reached ? 1 : 0);
  AddNumber(table, "opacity", location.Opacity);
  AddNumber(table, "total_opacity", location.TotalOpacity);
  for (int channel = 0; channel < 4; ++channel)
  {
    AddNumber(table, names[6 + channel], location.Color[channel]);
  }
  AddNumber(table, "primary", location.Axes[0]);
  AddNumber(table, "secondary", location.Axes[1]);
  AddArrays(table, sampler, location.Place);
}

//------------------------------------------------------------------------------
// What each region makes of a sample.
void vtkTFCProbeTables::FillRegions(vtkTable* table, const vtkTFCClassifier& classifier,
  const vtkTFCTransferFunction* names, const std::vector<double>& values)
{
  const vtkTFCCompiledModel& model = classifier.GetModel();
  vtkNew<vtkIntArray> id;
  id->SetName("id");
  vtkNew<vtkStringArray> name;
  name->SetName("name");
  std::array<vtkNew<vtkDoubleArray>, 4> columns;
  const char* const titles[] = { "weight", "tertiary", "opacity", "contribution" };
  for (int c = 0; c < 4; ++c)
  {
    columns[c]->SetName(titles[c]);
  }
  double axes[2];
  bool inside = true;
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto& range = model.Range[axis];
    axes[axis] = (values[axis] - range[0]) / (range[1] - range[0]);
    inside = inside && axes[axis] >= 0.0 && axes[axis] <= 1.0;
  }
  std::vector<double> shares;
  double transparency = 1.0;
  double sum = 0.0;
  for (const vtkTFCCompiledRegion& region : model.Regions)
  {
    const double weight = inside ? vtkTFCClassifier::RegionWeight(region, axes[0], axes[1]) : 0.0;
    const double tertiary = region.Tertiary < 0
      ? 1.0
      : vtkTFCClassifier::TertiaryOpacity(region, values[region.Tertiary]);
    const double opacity = region.Opacity * weight * tertiary;
    shares.push_back(model.Blend == vtkTFCBlendType::Over ? transparency * opacity : opacity);
    transparency *= 1.0 - opacity;
    sum += shares.back();
    id->InsertNextValue(region.Id);
    const vtkTFCRegion* named = names->GetRegionById(region.Id);
    name->InsertNextValue(named ? named->GetName() : std::string());
    columns[0]->InsertNextValue(weight);
    columns[1]->InsertNextValue(tertiary);
    columns[2]->InsertNextValue(opacity);
  }
  for (const double share : shares)
  {
    columns[3]->InsertNextValue(sum > 0.0 ? share / sum : 0.0);
  }
  table->AddColumn(id);
  table->AddColumn(name);
  for (const auto& column : columns)
  {
    table->AddColumn(column);
  }
}
