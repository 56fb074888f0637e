// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCJointCounts.h"

#include "vtkTFCAttributeSamples.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCThreads.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>

namespace
{
using Samples = vtkTFCAttributeSamples;
using vtkTFCJointCounts::TertiaryBits;

constexpr double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
// What one thread needs: kept from range to range.
struct Workspace
{
  explicit Workspace(size_t axes)
    : Values(axes * Samples::ChunkSize)
    , Keys(Samples::ChunkSize)
  {
  }
  double* GetValues(size_t axis) { return this->Values.data() + axis * Samples::ChunkSize; }

  std::vector<double> Values;
  std::vector<std::uint64_t> Keys;
  tfc::KeyCounter Counter;
};

//------------------------------------------------------------------------------
// The keys of a chunk, cell * 2^16 + tertiary bin.
void MakeKeys(const vtkTFCSparseHistogram* axes, bool hasTertiary, Workspace& work, vtkIdType count)
{
  const double* const x = work.GetValues(0);
  const double* const y = work.GetValues(1);
  const double* const z = hasTertiary ? work.GetValues(2) : nullptr;
  const auto width = static_cast<std::uint64_t>(axes->GetNumberOfBins(0));
  const auto none = static_cast<std::uint64_t>(hasTertiary ? axes->GetNumberOfBins(2) : 0);
  for (vtkIdType s = 0; s < count; ++s)
  {
    const int i = axes->GetBin(0, x[s]);
    const int j = axes->GetBin(1, y[s]);
    const int k = z ? axes->GetBin(2, z[s]) : -1;
    const std::uint64_t cell =
      static_cast<std::uint64_t>(j) * width + static_cast<std::uint64_t>(i);
    work.Keys[s] = i < 0 || j < 0
      ? tfc::KeyCounter::NoKey
      : (cell << TertiaryBits) | (k < 0 ? none : static_cast<std::uint64_t>(k));
  }
}
}

namespace vtkTFCJointCounts
{
//------------------------------------------------------------------------------
std::pair<double, double> FindRange(const Samples& samples, size_t attribute)
{
  std::pair<double, double> range{ Infinity, -Infinity };
  std::mutex merging;
  vtkTFCThreads::For(0, samples.GetNumberOfBlocks(), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> values(Samples::ChunkSize);
      double low = Infinity, high = -Infinity;
      for (vtkIdType block = begin; block < end; ++block)
      {
        samples.ForChunks(block,
          [&](vtkIdType first, vtkIdType count)
          {
            samples.Read(attribute, first, count, values.data());
            for (vtkIdType i = 0; i < count; ++i)
            {
              low = values[i] < low ? values[i] : low;
              high = values[i] > high ? values[i] : high;
            }
          });
      }
      const std::lock_guard<std::mutex> lock(merging);
      range.first = std::min(range.first, low);
      range.second = std::max(range.second, high);
    });
  return range;
}

//------------------------------------------------------------------------------
bool Count(const vtkTFCAttributeSamples& samples, const vtkTFCSparseHistogram* axes,
  bool hasTertiary, vtkAlgorithm* owner, std::vector<tfc::KeyCount>& list)
{
  const size_t numberOfAxes = hasTertiary ? 3 : 2;
  // As many workspaces as threads run at once: tables grow once, not once per range.
  std::vector<std::unique_ptr<Workspace>> idle;
  std::mutex exchanging;
  const bool done = vtkTFCThreads::ForWithProgress(0, samples.GetNumberOfBlocks(), 1, owner, 0., 1.,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::unique_ptr<Workspace> work;
      {
        const std::lock_guard<std::mutex> lock(exchanging);
        if (!idle.empty())
        {
          work = std::move(idle.back());
          idle.pop_back();
        }
      }
      if (!work)
      {
        work = std::make_unique<Workspace>(numberOfAxes);
      }
      for (vtkIdType block = begin; block < end; ++block)
      {
        samples.ForChunks(block,
          [&](vtkIdType first, vtkIdType count)
          {
            for (size_t axis = 0; axis < numberOfAxes; ++axis)
            {
              samples.Read(axis, first, count, work->GetValues(axis));
            }
            MakeKeys(axes, hasTertiary, *work, count);
            work->Counter.Add(work->Keys.data(), count);
          });
      }
      const std::lock_guard<std::mutex> lock(exchanging);
      idle.push_back(std::move(work));
    });
  for (auto& work : idle)
  {
    work->Counter.AppendTo(list);
    work.reset();
  }
  tfc::MergeKeys(list);
  return done;
}

//------------------------------------------------------------------------------
void Reduce(const vtkTFCDistributedImage& peers, std::vector<tfc::KeyCount>& list)
{
  if (peers.GetNumberOfRanks() < 2)
  {
    return;
  }
  std::vector<std::int64_t> mine;
  mine.reserve(2 * list.size());
  for (const tfc::KeyCount& entry : list)
  {
    mine.push_back(static_cast<std::int64_t>(entry.Key));
    mine.push_back(entry.Count);
  }
  const std::vector<std::int64_t> all = peers.Gather(mine);
  list.clear();
  list.reserve(all.size() / 2);
  for (size_t i = 0; i < all.size(); i += 2)
  {
    list.push_back({ static_cast<std::uint64_t>(all[i]), all[i + 1] });
  }
  tfc::MergeKeys(list);
}
}
