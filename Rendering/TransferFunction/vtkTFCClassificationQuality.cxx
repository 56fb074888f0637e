// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCClassificationQuality.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTFCAttributeReader.h"
#include "vtkTFCClassifier.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCQualityCounts.h"
#include "vtkTFCQualityTables.h"
#include "vtkTFCSamples.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

vtkStandardNewMacro(vtkTFCClassificationQuality);

namespace
{
using vtkTFCLabelHistogram::Entry;
using vtkTFCQualityCounts::Binning;
using vtkTFCQualityCounts::Counts;
using vtkTFCQualityCounts::Source;

constexpr size_t MostConfusionEntries = size_t{ 1 } << 22;
// Beyond it not every integer is a double.
constexpr double LargestLabel = 9007199254740992.;

//------------------------------------------------------------------------------
// How messages and tables name an attribute.
std::string NameOf(const vtkTFCAttribute& attribute)
{
  return attribute.Component == 0 ? attribute.Array
    : attribute.Component < 0     ? attribute.Array + ":magnitude"
                                  : attribute.Array + ":" + std::to_string(attribute.Component);
}

//------------------------------------------------------------------------------
// What is wrong with the label array, empty when nothing is.
std::string CheckLabels(vtkDataArray* array)
{
  const std::string name = "The label array '" + std::string(array->GetName()) + "' ";
  if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
  {
    return name + "holds values of the type " + array->GetDataTypeAsString() +
      ", not integers. Choose an array with one integer per voxel, or convert it, for example with "
      "the filter Calculator and the result type Int.";
  }
  if (array->GetNumberOfComponents() != 1)
  {
    return name + "has " + std::to_string(array->GetNumberOfComponents()) +
      " components. Choose an array with one integer per voxel.";
  }
  return {};
}

//------------------------------------------------------------------------------
// Bind the attributes and, after them, the labels.
std::string Bind(vtkDataSet* data, std::vector<vtkTFCAttribute> attributes,
  const std::string& labels, vtkTFCAttributeReader& reader)
{
  vtkDataSetAttributes* points = data->GetPointData();
  vtkDataSetAttributes* cells = data->GetCellData();
  if (!points->GetArray(labels.c_str()) && !cells->GetArray(labels.c_str()))
  {
    return "There is no label array '" + labels +
      "' of numbers in the data. Point arrays: " + vtkTFCSamples::ListArrays(points) +
      "; cell arrays: " + vtkTFCSamples::ListArrays(cells) + ". Choose one of them as LabelArray.";
  }
  std::string problem;
  if (!reader.Bind(data, attributes, problem))
  {
    return problem;
  }
  const bool ofCells = reader.GetAssociation() == vtkDataObject::CELL;
  attributes.push_back({ labels, 0 });
  if (reader.Bind(data, attributes, problem))
  {
    const bool chosen = reader.GetAssociation() == vtkDataObject::CELL;
    return CheckLabels((chosen ? cells : points)->GetArray(labels.c_str()));
  }
  if (!(ofCells ? cells : points)->GetArray(labels.c_str()))
  {
    return "The label array '" + labels + "' is a " + (ofCells ? "point" : "cell") +
      " array, the attributes are " + (ofCells ? "cell" : "point") +
      " arrays. Convert the attributes with " +
      (ofCells ? "Cell Data to Point Data" : "Point Data to Cell Data") +
      ", not the labels, whose mean says nothing.";
  }
  return problem;
}

//------------------------------------------------------------------------------
// Ranges of all attributes over all processes: {inf, -inf} where not needed or without finite data.
std::vector<std::array<double, 2>> FindRanges(const vtkTFCAttributeReader& reader,
  const vtkTFCTransferFunction& model, size_t attributes, const vtkTFCDistributedImage& image)
{
  std::vector<double> low(attributes, HUGE_VAL);
  std::vector<double> negatedHigh(attributes, HUGE_VAL);
  for (size_t a = 0; a < attributes && reader.GetNumberOfTuples() > 0; ++a)
  {
    const int index = static_cast<int>(a);
    if (index > 1 || !model.HasAxisRange(index))
    {
      double range[2];
      reader.FiniteRange(index, range);
      low[a] = range[0];
      negatedHigh[a] = -range[1];
    }
  }
  image.Minimum(low.data(), static_cast<vtkIdType>(attributes));
  image.Minimum(negatedHigh.data(), static_cast<vtkIdType>(attributes));
  std::vector<std::array<double, 2>> ranges(attributes + 1, { { 0, 1 } });
  for (size_t a = 0; a < attributes; ++a)
  {
    ranges[a] = { { low[a], -negatedHigh[a] } };
  }
  double used[4];
  model.ResolveRanges(ranges[0].data(), ranges[1].data(), used);
  ranges[0] = { { used[0], used[1] } };
  ranges[1] = { { used[2], used[3] } };
  return ranges;
}

//------------------------------------------------------------------------------
// The labels of all processes; a text when there are none, too many or too large ones.
std::string ShareLabels(const vtkTFCDistributedImage& image, std::vector<double>& labels)
{
  std::vector<std::int64_t> mine;
  mine.reserve(labels.size());
  for (const double label : labels)
  {
    mine.push_back(
      static_cast<std::int64_t>(std::max(-LargestLabel, std::min(LargestLabel, label))));
  }
  std::vector<std::int64_t> all = image.Gather(mine);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  labels.assign(all.begin(), all.end());
  if (labels.empty())
  {
    return "No voxel is left: all are blanked or have an ignored label.";
  }
  if (labels.size() > vtkTFCLabelHistogram::MostLabels)
  {
    return "There are more than " + std::to_string(vtkTFCLabelHistogram::MostLabels) +
      " labels. Choose an array with a number per material, not per voxel, or merge labels.";
  }
  if (labels.front() <= -LargestLabel || labels.back() >= LargestLabel)
  {
    return "A label is 2^53 or more in magnitude. Number the labels from 0.";
  }
  return {};
}

//------------------------------------------------------------------------------
// Add up what the processes counted; merge the histograms.
void Reduce(const vtkTFCDistributedImage& image, Counts& counts)
{
  image.Sum(counts.Confusion.data(), static_cast<vtkIdType>(counts.Confusion.size()));
  image.Sum(counts.Totals.data()->data(), 2 * static_cast<vtkIdType>(counts.Totals.size()));
  for (std::vector<Entry>& histogram : counts.Histograms)
  {
    vtkTFCLabelHistogram::Merge(histogram);
    if (image.GetNumberOfRanks() > 1)
    {
      std::vector<std::int64_t> mine;
      mine.reserve(2 * histogram.size());
      for (const Entry& entry : histogram)
      {
        mine.push_back(static_cast<std::int64_t>(entry.Key));
        mine.push_back(entry.Count);
      }
      const std::vector<std::int64_t> all = image.Gather(mine);
      histogram.clear();
      for (size_t i = 0; i < all.size(); i += 2)
      {
        histogram.push_back({ static_cast<std::uint64_t>(all[i]), all[i + 1] });
      }
      vtkTFCLabelHistogram::Merge(histogram);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkTFCClassificationQuality::vtkTFCClassificationQuality()
{
  this->SetNumberOfOutputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkTFCClassificationQuality::~vtkTFCClassificationQuality()
{
  this->SetController(nullptr);
  this->SetLabelArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkTFCClassificationQuality::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
}

//------------------------------------------------------------------------------
void vtkTFCClassificationQuality::SetTransferFunction(const char* json)
{
  this->Model->SetState(json);
}

//------------------------------------------------------------------------------
std::string vtkTFCClassificationQuality::GetTransferFunction() const
{
  return this->Model->GetState();
}

//------------------------------------------------------------------------------
vtkTFCTransferFunction* vtkTFCClassificationQuality::GetModel() const
{
  return this->Model;
}

//------------------------------------------------------------------------------
void vtkTFCClassificationQuality::AddIgnoredLabel(vtkIdType label)
{
  this->IgnoredLabels.push_back(static_cast<double>(label));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTFCClassificationQuality::ClearIgnoredLabels()
{
  this->IgnoredLabels.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTFCClassificationQuality::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Model->GetMTime());
}

//------------------------------------------------------------------------------
int vtkTFCClassificationQuality::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkTFCClassificationQuality::CheckSettings() const
{
  if (this->NumberOfBins < 2 || this->NumberOfBins > vtkTFCLabelHistogram::MostBins)
  {
    return "NumberOfBins is " + std::to_string(this->NumberOfBins) + ". Set it to 2 to " +
      std::to_string(vtkTFCLabelHistogram::MostBins) + ".";
  }
  if (!this->LabelArray || !*this->LabelArray || std::strcmp(this->LabelArray, "None") == 0)
  {
    return "LabelArray is not set. Name the integer array that says what each voxel is.";
  }
  if (!this->Model->HasAxes())
  {
    return "The transfer function lacks an axis. Give it a JSON state with \"primary\" and "
           "\"secondary\" arrays.";
  }
  return {};
}

//------------------------------------------------------------------------------
int vtkTFCClassificationQuality::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  const std::vector<vtkTFCAttribute> attributes = this->Model->GetAttributes();
  vtkTFCAttributeReader reader;
  std::string problem = this->CheckSettings();
  if (problem.empty() && !isEmpty)
  {
    problem = Bind(input, attributes, this->LabelArray, reader);
  }

  // From here on every process takes the same way, whatever it found.
  const vtkTFCDistributedImage peers(input, vtkDataObject::POINT, this->Controller);
  const auto fails = [&]()
  {
    const bool good = peers.All(problem.empty());
    if (!good)
    {
      vtkErrorMacro(<< (problem.empty() ? "Another process cannot use its piece of the input: see "
                                          "the message there."
                                        : problem)
                    << " The tables are empty.");
    }
    return !good;
  };
  if (!peers.Any(!isEmpty) && problem.empty())
  {
    problem = "The input is empty. Connect a volume with at least one voxel.";
  }
  double kind = isEmpty ? -1. : reader.GetAssociation();
  peers.Maximum(&kind, 1);
  const int association = static_cast<int>(kind);
  if (problem.empty() && !isEmpty && association != reader.GetAssociation())
  {
    problem = "The arrays are of points on some processes and of cells on others. Use one of both.";
  }
  if (fails())
  {
    return 1;
  }

  const vtkTFCDistributedImage image(input, association, this->Controller);
  Binning binning;
  binning.Bins = this->NumberOfBins;
  binning.Ranges = FindRanges(reader, *this->Model, attributes.size(), image);
  const double used[4] = { binning.Ranges[0][0], binning.Ranges[0][1], binning.Ranges[1][0],
    binning.Ranges[1][1] };
  const vtkTFCClassifier classifier(this->Model->Compile(used));
  const vtkTFCCompiledModel& model = classifier.GetModel();
  binning.Third = { -1 };
  std::vector<std::string> names = { "" };
  for (const vtkTFCCompiledRegion& region : model.Regions)
  {
    if (region.Tertiary > 1 &&
      std::find(binning.Third.begin(), binning.Third.end(), region.Tertiary) == binning.Third.end())
    {
      binning.Third.push_back(region.Tertiary);
      names.push_back(NameOf(model.Attributes[region.Tertiary]));
    }
  }

  Source source;
  source.Reader = &reader;
  source.LabelAttribute = static_cast<int>(attributes.size());
  source.Extent = image.GetLocalExtent();
  source.Owned = image.GetOwnedSamples();
  source.Ignored = this->IgnoredLabels;
  std::vector<double> labels;
  if (!image.All(vtkTFCQualityCounts::FindLabels(source, this, labels)))
  {
    return 1;
  }
  problem = ShareLabels(image, labels);
  if (problem.empty() && labels.size() * (model.Regions.size() + 1) > MostConfusionEntries)
  {
    problem = std::to_string(labels.size()) + " labels and " +
      std::to_string(model.Regions.size()) + " regions make more than " +
      std::to_string(MostConfusionEntries) + " entries of the confusion table. Hide regions.";
  }
  if (fails())
  {
    return 1;
  }

  Counts counts;
  if (!image.All(vtkTFCQualityCounts::Count(source, classifier, labels, binning, this, counts)))
  {
    return 1;
  }
  Reduce(image, counts);
  std::vector<std::vector<double>> best;
  for (std::vector<Entry>& histogram : counts.Histograms)
  {
    best.push_back(
      vtkTFCLabelHistogram::BestDice(std::move(histogram), this->NumberOfBins, counts.Totals));
  }
  const bool rows =
    this->TablesOnAllProcesses || !this->Controller || this->Controller->GetLocalProcessId() == 0;
  const vtkTFCQualityTables::Result result = { *this->Model, model.Regions, labels, counts, best,
    names };
  vtkTFCQualityTables::FillQuality(result, rows, vtkTable::GetData(outputs, 0));
  vtkTFCQualityTables::FillConfusion(result, rows, vtkTable::GetData(outputs, 1));
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCClassificationQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LabelArray: " << (this->LabelArray ? this->LabelArray : "") << "\n";
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "IgnoredLabels:";
  for (const double label : this->IgnoredLabels)
  {
    os << " " << label;
  }
  os << "\n" << indent << "TablesOnAllProcesses: " << this->TablesOnAllProcesses << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "Model:\n";
  this->Model->PrintSelf(os, indent.GetNextIndent());
}
