// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCFallbackRenderer.h"

#include "vtkTFCAttributePacker.h"
#include "vtkTFCAttributeReader.h"
#include "vtkTFCClassifier.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCThreads.h"
#include "vtkTFCTransferFunction.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeRayCastSpaceLeapingImageFilter.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

using Size = std::array<int, 3>;

//------------------------------------------------------------------------------
// Visit every row along x of a lattice on several threads: visit(first point of the row, y, z).
template <typename Visit>
void ForRows(const Size& size, const Visit& visit)
{
  vtkTFCThreads::For(0, static_cast<vtkIdType>(size[1]) * size[2], 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        visit(row * size[0], static_cast<int>(row % size[1]), static_cast<int>(row / size[1]));
      }
    });
}

//------------------------------------------------------------------------------
std::vector<float> ClassifyPoints(const vtkTFCAttributeReader& reader,
  const vtkTFCClassifier& classifier)
{
  const vtkIdType total = reader.GetNumberOfTuples();
  const size_t attributes = classifier.GetModel().Attributes.size();
  std::vector<float> rgba(4 * total);
  vtkTFCThreads::For(0, total, 16384,
    [&](vtkIdType begin, vtkIdType end)
    {
      constexpr vtkIdType chunk = 2048;
      std::vector<double> scratch(attributes * chunk);
      std::vector<const double*> pointers(attributes);
      for (size_t a = 0; a < attributes; ++a)
      {
        pointers[a] = scratch.data() + a * chunk;
      }
      for (vtkIdType first = begin; first < end; first += chunk)
      {
        const vtkIdType count = std::min(chunk, end - first);
        reader.ReadAll(first, count, chunk, scratch.data());
        classifier.Classify(static_cast<size_t>(count), pointers.data(), rgba.data() + 4 * first);
      }
    });
  return rgba;
}

//------------------------------------------------------------------------------
// Corners of blanked cells become transparent.
void HideCells(vtkUnsignedCharArray* ghosts, const Size& size, std::vector<float>& rgba)
{
  const Size cells = { std::max(1, size[0] - 1), std::max(1, size[1] - 1),
    std::max(1, size[2] - 1) };
  const auto hidden = [&](int x, int y, int z)
  {
    return x >= 0 && y >= 0 && z >= 0 && x < cells[0] && y < cells[1] && z < cells[2] &&
      (ghosts->GetValue(
         x + static_cast<vtkIdType>(cells[0]) * (y + static_cast<vtkIdType>(cells[1]) * z)) &
        vtkDataSetAttributes::HIDDENCELL) != 0;
  };
  ForRows(size,
    [&](vtkIdType first, int y, int z)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        bool hide = false;
        for (int corner = 0; corner < 8; ++corner)
        {
          hide = hide || hidden(x - (corner & 1), y - (corner >> 1 & 1), z - (corner >> 2));
        }
        if (hide)
        {
          std::fill_n(rgba.data() + 4 * (first + x), 4, 0.0f);
        }
      }
    });
}

//------------------------------------------------------------------------------
// Mean colour of the visible neighbours of a point, weighted by opacity; black where there is none.
std::array<float, 3> FindNeighbourColor(const std::vector<float>& rgba, const Size& size, int x,
  int y, int z)
{
  std::array<float, 3> sum = { 0, 0, 0 };
  float weight = 0;
  for (int k = std::max(0, z - 1); k <= std::min(size[2] - 1, z + 1); ++k)
  {
    for (int j = std::max(0, y - 1); j <= std::min(size[1] - 1, y + 1); ++j)
    {
      for (int i = std::max(0, x - 1); i <= std::min(size[0] - 1, x + 1); ++i)
      {
        const float* point = rgba.data() +
          4 * (i + static_cast<vtkIdType>(size[0]) * (j + static_cast<vtkIdType>(size[1]) * k));
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += point[3] * point[c];
        }
        weight += point[3];
      }
    }
  }
  for (float& channel : sum)
  {
    channel = weight > 0.0f ? channel / weight : 0.0f;
  }
  return sum;
}

