// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCImageBlocks.h"

#include "vtkTFCAttributePacker.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkExtractVOI.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkResampleToImage.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

using Block = vtkTFCImageBlocks::Block;
using Extent = std::array<int, 6>;

//------------------------------------------------------------------------------
std::string MakeGridFingerprint(vtkRectilinearGrid* grid,
  const std::vector<vtkTFCAttribute>& attributes)
{
  std::ostringstream key;
  const auto add = [&key](vtkAbstractArray* array)
  { key << array << '@' << (array ? array->GetMTime() : 0) << ' '; };
  add(grid->GetXCoordinates());
  add(grid->GetYCoordinates());
  add(grid->GetZCoordinates());
  add(grid->GetPointGhostArray());
  add(grid->GetCellGhostArray());
  for (const auto& attribute : attributes)
  {
    add(grid->GetPointData()->GetAbstractArray(attribute.Array.c_str()));
    add(grid->GetCellData()->GetAbstractArray(attribute.Array.c_str()));
  }
  return key.str();
}

//------------------------------------------------------------------------------
// Only the arrays that are drawn, lest a copy has more; all where one is missing, for the message.
void SelectArrays(vtkDataSet* from, const std::vector<vtkTFCAttribute>& attributes, vtkDataSet* to)
{
  const auto has = [&](const vtkTFCAttribute& attribute)
  {
    return from->GetPointData()->HasArray(attribute.Array.c_str()) ||
      from->GetCellData()->HasArray(attribute.Array.c_str());
  };
  if (!std::all_of(attributes.begin(), attributes.end(), has))
  {
    to->ShallowCopy(from);
    return;
  }
  const auto select = [&](vtkDataSetAttributes* source, vtkDataSetAttributes* target)
  {
    for (const auto& attribute : attributes)
    {
      target->AddArray(source->GetArray(attribute.Array.c_str()));
    }
    target->AddArray(source->GetArray(vtkDataSetAttributes::GhostArrayName()));
  };
  select(from->GetPointData(), to->GetPointData());
  select(from->GetCellData(), to->GetCellData());
}

//------------------------------------------------------------------------------
// Points of a uniform axis as fine as the finest part of a rectilinear one.
double CountFinePoints(vtkDataArray* coordinates)
{
  const vtkIdType count = coordinates->GetNumberOfTuples();
  double smallest = VTK_DOUBLE_MAX;
  for (vtkIdType i = 1; i < count; ++i)
  {
    const double spacing =
      std::abs(coordinates->GetComponent(i, 0) - coordinates->GetComponent(i - 1, 0));
    smallest = spacing > 0.0 ? std::min(smallest, spacing) : smallest;
  }
  const double length =
    count > 0 ? coordinates->GetComponent(count - 1, 0) - coordinates->GetComponent(0, 0) : 0.0;
  return smallest < VTK_DOUBLE_MAX ? std::ceil(std::abs(length) / smallest - 1e-6) + 1.0 : 1.0;
}

//------------------------------------------------------------------------------
// Bounds of the cells that are no duplicates of another block's.
std::array<double, 6> FindOwnedBounds(vtkRectilinearGrid* grid)
{
  std::array<double, 6> bounds;
  grid->GetBounds(bounds.data());
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  if (!ghosts || ghosts->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    return bounds;
  }
  vtkDataArray* coordinates[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  std::array<int, 3> first = { VTK_INT_MAX, VTK_INT_MAX, VTK_INT_MAX };
  std::array<int, 3> last = { -1, -1, -1 };
  const int* dimensions = grid->GetDimensions();
  const vtkIdType cells[2] = { std::max(1, dimensions[0] - 1), std::max(1, dimensions[1] - 1) };
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    if (!(ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL))
    {
      const std::array<vtkIdType, 3> place = { i % cells[0], i / cells[0] % cells[1],
        i / cells[0] / cells[1] };
      for (int axis = 0; axis < 3; ++axis)
      {
        first[axis] = std::min(first[axis], static_cast<int>(place[axis]));
        last[axis] = std::max(last[axis], static_cast<int>(place[axis]));
      }
    }
  }
  for (int axis = 0; axis < 3 && last[axis] >= 0; ++axis)
  {
    const double ends[2] = { coordinates[axis]->GetComponent(first[axis], 0),
      coordinates[axis]->GetComponent(std::min(last[axis] + 1, dimensions[axis] - 1), 0) };
    bounds[2 * axis] = std::min(ends[0], ends[1]);
    bounds[2 * axis + 1] = std::max(ends[0], ends[1]);
  }
  return bounds;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Resample(vtkRectilinearGrid* grid,
  const std::vector<vtkTFCAttribute>& attributes)
{
  double fine[3] = { CountFinePoints(grid->GetXCoordinates()),
    CountFinePoints(grid->GetYCoordinates()), CountFinePoints(grid->GetZCoordinates()) };
  const double most = 8.0 * static_cast<double>(grid->GetNumberOfPoints());
  const double factor = std::min(1.0, std::cbrt(most / (fine[0] * fine[1] * fine[2])));
  vtkNew<vtkResampleToImage> resample;
  vtkNew<vtkRectilinearGrid> wanted;
  wanted->CopyStructure(grid);
  SelectArrays(grid, attributes, wanted);
  resample->SetInputDataObject(wanted);
  resample->SetUseInputBounds(false);
  resample->SetSamplingBounds(FindOwnedBounds(grid).data());
  int dimensions[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] =
      std::max(fine[axis] > 1.0 ? 2 : 1, static_cast<int>(std::lround(factor * fine[axis])));
  }
  resample->SetSamplingDimensions(dimensions);
  resample->Update();
  vtkSmartPointer<vtkImageData> image = resample->GetOutput();
  return image;
}

