// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributeInformation.h"

#include "vtkTFCDistributedImage.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>

namespace
{
using Samples = vtkTFCAttributeSamples;

//------------------------------------------------------------------------------
/**
 * What one thread needs. Two interleaved copies of the counts keep equal neighbours, the normal
 * case in a volume, from waiting for each other's increment; one more cell takes what has no data.
 */
struct Workspace
{
  Workspace(const std::vector<bool>& candidates, int bins)
    : Cells(static_cast<size_t>(bins) * bins * bins)
    , Values(Samples::ChunkSize)
    , Axis(Samples::ChunkSize)
    , Plane(Samples::ChunkSize)
    , Counts(candidates.size())
  {
    for (size_t i = 0; i < candidates.size(); ++i)
    {
      this->Counts[i].resize(candidates[i] ? 2 * (this->Cells + 1) : 0, 0);
    }
  }

  size_t Cells;
  std::vector<double> Values;
  std::vector<std::int32_t> Axis, Plane;
  std::vector<std::vector<std::uint32_t>> Counts; // per attribute; none for the axes
};

//------------------------------------------------------------------------------
class Counter
{
public:
  Counter(const Samples& from, const std::vector<vtkTFCAttributeStatistics::Summary>& summaries,
    int primary, int secondary, int bins)
    : Data(from)
    , Summaries(summaries)
    , Primary(primary)
    , Secondary(secondary)
    , Bins(bins)
  {
  }

  void Run(vtkIdType first, vtkIdType count, Workspace& work) const
  {
    this->Read(this->Primary, first, count, work, work.Plane);
    if (this->Secondary >= 0)
    {
      this->Read(this->Secondary, first, count, work, work.Axis);
    }
    else
    {
      std::fill_n(work.Axis.begin(), count, 0);
    }
    for (vtkIdType s = 0; s < count; ++s)
    {
      const int cell = work.Axis[s] * this->Bins + work.Plane[s];
      work.Plane[s] = work.Axis[s] < 0 || work.Plane[s] < 0 ? -1 : cell;
    }
    for (size_t i = 0; i < this->Summaries.size(); ++i)
    {
      const int index = static_cast<int>(i);
      if (index == this->Primary || index == this->Secondary)
      {
        continue;
      }
      this->Read(index, first, count, work, work.Axis);
      std::uint32_t* const counts = work.Counts[i].data();
      const auto none = static_cast<std::int32_t>(work.Cells);
      for (vtkIdType s = 0; s < count; ++s)
      {
        const std::int32_t cell = work.Plane[s] * this->Bins + work.Axis[s];
        const std::int32_t at = work.Plane[s] < 0 || work.Axis[s] < 0 ? none : cell;
        ++counts[static_cast<size_t>(s & 1) * (work.Cells + 1) + static_cast<size_t>(at)];
      }
    }
  }

private:
  void Read(int index, vtkIdType first, vtkIdType count, Workspace& work,
    std::vector<std::int32_t>& bins) const
  {
    const auto& sum = this->Summaries[static_cast<size_t>(index)];
    this->Data.Read(static_cast<size_t>(index), first, count, work.Values.data());
    tfc::FindCoarseBins(work.Values.data(), count, sum.Minimum, sum.Maximum, this->Bins,
      bins.data());
  }

  const Samples& Data;
  const std::vector<vtkTFCAttributeStatistics::Summary>& Summaries;
  int Primary, Secondary, Bins;
};
}

namespace vtkTFCAttributeInformation
{
//------------------------------------------------------------------------------
bool Compute(const vtkTFCAttributeSamples& samples, const vtkTFCDistributedImage& image,
  const std::vector<vtkTFCAttributeStatistics::Summary>& summaries, int primary, int secondary,
  vtkAlgorithm* owner, std::vector<tfc::Information>& result)
{
  const size_t k = summaries.size();
  const int bins = tfc::GetInformationBins(summaries[static_cast<size_t>(primary)].Count);
  const Counter counter(samples, summaries, primary, secondary, bins);
  const size_t cells = static_cast<size_t>(bins) * bins * bins;
  std::vector<bool> candidates(k, true);
  for (const int axis : { primary, secondary })
  {
    if (axis >= 0)
    {
      candidates[static_cast<size_t>(axis)] = false;
    }
  }
  std::vector<std::vector<std::int64_t>> counts(k);
  for (size_t i = 0; i < k; ++i)
  {
    counts[i].resize(candidates[i] ? cells : 0, 0);
  }
  std::vector<std::unique_ptr<Workspace>> idle;
  std::mutex exchanging;
  const auto flush = [&](Workspace& work)
  {
    for (size_t i = 0; i < k; ++i)
    {
      for (size_t cell = 0; cell < counts[i].size(); ++cell)
      {
        counts[i][cell] +=
          std::int64_t{ work.Counts[i][cell] } + std::int64_t{ work.Counts[i][cells + 1 + cell] };
      }
      std::fill(work.Counts[i].begin(), work.Counts[i].end(), 0);
    }
  };
  // Before 32 bits overflow.
  constexpr vtkIdType mostBlocks = (vtkIdType{ 1 } << 31) / Samples::BlockSize;
  const vtkIdType blocks = samples.GetNumberOfBlocks();
  bool done = true;
  for (vtkIdType part = 0; part < blocks && done; part += mostBlocks)
  {
    const vtkIdType last = std::min(blocks, part + mostBlocks);
    done = vtkTFCThreads::ForWithProgress(part, last, 1, owner,
      static_cast<double>(part) / static_cast<double>(blocks),
      static_cast<double>(last) / static_cast<double>(blocks),
      vtkTFCSimd::Vectorize(
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
            work = std::make_unique<Workspace>(candidates, bins);
          }
          for (vtkIdType block = begin; block < end; ++block)
          {
            samples.ForChunks(block,
              [&](vtkIdType first, vtkIdType count) { counter.Run(first, count, *work); });
          }
          const std::lock_guard<std::mutex> lock(exchanging);
          idle.push_back(std::move(work));
        }));
    for (const auto& work : idle)
    {
      flush(*work);
    }
  }
  if (!image.All(done))
  {
    return false;
  }
  result.assign(k, tfc::Information());
  for (size_t i = 0; i < k; ++i)
  {
    if (candidates[i])
    {
      image.Sum(counts[i].data(), static_cast<vtkIdType>(cells));
      result[i] = tfc::MeasureInformation(counts[i], bins);
    }
  }
  return true;
}
}
