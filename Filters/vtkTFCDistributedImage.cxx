// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCDistributedImage.h"

#include "vtkTFCSamples.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace
{
using Extent = vtkTFCDistributedImage::Extent;

constexpr Extent EmptyExtent{ 0, -1, 0, -1, 0, -1 };
constexpr int MessageTag = 0x7f6;

//------------------------------------------------------------------------------
bool IsEmpty(const Extent& e)
{
  return e[0] > e[1] || e[2] > e[3] || e[4] > e[5];
}

//------------------------------------------------------------------------------
Extent Intersect(const Extent& a, const Extent& b)
{
  Extent result;
  for (int i = 0; i < 6; i += 2)
  {
    result[i] = std::max(a[i], b[i]);
    result[i + 1] = std::min(a[i + 1], b[i + 1]);
  }
  return IsEmpty(result) ? EmptyExtent : result;
}

//------------------------------------------------------------------------------
void Include(Extent& box, const Extent& other)
{
  if (IsEmpty(box))
  {
    box = other;
  }
  for (int i = 0; !IsEmpty(other) && i < 6; i += 2)
  {
    box[i] = std::min(box[i], other[i]);
    box[i + 1] = std::max(box[i + 1], other[i + 1]);
  }
}

//------------------------------------------------------------------------------
Extent GetPointExtent(vtkDataSet* data)
{
  Extent extent = EmptyExtent;
  auto* image = vtkImageData::SafeDownCast(data);
  auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data);
  auto* structured = vtkStructuredGrid::SafeDownCast(data);
  if (image)
  {
    image->GetExtent(extent.data());
  }
  if (rectilinear)
  {
    rectilinear->GetExtent(extent.data());
  }
  if (structured)
  {
    structured->GetExtent(extent.data());
  }
  return IsEmpty(extent) ? EmptyExtent : extent;
}

//------------------------------------------------------------------------------
Extent ToCells(Extent points)
{
  for (int i = 0; i < 6; i += 2)
  {
    // An axis with one point has one layer of flat cells.
    points[i + 1] = std::max(points[i], points[i + 1] - 1);
  }
  return points;
}

//------------------------------------------------------------------------------
/**
 * Calls body(offsetInA, offsetInB, length) for the rows of `part`, which lies in both.
 */
template <typename Body>
void ForRows(const Extent& part, const Extent& a, const Extent& b, Body&& body)
{
  const auto offset = [&](const Extent& e, int y, int z)
  {
    const vtkIdType nx = e[1] - e[0] + 1, ny = e[3] - e[2] + 1;
    return ((z - e[4]) * ny + (y - e[2])) * nx + (part[0] - e[0]);
  };
  for (int z = part[4]; z <= part[5]; ++z)
  {
    for (int y = part[2]; y <= part[3]; ++y)
    {
      body(offset(a, y, z), offset(b, y, z), vtkIdType{ 1 } + part[1] - part[0]);
    }
  }
}

//------------------------------------------------------------------------------
/**
 * Bounding box of the samples of `extent` that are not flagged as duplicates.
 */
Extent GetUnflagged(const Extent& extent, vtkUnsignedCharArray* ghosts, unsigned char duplicate)
{
  Extent box = EmptyExtent;
  vtkIdType id = 0;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x, ++id)
      {
        if (!(ghosts->GetValue(id) & duplicate))
        {
          Include(box, { x, x, y, y, z, z });
        }
      }
    }
  }
  return box;
}

//------------------------------------------------------------------------------
Extent FindInnerExtent(vtkDataSet* data, const Extent& points, int association)
{
  if (IsEmpty(points))
  {
    return EmptyExtent;
  }
  const bool cells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const Extent cellExtent = ToCells(points);
  auto* cellGhosts = vtkTFCSamples::GetGhosts(data->GetCellData());
  if (cellGhosts &&
    cellGhosts->GetNumberOfValues() == vtkTFCDistributedImage::GetNumberOfSamples(cellExtent))
  {
    Extent inner = GetUnflagged(cellExtent, cellGhosts,
      vtkTFCSamples::GetDuplicateBit(vtkDataObject::FIELD_ASSOCIATION_CELLS));
    for (int i = 0; !cells && !IsEmpty(inner) && i < 6; i += 2)
    {
      // The points of a cell, except along an axis with a single layer of points.
      inner[i + 1] += points[i + 1] > points[i] ? 1 : 0;
    }
    return inner;
  }
  auto* pointGhosts = vtkTFCSamples::GetGhosts(data->GetPointData());
  if (!cells && pointGhosts &&
    pointGhosts->GetNumberOfValues() == vtkTFCDistributedImage::GetNumberOfSamples(points))
  {
    return GetUnflagged(points, pointGhosts,
      vtkTFCSamples::GetDuplicateBit(vtkDataObject::FIELD_ASSOCIATION_POINTS));
  }
  return cells ? cellExtent : points;
}
}

