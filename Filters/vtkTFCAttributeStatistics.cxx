// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributeStatistics.h"

#include "Kernels/TFCCorrelation.h"
#include "Kernels/TFCHistogram.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <mutex>

namespace
{
using Reader = vtkTFCAttributeSamples;
using vtkTFCAttributeStatistics::Attribute;
using vtkTFCAttributeStatistics::Summary;

constexpr vtkIdType ChunkSize = Reader::ChunkSize;
constexpr int WidestMerge = 8;

//------------------------------------------------------------------------------
// Eight doubles, and what comparing them gives. The compiler makes of them what the instruction set
// has; it does not turn a loop over lanes with conditions into that by itself.
using Lanes = double __attribute__((vector_size(64)));
using Masks = std::int64_t __attribute__((vector_size(64)));

//------------------------------------------------------------------------------
/**
 * Add samples to a summary, in eight lanes, which are the same on every processor.
 */
inline void Summarize(const double* values, vtkIdType count, Summary& sum)
{
  constexpr int width = 8;
  Lanes sums = {}, minima = Lanes{} + sum.Minimum, maxima = Lanes{} + sum.Maximum;
  Masks counts = {};
  for (vtkIdType s = 0; s < count; s += width)
  {
    Lanes v = Lanes{} + std::numeric_limits<double>::quiet_NaN();
    if (s + width <= count)
    {
      std::memcpy(&v, values + s, sizeof(v));
    }
    else
    {
      std::memcpy(&v, values + s, sizeof(double) * static_cast<size_t>(count - s));
    }
    const Masks valid = v == v; // -1 where it is
    counts -= valid;
    sums += valid ? v : Lanes{};
    minima = v < minima ? v : minima;
    maxima = v > maxima ? v : maxima;
  }
  for (int lane = 0; lane < width; ++lane)
  {
    sum.Count += static_cast<double>(counts[lane]);
    sum.Sum += sums[lane];
    sum.Minimum = std::min(sum.Minimum, minima[lane]);
    sum.Maximum = std::max(sum.Maximum, maxima[lane]);
  }
}

//------------------------------------------------------------------------------
/**
 * First pass: count, mean and range of every attribute, over all processes.
 */
bool Summarize(const Reader& reader, const vtkTFCDistributedImage& image, vtkAlgorithm* owner,
  std::vector<Summary>& summaries)
{
  const size_t k = summaries.size();
  const vtkIdType blocks = reader.GetNumberOfBlocks();
  std::vector<Summary> partial(k * static_cast<size_t>(blocks));
  const bool done = vtkTFCThreads::ForWithProgress(0, blocks, 1, owner, 0., 0.3,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<double> values(ChunkSize);
        for (vtkIdType block = begin; block < end; ++block)
        {
          for (size_t i = 0; i < k; ++i)
          {
            Summary& sum = partial[block * k + i];
            reader.ForChunks(block,
              [&](vtkIdType first, vtkIdType count)
              {
                reader.Read(i, first, count, values.data());
                Summarize(values.data(), count, sum);
              });
          }
        }
      }));
  for (size_t p = 0; p < partial.size(); ++p)
  {
    Summary& sum = summaries[p % k];
    sum.Count += partial[p].Count;
    sum.Sum += partial[p].Sum;
    sum.Minimum = std::min(sum.Minimum, partial[p].Minimum);
    sum.Maximum = std::max(sum.Maximum, partial[p].Maximum);
  }
  if (!image.All(done))
  {
    return false;
  }
  for (Summary& sum : summaries)
  {
    image.Sum(&sum.Count, 1);
    image.Sum(&sum.Sum, 1);
    image.Minimum(&sum.Minimum, 1);
    image.Maximum(&sum.Maximum, 1);
  }
  return true;
}

//------------------------------------------------------------------------------
/**
 * Second pass: sums of all pairs and histograms, over all processes.
 */