//------------------------------------------------------------------------------
// The tuples [first, first + count) of an array, without a copy where its memory allows.
vtkSmartPointer<vtkDataArray> ViewTuples(vtkDataArray* array, vtkIdType first, vtkIdType count)
{
  auto view = vtk::TakeSmartPointer(array->NewInstance());
  view->SetName(array->GetName());
  view->SetNumberOfComponents(array->GetNumberOfComponents());
  if (array->HasStandardMemoryLayout())
  {
    const int components = array->GetNumberOfComponents();
    view->SetVoidArray(array->GetVoidPointer(first * components), count * components, 1);
  }
  else
  {
    view->SetNumberOfTuples(count);
    view->InsertTuples(0, count, first, array);
  }
  return view;
}

//------------------------------------------------------------------------------
// The wanted arrays of an image with another extent along z.
vtkSmartPointer<vtkImageData> MakeSlab(vtkImageData* image, const Extent& extent)
{
  const int* whole = image->GetExtent();
  auto slab = vtkSmartPointer<vtkImageData>::New();
  slab->SetOrigin(image->GetOrigin());
  slab->SetSpacing(image->GetSpacing());
  slab->SetDirectionMatrix(image->GetDirectionMatrix());
  slab->SetExtent(const_cast<int*>(extent.data()));
  const auto pass =
    [&](vtkDataSetAttributes* from, vtkDataSetAttributes* to, vtkIdType layer, vtkIdType layers)
  {
    for (int i = 0; i < from->GetNumberOfArrays(); ++i)
    {
      if (vtkDataArray* array = from->GetArray(i))
      {
        to->AddArray(ViewTuples(array, layer * (extent[4] - whole[4]), layer * layers));
      }
    }
  };
  const int* points = image->GetDimensions();
  const vtkIdType pointLayer = static_cast<vtkIdType>(points[0]) * points[1];
  const vtkIdType cellLayer =
    static_cast<vtkIdType>(std::max(1, points[0] - 1)) * std::max(1, points[1] - 1);
  pass(image->GetPointData(), slab->GetPointData(), pointLayer, extent[5] - extent[4] + 1);
  pass(image->GetCellData(), slab->GetCellData(), cellLayer, std::max(1, extent[5] - extent[4]));
  return slab;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakePiece(vtkImageData* image, const Extent& extent)
{
  const int* whole = image->GetExtent();
  if (std::equal(extent.begin(), extent.begin() + 4, whole))
  {
    return MakeSlab(image, extent);
  }
  vtkNew<vtkExtractVOI> extract;
  extract->SetInputData(image);
  extract->SetVOI(const_cast<int*>(extent.data()));
  extract->Update();
  vtkSmartPointer<vtkImageData> piece = extract->GetOutput();
  return piece;
}

//------------------------------------------------------------------------------
void Cut(vtkImageData* image, const std::vector<vtkTFCAttribute>& attributes,
  const vtkTFCImageBlocks::Limits& limits, std::vector<Block>& blocks)
{
  Extent whole;
  image->GetExtent(whole.data());
  std::array<int, 3> pieces;
  vtkIdType voxels = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int side = whole[2 * axis + 1] - whole[2 * axis] + 1;
    voxels *= side;
    // A piece has a layer more on either side.
    const int longest = std::max(1, limits.LongestSide - 3);
    pieces[axis] = side <= limits.LongestSide ? 1 : (side - 1 + longest - 1) / longest;
  }
  const vtkIdType others = static_cast<vtkIdType>(pieces[0]) * pieces[1];
  const vtkIdType most = std::max<vtkIdType>(1, limits.MostVoxels);
  const vtkIdType wanted = 1 + (voxels / others - 1) / most; // rounded up
  const int layers = std::max(1, whole[5] - whole[4]);
  pieces[2] = static_cast<int>(std::min<vtkIdType>(layers, std::max<vtkIdType>(pieces[2], wanted)));
  if (pieces[0] * pieces[1] * pieces[2] == 1)
  {
    blocks.push_back({ image, whole });
    return;
  }

  vtkNew<vtkImageData> wantedArrays;
  wantedArrays->CopyStructure(image);
  SelectArrays(image, attributes, wantedArrays);
  const auto end = [&](int axis, int piece)
  {
    const vtkIdType length = whole[2 * axis + 1] - whole[2 * axis];
    return whole[2 * axis] + static_cast<int>(length * piece / pieces[axis]);
  };
  for (int k = 0; k < pieces[2]; ++k)
  {
    for (int j = 0; j < pieces[1]; ++j)
    {
      for (int i = 0; i < pieces[0]; ++i)
      {
        const std::array<int, 3> place = { i, j, k };
        Extent drawn;
        Extent extent;
        for (int axis = 0; axis < 3; ++axis)
        {
          drawn[2 * axis] = end(axis, place[axis]);
          drawn[2 * axis + 1] = end(axis, place[axis] + 1);
          extent[2 * axis] = std::max(whole[2 * axis], drawn[2 * axis] - 1);
          extent[2 * axis + 1] = std::min(whole[2 * axis + 1], drawn[2 * axis + 1] + 1);
        }
        blocks.push_back({ MakePiece(wantedArrays, extent), drawn });
      }
    }
  }
}

}

