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
  return this->Masked ? this->RunBall<double>(kernel, out) : this->RunBall<float>(kernel, out);
}

//------------------------------------------------------------------------------
template <typename Real>
bool vtkTFCNeighborhoodMean::RunBall(const tfc::BallKernel& kernel, float* out) const
{
  constexpr bool masked = std::is_same<Real, double>::value;
  const tfc::BallMean<Real> ball(this->Values, this->Size, this->Begin, this->End, this->Middle,
    masked, kernel,
    [](tfc::Index count, auto&& body)
    { vtkTFCThreads::For(0, count, 1 + count / 64, vtkTFCSimd::Vectorize(body)); });
  const vtkIdType floats = masked ? 2 : 1;
  const auto buffer = vtkTFCLargeBuffer::Allocate(ball.GetSize() * floats);
  // A double buffer in memory that was asked for as floats: nothing is read before it is written.
  Real* spectrum = reinterpret_cast<Real*>(buffer.get());

  // A range has a workspace, with a plane of the spectrum in it: some units each, but short enough
  // for all threads to end together and for an abort.
  const tfc::Index samples = this->Size[0] * this->Size[1] * this->Size[2];
  const auto run = [this, samples](tfc::Index count, double from, double to, const auto& body)
  {
    constexpr tfc::Index samplesOfRange = tfc::Index{ 1 } << 22;
    const vtkIdType grain = 1 +
      std::min(count / (16 * vtkTFCThreads::GetNumberOfThreads()),
        count * samplesOfRange / std::max<tfc::Index>(samples, 1));
    return vtkTFCThreads::ForWithProgress(0, count, grain, this->Owner, this->At(from),
      this->At(to),
      vtkTFCSimd::Vectorize(
        [&](vtkIdType begin, vtkIdType end)
        {
          typename tfc::BallMean<Real>::Workspace work;
          for (vtkIdType unit = begin; unit < end; ++unit)
          {
            body(unit, work);
          }
        }));
  };
  return run((this->Size[2] + 1) / 2, 0., 0.3,
           [&](vtkIdType pair, auto& work) { ball.Forward(2 * pair, spectrum, work); }) &&
    run(ball.GetNumberOfUnits(), 0.3, 0.7,
      [&](vtkIdType unit, auto& work) { ball.Filter(unit, spectrum, work); }) &&
    run((this->End[2] - this->Begin[2] + 1) / 2, 0.7, 1.,
      [&](vtkIdType pair, auto& work)
      {
        const tfc::Index z = this->Begin[2] + 2 * pair;
        ball.Backward(z, spectrum, work, out + this->GetOffset(z));
        this->ApplyBoundary<masked>(z, out + this->GetOffset(z));
        if (z + 1 < this->End[2])
        {
          this->ApplyBoundary<masked>(z + 1, out + this->GetOffset(z + 1));
        }
      });
}

//------------------------------------------------------------------------------
template <bool Masked>
void vtkTFCNeighborhoodMean::ApplyBoundary(tfc::Index z, float* slice) const
{
  if (this->BoundaryWeight == 0.f)
  {
    return;
  }
  const tfc::Index width = this->End[0] - this->Begin[0];
  std::vector<float> scratch(static_cast<size_t>(width));
  for (tfc::Index y = this->Begin[1]; y < this->End[1]; ++y)
  {
    tfc::ApplyBoundaryRow<Masked>(this->Values, this->Size, y, z, this->Begin[0], this->End[0],
      this->BoundaryWeight, scratch.data(), slice + (y - this->Begin[1]) * width);
  }
}

//------------------------------------------------------------------------------
tfc::Index vtkTFCNeighborhoodMean::GetOffset(tfc::Index z) const
{
  return (z - this->Begin[2]) * (this->End[0] - this->Begin[0]) * (this->End[1] - this->Begin[1]);
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
  double reach[3], length[3];
  for (int a = 0; a < 3; ++a)
  {
    reach[a] =
      std::min(std::floor(radius / this->Spacing[a]), static_cast<double>(this->Size[a] - 1));
    length[a] =
      static_cast<double>(tfc::GetFourierLength(this->Size[a] + static_cast<tfc::Index>(reach[a])));
  }
  const double size = this->Masked ? sizeof(double) : sizeof(float), lanes = 64. / size;
  // Rows are filled to a cache line.
  const double row = std::ceil(static_cast<double>(this->Size[0]) / lanes) * 2. * lanes;
  const double frequencies = length[1] / 2. + 1., pitch = length[2] / 2. + lanes;
  const double spectrum = static_cast<double>(this->Size[2]) * frequencies * row;
  const double kernel = (reach[0] + lanes) * (frequencies + reach[1] + 1.) * pitch;
  const double thread = length[2] * (row + 2. * lanes) + (length[0] / 2. + 1.) * pitch;
  return size *
    ((this->Masked ? 2. : 1.) * spectrum + kernel + vtkTFCThreads::GetNumberOfThreads() * thread) +
    16. * (reach[0] + 1.) * (reach[1] + 1.) * (reach[2] + 1.);
}
