// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCSparseHistogram.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

vtkStandardNewMacro(vtkTFCSparseHistogram);

namespace
{
// The value differs when the bytes are reversed.
constexpr std::uint64_t Magic = 0x5446434831000000u;

//------------------------------------------------------------------------------
template <typename T>
void Append(std::vector<unsigned char>& buffer, const T* values, size_t count)
{
  const size_t at = buffer.size();
  buffer.resize(at + count * sizeof(T));
  if (count > 0)
  {
    std::memcpy(buffer.data() + at, values, count * sizeof(T));
  }
}

//------------------------------------------------------------------------------
// Reads what Append() wrote; false when the buffer is too short.
template <typename T>
bool Take(const std::vector<unsigned char>& buffer, size_t& at, T* values, size_t count)
{
  if (count > (buffer.size() - at) / sizeof(T))
  {
    return false;
  }
  if (count > 0)
  {
    std::memcpy(values, buffer.data() + at, count * sizeof(T));
  }
  at += count * sizeof(T);
  return true;
}
}

//------------------------------------------------------------------------------
const char* vtkTFCSparseHistogram::CheckAxis(double minimum, double maximum, double bins)
{
  if (!(std::isfinite(minimum) && std::isfinite(maximum) && minimum <= maximum))
  {
    return "Give an axis two finite numbers, the smaller one first.";
  }
  if (!std::isfinite(maximum - minimum))
  {
    return "The range of an axis is longer than the largest double. Scale the data.";
  }
  return bins >= 1 && bins <= MostBins ? nullptr : "Give an axis 1 to 16384 bins.";
}

