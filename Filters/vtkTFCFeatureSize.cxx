// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCFeatureSize.h"

#include "Kernels/TFCBlobs.h"
#include "Kernels/TFCScaleSpace.h"
#include "Kernels/TFCShepard.h"
#include "vtkTFCBlobSearch.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkTFCFeatureSize);

namespace
{
constexpr double SmallestSpacings = 1.5;

//------------------------------------------------------------------------------
/**
 * Position in samples of the whole volume, and what the output tells of a blob.
 */
struct FoundBlob
{
  tfc::Blob Blob;
  double Size;
  double WorldRadius;
  std::string Array;
  int Association;
};
}

//------------------------------------------------------------------------------
struct vtkTFCFeatureSize::Internals
{
  std::vector<FoundBlob> Found;     // of the arrays that are complete
  std::vector<unsigned char> Owned; // of the local samples; empty: all
  int WholeBegin[3] = { 0, 0, 0 };

  static tfc::ScaleSpacePlan MakePlan(const vtkTFCFeatureSize* self, const Field& field)
  {
    tfc::ScaleSpaceParameters parameters;
    for (int a = 0; a < 3; ++a)
    {
      parameters.WholeSize[a] = field.WholeSize[a];
      parameters.Spacing[a] = field.UnitSpacing[a];
    }
    parameters.SmallestRadius = self->SmallestSize;
    parameters.LargestRadius = self->LargestSize;
    parameters.NumberOfScales = self->NumberOfScales;
    parameters.Conductance = self->ScaleSpace == NONLINEAR ? self->Conductance : 0.;
    return tfc::ScaleSpacePlanner(parameters).Plan;
  }

  /// Keep what this process owns of the blobs for the second output.
  void Keep(const Field& field, const std::vector<std::vector<tfc::Blob>>& scales)
  {
    std::ptrdiff_t size[3];
    double world = 1., unit = 1.;
    int dimension = 0;
    for (int a = 0; a < 3; ++a)
    {
      size[a] = field.End[a] - field.Begin[a];
      dimension += field.WholeSize[a] > 1 ? 1 : 0;
      world *= field.WholeSize[a] > 1 ? field.Spacing[a] : 1.;
      unit *= field.WholeSize[a] > 1 ? field.UnitSpacing[a] : 1.;
    }
    const double factor = std::pow(world / unit, 1. / std::max(1, dimension));
    for (const std::vector<tfc::Blob>& scale : scales)
    {
      for (const tfc::Blob& blob : scale)
      {
        std::ptrdiff_t at[3];
        bool inside = true;
        for (int a = 0; a < 3; ++a)
        {
          at[a] = blob.Voxel[a] - field.Offset[a] - field.Begin[a];
          inside = inside && at[a] >= 0 && at[a] < size[a];
        }
        if (inside &&
          (this->Owned.empty() || this->Owned[(at[2] * size[1] + at[1]) * size[0] + at[0]]))
        {
          const double radius = std::sqrt(1. * dimension) * blob.Sigma;
          this->Found.push_back({ blob, radius, radius * factor, field.Name, field.Association });
        }
      }
    }
  }

  /// The second output, with its arrays even where there is no blob.
  void Fill(vtkImageData* input, vtkPolyData* output) const
  {
    const vtkIdType count = static_cast<vtkIdType>(this->Found.size());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkNew<vtkCellArray> vertices;
    const char* names[] = { "size", "radius_world", "scale", "response" };
    vtkNew<vtkFloatArray> columns[4];
    for (int c = 0; c < 4; ++c)
    {
      columns[c]->SetName(names[c]);
      columns[c]->SetNumberOfTuples(count);
      output->GetPointData()->AddArray(columns[c]);
    }
    vtkNew<vtkStringArray> arrays;
    arrays->SetName("array");
    arrays->SetNumberOfValues(count);
    output->GetPointData()->AddArray(arrays);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const FoundBlob& found = this->Found[i];
      double index[3], place[3];
      for (int a = 0; a < 3; ++a)
      {
        // The sample of a cell lies in its middle; the cells of a slice lie in the slice.
        const bool middle = found.Association == vtkDataObject::FIELD_ASSOCIATION_CELLS &&
          input->GetDimensions()[a] > 1;
        index[a] = this->WholeBegin[a] + found.Blob.Position[a] + (middle ? 0.5 : 0.);
      }
      input->TransformContinuousIndexToPhysicalPoint(index[0], index[1], index[2], place);
      points->SetPoint(i, place);
      vertices->InsertNextCell(1, &i);
      const double values[] = { found.Size, found.WorldRadius, found.Blob.Sigma,
        found.Blob.Response };
      for (int c = 0; c < 4; ++c)
      {
        columns[c]->SetValue(i, static_cast<float>(values[c]));
      }
      arrays->SetValue(i, found.Array);
    }
    output->SetPoints(points);
    output->SetVerts(vertices);
  }
};

