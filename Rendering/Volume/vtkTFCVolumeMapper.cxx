// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCVolumeMapper.h"

#include "vtkTFCAttributePacker.h"
#include "vtkTFCBrickActivity.h"
#include "vtkTFCBrickRanges.h"
#include "vtkTFCRayCastMapper.h"
#include "vtkTFCTransferFunction.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
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
std::vector<std::array<float, 4>> MakeClippingPlanes(vtkPlaneCollection* planes,
  vtkImageData* image, vtkMatrix4x4* volumeMatrix, const TextureAxis axes[3])
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
class vtkTFCVolumeMapper::Internals
{
public:
  vtkNew<vtkTFCRayCastMapper> Caster;
  vtkTFCAttributePacker Packer;

  // The model with the axis ranges it was compiled for, and what the tables were made from.
  vtkTFCCompiledModel Model;
  std::array<double, 4> UsedRanges = { 0, 1, 0, 1 };
  vtkMTimeType ModelTime = 0;
  vtkTFCTransferFunction* CompiledFrom = nullptr; // only compared
  unsigned int TablesPackGeneration = 0;
  unsigned int TablesGeneration = 0;
  bool TablesOutdated = true;
  unsigned int Features = 0; // of all tables so far

  vtkTFCBrickRanges Ranges;
  unsigned int RangesPackGeneration = 0;
  bool Skipping = false; // whether the caster was given the distances of bricks

  void UpdateBricks(bool skipping, bool changed);
  bool PackAndCompile(vtkTFCVolumeMapper* mapper, vtkImageData* image, std::string& error);
  vtkTFCRayCastMapper::Visibility FindVisibility(vtkVolumeMapper* mapper, vtkVolume* vol) const;
};

//------------------------------------------------------------------------------
// Bring the compiled model, the packed attributes and the tables up to date. Returns whether there
// is something to draw. A model that does not fit the data is an error and leaves what was drawn
// before in force, as long as the data is the same.
bool vtkTFCVolumeMapper::Internals::PackAndCompile(vtkTFCVolumeMapper* mapper, vtkImageData* image,
  std::string& error)
{
  vtkTFCTransferFunction* model = mapper->TransferFunction;
  if (this->CompiledFrom != model || this->ModelTime != model->GetMTime())
  {
    this->Model = model->Compile(this->UsedRanges.data());
    this->ModelTime = model->GetMTime();
    this->CompiledFrom = model;
    this->TablesOutdated = true;
  }
  if (this->Model.Regions.empty())
  {
    return false;
  }
  if (!model->HasAxes())
  {
    error = "the transfer function has regions but no axes; name a primary and a secondary array.";
  }
  if (!error.empty() || !this->Packer.Update(image, this->Model.Attributes, error))
  {
    return this->TablesGeneration > 0 && this->Packer.IsCurrent(image);
  }

  // Ranges that the model leaves open need the data, hence only now.
  double data[2][2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const vtkTFCStoredAttribute& stored = this->Packer.GetStored()[axis];
    data[axis][0] = mapper->HasAutomaticRanges ? mapper->AutomaticRanges[axis][0] : stored.Offset;
    data[axis][1] =
      mapper->HasAutomaticRanges ? mapper->AutomaticRanges[axis][1] : stored.Offset + stored.Scale;
  }
  std::array<double, 4> used;
  model->ResolveRanges(data[0], data[1], used.data());
  if (used != this->UsedRanges)
  {
    this->UsedRanges = used;
    this->TablesOutdated = true;
  }
  if (this->TablesOutdated || this->TablesPackGeneration != this->Packer.GetGeneration())
  {
    this->Model = model->Compile(used.data());
    ++this->TablesGeneration;
    // What was compiled once stays, so that an edit back and forth builds no shader.
    const auto tables =
      vtkTFCShaderTables::Build(this->Model, this->Packer.GetStored(), this->Features);
    this->Features = tables.FeaturesUsed;
    this->Caster->SetTables(tables, this->TablesGeneration);
    this->TablesPackGeneration = this->Packer.GetGeneration();
    this->TablesOutdated = false;
    this->UpdateBricks(mapper->EmptySpaceSkipping, true);
  }
  this->UpdateBricks(mapper->EmptySpaceSkipping, false);
  return true;
}

