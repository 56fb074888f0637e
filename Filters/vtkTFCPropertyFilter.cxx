// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCPropertyFilter.h"

#include "vtkTFCDistributedImage.h"
#include "vtkTFCLargeBuffer.h"
#include "vtkTFCSamples.h"
#include "vtkTFCThreads.h"

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

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

vtkCxxSetObjectMacro(vtkTFCPropertyFilter, Controller, vtkMultiProcessController);

namespace
{
constexpr vtkIdType BlockSize = 65536;

// Half of the largest float: the difference of two valid samples is finite.
constexpr float LargestValid = std::numeric_limits<float>::max() / 2;

//------------------------------------------------------------------------------
/**
 * What one look at the samples tells.
 */
struct Survey
{
  float Minimum = std::numeric_limits<float>::infinity();
  float Maximum = -std::numeric_limits<float>::infinity();
  bool HasNaN = false;
  bool HasOther = false; // invalid samples that are not NaN yet

  void Add(const Survey& other)
  {
    this->Minimum = std::min(this->Minimum, other.Minimum);
    this->Maximum = std::max(this->Maximum, other.Maximum);
    this->HasNaN = this->HasNaN || other.HasNaN;
    this->HasOther = this->HasOther || other.HasOther;
  }
};

//------------------------------------------------------------------------------
Survey Look(const float* values, vtkIdType count)
{
  // Independent lanes instead of one chain of comparisons.
  constexpr int width = 16;
  float low[width], high[width];
  int nan[width] = {}, other[width] = {};
  Survey result;
  std::fill_n(low, width, result.Minimum);
  std::fill_n(high, width, result.Maximum);
  const auto look = [&](int lane, float v)
  {
    const bool valid = std::fabs(v) <= LargestValid;
    const float forLow = valid ? v : std::numeric_limits<float>::infinity();
    const float forHigh = valid ? v : -std::numeric_limits<float>::infinity();
    low[lane] = forLow < low[lane] ? forLow : low[lane];
    high[lane] = forHigh > high[lane] ? forHigh : high[lane];
    nan[lane] |= v != v;
    other[lane] |= !valid & (v == v);
  };
  vtkIdType i = 0;
  for (; i + width <= count; i += width)
  {
    for (int lane = 0; lane < width; ++lane)
    {
      look(lane, values[i + lane]);
    }
  }
  for (; i < count; ++i)
  {
    look(0, values[i]);
  }
  for (int lane = 0; lane < width; ++lane)
  {
    result.Minimum = std::min(result.Minimum, low[lane]);
    result.Maximum = std::max(result.Maximum, high[lane]);
    result.HasNaN = result.HasNaN || nan[lane];
    result.HasOther = result.HasOther || other[lane];
  }
  return result;
}

//------------------------------------------------------------------------------
/**
 * Visits the samples in blocks: body(first, count) returns a Survey.
 */
template <typename Body>
bool SurveyBlocks(vtkIdType count, vtkAlgorithm* owner, double from, double to, Survey& total,
  Body&& body)
{
  const vtkIdType blocks = (count + BlockSize - 1) / BlockSize;
  std::vector<Survey> surveys(static_cast<size_t>(blocks));
  const bool done = vtkTFCThreads::ForWithProgress(0, blocks, 1, owner, from, to,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const vtkIdType first = block * BlockSize;
        surveys[block] = body(first, std::min(BlockSize, count - first));
      }
    });
  for (const Survey& survey : surveys)
  {
    total.Add(survey);
  }
  return done;
}

//------------------------------------------------------------------------------
/**
 * The samples of this process as floats, NaN where invalid: the array itself where possible.
 */
class LocalSamples
{
public:
  LocalSamples(vtkDataArray* array, int component, vtkUnsignedCharArray* ghosts, int association)
    : Array(array)
    , Component(component)
    , Hidden(vtkTFCSamples::GetHiddenBit(association))
  {
    if (ghosts && ghosts->GetNumberOfValues() == array->GetNumberOfTuples())
    {
      this->Ghosts = ghosts->GetPointer(0);
    }
  }

  bool Load(vtkAlgorithm* owner, double from, double to)
  {
    const vtkIdType count = this->Array->GetNumberOfTuples();
    auto* floats = vtkFloatArray::SafeDownCast(this->Array);
    if (floats && floats->GetNumberOfComponents() == 1 && this->Component == 0)
    {
      const float* values = floats->GetPointer(0);
      const bool done = SurveyBlocks(count, owner, from, to, this->Found,
        [&](vtkIdType first, vtkIdType n)
        {
          Survey survey = Look(values + first, n);
          survey.HasOther = survey.HasOther || this->HasBlanked(first, n);
          return survey;
        });
      if (!done || !this->Found.HasOther)
      {
        this->Values = values;
        return done;
      }
    }
    this->Copy = vtkTFCLargeBuffer::Allocate(count);
    this->Values = this->Copy.get();
    this->Found = Survey();
    return SurveyBlocks(count, owner, from, to, this->Found,
      [&](vtkIdType first, vtkIdType n)
      {
        float* values = this->Copy.get() + first;
        vtkTFCSamples::Read(this->Array, this->Component, first, n, values);
        for (vtkIdType i = 0; i < n; ++i)
        {
          const bool hidden = this->Ghosts && (this->Ghosts[first + i] & this->Hidden);
          if (hidden || !(std::fabs(values[i]) <= LargestValid))
          {
            values[i] = std::numeric_limits<float>::quiet_NaN();
          }
        }
        return Look(values, n);
      });
  }

