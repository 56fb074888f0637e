// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCMaterialPhantom.h"

#include "Kernels/TFCPhantom.h"
#include "vtkTFCLargeBuffer.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkTFCMaterialPhantom);

//------------------------------------------------------------------------------
vtkTFCMaterialPhantom::vtkTFCMaterialPhantom()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
int vtkTFCMaterialPhantom::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  int extent[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->Dimensions[axis] < 1)
    {
      vtkErrorMacro("Dimensions[" << axis << "] is " << this->Dimensions[axis]
                                  << "; a volume needs at least 1 sample along each axis.");
      return 0;
    }
    extent[2 * axis] = 0;
    extent[2 * axis + 1] = this->Dimensions[axis] - 1;
  }
  const double origin[3] = { 0, 0, 0 };
  const double spacing[3] = { 1, 1, 1 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCMaterialPhantom::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  output->SetExtent(extent);

  vtkNew<vtkFloatArray> intensity;
  intensity->SetName("intensity");
  const vtkIdType count = output->GetNumberOfPoints();
  intensity->SetArray(vtkTFCLargeBuffer::Allocate(count).release(), count, 0,
    vtkFloatArray::VTK_DATA_ARRAY_FREE);
  vtkNew<vtkUnsignedCharArray> material;
  material->SetName("material");
  material->SetNumberOfTuples(output->GetNumberOfPoints());
  float* values = intensity->GetPointer(0);
  unsigned char* labels = material->GetPointer(0);

  const vtkIdType nx = extent[1] - extent[0] + 1;
  const vtkIdType ny = extent[3] - extent[2] + 1;
  const vtkIdType nz = extent[5] - extent[4] + 1;
  const auto position = [this](int axis, vtkIdType i)
  { return 2.0 * (static_cast<double>(i) + 0.5) / this->Dimensions[axis] - 1.0; };
  // Rows, so that there is work for every thread whatever the proportions.
  vtkTFCThreads::ForWithProgress(0, ny * nz, 16, this, 0.0, 1.0,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          const vtkIdType j = extent[2] + row % ny;
          const vtkIdType k = extent[4] + row / ny;
          // The index in the whole volume: what is drawn does not depend on the part asked for.
          const vtkIdType index = this->Dimensions[0] * (j + this->Dimensions[1] * k);
          tfc::PhantomRow(extent[0], nx, this->Dimensions[0], position(1, j), position(2, k),
            this->GeometryScale, static_cast<std::uint64_t>(this->Seed),
            static_cast<std::uint64_t>(index), this->NoiseScale, values + row * nx,
            labels + row * nx);
        }
      }));
  output->GetPointData()->SetScalars(intensity);
  output->GetPointData()->AddArray(material);
  return 1;
}

//------------------------------------------------------------------------------
void vtkTFCMaterialPhantom::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
     << this->Dimensions[2] << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "NoiseScale: " << this->NoiseScale << "\n";
  os << indent << "GeometryScale: " << this->GeometryScale << "\n";
}
