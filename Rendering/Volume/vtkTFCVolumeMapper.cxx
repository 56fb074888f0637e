// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCVolumeMapper.h"

#include "vtkTFCFallbackRenderer.h"
#include "vtkTFCGraphicsSupport.h"
#include "vtkTFCImageBlocks.h"
#include "vtkTFCSettingsCheck.h"
#include "vtkTFCTextureLimit.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTFCVolumeBlock.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

//------------------------------------------------------------------------------
class vtkTFCVolumeMapper::Internals
{
public:
  vtkTFCImageBlocks Images;
  std::vector<std::unique_ptr<vtkTFCVolumeBlock>> Blocks;
  bool Streaming = false; // textures do not fit into the memory limit at a time
  vtkTFCFallbackRenderer Fallback;
  vtkRenderWindow* ProbedWindow = nullptr; // only compared
  std::string Missing;                     // of its OpenGL
  std::string WarnedOf;
  std::string Omission; // from the picture, as last told

  // The model with the axis ranges it was compiled for.
  vtkTFCCompiledModel Model;
  std::array<double, 4> UsedRanges = { 0, 1, 0, 1 };
  vtkMTimeType ModelTime = 0;
  vtkTFCTransferFunction* CompiledFrom = nullptr; // only compared
  unsigned int ModelGeneration = 0;
  unsigned int ImagesGeneration = 0;
  bool ModelOutdated = true;
  unsigned int Features = 0;  // of all tables so far
  int FormerTableUploads = 0; // of blocks that are gone
  int FormerVolumeUploads = 0;

  bool UpdateBlocks(vtkTFCVolumeMapper* mapper, vtkRenderer* ren, vtkVolume* vol,
    std::string& error);
  bool PackAndCompile(vtkTFCVolumeMapper* mapper, std::string& error);
  void RemoveBlocks(vtkWindow* window);
};

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::Internals::RemoveBlocks(vtkWindow* window)
{
  for (auto& block : this->Blocks)
  {
    this->FormerTableUploads += block->GetNumberOfTableUploads();
    this->FormerVolumeUploads += block->GetNumberOfVolumeUploads();
    block->ReleaseGraphicsResources(window);
  }
  this->Blocks.clear();
}

//------------------------------------------------------------------------------
// Find the images to draw. Returns whether there are any.
bool vtkTFCVolumeMapper::Internals::UpdateBlocks(vtkTFCVolumeMapper* mapper, vtkRenderer* ren,
  vtkVolume* vol, std::string& error)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkTFCImageBlocks::Limits limits;
  limits.LongestSide = mapper->LongestTextureSide > 0 ? mapper->LongestTextureSide
                                                      : vtkTFCTextureLimit::FindLongestSide(window);
  const size_t attributes = this->Model.Attributes.size();
  const vtkIdType voxelBytes = (attributes > 4      ? 32
                                   : attributes > 2 ? 16
                                                    : 8) +
    (vol->GetProperty()->GetShade() ? 8 : 0);
  const vtkIdType limit = static_cast<vtkIdType>(mapper->MemoryLimit) << 20;
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  window->MakeCurrent();
  limits.MostVoxels = vtkTFCTextureLimit::FindMostVoxels(window, input, attributes > 2 ? 4 : 2);
  if (limit > 0)
  {
    limits.MostVoxels = std::min(limits.MostVoxels, limit / voxelBytes);
  }
  std::vector<vtkTFCAttribute> arrays = this->Model.Attributes;
  if (!mapper->ShadingArray.empty())
  {
    arrays.push_back({ mapper->ShadingArray, 0 });
  }
  const auto& images = this->Images.Update(input, arrays, limits, error);
  if (this->ImagesGeneration != this->Images.GetGeneration())
  {
    this->ImagesGeneration = this->Images.GetGeneration();
    // One image for another keeps its block, with what it drew last.
    if (this->Blocks.size() != images.size())
    {
      this->RemoveBlocks(window);
      for (size_t i = 0; i < images.size(); ++i)
      {
        this->Blocks.push_back(std::make_unique<vtkTFCVolumeBlock>());
      }
    }
    vtkIdType bytes = 0;
    for (const auto& image : images)
    {
      bytes += image.Image->GetNumberOfPoints() * voxelBytes;
    }
    this->Streaming = limit > 0 && bytes > limit;
  }
  return !images.empty();
}