//------------------------------------------------------------------------------
unsigned char ToByte(float value)
{
  return static_cast<unsigned char>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

//------------------------------------------------------------------------------
// The axes of an image in the world: columns are steps of one index, and the place of index 0 0 0.
void MakeIndexToWorld(vtkVolume* vol, vtkImageData* image, vtkMatrix4x4* indexToWorld)
{
  vol->GetModelToWorldMatrix(indexToWorld);
  vtkMatrix4x4::Multiply4x4(indexToWorld, image->GetIndexToPhysicalMatrix(), indexToWorld);
}

}

//------------------------------------------------------------------------------
// VTK's search for empty space starts all threads but the first at the wrong voxel when components
// are dependent, and drops parts of the volume (ComputeOffset() in
// https://gitlab.kitware.com/vtk/vtk/-/blob/master/Rendering/Volume/vtkVolumeRayCastSpaceLeapingImageFilter.cxx,
// up to and including VTK 9.5), so it gets one thread.
class vtkTFCFallbackRenderer::RayCaster : public vtkFixedPointVolumeRayCastMapper
{
public:
  static RayCaster* New();
  vtkTypeMacro(RayCaster, vtkFixedPointVolumeRayCastMapper);

protected:
  RayCaster()
  {
    this->SpaceLeapFilter->SetEnableSMP(false);
    this->SpaceLeapFilter->SetNumberOfThreads(1);
  }
};

vtkStandardNewMacro(vtkTFCFallbackRenderer::RayCaster);

//------------------------------------------------------------------------------
vtkTFCFallbackRenderer::vtkTFCFallbackRenderer()
  : Caster(vtk::TakeSmartPointer(RayCaster::New()))
{
  this->Caster->IntermixIntersectingGeometryOn();
  this->Caster->AutoAdjustSampleDistancesOff();
  this->Volume->SetMapper(this->Caster);
}

//------------------------------------------------------------------------------
vtkTFCFallbackRenderer::~vtkTFCFallbackRenderer() = default;

