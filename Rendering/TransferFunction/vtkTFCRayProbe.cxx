// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRayProbe.h"

#include "vtkTFCClassifier.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCProbeCropping.h"
#include "vtkTFCProbeTables.h"
#include "vtkTFCRaySampler.h"
#include "vtkTFCTransferFunction.h"

#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkRectilinearGrid.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkTFCRayProbe);

namespace
{

using Point = std::array<double, 3>;
using vtkTFCProbeTables::FillLocation;
using vtkTFCProbeTables::FillRegions;

constexpr double MostPieces = 1e7;
// Optical depth of what is opaque: exp(-100) is nothing.
constexpr double OpaqueDepth = 100.0;
constexpr int TableTag = 40117;

//------------------------------------------------------------------------------
Point Along(const Point& start, const Point& direction, double t)
{
  return { start[0] + t * direction[0], start[1] + t * direction[1], start[2] + t * direction[2] };
}

//------------------------------------------------------------------------------
// The images and rectilinear grids of an input; a text when there is something else in it.
std::string CollectGrids(vtkDataObject* input, std::vector<vtkDataSet*>& grids)
{
  std::vector<vtkDataSet*> parts;
  if (vtkCompositeDataSet::SafeDownCast(input))
  {
    parts = vtkCompositeDataSet::GetDataSets<vtkDataSet>(input);
  }
  else if (auto* part = vtkDataSet::SafeDownCast(input))
  {
    parts = { part };
  }
  for (vtkDataSet* part : parts)
  {
    const bool known = vtkImageData::SafeDownCast(part) || vtkRectilinearGrid::SafeDownCast(part);
    if (!known && part->GetNumberOfPoints() > 0)
    {
      return std::string("The input holds a ") + part->GetClassName() +
        ". Only images and rectilinear grids can be probed; the filter Resample To Image makes an "
        "image.";
    }
    if (known && part->GetNumberOfPoints() > 0)
    {
      grids.push_back(part);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// The line, cut into pieces, and the classification along it.
class Line
{
public:
  Line(const vtkTFCClassifier& classifier, const vtkTFCProbeCropping& cropping, const Point& start,
    const Point& direction, double length, double step, double unit)
    : Classifier(classifier)
    , Cropping(cropping)
    , Start(start)
    , Direction(direction)
    , Length(length)
    , Step(step)
    , Unit(unit)
    , Values(classifier.GetModel().Attributes.size())
  {
    for (double& value : this->Values)
    {
      this->Pointers.push_back(&value);
    }
  }

  /// The part of piece `index` that an image draws: its middle and length; false where there is
  /// none.
  bool FindPiece(const vtkTFCRaySampler& image, double index, double& middle, double& length) const
  {
    double inside[2];
    if (!image.Intersect(this->Start, this->Direction, inside))
    {
      return false;
    }
    const double begin = std::max({ index * this->Step, inside[0], 0.0 });
    const double end = std::min({ (index + 1.0) * this->Step, inside[1], this->Length });
    middle = 0.5 * (begin + end);
    length = end - begin;
    return length > 0.0 && !this->Cropping.Hides(image.FindAxisPosition(this->GetPoint(middle)));
  }

  /// Optical depth of piece `index` in an image.
  double FindDepth(const vtkTFCRaySampler& image, double index)
  {
    double middle;
    double length;
    if (!this->FindPiece(image, index, middle, length))
    {
      return 0.0;
    }
    float rgba[4];
    this->Classify(image, this->GetPoint(middle), rgba);
    return rgba[3] < 1.0F ? -std::log1p(-rgba[3]) * length / this->Unit : OpaqueDepth;
  }

  Point GetPoint(double t) const { return Along(this->Start, this->Direction, t); }

  const std::vector<double>& Classify(const vtkTFCRaySampler& image, const Point& point,
    float rgba[4])
  {
    image.Sample(point, this->Values.data());
    this->Classifier.Classify(1, this->Pointers.data(), rgba);
    return this->Values;
  }

private:
  const vtkTFCClassifier& Classifier;
  const vtkTFCProbeCropping& Cropping;
  Point Start;
  Point Direction;
  double Length;
  double Step;
  double Unit;
  std::vector<double> Values;
  std::vector<const double*> Pointers;
};

//------------------------------------------------------------------------------
// The classifier for the ranges of all processes.
vtkTFCClassifier MakeClassifier(const vtkTFCTransferFunction* model,
  const std::vector<vtkTFCRaySampler>& samplers, const vtkTFCDistributedImage& peers)
{
  double ends[4];
  std::fill(ends, ends + 4, std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < 2; ++axis)
  {
    for (const auto& sampler : samplers)
    {
      if (!model->HasAxisRange(axis))
      {
        double range[2];
        sampler.GetReader().FiniteRange(axis, range);
        ends[2 * axis] = std::min(ends[2 * axis], range[0]);
        ends[2 * axis + 1] = std::min(ends[2 * axis + 1], -range[1]);
      }
    }
  }
  peers.Minimum(ends, 4);
  const double primary[2] = { ends[0], -ends[1] };
  const double secondary[2] = { ends[2], -ends[3] };
  double used[4];
  model->ResolveRanges(primary, secondary, used);
  return vtkTFCClassifier(model->Compile(used));
}

}

//------------------------------------------------------------------------------
vtkTFCRayProbe::vtkTFCRayProbe()
{
  this->SetNumberOfOutputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkTFCRayProbe::~vtkTFCRayProbe()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkTFCRayProbe::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
}

//------------------------------------------------------------------------------
void vtkTFCRayProbe::SetTransferFunction(const char* json)
{
  this->Model->SetState(json);
}

//------------------------------------------------------------------------------
std::string vtkTFCRayProbe::GetTransferFunction() const
{
  return this->Model->GetState();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTFCRayProbe::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Model->GetMTime());
}

//------------------------------------------------------------------------------
int vtkTFCRayProbe::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkTFCRayProbe::CheckSettings() const
{
  if (!this->Model->HasAxes())
  {
    return "The transfer function lacks an axis. Give it a JSON state with \"primary\" and "
           "\"secondary\" arrays.";
  }
  if (!(this->UnitDistance > 0.0))
  {
    return "UnitDistance is " + std::to_string(this->UnitDistance) + ". Set a positive length.";
  }
  if (!(this->Threshold > 0.0 && this->Threshold <= 1.0))
  {
    return "Threshold is " + std::to_string(this->Threshold) +
      ". Set an opacity above 0 and at most 1.";
  }
  if (std::equal(this->StartPoint, this->StartPoint + 3, this->EndPoint))
  {
    return "StartPoint and EndPoint are the same. Set two ends of a line.";
  }
  return {};
}

//------------------------------------------------------------------------------
// The planes by the bounds of the data on all processes.
vtkTFCProbeCropping vtkTFCRayProbe::FindCropping(const std::vector<vtkTFCRaySampler>& samplers,
  const vtkTFCDistributedImage& peers) const
{
  double ends[6]; // upper ones negated
  std::fill(ends, ends + 6, std::numeric_limits<double>::infinity());
  for (const auto& sampler : samplers)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto bounds = sampler.GetAxisBounds(axis);
      ends[2 * axis] = std::min(ends[2 * axis], bounds[0]);
      ends[2 * axis + 1] = std::min(ends[2 * axis + 1], -bounds[1]);
    }
  }
  peers.Minimum(ends, 6);
  vtkTFCProbeCropping cropping;
  cropping.Enabled = this->UseCropping;
  cropping.Flags = this->CroppingRegionFlags;
  for (int i = 0; i < 6; ++i)
  {
    cropping.Planes[i] =
      this->CroppingOrigin[i / 2] + this->CroppingScale[i / 2] * (i % 2 ? -ends[i] : ends[i]);
  }
  return cropping;
}

