// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAxisSuggestion.h"

#include "Kernels/TFCScore.h"
#include "vtkTFCAttributeAgreement.h"
#include "vtkTFCAttributeInformation.h"
#include "vtkTFCAttributeStatistics.h"

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
#include <limits>

vtkStandardNewMacro(vtkTFCAxisSuggestion);
vtkCxxSetObjectMacro(vtkTFCAxisSuggestion, Controller, vtkMultiProcessController);

namespace
{
using vtkTFCAttributeStatistics::Attribute;

//------------------------------------------------------------------------------
struct Pair
{
  const char* Kind;
  int Primary, Secondary;
  double Score;
};

//------------------------------------------------------------------------------
int FindLabel(const std::vector<Attribute>& attributes, const std::string& label)
{
  const auto found = std::find_if(attributes.begin(), attributes.end(),
    [&](const Attribute& attribute) { return attribute.Label == label; });
  return found == attributes.end() ? -1 : static_cast<int>(found - attributes.begin());
}

//------------------------------------------------------------------------------
bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

//------------------------------------------------------------------------------
/**
 * Whether the name is what a property filter makes of another array: the array itself, or another
 * one made from it, is there.
 */
bool IsDerived(const std::string& label, const std::vector<Attribute>& attributes)
{
  for (const char* suffix :
    { "_gradient", "_mean", "_stddev", "_radius", "_skewness", "_kurtosis", "_occlusion", "_size" })
  {
    if (EndsWith(label, suffix))
    {
      const std::string base = label.substr(0, label.size() - std::string(suffix).size());
      return std::any_of(attributes.begin(), attributes.end(),
        [&](const Attribute& other)
        {
          return other.Label == base ||
            (other.Label != label && other.Label.compare(0, base.size() + 1, base + "_") == 0);
        });
    }
  }
  return false;
}

//------------------------------------------------------------------------------
class PairFinder
{
public:
  PairFinder(const std::vector<Attribute>& attributes,
    const vtkTFCAttributeStatistics::Result& statistics, double balance)
    : Attributes(attributes)
    , Statistics(statistics)
    , Balance(balance)
    , Largest(*std::max_element(statistics.Entropies.begin(), statistics.Entropies.end()))
  {
  }

  /**
   * Pairs that belong together, best first.
   */
  std::vector<Pair> FindAssociated() const
  {
    std::vector<Pair> pairs;
    for (int i = 0; i < this->Count(); ++i)
    {
      const std::string& label = this->Attributes[i].Label;
      this->Add(pairs, "value and gradient", i, FindLabel(this->Attributes, label + "_gradient"));
      if (EndsWith(label, "_mean"))
      {
        this->Add(pairs, "mean and deviation", i,
          FindLabel(this->Attributes, label.substr(0, label.size() - 5) + "_stddev"));
      }
    }
    return Sorted(pairs);
  }

  /**
   * Any two that are not made from others, best first.
   */
  std::vector<Pair> FindMultivariate() const
  {
    std::vector<Pair> pairs;
    for (int i = 0; i < this->Count(); ++i)
    {
      for (int j = i + 1; j < this->Count(); ++j)
      {
        if (!IsDerived(this->Attributes[i].Label, this->Attributes) &&
          !IsDerived(this->Attributes[j].Label, this->Attributes))
        {
          const bool swap = this->Statistics.Entropies[j] > this->Statistics.Entropies[i];
          this->Add(pairs, "multivariate", swap ? j : i, swap ? i : j);
        }
      }
    }
    return Sorted(pairs);
  }

private:
  int Count() const { return static_cast<int>(this->Attributes.size()); }

  void Add(std::vector<Pair>& pairs, const char* kind, int primary, int secondary) const
  {
    if (secondary < 0)
    {
      return;
    }
    const auto k = this->Attributes.size();
    const double r =
      this->Statistics
        .Correlations[static_cast<size_t>(primary) * k + static_cast<size_t>(secondary)];
    const double information = 0.5 *
      (this->Statistics.Entropies[static_cast<size_t>(primary)] +
        this->Statistics.Entropies[static_cast<size_t>(secondary)]);
    // Undefined: one of them is constant.
    if (!std::isnan(r) && this->Largest > 0.)
    {
      pairs.push_back({ kind, primary, secondary,
        -this->Balance * std::abs(r) + (1. - this->Balance) * information / this->Largest });
    }
  }

  static std::vector<Pair> Sorted(std::vector<Pair> pairs)
  {
    std::stable_sort(pairs.begin(), pairs.end(),
      [](const Pair& a, const Pair& b) { return a.Score > b.Score; });
    return pairs;
  }

  const std::vector<Attribute>& Attributes;
  const vtkTFCAttributeStatistics::Result& Statistics;
  double Balance, Largest;
};

//------------------------------------------------------------------------------
/**
 * The table under construction.
 */
struct Rows
{
  vtkNew<vtkIntArray> Pair, Rank;
  vtkNew<vtkStringArray> Kind, Primary, Secondary, Tertiary;
  vtkNew<vtkDoubleArray> PairScore, Score, New, Separation;

  void AddTo(vtkTable* table, bool information)
  {
    const std::pair<const char*, vtkAbstractArray*> columns[] = { { "pair", this->Pair },
      { "kind", this->Kind }, { "primary", this->Primary }, { "secondary", this->Secondary },
      { "pair_score", this->PairScore }, { "tertiary", this->Tertiary }, { "score", this->Score },
      { "rank", this->Rank }, { "new_information", this->New },
      { "separation", this->Separation } };
    for (size_t c = 0; c < (information ? 10 : 8); ++c)
    {
      columns[c].second->SetName(columns[c].first);
      table->AddColumn(columns[c].second);
    }
  }
};
}

