// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCCombinationScore.h"

#include "Kernels/TFCScore.h"
#include "vtkTFCAttributeStatistics.h"
#include "vtkTFCDistributedImage.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTFCCombinationScore);
vtkCxxSetObjectMacro(vtkTFCCombinationScore, Controller, vtkMultiProcessController);

namespace
{
using vtkTFCAttributeStatistics::Attribute;

//------------------------------------------------------------------------------
bool IsSet(const char* name)
{
  return name && *name && std::strcmp(name, "None") != 0;
}

//------------------------------------------------------------------------------
int FindLabel(const std::vector<Attribute>& attributes, const std::string& label)
{
  const auto found = std::find_if(attributes.begin(), attributes.end(),
    [&](const Attribute& attribute) { return attribute.Label == label; });
  return found == attributes.end() ? -1 : static_cast<int>(found - attributes.begin());
}

//------------------------------------------------------------------------------
/**
 * What processes must agree on, as one text, and back. Line feeds end entries.
 */
std::string Describe(const std::vector<Attribute>& attributes)
{
  std::string text;
  for (const Attribute& attribute : attributes)
  {
    text += (attribute.Integer ? "i" : "f") + attribute.Label + '\n';
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<Attribute> FromDescription(const std::string& text)
{
  std::vector<Attribute> attributes;
  for (size_t begin = 0; begin < text.size();)
  {
    const size_t end = text.find('\n', begin);
    Attribute attribute;
    attribute.Integer = text[begin] == 'i';
    attribute.Label = text.substr(begin + 1, end - begin - 1);
    attributes.push_back(attribute);
    begin = end + 1;
  }
  return attributes;
}

//------------------------------------------------------------------------------
/**
 * Which attributes are first, as a sentence.
 */
std::string MakeSentence(const std::vector<tfc::RankingInterval>& intervals,
  const std::vector<Attribute>& attributes)
{
  std::string text;
  const auto format = [](double value)
  {
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%.3g", value);
    return std::string(digits);
  };
  for (size_t i = 0; i < intervals.size();)
  {
    size_t last = i;
    while (last + 1 < intervals.size() && intervals[last + 1].Order[0] == intervals[i].Order[0])
    {
      ++last;
    }
    text += (text.empty() ? "" : ", ") + attributes[intervals[i].Order[0]].Label + " is first for ";
    text += i == 0 && last + 1 == intervals.size() ? "every balance"
      : i == 0                                     ? "a < " + format(intervals[last].To)
      : last + 1 == intervals.size()
      ? "a > " + format(intervals[i].From)
      : "a from " + format(intervals[i].From) + " to " + format(intervals[last].To);
    i = last + 1;
  }
  return text.empty() ? "no attribute is a candidate" : text;
}

//------------------------------------------------------------------------------
template <typename Column, typename Value>
void AddColumn(vtkTable* table, const char* name, const std::vector<Value>& values)
{
  vtkNew<Column> column;
  column->SetName(name);
  for (const Value& value : values)
  {
    column->InsertNextValue(value);
  }
  table->AddColumn(column);
}
}

//------------------------------------------------------------------------------
vtkTFCCombinationScore::vtkTFCCombinationScore()
{
  this->SetNumberOfOutputPorts(3);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkTFCCombinationScore::~vtkTFCCombinationScore()
{
  this->SetController(nullptr);
  this->SetPrimary(nullptr);
  this->SetSecondary(nullptr);
}

//------------------------------------------------------------------------------
void vtkTFCCombinationScore::AddArray(const char* name)
{
  if (name && *name)
  {
    this->Arrays.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCCombinationScore::ClearArrays()
{
  this->Arrays.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTFCCombinationScore::AddFillValue(double value)
{
  this->FillValues.push_back(value);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTFCCombinationScore::ClearFillValues()
{
  this->FillValues.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkTFCCombinationScore::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCCombinationScore::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  std::string problem;
  std::vector<Attribute> attributes;
  if (!(this->Balance >= 0. && this->Balance < 1.))
  {
    problem = "Balance is " + std::to_string(this->Balance) + ". Set it to 0 or more, below 1.";
  }
  else if (this->NumberOfBins < 2 || this->NumberOfBins > 65536)
  {
    problem = "NumberOfBins is " + std::to_string(this->NumberOfBins) + ". Set it to 2 to 65536.";
  }
  else if (!isEmpty)
  {
    problem = this->FindAttributes(input->GetPointData(), attributes);
  }

  // From here on every process takes the same way, whatever it found.
  const vtkTFCDistributedImage image(input, vtkDataObject::FIELD_ASSOCIATION_POINTS,
    this->Controller);
  if (!image.Any(!isEmpty) && problem.empty())
  {
    problem = "The input is empty. Connect a volume with at least one point.";
  }
  const std::string shared = image.ShareText(!isEmpty, Describe(attributes));
  if (problem.empty() && !isEmpty && shared != Describe(attributes))
  {
    problem = "The processes hold different point arrays, or in another order. List those that all "
              "have in Arrays.";
  }
  if (!image.All(problem.empty()))
  {
    vtkErrorMacro(<< (problem.empty()
                         ? "Another process cannot use its piece of the input: see the "
                           "message there."
                         : problem)
                  << " No scores were computed.");
    return 1;
  }
  if (isEmpty)
  {
    attributes = FromDescription(shared);
  }

  vtkTFCAttributeStatistics::Result statistics;
  if (!vtkTFCAttributeStatistics::Compute(input, image, attributes, this->FillValues,
        this->NumberOfBins, this, statistics))
  {
    return 1;
  }

  const int primary = IsSet(this->Primary) ? std::max(0, FindLabel(attributes, this->Primary)) : 0;
  const int secondary = IsSet(this->Secondary) ? FindLabel(attributes, this->Secondary) : -1;
  const tfc::Scores scores = tfc::CombinationScores(statistics.Correlations, statistics.Entropies,
    this->Balance, primary, secondary);

  // Best first; then the primary, the secondary and the undefined ones.
  const int k = static_cast<int>(attributes.size());
  std::vector<int> order(attributes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      const auto place = [&](int i)
      {
        return scores.Rank[i] > 0 ? scores.Rank[i]
          : i == primary          ? k + 1
          : i == secondary        ? k + 2
                                  : k + 3;
      };
      return place(a) < place(b);
    });
  if (!this->TablesOnAllProcesses && this->Controller && this->Controller->GetLocalProcessId() > 0)
  {
    order.clear();
  }

  std::vector<std::string> names;
  std::vector<double> correlations, entropies, values;
  std::vector<int> ranks;
  for (const int i : order)
  {
    names.push_back(attributes[i].Label);
    correlations.push_back(statistics.Correlations[primary * k + i]);
    entropies.push_back(statistics.Entropies[i]);
    values.push_back(scores.Score[i]);
    ranks.push_back(scores.Rank[i]);
  }
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  AddColumn<vtkStringArray>(table, "attribute", names);
  AddColumn<vtkDoubleArray>(table, "correlation", correlations);
  AddColumn<vtkDoubleArray>(table, "entropy", entropies);
  AddColumn<vtkDoubleArray>(table, "score", values);
  AddColumn<vtkIntArray>(table, "rank", ranks);

  vtkTable* matrix = vtkTable::GetData(outputVector, 1);
  names.clear();
  for (int i = 0; i < k && !order.empty(); ++i)
  {
    names.push_back(attributes[i].Label);
  }
  AddColumn<vtkStringArray>(matrix, "attribute", names);
  for (int i = 0; i < k; ++i)
  {
    // The matrix is symmetric: a row is a column.
    const double* row = statistics.Correlations.data() + static_cast<size_t>(i) * k;
    AddColumn<vtkDoubleArray>(matrix, attributes[i].Label.c_str(),
      std::vector<double>(row, row + names.size()));
  }

  const auto intervals =
    tfc::RankingIntervals(statistics.Correlations, statistics.Entropies, primary, secondary);
  std::vector<double> from, to;
  names.clear();
  for (const tfc::RankingInterval& interval : intervals)
  {
    if (order.empty())
    {
      break;
    }
    from.push_back(interval.From);
    to.push_back(interval.To);
    std::string ranking;
    for (const int i : interval.Order)
    {
      ranking += (ranking.empty() ? "" : ", ") + attributes[i].Label;
    }
    names.push_back(ranking);
  }
  vtkTable* stability = vtkTable::GetData(outputVector, 2);
  AddColumn<vtkDoubleArray>(stability, "from", from);
  AddColumn<vtkDoubleArray>(stability, "to", to);
  AddColumn<vtkStringArray>(stability, "ranking", names);
  vtkNew<vtkStringArray> sentence;
  sentence->SetName("summary");
  sentence->InsertNextValue(MakeSentence(intervals, attributes));
  stability->GetFieldData()->AddArray(sentence);
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkTFCCombinationScore::FindAttributes(vtkPointData* points,
  std::vector<Attribute>& attributes) const
{
  std::vector<std::string> wanted = this->Arrays;
  if (wanted.empty())
  {
    attributes = vtkTFCAttributeStatistics::FindAll(points);
  }
  for (const char* axis : { this->Primary, this->Secondary })
  {
    if (IsSet(axis))
    {
      wanted.emplace_back(axis);
    }
  }
  for (const std::string& name : wanted)
  {
    // Lists of all arrays, such as ParaView's, contain the flags: they are no data.
    if (name == vtkDataSetAttributes::GhostArrayName())
    {
      continue;
    }
    Attribute attribute;
    std::string problem = vtkTFCAttributeStatistics::Find(points, name, attribute);
    if (!problem.empty())
    {
      return problem;
    }
    if (FindLabel(attributes, name) < 0)
    {
      attributes.push_back(attribute);
    }
  }
  if (attributes.empty())
  {
    return "The input has no numeric single-component point array. Apply the filter Cell Data to "
           "Point Data first, or name components in Arrays, such as 'velocity:0'.";
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkTFCCombinationScore::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arrays:";
  for (const std::string& name : this->Arrays)
  {
    os << " " << name;
  }
  os << "\n" << indent << "Primary: " << (this->Primary ? this->Primary : "") << "\n";
  os << indent << "Secondary: " << (this->Secondary ? this->Secondary : "") << "\n";
  os << indent << "Balance: " << this->Balance << "\n";
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "TablesOnAllProcesses: " << this->TablesOnAllProcesses << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
