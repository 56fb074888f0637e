// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRegionSplit.h"

#include "vtkTFCAttributeReader.h"
#include "vtkTFCAttributeSamples.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCHistogramSplit.h"
#include "vtkTFCRegion.h"
#include "vtkTFCRegionHistograms.h"
#include "vtkTFCState.h"
#include "vtkTFCTransferFunction.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

vtkStandardNewMacro(vtkTFCRegionSplit);

namespace
{
constexpr int FewestBins = 8;
constexpr int MostBins = 1024;

//------------------------------------------------------------------------------
vtkDataSet* FindFirstBlock(vtkDataObject* input)
{
  const std::vector<vtkDataSet*> blocks = vtkCompositeDataSet::GetDataSets<vtkDataSet>(input);
  const auto found = std::find_if(blocks.begin(), blocks.end(),
    [](vtkDataSet* block) { return block && block->GetNumberOfPoints() > 0; });
  return found == blocks.end() ? nullptr : *found;
}

//------------------------------------------------------------------------------
// The attributes to try: those that were named, or all of the axes' kind; or what is wrong.
std::string FindAttributes(vtkDataSet* block, const std::vector<vtkTFCAttribute>& axes,
  std::vector<std::string> names, std::vector<vtkTFCAttribute>& found)
{
  vtkTFCAttributeReader reader;
  std::string problem;
  if (!reader.Bind(block, axes, problem))
  {
    return problem;
  }
  vtkDataSetAttributes* arrays = block->GetAttributes(reader.GetAssociation());
  const bool all = names.empty();
  for (int i = 0; all && i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
      std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) != 0)
    {
      names.emplace_back(array->GetName());
    }
  }
  for (const std::string& name : names)
  {
    std::vector<vtkTFCAttributeSamples::Attribute> attributes;
    int association;
    // With the axis in front, so that all are of one kind.
    problem = vtkTFCAttributeSamples::Find(block,
      { { axes[0].Array, axes[0].Component }, { name } }, attributes, association);
    if (!problem.empty())
    {
      return problem;
    }
    const vtkTFCAttribute attribute{ attributes[1].Array->GetName(), attributes[1].Component };
    if (std::find(axes.begin(), axes.end(), attribute) == axes.end() &&
      std::find(found.begin(), found.end(), attribute) == found.end())
    {
      found.push_back(attribute);
    }
  }
  return found.empty() ? "There is no attribute to try besides the axes. Compute one, for example "
                         "with the filter Volume Occlusion."
                       : "";
}