//------------------------------------------------------------------------------
const std::vector<Block>& vtkTFCImageBlocks::Update(vtkDataObject* input,
  const std::vector<vtkTFCAttribute>& attributes, const Limits& limits, std::string& error)
{
  std::vector<vtkDataSet*> parts;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    parts = vtkCompositeDataSet::GetDataSets<vtkDataSet>(composite);
  }
  else if (auto* part = vtkDataSet::SafeDownCast(input))
  {
    parts = { part };
  }
  std::ostringstream key;
  key << limits.LongestSide << ' ' << limits.MostVoxels << '\n';
  std::vector<vtkDataSet*> drawable;
  std::string refused;
  for (vtkDataSet* part : parts)
  {
    auto* image = vtkImageData::SafeDownCast(part);
    auto* grid = vtkRectilinearGrid::SafeDownCast(part);
    if (part->GetNumberOfPoints() == 0)
    {
      continue;
    }
    if (!image && !grid)
    {
      refused = part->GetClassName();
      continue;
    }
    drawable.push_back(part);
    key << (image ? vtkTFCAttributePacker::MakeFingerprint(image, attributes)
                  : MakeGridFingerprint(grid, attributes))
        << '\n';
  }
  if (!refused.empty() || (input && parts.empty() && !vtkCompositeDataSet::SafeDownCast(input)))
  {
    error = "cannot render a " + (refused.empty() ? input->GetClassName() : refused) +
      ": the input must be images (vtkImageData) or rectilinear grids. The 'Resample To Image' "
      "filter makes one.";
  }
  if (this->Fingerprint != key.str())
  {
    this->Fingerprint = key.str();
    this->Blocks.clear();
    for (vtkDataSet* part : drawable)
    {
      auto* grid = vtkRectilinearGrid::SafeDownCast(part);
      vtkSmartPointer<vtkImageData> image = grid
        ? Resample(grid, attributes)
        : vtkSmartPointer<vtkImageData>(vtkImageData::SafeDownCast(part));
      Cut(image, attributes, limits, this->Blocks);
    }
    ++this->Generation;
  }
  return this->Blocks;
}
