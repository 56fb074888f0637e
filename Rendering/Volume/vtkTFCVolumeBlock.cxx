// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCVolumeBlock.h"

#include "vtkTFCBrickActivity.h"
#include "vtkTFCBrickDistances.h"
#include "vtkTFCVisibilityOrder.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{

//------------------------------------------------------------------------------
// Continuous point index (from 0 in the packed image) -> texture coordinate t = index * Scale +
// Bias. Texels are points or cells; texture coordinate (n + 0.5) / N is the centre of texel n.
struct TextureAxis
{
  double Scale;
  double Bias;
};

TextureAxis MakeTextureAxis(int numberOfPoints, bool cellData)
{
  if (cellData)
  {
    return { 1.0 / std::max(1, numberOfPoints - 1), 0.0 };
  }
  return { 1.0 / numberOfPoints, 0.5 / numberOfPoints };
}

//------------------------------------------------------------------------------
// Planes given in world coordinates, in texture coordinates of the packed image.
std::vector<std::array<float, 4>> MakeTexturePlanes(vtkPlaneCollection* planes, vtkImageData* image,
  vtkMatrix4x4* volumeMatrix, const TextureAxis axes[3])
{
  vtkNew<vtkMatrix4x4> textureToIndex;
  for (int axis = 0; axis < 3; ++axis)
  {
    textureToIndex->SetElement(axis, axis, 1.0 / axes[axis].Scale);
    textureToIndex->SetElement(axis, 3,
      image->GetExtent()[2 * axis] - axes[axis].Bias / axes[axis].Scale);
  }
  vtkNew<vtkMatrix4x4> textureToWorld;
  vtkMatrix4x4::Multiply4x4(image->GetIndexToPhysicalMatrix(), textureToIndex, textureToWorld);
  vtkMatrix4x4::Multiply4x4(volumeMatrix, textureToWorld, textureToWorld);

  std::vector<std::array<float, 4>> result;
  for (int i = 0; i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    double origin[3];
    double normal[3];
    plane->GetOrigin(origin);
    plane->GetNormal(normal);
    const double world[4] = { normal[0], normal[1], normal[2],
      -(normal[0] * origin[0] + normal[1] * origin[1] + normal[2] * origin[2]) };
    std::array<float, 4> texture;
    for (int column = 0; column < 4; ++column)
    {
      double sum = 0;
      for (int row = 0; row < 4; ++row)
      {
        sum += world[row] * textureToWorld->GetElement(row, column);
      }
      texture[column] = static_cast<float>(sum);
    }
    result.push_back(texture);
  }
  return result;
}

}

//------------------------------------------------------------------------------
bool vtkTFCVolumeBlock::IsCurrent(const vtkTFCImageBlocks::Block& block) const
{
  return this->Drawable && this->Packer.IsCurrent(block.Image);
}

//------------------------------------------------------------------------------
bool vtkTFCVolumeBlock::Pack(const vtkTFCImageBlocks::Block& block,
  const std::vector<vtkTFCAttribute>& attributes, std::string& error)
{
  if (!this->Packer.Update(block.Image, attributes, error))
  {
    return false;
  }
  this->Drawn = block.Drawn;
  this->Drawable = true;
  return true;
}

//------------------------------------------------------------------------------
unsigned int vtkTFCVolumeBlock::Compile(const vtkTFCCompiledModel& model, unsigned int generation,
  bool skipping, unsigned int features)
{
  const bool changed = this->ModelGeneration != generation ||
    this->TablesPackGeneration != this->Packer.GetGeneration();
  if (changed)
  {
    this->Tables = vtkTFCShaderTables::Build(model, this->Packer.GetStored(), features);
    this->ModelGeneration = generation;
    this->TablesPackGeneration = this->Packer.GetGeneration();
    this->Caster->SetTables(this->Tables, ++this->TablesGeneration);
  }
  this->UpdateBricks(model, skipping, changed);
  return features | this->Tables.FeaturesUsed;
}

