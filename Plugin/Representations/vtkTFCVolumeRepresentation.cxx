// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCVolumeRepresentation.h"

#include "vtkTFCAttributeReader.h"
#include "vtkTFCCompiledModel.h"
#include "vtkTFCLegendItem.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTFCVolumeMapper.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
// The piece of the view's data, after those of the base class, that holds the automatic ranges.
constexpr int RANGES_PORT = 2;
const char* const RANGES_ARRAY = "AutomaticRanges";

//------------------------------------------------------------------------------
// The image and rectilinear grids in `data` as images, which share their arrays; the geometry of
// grids is lost.
std::vector<vtkSmartPointer<vtkImageData>> CollectLattices(vtkDataObject* data)
{
  std::vector<vtkDataSet*> parts;
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    parts = vtkCompositeDataSet::GetDataSets<vtkDataSet>(data);
  }
  else if (auto* part = vtkDataSet::SafeDownCast(data))
  {
    parts = { part };
  }
  std::vector<vtkSmartPointer<vtkImageData>> lattices;
  for (vtkDataSet* part : parts)
  {
    if (auto* image = vtkImageData::SafeDownCast(part))
    {
      lattices.push_back(image);
    }
    else if (auto* grid = vtkRectilinearGrid::SafeDownCast(part))
    {
      auto lattice = vtkSmartPointer<vtkImageData>::New();
      lattice->SetExtent(grid->GetExtent());
      lattice->GetPointData()->ShallowCopy(grid->GetPointData());
      lattice->GetCellData()->ShallowCopy(grid->GetCellData());
      lattices.push_back(lattice);
    }
  }
  return lattices;
}

}

vtkStandardNewMacro(vtkTFCVolumeRepresentation);

//------------------------------------------------------------------------------
vtkTFCVolumeRepresentation::vtkTFCVolumeRepresentation()
{
  auto mapper = vtkSmartPointer<vtkTFCVolumeMapper>::New();
  mapper->SetTransferFunction(this->Model);
  this->VolumeMapper = mapper;
  this->Legend->SetTransferFunction(this->Model);
  this->LegendActor->GetScene()->AddItem(this->Legend);
  this->LegendActor->PickableOff();
  this->UpdateLegendVisibility();
  this->Property->SetIndependentComponents(0);
  this->Property->SetInterpolationTypeToLinear();
}

//------------------------------------------------------------------------------
vtkTFCVolumeRepresentation::~vtkTFCVolumeRepresentation() = default;

