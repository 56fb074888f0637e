// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCOcclusion.h"

#include "Kernels/TFCOcclusion.h"
#include "vtkTFCLargeBuffer.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include "vtkObjectFactory.h"

#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkTFCOcclusion);

//------------------------------------------------------------------------------
std::string vtkTFCOcclusion::CheckParameters() const
{
  std::ostringstream problem;
  if (this->Radius < 1)
  {
    problem << "Radius is " << this->Radius << ". Set it to a number of voxels from 1 on.";
  }
  else if (!(this->BoundaryParameter > 0.) || !std::isfinite(this->BoundaryParameter))
  {
    problem << "BoundaryParameter is " << this->BoundaryParameter
            << ". Set it to a positive number, typically 0.001 to 0.01, for noisy data up to 1.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
bool vtkTFCOcclusion::ComputeProperties(const Field& field, const std::vector<float*>& outputs)
{
  const tfc::BoxSum box(field.Size, field.Begin, field.End, this->Radius);
  const auto sums = vtkTFCLargeBuffer::Allocate(box.GetTemporarySize());
  vtkTFCLargeBuffer::Pointer validity;
  if (field.HasInvalid)
  {
    validity = vtkTFCLargeBuffer::Allocate(box.GetTemporarySize());
  }
  bool done = vtkTFCThreads::ForWithProgress(0, field.Size[2], 1, this, 0.15, 0.6,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        tfc::BoxSum::Workspace work;
        for (vtkIdType z = begin; z < end; ++z)
        {
          if (validity)
          {
            box.SumSlice<tfc::BoxTerm::ValidValue>(field.Values, z, sums.get(), work);
            box.SumSlice<tfc::BoxTerm::Validity>(field.Values, z, validity.get(), work);
          }
          else
          {
            box.SumSlice<tfc::BoxTerm::Value>(field.Values, z, sums.get(), work);
          }
        }
      }));
  if (!done)
  {
    return false;
  }

  const float weight =
    tfc::ConductanceWeight(field.Range[1] - field.Range[0], this->BoundaryParameter);
  const tfc::Index height = field.End[1] - field.Begin[1];
  // Tiles of a few rows: the slab that the running sum spans stays in the second-level cache.
  constexpr tfc::Index tileRows = 8;
  const tfc::Index tiles = (height + tileRows - 1) / tileRows;
  return vtkTFCThreads::ForWithProgress(0, tiles, 1, this, 0.6, 1.,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        tfc::BoxSum::Workspace work;
        for (tfc::Index tile = begin; tile < end; ++tile)
        {
          const tfc::Index y0 = tile * tileRows, y1 = std::min(height, y0 + tileRows);
          if (validity)
          {
            tfc::OcclusionTile<true>(box, field.Values, field.Size, field.Begin, field.End, weight,
              sums.get(), validity.get(), y0, y1, work, outputs[0]);
          }
          else
          {
            tfc::OcclusionTile<false>(box, field.Values, field.Size, field.Begin, field.End, weight,
              sums.get(), nullptr, y0, y1, work, outputs[0]);
          }
        }
      }));
}

//------------------------------------------------------------------------------
void vtkTFCOcclusion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "BoundaryParameter: " << this->BoundaryParameter << "\n";
}
