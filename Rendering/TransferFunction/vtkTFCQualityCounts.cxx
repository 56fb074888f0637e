// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCQualityCounts.h"

#include "vtkTFCAttributeReader.h"
#include "vtkTFCClassifier.h"
#include "vtkTFCThreads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

namespace
{
using vtkTFCQualityCounts::Binning;
using vtkTFCQualityCounts::Counts;
using vtkTFCQualityCounts::Source;

constexpr vtkIdType ChunkSize = 2048;
constexpr vtkIdType Grain = 16384;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

//------------------------------------------------------------------------------
// Labels of a chunk, NaN for the samples that are left out.
void ReadLabels(const Source& source, vtkIdType first, vtkIdType count, double* out)
{
  source.Reader->Read(source.LabelAttribute, first, count, out);
  for (const double ignored : source.Ignored)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      out[i] = out[i] == ignored ? NaN : out[i];
    }
  }
  for (vtkIdType i = 0; !source.Owned.empty() && i < count; ++i)
  {
    out[i] = source.Owned[first + i] ? out[i] : NaN;
  }
  for (vtkIdType i = 0; source.Reader->HasHidden() && i < count; ++i)
  {
    out[i] = source.Reader->IsHidden(first + i) ? NaN : out[i];
  }
}

//------------------------------------------------------------------------------
// Number of a value in a sorted list of integers: by a table where their span is small.
class Numbers
{
public:
  explicit Numbers(std::vector<double> values)
    : Values(std::move(values))
  {
    constexpr double longest = 65536;
    if (!this->Values.empty() && this->Values.back() - this->Values.front() < longest)
    {
      this->Table.resize(static_cast<size_t>(this->Values.back() - this->Values.front()) + 1, 0);
      for (size_t i = 0; i < this->Values.size(); ++i)
      {
        this->Table[static_cast<size_t>(this->Values[i] - this->Values.front())] =
          static_cast<int>(i);
      }
    }
  }

  int operator()(double value) const
  {
    return this->Table.empty()
      ? static_cast<int>(
          std::lower_bound(this->Values.begin(), this->Values.end(), value) - this->Values.begin())
      : this->Table[static_cast<size_t>(value - this->Values.front())];
  }

private:
  std::vector<double> Values;
  std::vector<int> Table;
};

//------------------------------------------------------------------------------
void FindHalves(const std::array<int, 6>& extent, vtkIdType first, vtkIdType count,
  std::uint32_t* out)
{
  const vtkIdType nx = vtkIdType{ 1 } + extent[1] - extent[0];
  const vtkIdType ny = vtkIdType{ 1 } + extent[3] - extent[2];
  for (vtkIdType done = 0; done < count;)
  {
    const vtkIdType x = (first + done) % nx;
    const vtkIdType row = (first + done) / nx;
    const vtkIdType run = std::min(nx - x, count - done);
    const auto y = static_cast<std::uint64_t>(extent[2] + row % ny);
    const auto z = static_cast<std::uint64_t>(extent[4] + row / ny);
    const auto x0 = static_cast<std::uint64_t>(extent[0] + x);
    for (vtkIdType i = 0; i < run; ++i)
    {
      out[done + i] = vtkTFCQualityCounts::GetHalf(x0 + static_cast<std::uint64_t>(i), y, z);
    }
    done += run;
  }
}

//------------------------------------------------------------------------------
// Bins of a chunk of one attribute, moved to their place in a cell.
void FindBins(const double* values, vtkIdType count, const std::array<double, 2>& range, int bins,
  int shift, std::uint32_t* out)
{
  // Halves: the difference of the largest numbers would overflow.
  const double low = 0.5 * range[0];
  const double scale = bins / (0.5 * range[1] - low);
  const double last = bins - 1;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double bin = (0.5 * values[i] - low) * scale;
    bin = bin > 0 ? bin : 0; // NaN too
    bin = bin < last ? bin : last;
    out[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(bin)) << shift;
  }
}

