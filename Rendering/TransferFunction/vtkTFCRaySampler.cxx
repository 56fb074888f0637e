// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRaySampler.h"

#include "vtkTFCDistributedImage.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
// A rectilinear grid as an image of its mean spacings, and where its points are.
void vtkTFCRaySampler::BindGrid(vtkDataSet* data)
{
  this->Image = vtkImageData::SafeDownCast(data);
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (!grid)
  {
    return;
  }
  this->Image = vtkSmartPointer<vtkImageData>::New();
  this->Image->SetExtent(grid->GetExtent());
  this->Image->GetPointData()->ShallowCopy(grid->GetPointData());
  this->Image->GetCellData()->ShallowCopy(grid->GetCellData());
  vtkDataArray* coordinates[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    auto& places = this->Places[axis];
    for (vtkIdType i = 0; i < coordinates[axis]->GetNumberOfTuples(); ++i)
    {
      places.push_back(coordinates[axis]->GetComponent(i, 0));
    }
    spacing[axis] = places.size() > 1
      ? (places.back() - places.front()) / static_cast<double>(places.size() - 1)
      : 0.0;
  }
  this->Image->SetSpacing(spacing);
}

//------------------------------------------------------------------------------
bool vtkTFCRaySampler::Bind(vtkDataSet* data, const std::vector<vtkTFCAttribute>& attributes,
  vtkMatrix4x4* modelToWorld, std::string& error)
{
  this->BindGrid(data);
  if (!this->Reader.Bind(this->Image, attributes, error))
  {
    return false;
  }
  vtkImageData* image = this->Image;
  const bool rectilinear = !this->Places[0].empty();
  this->Attributes = static_cast<int>(attributes.size());
  const bool cells = this->Reader.GetAssociation() == vtkDataObject::CELL;
  this->CellShift = cells ? 0.5 : 0.0;
  const int* extent = image->GetExtent();
  // Without a controller: what this image holds besides ghosts needs nobody else.
  const vtkTFCDistributedImage block(image, vtkDataObject::FIELD_ASSOCIATION_POINTS, nullptr);
  const auto& inner = block.GetInnerExtent();
  // A spacing of 0, of some 2D files and of layers, would have no inverse.
  vtkNew<vtkImageData> frame;
  double spacing[3];
  image->GetSpacing(spacing);
  const double largest =
    std::max({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  for (int axis = 0; axis < 3; ++axis)
  {
    if (spacing[axis] == 0.0)
    {
      spacing[axis] = largest > 0.0 ? largest : 1.0;
    }
    const bool layer = extent[2 * axis] == extent[2 * axis + 1];
    for (const int side : { 0, 1 })
    {
      const int index = inner[2 * axis + side];
      const double half = layer ? (side ? 0.5 : -0.5) : 0.0;
      this->Drawn[2 * axis + side] = rectilinear
        ? this->Places[axis][index - extent[2 * axis]] + half * spacing[axis]
        : index + half;
    }
    this->Lattice[2 * axis] = extent[2 * axis];
    this->Lattice[2 * axis + 1] =
      std::max(extent[2 * axis], extent[2 * axis + 1] - (cells ? 1 : 0));
  }
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(modelToWorld);
  if (!rectilinear)
  {
    frame->SetOrigin(image->GetOrigin());
    frame->SetSpacing(spacing);
    frame->SetDirectionMatrix(image->GetDirectionMatrix());
    vtkMatrix4x4::Multiply4x4(modelToWorld, frame->GetIndexToPhysicalMatrix(), matrix);
  }
  if (matrix->Determinant() == 0.0)
  {
    error = "The transform of the volume is singular: it has a scale of 0.";
    return false;
  }
  matrix->Invert();
  std::copy_n(matrix->GetData(), 16, this->WorldToFrame.begin());
  return true;
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkTFCRaySampler::ToFrame(const std::array<double, 3>& point, double w) const
{
  const auto& m = this->WorldToFrame;
  std::array<double, 3> result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] =
      m[4 * i] * point[0] + m[4 * i + 1] * point[1] + m[4 * i + 2] * point[2] + m[4 * i + 3] * w;
  }
  return result;
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkTFCRaySampler::ToIndex(const std::array<double, 3>& world) const
{
  auto index = this->ToFrame(world, 1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& places = this->Places[axis];
    if (!places.empty())
    {
      // Linear from point to point, as the arrays are.
      const auto above = std::upper_bound(places.begin() + 1, places.end(), index[axis]);
      const auto first = std::min<std::ptrdiff_t>(above - places.begin() - 1,
        std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(places.size()) - 2));
      const double width =
        places.size() > 1 ? places[first + 1] - places[first] : this->Image->GetSpacing()[axis];
      const double t = width != 0.0 ? (index[axis] - places[first]) / width : 0.0;
      index[axis] = this->Image->GetExtent()[2 * axis] + static_cast<double>(first) + t;
    }
  }
  return index;
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkTFCRaySampler::FindAxisPosition(const std::array<double, 3>& world) const
{
  auto position = this->ToFrame(world, 1.0);
  for (int axis = 0; axis < 3 && this->Places[0].empty(); ++axis)
  {
    position[axis] =
      this->Image->GetOrigin()[axis] + this->Image->GetSpacing()[axis] * position[axis];
  }
  return position;
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkTFCRaySampler::GetAxisBounds(int axis) const
{
  const auto& places = this->Places[axis];
  if (!places.empty())
  {
    return { { places.front(), places.back() } };
  }
  const double origin = this->Image->GetOrigin()[axis];
  const double spacing = this->Image->GetSpacing()[axis];
  const double ends[2] = { origin + spacing * this->Image->GetExtent()[2 * axis],
    origin + spacing * this->Image->GetExtent()[2 * axis + 1] };
  return { { std::min(ends[0], ends[1]), std::max(ends[0], ends[1]) } };
}

//------------------------------------------------------------------------------
bool vtkTFCRaySampler::Intersect(const std::array<double, 3>& start,
  const std::array<double, 3>& direction, double interval[2]) const
{
  const auto from = this->ToFrame(start, 1.0);
  const auto along = this->ToFrame(direction, 0.0);
  interval[0] = -std::numeric_limits<double>::infinity();
  interval[1] = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (along[axis] == 0.0)
    {
      // Of two images that share a face the line is in one.
      if (!(from[axis] >= this->Drawn[2 * axis] && from[axis] < this->Drawn[2 * axis + 1]))
      {
        return false;
      }
      continue;
    }
    const double a = (this->Drawn[2 * axis] - from[axis]) / along[axis];
    const double b = (this->Drawn[2 * axis + 1] - from[axis]) / along[axis];
    interval[0] = std::max(interval[0], std::min(a, b));
    interval[1] = std::min(interval[1], std::max(a, b));
  }
  return interval[0] < interval[1];
}

//------------------------------------------------------------------------------
std::array<int, 3> vtkTFCRaySampler::FindVoxel(const std::array<double, 3>& world) const
{
  const auto index = this->ToIndex(world);
  std::array<int, 3> voxel;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double place = std::floor(index[axis] + 0.5 - this->CellShift);
    voxel[axis] = static_cast<int>(
      std::clamp<double>(place, this->Lattice[2 * axis], this->Lattice[2 * axis + 1]));
  }
  return voxel;
}

//------------------------------------------------------------------------------
std::array<vtkTFCRaySampler::Corner, 8> vtkTFCRaySampler::FindCorners(
  const std::array<double, 3>& world) const
{
  const auto index = this->ToIndex(world);
  vtkIdType low[3];
  vtkIdType high[3];
  double t[3];
  const vtkIdType strides[3] = { 1, this->Lattice[1] - this->Lattice[0] + vtkIdType{ 1 },
    (this->Lattice[1] - this->Lattice[0] + vtkIdType{ 1 }) *
      (this->Lattice[3] - this->Lattice[2] + vtkIdType{ 1 }) };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = this->Lattice[2 * axis + 1] - this->Lattice[2 * axis];
    const double place =
      std::clamp(index[axis] - this->CellShift - this->Lattice[2 * axis], 0.0, last);
    const double first = std::min(std::floor(place), std::max(0.0, last - 1.0));
    t[axis] = place - first;
    low[axis] = static_cast<vtkIdType>(first) * strides[axis];
    high[axis] = low[axis] + (last > 0.0 ? strides[axis] : 0);
  }
  std::array<Corner, 8> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    corners[corner] = { 0, 1.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isHigh = corner >> axis & 1;
      corners[corner].Index += isHigh ? high[axis] : low[axis];
      corners[corner].Weight *= isHigh ? t[axis] : 1.0 - t[axis];
    }
  }
  return corners;
}

//------------------------------------------------------------------------------
void vtkTFCRaySampler::Sample(const std::array<double, 3>& world, double* values) const
{
  const auto corners = this->FindCorners(world);
  for (int a = 0; a < this->Attributes; ++a)
  {
    values[a] = 0.0;
    for (const Corner& corner : corners)
    {
      double value = std::numeric_limits<double>::quiet_NaN();
      if (!this->Reader.IsHidden(corner.Index))
      {
        this->Reader.Read(a, corner.Index, 1, &value);
      }
      // What has no weight must not spoil a sample with its NaN.
      values[a] += corner.Weight > 0.0 ? corner.Weight * value : 0.0;
    }
  }
}

//------------------------------------------------------------------------------
std::vector<double> vtkTFCRaySampler::SampleArray(vtkDataArray* array,
  const std::array<double, 3>& world) const
{
  std::vector<double> values(array->GetNumberOfComponents(), 0.0);
  for (const Corner& corner : this->FindCorners(world))
  {
    for (int c = 0; c < array->GetNumberOfComponents() && corner.Weight > 0.0; ++c)
    {
      values[c] += corner.Weight * array->GetComponent(corner.Index, c);
    }
  }
  return values;
}
