// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRegionHistograms.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkTFCAttributeReader.h"
#include "vtkTFCJointHistogram.h"
#include "vtkTFCRegion.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace
{
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
// Element-wise minimum over all processes.
void Minimum(vtkMultiProcessController* controller, std::vector<double>& values)
{
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    const std::vector<double> local = values;
    controller->AllReduce(local.data(), values.data(), static_cast<vtkIdType>(values.size()),
      vtkCommunicator::MIN_OP);
  }
}

//------------------------------------------------------------------------------
// The weight of the only region of `model` in the middle of every bin of the plane.
std::vector<float> FindWeights(vtkTFCCompiledModel model, const vtkTFCSparseHistogram* plane)
{
  const auto columns = static_cast<size_t>(plane->GetNumberOfBins(0));
  const size_t cells = columns * static_cast<size_t>(plane->GetNumberOfBins(1));
  std::vector<double> x(cells), y(cells);
  for (size_t cell = 0; cell < cells; ++cell)
  {
    x[cell] = plane->GetBinCenter(0, static_cast<int>(cell % columns));
    y[cell] = plane->GetBinCenter(1, static_cast<int>(cell / columns));
  }
  // Alone, opaque and without tertiary function, a region's opacity is its weight.
  model.Blend = vtkTFCBlendType::Mix;
  model.Regions[0].Tertiary = -1;
  model.Regions[0].Opacity = 1;
  const double* axes[2] = { x.data(), y.data() };
  std::vector<float> weights(cells);
  vtkTFCClassifier(std::move(model)).Classify(cells, axes, nullptr, nullptr, weights.data());
  return weights;
}

//------------------------------------------------------------------------------
// The finite extents of all attributes over all blocks and processes, {inf, -inf} where there is
// none; or what is wrong. Every process takes part in the reduction whatever happens to it.
std::string FindRanges(vtkDataObject* input, const std::vector<vtkTFCAttribute>& attributes,
  vtkMultiProcessController* controller, std::vector<double>& ranges)
{
  const size_t count = attributes.size();
  // Minima, negated maxima, the negated number of failures.
  std::vector<double> extremes(2 * count + 1, HUGE_VAL);
  extremes.back() = 0.;
  std::string problem;
  for (vtkDataSet* block : FindBlocks(input))
  {
    vtkTFCAttributeReader reader;
    if (!reader.Bind(block, attributes, problem))
    {
      extremes.back() = -1.;
      break;
    }
    for (size_t a = 0; a < count; ++a)
    {
      double range[2];
      reader.FiniteRange(static_cast<int>(a), range);
      extremes[a] = std::min(extremes[a], range[0]);
      extremes[count + a] = std::min(extremes[count + a], -range[1]);
    }
  }
  Minimum(controller, extremes);
  for (size_t a = 0; a < count; ++a)
  {
    ranges.push_back(extremes[a]);
    ranges.push_back(-extremes[count + a]);
  }
  if (extremes.back() != 0. && problem.empty())
  {
    problem = "Another process cannot use its piece of the input: see the message there.";
  }
  return problem;
}

//------------------------------------------------------------------------------
// Passes the progress of an inner filter to its owner, and the owner's abort flag to it.
class Forwarding
{
public:
  Forwarding(vtkAlgorithm* inner, vtkAlgorithm* owner, double begin, double end)
    : Inner(inner)
    , Owner(owner)
    , Begin(begin)
    , End(end)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void*)
      { static_cast<Forwarding*>(self)->Forward(); });
    this->Tag = inner->AddObserver(vtkCommand::ProgressEvent, command);
  }
  ~Forwarding() { this->Inner->RemoveObserver(this->Tag); }
  Forwarding(const Forwarding&) = delete;
  void operator=(const Forwarding&) = delete;

private:
  void Forward()
  {
    this->Owner->UpdateProgress(
      this->Begin + (this->End - this->Begin) * this->Inner->GetProgress());
    if (this->Owner->GetAbortExecute())
    {
      this->Inner->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Inner;
  vtkAlgorithm* Owner;
  double Begin, End;
  unsigned long Tag;
};

//------------------------------------------------------------------------------
// An extent that bins can divide: empty becomes [0, 1].
void MakeUsable(double range[2])
{
  if (!(range[0] <= range[1]))
  {
    range[0] = 0.;
    range[1] = 1.;
  }
}
}

//------------------------------------------------------------------------------
struct vtkTFCRegionHistograms::Joint
{
  vtkSmartPointer<vtkTFCJointHistogram> Filter;
  std::string Label;
  bool Used = false; ///< by the latest transfer function
  bool Stale = true; ///< must be computed
};