//------------------------------------------------------------------------------
// What processes must agree on, as one text, and back.
std::string Describe(const std::vector<vtkTFCAttribute>& attributes)
{
  std::string text;
  for (const vtkTFCAttribute& attribute : attributes)
  {
    text += std::to_string(attribute.Component) + " " + attribute.Array + '\n';
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<vtkTFCAttribute> FromDescription(const std::string& text)
{
  std::vector<vtkTFCAttribute> attributes;
  for (size_t begin = 0; begin < text.size();)
  {
    const size_t space = text.find(' ', begin);
    const size_t end = text.find('\n', begin);
    attributes.push_back(
      { text.substr(space + 1, end - space - 1), std::stoi(text.substr(begin, space - begin)) });
    begin = end + 1;
  }
  return attributes;
}

//------------------------------------------------------------------------------
// One row of the table.
struct Row
{
  int Region;
  std::string RegionName;
  vtkTFCAttribute Attribute;
  vtkTFCRegionHistograms::Conditional Histogram;
  vtkTFCHistogramSplit Split;
  int Rank = 0;

  bool IsCandidate() const { return this->Split.Separability > 0.; }

  double ToData(double bins) const
  {
    return this->Histogram.Minimum + bins * this->Histogram.BinWidth;
  }

  // The region's tertiary function that shows what is above the cut, or below.
  std::string MakeTertiary(bool above) const
  {
    if (!this->IsCandidate())
    {
      return {};
    }
    const auto bins = static_cast<double>(this->Histogram.Counts.size());
    const double low = this->ToData(std::max(0., this->Split.Cut - 1.));
    const double high = this->ToData(std::min(bins, this->Split.Cut + 1.));
    vtkTFCTertiaryState state;
    state.Set = true;
    state.Attribute = this->Attribute;
    state.HasRange = true;
    state.Range = { { this->ToData(0.), this->ToData(bins) } };
    state.Opacity = { { { low, above ? 0. : 1. } }, { { high, above ? 1. : 0. } } };
    if (low > state.Range[0])
    {
      state.Opacity.insert(state.Opacity.begin(), { { state.Range[0], above ? 0. : 1. } });
    }
    if (high < state.Range[1])
    {
      state.Opacity.push_back({ { state.Range[1], above ? 1. : 0. } });
    }
    return vtkTFCTertiaryText(state);
  }
};

//------------------------------------------------------------------------------
template <typename Column, typename Value>
void AddColumn(vtkTable* table, const char* name, const std::vector<Row>& rows, Value&& value)
{
  vtkNew<Column> column;
  column->SetName(name);
  for (const Row& row : rows)
  {
    column->InsertNextValue(value(row));
  }
  table->AddColumn(column);
}

//------------------------------------------------------------------------------
void FillTable(const std::vector<Row>& rows, vtkTable* table)
{
  const auto number = [&](const char* name, auto&& value)
  {
    AddColumn<vtkDoubleArray>(table, name, rows,
      [&](const Row& row)
      { return row.IsCandidate() ? value(row) : std::numeric_limits<double>::quiet_NaN(); });
  };
  AddColumn<vtkIntArray>(table, "region", rows, [](const Row& row) { return row.Region; });
  AddColumn<vtkStringArray>(table, "region_name", rows,
    [](const Row& row) { return row.RegionName; });
  AddColumn<vtkStringArray>(table, "attribute", rows,
    [](const Row& row) { return row.Histogram.Label; });
  AddColumn<vtkIntArray>(table, "rank", rows, [](const Row& row) { return row.Rank; });
  number("power", [](const Row& row) { return row.Split.Power; });
  number("separability", [](const Row& row) { return row.Split.Separability; });
  number("valley", [](const Row& row) { return row.Split.Valley; });
  number("threshold", [](const Row& row) { return row.ToData(row.Split.Threshold); });
  number("cut", [](const Row& row) { return row.ToData(row.Split.Cut); });
  number("below", [](const Row& row) { return row.Split.Below; });
  AddColumn<vtkDoubleArray>(table, "voxels", rows, [](const Row& row) { return row.Split.Weight; });
  AddColumn<vtkStringArray>(table, "keep_above", rows,
    [](const Row& row) { return row.MakeTertiary(true); });
  AddColumn<vtkStringArray>(table, "keep_below", rows,
    [](const Row& row) { return row.MakeTertiary(false); });
}
}

//------------------------------------------------------------------------------
struct vtkTFCRegionSplit::Internals
{
  vtkTFCRegionHistograms Histograms;
};

//------------------------------------------------------------------------------
vtkTFCRegionSplit::vtkTFCRegionSplit()
  : Internal(new Internals)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkTFCRegionSplit::~vtkTFCRegionSplit()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkTFCRegionSplit::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
}

//------------------------------------------------------------------------------
void vtkTFCRegionSplit::SetTransferFunction(const char* json)
{
  this->Model->SetState(json);
}

//------------------------------------------------------------------------------
std::string vtkTFCRegionSplit::GetTransferFunction() const
{
  return this->Model->GetState();
}

//------------------------------------------------------------------------------
vtkTFCTransferFunction* vtkTFCRegionSplit::GetModel() const
{
  return this->Model;
}

