// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCNeighborhoodMean.h"

#include "Kernels/TFCBallMean.h"
#include "Kernels/TFCOcclusion.h"
#include "vtkTFCLargeBuffer.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

//------------------------------------------------------------------------------
vtkTFCNeighborhoodMean::vtkTFCNeighborhoodMean(const float* values, const tfc::Index size[3],
  const tfc::Index begin[3], const tfc::Index end[3], const double spacing[3], bool masked)
  : Values(values)
  , Masked(masked)
{
  std::copy_n(size, 3, this->Size);
  std::copy_n(begin, 3, this->Begin);
  std::copy_n(end, 3, this->End);
  std::copy_n(spacing, 3, this->Spacing);
}

//------------------------------------------------------------------------------
void vtkTFCNeighborhoodMean::SetProgress(vtkAlgorithm* owner, double from, double to)
{
  this->Owner = owner;
  this->From = from;
  this->To = to;
}

//------------------------------------------------------------------------------
bool vtkTFCNeighborhoodMean::ComputeBox(double radius, float* out) const
{
  return this->Masked ? this->RunBox<true>(radius, out) : this->RunBox<false>(radius, out);
}

//------------------------------------------------------------------------------
template <bool Masked>
bool vtkTFCNeighborhoodMean::RunBox(double radius, float* out) const
{
  tfc::Index reach[3];
  for (int a = 0; a < 3; ++a)
  {
    const double samples = std::floor(radius / this->Spacing[a] * (1. + 1e-9));
    reach[a] = static_cast<tfc::Index>(std::min(samples, static_cast<double>(this->Size[a])));
  }
  const tfc::BoxSum box(this->Size, this->Begin, this->End, reach);
  const auto sums = vtkTFCLargeBuffer::Allocate(box.GetTemporarySize());
  vtkTFCLargeBuffer::Pointer validity;
  if (Masked)
  {
    validity = vtkTFCLargeBuffer::Allocate(box.GetTemporarySize());
  }
  const bool done =
    vtkTFCThreads::ForWithProgress(0, this->Size[2], 1, this->Owner, this->From, this->At(0.5),
      vtkTFCSimd::Vectorize(
        [&](vtkIdType begin, vtkIdType end)
        {
          tfc::BoxSum::Workspace work;
          for (vtkIdType z = begin; z < end; ++z)
          {
            if constexpr (Masked)
            {
              box.SumSlice<tfc::BoxTerm::ValidValue>(this->Values, z, sums.get(), work);
              box.SumSlice<tfc::BoxTerm::Validity>(this->Values, z, validity.get(), work);
            }
            else
            {
              box.SumSlice<tfc::BoxTerm::Value>(this->Values, z, sums.get(), work);
            }
          }
        }));
  if (!done)
  {
    return false;
  }
  // Tiles of a few rows: the slab that the running sum spans stays in the second-level cache.
  const tfc::Index height = this->End[1] - this->Begin[1];
  constexpr tfc::Index tileRows = 8;
  const tfc::Index tiles = (height + tileRows - 1) / tileRows;
  return vtkTFCThreads::ForWithProgress(0, tiles, 1, this->Owner, this->At(0.5), this->To,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        tfc::BoxSum::Workspace work;
        for (tfc::Index tile = begin; tile < end; ++tile)
        {
          const tfc::Index y0 = tile * tileRows, y1 = std::min(height, y0 + tileRows);
          tfc::OcclusionTile<Masked>(box, this->Values, this->Size, this->Begin, this->End,
            this->BoundaryWeight, sums.get(), validity.get(), y0, y1, work, out);
        }
      }));
}

//------------------------------------------------------------------------------
bool vtkTFCNeighborhoodMean::ComputeBall(double radius, tfc::DistanceWeight weight,
  float* out) const
{
  const tfc::BallKernel kernel(this->Size, this->Spacing, radius, weight);
  const bool done =
    this->Masked ? this->RunBall<double>(kernel, out) : this->RunBall<float>(kernel, out);
  return done && (this->BoundaryWeight == 0.f || this->ApplyBoundary(out));
}