//------------------------------------------------------------------------------
std::array<int, 3> vtkTFCVolumeBlock::GetTexels() const
{
  std::array<int, 3> texels;
  for (int axis = 0; axis < 3; ++axis)
  {
    texels[axis] = std::max(1,
      this->Packer.GetImage()->GetDimensions()[axis] - (this->Packer.IsCellData() ? 1 : 0));
  }
  return texels;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeBlock::UpdateShading(const vtkTFCImageBlocks::Block& block,
  const std::string& array, std::string& error)
{
  this->Shading.Update(block.Image, array, this->Packer.IsCellData(), this->GetTexels(), error);
}

//------------------------------------------------------------------------------
// Tell the caster where nothing can be visible; `changed`: the model or the data is new.
void vtkTFCVolumeBlock::UpdateBricks(const vtkTFCCompiledModel& model, bool skipping, bool changed)
{
  if (!skipping && (changed || this->Skipping))
  {
    this->Caster->SetBricks({ 0 }, { 1, 1, 1 }, 1); // one active brick
  }
  else if (skipping && (changed || !this->Skipping))
  {
    if (this->RangesPackGeneration != this->Packer.GetGeneration())
    {
      vtkImageData* image = this->Packer.GetImage();
      const bool cells = this->Packer.IsCellData();
      auto* array = vtkFloatArray::SafeDownCast(
        cells ? image->GetCellData()->GetScalars() : image->GetPointData()->GetScalars());
      const std::array<int, 3> texels = this->GetTexels();
      this->Ranges.Compute(array->GetPointer(0), texels, array->GetNumberOfComponents());
      this->MoreRanges = vtkTFCBrickRanges();
      if (vtkFloatArray* more = this->Packer.GetMore())
      {
        this->MoreRanges.Compute(more->GetPointer(0), texels, more->GetNumberOfComponents());
      }
      this->RangesPackGeneration = this->Packer.GetGeneration();
    }
    const auto& dimensions = this->Ranges.GetDimensions();
    this->Caster->SetBricks(
      vtkTFCBrickDistances::Find(
        vtkTFCBrickActivity::Find(this->Ranges, this->MoreRanges, model, this->Packer.GetStored()),
        dimensions),
      dimensions, this->Ranges.GetBrickSize());
  }
  this->Skipping = skipping;
}

//------------------------------------------------------------------------------
// The part of the packed image's extent that this block draws.
std::array<int, 6> vtkTFCVolumeBlock::GetDrawnExtent() const
{
  const int* owned = this->Packer.GetOwnedExtent();
  const int* whole = this->Packer.GetImage()->GetExtent();
  std::array<int, 6> drawn;
  for (int axis = 0; axis < 3; ++axis)
  {
    // The packer has given a single layer a thickness.
    const bool layer = this->Drawn[2 * axis] == this->Drawn[2 * axis + 1];
    const int low = layer ? whole[2 * axis] : this->Drawn[2 * axis];
    const int high = layer ? whole[2 * axis + 1] : this->Drawn[2 * axis + 1];
    drawn[2 * axis] = std::max(owned[2 * axis], low);
    drawn[2 * axis + 1] = std::min(owned[2 * axis + 1], high);
  }
  return drawn;
}

//------------------------------------------------------------------------------
vtkTFCRayCastMapper::Visibility vtkTFCVolumeBlock::FindVisibility(vtkVolumeMapper* mapper,
  vtkVolume* vol) const
{
  vtkImageData* image = this->Packer.GetImage();
  const int* extent = image->GetExtent();
  const std::array<int, 6> owned = this->GetDrawnExtent();
  const int* dimensions = image->GetDimensions();
  TextureAxis axes[3];
  vtkTFCRayCastMapper::Visibility visibility;
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[axis] = MakeTextureAxis(dimensions[axis], this->Packer.IsCellData());
    const auto texture = [&](double index)
    { return static_cast<float>(index * axes[axis].Scale + axes[axis].Bias); };
    visibility.BoxMin[axis] = texture(owned[2 * axis] - extent[2 * axis]);
    visibility.BoxMax[axis] = texture(owned[2 * axis + 1] - extent[2 * axis]);
    if (owned[2 * axis + 1] < extent[2 * axis + 1])
    {
      visibility.UpperMargin[axis] = -1e-6f;
    }

    if (mapper->GetCropping())
    {
      // Planes are positions along the image's own axes: origin + index * spacing.
      double indices[2];
      for (const int side : { 0, 1 })
      {
        const double position = mapper->GetCroppingRegionPlanes()[2 * axis + side];
        indices[side] =
          (position - image->GetOrigin()[axis]) / image->GetSpacing()[axis] - extent[2 * axis];
      }
      visibility.CropMin[axis] = texture(std::min(indices[0], indices[1]));
      visibility.CropMax[axis] = texture(std::max(indices[0], indices[1]));
    }
  }
  if (mapper->GetCropping())
  {
    if (mapper->GetCroppingRegionFlags() == VTK_CROP_SUBVOLUME)
    {
      // The usual case exactly: rays end at the planes instead of at the last sample before them.
      for (int axis = 0; axis < 3; ++axis)
      {
        visibility.BoxMin[axis] = std::max(visibility.BoxMin[axis], visibility.CropMin[axis]);
        visibility.BoxMax[axis] = std::min(visibility.BoxMax[axis], visibility.CropMax[axis]);
      }
    }
    else
    {
      visibility.CropFlags = mapper->GetCroppingRegionFlags();
    }
  }
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkNew<vtkMatrix4x4> volumeMatrix;
    vol->GetModelToWorldMatrix(volumeMatrix);
    visibility.ClippingPlanes = MakeTexturePlanes(planes, image, volumeMatrix, axes);
  }
  if (mapper->GetBlendMode() == vtkVolumeMapper::SLICE_BLEND)
  {
    vtkNew<vtkPlaneCollection> planes;
    planes->AddItem(vtkPlane::SafeDownCast(vol->GetProperty()->GetSliceFunction()));
    vtkNew<vtkMatrix4x4> volumeMatrix;
    vol->GetModelToWorldMatrix(volumeMatrix);
    visibility.SlicePlane = MakeTexturePlanes(planes, image, volumeMatrix, axes).front();
  }
  return visibility;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeBlock::Render(vtkRenderer* ren, vtkVolume* vol, vtkVolumeMapper* mapper,
  const Resolution& resolution, unsigned int features)
{
  this->Caster->SetInputData(this->Packer.GetImage());
  this->Caster->SetScalarMode(
    this->Packer.IsCellData() ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
  this->Caster->SetFeatures(features);
  this->Caster->SetShadingValues(this->Shading.Get());
  this->Caster->SetBlending(mapper->GetBlendMode());
  this->Caster->SetMoreAttributes(this->Packer.GetMore());
  this->Caster->SetVisibility(this->FindVisibility(mapper, vol));
  this->Caster->SetDistances(resolution.SampleDistance,
    vol->GetProperty()->GetScalarOpacityUnitDistance());
  this->Caster->SetPixelSize(resolution.PixelSize);
  this->Caster->Render(ren, vol);
}

//------------------------------------------------------------------------------
double vtkTFCVolumeBlock::GetDefaultSampleDistance() const
{
  const double* spacing = this->Packer.GetImage()->GetSpacing();
  return 0.5 * (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
}

//------------------------------------------------------------------------------
std::array<double, 6> vtkTFCVolumeBlock::GetBounds(vtkMatrix4x4* frame) const
{
  const std::array<int, 6> drawn = this->GetDrawnExtent();
  vtkNew<vtkMatrix4x4> indexToFrame;
  vtkMatrix4x4::Multiply4x4(frame, this->Packer.GetImage()->GetIndexToPhysicalMatrix(),
    indexToFrame);
  vtkBoundingBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { static_cast<double>(drawn[corner & 1]),
      static_cast<double>(drawn[2 + (corner >> 1 & 1)]),
      static_cast<double>(drawn[4 + (corner >> 2 & 1)]), 1.0 };
    indexToFrame->MultiplyPoint(point, point);
    box.AddPoint(point);
  }
  std::array<double, 6> bounds;
  box.GetBounds(bounds.data());
  return bounds;
}

//------------------------------------------------------------------------------
vtkMatrix3x3* vtkTFCVolumeBlock::GetDirection() const
{
  return this->Packer.GetImage()->GetDirectionMatrix();
}

//------------------------------------------------------------------------------
std::vector<vtkTFCVolumeBlock*> vtkTFCVolumeBlock::FindOrder(
  const std::vector<std::unique_ptr<vtkTFCVolumeBlock>>& blocks, vtkRenderer* ren, vtkVolume* vol)
{
  std::vector<vtkTFCVolumeBlock*> drawable;
  for (const auto& block : blocks)
  {
    if (block->IsDrawable())
    {
      drawable.push_back(block.get());
    }
  }
  if (drawable.size() < 2)
  {
    return drawable;
  }
  // Along the axes of the first image: pieces of one image, and most composites, are boxes there.
  vtkNew<vtkMatrix4x4> frame;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      frame->SetElement(i, j, drawable.front()->GetDirection()->GetElement(j, i));
    }
  }
  vtkNew<vtkMatrix4x4> worldToFrame;
  vol->GetModelToWorldMatrix(worldToFrame);
  worldToFrame->Invert();
  vtkMatrix4x4::Multiply4x4(frame, worldToFrame, worldToFrame);
  vtkCamera* camera = ren->GetActiveCamera();
  const bool parallel = camera->GetParallelProjection() != 0;
  double eye[4] = { 0, 0, 0, parallel ? 0.0 : 1.0 };
  std::copy_n(parallel ? camera->GetDirectionOfProjection() : camera->GetPosition(), 3, eye);
  worldToFrame->MultiplyPoint(eye, eye);
  std::vector<vtkTFCVisibilityOrder::Box> boxes;
  boxes.reserve(drawable.size());
  for (const auto* block : drawable)
  {
    boxes.push_back(block->GetBounds(frame));
  }
  std::vector<vtkTFCVolumeBlock*> order;
  for (const int i : vtkTFCVisibilityOrder::Find(boxes, { { eye[0], eye[1], eye[2] }, parallel }))
  {
    order.push_back(drawable[i]);
  }
  return order;
}

//------------------------------------------------------------------------------
vtkIdType vtkTFCVolumeBlock::GetTextureBytes() const
{
  vtkImageData* image = this->Packer.GetImage();
  vtkDataArray* scalars = this->Packer.IsCellData() ? image->GetCellData()->GetScalars()
                                                    : image->GetPointData()->GetScalars();
  return scalars->GetNumberOfValues() * static_cast<vtkIdType>(sizeof(float));
}

//------------------------------------------------------------------------------
void vtkTFCVolumeBlock::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Caster->ReleaseGraphicsResources(window);
}