//------------------------------------------------------------------------------
int vtkTFCRayProbe::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  vtkTable* location = vtkTable::GetData(outputs, 0);
  vtkTable* regions = vtkTable::GetData(outputs, 1);
  std::vector<vtkDataSet*> grids;
  std::string problem = this->CheckSettings();
  if (problem.empty())
  {
    problem = CollectGrids(vtkDataObject::GetData(inputs[0]), grids);
  }
  vtkNew<vtkMatrix4x4> transform;
  transform->DeepCopy(this->Transform);
  std::vector<vtkTFCRaySampler> samplers;
  std::vector<int> blocks;
  std::string missing;
  for (size_t i = 0; i < grids.size() && problem.empty(); ++i)
  {
    vtkTFCRaySampler sampler;
    if (sampler.Bind(grids[i], this->Model->GetAttributes(), transform, missing))
    {
      samplers.push_back(sampler);
      blocks.push_back(static_cast<int>(i));
    }
  }

  // From here on every process takes the same way, whatever it found.
  vtkNew<vtkImageData> nothing;
  const vtkTFCDistributedImage peers(nothing, vtkDataObject::POINT, this->Controller);
  if (problem.empty() && !peers.Any(!samplers.empty()))
  {
    problem = missing.empty() ? "The input is empty. Connect a volume." : missing;
  }
  if (!peers.All(problem.empty()))
  {
    const std::string text = peers.ShareText(!problem.empty(), problem);
    vtkErrorMacro(<< text << " The tables are empty.");
    return 1;
  }
  const vtkTFCClassifier classifier = MakeClassifier(this->Model, samplers, peers);

  const Point start = { this->StartPoint[0], this->StartPoint[1], this->StartPoint[2] };
  Point direction;
  double length = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    direction[axis] = this->EndPoint[axis] - start[axis];
    length = std::hypot(length, direction[axis]);
  }
  for (double& component : direction)
  {
    component /= length;
  }
  // The step, and the part of the line with data on it: one reduction.
  double common[3] = { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() };
  for (const auto& sampler : samplers)
  {
    const double* spacing = sampler.GetImage()->GetSpacing();
    common[0] = std::min(common[0],
      0.5 * (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0);
    double inside[2];
    if (sampler.Intersect(start, direction, inside))
    {
      common[1] = std::min(common[1], std::max(0.0, inside[0]));
      common[2] = std::min(common[2], -std::min(length, inside[1]));
    }
  }
  peers.Minimum(common, 3);
  const double step = this->SampleDistance > 0.0 ? this->SampleDistance : common[0];
  const double first = std::floor(common[1] / step);
  const double pieces = std::ceil(-common[2] / step) - first;
  if (!(pieces > 0.0))
  {
    return 1; // beside the volume
  }
  if (pieces > MostPieces)
  {
    vtkErrorMacro(<< "SampleDistance is " << step << ": that makes more than " << MostPieces
                  << " samples along the line. Set a larger one.");
    return 1;
  }

  const vtkTFCProbeCropping cropping = this->FindCropping(samplers, peers);
  Line line(classifier, cropping, start, direction, length, step, this->UnitDistance);
  std::vector<double> depths(static_cast<size_t>(pieces), 0.0);
  for (const auto& sampler : samplers)
  {
    for (size_t i = 0; i < depths.size(); ++i)
    {
      depths[i] += line.FindDepth(sampler, first + static_cast<double>(i));
    }
  }
  peers.Sum(depths.data(), static_cast<vtkIdType>(depths.size()));

  double transparency = 1.0;
  double largest = 0.0;
  size_t chosen = depths.size();
  double opacity = 0.0; // accumulated at the chosen piece
  bool reached = false;
  for (size_t i = 0; i < depths.size(); ++i)
  {
    const double contribution = -transparency * std::expm1(-depths[i]);
    transparency *= std::exp(-depths[i]);
    const bool reaches = !reached && 1.0 - transparency >= this->Threshold - 1e-12;
    if (reaches || (!reached && contribution > largest))
    {
      chosen = i;
      opacity = 1.0 - transparency;
    }
    reached = reached || reaches;
    largest = std::max(largest, contribution);
  }
  if (chosen == depths.size())
  {
    return 1; // nothing to see
  }

  // Two images may share the piece: the one with more of it answers, the first process among
  // equals.
  const double index = first + static_cast<double>(chosen);
  double most = 0.0;
  size_t mine = 0;
  for (size_t s = 0; s < samplers.size(); ++s)
  {
    const double depth = line.FindDepth(samplers[s], index);
    mine = depth > most ? s : mine;
    most = std::max(most, depth);
  }
  double shared = most;
  peers.Maximum(&shared, 1);
  const int rank = this->Controller ? this->Controller->GetLocalProcessId() : 0;
  double owner = most == shared && most > 0.0 ? rank : std::numeric_limits<double>::infinity();
  peers.Minimum(&owner, 1);
  if (static_cast<double>(rank) == owner)
  {
    double middle;
    double part;
    line.FindPiece(samplers[mine], index, middle, part);
    const Point place = line.GetPoint(middle);
    float rgba[4];
    const std::vector<double> values = line.Classify(samplers[mine], place, rgba);
    FillLocation(location, samplers[mine],
      { place, middle, blocks[mine], reached, opacity, 1.0 - transparency,
        { rgba[0], rgba[1], rgba[2], rgba[3] }, { values[0], values[1] } });
    FillRegions(regions, classifier, this->Model, values);
  }
  if (owner > 0.0)
  {
    for (vtkTable* table : { location, regions })
    {
      if (static_cast<double>(rank) == owner)
      {
        this->Controller->Send(table, 0, TableTag);
        table->Initialize();
      }
      else if (rank == 0)
      {
        this->Controller->Receive(table, static_cast<int>(owner), TableTag);
      }
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCRayProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StartPoint: " << this->StartPoint[0] << " " << this->StartPoint[1] << " "
     << this->StartPoint[2] << "\n";
  os << indent << "EndPoint: " << this->EndPoint[0] << " " << this->EndPoint[1] << " "
     << this->EndPoint[2] << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "UnitDistance: " << this->UnitDistance << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
}
