// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCPropertyFilter.h"

#include "vtkTFCDistributedImage.h"
#include "vtkTFCLargeBuffer.h"
#include "vtkTFCLocalSamples.h"
#include "vtkTFCSamples.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkExtentTranslator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <sstream>

vtkCxxSetObjectMacro(vtkTFCPropertyFilter, Controller, vtkMultiProcessController);

namespace
{
const char* const ElsewhereProblem =
  "Another process cannot use its piece of the input: see the message there.";

//------------------------------------------------------------------------------
vtkDataSetAttributes* GetAttributes(vtkDataSet* data, int association)
{
  return association == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? static_cast<vtkDataSetAttributes*>(data->GetCellData())
    : static_cast<vtkDataSetAttributes*>(data->GetPointData());
}

//------------------------------------------------------------------------------
/**
 * What is wrong with the chosen array; empty when it can be used.
 */
std::string CheckArray(vtkImageData* input, vtkAbstractArray* chosen, const char* wanted,
  int association, int component)
{
  auto* array = vtkDataArray::SafeDownCast(chosen);
  if (chosen && !array)
  {
    return "The array '" + std::string(wanted) +
      "' holds text, not numbers. Choose a numeric array. Point arrays: " +
      vtkTFCSamples::ListArrays(input->GetPointData()) +
      "; cell arrays: " + vtkTFCSamples::ListArrays(input->GetCellData()) + ".";
  }
  const bool usable = association == vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (!array || !usable)
  {
    return "The input has no point or cell array '" + std::string(wanted) +
      "'. Set InputArray to one of the point arrays " +
      vtkTFCSamples::ListArrays(input->GetPointData()) + " or the cell arrays " +
      vtkTFCSamples::ListArrays(input->GetCellData()) + ".";
  }
  const std::string name = array->GetName() ? array->GetName() : "";
  if (component < vtkTFCSamples::Magnitude || component >= array->GetNumberOfComponents())
  {
    return "Component " + std::to_string(component) + " of the array '" + name +
      "' does not exist. Set Component to a number from 0 to " +
      std::to_string(array->GetNumberOfComponents() - 1) + ", or to -1 for the magnitude.";
  }
  const vtkIdType expected = association == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? input->GetNumberOfCells()
    : input->GetNumberOfPoints();
  if (array->GetNumberOfTuples() != expected)
  {
    return "The array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) +
      " values, but the volume has " + std::to_string(expected) +
      " samples. Check how the array was made.";
  }
  const int* dimensions = input->GetDimensions();
  const double* spacing = input->GetSpacing();
  for (int a = 0; a < 3; ++a)
  {
    if (dimensions[a] > 1 && !(std::fabs(spacing[a]) > 0. && std::isfinite(spacing[a])))
    {
      return "The spacing of the volume along axis " + std::to_string(a) + " is " +
        std::to_string(spacing[a]) + ". Set a positive spacing in the source.";
    }
  }
  return {};
}
}

//------------------------------------------------------------------------------
vtkTFCPropertyFilter::vtkTFCPropertyFilter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS,
    vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkTFCPropertyFilter::~vtkTFCPropertyFilter()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
int vtkTFCPropertyFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCPropertyFilter::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* in = inputVector[0]->GetInformationObject(0);
  // A subclass may have more outputs than the volume: the piece is asked of one of them.
  const int port =
    request->Has(SDDP::FROM_OUTPUT_PORT()) ? request->Get(SDDP::FROM_OUTPUT_PORT()) : 0;
  vtkInformation* out = outputVector->GetInformationObject(std::max(0, port));
  if (!in->Has(SDDP::WHOLE_EXTENT()))
  {
    return 1;
  }
  int whole[6], extent[6];
  in->Get(SDDP::WHOLE_EXTENT(), whole);
  int piece = 0, pieces = 1;
  if (out->Has(SDDP::UPDATE_NUMBER_OF_PIECES()))
  {
    piece = out->Get(SDDP::UPDATE_PIECE_NUMBER());
    pieces = std::max(1, out->Get(SDDP::UPDATE_NUMBER_OF_PIECES()));
  }
  // This process's share of the whole, even if downstream wants less of it: together the processes
  // must hold everything. And what downstream wants, which may lie outside of that share.
  vtkNew<vtkExtentTranslator> translator;
  translator->PieceToExtentThreadSafe(piece, pieces, 0, whole, extent,
    vtkExtentTranslator::BLOCK_MODE, 0);
  const auto isEmpty = [](const int* e) { return e[0] > e[1] || e[2] > e[3] || e[4] > e[5]; };
  int wanted[6] = { 0, -1, 0, -1, 0, -1 };
  if (out->Has(SDDP::UPDATE_EXTENT()))
  {
    out->Get(SDDP::UPDATE_EXTENT(), wanted);
  }
  if (isEmpty(extent))
  {
    return 1;
  }
  for (int i = 0; !isEmpty(wanted) && i < 6; i += 2)
  {
    extent[i] = std::min(extent[i], std::max(wanted[i], whole[i]));
    extent[i + 1] = std::max(extent[i + 1], std::min(wanted[i + 1], whole[i + 1]));
  }
  in->Set(SDDP::UPDATE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
/**
 * What RequestData() finds out once for all arrays.
 */
struct vtkTFCPropertyFilter::Job
{
  vtkImageData* Input = nullptr;
  vtkImageData* Output = nullptr;
  int Association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  std::vector<vtkDataArray*> Arrays; // none on a process without samples
  bool IsEmpty = false;
  const vtkTFCDistributedImage* Image = nullptr;
  std::string Problem;
};

//------------------------------------------------------------------------------
std::string vtkTFCPropertyFilter::FindArrays(vtkImageData* input, Job& job)
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* wanted =
    info->Has(vtkDataObject::FIELD_NAME()) ? info->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  vtkAbstractArray* chosen = nullptr;
  if (wanted && *wanted == '\0')
  {
    // What ParaView sends for a source that was not updated when the filter was made.
    wanted = nullptr;
    chosen = input->GetPointData()->GetScalars();
    if (!chosen && (chosen = input->GetCellData()->GetScalars()))
    {
      job.Association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    }
  }
  else
  {
    chosen = this->GetInputAbstractArrayToProcess(0, input, job.Association);
  }
  if (job.IsEmpty)
  {
    return {};
  }
  std::string problem = CheckArray(input, chosen, wanted ? wanted : "(active scalars)",
    job.Association, this->Component);
  if (!problem.empty())
  {
    return problem;
  }
  job.Arrays.push_back(vtkDataArray::SafeDownCast(chosen));
  for (const std::string& name : this->MoreArrays)
  {
    vtkAbstractArray* more = GetAttributes(input, job.Association)->GetAbstractArray(name.c_str());
    if (more == chosen)
    {
      continue;
    }
    std::string other = CheckArray(input, more, name.c_str(), job.Association, this->Component);
    if (!other.empty())
    {
      return other;
    }
    job.Arrays.push_back(vtkDataArray::SafeDownCast(more));
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkTFCPropertyFilter::CheckMemory(const Job& job, const Field& field,
  bool needsCopy) const
{
  const double own = static_cast<double>(field.GetOwnSize());
  double bytes = this->GetTemporaryBytes(field);
  bytes += 4. * own * static_cast<double>(this->GetSuffixes().size());
  bytes += needsCopy ? 4. * own : 0.;
  bytes += job.Image->GetNumberOfRanks() > 1 ? 4. * static_cast<double>(field.GetSize()) : 0.;

  vtksys::SystemInformation system;
  // KiB. Memory that the system uses for files only is not "used".
  double available =
    1024. * static_cast<double>(system.GetHostMemoryTotal() - system.GetHostMemoryUsed());
  if (const char* limit = std::getenv("TFC_MEMORY_LIMIT"))
  {
    const double mebibytes = std::strtod(limit, nullptr);
    available = mebibytes > 0. ? std::min(available, mebibytes * 1048576.) : available;
  }
  if (bytes <= available)
  {
    return {};
  }
  std::ostringstream problem;
  problem << "This needs " << std::ceil(bytes / 1048576.) << " MiB of memory for '" << field.Name
          << "', and " << std::floor(available / 1048576.)
          << " MiB are available. Use more processes, extract a part of the volume, or reduce its "
             "resolution.";
  return problem.str();
}

//------------------------------------------------------------------------------
bool vtkTFCPropertyFilter::ProcessArray(Job& job, size_t index)
{
  const vtkTFCDistributedImage& image = *job.Image;
  vtkDataArray* array = job.IsEmpty ? nullptr : job.Arrays[index];
  Field field;
  field.Name = array && array->GetName() ? array->GetName() : "";
  field.Association = job.Association;

  std::unique_ptr<vtkTFCLocalSamples> local;
  vtkTFCSurvey found;
  bool completed = true;
  if (array)
  {
    local.reset(new vtkTFCLocalSamples(array, this->Component,
      vtkTFCSamples::GetGhosts(GetAttributes(job.Input, job.Association)), job.Association));
    completed = local->Load(this, 0., 0.15);
    found = local->Found;
  }
  if (!image.All(completed))
  {
    return false;
  }
  field.Range[0] = found.Minimum;
  field.Range[1] = found.Maximum;
  image.Minimum(field.Range, 1);
  image.Maximum(field.Range + 1, 1);
  if (field.Range[0] > field.Range[1])
  {
    job.Problem = "The array '" + field.Name +
      "' has no valid value: all are NaN, infinite or blanked. Choose another array.";
    return false;
  }

  const auto whole = image.GetWholeExtent();
  double spacing[3] = { 0., 0., 0. };
  for (int a = 0; a < 3; ++a)
  {
    // Along an axis with one sample the spacing plays no part, and may be 0.
    spacing[a] = job.IsEmpty ? 0. : std::fabs(job.Input->GetSpacing()[a]);
    field.WholeSize[a] = whole[2 * a + 1] - whole[2 * a] + 1;
  }
  image.Maximum(spacing, 3);
  for (int a = 0; a < 3; ++a)
  {
    field.Spacing[a] = spacing[a] > 0. ? spacing[a] : 1.;
    field.UnitSpacing[a] = this->LengthUnit == WORLD ? field.Spacing[a] : 1.;
  }
  const bool several = image.GetNumberOfRanks() > 1;
  const int halo = several ? this->GetHaloWidth(field) : 0;
  const auto localExtent = image.GetLocalExtent();
  const auto extent = several ? image.GetGrownExtent(halo) : localExtent;
  for (int a = 0; !job.IsEmpty && a < 3; ++a)
  {
    field.Size[a] = extent[2 * a + 1] - extent[2 * a] + 1;
    field.Begin[a] = localExtent[2 * a] - extent[2 * a];
    field.End[a] = localExtent[2 * a + 1] - extent[2 * a] + 1;
    field.Offset[a] = extent[2 * a] - whole[2 * a];
  }
  field.HasInvalid = local && (found.HasNaN || found.HasOther);
  job.Problem = this->CheckField(field);
  if (job.Problem.empty() && !job.IsEmpty)
  {
    job.Problem = this->CheckMemory(job, field, local->NeedsCopy() || found.HasOther);
  }
  if (!image.All(job.Problem.empty()))
  {
    job.Problem = job.Problem.empty() ? ElsewhereProblem : job.Problem;
    return false;
  }

  field.Values = local ? local->Values : nullptr;
  field.HasInvalid = found.HasNaN;
  vtkTFCLargeBuffer::Pointer grown;
  if (several)
  {
    const vtkIdType count = vtkTFCDistributedImage::GetNumberOfSamples(extent);
    grown = vtkTFCLargeBuffer::Allocate(count);
    image.Exchange(field.Values, halo, grown.get());
    field.Values = grown.get();
    field.HasInvalid = vtkTFCSurvey::Look(grown.get(), count).HasNaN;
  }
  if (!image.All(this->Prepare(field, image)))
  {
    return false;
  }

  std::vector<vtkSmartPointer<vtkFloatArray>> results;
  std::vector<float*> pointers;
  for (const std::string& suffix : this->GetSuffixes())
  {
    const vtkIdType count = array ? array->GetNumberOfTuples() : 0;
    auto result = vtkSmartPointer<vtkFloatArray>::New();
    result->SetName((field.Name + suffix).c_str());
    result->SetArray(vtkTFCLargeBuffer::Allocate(count).release(), count, 0,
      vtkFloatArray::VTK_DATA_ARRAY_FREE);
    pointers.push_back(result->GetPointer(0));
    results.push_back(result);
  }
  // All processes end up with the same arrays.
  if (!image.All(job.IsEmpty || this->ComputeProperties(field, pointers)))
  {
    return false;
  }
  for (const auto& result : results)
  {
    if (!job.IsEmpty)
    {
      GetAttributes(job.Output, job.Association)->AddArray(result);
    }
  }
  this->AddFieldData(field, job.Output->GetFieldData());
  return true;
}

//------------------------------------------------------------------------------
int vtkTFCPropertyFilter::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  Job job;
  job.Input = vtkImageData::GetData(inputVector[0]);
  job.Output = vtkImageData::GetData(outputVector);
  job.Output->ShallowCopy(job.Input);
  job.IsEmpty = job.Input->GetNumberOfPoints() == 0;
  job.Problem = this->CheckParameters();
  const std::string arrayProblem = this->FindArrays(job.Input, job);
  job.Problem = job.Problem.empty() ? arrayProblem : job.Problem;

  // From here on every process takes the same way, whatever it found.
  const vtkTFCDistributedImage image(job.Input, job.Association, this->Controller);
  job.Image = &image;
  if (!image.Any(!job.IsEmpty) && job.Problem.empty())
  {
    job.Problem = "The input is empty. Connect a volume with at least one point.";
  }
  if (image.All(job.Problem.empty()))
  {
    this->ProcessArrays(job);
  }
  else if (job.Problem.empty())
  {
    job.Problem = ElsewhereProblem;
  }
  if (!job.Problem.empty())
  {
    job.Output->Initialize();
    vtkErrorMacro(<< job.Problem);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCPropertyFilter::ProcessArrays(Job& job)
{
  double count = static_cast<double>(job.Arrays.size());
  job.Image->Maximum(&count, 1);
  const double shift = this->GetProgressShift(), scale = this->GetProgressScale();
  try
  {
    for (double i = 0.; i < count; ++i)
    {
      this->SetProgressShiftScale(shift + scale * i / count, scale / count);
      if (!this->ProcessArray(job, static_cast<size_t>(i)))
      {
        break;
      }
    }
  }
  catch (const std::bad_alloc&)
  {
    job.Problem = "The memory does not suffice for this volume. Use more processes, extract a part "
                  "of the volume, or reduce its resolution.";
  }
  this->SetProgressShiftScale(shift, scale);
}

//------------------------------------------------------------------------------
void vtkTFCPropertyFilter::AddArray(const char* name)
{
  if (name && *name)
  {
    this->MoreArrays.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCPropertyFilter::ClearArrays()
{
  if (!this->MoreArrays.empty())
  {
    this->MoreArrays.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCPropertyFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "LengthUnit: " << (this->LengthUnit == WORLD ? "WORLD" : "VOXELS") << "\n";
  os << indent << "MoreArrays:";
  for (const std::string& name : this->MoreArrays)
  {
    os << " '" << name << "'";
  }
  os << "\n" << indent << "Controller: " << this->Controller << "\n";
}