//------------------------------------------------------------------------------
// Tell the caster where nothing can be visible; `changed`: the model or the data is new.
void vtkTFCVolumeMapper::Internals::UpdateBricks(bool skipping, bool changed)
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
      std::array<int, 3> texels;
      for (int axis = 0; axis < 3; ++axis)
      {
        texels[axis] = std::max(1, image->GetDimensions()[axis] - (cells ? 1 : 0));
      }
      this->Ranges.Compute(array->GetPointer(0), texels, array->GetNumberOfComponents());
      this->RangesPackGeneration = this->Packer.GetGeneration();
    }
    const auto& dimensions = this->Ranges.GetDimensions();
    this->Caster->SetBricks(
      vtkTFCBrickActivity::FindDistances(
        vtkTFCBrickActivity::Find(this->Ranges, this->Model, this->Packer.GetStored()), dimensions),
      dimensions, this->Ranges.GetBrickSize());
  }
  this->Skipping = skipping;
}

//------------------------------------------------------------------------------
vtkTFCRayCastMapper::Visibility vtkTFCVolumeMapper::Internals::FindVisibility(
  vtkVolumeMapper* mapper, vtkVolume* vol) const
{
  vtkImageData* image = this->Packer.GetImage();
  const int* extent = image->GetExtent();
  const int* owned = this->Packer.GetOwnedExtent();
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
    visibility.ClippingPlanes = MakeClippingPlanes(planes, image, volumeMatrix, axes);
  }
  return visibility;
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
  return this->Internal->Caster->GetNumberOfTableUploads();
}

//------------------------------------------------------------------------------
int vtkTFCVolumeMapper::GetNumberOfVolumeUploads() const
{
  return static_cast<int>(this->Internal->Packer.GetGeneration());
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
bool vtkTFCVolumeMapper::Prepare(vtkRenderer* ren, vtkVolume* vol, std::string& error)
{
  Internals& internal = *this->Internal;
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  auto* image = vtkImageData::SafeDownCast(input);
  if (!image)
  {
    auto* composite = vtkCompositeDataSet::SafeDownCast(input);
    if (input && !(composite && composite->GetNumberOfPoints() == 0))
    {
      error = std::string("cannot render a ") + input->GetClassName() +
        ": the input must be a vtkImageData. The 'Resample To Image' filter makes one.";
    }
    return false;
  }
  if (!this->TransferFunction || image->GetNumberOfPoints() == 0)
  {
    return false;
  }
  if (this->BlendMode != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    error = "only composite blending is available for a combined transfer function.";
    return false;
  }
  if (this->ClippingPlanes &&
    this->ClippingPlanes->GetNumberOfItems() > vtkTFCRayCastMapper::MaximumNumberOfClippingPlanes)
  {
    error = "more than 16 clipping planes.";
    return false;
  }
  if (!internal.PackAndCompile(this, image, error))
  {
    return false;
  }

  vtkTFCRayCastMapper* caster = internal.Caster;
  caster->SetInputData(internal.Packer.GetImage());
  caster->SetScalarMode(
    internal.Packer.IsCellData() ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
  caster->SetVisibility(internal.FindVisibility(this, vol));
  const double* spacing = internal.Packer.GetImage()->GetSpacing();
  const double mean = (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
  caster->SetDistances(this->SampleDistance > 0.0 ? this->SampleDistance : 0.5 * mean,
    vol->GetProperty()->GetScalarOpacityUnitDistance());
  caster->SetInteractive(ren->GetRenderWindow()->GetDesiredUpdateRate() >= 1.0);

  // Both setters do nothing when nothing changes.
  vol->GetProperty()->SetIndependentComponents(0);
  vol->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::Render(vtkRenderer* ren, vtkVolume* vol)
{
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->Update();
  }
  std::string error;
  const bool ready = this->Prepare(ren, vol, error);
  if (error != this->LastError)
  {
    this->LastError = error;
    if (!error.empty())
    {
      vtkErrorMacro("Combined Volume: " << error);
    }
  }
  if (ready)
  {
    this->Internal->Caster->Render(ren, vol);
  }
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Caster->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TransferFunction: " << this->TransferFunction.Get() << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "EmptySpaceSkipping: " << this->EmptySpaceSkipping << "\n";
  os << indent << "LastError: " << this->LastError << "\n";
}