//------------------------------------------------------------------------------
void vtkTFCSparseHistogram::SetAxis(int axis, double minimum, double maximum, int bins)
{
  const char* problem =
    axis < 0 || axis > 2 ? "The axes are 0, 1 and 2." : CheckAxis(minimum, maximum, bins);
  if (problem)
  {
    vtkErrorMacro("Axis " << axis << " from " << minimum << " to " << maximum << " with " << bins
                          << " bins: " << problem);
    return;
  }
  this->Axes[axis] = { minimum, maximum, bins };
  this->Cells.clear();
  this->TertiaryBins.clear();
  this->Counts.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkTFCSparseHistogram::GetNumberOfBins(int axis) const
{
  return axis < 0 || axis > 2 ? 0 : this->Axes[axis].Bins;
}

//------------------------------------------------------------------------------
void vtkTFCSparseHistogram::GetRange(int axis, double range[2]) const
{
  const Axis& a = this->Axes[std::min(2, std::max(0, axis))];
  range[0] = a.Minimum;
  range[1] = a.Maximum;
}

//------------------------------------------------------------------------------
double vtkTFCSparseHistogram::GetBinCenter(int axis, int bin) const
{
  const Axis& a = this->Axes[std::min(2, std::max(0, axis))];
  return a.Minimum + (bin + 0.5) / a.Bins * (a.Maximum - a.Minimum);
}

//------------------------------------------------------------------------------
bool vtkTFCSparseHistogram::SetEntries(std::vector<unsigned int> cells,
  std::vector<unsigned short> tertiaryBins, std::vector<double> counts)
{
  bool good = cells.size() == counts.size() && tertiaryBins.size() == counts.size();
  const std::uint64_t end =
    static_cast<std::uint64_t>(this->Axes[0].Bins) * static_cast<std::uint64_t>(this->Axes[1].Bins);
  for (size_t i = 0; good && i < counts.size(); ++i)
  {
    const bool sorted = i == 0 || cells[i - 1] < cells[i] ||
      (cells[i - 1] == cells[i] && tertiaryBins[i - 1] < tertiaryBins[i]);
    good = sorted && cells[i] < end && tertiaryBins[i] <= this->Axes[2].Bins && counts[i] > 0. &&
      std::isfinite(counts[i]);
  }
  if (!good)
  {
    vtkErrorMacro("The entries do not fit the axes: sort them by cell and tertiary bin, each pair "
                  "once, inside of the axes and with a count above 0.");
    return false;
  }
  this->Cells = std::move(cells);
  this->TertiaryBins = std::move(tertiaryBins);
  this->Counts = std::move(counts);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
double vtkTFCSparseHistogram::GetTotal() const
{
  double total = 0.;
  for (const double count : this->Counts)
  {
    total += count;
  }
  return total;
}

//------------------------------------------------------------------------------
void vtkTFCSparseHistogram::GetPlane(double* counts) const
{
  std::fill_n(counts,
    static_cast<size_t>(this->Axes[0].Bins) * static_cast<size_t>(this->Axes[1].Bins), 0.);
  for (size_t i = 0; i < this->Counts.size(); ++i)
  {
    counts[this->Cells[i]] += this->Counts[i];
  }
}

//------------------------------------------------------------------------------
void vtkTFCSparseHistogram::GetConditional(const float* weights, double* counts) const
{
  // One more for what has no tertiary value, so that the loop has no branch for it.
  std::vector<double> sums(static_cast<size_t>(this->Axes[2].Bins) + 1, 0.);
  for (size_t i = 0; i < this->Counts.size(); ++i)
  {
    const auto weight = static_cast<double>(weights[this->Cells[i]]);
    if (weight != 0.)
    {
      sums[this->TertiaryBins[i]] += weight * this->Counts[i];
    }
  }
  std::copy_n(sums.begin(), this->Axes[2].Bins, counts);
}

//------------------------------------------------------------------------------
bool vtkTFCSparseHistogram::Merge(const vtkTFCSparseHistogram* other)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Axis& a = this->Axes[axis];
    const Axis* b = other ? &other->Axes[axis] : nullptr;
    if (!b || a.Minimum != b->Minimum || a.Maximum != b->Maximum || a.Bins != b->Bins)
    {
      vtkErrorMacro("Histograms can be merged only when all axes have the same range and bins"
        << (b ? "." : "; there is none to merge."));
      return false;
    }
  }
  std::vector<unsigned int> cells;
  std::vector<unsigned short> bins;
  std::vector<double> counts;
  const size_t n = this->Counts.size();
  const size_t m = other->Counts.size();
  cells.reserve(n + m);
  bins.reserve(n + m);
  counts.reserve(n + m);
  for (size_t i = 0, j = 0; i < n || j < m;)
  {
    constexpr auto last = std::make_pair(std::numeric_limits<unsigned int>::max(),
      std::numeric_limits<unsigned short>::max());
    const auto a = i < n ? std::make_pair(this->Cells[i], this->TertiaryBins[i]) : last;
    const auto b = j < m ? std::make_pair(other->Cells[j], other->TertiaryBins[j]) : last;
    cells.push_back(std::min(a, b).first);
    bins.push_back(std::min(a, b).second);
    counts.push_back((a <= b ? this->Counts[i] : 0.) + (b <= a ? other->Counts[j] : 0.));
    i += a <= b ? 1 : 0;
    j += b <= a ? 1 : 0;
  }
  this->Cells = std::move(cells);
  this->TertiaryBins = std::move(bins);
  this->Counts = std::move(counts);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCSparseHistogram::Save(std::vector<unsigned char>& buffer) const
{
  buffer.clear();
  Append(buffer, &Magic, 1);
  for (const Axis& axis : this->Axes)
  {
    const double numbers[3] = { axis.Minimum, axis.Maximum, static_cast<double>(axis.Bins) };
    Append(buffer, numbers, 3);
  }
  const std::uint64_t entries = this->Counts.size();
  Append(buffer, &entries, 1);
  Append(buffer, this->Counts.data(), this->Counts.size());
  Append(buffer, this->Cells.data(), this->Cells.size());
  Append(buffer, this->TertiaryBins.data(), this->TertiaryBins.size());
}

//------------------------------------------------------------------------------
bool vtkTFCSparseHistogram::Load(const std::vector<unsigned char>& buffer)
{
  const auto fail = [this](const char* why)
  {
    vtkErrorMacro("The buffer is no joint histogram: " << why);
    return false;
  };
  size_t at = 0;
  std::uint64_t magic = 0;
  if (!Take(buffer, at, &magic, 1) || magic != Magic)
  {
    return fail("it does not begin as one, or was made on a machine with another byte order.");
  }
  std::array<Axis, 3> axes;
  for (Axis& axis : axes)
  {
    double numbers[3] = {};
    if (!Take(buffer, at, numbers, 3))
    {
      return fail("it is cut short.");
    }
    if (const char* problem = CheckAxis(numbers[0], numbers[1], numbers[2]))
    {
      return fail(problem);
    }
    axis = { numbers[0], numbers[1], static_cast<int>(numbers[2]) };
  }
  std::uint64_t entries = 0;
  constexpr size_t entrySize = sizeof(double) + sizeof(unsigned int) + sizeof(unsigned short);
  if (!Take(buffer, at, &entries, 1) || entries > buffer.size() / entrySize ||
    entries * entrySize != buffer.size() - at)
  {
    return fail("its length does not match its number of entries.");
  }
  std::vector<double> counts(entries);
  std::vector<unsigned int> cells(entries);
  std::vector<unsigned short> bins(entries);
  Take(buffer, at, counts.data(), entries);
  Take(buffer, at, cells.data(), entries);
  Take(buffer, at, bins.data(), entries);
  std::swap(axes, this->Axes);
  if (!this->SetEntries(std::move(cells), std::move(bins), std::move(counts)))
  {
    std::swap(axes, this->Axes);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCSparseHistogram::DeepCopy(const vtkTFCSparseHistogram* other)
{
  if (other && other != this)
  {
    this->Axes = other->Axes;
    this->Cells = other->Cells;
    this->TertiaryBins = other->TertiaryBins;
    this->Counts = other->Counts;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCSparseHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Axis& axis : this->Axes)
  {
    os << indent << "Axis: " << axis.Minimum << " to " << axis.Maximum << ", " << axis.Bins
       << " bins\n";
  }
  os << indent << "NumberOfEntries: " << this->GetNumberOfEntries() << "\n";
}