//------------------------------------------------------------------------------
void vtkTFCRegionSplit::AddArray(const char* name)
{
  if (name && *name)
  {
    this->Arrays.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCRegionSplit::ClearArrays()
{
  this->Arrays.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTFCRegionSplit::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Model->GetMTime());
}

//------------------------------------------------------------------------------
int vtkTFCRegionSplit::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCRegionSplit::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataSet* first = FindFirstBlock(input);
  std::vector<vtkTFCAttribute> attributes;
  std::string problem;
  if (this->NumberOfBins < FewestBins || this->NumberOfBins > MostBins)
  {
    problem = "NumberOfBins is " + std::to_string(this->NumberOfBins) + ". Set it to " +
      std::to_string(FewestBins) + " to " + std::to_string(MostBins) + ".";
  }
  else if (!this->Model->HasAxes())
  {
    problem = "The transfer function lacks an axis. Give it a JSON state with \"primary\" and "
              "\"secondary\" arrays.";
  }
  else if (first)
  {
    std::vector<vtkTFCAttribute> axes = this->Model->GetAttributes();
    axes.resize(2);
    problem = FindAttributes(first, axes, this->Arrays, attributes);
  }

  // From here on every process takes the same way, whatever it found.
  vtkNew<vtkImageData> nothing;
  const vtkTFCDistributedImage peers(nothing, 0, this->Controller);
  if (!peers.Any(first != nullptr) && problem.empty())
  {
    problem = "The input is empty. Connect a volume with at least one voxel.";
  }
  const std::string shared = peers.ShareText(first != nullptr, Describe(attributes));
  if (problem.empty() && first && shared != Describe(attributes))
  {
    problem = "The processes hold different arrays. List those that all have in Arrays.";
  }
  if (peers.All(problem.empty()))
  {
    attributes = FromDescription(shared);
    problem = this->Internal->Histograms.Update(input, this->Model, this->NumberOfBins,
      this->Controller, this, attributes);
  }
  else if (problem.empty())
  {
    problem = "Another process cannot use its piece of the input: see the message there.";
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem << " There is no advice.");
    return 1;
  }

  if (this->Internal->Histograms.WasAborted())
  {
    return 1;
  }
  std::vector<Row> rows;
  const std::vector<int>& ids = this->Internal->Histograms.GetRegionIds();
  for (size_t region = 0; region < ids.size(); ++region)
  {
    const auto begin = static_cast<std::ptrdiff_t>(rows.size());
    for (size_t a = 0; a < attributes.size(); ++a)
    {
      Row row;
      row.Region = ids[region];
      row.RegionName = this->Model->GetRegionById(row.Region)->GetName();
      row.Attribute = attributes[a];
      row.Histogram = this->Internal->Histograms.GetExtra(a, region);
      double weight = 0.;
      for (const double count : row.Histogram.Counts)
      {
        weight += count;
      }
      row.Split = vtkTFCHistogramSplit::Find(row.Histogram.Counts, weight);
      rows.push_back(row);
    }
    std::stable_sort(rows.begin() + begin, rows.end(),
      [](const Row& a, const Row& b)
      {
        return a.Split.Power != b.Split.Power ? a.Split.Power > b.Split.Power
                                              : a.Split.Separability > b.Split.Separability;
      });
    int rank = 0;
    for (auto row = rows.begin() + begin; row != rows.end(); ++row)
    {
      row->Rank = row->IsCandidate() ? ++rank : 0;
    }
  }
  if (!this->TablesOnAllProcesses && this->Controller && this->Controller->GetLocalProcessId() > 0)
  {
    rows.clear();
  }
  FillTable(rows, vtkTable::GetData(outputs, 0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCRegionSplit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arrays:";
  for (const std::string& name : this->Arrays)
  {
    os << " " << name;
  }
  os << "\n" << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "TablesOnAllProcesses: " << this->TablesOnAllProcesses << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "Model:\n";
  this->Model->PrintSelf(os, indent.GetNextIndent());
}
