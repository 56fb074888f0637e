// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCOcclusion.h"

#include "Kernels/TFCOcclusion.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCLargeBuffer.h"
#include "vtkTFCNeighborhoodMean.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkTFCOcclusion);

namespace
{
//------------------------------------------------------------------------------
/**
 * Number, sum and sum of squares of the values minus `middle` that are not NaN, of the samples of
 * this process that no other owns. Blocks of fixed size: the sum does not depend on the threads.
 */
void AddMoments(const float* values, vtkIdType count, double middle,
  const std::vector<unsigned char>& owned, double moments[3])
{
  constexpr vtkIdType blockSize = 65536;
  const vtkIdType blocks = (count + blockSize - 1) / blockSize;
  std::vector<double> parts(static_cast<size_t>(3 * blocks));
  vtkTFCThreads::For(0, blocks, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        double n = 0., sum = 0., squares = 0.;
        for (vtkIdType i = block * blockSize; i < std::min(count, (block + 1) * blockSize); ++i)
        {
          const bool counts = tfc::IsValid(values[i]) && (owned.empty() || owned[i]);
          const double v = counts ? values[i] - middle : 0.;
          n += counts ? 1. : 0.;
          sum += v;
          squares += v * v;
        }
        parts[3 * block] = n;
        parts[3 * block + 1] = sum;
        parts[3 * block + 2] = squares;
      }
    });
  for (size_t i = 0; i < parts.size(); ++i)
  {
    moments[i % 3] += parts[i];
  }
}

//------------------------------------------------------------------------------
double GetLongestSide(const double spacing[3], const std::ptrdiff_t size[3])
{
  double longest = 0.;
  for (int a = 0; a < 3; ++a)
  {
    longest = std::max(longest, spacing[a] * static_cast<double>(size[a]));
  }
  return longest;
}

//------------------------------------------------------------------------------
/**
 * Smallest spacing of the axes with more than one sample.
 */
double GetSmallestSpacing(const double spacing[3], const std::ptrdiff_t size[3])
{
  double smallest = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a)
  {
    smallest = size[a] > 1 ? std::min(smallest, spacing[a]) : smallest;
  }
  return std::isfinite(smallest) ? smallest : spacing[0];
}
}