//------------------------------------------------------------------------------
// What one thread needs: kept from range to range.
struct Workspace
{
  Workspace(size_t attributes, size_t histograms, size_t confusion, size_t labels)
    : Values(attributes * ChunkSize)
    , Labels(ChunkSize)
    , Regions(ChunkSize)
    , Halves(ChunkSize)
    , Cells(ChunkSize)
    , Bins(ChunkSize)
    , Histograms(histograms)
    , Confusion(confusion, 0)
    , Totals(labels, { { 0, 0 } })
  {
    for (size_t a = 0; a < attributes; ++a)
    {
      this->Attributes.push_back(this->Values.data() + a * ChunkSize);
    }
  }
  Workspace(const Workspace&) = delete;
  void operator=(const Workspace&) = delete;

  std::vector<double> Values, Labels;
  std::vector<const double*> Attributes;
  std::vector<int> Regions;
  std::vector<std::uint32_t> Halves, Cells, Bins;
  std::vector<vtkTFCLabelHistogram::Counter> Histograms;
  std::vector<std::int64_t> Confusion;
  std::vector<std::array<std::int64_t, 2>> Totals;
};

//------------------------------------------------------------------------------
// Everything that is the same for all chunks.
class ChunkCounter
{
public:
  ChunkCounter(const Source& from, const vtkTFCClassifier& with, const std::vector<double>& labels,
    const Binning& how)
    : Data(from)
    , Classifier(with)
    , Axes(how)
    , LabelNumbers(labels)
    , RegionNumbers(SortedIds(with))
  {
    const auto& regions = with.GetModel().Regions;
    this->Columns.resize(regions.size() + 1);
    for (size_t r = 0; r < regions.size(); ++r)
    {
      this->Columns[this->RegionNumbers(regions[r].Id)] = r + 1;
    }
    this->Columns[this->RegionNumbers(0)] = 0;
  }

  void Run(vtkIdType first, vtkIdType count, Workspace& work) const
  {
    this->Data.Reader->ReadAll(first, count, ChunkSize, work.Values.data());
    ReadLabels(this->Data, first, count, work.Labels.data());
    this->Classifier.Classify(static_cast<size_t>(count), work.Attributes.data(), nullptr,
      work.Regions.data());
    FindHalves(this->Data.Extent, first, count, work.Halves.data());
    const size_t columns = this->Columns.size();
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (work.Labels[i] == work.Labels[i])
      {
        const size_t label = static_cast<size_t>(this->LabelNumbers(work.Labels[i]));
        ++work.Confusion[label * columns + this->Columns[this->RegionNumbers(work.Regions[i])]];
        ++work.Totals[label][work.Halves[i]];
      }
    }
    this->AddToHistograms(count, work);
  }

private:
  static std::vector<double> SortedIds(const vtkTFCClassifier& classifier)
  {
    std::vector<double> ids = { 0 };
    for (const vtkTFCCompiledRegion& region : classifier.GetModel().Regions)
    {
      ids.push_back(region.Id);
    }
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  void AddToHistograms(vtkIdType count, Workspace& work) const
  {
    const auto& ranges = this->Axes.Ranges;
    const double* const x = work.Attributes[0];
    const double* const y = work.Attributes[1];
    for (vtkIdType i = 0; i < count; ++i)
    {
      // As the classifier does: what is outside of the axes is in no region whatever they are.
      const bool inside = x[i] >= ranges[0][0] && x[i] <= ranges[0][1] && y[i] >= ranges[1][0] &&
        y[i] <= ranges[1][1];
      work.Labels[i] = inside ? work.Labels[i] : NaN;
    }
    FindBins(x, count, ranges[0], this->Axes.Bins, 0, work.Cells.data());
    FindBins(y, count, ranges[1], this->Axes.Bins, vtkTFCLabelHistogram::BitsPerAxis,
      work.Bins.data());
    for (vtkIdType i = 0; i < count; ++i)
    {
      work.Cells[i] |= work.Bins[i];
    }
    for (size_t h = 0; h < work.Histograms.size(); ++h)
    {
      const int third = this->Axes.Third[h];
      // Without a third attribute, the labels themselves: not NaN where it matters.
      const double* const z = third < 0 ? work.Labels.data() : work.Attributes[third];
      std::fill_n(work.Bins.begin(), count, 0);
      if (third >= 0)
      {
        FindBins(z, count, ranges[third], this->Axes.Bins, 2 * vtkTFCLabelHistogram::BitsPerAxis,
          work.Bins.data());
      }
      for (vtkIdType i = 0; i < count; ++i)
      {
        if (work.Labels[i] == work.Labels[i] && z[i] == z[i])
        {
          work.Histograms[h].Add(vtkTFCLabelHistogram::MakeKey(work.Cells[i] | work.Bins[i],
            static_cast<std::uint32_t>(this->LabelNumbers(work.Labels[i])), work.Halves[i]));
        }
      }
    }
  }

  const Source& Data;
  const vtkTFCClassifier& Classifier;
  const Binning& Axes;
  Numbers LabelNumbers;
  Numbers RegionNumbers;
  std::vector<size_t> Columns;
};
}