//------------------------------------------------------------------------------
vtkTFCFeatureSize::vtkTFCFeatureSize()
  : Internal(new Internals)
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkTFCFeatureSize::~vtkTFCFeatureSize() = default;

//------------------------------------------------------------------------------
std::string vtkTFCFeatureSize::CheckParameters() const
{
  std::ostringstream problem;
  const auto isPositive = [](double value) { return value > 0. && std::isfinite(value); };
  const double* range = this->IntensityRange;
  if (this->UseIntensityRange &&
    !(std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1]))
  {
    problem << "IntensityRange is (" << range[0] << ", " << range[1]
            << "). Set it to two intensities, the smaller one first.";
  }
  else if (!isPositive(this->SmallestSize))
  {
    problem << "SmallestSize is " << this->SmallestSize
            << ". Set it to the radius of the smallest objects, a positive number.";
  }
  else if (!(this->LargestSize > this->SmallestSize) || !std::isfinite(this->LargestSize))
  {
    problem << "LargestSize is " << this->LargestSize << " and SmallestSize is "
            << this->SmallestSize << ". Set LargestSize to a larger number than SmallestSize.";
  }
  else if (this->NumberOfScales < 2 || this->NumberOfScales > 100)
  {
    problem << "NumberOfScales is " << this->NumberOfScales
            << ". Set it to a number from 2 to 100, typically 12.";
  }
  else if (this->ScaleSpace == NONLINEAR && !isPositive(this->Conductance))
  {
    problem << "Conductance is " << this->Conductance
            << ". Set it to a positive number, typically 0.1 to 1.";
  }
  else if (!isPositive(this->Threshold))
  {
    problem << "Threshold is " << this->Threshold
            << ". Set it to a positive number, typically 0.05 to 0.5.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
std::string vtkTFCFeatureSize::CheckField(const Field& field) const
{
  double shortest = std::numeric_limits<double>::infinity(), longest = 0.;
  for (int a = 0; a < 3; ++a)
  {
    if (field.WholeSize[a] > 1)
    {
      shortest = std::min(shortest, field.UnitSpacing[a]);
      longest = std::max(longest, static_cast<double>(field.WholeSize[a]) * field.UnitSpacing[a]);
    }
  }
  const char* unit = this->LengthUnit == WORLD ? " world units" : " voxels";
  std::ostringstream problem;
  // The tolerance is for limits that were computed, or read from this message.
  if (longest == 0.)
  {
    problem << "The volume has one sample. Choose one with objects in it.";
  }
  else if (this->LargestSize > 0.5 * longest * (1. + 1e-5))
  {
    problem << "LargestSize is " << this->LargestSize << unit
            << ", but half the volume's longest side is " << 0.5 * longest
            << ". Set LargestSize to at most that.";
  }
  else if (this->SmallestSize < SmallestSpacings * shortest * (1. - 1e-5))
  {
    problem
      << "SmallestSize is " << this->SmallestSize << unit << ", but objects smaller than "
      << SmallestSpacings * shortest
      << " (1.5 times the smallest spacing) cannot be told from noise. Set SmallestSize to at "
         "least that.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
int vtkTFCFeatureSize::GetHaloWidth(const Field& field) const
{
  const tfc::ScaleSpacePlan plan = Internals::MakePlan(this, field);
  // A blob's sigma lies below the middle between the last scale but one and the last.
  const size_t last = plan.Sigmas.size();
  const double sigma = last < 2 ? 0. : 0.5 * (plan.Sigmas[last - 2] + plan.Sigmas[last - 1]);
  double shortest = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a)
  {
    shortest = field.WholeSize[a] > 1 ? std::min(shortest, field.UnitSpacing[a]) : shortest;
  }
  // A blob's radius, and the distance at which its width is tested.
  const double reach = (std::sqrt(1. * plan.Dimension) + 0.5) * sigma / shortest;
  const double halo = std::ceil(reach) + static_cast<double>(plan.GetReach(shortest));
  // More than the volume changes nothing.
  const auto* whole = field.WholeSize;
  return static_cast<int>(
    std::min(halo, static_cast<double>(std::max({ whole[0], whole[1], whole[2] }))));
}

//------------------------------------------------------------------------------
double vtkTFCFeatureSize::GetTemporaryBytes(const Field& field) const
{
  return 4. * vtkTFCBlobSearch::NumberOfBuffers * static_cast<double>(field.GetSize());
}

//------------------------------------------------------------------------------
bool vtkTFCFeatureSize::Prepare(const Field&, const vtkTFCDistributedImage& image)
{
  this->Internal->Owned = image.GetOwnedSamples();
  for (int a = 0; a < 3; ++a)
  {
    this->Internal->WholeBegin[a] = image.GetWholeExtent()[2 * a];
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCFeatureSize::ComputeProperties(const Field& field, const std::vector<float*>& outputs)
{
  const tfc::ScaleSpacePlan plan = Internals::MakePlan(this, field);
  vtkTFCBlobSearch search;
  search.Values = field.Values;
  search.HasInvalid = field.HasInvalid;
  std::copy(field.Size, field.Size + 3, search.Size);
  std::copy(field.Offset, field.Offset + 3, search.Offset);
  std::copy(field.UnitSpacing, field.UnitSpacing + 3, search.Spacing);
  const double* range = this->UseIntensityRange ? this->IntensityRange : field.Range;
  std::copy(range, range + 2, search.Range);
  search.FindBright = this->Polarity != DARK;
  search.FindDark = this->Polarity != BRIGHT;
  search.Threshold = this->Threshold;
  search.ProgressBegin = 0.15;
  search.ProgressEnd = 0.9;
  if (!search.Run(plan, this))
  {
    return false;
  }

  std::vector<std::vector<tfc::SizedBlob>> scales;
  for (const std::vector<tfc::Blob>& blobs : search.Blobs)
  {
    std::vector<tfc::SizedBlob> sized;
    sized.reserve(blobs.size());
    for (const tfc::Blob& blob : blobs)
    {
      sized.push_back({ { blob.Position[0], blob.Position[1], blob.Position[2] },
        std::sqrt(1. * plan.Dimension) * blob.Sigma });
    }
    scales.push_back(sized);
  }
  tfc::SizeBox box;
  for (int a = 0; a < 3; ++a)
  {
    box.Begin[a] = field.Offset[a] + field.Begin[a];
    box.End[a] = field.Offset[a] + field.End[a];
    box.Spacing[a] = field.UnitSpacing[a];
  }
  const tfc::Index width = box.GetWidth(), height = box.GetHeight();
  const bool done = vtkTFCThreads::ForWithProgress(0, box.End[2] - box.Begin[2], 4, this, 0.9, 1.,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        tfc::SizeWorkspace work;
        for (tfc::Index z = begin; z < end; ++z)
        {
          float* slice = outputs[0] + z * width * height;
          std::fill(slice, slice + width * height, 0.f);
          for (const std::vector<tfc::SizedBlob>& blobs : scales)
          {
            tfc::RaiseSlice(blobs, box, box.Begin[2] + z, work, slice);
          }
          for (tfc::Index y = 0; field.HasInvalid && y < height; ++y)
          {
            const float* values = field.Values + field.Begin[0] +
              ((field.Begin[2] + z) * field.Size[1] + field.Begin[1] + y) * field.Size[0];
            for (tfc::Index x = 0; x < width; ++x)
            {
              // v - v is 0, or NaN for an invalid sample.
              slice[y * width + x] += values[x] - values[x];
            }
          }
        }
      }));
  if (done)
  {
    this->Internal->Keep(field, search.Blobs);
  }
  return done;
}

//------------------------------------------------------------------------------
int vtkTFCFeatureSize::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCFeatureSize::RequestDataObject(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
  // The superclass would make both outputs of the input's type.
  if (vtkDataObject* volume = vtkDataObject::GetData(outputVector, 0);
      !volume || !volume->IsA(input->GetClassName()))
  {
    vtkSmartPointer<vtkDataObject> made;
    made.TakeReference(input->NewInstance());
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  if (!vtkPolyData::GetData(outputVector, 1))
  {
    vtkNew<vtkPolyData> made;
    outputVector->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCFeatureSize::RequestData(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  this->Internal->Found.clear();
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  this->Internal->Fill(vtkImageData::GetData(inputVector[0]),
    vtkPolyData::GetData(outputVector, 1));
  this->Internal->Found.clear();
  this->Internal->Owned.clear();
  return result;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkTFCFeatureSize::GetBlobs()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
void vtkTFCFeatureSize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseIntensityRange: " << (this->UseIntensityRange ? "on" : "off") << "\n";
  os << indent << "IntensityRange: " << this->IntensityRange[0] << " " << this->IntensityRange[1]
     << "\n";
  os << indent << "ScaleSpace: " << (this->ScaleSpace == NONLINEAR ? "NONLINEAR" : "GAUSSIAN")
     << "\n";
  os << indent << "Conductance: " << this->Conductance << "\n";
  const char* polarities[] = { "BRIGHT", "DARK", "BOTH" };
  os << indent << "Polarity: " << polarities[this->Polarity] << "\n";
  os << indent << "NumberOfScales: " << this->NumberOfScales << "\n";
  os << indent << "SmallestSize: " << this->SmallestSize << "\n";
  os << indent << "LargestSize: " << this->LargestSize << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
}
