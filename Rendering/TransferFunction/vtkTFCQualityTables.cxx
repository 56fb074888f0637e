// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCQualityTables.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTFCQualityCounts.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTable.h"

namespace
{
// What counts as good enough, in `limited_by`.
constexpr double GoodEnough = 0.95;

//------------------------------------------------------------------------------
template <typename Column>
Column* AddColumn(vtkTable* table, const std::string& name)
{
  vtkNew<Column> column;
  column->SetName(name.c_str());
  table->AddColumn(column);
  return column;
}

//------------------------------------------------------------------------------
double Ratio(std::int64_t part, std::int64_t whole)
{
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.;
}
}

namespace vtkTFCQualityTables
{
//------------------------------------------------------------------------------
void FillConfusion(const Result& result, bool rows, vtkTable* table)
{
  const std::vector<double>& labels = result.Labels;
  const std::vector<vtkTFCCompiledRegion>& regions = result.Regions;
  const size_t columns = regions.size() + 1;
  // All columns first: a table takes no column that is shorter than the others.
  std::vector<vtkIdTypeArray*> all = { AddColumn<vtkIdTypeArray>(table, "label") };
  for (size_t c = 0; c < columns; ++c)
  {
    all.push_back(AddColumn<vtkIdTypeArray>(table,
      c == 0 ? "none" : "region " + std::to_string(regions[c - 1].Id)));
  }
  for (size_t row = 0; rows && row < labels.size(); ++row)
  {
    all[0]->InsertNextValue(static_cast<vtkIdType>(labels[row]));
    for (size_t c = 0; c < columns; ++c)
    {
      all[c + 1]->InsertNextValue(result.Data.Confusion[row * columns + c]);
    }
  }
}

//------------------------------------------------------------------------------
void FillQuality(const Result& result, bool rows, vtkTable* table)
{
  const std::vector<double>& labels = result.Labels;
  const std::vector<vtkTFCCompiledRegion>& regions = result.Regions;
  const vtkTFCQualityCounts::Counts& counts = result.Data;
  const std::vector<std::vector<double>>& best = result.Best;
  auto* label = AddColumn<vtkIdTypeArray>(table, "label");
  auto* voxels = AddColumn<vtkIdTypeArray>(table, "voxels");
  auto* region = AddColumn<vtkIntArray>(table, "region");
  auto* regionName = AddColumn<vtkStringArray>(table, "region_name");
  auto* precision = AddColumn<vtkDoubleArray>(table, "precision");
  auto* recall = AddColumn<vtkDoubleArray>(table, "recall");
  auto* dice = AddColumn<vtkDoubleArray>(table, "dice");
  auto* leakage = AddColumn<vtkDoubleArray>(table, "leakage");
  auto* axesDice = AddColumn<vtkDoubleArray>(table, "axes_dice");
  auto* bestDice = AddColumn<vtkDoubleArray>(table, "best_dice");
  auto* bestAttribute = AddColumn<vtkStringArray>(table, "best_attribute");
  auto* limit = AddColumn<vtkStringArray>(table, "limited_by");

  const size_t columns = regions.size() + 1;
  std::vector<std::int64_t> sizes(columns, 0);
  for (size_t i = 0; i < counts.Confusion.size(); ++i)
  {
    sizes[i % columns] += counts.Confusion[i];
  }
  for (size_t row = 0; rows && row < labels.size(); ++row)
  {
    const std::int64_t total = counts.Totals[row][0] + counts.Totals[row][1];
    size_t found = 0;
    double reached = 0;
    for (size_t c = 1; c < columns; ++c)
    {
      const double d = Ratio(2 * counts.Confusion[row * columns + c], total + sizes[c]);
      if (d > reached)
      {
        reached = d;
        found = c;
      }
    }
    size_t winner = 0;
    for (size_t h = 1; h < best.size(); ++h)
    {
      winner = best[h][row] > best[winner][row] ? h : winner;
    }
    const double possible = best[winner][row];
    const std::int64_t both = found > 0 ? counts.Confusion[row * columns + found] : 0;
    const vtkTFCRegion* object =
      found > 0 ? result.Model.GetRegionById(regions[found - 1].Id) : nullptr;
    label->InsertNextValue(static_cast<vtkIdType>(labels[row]));
    voxels->InsertNextValue(total);
    region->InsertNextValue(found > 0 ? regions[found - 1].Id : 0);
    regionName->InsertNextValue(object ? object->GetName() : "");
    precision->InsertNextValue(Ratio(both, sizes[found]));
    recall->InsertNextValue(Ratio(both, total));
    dice->InsertNextValue(reached);
    leakage->InsertNextValue(found > 0 ? Ratio(sizes[found] - both, sizes[found]) : 0.);
    axesDice->InsertNextValue(best[0][row]);
    bestDice->InsertNextValue(possible);
    bestAttribute->InsertNextValue(result.Names[winner]);
    limit->InsertNextValue(reached >= GoodEnough ? "neither"
        : possible - reached > 1 - possible      ? "regions"
                                                 : "axes");
  }
}
}