namespace vtkTFCQualityCounts
{
//------------------------------------------------------------------------------
bool FindLabels(const Source& source, vtkAlgorithm* owner, std::vector<double>& labels)
{
  std::set<double> found;
  std::mutex merging;
  const size_t most = vtkTFCLabelHistogram::MostLabels;
  const bool done =
    vtkTFCThreads::ForWithProgress(0, source.Reader->GetNumberOfTuples(), Grain, owner, 0., 0.2,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::array<double, ChunkSize> values;
        std::set<double> local;
        double previous = NaN;
        for (vtkIdType first = begin; first < end && local.size() <= most; first += ChunkSize)
        {
          const vtkIdType count = std::min(ChunkSize, end - first);
          ReadLabels(source, first, count, values.data());
          for (vtkIdType i = 0; i < count; ++i)
          {
            // Neighbours are mostly alike.
            if (values[i] != previous && values[i] == values[i])
            {
              local.insert(values[i]);
              previous = values[i];
            }
          }
        }
        const std::lock_guard<std::mutex> lock(merging);
        found.insert(local.begin(), local.end());
      });
  labels.assign(found.begin(), found.end());
  labels.resize(std::min(labels.size(), most + 1));
  return done;
}

//------------------------------------------------------------------------------
bool Count(const Source& source, const vtkTFCClassifier& classifier,
  const std::vector<double>& labels, const Binning& binning, vtkAlgorithm* owner, Counts& counts)
{
  const size_t histograms = binning.Third.size();
  const size_t columns = classifier.GetModel().Regions.size() + 1;
  counts.Confusion.assign(labels.size() * columns, 0);
  counts.Totals.assign(labels.size(), { { 0, 0 } });
  counts.Histograms.resize(histograms);
  if (source.Reader->GetNumberOfTuples() == 0)
  {
    return true;
  }
  const ChunkCounter counter(source, classifier, labels, binning);

  // As many workspaces as threads run at once: tables grow once, not once per range.
  std::vector<std::unique_ptr<Workspace>> idle;
  std::mutex exchanging;
  const bool done =
    vtkTFCThreads::ForWithProgress(0, source.Reader->GetNumberOfTuples(), Grain, owner, 0.2, 1.,
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
          work = std::make_unique<Workspace>(binning.Ranges.size(), histograms,
            counts.Confusion.size(), labels.size());
        }
        for (vtkIdType first = begin; first < end; first += ChunkSize)
        {
          counter.Run(first, std::min(ChunkSize, end - first), *work);
        }
        const std::lock_guard<std::mutex> lock(exchanging);
        idle.push_back(std::move(work));
      });

  for (const auto& work : idle)
  {
    for (size_t i = 0; i < counts.Confusion.size(); ++i)
    {
      counts.Confusion[i] += work->Confusion[i];
    }
    for (size_t label = 0; label < labels.size(); ++label)
    {
      counts.Totals[label][0] += work->Totals[label][0];
      counts.Totals[label][1] += work->Totals[label][1];
    }
    for (size_t h = 0; h < histograms; ++h)
    {
      work->Histograms[h].AppendTo(counts.Histograms[h]);
    }
  }
  return done;
}
}