//------------------------------------------------------------------------------
vtkTFCDistributedImage::vtkTFCDistributedImage(vtkDataSet* data, int association,
  vtkMultiProcessController* controller)
  : Controller(controller)
  , Whole(EmptyExtent)
  , Data(data)
  , Association(association)
{
  if (controller)
  {
    this->Rank = controller->GetLocalProcessId();
    this->NumberOfRanks = controller->GetNumberOfProcesses();
  }
  const Extent points = GetPointExtent(data);
  const Extent local = IsEmpty(points)                      ? EmptyExtent
    : association == vtkDataObject::FIELD_ASSOCIATION_CELLS ? ToCells(points)
                                                            : points;
  const Extent inner = FindInnerExtent(data, points, association);
  this->Local.assign(this->NumberOfRanks, local);
  this->Inner.assign(this->NumberOfRanks, inner);
  if (this->NumberOfRanks > 1)
  {
    int mine[12];
    std::copy(local.begin(), local.end(), mine);
    std::copy(inner.begin(), inner.end(), mine + 6);
    std::vector<int> all(12 * static_cast<size_t>(this->NumberOfRanks));
    controller->AllGather(mine, all.data(), 12);
    for (int rank = 0; rank < this->NumberOfRanks; ++rank)
    {
      std::copy_n(all.data() + 12 * rank, 6, this->Local[rank].begin());
      std::copy_n(all.data() + 12 * rank + 6, 6, this->Inner[rank].begin());
    }
  }
  // Without neighbours to own them, samples flagged as duplicates are still part of the lattice.
  for (const Extent& extent : this->NumberOfRanks > 1 ? this->Inner : this->Local)
  {
    Include(this->Whole, extent);
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkTFCDistributedImage::GetNumberOfSamples(const Extent& e)
{
  vtkIdType count = IsEmpty(e) ? 0 : 1;
  for (int i = 0; i < 6; i += 2)
  {
    count *= vtkIdType{ 1 } + e[i + 1] - e[i];
  }
  return count;
}

//------------------------------------------------------------------------------
Extent vtkTFCDistributedImage::Grow(int rank, int width) const
{
  Extent result = this->Local[rank];
  if (IsEmpty(result))
  {
    return EmptyExtent;
  }
  for (int i = 0; i < 6; i += 2)
  {
    // Within the whole, but never without the samples of this process. No int overflows.
    const std::int64_t low = static_cast<std::int64_t>(result[i]) - width;
    const std::int64_t high = static_cast<std::int64_t>(result[i + 1]) + width;
    result[i] =
      std::min<int>(result[i], static_cast<int>(std::max<std::int64_t>(low, this->Whole[i])));
    result[i + 1] = std::max<int>(result[i + 1],
      static_cast<int>(std::min<std::int64_t>(high, this->Whole[i + 1])));
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> vtkTFCDistributedImage::GetOwnedSamples() const
{
  std::vector<unsigned char> owned;
  const Extent& local = this->GetLocalExtent();
  const bool cells = this->Association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (IsEmpty(local))
  {
    // No lattice: only the flags tell.
    auto* ghosts = vtkTFCSamples::GetGhosts(cells
        ? static_cast<vtkDataSetAttributes*>(this->Data->GetCellData())
        : static_cast<vtkDataSetAttributes*>(this->Data->GetPointData()));
    if (ghosts)
    {
      const unsigned char duplicate = vtkTFCSamples::GetDuplicateBit(this->Association);
      owned.resize(static_cast<size_t>(ghosts->GetNumberOfValues()));
      for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
      {
        owned[i] = (ghosts->GetValue(i) & duplicate) ? 0 : 1;
      }
    }
    return owned;
  }
  const auto set = [&](const Extent& part, unsigned char value)
  {
    const Extent common = Intersect(part, local);
    if (!IsEmpty(common))
    {
      ForRows(common, local, local,
        [&](vtkIdType at, vtkIdType, vtkIdType length)
        { std::fill_n(owned.begin() + at, length, value); });
    }
  };
  const Extent& inner = this->Inner[this->Rank];
  bool all = inner == local;
  for (int rank = 0; rank < this->Rank; ++rank)
  {
    all = all && IsEmpty(Intersect(this->Inner[rank], local));
  }
  if (!all)
  {
    owned.assign(static_cast<size_t>(GetNumberOfSamples(local)), 0);
    set(inner, 1);
    for (int rank = 0; rank < this->Rank; ++rank)
    {
      set(this->Inner[rank], 0);
    }
  }
  return owned;
}

//------------------------------------------------------------------------------
void vtkTFCDistributedImage::Exchange(const float* local, int width, float* grown) const
{
  const Extent& mine = this->GetLocalExtent();
  const Extent wanted = this->Grow(this->Rank, width);
  std::fill_n(grown, GetNumberOfSamples(wanted), std::numeric_limits<float>::quiet_NaN());
  if (!IsEmpty(mine))
  {
    ForRows(mine, mine, wanted,
      [&](vtkIdType from, vtkIdType to, vtkIdType length)
      { std::copy_n(local + from, length, grown + to); });
  }

  // Messages longer than this many values are cut: MPI counts in int.
  constexpr vtkIdType longest = 1 << 28;
  std::vector<float> buffer;
  const auto send = [&](int to)
  {
    const Extent part = Intersect(this->Inner[this->Rank], this->Grow(to, width));
    buffer.clear();
    buffer.reserve(static_cast<size_t>(GetNumberOfSamples(part)));
    ForRows(part, mine, mine,
      [&](vtkIdType from, vtkIdType, vtkIdType length)
      { buffer.insert(buffer.end(), local + from, local + from + length); });
    const vtkIdType total = static_cast<vtkIdType>(buffer.size());
    for (vtkIdType at = 0; at < total; at += longest)
    {
      this->Controller->Send(buffer.data() + at, std::min(longest, total - at), to, MessageTag);
    }
  };
  const auto receive = [&](int from)
  {
    const Extent part = Intersect(this->Inner[from], wanted);
    const vtkIdType total = GetNumberOfSamples(part);
    buffer.resize(static_cast<size_t>(total));
    for (vtkIdType at = 0; at < total; at += longest)
    {
      this->Controller->Receive(buffer.data() + at, std::min(longest, total - at), from,
        MessageTag);
    }
    ForRows(part, part, wanted,
      [&](vtkIdType at, vtkIdType to, vtkIdType length)
      { std::copy_n(buffer.data() + at, length, grown + to); });
  };
  for (int low = 0; low < this->NumberOfRanks; ++low)
  {
    for (int high = low + 1; high < this->NumberOfRanks; ++high)
    {
      if (this->Rank == low)
      {
        send(high);
        receive(high);
      }
      else if (this->Rank == high)
      {
        receive(low);
        send(low);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkTFCDistributedImage::ReduceDoubles(double* values, vtkIdType count, int operation) const
{
  if (this->NumberOfRanks > 1 && count > 0)
  {
    const std::vector<double> mine(values, values + count);
    this->Controller->AllReduce(mine.data(), values, count, operation);
  }
}

//------------------------------------------------------------------------------
void vtkTFCDistributedImage::Sum(double* values, vtkIdType count) const
{
  this->ReduceDoubles(values, count, vtkCommunicator::SUM_OP);
}

//------------------------------------------------------------------------------
void vtkTFCDistributedImage::Minimum(double* values, vtkIdType count) const
{
  this->ReduceDoubles(values, count, vtkCommunicator::MIN_OP);
}

//------------------------------------------------------------------------------
void vtkTFCDistributedImage::Maximum(double* values, vtkIdType count) const
{
  this->ReduceDoubles(values, count, vtkCommunicator::MAX_OP);
}

//------------------------------------------------------------------------------
void vtkTFCDistributedImage::Sum(std::int64_t* values, vtkIdType count) const
{
  if (this->NumberOfRanks > 1 && count > 0)
  {
    const std::vector<long long> mine(values, values + count);
    std::vector<long long> all(mine.size());
    this->Controller->AllReduce(mine.data(), all.data(), count, vtkCommunicator::SUM_OP);
    std::copy(all.begin(), all.end(), values);
  }
}

//------------------------------------------------------------------------------
bool vtkTFCDistributedImage::All(bool value) const
{
  double flag = value ? 1. : 0.;
  this->Minimum(&flag, 1);
  return flag > 0.;
}

//------------------------------------------------------------------------------
bool vtkTFCDistributedImage::Any(bool value) const
{
  double flag = value ? 1. : 0.;
  this->Maximum(&flag, 1);
  return flag > 0.;
}

//------------------------------------------------------------------------------
std::string vtkTFCDistributedImage::ShareText(bool has, const std::string& text) const
{
  if (this->NumberOfRanks == 1)
  {
    return has ? text : std::string();
  }
  double lowest = has ? this->Rank : this->NumberOfRanks;
  this->Minimum(&lowest, 1);
  const int source = static_cast<int>(lowest);
  if (source == this->NumberOfRanks)
  {
    return {};
  }
  vtkIdType length = static_cast<vtkIdType>(text.size());
  this->Controller->Broadcast(&length, 1, source);
  std::string shared = this->Rank == source ? text : std::string(static_cast<size_t>(length), ' ');
  if (length > 0)
  {
    this->Controller->Broadcast(&shared[0], length, source);
  }
  return shared;
}

//------------------------------------------------------------------------------
std::vector<std::int64_t> vtkTFCDistributedImage::Gather(
  const std::vector<std::int64_t>& values) const
{
  if (this->NumberOfRanks == 1)
  {
    return values;
  }
  const vtkIdType length = static_cast<vtkIdType>(values.size());
  std::vector<vtkIdType> lengths(this->NumberOfRanks);
  this->Controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(lengths.size(), 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  const std::vector<long long> mine(values.begin(), values.end());
  std::vector<long long> all(static_cast<size_t>(offsets.back() + lengths.back()));
  this->Controller->AllGatherV(mine.data(), all.data(), length, lengths.data(), offsets.data());
  return { all.begin(), all.end() };
}