//------------------------------------------------------------------------------
vtkTFCRegionHistograms::vtkTFCRegionHistograms() = default;
vtkTFCRegionHistograms::~vtkTFCRegionHistograms() = default;

//------------------------------------------------------------------------------
std::string vtkTFCRegionHistograms::GetLabel(const vtkTFCAttribute& attribute)
{
  return attribute.Component == 0 ? attribute.Array
    : attribute.Component < 0     ? attribute.Array + ":magnitude"
                                  : attribute.Array + ":" + std::to_string(attribute.Component);
}

//------------------------------------------------------------------------------
vtkTFCRegionHistograms::Joint& vtkTFCRegionHistograms::GetOrMake(const vtkTFCAttribute* tertiary,
  const double range[2])
{
  // Everything that a joint histogram depends on, but the data.
  const vtkTFCAttribute* const attributes[3] = { this->Axes, this->Axes + 1, tertiary };
  const double* const ranges[3] = { this->Ranges[0], this->Ranges[1], range };
  const int axes = tertiary ? 3 : 2;
  std::string key = std::to_string(this->Bins);
  for (int axis = 0; axis < axes; ++axis)
  {
    char numbers[64];
    std::snprintf(numbers, sizeof(numbers), "\n%a %a ", ranges[axis][0], ranges[axis][1]);
    key +=
      numbers + GetLabel(*attributes[axis]) + "\n" + std::to_string(attributes[axis]->Component);
  }
  Joint& joint = this->Joints[key];
  joint.Used = true;
  if (!joint.Filter)
  {
    joint.Filter = vtkSmartPointer<vtkTFCJointHistogram>::New();
    joint.Filter->TablesOnAllProcessesOff();
    for (int axis = 0; axis < axes; ++axis)
    {
      joint.Filter->SetArray(axis, attributes[axis]->Array.c_str(), attributes[axis]->Component);
      joint.Filter->SetRange(axis, ranges[axis][0], ranges[axis][1]);
      joint.Filter->SetNumberOfBins(axis, this->Bins);
    }
    joint.Label = tertiary ? GetLabel(*tertiary) : "";
  }
  return joint;
}

