// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCVolumeMapper.h"

#include "vtkTFCBlendBuffer.h"
#include "vtkTFCBlockSet.h"
#include "vtkTFCFallbackRenderer.h"
#include "vtkTFCFrameBudget.h"
#include "vtkTFCGraphicsSupport.h"
#include "vtkTFCSettingsCheck.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTFCVolumeBlock.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{

// Frames per second from which on a window is being moved. VTK asks a window at rest for 0.0001,
// ParaView for 0.002.
constexpr double SlowestMovingRate = 1.0;

//------------------------------------------------------------------------------
bool HasRenderPass(vtkVolume* vol)
{
  vtkInformation* keys = vol->GetPropertyKeys();
  return keys && keys->Has(vtkOpenGLRenderPass::RenderPasses());
}

}

//------------------------------------------------------------------------------
class vtkTFCVolumeMapper::Internals
{
public:
  vtkTFCBlockSet Blocks;
  vtkTFCBlendBuffer Buffer;
  vtkTFCFrameBudget Budget;
  vtkTFCImageBlocks ImagesForCPU;
  vtkTFCFallbackRenderer Fallback;
  vtkRenderWindow* ProbedWindow = nullptr; // only compared
  std::string Missing;                     // of its OpenGL
  std::string WarnedOf;
  std::string Omission; // from the picture, as last told
};

vtkStandardNewMacro(vtkTFCVolumeMapper);