bool Accumulate(const Reader& reader, const vtkTFCDistributedImage& image, vtkAlgorithm* owner,
  const std::vector<Summary>& summaries, const std::vector<tfc::Binning>& binnings,
  std::vector<tfc::PairSums>& pairs, std::vector<std::vector<std::int64_t>>& histograms)
{
  const size_t k = summaries.size();
  std::vector<double> shift(k), scale(k);
  for (size_t i = 0; i < k; ++i)
  {
    const Summary& sum = summaries[i];
    const double mean = sum.Count > 0. ? sum.Sum / sum.Count : 0.;
    const double range = sum.Maximum - sum.Minimum;
    shift[i] = std::isfinite(mean) ? mean : 0.5 * sum.Minimum + 0.5 * sum.Maximum;
    scale[i] = range > 0. ? std::min(1. / range, 1e300) : 0.;
  }
  const vtkIdType blocks = reader.GetNumberOfBlocks();
  const size_t numberOfPairs = pairs.size();
  std::vector<tfc::PairSums> partial(numberOfPairs * static_cast<size_t>(blocks));
  std::mutex merging;
  const bool done = vtkTFCThreads::ForWithProgress(0, blocks, 1, owner, 0.3, 1.,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        tfc::PairWorkspace work(k, ChunkSize);
        std::vector<tfc::Histogram> local(binnings.begin(), binnings.end());
        for (vtkIdType block = begin; block < end; ++block)
        {
          reader.ForChunks(block,
            [&](vtkIdType first, vtkIdType count)
            {
              for (size_t i = 0; i < k; ++i)
              {
                double* values = work.GetValues(i);
                reader.Read(i, first, count, values);
                local[i].Add(values, count);
                for (vtkIdType s = 0; s < count; ++s)
                {
                  values[s] = (values[s] - shift[i]) * scale[i];
                }
              }
              tfc::AccumulatePairs(k, count, work, partial.data() + block * numberOfPairs);
            });
        }
        // Integers: the order of merging does not matter.
        const std::lock_guard<std::mutex> lock(merging);
        for (size_t i = 0; i < k; ++i)
        {
          local[i].AddTo(histograms[i].data());
        }
      }));
  for (size_t p = 0; p < partial.size(); ++p)
  {
    pairs[p % numberOfPairs] += partial[p];
  }
  if (!image.All(done))
  {
    return false;
  }
  image.Sum(reinterpret_cast<double*>(pairs.data()),
    static_cast<vtkIdType>(pairs.size() * sizeof(tfc::PairSums) / sizeof(double)));
  for (auto& histogram : histograms)
  {
    image.Sum(histogram.data(), static_cast<vtkIdType>(histogram.size()));
  }
  return true;
}
}

namespace vtkTFCAttributeStatistics
{
//------------------------------------------------------------------------------
bool Compute(const vtkTFCAttributeSamples& samples, const vtkTFCDistributedImage& image,
  const std::vector<Attribute>& attributes, int bins, vtkAlgorithm* owner, Result& result)
{
  const size_t k = attributes.size();
  std::vector<Summary>& summaries = result.Summaries;
  summaries.assign(k, Summary());
  if (!Summarize(samples, image, owner, summaries))
  {
    return false;
  }
  std::vector<bool> constant(k);
  std::vector<tfc::Binning> binnings(k);
  std::vector<std::vector<std::int64_t>> histograms(k);
  for (size_t i = 0; i < k; ++i)
  {
    const Summary& sum = summaries[i];
    constant[i] = !(sum.Maximum > sum.Minimum);
    const bool integer = attributes[i].Integer;
    binnings[i] = tfc::Binning::Make(sum.Minimum, sum.Maximum, integer,
      bins > 0    ? bins
        : integer ? LargestDepth
                  : FloatBins);
    histograms[i].assign(static_cast<size_t>(binnings[i].Bins), 0);
  }
  std::vector<tfc::PairSums> pairs(tfc::NumberOfPairs(k));
  if (!Accumulate(samples, image, owner, summaries, binnings, pairs, histograms))
  {
    return false;
  }
  result.Correlations = tfc::CorrelationMatrix(pairs, constant);
  result.CoarseEntropies.clear();
  for (int width = 1; width <= WidestMerge; width *= 2)
  {
    std::vector<double> entropies;
    for (auto& histogram : histograms)
    {
      if (width > 1)
      {
        tfc::MergeBins(histogram);
      }
      entropies.push_back(
        tfc::Entropy(histogram.data(), static_cast<tfc::Index>(histogram.size())));
    }
    result.CoarseEntropies.push_back(entropies);
  }
  result.Entropies = result.CoarseEntropies.front();
  return true;
}
}
