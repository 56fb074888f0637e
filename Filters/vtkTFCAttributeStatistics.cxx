// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributeStatistics.h"

#include "Kernels/TFCCorrelation.h"
#include "Kernels/TFCHistogram.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCSamples.h"
#include "vtkTFCThreads.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <mutex>

namespace
{
using vtkTFCAttributeStatistics::Attribute;

// Partial sums are kept per block, and added in the order of the blocks. A chunk's samples of all
// attributes stay in the second-level cache.
constexpr vtkIdType BlockSize = 65536;
constexpr vtkIdType ChunkSize = 2048;

// A quarter of the largest double: differences stay finite.
constexpr double LargestValid = std::numeric_limits<double>::max() / 4;

//------------------------------------------------------------------------------
struct Summary
{
  double Count = 0., Sum = 0.;
  double Minimum = std::numeric_limits<double>::infinity();
  double Maximum = -std::numeric_limits<double>::infinity();
};

//------------------------------------------------------------------------------
bool HoldsIntegers(const Attribute& attribute)
{
  const int type = attribute.Array->GetDataType();
  return attribute.Component >= 0 && type != VTK_FLOAT && type != VTK_DOUBLE;
}

//------------------------------------------------------------------------------
/**
 * Reads chunks of samples as doubles, NaN where there is no data.
 */
class Reader
{
public:
  Reader(vtkDataSet* data, std::vector<Attribute> attributes, std::vector<unsigned char> owned,
    const std::vector<double>& fillValues)
    : Attributes(std::move(attributes))
    , Owned(std::move(owned))
    , Fill(fillValues)
  {
    this->Count = data->GetNumberOfPoints();
    auto* ghosts = vtkTFCSamples::GetGhosts(data->GetPointData());
    if (ghosts && ghosts->GetNumberOfValues() == this->Count)
    {
      this->Ghosts = ghosts->GetPointer(0);
    }
    for (const double value : fillValues)
    {
      this->FloatFill.push_back(static_cast<double>(static_cast<float>(value)));
    }
  }

  vtkIdType GetNumberOfBlocks() const { return (this->Count + BlockSize - 1) / BlockSize; }

  /**
   * body(first, count) for the chunks of one block.
   */
  template <typename Body>
  void ForChunks(vtkIdType block, Body&& body) const
  {
    const vtkIdType end = std::min(this->Count, (block + 1) * BlockSize);
    for (vtkIdType first = block * BlockSize; first < end; first += ChunkSize)
    {
      body(first, std::min(ChunkSize, end - first));
    }
  }

  void Read(size_t i, vtkIdType first, vtkIdType count, double* out) const
  {
    const Attribute& attribute = this->Attributes[i];
    vtkTFCSamples::Read(attribute.Array, attribute.Component, first, count, out);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (vtkIdType s = 0; s < count; ++s)
    {
      out[s] = std::fabs(out[s]) <= LargestValid ? out[s] : nan;
    }
    const bool isFloat = attribute.Array->GetDataType() == VTK_FLOAT;
    for (const double fill : isFloat ? this->FloatFill : this->Fill)
    {
      for (vtkIdType s = 0; s < count; ++s)
      {
        out[s] = out[s] == fill ? nan : out[s];
      }
    }
    const unsigned char hidden =
      vtkTFCSamples::GetHiddenBit(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    for (vtkIdType s = 0; this->Ghosts && s < count; ++s)
    {
      out[s] = (this->Ghosts[first + s] & hidden) ? nan : out[s];
    }
    for (vtkIdType s = 0; !this->Owned.empty() && s < count; ++s)
    {
      out[s] = this->Owned[first + s] ? out[s] : nan;
    }
  }

private:
  std::vector<Attribute> Attributes;
  std::vector<unsigned char> Owned;
  std::vector<double> Fill, FloatFill;
  vtkIdType Count;
  const unsigned char* Ghosts = nullptr;
};

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
              for (vtkIdType s = 0; s < count; ++s)
              {
                const double v = values[s];
                const bool valid = v == v;
                sum.Count += valid ? 1. : 0.;
                sum.Sum += valid ? v : 0.;
                sum.Minimum = v < sum.Minimum ? v : sum.Minimum;
                sum.Maximum = v > sum.Maximum ? v : sum.Maximum;
              }
            });
        }
      }
    });
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
    });
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
std::string Find(vtkPointData* points, const std::string& text, Attribute& found)
{
  found.Label = text;
  found.Component = 0;
  std::string name = text, component;
  const size_t colon = text.rfind(':');
  // The whole text first: an array's name may contain a colon.
  if (!points->HasArray(name.c_str()) && colon != std::string::npos)
  {
    name = text.substr(0, colon);
    component = text.substr(colon + 1);
  }
  if (!points->HasArray(name.c_str()))
  {
    return "There is no point array '" + name + "'. Choose from " +
      vtkTFCSamples::ListArrays(points) +
      "; to use cell arrays, apply the filter Cell Data to Point Data first.";
  }
  found.Array = points->GetArray(name.c_str());
  if (!found.Array)
  {
    return "The array '" + name + "' holds text, not numbers. Choose from " +
      vtkTFCSamples::ListArrays(points) + ".";
  }
  const int components = found.Array->GetNumberOfComponents();
  const std::string last = std::to_string(components - 1);
  if (component == "magnitude")
  {
    found.Component = vtkTFCSamples::Magnitude;
  }
  else if (!component.empty())
  {
    char* end = nullptr;
    const long number = std::strtol(component.c_str(), &end, 10);
    if (*end || number < 0 || number >= components)
    {
      return "The array '" + name + "' has no component '" + component + "'. Use '" + name +
        ":0' to '" + name + ":" + last + "', or '" + name + ":magnitude'.";
    }
    found.Component = static_cast<int>(number);
  }
  else if (components != 1)
  {
    return "The array '" + name + "' has " + std::to_string(components) + " components. Use '" +
      name + ":0' to '" + name + ":" + last + "', or '" + name + ":magnitude'.";
  }
  found.Integer = HoldsIntegers(found);
  return {};
}

//------------------------------------------------------------------------------
std::vector<Attribute> FindAll(vtkPointData* points)
{
  std::vector<Attribute> attributes;
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
      std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) != 0)
    {
      Attribute attribute;
      attribute.Label = array->GetName();
      attribute.Array = array;
      attribute.Integer = HoldsIntegers(attribute);
      attributes.push_back(attribute);
    }
  }
  return attributes;
}

//------------------------------------------------------------------------------
bool Compute(vtkDataSet* data, const vtkTFCDistributedImage& image,
  const std::vector<Attribute>& attributes, const std::vector<double>& fillValues, int bins,
  vtkAlgorithm* owner, Result& result)
{
  const size_t k = attributes.size();
  const Reader reader(data, attributes, image.GetOwnedSamples(), fillValues);
  std::vector<Summary> summaries(k);
  if (!Summarize(reader, image, owner, summaries))
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
    binnings[i] = tfc::Binning::Make(sum.Minimum, sum.Maximum, attributes[i].Integer, bins);
    histograms[i].assign(static_cast<size_t>(binnings[i].Bins), 0);
  }
  std::vector<tfc::PairSums> pairs(tfc::NumberOfPairs(k));
  if (!Accumulate(reader, image, owner, summaries, binnings, pairs, histograms))
  {
    return false;
  }
  result.Correlations = tfc::CorrelationMatrix(pairs, constant);
  result.Entropies.clear();
  for (const auto& histogram : histograms)
  {
    result.Entropies.push_back(
      tfc::Entropy(histogram.data(), static_cast<tfc::Index>(histogram.size())));
  }
  return true;
}
}
