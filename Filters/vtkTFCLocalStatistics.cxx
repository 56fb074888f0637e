// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCLocalStatistics.h"

#include "Kernels/TFCGrowingSpheres.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkTFCLocalStatistics);

namespace
{
//------------------------------------------------------------------------------
/**
 * Factor of the values before they are raised to powers, which float must hold. 1 for the usual
 * ranges; else the power of two that leaves most room on both sides: deviations down to 1e-17 of
 * the range still count.
 */
float GetScale(const double range[2])
{
  const double width = range[1] - range[0];
  if (!(width > 0.) || (width >= 0.5 && width < std::ldexp(1., 25)))
  {
    return 1.f;
  }
  const int exponent = 22 - std::ilogb(width);
  // The inverse must be a number, too; and large offsets must not overflow.
  const double largest = std::max(std::fabs(range[0]), std::fabs(range[1]));
  const int room = 120 - std::ilogb(largest);
  return static_cast<float>(std::ldexp(1., std::max(-120, std::min({ exponent, room, 120 }))));
}
}

//------------------------------------------------------------------------------
std::string vtkTFCLocalStatistics::CheckParameters() const
{
  std::ostringstream problem;
  const bool voxels = this->LengthUnit == VOXELS;
  if (!std::isfinite(this->MaximumRadius) || this->MaximumRadius < (voxels ? 1. : 0.))
  {
    problem << "MaximumRadius is " << this->MaximumRadius << ". Set it to a number of "
            << (voxels ? "voxels from 1 on" : "world units from the spacing of the volume on")
            << ", typically 6 to 10" << (voxels ? "." : " times the spacing.");
  }
  else if (!(this->ConfidenceLevel > 0. && this->ConfidenceLevel < 1.))
  {
    problem << "ConfidenceLevel is " << this->ConfidenceLevel
            << ". Set it to a number above 0 and below 1, typically 0.001 to 0.1.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
std::string vtkTFCLocalStatistics::CheckField(const Field& field) const
{
  std::ostringstream problem;
  const char* unit = this->LengthUnit == VOXELS ? " voxels" : " world units";
  const tfc::SphereShells shells(field.WholeSize, field.UnitSpacing, this->MaximumRadius);
  double side = 0.;
  for (int a = 0; a < 3; ++a)
  {
    side = std::max(side, static_cast<double>(field.WholeSize[a]) * field.UnitSpacing[a]);
  }
  if (shells.NumberOfShells < 1)
  {
    problem << "MaximumRadius is " << this->MaximumRadius << unit
            << ", but the smallest spacing of the volume is " << shells.Step
            << ". Set it to at least that, typically to 6 to 10 times that.";
  }
  else if (this->MaximumRadius > side)
  {
    problem << "MaximumRadius is " << this->MaximumRadius << unit << ", but the largest side of '"
            << field.Name << "' is " << side << ". Set it to at most that, typically to "
            << std::max(shells.Step, std::min(6. * shells.Step, side / 4.)) << ".";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
int vtkTFCLocalStatistics::GetHaloWidth(const Field& field) const
{
  const tfc::SphereShells shells(field.WholeSize, field.UnitSpacing, this->MaximumRadius);
  return static_cast<int>(*std::max_element(shells.Reach, shells.Reach + 3));
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkTFCLocalStatistics::GetSuffixes() const
{
  // In the order of tfc::SphereStatistic.
  std::vector<std::string> suffixes{ "_mean", "_stddev", "_radius" };
  if (this->Moments)
  {
    suffixes.insert(suffixes.end(), { "_skewness", "_kurtosis" });
  }
  return suffixes;
}

//------------------------------------------------------------------------------
double vtkTFCLocalStatistics::GetTemporaryBytes(const Field& field) const
{
  const tfc::SphereShells shells(field.WholeSize, field.UnitSpacing, this->MaximumRadius);
  return 60. * shells.EstimateSize() +
    tfc::GrowingSpheres::EstimateBytes(shells, field.Begin, field.End) *
    vtkTFCThreads::GetNumberOfThreads();
}

//------------------------------------------------------------------------------
bool vtkTFCLocalStatistics::ComputeProperties(const Field& field,
  const std::vector<float*>& outputs)
{
  const auto shells =
    tfc::SphereShells::Make(field.WholeSize, field.UnitSpacing, this->MaximumRadius);
  const tfc::SphereTests tests(this->ConfidenceLevel, shells.Ends.back());
  const tfc::GrowingSpheres spheres(shells, tests, field.Size, field.Begin, field.End,
    GetScale(field.Range));
  float* statistics[tfc::NumberOfSphereStatistics] = {};
  std::copy(outputs.begin(), outputs.end(), statistics);
  const auto body = vtkTFCSimd::Vectorize(
    [&](vtkIdType begin, vtkIdType end)
    {
      tfc::GrowingSpheres::Workspace work;
      for (vtkIdType tile = begin; tile < end; ++tile)
      {
        spheres.ComputeTile(field.Values, tile, statistics, work);
      }
    });
  // A loop with progress starts with a 64th of its range. Large spheres in a large volume would
  // make that too long to wait for after an abort: several loops.
  const vtkIdType tiles = spheres.GetNumberOfTiles();
  const double seconds = tfc::GrowingSpheres::EstimateSeconds(shells, field.Begin, field.End);
  const vtkIdType loops =
    std::min(tiles, static_cast<vtkIdType>(1. + static_cast<double>(tiles) / 64. * seconds / 0.1));
  // Two tiles at once while they are short, as the workspace is allocated once per call.
  const vtkIdType grain = seconds < 0.05 ? 2 : 1;
  const auto progress = [&](vtkIdType loop)
  { return 0.15 + 0.85 * static_cast<double>(loop) / static_cast<double>(loops); };
  for (vtkIdType loop = 0; loop < loops; ++loop)
  {
    if (!vtkTFCThreads::ForWithProgress(tiles * loop / loops, tiles * (loop + 1) / loops, grain,
          this, progress(loop), progress(loop + 1), body))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCLocalStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumRadius: " << this->MaximumRadius << "\n";
  os << indent << "ConfidenceLevel: " << this->ConfidenceLevel << "\n";
  os << indent << "Moments: " << (this->Moments ? "on" : "off") << "\n";
}
