// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCJointHistogram.h"

#include "vtkTFCAttributeSamples.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCJointCounts.h"
#include "vtkTFCSparseHistogram.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

vtkStandardNewMacro(vtkTFCJointHistogram);
vtkCxxSetObjectMacro(vtkTFCJointHistogram, Controller, vtkMultiProcessController);

namespace
{
using Samples = vtkTFCAttributeSamples;
using Attribute = vtkTFCAttributeSamples::Attribute;

using vtkTFCJointCounts::TertiaryBits;

constexpr double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
std::vector<vtkDataSet*> FindBlocks(vtkDataObject* input)
{
  std::vector<vtkDataSet*> blocks = vtkCompositeDataSet::GetDataSets<vtkDataSet>(input);
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [](vtkDataSet* block) { return block->GetNumberOfPoints() == 0; }),
    blocks.end());
  return blocks;
}

//------------------------------------------------------------------------------
void SetEntries(vtkTFCSparseHistogram* histogram, const std::vector<tfc::KeyCount>& list)
{
  std::vector<unsigned int> cells;
  std::vector<unsigned short> bins;
  std::vector<double> counts;
  cells.reserve(list.size());
  bins.reserve(list.size());
  counts.reserve(list.size());
  for (const tfc::KeyCount& entry : list)
  {
    cells.push_back(static_cast<unsigned int>(entry.Key >> TertiaryBits));
    bins.push_back(static_cast<unsigned short>(entry.Key & ((1u << TertiaryBits) - 1)));
    counts.push_back(static_cast<double>(entry.Count));
  }
  histogram->SetEntries(std::move(cells), std::move(bins), std::move(counts));
}
}

