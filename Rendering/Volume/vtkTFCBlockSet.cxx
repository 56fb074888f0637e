// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCBlockSet.h"

#include "vtkTFCTextureLimit.h"
#include "vtkTFCTransferFunction.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkTFCBlockSet::RemoveBlocks(vtkWindow* window)
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
bool vtkTFCBlockSet::FindBlocks(const Settings& settings, vtkOpenGLRenderWindow* window,
  std::string& error)
{
  vtkTFCImageBlocks::Limits limits;
  limits.LongestSide = settings.LongestTextureSide > 0
    ? settings.LongestTextureSide
    : vtkTFCTextureLimit::FindLongestSide(window);
  const size_t attributes = this->Model.Attributes.size();
  const vtkIdType voxelBytes = (attributes > 4      ? 32
                                   : attributes > 2 ? 16
                                                    : 8) +
    (settings.HasGradients ? 8 : 0);
  const vtkIdType limit = static_cast<vtkIdType>(settings.MemoryLimit) << 20;
  vtkDataObject* input = settings.Input;
  window->MakeCurrent();
  limits.MostVoxels = vtkTFCTextureLimit::FindMostVoxels(window, input, attributes > 2 ? 4 : 2);
  if (limit > 0)
  {
    limits.MostVoxels = std::min(limits.MostVoxels, limit / voxelBytes);
  }
  std::vector<vtkTFCAttribute> arrays = this->Model.Attributes;
  if (!settings.ShadingArray.empty())
  {
    arrays.push_back({ settings.ShadingArray, 0 });
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
std::array<double, 4> vtkTFCBlockSet::ResolveRanges(vtkTFCTransferFunction* model,
  const std::vector<vtkTFCVolumeBlock*>& packed, const AxisRanges* automatic) const
{
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
    if (automatic)
    {
      std::copy((*automatic)[axis].begin(), (*automatic)[axis].end(), data[axis]);
    }
  }
  std::array<double, 4> used;
  model->ResolveRanges(data[0], data[1], used.data());
  return used;
}

//------------------------------------------------------------------------------
bool vtkTFCBlockSet::PackAndCompile(vtkTFCTransferFunction* model, const Settings& settings,
  std::string& error)
{
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
  const auto used = this->ResolveRanges(model, packed, settings.AutomaticRanges);
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
    this->Features = block->Compile(this->Model, this->ModelGeneration, settings.EmptySpaceSkipping,
      this->Features);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCBlockSet::Update(vtkTFCTransferFunction* model, const Settings& settings,
  vtkOpenGLRenderWindow* window, std::string& error)
{
  if (!model)
  {
    return false;
  }
  if (this->CompiledFrom != model || this->ModelTime != model->GetMTime())
  {
    this->Model = model->Compile(this->UsedRanges.data());
    this->ModelTime = model->GetMTime();
    this->CompiledFrom = model;
    this->ModelOutdated = true;
  }
  if (!this->FindBlocks(settings, window, error) || this->Model.Regions.empty() ||
    !this->PackAndCompile(model, settings, error))
  {
    return false;
  }
  for (size_t i = 0; i < this->Blocks.size() && settings.HasGradients; ++i)
  {
    if (this->Blocks[i]->IsDrawable())
    {
      this->Blocks[i]->UpdateShading(this->Images.GetBlocks()[i], settings.ShadingArray, error);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkTFCBlockSet::GetNumberOfDrawableBlocks() const
{
  return static_cast<int>(std::count_if(this->Blocks.begin(), this->Blocks.end(),
    [](const auto& block) { return block->IsDrawable(); }));
}

//------------------------------------------------------------------------------
int vtkTFCBlockSet::GetNumberOfTableUploads() const
{
  int count = this->FormerTableUploads;
  for (const auto& block : this->Blocks)
  {
    count += block->GetNumberOfTableUploads();
  }
  return count;
}

//------------------------------------------------------------------------------
int vtkTFCBlockSet::GetNumberOfVolumeUploads() const
{
  int count = this->FormerVolumeUploads;
  for (const auto& block : this->Blocks)
  {
    count += block->GetNumberOfVolumeUploads();
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkTFCBlockSet::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& block : this->Blocks)
  {
    block->ReleaseGraphicsResources(window);
  }
}
