// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCLabelHistogram.h"

#include <algorithm>
#include <iterator>

namespace
{
using vtkTFCLabelHistogram::Cell;
using vtkTFCLabelHistogram::Entry;

constexpr int FirstBits = 12;
constexpr int FewestBins = 4;

//------------------------------------------------------------------------------
// Voxels of one label in one cell.
struct Share
{
  size_t Cell;
  std::array<std::int64_t, 2> Count;
};

// A histogram as lists: all voxels of every cell, and the cells of every label.
struct Lists
{
  std::vector<std::array<std::int64_t, 2>> All;
  std::vector<std::vector<Share>> Labels;
};

//------------------------------------------------------------------------------
Lists Unpack(const std::vector<Entry>& entries, size_t numberOfLabels)
{
  constexpr std::uint64_t labelMask = vtkTFCLabelHistogram::MostLabels - 1;
  Lists lists;
  lists.Labels.resize(numberOfLabels);
  std::uint64_t cell = ~std::uint64_t{ 0 };
  for (const Entry& entry : entries)
  {
    if (entry.Key >> (vtkTFCLabelHistogram::LabelBits + 1) != cell)
    {
      cell = entry.Key >> (vtkTFCLabelHistogram::LabelBits + 1);
      lists.All.push_back({ { 0, 0 } });
    }
    const size_t half = entry.Key & 1;
    const size_t index = lists.All.size() - 1;
    lists.All.back()[half] += entry.Count;
    auto& shares = lists.Labels[(entry.Key >> 1) & labelMask];
    if (shares.empty() || shares.back().Cell != index)
    {
      shares.push_back({ index, { { 0, 0 } } });
    }
    shares.back().Count[half] += entry.Count;
  }
  return lists;
}

//------------------------------------------------------------------------------
// D of a label at one resolution, each half judged by the other one.
double CrossValidate(const Lists& lists, size_t label, const std::array<std::int64_t, 2>& totals)
{
  std::int64_t hits = 0;
  std::int64_t chosen = 0;
  std::vector<Cell> cells;
  for (size_t fit = 0; fit < 2; ++fit)
  {
    const size_t test = 1 - fit;
    cells.clear();
    for (const Share& share : lists.Labels[label])
    {
      if (share.Count[fit] > 0)
      {
        const auto& all = lists.All[share.Cell];
        cells.push_back({ share.Count[fit], all[fit], share.Count[test], all[test] });
      }
    }
    double dice;
    const size_t count = vtkTFCLabelHistogram::ChooseCells(cells, totals[fit], dice);
    for (size_t i = 0; i < count; ++i)
    {
      hits += cells[i].TestLabel;
      chosen += cells[i].TestAll;
    }
  }
  const std::int64_t both = totals[0] + totals[1] + chosen;
  return both > 0 ? 2. * static_cast<double>(hits) / static_cast<double>(both) : 0.;
}

//------------------------------------------------------------------------------
// Merge pairs of bins along every axis.
void Coarsen(std::vector<Entry>& entries)
{
  constexpr int bits = vtkTFCLabelHistogram::BitsPerAxis;
  constexpr std::uint64_t axis = (std::uint64_t{ 1 } << (bits - 1)) - 1;
  constexpr std::uint64_t mask = axis | axis << bits | axis << 2 * bits;
  constexpr int low = vtkTFCLabelHistogram::LabelBits + 1;
  constexpr std::uint64_t rest = (std::uint64_t{ 1 } << low) - 1;
  for (Entry& entry : entries)
  {
    entry.Key = ((((entry.Key >> low) >> 1) & mask) << low) | (entry.Key & rest);
  }
  vtkTFCLabelHistogram::Merge(entries);
}
}

namespace vtkTFCLabelHistogram
{
//------------------------------------------------------------------------------
Counter::Counter()
  : Slots(std::size_t{ 1 } << FirstBits)
  , Shift(64 - FirstBits)
{
}

//------------------------------------------------------------------------------
void Counter::Grow()
{
  std::vector<Entry> old(2 * this->Slots.size());
  old.swap(this->Slots);
  --this->Shift;
  for (const Entry& entry : old)
  {
    if (entry.Count != 0)
    {
      this->Find(entry.Key) = entry;
    }
  }
}

//------------------------------------------------------------------------------
void Counter::AppendTo(std::vector<Entry>& entries) const
{
  std::copy_if(this->Slots.begin(), this->Slots.end(), std::back_inserter(entries),
    [](const Entry& entry) { return entry.Count != 0; });
}

//------------------------------------------------------------------------------
void Merge(std::vector<Entry>& entries)
{
  std::sort(entries.begin(), entries.end(),
    [](const Entry& a, const Entry& b) { return a.Key < b.Key; });
  size_t last = 0;
  for (size_t i = 1; i < entries.size(); ++i)
  {
    if (entries[i].Key == entries[last].Key)
    {
      entries[last].Count += entries[i].Count;
    }
    else
    {
      entries[++last] = entries[i];
    }
  }
  entries.resize(std::min(entries.size(), last + 1));
}

//------------------------------------------------------------------------------
size_t ChooseCells(std::vector<Cell>& cells, std::int64_t total, double& dice)
{
  const auto share = [](const Cell& cell)
  { return static_cast<double>(cell.Label) / static_cast<double>(cell.All); };
  std::sort(cells.begin(), cells.end(),
    [&share](const Cell& a, const Cell& b) { return share(a) > share(b); });
  size_t best = 0;
  dice = 0;
  std::int64_t hits = 0;
  std::int64_t both = total;
  for (size_t i = 0; i < cells.size(); ++i)
  {
    hits += cells[i].Label;
    both += cells[i].All;
    const double d = 2. * static_cast<double>(hits) / static_cast<double>(both);
    // Cells of equal share go together: the choice does not depend on their order.
    const bool last = i + 1 == cells.size() || share(cells[i + 1]) < share(cells[i]);
    if (last && d > dice)
    {
      dice = d;
      best = i + 1;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
std::vector<double> BestDice(std::vector<Entry> entries, int bins,
  const std::vector<std::array<std::int64_t, 2>>& totals)
{
  std::vector<double> best(totals.size(), 0.);
  while (true)
  {
    const Lists lists = Unpack(entries, totals.size());
    for (size_t label = 0; label < totals.size(); ++label)
    {
      best[label] = std::max(best[label], CrossValidate(lists, label, totals[label]));
    }
    bins = (bins + 1) / 2;
    if (bins < FewestBins)
    {
      return best;
    }
    Coarsen(entries);
  }
}
}