//------------------------------------------------------------------------------
bool vtkTFCFallbackRenderer::Update(const vtkTFCImageBlocks::Block& block,
  vtkTFCTransferFunction* model, const AxisRanges* ranges, std::string& error)
{
  const auto makeFingerprint = [&](const std::vector<vtkTFCAttribute>& attributes)
  {
    std::ostringstream key;
    key.precision(17);
    key << vtkTFCAttributePacker::MakeFingerprint(block.Image, attributes);
    for (const int i : block.Drawn)
    {
      key << i << ' ';
    }
    for (int i = 0; ranges && i < 4; ++i)
    {
      key << (*ranges)[i / 2][i % 2] << ' ';
    }
    return key.str();
  };
  const std::vector<vtkTFCAttribute> attributes = model->GetAttributes();
  const std::string fingerprint = makeFingerprint(attributes);
  if (this->Image && this->Model == model && this->ModelTime == model->GetMTime() &&
    this->Fingerprint == fingerprint)
  {
    return true;
  }
  if (!this->Classify(block.Image, block.Drawn, model, ranges, error))
  {
    return this->Image && this->Fingerprint == makeFingerprint(this->Attributes);
  }
  this->Model = model;
  this->ModelTime = model->GetMTime();
  this->Attributes = attributes;
  this->Fingerprint = fingerprint;
  ++this->Classifications;
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCFallbackRenderer::Classify(vtkImageData* source, const std::array<int, 6>& drawn,
  vtkTFCTransferFunction* model, const AxisRanges* ranges, std::string& error)
{
  if (!model->HasAxes())
  {
    error = "the transfer function has regions but no axes; name a primary and a secondary array.";
    return false;
  }
  vtkSmartPointer<vtkDataSet> points = source;
  vtkTFCAttributeReader reader;
  if (!reader.Bind(source, model->GetAttributes(), error))
  {
    return false;
  }
  double data[2][2];
  for (int axis = 0; axis < 2; ++axis)
  {
    reader.FiniteRange(axis, data[axis]);
    if (ranges)
    {
      std::copy_n((*ranges)[axis].data(), 2, data[axis]);
    }
  }
  if (reader.GetAssociation() == vtkDataObject::CELL)
  {
    vtkNew<vtkCellDataToPointData> average;
    average->SetInputData(source);
    average->Update();
    points = vtkDataSet::SafeDownCast(average->GetOutput());
    if (!reader.Bind(points, model->GetAttributes(), error))
    {
      return false;
    }
  }
  double used[4];
  model->ResolveRanges(data[0], data[1], used);
  const vtkTFCClassifier classifier(model->Compile(used));
  std::vector<float> rgba = ClassifyPoints(reader, classifier);
  const Size whole = { source->GetDimensions()[0], source->GetDimensions()[1],
    source->GetDimensions()[2] };
  if (source->GetCellGhostArray())
  {
    HideCells(source->GetCellGhostArray(), whole, rgba);
  }

  // Without a controller: what this block holds besides ghosts needs nobody else.
  const vtkTFCDistributedImage block(source, vtkDataObject::FIELD_ASSOCIATION_POINTS, nullptr);
  Size size;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int low = std::max(drawn[2 * axis], block.GetInnerExtent()[2 * axis]);
    const int high = std::min(drawn[2 * axis + 1], block.GetInnerExtent()[2 * axis + 1]);
    this->First[axis] = low;
    this->Flat[axis] = whole[axis] == 1;
    size[axis] = this->Flat[axis] ? 2 : std::max(1, high - low + 1);
  }
  float largest = 0;
  for (size_t i = 3; i < rgba.size(); i += 4)
  {
    largest = std::max(largest, rgba[i]);
  }
  this->LargestOpacity = largest > 0.0f ? largest : 1.0;

  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName("tfc_rgba");
  bytes->SetNumberOfComponents(4);
  bytes->SetNumberOfTuples(static_cast<vtkIdType>(size[0]) * size[1] * size[2]);
  const int* extent = source->GetExtent();
  ForRows(size,
    [&](vtkIdType first, int y, int z)
    {
      unsigned char* to = bytes->GetPointer(4 * first);
      for (int x = 0; x < size[0]; ++x, to += 4)
      {
        const Size at = { x, y, z };
        Size from;
        for (int axis = 0; axis < 3; ++axis)
        {
          from[axis] = this->Flat[axis] ? 0 : this->First[axis] - extent[2 * axis] + at[axis];
        }
        const float* point = rgba.data() +
          4 *
            (from[0] +
              static_cast<vtkIdType>(whole[0]) *
                (from[1] + static_cast<vtkIdType>(whole[1]) * from[2]));
        const std::array<float, 3> color = point[3] > 0.0f
          ? std::array<float, 3>{ point[0], point[1], point[2] }
          : FindNeighbourColor(rgba, whole, from[0], from[1], from[2]);
        std::transform(color.begin(), color.end(), to, ToByte);
        to[3] = ToByte(static_cast<float>(std::sqrt(point[3] / this->LargestOpacity)));
      }
    });
  this->Source = source;
  this->Image = vtkSmartPointer<vtkImageData>::New();
  this->Image->SetDimensions(size.data());
  this->Image->GetPointData()->SetScalars(bytes);
  return true;
}

//------------------------------------------------------------------------------
// VTK's caster knows no direction matrix, and takes lengths along the axes of the image as world
// lengths. So the image gets the length of its steps in the world as spacing, and the volume the
// rest.
void vtkTFCFallbackRenderer::PlaceVolume(vtkVolume* vol)
{
  vtkNew<vtkMatrix4x4> indexToWorld;
  MakeIndexToWorld(vol, this->Source, indexToWorld);
  double first[4] = { 0, 0, 0, 1 };
  std::array<double, 3> spacing;
  vtkNew<vtkMatrix4x4> place;
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = this->First[axis] - (this->Flat[axis] ? 0.5 : 0.0);
    double sum = 0;
    for (int i = 0; i < 3; ++i)
    {
      sum += indexToWorld->GetElement(i, axis) * indexToWorld->GetElement(i, axis);
    }
    spacing[axis] = sum > 0.0 ? std::sqrt(sum) : 1.0;
    for (int i = 0; i < 3; ++i)
    {
      place->SetElement(i, axis, indexToWorld->GetElement(i, axis) / spacing[axis]);
    }
  }
  indexToWorld->MultiplyPoint(first, first);
  for (int i = 0; i < 3; ++i)
  {
    place->SetElement(i, 3, first[i]);
  }
  this->Image->SetSpacing(spacing.data()); // does nothing when they are the same
  this->Volume->SetUserMatrix(place);
}

