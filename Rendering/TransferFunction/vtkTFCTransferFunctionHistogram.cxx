// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTransferFunctionHistogram.h"

#include "vtkTFCRegion.h"
#include "vtkTFCRegionHistograms.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkTFCTransferFunctionHistogram);

namespace
{
constexpr int MostBins = 1024;

//------------------------------------------------------------------------------
void FillPlane(const vtkTFCSparseHistogram* histogram, vtkImageData* image)
{
  const int bins[2] = { histogram->GetNumberOfBins(0), histogram->GetNumberOfBins(1) };
  double spacing[3] = { 1., 1., 1. };
  for (int axis = 0; axis < 2; ++axis)
  {
    double range[2];
    histogram->GetRange(axis, range);
    spacing[axis] = (range[1] - range[0]) / bins[axis];
  }
  image->SetDimensions(bins[0], bins[1], 1);
  image->SetOrigin(histogram->GetBinCenter(0, 0), histogram->GetBinCenter(1, 0), 0.);
  image->SetSpacing(spacing);
  vtkNew<vtkDoubleArray> counts;
  counts->SetName("count");
  counts->SetNumberOfTuples(image->GetNumberOfPoints());
  histogram->GetPlane(counts->GetPointer(0));
  image->GetPointData()->SetScalars(counts);
}

//------------------------------------------------------------------------------
void AddColumns(const vtkTFCRegionHistograms::Conditional& region, bool rows, vtkTable* table)
{
  const std::string name = "region " + std::to_string(region.Id) + " ";
  const auto bins = static_cast<vtkIdType>(rows ? region.Counts.size() : 0);
  vtkNew<vtkDoubleArray> centers;
  centers->SetName((name + region.Label).c_str());
  centers->SetNumberOfTuples(bins);
  vtkNew<vtkDoubleArray> counts;
  counts->SetName((name + "count").c_str());
  counts->SetNumberOfTuples(bins);
  for (vtkIdType bin = 0; bin < bins; ++bin)
  {
    centers->SetValue(bin, region.GetBinCenter(static_cast<int>(bin)));
    counts->SetValue(bin, region.Counts[bin]);
  }
  table->AddColumn(centers);
  table->AddColumn(counts);
}
}

//------------------------------------------------------------------------------
struct vtkTFCTransferFunctionHistogram::Internals
{
  vtkTFCRegionHistograms Histograms;
};

//------------------------------------------------------------------------------
vtkTFCTransferFunctionHistogram::vtkTFCTransferFunctionHistogram()
  : Internal(new Internals)
{
  this->SetNumberOfOutputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkTFCTransferFunctionHistogram::~vtkTFCTransferFunctionHistogram()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunctionHistogram::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunctionHistogram::SetTransferFunction(const char* json)
{
  this->Model->SetState(json);
}

//------------------------------------------------------------------------------
std::string vtkTFCTransferFunctionHistogram::GetTransferFunction() const
{
  return this->Model->GetState();
}

//------------------------------------------------------------------------------
vtkTFCTransferFunction* vtkTFCTransferFunctionHistogram::GetModel() const
{
  return this->Model;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTFCTransferFunctionHistogram::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Model->GetMTime());
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunctionHistogram::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunctionHistogram::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunctionHistogram::RequestInformation(vtkInformation*, vtkInformationVector**,
  vtkInformationVector* outputs)
{
  const int last = std::max(1, this->NumberOfBins) - 1;
  outputs->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), 0, last,
    0, last, 0, 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunctionHistogram::RequestUpdateExtent(vtkInformation*,
  vtkInformationVector** inputs, vtkInformationVector*)
{
  // The extent that is wanted is one of bins. Of the input all is needed; its source cuts it into
  // the pieces that the processes ask for.
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  if (info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    int extent[6];
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCTransferFunctionHistogram::RequestData(vtkInformation*, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  std::string problem;
  if (this->NumberOfBins < 2 || this->NumberOfBins > MostBins)
  {
    problem = "NumberOfBins is " + std::to_string(this->NumberOfBins) + ". Set it to 2 to " +
      std::to_string(MostBins) + ".";
  }
  else if (!this->Model->HasAxes())
  {
    problem = "The transfer function lacks an axis. Give it a JSON state with \"primary\" and "
              "\"secondary\" arrays.";
  }
  else
  {
    problem = this->Internal->Histograms.Update(vtkDataObject::GetData(inputs[0]), this->Model,
      this->NumberOfBins, this->Controller, this);
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem << " There are no histograms.");
    return 1;
  }

  if (this->Internal->Histograms.WasAborted())
  {
    return 1;
  }

  // The image is on all processes: one whose image lacks what was asked for would update again,
  // alone, and wait for the others for ever.
  FillPlane(this->Internal->Histograms.GetJoint(), vtkImageData::GetData(outputs, 0));
  const bool rows =
    this->TablesOnAllProcesses || !this->Controller || this->Controller->GetLocalProcessId() == 0;
  for (const auto& conditional : this->Internal->Histograms.GetConditionals())
  {
    AddColumns(conditional, rows, vtkTable::GetData(outputs, 1));
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCTransferFunctionHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "TablesOnAllProcesses: " << this->TablesOnAllProcesses << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "Model:\n";
  this->Model->PrintSelf(os, indent.GetNextIndent());
}