//------------------------------------------------------------------------------
std::string vtkTFCRegionHistograms::Update(vtkDataObject* input, vtkTFCTransferFunction* model,
  int bins, vtkMultiProcessController* controller, vtkAlgorithm* owner,
  const std::vector<vtkTFCAttribute>& extra)
{
  this->Conditionals.clear();
  this->ExtraJoints.clear();
  // Every visible region, whatever its opacity.
  vtkNew<vtkTFCTransferFunction> visible;
  visible->SetState(model->GetState().c_str());
  for (int i = 0; i < visible->GetNumberOfRegions(); ++i)
  {
    visible->GetRegion(i)->SetOpacity(1.);
  }
  std::vector<vtkTFCAttribute> attributes = visible->GetAttributes();
  const size_t own = attributes.size();
  attributes.insert(attributes.end(), extra.begin(), extra.end());
  std::vector<double> extents;
  std::string problem = FindRanges(input, attributes, controller, extents);
  if (!problem.empty())
  {
    return problem;
  }
  double used[4];
  visible->ResolveRanges(extents.data(), extents.data() + 2, used);
  const vtkTFCCompiledModel compiled = visible->Compile(used);
  for (size_t axis = 0; axis < 2; ++axis)
  {
    this->Axes[axis] = attributes[axis];
    std::copy_n(used + 2 * axis, 2, this->Ranges[axis]);
  }
  this->Bins = bins;

  // A process whose data are the same must join those whose data are not.
  std::vector<double> same{ input == this->Input && input->GetMTime() <= this->InputTime ? 1.
                                                                                         : 0. };
  Minimum(controller, same);
  this->Input = input;
  this->InputTime = input->GetMTime();
  for (auto& joint : this->Joints)
  {
    joint.second.Used = false;
    joint.second.Stale = joint.second.Stale || same[0] == 0.;
  }

  std::vector<const Joint*> ofRegions;
  for (const vtkTFCCompiledRegion& region : compiled.Regions)
  {
    const Joint* joint = nullptr;
    if (region.Tertiary >= 0)
    {
      double range[2];
      if (!visible->GetRegionById(region.Id)->GetTertiaryRange(range))
      {
        std::copy_n(extents.data() + 2 * static_cast<size_t>(region.Tertiary), 2, range);
        MakeUsable(range);
      }
      joint = &this->GetOrMake(&attributes[static_cast<size_t>(region.Tertiary)], range);
    }
    ofRegions.push_back(joint);
  }
  for (size_t e = 0; e < extra.size(); ++e)
  {
    MakeUsable(extents.data() + 2 * (own + e));
    this->ExtraJoints.push_back(&this->GetOrMake(&extra[e], extents.data() + 2 * (own + e)));
  }
  if (std::none_of(this->Joints.begin(), this->Joints.end(),
        [](const auto& joint) { return joint.second.Used; }))
  {
    this->GetOrMake(nullptr, nullptr);
  }

  this->Aborted = false;
  size_t done = 0;
  const auto total = static_cast<double>(this->Joints.size());
  for (auto joint = this->Joints.begin(); joint != this->Joints.end();)
  {
    if (!joint->second.Used)
    {
      joint = this->Joints.erase(joint);
      continue;
    }
    if (joint->second.Stale)
    {
      vtkTFCJointHistogram* filter = joint->second.Filter;
      filter->SetController(controller);
      filter->SetInputDataObject(input);
      filter->Modified();
      const Forwarding forwarding(filter, owner, static_cast<double>(done) / total,
        static_cast<double>(done + 1) / total);
      filter->Update();
      // The data are those of the pipeline, not ours to keep.
      filter->SetInputDataObject(nullptr);
      // Once one process was stopped, what all have is of no use.
      std::vector<double> complete{ filter->GetAbortExecute() ? 0. : 1. };
      Minimum(controller, complete);
      filter->SetAbortExecute(0);
      if (complete[0] == 0.)
      {
        this->Aborted = true;
        return {};
      }
      joint->second.Stale = false;
    }
    ++done;
    ++joint;
  }

  this->FillWeights(compiled);
  for (size_t region = 0; region < ofRegions.size(); ++region)
  {
    if (ofRegions[region])
    {
      this->Conditionals.push_back(this->MakeConditional(*ofRegions[region], region));
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkTFCRegionHistograms::FillWeights(vtkTFCCompiledModel model)
{
  const vtkTFCSparseHistogram* plane = this->GetJoint();
  std::vector<vtkTFCCompiledRegion> regions;
  regions.swap(model.Regions);
  this->Ids.clear();
  this->Weights.clear();
  for (const vtkTFCCompiledRegion& region : regions)
  {
    this->Ids.push_back(region.Id);
    model.Regions = { region };
    this->Weights.push_back(FindWeights(model, plane));
  }
}

//------------------------------------------------------------------------------
std::vector<double> vtkTFCRegionHistograms::MakeConditional(const vtkTFCSparseHistogram* histogram,
  const vtkTFCTransferFunction* model, vtkTFCRegion* region, const double ranges[4])
{
  // A copy that takes part whatever the original does.
  vtkNew<vtkTFCTransferFunction> one;
  for (int axis = 0; axis < 2; ++axis)
  {
    one->SetAxis(axis, model->GetAxisArray(axis).c_str(), model->GetAxisComponent(axis));
  }
  vtkNew<vtkTFCRegion> copy;
  copy->DeepCopy(region);
  copy->SetVisible(true);
  copy->SetOpacity(1);
  one->AddRegion(copy);
  std::vector<double> counts(static_cast<size_t>(histogram->GetNumberOfBins(2)), 0.);
  const vtkTFCCompiledModel compiled = one->Compile(ranges);
  // A shape may be too thin to take part.
  if (!compiled.Regions.empty())
  {
    histogram->GetConditional(FindWeights(compiled, histogram).data(), counts.data());
  }
  return counts;
}

//------------------------------------------------------------------------------
vtkTFCRegionHistograms::Conditional vtkTFCRegionHistograms::MakeConditional(const Joint& joint,
  size_t region) const
{
  const vtkTFCSparseHistogram* histogram = joint.Filter->GetHistogram();
  Conditional result;
  double range[2];
  histogram->GetRange(2, range);
  result.Id = this->Ids[region];
  result.Label = joint.Label;
  result.Minimum = range[0];
  result.BinWidth = (range[1] - range[0]) / this->Bins;
  result.Counts.resize(static_cast<size_t>(histogram->GetNumberOfBins(2)));
  histogram->GetConditional(this->Weights[region].data(), result.Counts.data());
  return result;
}

//------------------------------------------------------------------------------
vtkTFCRegionHistograms::Conditional vtkTFCRegionHistograms::GetExtra(size_t index,
  size_t region) const
{
  return this->MakeConditional(*this->ExtraJoints[index], region);
}

//------------------------------------------------------------------------------
const vtkTFCSparseHistogram* vtkTFCRegionHistograms::GetJoint() const
{
  return this->Joints.begin()->second.Filter->GetHistogram();
}
