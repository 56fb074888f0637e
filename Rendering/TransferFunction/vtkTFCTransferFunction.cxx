// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTransferFunction.h"

#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"
#include "vtkTFCState.h"

#include <algorithm>
#include <cmath>
#include <set>

vtkStandardNewMacro(vtkTFCTransferFunction);

namespace
{
constexpr const char* PROPOSAL = "x-proposal";
}

struct vtkTFCTransferFunction::Internals
{
  vtkTFCState Values; ///< its Regions are unused: the objects below hold them
  std::vector<vtkSmartPointer<vtkTFCRegion>> Regions;
  int LargestId = 0; ///< ever used, so that a removed region's id does not come back
  vtkTFCPoleCache Poles;
};

//------------------------------------------------------------------------------
vtkTFCTransferFunction::vtkTFCTransferFunction()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkTFCTransferFunction::~vtkTFCTransferFunction() = default;

//------------------------------------------------------------------------------
vtkMTimeType vtkTFCTransferFunction::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& region : this->Internal->Regions)
  {
    time = std::max(time, region->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
vtkTFCState vtkTFCTransferFunction::CollectState() const
{
  vtkTFCState state = this->Internal->Values;
  for (const auto& region : this->Internal->Regions)
  {
    state.Regions.push_back(region->GetValues());
  }
  return state;
}

//------------------------------------------------------------------------------
bool vtkTFCTransferFunction::SetState(const char* json)
{
  vtkTFCState state;
  std::string error;
  if (!vtkTFCReadState(json ? json : "", state, error))
  {
    this->LastError = error;
    vtkErrorMacro("The transfer function was not changed. " << error);
    return false;
  }
  this->LastError.clear();
  if (state == this->CollectState())
  {
    return true;
  }

  std::vector<vtkSmartPointer<vtkTFCRegion>> regions;
  for (const vtkTFCRegionState& values : state.Regions)
  {
    vtkSmartPointer<vtkTFCRegion> region = this->GetRegionById(values.Id);
    if (!region)
    {
      region = vtkSmartPointer<vtkTFCRegion>::New();
    }
    region->SetValues(values);
    regions.push_back(region);
    this->Internal->LargestId = std::max(this->Internal->LargestId, values.Id);
  }
  state.Regions.clear();
  // Without this test, an edit of one region would count as an edit of the axes too.
  if (regions != this->Internal->Regions || !(state == this->Internal->Values))
  {
    this->Internal->Regions = std::move(regions);
    this->Internal->Values = std::move(state);
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkTFCTransferFunction::GetState() const
{
  return vtkTFCWriteState(this->CollectState());
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::SetProposal(bool proposal)
{
  if (proposal != this->GetProposal())
  {
    this->SetNote(PROPOSAL, proposal ? "true" : "");
  }
}

//------------------------------------------------------------------------------
bool vtkTFCTransferFunction::GetProposal() const
{
  return this->GetNote(PROPOSAL) == "true";
}

//------------------------------------------------------------------------------
bool vtkTFCTransferFunction::SetNote(const char* key, const std::string& json)
{
  const std::string name = key ? key : "";
  // Through the reader of states, so that its limits hold and what is written can be read.
  vtkTFCState state;
  std::string error;
  if (name.compare(0, 2, "x-") != 0 || name.find_first_of("\"\\") != std::string::npos ||
    (!json.empty() &&
      (!vtkTFCReadState("{\"format\": \"transfer-function-combination\", \"version\": 1, \"" +
           name + "\": " + json + "}",
         state, error) ||
        state.Extras.size() != 1)))
  {
    vtkErrorMacro("Expected a key that starts with x- and JSON, got \"" << name << "\". " << error);
    return false;
  }
  const std::string text = json.empty() ? "" : state.Extras.begin()->second;
  if (text != this->GetNote(name.c_str()))
  {
    vtkTFCExtras& extras = this->Internal->Values.Extras;
    if (text.empty())
    {
      extras.erase(name);
    }
    else
    {
      extras[name] = text;
    }
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkTFCTransferFunction::GetNote(const char* key) const
{
  const vtkTFCExtras& extras = this->Internal->Values.Extras;
  const auto note = extras.find(key ? key : "");
  return note == extras.end() ? std::string() : note->second;
}

//------------------------------------------------------------------------------
bool vtkTFCTransferFunction::CheckAxis(int axis) const
{
  if (axis != Primary && axis != Secondary)
  {
    vtkErrorMacro("Expected axis 0 (primary) or 1 (secondary), got " << axis);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::SetAxis(int axis, const char* array, int component)
{
  if (!this->CheckAxis(axis))
  {
    return;
  }
  if (component < -1 || component > vtkTFCLimits::Component)
  {
    vtkErrorMacro("Expected a component index (-1: vector magnitude), got " << component);
    return;
  }
  vtkTFCAxisState values = this->Internal->Values.Axes[axis];
  values.Set = array && *array;
  if (values.Set)
  {
    values.Attribute.Array = array;
    values.Attribute.Component = component;
  }
  else
  {
    values = vtkTFCAxisState();
  }
  if (!(values == this->Internal->Values.Axes[axis]))
  {
    this->Internal->Values.Axes[axis] = values;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const std::string& vtkTFCTransferFunction::GetAxisArray(int axis) const
{
  return this->Internal->Values.Axes[axis == Secondary ? 1 : 0].Attribute.Array;
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunction::GetAxisComponent(int axis) const
{
  return this->Internal->Values.Axes[axis == Secondary ? 1 : 0].Attribute.Component;
}

//------------------------------------------------------------------------------
bool vtkTFCTransferFunction::HasAxes() const
{
  return this->Internal->Values.Axes[0].Set && this->Internal->Values.Axes[1].Set;
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::SetAxisRange(int axis, double low, double high)
{
  if (!this->CheckAxis(axis))
  {
    return;
  }
  vtkTFCAxisState& values = this->Internal->Values.Axes[axis];
  if (!values.Set)
  {
    vtkErrorMacro("Set the array of the axis before its range.");
    return;
  }
  if (!(low < high) || !vtkTFCIsNumber(low) || !vtkTFCIsNumber(high))
  {
    vtkErrorMacro("range: expected low < high, got " << low << ", " << high);
    return;
  }
  const std::array<double, 2> range = { { low, high } };
  if (!values.HasRange || values.Range != range)
  {
    values.HasRange = true;
    values.Range = range;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::ClearAxisRange(int axis)
{
  if (this->CheckAxis(axis) && this->Internal->Values.Axes[axis].HasRange)
  {
    this->Internal->Values.Axes[axis].HasRange = false;
    this->Internal->Values.Axes[axis].Range = { { 0, 1 } };
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkTFCTransferFunction::HasAxisRange(int axis) const
{
  return this->CheckAxis(axis) && this->Internal->Values.Axes[axis].HasRange;
}

//------------------------------------------------------------------------------
bool vtkTFCTransferFunction::GetAxisRange(int axis, double range[2]) const
{
  if (!this->CheckAxis(axis))
  {
    return false;
  }
  std::copy_n(this->Internal->Values.Axes[axis].Range.begin(), 2, range);
  return this->Internal->Values.Axes[axis].HasRange;
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::ResolveRanges(const double primary[2], const double secondary[2],
  double used[4]) const
{
  const std::array<const double*, 2> data = { { primary, secondary } };
  for (int axis = 0; axis < 2; ++axis)
  {
    double* range = used + 2 * axis;
    const double* extent = data[axis];
    if (this->GetAxisRange(axis, range))
    {
      continue;
    }
    // Ranges beyond the limit could not be written as a state, and their width would overflow.
    const bool known =
      extent && vtkTFCIsNumber(extent[0]) && vtkTFCIsNumber(extent[1]) && extent[0] <= extent[1];
    range[0] = known ? extent[0] : 0.0;
    range[1] = known ? extent[1] : 1.0;
    if (range[0] == range[1])
    {
      const double half = std::max(0.5, 0.5 * std::abs(range[0]));
      range[0] -= half;
      range[1] += half;
    }
  }
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::SetBlend(int blend)
{
  if (blend != Mix && blend != Over)
  {
    vtkErrorMacro("blend: expected 0 (mix) or 1 (over), got " << blend);
    return;
  }
  const auto type = static_cast<vtkTFCBlendType>(blend);
  if (type != this->Internal->Values.Blend)
  {
    this->Internal->Values.Blend = type;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunction::GetBlend() const
{
  return static_cast<int>(this->Internal->Values.Blend);
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunction::GetNumberOfRegions() const
{
  return static_cast<int>(this->Internal->Regions.size());
}

//------------------------------------------------------------------------------
vtkTFCRegion* vtkTFCTransferFunction::GetRegion(int index) const
{
  return index >= 0 && index < this->GetNumberOfRegions() ? this->Internal->Regions[index].Get()
                                                          : nullptr;
}

//------------------------------------------------------------------------------
vtkTFCRegion* vtkTFCTransferFunction::GetRegionById(int id) const
{
  for (const auto& region : this->Internal->Regions)
  {
    if (region->GetId() == id)
    {
      return region;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunction::NewId()
{
  int& largest = this->Internal->LargestId;
  if (largest < vtkTFCLimits::Id)
  {
    return ++largest;
  }
  // A state used the very last id: take the smallest free one.
  int id = 1;
  while (this->GetRegionById(id))
  {
    ++id;
  }
  return id;
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunction::AddRegion(vtkTFCRegion* region)
{
  if (!region || region->GetId() != 0 || this->Internal->Regions.size() >= vtkTFCLimits::Regions)
  {
    vtkErrorMacro("Expected a region that is in no transfer function, and at most "
      << vtkTFCLimits::Regions << " regions.");
    return 0;
  }
  vtkTFCRegionState values = region->GetValues();
  values.Id = this->NewId();
  if (values.Name.empty())
  {
    values.Name = "region " + std::to_string(values.Id);
  }
  region->SetValues(values);
  this->Internal->Regions.emplace_back(region);
  this->Modified();
  return values.Id;
}

//------------------------------------------------------------------------------
vtkTFCRegion* vtkTFCTransferFunction::AddNewRegion(const char* shapeType)
{
  const auto shape = vtkSmartPointer<vtkTFCShape>::Take(vtkTFCShape::NewShape(shapeType));
  if (!shape)
  {
    vtkErrorMacro("Expected one of ellipse, rectangle, triangle, polygon, got "
      << (shapeType ? shapeType : "nothing"));
    return nullptr;
  }
  const auto region = vtkSmartPointer<vtkTFCRegion>::New();
  region->SetShape(shape);
  return this->AddRegion(region) ? this->Internal->Regions.back().Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::RemoveRegion(vtkTFCRegion* region)
{
  auto& regions = this->Internal->Regions;
  const auto found = std::find(regions.begin(), regions.end(), region);
  if (found != regions.end())
  {
    regions.erase(found);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::RemoveAllRegions()
{
  if (!this->Internal->Regions.empty())
  {
    this->Internal->Regions.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::MoveRegion(int from, int to)
{
  auto& regions = this->Internal->Regions;
  if (!this->GetRegion(from) || !this->GetRegion(to) || from == to)
  {
    return;
  }
  if (from < to)
  {
    std::rotate(regions.begin() + from, regions.begin() + from + 1, regions.begin() + to + 1);
  }
  else
  {
    std::rotate(regions.begin() + to, regions.begin() + from, regions.begin() + from + 1);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
std::vector<vtkTFCAttribute> vtkTFCTransferFunction::GetAttributes() const
{
  return vtkTFCCollectAttributes(this->CollectState());
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::SetHighlightedRegion(int id)
{
  if (id != this->HighlightedRegion)
  {
    this->HighlightedRegion = id;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTFCCompiledModel vtkTFCTransferFunction::Compile(const double used[4]) const
{
  vtkTFCCompiledModel model = vtkTFCCompileState(this->CollectState(),
    { { { { used[0], used[1] } }, { { used[2], used[3] } } } }, &this->Internal->Poles);
  const auto isHighlighted = [this](const vtkTFCCompiledRegion& region)
  { return region.Id == this->HighlightedRegion; };
  if (std::any_of(model.Regions.begin(), model.Regions.end(), isHighlighted))
  {
    for (vtkTFCCompiledRegion& region : model.Regions)
    {
      region.Opacity *= isHighlighted(region) ? 1.0 : HighlightDimming;
    }
  }
  return model;
}

//------------------------------------------------------------------------------
vtkTFCCompiledModel vtkTFCTransferFunction::Compile() const
{
  double used[4];
  this->ResolveRanges(nullptr, nullptr, used);
  return this->Compile(used);
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "State: " << this->GetState();
  os << indent << "HighlightedRegion: " << this->HighlightedRegion << "\n";
  os << indent << "LastError: " << this->LastError << "\n";
}