//------------------------------------------------------------------------------
// Bring the packed attributes and the tables up to date. Returns whether there is something to
// draw. A model that does not fit the data is an error and leaves what was drawn before in force,
// as long as the data is the same.
bool vtkTFCVolumeMapper::Internals::PackAndCompile(vtkTFCVolumeMapper* mapper, std::string& error)
{
  vtkTFCTransferFunction* model = mapper->TransferFunction;
  const auto& images = this->Images.GetBlocks();
  std::vector<vtkTFCVolumeBlock*> packed;
  std::string refused;
  for (size_t i = 0; i < images.size() && model->HasAxes(); ++i)
  {
    std::string reason;
    if (this->Blocks[i]->Pack(images[i], this->Model.Attributes, reason))
    {
      packed.push_back(this->Blocks[i].get());
    }
    else if (refused.empty())
    {
      refused = reason;
    }
  }
  if (packed.empty())
  {
    error = model->HasAxes()
      ? refused
      : "the transfer function has regions but no axes; name a primary and a secondary array.";
    return this->ModelGeneration > 0 &&
      std::all_of(images.begin(), images.end(),
        [&, i = size_t(0)](const auto& image) mutable
        { return this->Blocks[i++]->IsCurrent(image); });
  }
  // Arrays may be missing in some blocks of a composite dataset: nothing to see there.
  for (auto& block : this->Blocks)
  {
    block->SetDrawable(std::find(packed.begin(), packed.end(), block.get()) != packed.end());
  }

  // Ranges that the model leaves open need the data, hence only now.
  double data[2][2];
  for (int axis = 0; axis < 2; ++axis)
  {
    data[axis][0] = VTK_DOUBLE_MAX;
    data[axis][1] = -VTK_DOUBLE_MAX;
    for (const auto* block : packed)
    {
      const auto range = block->GetRange(axis);
      if (range[0] <= range[1])
      {
        const bool first = data[axis][0] > data[axis][1];
        data[axis][0] = first ? range[0] : std::min(data[axis][0], range[0]);
        data[axis][1] = first ? range[1] : std::max(data[axis][1], range[1]);
      }
    }
    if (mapper->HasAutomaticRanges)
    {
      std::copy(mapper->AutomaticRanges[axis], mapper->AutomaticRanges[axis] + 2, data[axis]);
    }
  }
  std::array<double, 4> used;
  model->ResolveRanges(data[0], data[1], used.data());
  if (this->ModelOutdated || used != this->UsedRanges)
  {
    this->UsedRanges = used;
    this->Model = model->Compile(used.data());
    ++this->ModelGeneration;
    this->ModelOutdated = false;
  }
  for (auto* block : packed)
  {
    // What was compiled once stays, so that an edit back and forth builds no shader.
    this->Features = block->Compile(this->Model, this->ModelGeneration, mapper->EmptySpaceSkipping,
      this->Features);
  }
  return true;
}

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
  std::copy(primary, primary + 2, this->AutomaticRanges[0]);
  std::copy(secondary, secondary + 2, this->AutomaticRanges[1]);
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
  int count = this->Internal->FormerTableUploads;
  for (const auto& block : this->Internal->Blocks)
  {
    count += block->GetNumberOfTableUploads();
  }
  return count;
}

//------------------------------------------------------------------------------
int vtkTFCVolumeMapper::GetNumberOfVolumeUploads() const
{
  int count = this->Internal->FormerVolumeUploads;
  for (const auto& block : this->Internal->Blocks)
  {
    count += block->GetNumberOfVolumeUploads();
  }
  return count;
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
  const auto& images = this->Internal->Images.Update(this->GetInputDataObject(0, 0),
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
  vtkTFCFallbackRenderer::AxisRanges ranges;
  std::copy_n(&this->AutomaticRanges[0][0], 4, &ranges[0][0]);
  return this->Internal->Fallback.Update(images.front(), model,
    this->HasAutomaticRanges ? &ranges : nullptr, error);
}

//------------------------------------------------------------------------------
bool vtkTFCVolumeMapper::Prepare(vtkRenderer* ren, vtkVolume* vol, std::string& error)
{
  Internals& internal = *this->Internal;
  vtkTFCTransferFunction* model = this->TransferFunction;
  if (!model)
  {
    return false;
  }
  if (internal.CompiledFrom != model || internal.ModelTime != model->GetMTime())
  {
    internal.Model = model->Compile(internal.UsedRanges.data());
    internal.ModelTime = model->GetMTime();
    internal.CompiledFrom = model;
    internal.ModelOutdated = true;
  }
  const bool hasImages = internal.UpdateBlocks(this, ren, vol, error);
  if (!hasImages || internal.Model.Regions.empty())
  {
    return false;
  }
  const bool packed = internal.PackAndCompile(this, error);
  const auto blocks = std::count_if(internal.Blocks.begin(), internal.Blocks.end(),
    [](const auto& block) { return block->IsDrawable(); });
  const std::string unsupported =
    vtkTFCSettingsCheck::FindError(this, static_cast<int>(blocks), this->Distributed);
  if (!packed || !unsupported.empty())
  {
    error = packed ? unsupported : error;
    return false;
  }
  for (size_t i = 0; i < internal.Blocks.size() && vol->GetProperty()->GetShade(); ++i)
  {
    if (internal.Blocks[i]->IsDrawable())
    {
      internal.Blocks[i]->UpdateShading(internal.Images.GetBlocks()[i], this->ShadingArray, error);
    }
  }
  // Both setters do nothing when nothing changes.
  vol->GetProperty()->SetIndependentComponents(0);
  vol->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::RenderBlocks(vtkRenderer* ren, vtkVolume* vol)
{
  const auto order = vtkTFCVolumeBlock::FindOrder(this->Internal->Blocks, ren, vol);
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
  for (auto* block : order)
  {
    block->SetJittering(this->UseJittering);
    block->Render(ren, vol, this, distance, this->Internal->Features);
    if (this->Internal->Streaming)
    {
      block->ReleaseGraphicsResources(ren->GetRenderWindow());
    }
  }
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::Render(vtkRenderer* ren, vtkVolume* vol)
{
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
    vol->GetProperty()->GetShade() ? this->ShadingArray : "");
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
  for (auto& block : this->Internal->Blocks)
  {
    block->ReleaseGraphicsResources(window);
  }
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
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "UsedCPU: " << this->UsedCPU << "\n";
  os << indent << "LastError: " << this->LastError << "\n";
}
