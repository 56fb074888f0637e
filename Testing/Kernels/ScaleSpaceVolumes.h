// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scale space computed action by action, as plainly as can be.
 */

#ifndef ScaleSpaceVolumes_h
#define ScaleSpaceVolumes_h

#include "Filters/Kernels/TFCBlobs.h"
#include "Filters/Kernels/TFCPyramid.h"
#include "Filters/Kernels/TFCScaleSpace.h"

#include <cmath>
#include <limits>
#include <vector>

namespace testing_volumes
{
/**
 * The responses of a scale: per sample of the lattice.
 */
struct Responses
{
  tfc::CoarseLattice Lattice;
  double Sigma = 0.;
  std::vector<float> Values;

  /// At a sample of the whole volume, which must be on the lattice.
  float At(const tfc::Index voxel[3]) const
  {
    tfc::Index i[3];
    for (int a = 0; a < 3; ++a)
    {
      i[a] = voxel[a] / this->Lattice.Stride[a] - this->Lattice.First[a];
    }
    return this->Values[(i[2] * this->Lattice.Size[1] + i[1]) * this->Lattice.Size[0] + i[0]];
  }
};

/**
 * All responses of a plan on a volume.
 */
inline std::vector<Responses> ComputeResponses(const tfc::ScaleSpacePlan& plan,
  const tfc::Index size[3], std::vector<float> current)
{
  std::vector<Responses> results;
  const tfc::Index zero[3] = { 0, 0, 0 }, unit[3] = { 1, 1, 1 };
  tfc::CoarseLattice lattice = tfc::MakeCoarseLattice(zero, size, unit);
  std::vector<float> cycle;
  for (const tfc::ScaleSpaceAction& action : plan.Actions)
  {
    const tfc::CoarseLattice next = tfc::MakeCoarseLattice(zero, size, action.Stride);
    std::vector<float> result(next.GetSize());
    const tfc::Index slices = next.Size[2];
    if (action.Kind == tfc::ScaleSpaceAction::Diffuse)
    {
      cycle = action.BeginsCycle ? current : cycle;
      if (action.Nonlinear)
      {
        tfc::DiffuseSlices<true, true>(current.data(), cycle.data(), next.Size, action.Coefficients,
          0, slices, result.data());
      }
      else
      {
        tfc::DiffuseSlices<false, true>(current.data(), cycle.data(), next.Size,
          action.Coefficients, 0, slices, result.data());
      }
      current = result;
    }
    for (tfc::Index z = 0; z < slices; ++z)
    {
      if (action.Kind == tfc::ScaleSpaceAction::Halve)
      {
        tfc::SubsampleSlice(current.data(), lattice, next, z, result.data());
      }
      else if (action.Kind == tfc::ScaleSpaceAction::Respond)
      {
        tfc::LaplacianSlice<true>(current.data(), next.Size, action.Weights, z, result.data());
      }
    }
    if (action.Kind == tfc::ScaleSpaceAction::Halve)
    {
      current = result;
    }
    else if (action.Kind == tfc::ScaleSpaceAction::Respond)
    {
      results.push_back({ next, plan.Sigmas[results.size()], result });
    }
    lattice = next;
  }
  return results;
}

/**
 * Where in log sigma the response at a sample is most negative, by a parabola; `height` receives
 * its magnitude there. 0 when the extremum is at an end.
 */
inline double FindPeakSigma(const std::vector<Responses>& responses, const tfc::Index voxel[3],
  double* height = nullptr)
{
  size_t best = 0;
  for (size_t i = 1; i < responses.size(); ++i)
  {
    best = responses[i].At(voxel) < responses[best].At(voxel) ? i : best;
  }
  if (best == 0 || best + 1 == responses.size())
  {
    return 0.;
  }
  double x[3], y[3];
  for (size_t i = 0; i < 3; ++i)
  {
    x[i] = std::log(responses[best - 1 + i].Sigma);
    y[i] = -responses[best - 1 + i].At(voxel);
  }
  const double position = tfc::FitParabola(x, y);
  if (height)
  {
    *height = tfc::EvaluateParabola(x, y, position);
  }
  return std::exp(position);
}
}

#endif