//------------------------------------------------------------------------------
template <typename Real>
bool vtkTFCNeighborhoodMean::RunBall(const tfc::BallKernel& kernel, float* out) const
{
  const bool masked = std::is_same<Real, double>::value;
  const tfc::BallMean<Real> ball(this->Values, this->Size, this->Begin, this->End, this->Middle,
    masked, kernel);
  tfc::Index lengths[3];
  ball.GetLengths(lengths);
  const auto response = kernel.template GetSpectrum<Real>(lengths, ball.GetScale(),
    [](tfc::Index count, auto&& body)
    { vtkTFCThreads::For(0, count, 1 + count / 64, vtkTFCSimd::Vectorize(body)); });
  const vtkIdType floats = masked ? 2 : 1;
  const auto buffer = vtkTFCLargeBuffer::Allocate(ball.GetSize() * floats);
  // A double buffer in memory that was asked for as floats: nothing is read before it is written.
  Real* spectrum = reinterpret_cast<Real*>(buffer.get());

  using Workspace = typename tfc::BallMean<Real>::Workspace;
  return vtkTFCThreads::ForWithProgress(0, this->Size[2], 1, this->Owner, this->From, this->At(0.3),
           vtkTFCSimd::Vectorize(
             [&](vtkIdType begin, vtkIdType end)
             {
               Workspace work;
               for (vtkIdType z = begin; z < end; ++z)
               {
                 ball.Forward(z, spectrum, work);
               }
             })) &&
    vtkTFCThreads::ForWithProgress(0, ball.GetNumberOfUnits(), 1, this->Owner, this->At(0.3),
      this->At(0.65),
      vtkTFCSimd::Vectorize(
        [&](vtkIdType begin, vtkIdType end)
        {
          Workspace work;
          for (vtkIdType unit = begin; unit < end; ++unit)
          {
            ball.Filter(unit, response.data(), spectrum, work);
          }
        })) &&
    vtkTFCThreads::ForWithProgress(this->Begin[2], this->End[2], 1, this->Owner, this->At(0.65),
      this->At(0.95),
      vtkTFCSimd::Vectorize(
        [&](vtkIdType begin, vtkIdType end)
        {
          Workspace work;
          const tfc::Index slice =
            (this->End[0] - this->Begin[0]) * (this->End[1] - this->Begin[1]);
          for (vtkIdType z = begin; z < end; ++z)
          {
            ball.Backward(z, spectrum, work, out + (z - this->Begin[2]) * slice);
          }
        }));
}

//------------------------------------------------------------------------------
bool vtkTFCNeighborhoodMean::ApplyBoundary(float* out) const
{
  const tfc::Index width = this->End[0] - this->Begin[0];
  const tfc::Index height = this->End[1] - this->Begin[1];
  return vtkTFCThreads::ForWithProgress(0, height * (this->End[2] - this->Begin[2]), 64,
    this->Owner, this->At(0.95), this->To,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<float> scratch(static_cast<size_t>(width));
        for (tfc::Index row = begin; row < end; ++row)
        {
          const tfc::Index y = this->Begin[1] + row % height, z = this->Begin[2] + row / height;
          const auto apply =
            this->Masked ? tfc::ApplyBoundaryRow<true> : tfc::ApplyBoundaryRow<false>;
          apply(this->Values, this->Size, y, z, this->Begin[0], this->End[0], this->BoundaryWeight,
            scratch.data(), out + row * width);
        }
      }));
}

//------------------------------------------------------------------------------
double vtkTFCNeighborhoodMean::GetBoxBytes() const
{
  const double block = static_cast<double>(this->End[0] - this->Begin[0]) *
    static_cast<double>(this->End[1] - this->Begin[1]);
  return block * static_cast<double>(this->Size[2]) * (this->Masked ? 8. : 4.);
}

//------------------------------------------------------------------------------
double vtkTFCNeighborhoodMean::GetBallBytes(double radius) const
{
  double length[3], octant = 1., response = 1.;
  for (int a = 0; a < 3; ++a)
  {
    const double reach =
      std::min(std::floor(radius / this->Spacing[a]), static_cast<double>(this->Size[a] - 1));
    length[a] =
      static_cast<double>(tfc::GetFourierLength(this->Size[a] + static_cast<tfc::Index>(reach)));
    octant *= reach + 1.;
    response *= length[a] / 2. + (a ? 1. : 16.); // rows are filled to a cache line
  }
  // A block of frequencies more than needed; two fields of twice the size when masked.
  const double spectrum =
    static_cast<double>(this->Size[2]) * length[1] * (length[0] / 2. + 17.) * 8.;
  return (this->Masked ? 4. : 1.) * spectrum + (this->Masked ? 8. : 4.) * response + 16. * octant;
}