//------------------------------------------------------------------------------
vtkTFCJointHistogram::vtkTFCJointHistogram()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkTFCJointHistogram::~vtkTFCJointHistogram()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
bool vtkTFCJointHistogram::CheckIndex(int axis)
{
  if (axis < 0 || axis > 2)
  {
    vtkErrorMacro("There is no axis " << axis << ": 0 is the primary, 1 the secondary and 2 the "
                                      << "tertiary one.");
    return false;
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCJointHistogram::SetArray(int axis, const char* name, int component)
{
  if (this->CheckIndex(axis))
  {
    this->Axes[axis].Array = name ? name : "";
    this->Axes[axis].Component = component;
  }
}

//------------------------------------------------------------------------------
const char* vtkTFCJointHistogram::GetArray(int axis) const
{
  return axis < 0 || axis > 2 ? "" : this->Axes[axis].Array.c_str();
}

//------------------------------------------------------------------------------
int vtkTFCJointHistogram::GetComponent(int axis) const
{
  return axis < 0 || axis > 2 ? 0 : this->Axes[axis].Component;
}

//------------------------------------------------------------------------------
void vtkTFCJointHistogram::SetRange(int axis, double minimum, double maximum)
{
  if (this->CheckIndex(axis))
  {
    this->Axes[axis].HasRange = true;
    this->Axes[axis].Range[0] = minimum;
    this->Axes[axis].Range[1] = maximum;
  }
}

//------------------------------------------------------------------------------
void vtkTFCJointHistogram::ClearRange(int axis)
{
  if (this->CheckIndex(axis))
  {
    this->Axes[axis].HasRange = false;
  }
}

//------------------------------------------------------------------------------
void vtkTFCJointHistogram::SetNumberOfBins(int axis, int bins)
{
  if (this->CheckIndex(axis))
  {
    this->Axes[axis].Bins = bins;
  }
}

//------------------------------------------------------------------------------
int vtkTFCJointHistogram::GetNumberOfBins(int axis) const
{
  return axis < 0 || axis > 2 ? 0 : this->Axes[axis].Bins;
}

//------------------------------------------------------------------------------
int vtkTFCJointHistogram::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCJointHistogram::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Histogram->SetAxis(axis, 0., 1., 1);
  }
  const std::string problem = this->Compute(FindBlocks(vtkDataObject::GetData(inputs[0])));
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem << " The histogram is empty.");
  }
  this->FillTable(vtkTable::GetData(outputs, 0));
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkTFCJointHistogram::Compute(const std::vector<vtkDataSet*>& blocks)
{
  std::string problem;
  std::vector<Samples::Request> requests;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Axis& a = this->Axes[axis];
    if (a.Bins < 1 || a.Bins > vtkTFCSparseHistogram::MostBins)
    {
      problem = "Axis " + std::to_string(axis) + " has " + std::to_string(a.Bins) +
        " bins. Set 1 to " + std::to_string(vtkTFCSparseHistogram::MostBins) + ".";
    }
    if (a.HasRange &&
      !(a.Range[0] <= a.Range[1] && std::isfinite(a.Range[1] - a.Range[0]) &&
        std::isfinite(a.Range[0])))
    {
      problem = "The range of axis " + std::to_string(axis) +
        " is not valid. Set two finite numbers, the smaller one first.";
    }
    if (!a.Array.empty())
    {
      // Components below -1 would be read as part of the name.
      requests.push_back({ a.Array, std::max(-1, a.Component) });
    }
    else if (axis < 2)
    {
      problem = std::string("The ") + (axis == 0 ? "primary" : "secondary") +
        " attribute is not set. Name an array.";
    }
  }
  const bool hasTertiary = requests.size() == 3;

  std::vector<std::vector<Attribute>> attributes(blocks.size());
  int association = -1;
  for (size_t b = 0; b < blocks.size() && problem.empty(); ++b)
  {
    int found;
    problem = Samples::Find(blocks[b], requests, attributes[b], found);
    if (problem.empty() && association >= 0 && found != association)
    {
      problem = "The arrays are of points in some blocks and of cells in others. Use one of both.";
    }
    association = problem.empty() ? found : -1;
  }

  // From here on every process takes the same way, whatever it found.
  vtkNew<vtkImageData> nothing;
  const vtkTFCDistributedImage peers(nothing, 0, this->Controller);
  double extremes[2] = { static_cast<double>(association < 0 ? 2 : association),
    static_cast<double>(association) };
  peers.Minimum(extremes, 1);
  peers.Maximum(extremes + 1, 1);
  if (problem.empty() && extremes[1] < 0.)
  {
    problem = "The input is empty. Connect a volume with at least one voxel.";
  }
  else if (problem.empty() && extremes[0] != extremes[1])
  {
    problem = "The arrays are of points on some processes and of cells on others. Use one of both.";
  }
  if (!peers.All(problem.empty()))
  {
    return problem.empty()
      ? "Another process cannot use its piece of the input: see the message there."
      : problem;
  }
  association = static_cast<int>(extremes[1]);

  // A single dataset is a piece of one whole; the blocks of a composite one are not.
  const bool composite =
    vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)) != nullptr;
  Samples samples;
  if (!composite)
  {
    vtkDataSet* piece = blocks.empty() ? nothing.Get() : blocks[0];
    const vtkTFCDistributedImage image(piece, association, this->Controller);
    if (!blocks.empty())
    {
      samples.Add(piece, association, attributes[0], image.GetOwnedSamples(), {});
    }
  }
  for (size_t b = 0; b < blocks.size() && composite; ++b)
  {
    const vtkTFCDistributedImage image(blocks[b], association, nullptr);
    samples.Add(blocks[b], association, attributes[b], image.GetOwnedSamples(), {});
  }

  for (size_t axis = 0; axis < requests.size(); ++axis)
  {
    double range[2] = { Infinity, -Infinity };
    if (!this->Axes[axis].HasRange)
    {
      std::tie(range[0], range[1]) = vtkTFCJointCounts::FindRange(samples, axis);
    }
    peers.Minimum(range, 1);
    peers.Maximum(range + 1, 1);
    if (this->Axes[axis].HasRange)
    {
      std::copy_n(this->Axes[axis].Range, 2, range);
    }
    else if (!(range[0] <= range[1]))
    {
      return "The array '" + this->Axes[axis].Array +
        "' has no finite value that counts. Choose another one, or set a range.";
    }
    this->Histogram->SetAxis(static_cast<int>(axis), range[0], range[1], this->Axes[axis].Bins);
  }

  std::vector<tfc::KeyCount> list;
  const bool done = vtkTFCJointCounts::Count(samples, this->Histogram, hasTertiary, this, list);
  if (peers.All(done))
  {
    vtkTFCJointCounts::Reduce(peers, list);
    SetEntries(this->Histogram, list);
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkTFCJointHistogram::FillTable(vtkTable* table) const
{
  const bool rows =
    this->TablesOnAllProcesses || !this->Controller || this->Controller->GetLocalProcessId() == 0;
  const vtkIdType count = rows ? this->Histogram->GetNumberOfEntries() : 0;
  const auto add = [&](auto* column, const char* name, const auto& values)
  {
    column->SetName(name);
    column->SetNumberOfValues(count);
    std::copy_n(values.begin(), count, column->GetPointer(0));
    table->AddColumn(column);
  };
  vtkNew<vtkUnsignedIntArray> cells;
  vtkNew<vtkUnsignedShortArray> bins;
  vtkNew<vtkDoubleArray> counts;
  add(cells.Get(), "cell", this->Histogram->GetCells());
  add(bins.Get(), "tertiary_bin", this->Histogram->GetTertiaryBins());
  add(counts.Get(), "count", this->Histogram->GetCounts());
}

//------------------------------------------------------------------------------
void vtkTFCJointHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Axis& axis : this->Axes)
  {
    os << indent << "Axis: " << axis.Array << ":" << axis.Component << ", " << axis.Bins
       << " bins\n";
  }
  os << indent << "TablesOnAllProcesses: " << this->TablesOnAllProcesses << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "Histogram:\n";
  this->Histogram->PrintSelf(os, indent.GetNextIndent());
}
