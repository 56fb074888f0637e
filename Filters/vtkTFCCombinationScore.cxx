// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCCombinationScore.h"

#include "Kernels/TFCScore.h"
#include "vtkTFCAttributeAgreement.h"
#include "vtkTFCAttributeInformation.h"
#include "vtkTFCAttributeSamples.h"
#include "vtkTFCAttributeStatistics.h"
#include "vtkTFCDistributedImage.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
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
/**
 * The candidates, best first.
 */
std::string MakeRanking(const std::vector<int>& ranks, const std::vector<Attribute>& attributes)
{
  std::string text;
  for (int rank = 1; rank <= static_cast<int>(ranks.size()); ++rank)
  {
    const auto found = std::find(ranks.begin(), ranks.end(), rank);
    text += found == ranks.end()
      ? ""
      : (rank > 1 ? ", " : "") + attributes[static_cast<size_t>(found - ranks.begin())].Label;
  }
  return text;
}

//------------------------------------------------------------------------------
/**
 * Whether the ranking depends on the bins, as the rest of a sentence.
 */
std::string MakeBinSentence(double balance, const std::vector<std::string>& rankings)
{
  if (rankings.empty() || rankings[0].empty())
  {
    return {};
  }
  char text[96];
  const auto other = std::find_if(rankings.begin(), rankings.end(),
    [&](const std::string& ranking) { return ranking != rankings[0]; });
  if (other == rankings.end())
  {
    std::snprintf(text, sizeof(text), "; for a = %.3g bins up to %d times as wide rank alike",
      balance, 1 << (rankings.size() - 1));
    return text;
  }
  std::snprintf(text, sizeof(text),
    "; for a = %.3g bins %d times as wide rank differently: ", balance,
    1 << (other - rankings.begin()));
  return text + *other;
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

//------------------------------------------------------------------------------
void AddInformation(const std::vector<int>& rows, const std::vector<tfc::Information>& information,
  int primary, int secondary, vtkTable* table)
{
  std::vector<double> columns[4];
  for (const int i : rows)
  {
    const tfc::Information& info = information[static_cast<size_t>(i)];
    const bool measured = i != primary && i != secondary && info.Samples > 0.;
    const double separation = info.Entropy > 0. ? info.New / info.Entropy : 0.;
    const double values[4] = { info.Mutual, info.ConditionalMutual, info.New, separation };
    for (int c = 0; c < 4; ++c)
    {
      columns[c].push_back(measured ? values[c] : std::numeric_limits<double>::quiet_NaN());
    }
  }
  AddColumn<vtkDoubleArray>(table, "mutual_information", columns[0]);
  AddColumn<vtkDoubleArray>(table, "conditional_mutual_information", columns[1]);
  AddColumn<vtkDoubleArray>(table, "new_information", columns[2]);
  AddColumn<vtkDoubleArray>(table, "separation", columns[3]);
}
}

//------------------------------------------------------------------------------
vtkTFCCombinationScore::vtkTFCCombinationScore()
{
  this->SetNumberOfOutputPorts(4);
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
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCCombinationScore::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  std::vector<std::string> axes;
  for (const char* axis : { this->Primary, this->Secondary })
  {
    if (IsSet(axis))
    {
      axes.emplace_back(axis);
    }
  }
  vtkTFCAttributeAgreement agreement(this->Controller, this->FillValues);
  agreement.CheckScoring(this->Balance, this->NumberOfBins);
  const bool agreed = agreement.Find(input, this->Arrays, axes);
  if (!agreement.GetWarning().empty())
  {
    vtkWarningMacro(<< agreement.GetWarning());
  }
  if (!agreed)
  {
    vtkErrorMacro(<< agreement.GetProblem() << " No scores were computed.");
    return 1;
  }
  const std::vector<Attribute>& attributes = agreement.GetAttributes();
  const vtkTFCDistributedImage& image = agreement.GetImage();

  const int primary = IsSet(this->Primary) ? std::max(0, FindLabel(attributes, this->Primary)) : 0;
  const int secondary = IsSet(this->Secondary) ? FindLabel(attributes, this->Secondary) : -1;
  const vtkTFCAttributeSamples& samples = agreement.GetSamples();
  vtkTFCAttributeStatistics::Result statistics;
  std::vector<tfc::Information> information;
  if (!vtkTFCAttributeStatistics::Compute(samples, image, attributes, this->NumberOfBins, this,
        statistics) ||
    (this->MeasureInformation &&
      !vtkTFCAttributeInformation::Compute(samples, image, statistics.Summaries, primary, secondary,
        this, information)))
  {
    return 1;
  }
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
  if (this->MeasureInformation)
  {
    AddInformation(order, information, primary, secondary, table);
  }

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
  std::vector<int> merged;
  std::vector<std::string> rankings;
  for (size_t c = 0; c < statistics.CoarseEntropies.size(); ++c)
  {
    const tfc::Scores coarse = tfc::CombinationScores(statistics.Correlations,
      statistics.CoarseEntropies[c], this->Balance, primary, secondary);
    merged.push_back(1 << c);
    rankings.push_back(MakeRanking(coarse.Rank, attributes));
  }
  vtkNew<vtkStringArray> sentence;
  sentence->SetName("summary");
  sentence->InsertNextValue(
    MakeSentence(intervals, attributes) + MakeBinSentence(this->Balance, rankings));
  if (order.empty())
  {
    merged.clear();
    rankings.clear();
  }
  vtkTable* overBins = vtkTable::GetData(outputVector, 3);
  AddColumn<vtkIntArray>(overBins, "merged_bins", merged);
  AddColumn<vtkStringArray>(overBins, "ranking", rankings);
  stability->GetFieldData()->AddArray(sentence);
  return 1;
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
  os << indent << "MeasureInformation: " << this->MeasureInformation << "\n";
  os << indent << "TablesOnAllProcesses: " << this->TablesOnAllProcesses << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
