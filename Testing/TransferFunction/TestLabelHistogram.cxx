// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The best set of cells against all subsets, and the cross-validation against its definition.
#include "vtkTFCLabelHistogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace vtkTFCLabelHistogram;

namespace
{
double Dice(std::int64_t hits, std::int64_t chosen, std::int64_t total)
{
  return 2. * static_cast<double>(hits) / static_cast<double>(chosen + total);
}

// The largest coefficient over all sets of cells.
double BestOfAllSubsets(const std::vector<Cell>& cells, std::int64_t total)
{
  double best = 0;
  for (unsigned set = 0; set < 1u << cells.size(); ++set)
  {
    std::int64_t hits = 0;
    std::int64_t chosen = 0;
    for (size_t i = 0; i < cells.size(); ++i)
    {
      hits += (set >> i & 1) ? cells[i].Label : 0;
      chosen += (set >> i & 1) ? cells[i].All : 0;
    }
    best = std::max(best, Dice(hits, chosen, total));
  }
  return best;
}

std::vector<Entry> Collect(const std::map<std::uint64_t, std::int64_t>& counts)
{
  std::vector<Entry> entries;
  entries.reserve(counts.size());
  for (const auto& count : counts)
  {
    entries.push_back({ count.first, count.second });
  }
  return entries;
}
}

TEST(LabelHistogram, PrefixByShareIsTheBestSetOfCells)
{
  std::mt19937 random(1);
  for (int round = 0; round < 400; ++round)
  {
    std::vector<Cell> cells(1 + random() % 10);
    std::int64_t total = random() % 5; // voxels in no cell
    for (Cell& cell : cells)
    {
      cell.Label = random() % 6;
      cell.All = std::max<std::int64_t>(1, cell.Label + random() % 9);
      total += cell.Label;
    }
    const double expected = total > 0 ? BestOfAllSubsets(cells, total) : 0;
    double dice = -1;
    const size_t count = ChooseCells(cells, total, dice);
    EXPECT_EQ(dice, expected) << "round " << round;
    std::int64_t hits = 0;
    std::int64_t chosen = 0;
    for (size_t i = 0; i < count; ++i)
    {
      hits += cells[i].Label;
      chosen += cells[i].All;
    }
    EXPECT_EQ(count > 0 ? Dice(hits, chosen, total) : 0, dice);
  }
}

TEST(LabelHistogram, CounterCountsAndMergeAdds)
{
  std::mt19937_64 random(2);
  std::map<std::uint64_t, std::int64_t> expected;
  std::vector<Counter> counters(3);
  for (int i = 0; i < 60000; ++i)
  {
    // Some keys often, zero among them, others once: the table grows.
    const std::uint64_t key = i % 3 ? random() % 50 : random() >> 21;
    counters[i % counters.size()].Add(key);
    ++expected[key];
  }
  std::vector<Entry> entries;
  for (const Counter& counter : counters)
  {
    counter.AppendTo(entries);
  }
  Merge(entries);
  ASSERT_EQ(entries.size(), expected.size());
  size_t i = 0;
  for (const auto& count : expected)
  {
    EXPECT_EQ(entries[i].Key, count.first);
    EXPECT_EQ(entries[i++].Count, count.second);
  }
  entries.clear();
  Merge(entries);
  EXPECT_TRUE(entries.empty());
}

TEST(LabelHistogram, HalvesJudgeEachOther)
{
  // Label 0: 8 + 6 voxels in a cell that it has nearly for itself, 1 elsewhere, 1 in no cell.
  // Three bins: there is no coarser resolution.
  std::map<std::uint64_t, std::int64_t> counts;
  counts[MakeKey(0, 0, 0)] = 8;
  counts[MakeKey(0, 0, 1)] = 6;
  counts[MakeKey(0, 1, 1)] = 2;
  counts[MakeKey(1, 1, 0)] = 50;
  counts[MakeKey(1, 1, 1)] = 40;
  counts[MakeKey(2, 0, 0)] = 1; // chosen by half 0, but half 1 has only the other label there
  counts[MakeKey(2, 1, 1)] = 5;
  const auto best = BestDice(Collect(counts), 3, { { { 10, 6 } }, { { 50, 47 } }, { { 0, 0 } } });
  ASSERT_EQ(best.size(), 3u);
  // Half 0 chooses cells 0 and 2, of which half 1 has 6 of 13; half 1 chooses cell 0: 8 of 8.
  EXPECT_DOUBLE_EQ(best[0], Dice(6 + 8, 13 + 8, 16));
  // Half 0 chooses cell 1 (half 1: 40 of 40). Half 1 chooses 1 and 2, and 0 with it would be worse:
  // of those half 0 has 50 of 51.
  EXPECT_DOUBLE_EQ(best[1], Dice(90, 91, 97));
  EXPECT_EQ(best[2], 0);
}

TEST(LabelHistogram, NoiseIsNotLearnt)
{
  // Labels at random: whatever the bins, at best all voxels are chosen, D = 2 p / (1 + p).
  std::mt19937 random(3);
  Counter counter;
  std::vector<std::array<std::int64_t, 2>> totals(2, { { 0, 0 } });
  for (int i = 0; i < 20000; ++i)
  {
    const std::uint32_t cell = random() % 64 | (random() % 64) << 10 | (random() % 64) << 20;
    const std::uint32_t label = random() % 4 == 0 ? 1 : 0;
    const std::uint32_t half = random() % 2;
    counter.Add(MakeKey(cell, label, half));
    ++totals[label][half];
  }
  std::vector<Entry> entries;
  counter.AppendTo(entries);
  Merge(entries);
  const auto best = BestDice(entries, 64, totals);
  EXPECT_NEAR(best[1], 2 * 0.25 / 1.25, 0.01);
  EXPECT_NEAR(best[0], 2 * 0.75 / 1.75, 0.01);
}

TEST(LabelHistogram, CoarserCellsHelpWhereVoxelsAreFew)
{
  // Two labels on the two sides of a plane through 1024^3 cells, 300 voxels: hardly any cell has
  // two of them, but any resolution knows the sides.
  std::mt19937 random(4);
  std::map<std::uint64_t, std::int64_t> counts;
  std::vector<std::array<std::int64_t, 2>> totals(2, { { 0, 0 } });
  for (int i = 0; i < 300; ++i)
  {
    const std::uint32_t x = random() % 1024;
    const std::uint32_t half = random() % 2;
    const std::uint32_t label = x < 512 ? 0 : 1;
    ++counts[MakeKey(x | (random() % 1024) << 10 | (random() % 1024) << 20, label, half)];
    ++totals[label][half];
  }
  const auto best = BestDice(Collect(counts), 1024, totals);
  EXPECT_GT(best[0], 0.9);
  EXPECT_GT(best[1], 0.9);
}
