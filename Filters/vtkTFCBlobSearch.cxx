// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCBlobSearch.h"

#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include <cmath>
#include <limits>

namespace
{
// Of a pass over a lattice, relative to a step of diffusion.
constexpr double DiffuseCost = 1.;
constexpr double HalveCost = 0.3;
constexpr double RespondCost = 0.7;
constexpr double FindCost = 0.8;
}

//------------------------------------------------------------------------------
float* vtkTFCBlobSearch::Take()
{
  float* buffer = this->Free.back();
  this->Free.pop_back();
  return buffer;
}

//------------------------------------------------------------------------------
void vtkTFCBlobSearch::Release(float* buffer)
{
  if (buffer)
  {
    this->Free.push_back(buffer);
  }
}

//------------------------------------------------------------------------------
bool vtkTFCBlobSearch::ForSlices(const tfc::CoarseLattice& lattice, double cost, const Body& body)
{
  const double samples = static_cast<double>(lattice.GetSize());
  const double range = this->ProgressEnd - this->ProgressBegin;
  const double begin = this->ProgressBegin + range * this->Cost / this->TotalCost;
  this->Cost += cost * samples;
  const double end = this->ProgressBegin + range * this->Cost / this->TotalCost;
  // Starting threads costs as much as some hundred thousand samples: a pass over a small lattice
  // is one part, and only in a large one does the progress move within a pass.
  const tfc::Index slices = lattice.Size[2];
  const tfc::Index slice = std::max<tfc::Index>(1, lattice.Size[0] * lattice.Size[1]);
  const tfc::Index grain = std::min((slices + vtkTFCThreads::GetNumberOfThreads() - 1) /
      std::max(1, vtkTFCThreads::GetNumberOfThreads()),
    std::max<tfc::Index>(1, (tfc::Index{ 1 } << 23) / slice));
  return vtkTFCThreads::ForWithProgress(0, samples > 0. ? slices : 0, grain, this->Owner, begin,
    end, body);
}

//------------------------------------------------------------------------------
double vtkTFCBlobSearch::GetTotalCost(const tfc::ScaleSpacePlan& plan) const
{
  const double polarities = (this->FindBright ? 1. : 0.) + (this->FindDark ? 1. : 0.);
  double total = DiffuseCost * static_cast<double>(this->Lattice.GetSize());
  for (const tfc::ScaleSpaceAction& action : plan.Actions)
  {
    const double samples = static_cast<double>(
      tfc::MakeCoarseLattice(this->Offset, this->Size, action.Stride).GetSize());
    total += samples *
      (action.Kind == tfc::ScaleSpaceAction::Diffuse    ? DiffuseCost
          : action.Kind == tfc::ScaleSpaceAction::Halve ? 3. * HalveCost
                                                        : RespondCost + FindCost * polarities);
  }
  return std::max(1., total);
}

//------------------------------------------------------------------------------
bool vtkTFCBlobSearch::Run(const tfc::ScaleSpacePlan& plan, vtkAlgorithm* owner)
{
  this->Owner = owner;
  const tfc::Index unit[3] = { 1, 1, 1 };
  this->Lattice = tfc::MakeCoarseLattice(this->Offset, this->Size, unit);
  this->TotalCost = this->GetTotalCost(plan);
  this->Blobs.assign(plan.Sigmas.size(), {});
  for (vtkTFCLargeBuffer::Pointer& buffer : this->Buffers)
  {
    buffer = vtkTFCLargeBuffer::Allocate(this->Lattice.GetSize());
    this->Release(buffer.get());
  }
  bool going = this->Scale();
  for (size_t i = 0; going && i < plan.Actions.size(); ++i)
  {
    const tfc::ScaleSpaceAction& action = plan.Actions[i];
    switch (action.Kind)
    {
      case tfc::ScaleSpaceAction::Diffuse:
        going = this->Diffuse(action);
        break;
      case tfc::ScaleSpaceAction::Halve:
        going = this->Halve(action);
        break;
      default:
        going = this->Respond(action, plan.Sigmas);
    }
  }
  for (vtkTFCLargeBuffer::Pointer& buffer : this->Buffers)
  {
    buffer.reset();
  }
  return going;
}

//------------------------------------------------------------------------------
bool vtkTFCBlobSearch::Scale()
{
  this->Current = this->Take();
  const float low = static_cast<float>(this->Range[0]), high = static_cast<float>(this->Range[1]);
  // A range that floats cannot resolve is none, as is one of a single value.
  const double range = this->Range[1] - this->Range[0];
  const float scale =
    range > std::numeric_limits<float>::min() ? static_cast<float>(1. / range) : 0.f;
  const float* in = this->Values;
  float* out = this->Current;
  const tfc::Index slice = this->Size[0] * this->Size[1];
  return this->ForSlices(this->Lattice, DiffuseCost,
    vtkTFCSimd::Vectorize(
      [=](vtkIdType begin, vtkIdType end)
      {
        for (tfc::Index i = begin * slice; i < end * slice; ++i)
        {
          const float v = in[i];
          // NaN passes both tests.
          out[i] = (v < low) | (v > high) ? 0.f : (v - low) * scale;
        }
      }));
}