  const float* Values = nullptr;
  Survey Found;

private:
  bool HasBlanked(vtkIdType first, vtkIdType n) const
  {
    const unsigned char hidden = this->Hidden;
    return this->Ghosts &&
      std::any_of(this->Ghosts + first, this->Ghosts + first + n,
        [=](unsigned char flags) { return (flags & hidden) != 0; });
  }

  vtkDataArray* Array;
  int Component;
  unsigned char Hidden;
  const unsigned char* Ghosts = nullptr;
  vtkTFCLargeBuffer::Pointer Copy;
};

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
int vtkTFCPropertyFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* in = inputVector[0]->GetInformationObject(0);
  vtkInformation* out = outputVector->GetInformationObject(0);
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
int vtkTFCPropertyFilter::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->ShallowCopy(input);

  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
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
      association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    }
  }
  else
  {
    chosen = this->GetInputAbstractArrayToProcess(0, input, association);
  }
  auto* array = vtkDataArray::SafeDownCast(chosen);
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  std::string problem = this->CheckParameters();
  if (problem.empty() && !isEmpty)
  {
    problem =
      CheckArray(input, chosen, wanted ? wanted : "(active scalars)", association, this->Component);
  }

  // From here on every process takes the same way, whatever it found.
  const vtkTFCDistributedImage image(input, association, this->Controller);
  if (!image.Any(!isEmpty) && problem.empty())
  {
    problem = "The input is empty. Connect a volume with at least one point.";
  }
  if (!image.All(problem.empty()))
  {
    vtkErrorMacro(<< (problem.empty()
                         ? "Another process cannot use its piece of the input: see the "
                           "message there."
                         : problem)
                  << " No array was added.");
    return 1;
  }

  std::unique_ptr<LocalSamples> local;
  Survey found;
  bool completed = true;
  if (!isEmpty)
  {
    local.reset(new LocalSamples(array, this->Component,
      vtkTFCSamples::GetGhosts(GetAttributes(input, association)), association));
    completed = local->Load(this, 0., 0.15);
    found = local->Found;
  }
  if (!image.All(completed))
  {
    return 1;
  }
  Field field;
  field.Range[0] = found.Minimum;
  field.Range[1] = found.Maximum;
  image.Minimum(&field.Range[0], 1);
  image.Maximum(&field.Range[1], 1);
  if (field.Range[0] > field.Range[1])
  {
    vtkErrorMacro("The array '" << (array && array->GetName() ? array->GetName() : "")
                                << "' has no valid value: all are NaN, infinite or blanked. Choose "
                                   "another array. No array was added.");
    return 1;
  }

  field.Values = local ? local->Values : nullptr;
  field.HasInvalid = found.HasNaN;
  const int halo = image.GetNumberOfRanks() > 1 ? this->GetHaloWidth() : 0;
  const auto localExtent = image.GetLocalExtent();
  const auto extent = image.GetNumberOfRanks() > 1 ? image.GetGrownExtent(halo) : localExtent;
  vtkTFCLargeBuffer::Pointer grown;
  if (image.GetNumberOfRanks() > 1)
  {
    const vtkIdType count = vtkTFCDistributedImage::GetNumberOfSamples(extent);
    grown = vtkTFCLargeBuffer::Allocate(count);
    image.Exchange(field.Values, halo, grown.get());
    field.Values = grown.get();
    field.HasInvalid = Look(grown.get(), count).HasNaN;
  }
  if (isEmpty)
  {
    return 1;
  }
  for (int a = 0; a < 3; ++a)
  {
    field.Size[a] = extent[2 * a + 1] - extent[2 * a] + 1;
    field.Begin[a] = localExtent[2 * a] - extent[2 * a];
    field.End[a] = localExtent[2 * a + 1] - extent[2 * a] + 1;
    // Along an axis with one sample the spacing plays no part, and may be 0.
    const double spacing = std::fabs(input->GetSpacing()[a]);
    field.Spacing[a] = spacing > 0. ? spacing : 1.;
  }

  std::vector<vtkSmartPointer<vtkFloatArray>> results;
  std::vector<float*> pointers;
  for (const std::string& suffix : this->GetSuffixes())
  {
    auto result = vtkSmartPointer<vtkFloatArray>::New();
    result->SetName(((array->GetName() ? array->GetName() : "") + suffix).c_str());
    const vtkIdType count = array->GetNumberOfTuples();
    result->SetArray(vtkTFCLargeBuffer::Allocate(count).release(), count, 0,
      vtkFloatArray::VTK_DATA_ARRAY_FREE);
    pointers.push_back(result->GetPointer(0));
    results.push_back(result);
  }
  if (this->ComputeProperties(field, pointers))
  {
    for (const auto& result : results)
    {
      GetAttributes(output, association)->AddArray(result);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCPropertyFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