//------------------------------------------------------------------------------
vtkTFCVolumeMapper* vtkTFCVolumeRepresentation::GetMapper()
{
  return static_cast<vtkTFCVolumeMapper*>(this->VolumeMapper.Get());
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetTransferFunction(const char* state)
{
  // Without MarkModified(): the data do not depend on the model. But the automatic ranges do, and
  // the view delivers them only together with modified data.
  this->Model->SetState(state);
  const auto axes = this->FindAutomaticAxes();
  if (!axes.empty() && axes != this->RangedAxes)
  {
    this->MarkModified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetHighlightedRegion(int id)
{
  this->Model->SetHighlightedRegion(id);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetSampleDistance(double distance)
{
  this->GetMapper()->SetSampleDistance(distance);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetMemoryLimit(int megabytes)
{
  this->GetMapper()->SetMemoryLimit(megabytes);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetRenderer(int renderer)
{
  this->GetMapper()->SetRenderer(renderer);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetUseJittering(bool jittering)
{
  this->GetMapper()->SetUseJittering(jittering);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetShadingArray(const char* name)
{
  this->GetMapper()->SetShadingArray(name);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetShadeByOpacity(bool byOpacity)
{
  this->GetMapper()->SetShadeByOpacity(byOpacity);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetRayBlending(int mode)
{
  this->RayBlending = mode;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetBlendMode(int mode)
{
  this->SharedBlendMode = mode;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetSlicePlane(vtkImplicitFunction* plane)
{
  this->SlicePlane = plane;
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetCroppingRegionFlags(int flags)
{
  this->VolumeMapper->SetCroppingRegionFlags(flags);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetLegendVisibility(bool visible)
{
  this->LegendVisibility = visible;
  this->UpdateLegendVisibility();
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->UpdateLegendVisibility();
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::UpdateLegendVisibility()
{
  this->LegendActor->SetVisibility(this->GetVisibility() && this->LegendVisibility);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetLegendLocation(int location)
{
  this->Legend->SetLocation(location);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetLegendPosition(double x, double y)
{
  this->Legend->SetPosition(x, y);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetLegendSize(double width, double height)
{
  this->Legend->SetSize(width, height);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetLegendTextColor(double red, double green, double blue)
{
  this->Legend->SetTextColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::SetLegendFontSize(int points)
{
  this->Legend->SetFontSize(points);
}

//------------------------------------------------------------------------------
bool vtkTFCVolumeRepresentation::AddToView(vtkView* view)
{
  if (auto* rview = vtkPVRenderView::SafeDownCast(view))
  {
    // Where annotations are: drawn on the client, over what the ranks composite.
    rview->GetNonCompositedRenderer()->AddActor(this->LegendActor);
    this->LegendActor->GetScene()->SetRenderer(rview->GetNonCompositedRenderer());
  }
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkTFCVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* rview = vtkPVRenderView::SafeDownCast(view))
  {
    rview->GetNonCompositedRenderer()->RemoveActor(this->LegendActor);
  }
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
int vtkTFCVolumeRepresentation::ProcessViewRequest(vtkInformationRequestKey* request,
  vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->UpdateAutomaticRanges();
    vtkPVView::SetPiece(inInfo, this, this->AutomaticRanges, 0, RANGES_PORT);
    vtkPVRenderView::SetDeliverToClientAndRenderingProcesses(inInfo, this,
      /*deliver_to_client=*/true, /*gather_before_delivery=*/false, RANGES_PORT);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->UseAutomaticRanges(vtkPVView::GetDeliveredPiece(inInfo, this, RANGES_PORT));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCVolumeRepresentation::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Superclass::RequestUpdateExtent(request, inputVector, outputVector))
  {
    return 0;
  }
  for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputVector[0]->GetInformationObject(i);
    if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
    {
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 1);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkTFCVolumeRepresentation::RequestData(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Superclass::RequestData(request, inputVector, outputVector))
  {
    return 0;
  }
  this->DataTime.Modified();
  if (vtkImageData* input = vtkImageData::GetData(inputVector[0], 0))
  {
    // The base class cropped the ghost cells off its copy, and with it set the bounds that order
    // the ranks: those stay. The mapper gets them all and draws its own part.
    this->Cache = vtk::TakeSmartPointer(input->NewInstance());
    this->Cache->ShallowCopy(input);
    this->VolumeMapper->SetInputData(vtkImageData::SafeDownCast(this->Cache));
  }
  return 1;
}

//------------------------------------------------------------------------------
// Both axes when one of them has no range in the model and something is to be drawn, else none.
std::vector<vtkTFCAttribute> vtkTFCVolumeRepresentation::FindAutomaticAxes()
{
  if (this->Model->GetNumberOfRegions() == 0 ||
    (this->Model->HasAxisRange(vtkTFCTransferFunction::Primary) &&
      this->Model->HasAxisRange(vtkTFCTransferFunction::Secondary)))
  {
    return {};
  }
  vtkTFCCompiledModel model = this->Model->Compile();
  model.Attributes.resize(2);
  return model.Attributes;
}

//------------------------------------------------------------------------------
// Axes without a range in the model run over the finite values on all ranks. View requests reach
// all processes in the same order with the same model, so the reduction is collective.
void vtkTFCVolumeRepresentation::UpdateAutomaticRanges()
{
  const auto axes = this->FindAutomaticAxes();
  // An edit of a region must not cost a pass over the data.
  if (axes == this->RangedAxes && (axes.empty() || this->RangesTime == this->DataTime.GetMTime()))
  {
    return;
  }
  this->RangesTime = this->DataTime.GetMTime();
  this->RangedAxes = axes;
  this->AutomaticRanges->Initialize();
  if (axes.empty())
  {
    return;
  }

  // Minima as they are, maxima negated: one reduction.
  double local[4];
  std::fill(local, local + 4, std::numeric_limits<double>::infinity());
  for (const auto& image : CollectLattices(this->Cache))
  {
    vtkTFCAttributeReader reader;
    std::string error; // the mapper reports it
    if (!reader.Bind(image, axes, error))
    {
      continue;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      double range[2];
      reader.FiniteRange(axis, range);
      if (range[0] <= range[1])
      {
        local[2 * axis] = std::min(local[2 * axis], range[0]);
        local[2 * axis + 1] = std::min(local[2 * axis + 1], -range[1]);
      }
    }
  }
  double global[4];
  std::copy(local, local + 4, global);
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    controller->AllReduce(local, global, 4, vtkCommunicator::MIN_OP);
  }
  vtkNew<vtkDoubleArray> ranges;
  ranges->SetName(RANGES_ARRAY);
  ranges->SetNumberOfComponents(2);
  for (int axis = 0; axis < 2; ++axis)
  {
    ranges->InsertNextTuple2(global[2 * axis], -global[2 * axis + 1]);
  }
  this->AutomaticRanges->GetFieldData()->AddArray(ranges);
}

//------------------------------------------------------------------------------
// From what the view delivers: it may have kept the data of another time, and the legend is drawn
// where the client is.
void vtkTFCVolumeRepresentation::UseAutomaticRanges(vtkDataObject* delivered)
{
  auto* array = delivered ? delivered->GetFieldData()->GetArray(RANGES_ARRAY) : nullptr;
  if (!array)
  {
    this->GetMapper()->ClearAutomaticRanges();
    this->Legend->ClearAutomaticRanges();
    return;
  }
  double ranges[2][2];
  array->GetTuple(0, ranges[0]);
  array->GetTuple(1, ranges[1]);
  this->GetMapper()->SetAutomaticRanges(ranges[0], ranges[1]);
  // An axis without a finite value is nothing that could be drawn.
  if (ranges[0][0] <= ranges[0][1] && ranges[1][0] <= ranges[1][1])
  {
    this->Legend->SetAutomaticRanges(ranges[0], ranges[1]);
  }
  else
  {
    this->Legend->ClearAutomaticRanges();
  }
}

//------------------------------------------------------------------------------
// Bounds of the whole dataset, not of this rank's part.
void vtkTFCVolumeRepresentation::FindWholeBounds(double bounds[6])
{
  std::copy(this->DataBounds, this->DataBounds + 6, bounds);
  auto* image = vtkImageData::SafeDownCast(this->Cache);
  if (image && this->WholeExtent[0] <= this->WholeExtent[1])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double origin = image->GetOrigin()[axis];
      const double spacing = image->GetSpacing()[axis];
      const double ends[2] = { origin + spacing * this->WholeExtent[2 * axis],
        origin + spacing * this->WholeExtent[2 * axis + 1] };
      bounds[2 * axis] = std::min(ends[0], ends[1]);
      bounds[2 * axis + 1] = std::max(ends[0], ends[1]);
    }
  }
}

//------------------------------------------------------------------------------
// Not the base class's: that sets up VTK's own transfer functions, which changes the property and
// with it the shader at every frame, and hides the volume while no array is selected for colouring.
void vtkTFCVolumeRepresentation::UpdateMapperParameters()
{
  this->Actor->SetMapper(this->VolumeMapper);
  this->Actor->SetVisibility(this->GetVisibility());
  const bool shared = this->SharedBlendMode != vtkVolumeMapper::COMPOSITE_BLEND;
  this->VolumeMapper->SetBlendMode(shared ? this->SharedBlendMode : this->RayBlending);
  this->Property->SetSliceFunction(this->SlicePlane);
  auto* controller = vtkMultiProcessController::GetGlobalController();
  this->GetMapper()->SetDistributed(controller && controller->GetNumberOfProcesses() > 1);
  if (this->Property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION)
  {
    // ParaView's default for this property is cubic, which is for surfaces.
    this->Property->SetInterpolationTypeToLinear();
  }
  if (this->VolumeMapper->GetCropping())
  {
    // The base class takes the bounds of the rank.
    double bounds[6];
    double planes[6];
    this->FindWholeBounds(bounds);
    for (int i = 0; i < 6; ++i)
    {
      planes[i] = this->CroppingOrigin[i / 2] + bounds[i] * this->CroppingScale[i / 2];
    }
    this->VolumeMapper->SetCroppingRegionPlanes(planes);
  }
}

//------------------------------------------------------------------------------
void vtkTFCVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Model->PrintSelf(os, indent.GetNextIndent());
}
