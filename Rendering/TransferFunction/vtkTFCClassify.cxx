// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCClassify.h"

#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTFCAttributeReader.h"
#include "vtkTFCClassifier.h"
#include "vtkTFCThreads.h"
#include "vtkTFCTransferFunction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkTFCClassify);

namespace
{
//------------------------------------------------------------------------------
// Make `output` a shallow copy of `input` and return its datasets that hold something.
std::vector<vtkDataSet*> PassInput(vtkDataObject* input, vtkDataObject* output)
{
  std::vector<vtkDataSet*> blocks;
  const auto add = [&blocks](vtkDataObject* object)
  {
    auto* block = vtkDataSet::SafeDownCast(object);
    if (block && block->GetNumberOfPoints() > 0)
    {
      blocks.push_back(block);
    }
  };
  auto* tree = vtkCompositeDataSet::SafeDownCast(input);
  if (!tree)
  {
    output->ShallowCopy(input);
    add(output);
    return blocks;
  }
  auto* copy = vtkCompositeDataSet::SafeDownCast(output);
  copy->CopyStructure(tree);
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    const auto leafCopy = vtkSmartPointer<vtkDataObject>::Take(leaf->NewInstance());
    leafCopy->ShallowCopy(leaf);
    copy->SetDataSet(iterator, leafCopy);
    add(leafCopy);
  }
  return blocks;
}

//------------------------------------------------------------------------------
// Classify one block and add the arrays to it. Returns false when it was aborted.
bool ClassifyBlock(vtkDataSet* block, const vtkTFCAttributeReader& reader,
  const vtkTFCClassifier& classifier, vtkAlgorithm* owner, double progressBegin, double progressEnd)
{
  const vtkIdType total = reader.GetNumberOfTuples();
  vtkNew<vtkFloatArray> rgba;
  rgba->SetName("tfc_rgba");
  rgba->SetNumberOfComponents(4);
  rgba->SetNumberOfTuples(total);
  vtkNew<vtkIntArray> region;
  region->SetName("tfc_region");
  region->SetNumberOfTuples(total);
  vtkNew<vtkFloatArray> opacity;
  opacity->SetName("tfc_opacity");
  opacity->SetNumberOfTuples(total);
  float* const rgbaValues = rgba->GetPointer(0);
  int* const regionValues = region->GetPointer(0);
  float* const opacityValues = opacity->GetPointer(0);

  const int attributes = static_cast<int>(classifier.GetModel().Attributes.size());
  const auto work = [&](vtkIdType begin, vtkIdType end)
  {
    constexpr vtkIdType chunk = 2048;
    std::vector<double> scratch(attributes * chunk);
    std::vector<const double*> pointers(attributes);
    for (int a = 0; a < attributes; ++a)
    {
      pointers[a] = scratch.data() + a * chunk;
    }
    for (vtkIdType first = begin; first < end; first += chunk)
    {
      const vtkIdType count = std::min(chunk, end - first);
      reader.ReadAll(first, count, chunk, scratch.data());
      classifier.Classify(static_cast<size_t>(count), pointers.data(), rgbaValues + 4 * first,
        regionValues + first, opacityValues + first);
    }
  };
  if (!vtkTFCThreads::ForWithProgress(0, total, 16384, owner, progressBegin, progressEnd, work))
  {
    return false;
  }
  vtkDataSetAttributes* data = block->GetAttributes(reader.GetAssociation());
  data->AddArray(rgba);
  data->AddArray(region);
  data->AddArray(opacity);
  return true;
}
}

//------------------------------------------------------------------------------
vtkTFCClassify::vtkTFCClassify()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkTFCClassify::~vtkTFCClassify()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkTFCClassify::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
}

//------------------------------------------------------------------------------
void vtkTFCClassify::SetTransferFunction(const char* json)
{
  // The model raises the error of a bad text and tells a change from an equal state.
  this->Model->SetState(json);
}

//------------------------------------------------------------------------------
std::string vtkTFCClassify::GetTransferFunction() const
{
  return this->Model->GetState();
}

//------------------------------------------------------------------------------
vtkTFCTransferFunction* vtkTFCClassify::GetModel() const
{
  return this->Model;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTFCClassify::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Model->GetMTime());
}

//------------------------------------------------------------------------------
int vtkTFCClassify::FillInputPortInformation(int, vtkInformation* info)
{
  // Composite data is taken as a whole: automatic ranges are those of all blocks.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCClassify::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  const std::vector<vtkDataSet*> blocks =
    PassInput(vtkDataObject::GetData(inputs[0]), vtkDataObject::GetData(outputs));
  if (!this->Model->HasAxes())
  {
    vtkWarningMacro("Nothing is classified: the transfer function has no "
      << (this->Model->GetAxisArray(vtkTFCTransferFunction::Primary).empty() ? "primary"
                                                                             : "secondary")
      << " axis. Give it a JSON state with \"primary\" and \"secondary\" arrays.");
    return 1;
  }

  const std::vector<vtkTFCAttribute> attributes = this->Model->GetAttributes();
  std::vector<vtkTFCAttributeReader> readers(blocks.size());
  // Minima of the axes, negated maxima, and the negated number of failures: one reduction for all,
  // in which every rank takes part whatever happens to it.
  std::array<double, 5> extremes = { { HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, 0 } };
  for (size_t i = 0; i < blocks.size() && extremes[4] == 0; ++i)
  {
    std::string error;
    if (!readers[i].Bind(blocks[i], attributes, error))
    {
      vtkErrorMacro(<< error);
      extremes[4] = -1;
      break;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      if (!this->Model->HasAxisRange(axis))
      {
        double range[2];
        readers[i].FiniteRange(axis, range);
        extremes[axis] = std::min(extremes[axis], range[0]);
        extremes[2 + axis] = std::min(extremes[2 + axis], -range[1]);
      }
    }
  }
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    const std::array<double, 5> local = extremes;
    this->Controller->AllReduce(local.data(), extremes.data(), 5, vtkCommunicator::MIN_OP);
  }
  if (extremes[4] != 0)
  {
    return 1;
  }

  const double primary[2] = { extremes[0], -extremes[2] };
  const double secondary[2] = { extremes[1], -extremes[3] };
  double used[4];
  this->Model->ResolveRanges(primary, secondary, used);
  const vtkTFCClassifier classifier(this->Model->Compile(used));
  for (size_t i = 0; i < blocks.size(); ++i)
  {
    const double parts = static_cast<double>(blocks.size());
    if (!ClassifyBlock(blocks[i], readers[i], classifier, this, static_cast<double>(i) / parts,
          static_cast<double>(i + 1) / parts))
    {
      break;
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCClassify::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "Model:\n";
  this->Model->PrintSelf(os, indent.GetNextIndent());
}