//------------------------------------------------------------------------------
vtkTFCVolumeMapper::vtkTFCVolumeMapper()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkTFCVolumeMapper::~vtkTFCVolumeMapper() = default;

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::SetTransferFunction(vtkTFCTransferFunction* model)
{
  if (this->TransferFunction != model)
  {
    this->TransferFunction = model;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTFCTransferFunction* vtkTFCVolumeMapper::GetTransferFunction() const
{
  return this->TransferFunction;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::SetAutomaticRanges(const double primary[2], const double secondary[2])
{
  // Not Modified(): ranges go into the tables, like any edit of the model.
  std::copy(primary, primary + 2, this->AutomaticRanges[0].begin());
  std::copy(secondary, secondary + 2, this->AutomaticRanges[1].begin());
  this->HasAutomaticRanges = true;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::ClearAutomaticRanges()
{
  this->HasAutomaticRanges = false;
}

//------------------------------------------------------------------------------
int vtkTFCVolumeMapper::GetNumberOfTableUploads() const
{
  return this->Internal->Blocks.GetNumberOfTableUploads();
}

//------------------------------------------------------------------------------
int vtkTFCVolumeMapper::GetNumberOfVolumeUploads() const
{
  return this->Internal->Blocks.GetNumberOfVolumeUploads();
}

//------------------------------------------------------------------------------
int vtkTFCVolumeMapper::GetNumberOfClassifications() const
{
  return this->Internal->Fallback.GetNumberOfClassifications();
}

//------------------------------------------------------------------------------
double* vtkTFCVolumeMapper::GetBounds()
{
  double* bounds = this->Superclass::GetBounds();
  auto* image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  if (bounds && image && image->GetNumberOfPoints() > 0)
  {
    // A single layer is drawn one voxel thick.
    const int* extent = image->GetExtent();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (extent[2 * axis] == extent[2 * axis + 1])
      {
        const double half = 0.5 * std::abs(image->GetSpacing()[axis]);
        for (int i = 0; i < 3; ++i)
        {
          const double reach = half * std::abs(image->GetDirectionMatrix()->GetElement(i, axis));
          this->Bounds[2 * i] = bounds[2 * i] - reach;
          this->Bounds[2 * i + 1] = bounds[2 * i + 1] + reach;
        }
        bounds = this->Bounds;
      }
    }
  }
  return bounds;
}

//------------------------------------------------------------------------------
// Sets UsedCPU. False when what was asked for cannot be had.
bool vtkTFCVolumeMapper::ChooseRenderer(vtkRenderer* ren, vtkVolume* vol, std::string& error)
{
  this->UsedCPU = this->Renderer == CPURenderer;
  if (this->UsedCPU)
  {
    return true;
  }
  if (this->Internal->ProbedWindow != ren->GetRenderWindow())
  {
    this->Internal->ProbedWindow = ren->GetRenderWindow();
    this->Internal->Missing =
      vtkTFCGraphicsSupport::Probe(ren->GetRenderWindow(), vol).FindMissing();
  }
  const std::string& missing = this->Internal->Missing;
  if (missing.empty())
  {
    return true;
  }
  if (this->Renderer == GPURenderer)
  {
    error = missing + ". Set Renderer to Auto or CPU.";
    return false;
  }
  this->UsedCPU = true;
  if (this->Internal->WarnedOf != missing)
  {
    this->Internal->WarnedOf = missing;
    vtkWarningMacro("Combined Volume is rendered on the CPU: "
      << missing << ". Edges of regions are softer, and it is slower.");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCVolumeMapper::PrepareForCPU(std::string& error)
{
  vtkTFCTransferFunction* model = this->TransferFunction;
  if (!model || model->GetNumberOfRegions() == 0)
  {
    return false;
  }
  const auto& images = this->Internal->ImagesForCPU.Update(this->GetInputDataObject(0, 0),
    model->GetAttributes(), vtkTFCImageBlocks::Limits(), error);
  if (images.empty())
  {
    return false;
  }
  const std::string unsupported =
    vtkTFCSettingsCheck::FindErrorOnCPU(this, static_cast<int>(images.size()), this->Distributed);
  if (!unsupported.empty())
  {
    error = unsupported;
    return false;
  }
  return this->Internal->Fallback.Update(images.front(), model,
    this->HasAutomaticRanges ? &this->AutomaticRanges : nullptr, error);
}

//------------------------------------------------------------------------------
bool vtkTFCVolumeMapper::Prepare(vtkRenderer* ren, vtkVolume* vol, std::string& error)
{
  vtkTFCBlockSet::Settings settings;
  settings.Input = this->GetInputDataObject(0, 0);
  settings.AutomaticRanges = this->HasAutomaticRanges ? &this->AutomaticRanges : nullptr;
  settings.ShadingArray = this->ShadingArray;
  settings.HasGradients = vol->GetProperty()->GetShade() && !this->ShadeByOpacity;
  settings.EmptySpaceSkipping = this->EmptySpaceSkipping;
  settings.MemoryLimit = this->MemoryLimit;
  settings.LongestTextureSide = this->LongestTextureSide;
  auto& blocks = this->Internal->Blocks;
  if (!blocks.Update(this->TransferFunction, settings,
        vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()), error))
  {
    return false;
  }
  const std::string unsupported = vtkTFCSettingsCheck::FindError(this, vol->GetProperty(),
    blocks.GetNumberOfDrawableBlocks(), this->Distributed);
  if (!unsupported.empty())
  {
    error = unsupported;
    return false;
  }
  // Both setters do nothing when nothing changes.
  vol->GetProperty()->SetIndependentComponents(0);
  vol->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::RenderBlocks(vtkRenderer* ren, vtkVolume* vol)
{
  const auto order = vtkTFCVolumeBlock::FindOrder(this->Internal->Blocks.GetBlocks(), ren, vol);
  double distance = this->SampleDistance;
  if (!(distance > 0.0))
  {
    // The same for all, so that what rays see does not depend on the blocks.
    distance = VTK_DOUBLE_MAX;
    for (const auto* block : order)
    {
      distance = std::min(distance, block->GetDefaultSampleDistance());
    }
  }
  vtkTFCFrameBudget& budget = this->Internal->Budget;
  const bool moving =
    !ren->GetSelector() && ren->GetRenderWindow()->GetDesiredUpdateRate() >= SlowestMovingRate;
  const vtkTFCFrameBudget::Level level =
    moving ? budget.Choose(vol->GetAllocatedRenderTime()) : vtkTFCFrameBudget::Level();
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();

  // Depth peeling and selection draw into buffers of their own.
  const bool buffered = order.size() > 1 && !ren->GetSelector() && !HasRenderPass(vol) &&
    this->Internal->Buffer.Begin(ren);
  for (auto* block : order)
  {
    block->SetJittering(this->UseJittering);
    block->SetShadeByOpacity(this->ShadeByOpacity);
    block->Render(ren, vol, this, { level.Step * distance, level.Image },
      this->Internal->Blocks.GetFeatures());
    if (this->Internal->Blocks.IsStreaming())
    {
      block->ReleaseGraphicsResources(ren->GetRenderWindow());
    }
  }
  if (buffered)
  {
    this->Internal->Buffer.End(ren);
  }
  timer->StopTimer();
  budget.Report(level, timer->GetElapsedTime());
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::Render(vtkRenderer* ren, vtkVolume* vol)
{
  vtkHardwareSelector* selector = ren->GetSelector();
  if (selector && selector->GetFieldAssociation() != vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    // VTK's mapper selects cells only, and would draw its picture among the numbers of points.
    return;
  }
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->Update();
  }
  std::string error;
  const bool ready = this->ChooseRenderer(ren, vol, error) &&
    (this->UsedCPU ? this->PrepareForCPU(error) : this->Prepare(ren, vol, error));
  if (error != this->LastError)
  {
    this->LastError = error;
    if (!error.empty())
    {
      vtkErrorMacro("Combined Volume: " << error);
    }
  }
  const std::string omission = vtkTFCSettingsCheck::FindOmission(this, this->UsedCPU,
    vol->GetProperty()->GetShade() && !this->ShadeByOpacity ? this->ShadingArray : "",
    HasRenderPass(vol) ? this->Internal->Blocks.GetNumberOfDrawableBlocks() : 0);
  if (ready && omission != this->Internal->Omission)
  {
    this->Internal->Omission = omission;
    if (!omission.empty())
    {
      vtkWarningMacro("Combined Volume: " << omission);
    }
  }
  if (ready && this->UsedCPU)
  {
    this->Internal->Fallback.Render(ren, vol, this, this->SampleDistance);
  }
  else if (ready)
  {
    this->RenderBlocks(ren, vol);
  }
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Blocks.ReleaseGraphicsResources(window);
  this->Internal->Buffer.ReleaseGraphicsResources(window);
  this->Internal->Fallback.ReleaseGraphicsResources(window);
  this->Internal->ProbedWindow = nullptr;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TransferFunction: " << this->TransferFunction.Get() << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "LongestTextureSide: " << this->LongestTextureSide << "\n";
  os << indent << "EmptySpaceSkipping: " << this->EmptySpaceSkipping << "\n";
  os << indent << "ShadingArray: " << this->ShadingArray << "\n";
  os << indent << "ShadeByOpacity: " << this->ShadeByOpacity << "\n";
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "UsedCPU: " << this->UsedCPU << "\n";
  os << indent << "LastError: " << this->LastError << "\n";
}