//------------------------------------------------------------------------------
std::string vtkTFCOcclusion::CheckParameters() const
{
  std::ostringstream problem;
  const double* range = this->AutoRadiusRange;
  if (!this->AutoRadius && !(this->Radius > 0. && std::isfinite(this->Radius)))
  {
    problem << "Radius is " << this->Radius << ". Set it to a length of at least one voxel.";
  }
  else if (this->AutoRadius && !(range[0] > 0. && range[0] <= range[1] && std::isfinite(range[1])))
  {
    problem << "AutoRadiusRange is " << range[0] << " to " << range[1]
            << ". Set it to two positive lengths, the smaller one first.";
  }
  else if (this->Metric == BOUNDARY_PRESERVING && this->BoundaryTerm &&
    (!(this->BoundaryParameter > 0.) || !std::isfinite(this->BoundaryParameter)))
  {
    problem << "BoundaryParameter is " << this->BoundaryParameter
            << ". Set it to a positive number, typically 0.001 to 0.01, for noisy data up to 1.";
  }
  else if (this->Metric == SPECTRUM && this->Mapping == TRUNCATED_RAMP &&
    !(this->MappingRange[0] < this->MappingRange[1]))
  {
    problem << "MappingRange is " << this->MappingRange[0] << " to " << this->MappingRange[1]
            << ", which is empty. Set the smaller intensity first.";
  }
  else if (this->Metric == SPECTRUM && this->DistanceWeight != CONSTANT &&
    this->Neighborhood != SPHERE)
  {
    problem << "A box has no distance weights. Set Neighborhood to Sphere, or DistanceWeight to "
               "Constant.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
std::string vtkTFCOcclusion::CheckField(const Field& field) const
{
  if (this->AutoRadius)
  {
    return {};
  }
  const char* unit = this->LengthUnit == WORLD ? " world units" : " voxels";
  const double smallest = GetSmallestSpacing(field.UnitSpacing, field.WholeSize);
  const double longest = GetLongestSide(field.UnitSpacing, field.WholeSize);
  std::ostringstream problem;
  if (this->Radius < smallest * (1. - 1e-9))
  {
    problem << "Radius is " << this->Radius << unit << ", less than one voxel. Set it to "
            << smallest << " or more.";
  }
  else if (this->Radius > std::max(longest, smallest))
  {
    problem << "Radius is " << this->Radius << unit << ", longer than the volume, whose longest "
            << "side has " << longest << ". Set a smaller Radius, e.g. " << longest / 6. << ".";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
void vtkTFCOcclusion::GetRadii(const Field& field, double radii[2]) const
{
  radii[0] = radii[1] = this->Radius;
  if (this->AutoRadius)
  {
    const double smallest = GetSmallestSpacing(field.UnitSpacing, field.WholeSize);
    const double longest = GetLongestSide(field.UnitSpacing, field.WholeSize);
    radii[0] = std::max(this->AutoRadiusRange[0], smallest);
    radii[1] = std::max(radii[0], std::min(this->AutoRadiusRange[1], longest / 2.));
  }
}

//------------------------------------------------------------------------------
int vtkTFCOcclusion::GetHaloWidth(const Field& field) const
{
  double radii[2];
  this->GetRadii(field, radii);
  // The gradient needs one sample even along an axis whose spacing exceeds the radius.
  double samples = 1.;
  for (int a = 0; a < 3; ++a)
  {
    const double most = static_cast<double>(field.WholeSize[a]);
    samples = std::max(samples, std::min(most, radii[1] / field.UnitSpacing[a] * (1. + 1e-9)));
  }
  return static_cast<int>(samples);
}

//------------------------------------------------------------------------------
double vtkTFCOcclusion::GetTemporaryBytes(const Field& field) const
{
  double radii[2];
  this->GetRadii(field, radii);
  // With invalid samples, of which nothing is known yet, it may be more.
  const vtkTFCNeighborhoodMean means(nullptr, field.Size, field.Begin, field.End, field.UnitSpacing,
    false);
  double bytes = this->Neighborhood == SPHERE ? means.GetBallBytes(radii[1]) : means.GetBoxBytes();
  bytes += this->Metric == SPECTRUM && this->Mapping == TRUNCATED_RAMP
    ? 4. * static_cast<double>(field.GetSize())
    : 0.;
  return bytes + (this->AutoRadius ? 4. * static_cast<double>(field.GetOwnSize()) : 0.);
}

//------------------------------------------------------------------------------
bool vtkTFCOcclusion::Prepare(const Field& field, const vtkTFCDistributedImage& image)
{
  double radii[2];
  this->GetRadii(field, radii);
  this->UsedRadius = radii[1];
  if (!this->AutoRadius || radii[0] == radii[1])
  {
    return true;
  }
  const vtkIdType count = field.GetOwnSize();
  const auto result = vtkTFCLargeBuffer::Allocate(count);
  const std::vector<unsigned char> owned = image.GetOwnedSamples();
  const double middle = 0.5 * (field.Range[0] + field.Range[1]);
  constexpr int candidates = 10, refinements = 4;
  int tried = 0;
  double best = -1.;
  // False when aborted. All processes see the same variances and make the same choices.
  const auto attempt = [&](double radius)
  {
    // In voxels only whole radii differ, but for the ball.
    radius = this->LengthUnit == VOXELS ? std::round(radius) : radius;
    const double from = 0.15 + 0.75 * tried / (candidates + refinements);
    const double to = 0.15 + 0.75 * (tried + 1) / (candidates + refinements);
    ++tried;
    const bool done = count == 0 || this->Compute(field, radius, from, to, result.get());
    if (!image.All(done))
    {
      return false;
    }
    double moments[3] = { 0., 0., 0. };
    AddMoments(result.get(), count, middle, owned, moments);
    image.Sum(moments, 3);
    const double mean = moments[0] > 0. ? moments[1] / moments[0] : 0.;
    const double variance = moments[0] > 0. ? moments[2] / moments[0] - mean * mean : 0.;
    if (variance > best)
    {
      best = variance;
      this->UsedRadius = radius;
    }
    return true;
  };
  const double step = std::pow(radii[1] / radii[0], 1. / (candidates - 1));
  for (int i = 0; i < candidates; ++i)
  {
    if (!attempt(radii[0] * std::pow(step, i)))
    {
      return false;
    }
  }
  double factor = std::sqrt(step);
  for (int i = 0; i < refinements; i += 2, factor = std::sqrt(factor))
  {
    const double center = this->UsedRadius;
    if (!attempt(std::max(radii[0], center / factor)) ||
      !attempt(std::min(radii[1], center * factor)))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCOcclusion::Compute(const Field& field, double radius, double from, double to, float* out)
{
  const float* values = field.Values;
  vtkTFCLargeBuffer::Pointer mapped;
  const bool isSpectrum = this->Metric == SPECTRUM;
  if (isSpectrum && this->Mapping == TRUNCATED_RAMP)
  {
    const vtkIdType count = field.GetSize();
    mapped = vtkTFCLargeBuffer::Allocate(count);
    const float low = static_cast<float>(this->MappingRange[0]);
    const float high = static_cast<float>(this->MappingRange[1]);
    vtkTFCThreads::For(0, count, 65536,
      vtkTFCSimd::Vectorize(
        [&, to = mapped.get()](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType i = begin; i < end; ++i)
          {
            const float v = values[i];
            // NaN stays NaN: it is not beyond either end.
            to[i] = (v <= low) | (v >= high) ? 0.f : v;
          }
        }));
    values = mapped.get();
  }
  vtkTFCNeighborhoodMean means(values, field.Size, field.Begin, field.End, field.UnitSpacing,
    field.HasInvalid);
  means.SetProgress(this, from, to);
  // Zero outside of a truncated ramp's interval is as likely as any value.
  means.SetMiddle(mapped ? 0.f : static_cast<float>(0.5 * (field.Range[0] + field.Range[1])));
  if (!isSpectrum && this->BoundaryTerm)
  {
    means.SetBoundaryWeight(
      tfc::ConductanceWeight(field.Range[1] - field.Range[0], this->BoundaryParameter));
  }
  if (this->Neighborhood == BOX)
  {
    return means.ComputeBox(radius, out);
  }
  const int weight = isSpectrum ? this->DistanceWeight : static_cast<int>(CONSTANT);
  return means.ComputeBall(radius,
    weight == LINEAR       ? tfc::DistanceWeight::Linear
      : weight == GAUSSIAN ? tfc::DistanceWeight::Gaussian
                           : tfc::DistanceWeight::Constant,
    out);
}

//------------------------------------------------------------------------------
bool vtkTFCOcclusion::ComputeProperties(const Field& field, const std::vector<float*>& outputs)
{
  return this->Compute(field, this->UsedRadius, this->AutoRadius ? 0.9 : 0.15, 1., outputs[0]);
}

//------------------------------------------------------------------------------
void vtkTFCOcclusion::AddFieldData(const Field& field, vtkFieldData* data)
{
  vtkNew<vtkDoubleArray> radius;
  radius->SetName((field.Name + "_occlusion_radius").c_str());
  radius->InsertNextValue(this->UsedRadius);
  data->AddArray(radius);
}

//------------------------------------------------------------------------------
void vtkTFCOcclusion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metric: " << this->Metric << "\n";
  os << indent << "Neighborhood: " << (this->Neighborhood == BOX ? "BOX" : "SPHERE") << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "AutoRadius: " << this->AutoRadius << "\n";
  os << indent << "AutoRadiusRange: " << this->AutoRadiusRange[0] << " " << this->AutoRadiusRange[1]
     << "\n";
  os << indent << "UsedRadius: " << this->UsedRadius << "\n";
  os << indent << "BoundaryTerm: " << this->BoundaryTerm << "\n";
  os << indent << "BoundaryParameter: " << this->BoundaryParameter << "\n";
  os << indent << "Mapping: " << this->Mapping << "\n";
  os << indent << "MappingRange: " << this->MappingRange[0] << " " << this->MappingRange[1] << "\n";
  os << indent << "DistanceWeight: " << this->DistanceWeight << "\n";
}