//------------------------------------------------------------------------------
vtkTFCAxisSuggestion::vtkTFCAxisSuggestion()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkTFCAxisSuggestion::~vtkTFCAxisSuggestion()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkTFCAxisSuggestion::AddArray(const char* name)
{
  if (name && *name)
  {
    this->Arrays.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCAxisSuggestion::ClearArrays()
{
  this->Arrays.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTFCAxisSuggestion::AddFillValue(double value)
{
  this->FillValues.push_back(value);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTFCAxisSuggestion::ClearFillValues()
{
  this->FillValues.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkTFCAxisSuggestion::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCAxisSuggestion::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkTFCAttributeAgreement agreement(this->Controller, this->FillValues);
  agreement.CheckScoring(this->Balance, this->NumberOfBins);
  const bool agreed = agreement.Find(input, this->Arrays, {});
  if (!agreement.GetWarning().empty())
  {
    vtkWarningMacro(<< agreement.GetWarning());
  }
  if (!agreed)
  {
    vtkErrorMacro(<< agreement.GetProblem() << " Nothing is suggested.");
    return 1;
  }
  const std::vector<Attribute>& attributes = agreement.GetAttributes();
  const vtkTFCDistributedImage& image = agreement.GetImage();
  const vtkTFCAttributeSamples& samples = agreement.GetSamples();
  vtkTFCAttributeStatistics::Result statistics;
  if (!vtkTFCAttributeStatistics::Compute(samples, image, attributes, this->NumberOfBins, this,
        statistics))
  {
    return 1;
  }

  const PairFinder finder(attributes, statistics, this->Balance);
  std::vector<Pair> pairs = finder.FindAssociated();
  const std::vector<Pair> others = finder.FindMultivariate();
  const auto taken = std::min<size_t>(others.size(), static_cast<size_t>(this->NumberOfPairs));
  pairs.insert(pairs.end(), others.begin(), others.begin() + static_cast<std::ptrdiff_t>(taken));

  const bool fill =
    this->TablesOnAllProcesses || !this->Controller || this->Controller->GetLocalProcessId() == 0;
  std::string summary;
  Rows rows;
  for (size_t p = 0; p < pairs.size(); ++p)
  {
    const Pair& pair = pairs[p];
    std::vector<tfc::Information> information(attributes.size());
    if (this->MeasureInformation &&
      !vtkTFCAttributeInformation::Compute(samples, image, statistics.Summaries, pair.Primary,
        pair.Secondary, this, information))
    {
      return 1;
    }
    const tfc::Scores scores = tfc::CombinationScores(statistics.Correlations, statistics.Entropies,
      this->Balance, pair.Primary, pair.Secondary);
    const std::string& primary = attributes[static_cast<size_t>(pair.Primary)].Label;
    const std::string& secondary = attributes[static_cast<size_t>(pair.Secondary)].Label;
    for (int rank = 0; rank <= static_cast<int>(attributes.size()); ++rank)
    {
      const auto found = std::find(scores.Rank.begin(), scores.Rank.end(), rank);
      // A pair without any candidate has one row, of rank 0.
      const bool none = *std::max_element(scores.Rank.begin(), scores.Rank.end()) == 0;
      if (found == scores.Rank.end() || (rank == 0) != none)
      {
        continue;
      }
      const auto i = static_cast<size_t>(found - scores.Rank.begin());
      const tfc::Information& info = information[i];
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      if (p == 0 && rank <= 1)
      {
        summary = "Use ";
        summary += primary;
        summary += " and ";
        summary += secondary;
        summary += " as the axes";
        summary += none ? "; there is no candidate for the tertiary attribute" : " and ";
        summary += none ? "" : attributes[i].Label + " as the tertiary attribute";
      }
      if (fill)
      {
        rows.Pair->InsertNextValue(static_cast<int>(p) + 1);
        rows.Kind->InsertNextValue(pair.Kind);
        rows.Primary->InsertNextValue(primary);
        rows.Secondary->InsertNextValue(secondary);
        rows.PairScore->InsertNextValue(pair.Score);
        rows.Tertiary->InsertNextValue(none ? "" : attributes[i].Label);
        rows.Score->InsertNextValue(none ? nan : scores.Score[i]);
        rows.Rank->InsertNextValue(rank);
        rows.New->InsertNextValue(none ? nan : info.New);
        rows.Separation->InsertNextValue(none ? nan
            : info.Entropy > 0.               ? info.New / info.Entropy
                                              : 0.);
      }
    }
  }
  if (pairs.empty())
  {
    summary = "No two attributes vary: compute others, for example with the filter Volume Gradient "
              "Magnitude";
  }
  vtkTable* table = vtkTable::GetData(outputs, 0);
  rows.AddTo(table, this->MeasureInformation);
  vtkNew<vtkStringArray> sentence;
  sentence->SetName("summary");
  sentence->InsertNextValue(summary);
  table->GetFieldData()->AddArray(sentence);
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCAxisSuggestion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arrays:";
  for (const std::string& name : this->Arrays)
  {
    os << " " << name;
  }
  os << "\n" << indent << "Balance: " << this->Balance << "\n";
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "NumberOfPairs: " << this->NumberOfPairs << "\n";
  os << indent << "MeasureInformation: " << this->MeasureInformation << "\n";
  os << indent << "TablesOnAllProcesses: " << this->TablesOnAllProcesses << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