//------------------------------------------------------------------------------
void vtkTFCFallbackRenderer::SetProperty(vtkVolume* vol, double sampleDistance)
{
  const vtkVolumeProperty* given = vol->GetProperty();
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetIndependentComponents(0);
  auto* from = const_cast<vtkVolumeProperty*>(given); // VTK's getters are not const
  property->SetInterpolationType(from->GetInterpolationType() == VTK_NEAREST_INTERPOLATION
      ? VTK_NEAREST_INTERPOLATION
      : VTK_LINEAR_INTERPOLATION);
  property->SetShade(from->GetShade());
  property->SetAmbient(from->GetAmbient());
  property->SetDiffuse(from->GetDiffuse());
  property->SetSpecular(from->GetSpecular());
  property->SetSpecularPower(from->GetSpecularPower());

  const double unit = from->GetScalarOpacityUnitDistance();
  const std::array<double, 3> key = { this->LargestOpacity, sampleDistance, unit };
  if (key == this->TabulatedOpacity)
  {
    return;
  }
  this->TabulatedOpacity = key;
  // Per sample: VTK's own correction leaves out opacities up to 0.0001 per unit distance.
  vtkNew<vtkPiecewiseFunction> opacity;
  for (int byte = 0; byte < 256; ++byte)
  {
    const double alpha = std::min(1.0, this->LargestOpacity * byte * byte / (255.0 * 255.0));
    opacity->AddPoint(byte, 1.0 - std::pow(1.0 - alpha, sampleDistance / unit));
  }
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(sampleDistance);
}

//------------------------------------------------------------------------------
// Cropping planes are positions along the axes of the source image: origin + index * spacing.
void vtkTFCFallbackRenderer::SetCropping(vtkVolumeMapper* settings)
{
  this->Caster->SetCropping(settings->GetCropping());
  this->Caster->SetCroppingRegionFlags(settings->GetCroppingRegionFlags());
  double planes[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    double ends[2];
    for (const int side : { 0, 1 })
    {
      const double index =
        (settings->GetCroppingRegionPlanes()[2 * axis + side] - this->Source->GetOrigin()[axis]) /
        this->Source->GetSpacing()[axis];
      ends[side] = (index - this->First[axis] + (this->Flat[axis] ? 0.5 : 0.0)) *
        this->Image->GetSpacing()[axis];
    }
    planes[2 * axis] = std::min(ends[0], ends[1]);
    planes[2 * axis + 1] = std::max(ends[0], ends[1]);
  }
  this->Caster->SetCroppingRegionPlanes(planes);
}

//------------------------------------------------------------------------------
void vtkTFCFallbackRenderer::Render(vtkRenderer* ren, vtkVolume* vol, vtkVolumeMapper* settings,
  double sampleDistance)
{
  if (!this->Image)
  {
    return;
  }
  this->PlaceVolume(vol);
  const double* spacing = this->Image->GetSpacing();
  const double distance =
    sampleDistance > 0.0 ? sampleDistance : (spacing[0] + spacing[1] + spacing[2]) / 6.0;
  this->SetProperty(vol, distance);
  this->SetCropping(settings);
  this->Caster->SetClippingPlanes(settings->GetClippingPlanes());
  this->Caster->SetSampleDistance(static_cast<float>(distance));
  this->Caster->SetInteractiveSampleDistance(static_cast<float>(2.0 * distance));
  const bool interactive = ren->GetRenderWindow()->GetDesiredUpdateRate() >= 1.0;
  this->Caster->SetAutoAdjustSampleDistances(interactive);
  if (!interactive)
  {
    this->Caster->SetImageSampleDistance(1.0f);
  }
  this->Caster->SetInputData(this->Image);
  this->Volume->SetAllocatedRenderTime(vol->GetAllocatedRenderTime(), ren);
  this->Caster->Render(ren, this->Volume);
}

//------------------------------------------------------------------------------
void vtkTFCFallbackRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Volume->ReleaseGraphicsResources(window);
  this->TabulatedOpacity = { 0, 0, 0 };
}
