// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCBrickActivity.h"

#include "vtkTFCRegionExtent.h"
#include "vtkTFCThreads.h"

#include <algorithm>
#include <cmath>

namespace
{

// The shader computes in single precision; ranges are widened by more than its rounding.
constexpr double Margin = 1e-5;

using Box = std::array<double, 4>;

//------------------------------------------------------------------------------
// How many cells of the axes' unit square have something in them, for any rectangle of cells.
class CellCounts
{
public:
  static constexpr int Size = 256;

  CellCounts()
    : Sums(static_cast<size_t>(Size + 1) * (Size + 1), 0)
  {
  }

  /// Mark the cells that a region may touch; before Sum().
  void Mark(const vtkTFCCompiledRegion& region)
  {
    const int x[2] = { Cell(region.Bounds[0] - Margin), Cell(region.Bounds[1] + Margin) };
    const int y[2] = { Cell(region.Bounds[2] - Margin), Cell(region.Bounds[3] + Margin) };
    for (int j = y[0]; j <= y[1]; ++j)
    {
      for (int i = x[0]; i <= x[1]; ++i)
      {
        int& cell = this->At(i + 1, j + 1);
        if (cell == 0 &&
          vtkTFCMayOverlap(region,
            { (i - 0.01) / Size, (i + 1.01) / Size, (j - 0.01) / Size, (j + 1.01) / Size }))
        {
          cell = 1;
        }
      }
    }
  }

  void Sum()
  {
    for (int j = 1; j <= Size; ++j)
    {
      int row = 0;
      for (int i = 1; i <= Size; ++i)
      {
        row += this->At(i, j);
        this->At(i, j) = row + this->At(i, j - 1);
      }
    }
  }

  bool HasAny(const Box& box) const
  {
    const int x[2] = { Cell(box[0]), Cell(box[1]) + 1 };
    const int y[2] = { Cell(box[2]), Cell(box[3]) + 1 };
    return this->At(x[1], y[1]) - this->At(x[0], y[1]) - this->At(x[1], y[0]) +
      this->At(x[0], y[0]) >
      0;
  }

private:
  static int Cell(double position)
  {
    return static_cast<int>(std::clamp(std::floor(position * Size), 0.0, Size - 1.0));
  }
  int& At(int i, int j) { return this->Sums[i + static_cast<size_t>(Size + 1) * j]; }
  int At(int i, int j) const { return this->Sums[i + static_cast<size_t>(Size + 1) * j]; }

  std::vector<int> Sums;
};

//------------------------------------------------------------------------------
// A model in the units of the packed image.
class BrickTest
{
public:
  BrickTest(const vtkTFCCompiledModel& model, const std::vector<vtkTFCStoredAttribute>& stored)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      const double extent = model.Range[axis][1] - model.Range[axis][0];
      this->Channel[axis] = stored[axis].Channel;
      this->Scale[axis] = stored[axis].Scale / extent;
      this->Bias[axis] = (stored[axis].Offset - model.Range[axis][0]) / extent;
    }
    for (const auto& region : model.Regions)
    {
      this->Cells.Mark(region);
      Candidate candidate;
      candidate.Region = &region;
      candidate.Bounds = region.Bounds;
      if (region.Tertiary >= 0)
      {
        const vtkTFCStoredAttribute& attribute = stored[region.Tertiary];
        candidate.Channel = attribute.Channel;
        for (const auto& interval : vtkTFCPositiveIntervals(region))
        {
          candidate.Intervals.push_back({ (interval[0] - attribute.Offset) / attribute.Scale,
            (interval[1] - attribute.Offset) / attribute.Scale });
        }
      }
      this->Candidates.push_back(candidate);
    }
    this->Cells.Sum();
  }

  /// `more`: of the channels beyond the fourth, or null.
  bool IsActive(const vtkTFCBrickRanges::Range& range, const vtkTFCBrickRanges::Range* more) const
  {
    Box box;
    for (int axis = 0; axis < 2; ++axis)
    {
      const int channel = this->Channel[axis];
      const double low = range.Minimum[channel] * this->Scale[axis] + this->Bias[axis];
      const double high = range.Maximum[channel] * this->Scale[axis] + this->Bias[axis];
      // Relative to where the axis ends are, in case they are far from the values.
      const double margin = Margin * (1.0 + std::abs(this->Bias[axis]));
      // Nothing is visible outside of the axes.
      box[2 * axis] = std::max(low, 0.0) - margin;
      box[2 * axis + 1] = std::min(high, 1.0) + margin;
      if (!(box[2 * axis] <= box[2 * axis + 1] && low <= high))
      {
        return false;
      }
    }
    if (!this->Cells.HasAny(box))
    {
      return false;
    }
    for (const Candidate& candidate : this->Candidates)
    {
      // The cheap tests first: most bricks fail them for most regions.
      if (candidate.IsNear(box) && candidate.MaySee(range, more) &&
        vtkTFCMayOverlap(*candidate.Region, box))
      {
        return true;
      }
    }
    return false;
  }

private:
  struct Candidate
  {
    const vtkTFCCompiledRegion* Region;
    Box Bounds;
    int Channel = -1; // of the tertiary attribute
    std::vector<std::array<double, 2>> Intervals;

    bool IsNear(const Box& box) const
    {
      return box[0] <= this->Bounds[1] && box[1] >= this->Bounds[0] && box[2] <= this->Bounds[3] &&
        box[3] >= this->Bounds[2];
    }

    bool MaySee(const vtkTFCBrickRanges::Range& first, const vtkTFCBrickRanges::Range* more) const
    {
      if (this->Channel < 0)
      {
        return true;
      }
      constexpr int channels = vtkTFCBrickRanges::MaximumNumberOfChannels;
      const vtkTFCBrickRanges::Range& range = this->Channel < channels ? first : *more;
      const double low = range.Minimum[this->Channel % channels];
      const double high = range.Maximum[this->Channel % channels];
      const double margin = Margin * (1.0 + std::abs(low) + std::abs(high));
      return low <= high &&
        std::any_of(this->Intervals.begin(), this->Intervals.end(),
          [=](const std::array<double, 2>& interval)
          { return high + margin >= interval[0] && low - margin <= interval[1]; });
    }
  };

  std::array<int, 2> Channel;
  std::array<double, 2> Scale;
  std::array<double, 2> Bias;
  CellCounts Cells;
  std::vector<Candidate> Candidates;
};

}

//------------------------------------------------------------------------------
std::vector<unsigned char> vtkTFCBrickActivity::Find(const vtkTFCBrickRanges& ranges,
  const vtkTFCBrickRanges& moreRanges, const vtkTFCCompiledModel& model,
  const std::vector<vtkTFCStoredAttribute>& stored)
{
  const auto& bricks = ranges.GetRanges();
  const auto& more = moreRanges.GetRanges();
  std::vector<unsigned char> active(bricks.size(), 0);
  if (model.Regions.empty())
  {
    return active;
  }
  const BrickTest test(model, stored);
  vtkTFCThreads::For(0, static_cast<vtkIdType>(bricks.size()), 4096,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        active[i] = test.IsActive(bricks[i], more.empty() ? nullptr : &more[i]) ? 1 : 0;
      }
    });
  return active;
}