//------------------------------------------------------------------------------
bool vtkTFCBlobSearch::Diffuse(const tfc::ScaleSpaceAction& action)
{
  if (action.BeginsCycle)
  {
    this->Release(this->Cycle != this->Current ? this->Cycle : nullptr);
    this->Cycle = this->Current;
  }
  const float* from = this->Current;
  const float* cycle = this->Cycle;
  float* to = this->Take();
  const tfc::CoarseLattice lattice = this->Lattice;
  const tfc::DiffusionCoefficients coefficients = action.Coefficients;
  const auto run = [&](auto nonlinear, auto masked)
  {
    return this->ForSlices(lattice, DiffuseCost,
      vtkTFCSimd::Vectorize(
        [=](vtkIdType begin, vtkIdType end)
        {
          tfc::DiffuseSlices<decltype(nonlinear)::value, decltype(masked)::value>(from, cycle,
            lattice.Size, coefficients, begin, end, to);
        }));
  };
  const bool going = action.Nonlinear ? this->HasInvalid ? run(std::true_type{}, std::true_type{})
                                                         : run(std::true_type{}, std::false_type{})
    : this->HasInvalid ? run(std::false_type{}, std::true_type{})
                                      : run(std::false_type{}, std::false_type{});
  if (this->Current != this->Cycle)
  {
    this->Release(this->Current);
  }
  this->Current = to;
  return going;
}

//------------------------------------------------------------------------------
bool vtkTFCBlobSearch::Halve(const tfc::ScaleSpaceAction& action)
{
  this->Release(this->Cycle != this->Current ? this->Cycle : nullptr);
  this->Cycle = nullptr;
  const tfc::CoarseLattice fine = this->Lattice;
  const tfc::CoarseLattice coarse = tfc::MakeCoarseLattice(this->Offset, this->Size, action.Stride);
  for (float** lattice : { &this->Current, &this->Older, &this->Old })
  {
    if (!*lattice)
    {
      continue;
    }
    const float* from = *lattice;
    float* to = this->Take();
    if (!this->ForSlices(coarse, HalveCost,
          [=](vtkIdType begin, vtkIdType end)
          {
            for (tfc::Index z = begin; z < end; ++z)
            {
              tfc::SubsampleSlice(from, fine, coarse, z, to);
            }
          }))
    {
      return false;
    }
    this->Release(*lattice);
    *lattice = to;
  }
  this->Lattice = coarse;
  this->IsHalved = true;
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCBlobSearch::Respond(const tfc::ScaleSpaceAction& action,
  const std::vector<double>& sigmas)
{
  this->Release(this->Cycle != this->Current ? this->Cycle : nullptr);
  this->Cycle = nullptr;
  const float* from = this->Current;
  float* response = this->Take();
  const tfc::CoarseLattice lattice = this->Lattice;
  const float weights[3] = { action.Weights[0], action.Weights[1], action.Weights[2] };
  const auto run = [&](auto masked)
  {
    return this->ForSlices(lattice, RespondCost,
      vtkTFCSimd::Vectorize(
        [=](vtkIdType begin, vtkIdType end)
        {
          for (tfc::Index z = begin; z < end; ++z)
          {
            tfc::LaplacianSlice<decltype(masked)::value>(from, lattice.Size, weights, z, response);
          }
        }));
  };
  if (!(this->HasInvalid ? run(std::true_type{}) : run(std::false_type{})))
  {
    return false;
  }
  this->NumberOfResponses += 1;
  if (this->Older && !this->Find(response, sigmas))
  {
    return false;
  }
  this->Release(this->Older);
  this->Older = this->Old;
  this->Old = response;
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCBlobSearch::Find(const float* response, const std::vector<double>& sigmas)
{
  tfc::BlobDetector detector;
  detector.Responses[0] = this->Older;
  detector.Responses[1] = this->Old;
  detector.Responses[2] = response;
  detector.Lattice = this->Lattice;
  detector.Scale = this->NumberOfResponses - 2;
  detector.IsHalved = this->IsHalved;
  this->IsHalved = false;
  detector.Threshold = static_cast<float>(this->Threshold);
  for (int i = 0; i < 3; ++i)
  {
    detector.LogSigmas[i] = std::log(sigmas[detector.Scale - 1 + i]);
  }
  for (int a = 0; a < 3; ++a)
  {
    detector.Width[a] = tfc::ScaleSpacePlan::GetHalfSigma(sigmas[detector.Scale],
      this->Spacing[a] * static_cast<double>(this->Lattice.Stride[a]));
  }
  // A list per slice: their order does not depend on the threads.
  std::vector<std::vector<tfc::Blob>> slices(this->Lattice.Size[2]);
  for (const float sign : { -1.f, 1.f })
  {
    if (!(sign < 0.f ? this->FindBright : this->FindDark))
    {
      continue;
    }
    detector.Sign = sign;
    if (!this->ForSlices(this->Lattice, FindCost,
          vtkTFCSimd::Vectorize(
            [&slices, detector](vtkIdType begin, vtkIdType end)
            {
              for (tfc::Index z = begin; z < end; ++z)
              {
                detector.FindInSlice(z, slices[z]);
              }
            })))
    {
      return false;
    }
  }
  for (const std::vector<tfc::Blob>& found : slices)
  {
    std::vector<tfc::Blob>& all = this->Blobs[detector.Scale];
    all.insert(all.end(), found.begin(), found.end());
  }
  if (detector.IsHalved)
  {
    tfc::RemoveDuplicates(this->Blobs[detector.Scale - 1], this->Blobs[detector.Scale],
      this->Lattice.Stride);
  }
  return true;
}
