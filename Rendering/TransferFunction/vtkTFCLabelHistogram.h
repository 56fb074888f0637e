// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How many voxels of each label lie in each cell of a joint histogram, and the best Dice
 * coefficient that a set of its cells can have.
 *
 * Counts are kept for the two halves of the voxels, and only for cells that hold something: 16
 * bytes per occupied cell, label and half, two to four times that while counting.
 *
 * The Dice coefficient of a set S of cells and a label with L voxels is
 * D(S) = 2 sum_S l / (L + sum_S n), where l are the label's voxels in a cell and n all of them.
 * The best S is { l / n > t } for some t: D(S) >= d exactly when sum_S (2 l - d n) >= d L, and the
 * set that makes this sum largest has the cells with l / n > d / 2. So sorting by share and trying
 * every threshold finds the optimum.
 *
 * The best set is chosen on one half and judged on the other, and the other way round, so that
 * every voxel is judged once, by cells that were chosen without it: D = 2 (l_01 + l_10) / (L + n_01
 * + n_10). Fine cells that only learn the noise lose by that. As cells may be too fine for the
 * number of voxels, the same is done with pairs of bins merged along every axis, again and again
 * down to 4 bins, and the largest D counts.
 */

#ifndef vtkTFCLabelHistogram_h
#define vtkTFCLabelHistogram_h

#include "vtkTFCTransferFunctionModule.h" // For export macro

#include <array>   // For halves
#include <cstddef> // For size_t
#include <cstdint> // For keys
#include <vector>  // For lists

namespace vtkTFCLabelHistogram
{
constexpr int BitsPerAxis = 10;
constexpr int MostBins = 1 << BitsPerAxis;
constexpr int LabelBits = 12;
constexpr int MostLabels = 1 << LabelBits;

/**
 * A cell (the bins of up to three axes, BitsPerAxis bits each), a label's index and a half (0, 1).
 */
inline std::uint64_t MakeKey(std::uint32_t cell, std::uint32_t label, std::uint32_t half)
{
  return (static_cast<std::uint64_t>(cell) << (LabelBits + 1)) | (label << 1) | half;
}

struct Entry
{
  std::uint64_t Key = 0;
  std::int64_t Count = 0;
};

/**
 * Counts keys: a hash table with open addressing. Not thread-safe, one per thread.
 */
class VTKTFCTRANSFERFUNCTION_EXPORT Counter
{
public:
  Counter();
  void Add(std::uint64_t key)
  {
    Entry& slot = this->Find(key);
    if (slot.Count == 0)
    {
      slot.Key = key;
      ++this->Used;
    }
    ++slot.Count;
    if (this->Used > this->Slots.size() / 2)
    {
      this->Grow();
    }
  }
  void AppendTo(std::vector<Entry>& entries) const;

private:
  Entry& Find(std::uint64_t key)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t at = (key * 0x9E3779B97F4A7C15u) >> this->Shift;
    while (this->Slots[at].Count != 0 && this->Slots[at].Key != key)
    {
      at = (at + 1) & mask;
    }
    return this->Slots[at];
  }
  void Grow();

  std::vector<Entry> Slots;
  std::size_t Used = 0;
  int Shift;
};

/**
 * Sort by key and add up equal keys.
 */
VTKTFCTRANSFERFUNCTION_EXPORT void Merge(std::vector<Entry>& entries);

/**
 * What one cell holds: voxels of the label and of all labels, in the half that chooses and in the
 * half that judges.
 */
struct Cell
{
  std::int64_t Label = 0, All = 0;
  std::int64_t TestLabel = 0, TestAll = 0;
};

/**
 * Sort cells so that the best set for a label with `total` voxels comes first, and return its size.
 * `dice` is its coefficient, 0 when no cell holds the label. Cost: n log n.
 */
VTKTFCTRANSFERFUNCTION_EXPORT std::size_t ChooseCells(std::vector<Cell>& cells, std::int64_t total,
  double& dice);

/**
 * The largest cross-validated D of every label over all resolutions, see above. `entries` must be
 * merged; `totals` are the voxels of each label in the two halves, those outside of all cells too.
 * 0 for labels without voxels in both halves. Cost: n log n for n entries.
 */
VTKTFCTRANSFERFUNCTION_EXPORT std::vector<double> BestDice(std::vector<Entry> entries, int bins,
  const std::vector<std::array<std::int64_t, 2>>& totals);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCLabelHistogram.h
