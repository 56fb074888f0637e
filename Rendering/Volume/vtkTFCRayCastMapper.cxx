// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRayCastMapper.h"

#include "vtkTFCAttributeTexture.h"
#include "vtkTFCBrickTexture.h"
#include "vtkTFCGradientTexture.h"
#include "vtkTFCPatch.h"
#include "vtkTFCTableTexture.h"

#include "vtkTFCClassify_glsl.h"
#include "vtkTFCGradient_glsl.h"
#include "vtkTFCLeap_glsl.h"
#include "vtkTFCPatch_glsl.h"
#include "vtkTFCRay_glsl.h"
#include "vtkTFCSample_glsl.h"
#include "vtkTFCShapes_glsl.h"
#include "vtkTFCTables_glsl.h"
#include "vtkTFCTertiary_glsl.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <string>
#include <utility>

namespace
{

//------------------------------------------------------------------------------
std::string MakeDefinitions(unsigned int features, bool cropping, bool shaded, bool byOpacity)
{
  const auto define = [](const char* name, int value)
  { return std::string("#define ") + name + " " + std::to_string(value) + "\n"; };
  std::string text = define("TFC_RECORD_TEXELS", vtkTFCShaderTables::RecordTexels) +
    define("TFC_BUCKETS", vtkTFCShaderTables::Buckets) +
    define("TFC_PATCH_NODES", vtkTFCPatch::Nodes);
  const std::pair<unsigned int, const char*> names[] = {
    { vtkTFCShaderTables::Polygons, "TFC_POLYGONS" },
    { vtkTFCShaderTables::Gaussians, "TFC_GAUSSIANS" },
    { vtkTFCShaderTables::Tertiaries, "TFC_TERTIARIES" },
    { vtkTFCShaderTables::TertiaryColors, "TFC_TERTIARY_COLORS" },
    { vtkTFCShaderTables::Patches, "TFC_PATCHES" },
    { vtkTFCShaderTables::MoreAttributes, "TFC_MORE_ATTRIBUTES" },
    { vtkTFCShaderTables::SeveralRegions, "TFC_SEVERAL_REGIONS" },
  };
  for (const auto& [feature, name] : names)
  {
    text += features & feature ? define(name, 1) : "";
  }
  text += cropping ? define("TFC_CROPPING", 1) : "";
  text += shaded ? define("TFC_SHADED", 1) : "";
  text += shaded && byOpacity ? define("TFC_SHADE_BY_OPACITY", 1) : "";
  return text;
}

//------------------------------------------------------------------------------
std::string MakeBlending(int mode)
{
  switch (mode)
  {
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return "#define TFC_MAXIMUM 1\n";
    case vtkVolumeMapper::ADDITIVE_BLEND:
      return "#define TFC_ADDITIVE 1\n";
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      return "#define TFC_AVERAGE 1\n";
    case vtkVolumeMapper::SLICE_BLEND:
      return "#define TFC_SLICE 1\n";
    default:
      return "#define TFC_COMPOSITE 1\n";
  }
}

//------------------------------------------------------------------------------
// Put our functions and the calls to them at the tags of VTK's ray casting shader. Tags that VTK
// still has to fill are kept in the replacement.
void InstallReplacements(vtkShaderProperty* shader, const std::string& definitions)
{
  const std::string ownTag = "//VTK::CustomUniforms::Dec";
  for (int i = 0; i < shader->GetNumberOfShaderReplacements(); ++i)
  {
    std::string name;
    std::string replacement;
    bool replaceFirst = false;
    bool replaceAll = false;
    shader->GetNthShaderReplacement(i, name, replaceFirst, replacement, replaceAll);
    if (name == ownTag && replacement == definitions &&
      shader->GetNthShaderReplacementTypeAsString(i) == "Fragment")
    {
      return;
    }
  }
  const auto replace = [shader](const std::string& tag, const std::string& text)
  { shader->AddFragmentShaderReplacement(tag, true, text, false); };

  // VTK would declare the uniforms here by the type they are set with, which for a sampler is an
  // integer. Our files declare them, where a reader looks for them.
  replace(ownTag, definitions);
  replace("//VTK::ComputeOpacity::Dec",
    std::string(vtkTFCRay_glsl) + vtkTFCLeap_glsl + vtkTFCTables_glsl + vtkTFCShapes_glsl +
      vtkTFCTertiary_glsl + vtkTFCPatch_glsl + vtkTFCClassify_glsl);
  replace("//VTK::ComputeGradient::Dec", vtkTFCGradient_glsl);
  replace("//VTK::ComputeColor::Dec", vtkTFCSample_glsl);
  replace("//VTK::Shading::Impl", "if (!g_skip)\n    {\n      tfcBlend();\n    }");
  replace("//VTK::Clipping::Impl", "g_tfcSegmentStart = g_dataPos;\n//VTK::Clipping::Impl");
  // Depth peeling would move the start to a sample, and drop segments shorter than a step.
  replace("//VTK::DepthPeeling::Ray::PathCheck", "");
  replace("//VTK::Shading::Init",
    "tfcBeginRay();\n  tfcBeginLeaps();\n  tfcBeginClassification();\n  "
    "tfcBeginLight();\n  tfcBeginBlending();\n//VTK::Shading::Init");
  replace("//VTK::Shading::Exit", "tfcEndBlending();\n//VTK::Shading::Exit");
  replace("//VTK::Base::Impl",
    "tfcBeginSample();\n//VTK::Base::Impl\n    g_skip = g_skip || tfcCropped();");
  replace("//VTK::Terminate::Impl", "if (tfcEndSample()) { break; }");
}

}

vtkStandardNewMacro(vtkTFCRayCastMapper);

//------------------------------------------------------------------------------
vtkTFCRayCastMapper::vtkTFCRayCastMapper()
  : Texture(new vtkTFCTableTexture)
  , BrickTexture(new vtkTFCBrickTexture)
  , GradientTexture(new vtkTFCGradientTexture)
  , AttributeTexture(new vtkTFCAttributeTexture)
{
  this->AutoAdjustSampleDistances = 0;
  this->UseJittering = 0;
}

//------------------------------------------------------------------------------
vtkTFCRayCastMapper::~vtkTFCRayCastMapper() = default;

//------------------------------------------------------------------------------
void vtkTFCRayCastMapper::SetTables(const vtkTFCShaderTables& tables, unsigned int generation)
{
  if (generation != this->TablesGeneration)
  {
    this->Tables = tables;
    this->TablesGeneration = generation;
  }
}

//------------------------------------------------------------------------------
void vtkTFCRayCastMapper::SetBricks(std::vector<unsigned char> distances,
  const std::array<int, 3>& dimensions, int brickSize)
{
  this->BrickSize = brickSize;
  this->BrickDistances = std::move(distances);
  this->BrickDimensions = dimensions;
  ++this->BrickGeneration;
}

//------------------------------------------------------------------------------
void vtkTFCRayCastMapper::SetDistances(double sampleDistance, double unitDistance)
{
  // Not SetSampleDistance(): it marks the mapper modified, and VTK then builds the shader again.
  this->SampleDistance = static_cast<float>(sampleDistance);
  this->UnitDistance = unitDistance;
}

//------------------------------------------------------------------------------
void vtkTFCRayCastMapper::SetPixelSize(int size)
{
  // Not SetImageSampleDistance(), for the same reason.
  this->ImageSampleDistance = static_cast<float>(size);
}

//------------------------------------------------------------------------------
int vtkTFCRayCastMapper::GetNumberOfTableUploads() const
{
  return this->Texture->GetNumberOfUploads();
}

//------------------------------------------------------------------------------
void vtkTFCRayCastMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->BrickTexture->ReleaseGraphicsResources(window);
  this->GradientTexture->ReleaseGraphicsResources(window);
  this->AttributeTexture->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTFCRayCastMapper::SetUniforms(vtkVolume* vol)
{
  vtkUniforms* uniforms = vol->GetShaderProperty()->GetFragmentCustomUniforms();
  uniforms->SetUniformi("in_tfcTables", this->Texture->GetTextureUnit());
  uniforms->SetUniformi("in_tfcBricks", this->BrickTexture->GetTextureUnit());
  uniforms->SetUniformf("in_tfcBrickSize", static_cast<float>(this->BrickSize));
  uniforms->SetUniformi("in_tfcGridSize", this->Tables.GridSize);
  uniforms->SetUniformi("in_tfcFirstRecord", this->Tables.FirstRecord);
  uniforms->SetUniform2f("in_tfcAxisScale", this->Tables.AxisScale.data());
  uniforms->SetUniform2f("in_tfcAxisBias", this->Tables.AxisBias.data());
  uniforms->SetUniformi("in_tfcBlendOver", this->Tables.BlendOver ? 1 : 0);
  uniforms->SetUniformf("in_tfcInverseUnitDistance", static_cast<float>(1.0 / this->UnitDistance));

  uniforms->SetUniform3f("in_tfcBoxMin", this->Visible.BoxMin.data());
  uniforms->SetUniform3f("in_tfcBoxMax", this->Visible.BoxMax.data());
  uniforms->SetUniform3f("in_tfcUpperMargin", this->Visible.UpperMargin.data());
  if (this->Blending == SLICE_BLEND)
  {
    uniforms->SetUniform4f("in_tfcSlicePlane", this->Visible.SlicePlane.data());
  }
  uniforms->SetUniform3f("in_tfcCropMin", this->Visible.CropMin.data());
  uniforms->SetUniform3f("in_tfcCropMax", this->Visible.CropMax.data());
  uniforms->SetUniformi("in_tfcCropFlags", this->Visible.CropFlags);

  // Always the full array: a uniform that changes its length is a new declaration, hence a shader.
  float planes[MaximumNumberOfClippingPlanes][4] = {};
  const auto count =
    std::min<size_t>(this->Visible.ClippingPlanes.size(), MaximumNumberOfClippingPlanes);
  for (size_t i = 0; i < count; ++i)
  {
    std::copy(this->Visible.ClippingPlanes[i].begin(), this->Visible.ClippingPlanes[i].end(),
      planes[i]);
  }
  uniforms->SetUniformi("in_tfcClipCount", static_cast<int>(count));
  uniforms->SetUniform4fv("in_tfcClipPlanes", MaximumNumberOfClippingPlanes, planes);
}

//------------------------------------------------------------------------------
bool vtkTFCRayCastMapper::UploadTextures(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property)
{
  if (!this->Texture->Upload(window, this->Tables, this->TablesGeneration))
  {
    vtkErrorMacro("The transfer function needs a table of "
      << this->Tables.Texels.size() * sizeof(this->Tables.Texels.front())
      << " bytes, more than this graphics driver allows. Use fewer regions, or polygons with fewer "
         "points.");
    return false;
  }
  if (!this->BrickTexture->Upload(window, this->BrickDistances, this->BrickDimensions,
        this->BrickGeneration))
  {
    vtkErrorMacro("The graphics driver refuses a texture of "
      << this->BrickDimensions[0] << " x " << this->BrickDimensions[1] << " x "
      << this->BrickDimensions[2] << " bytes for skipping empty space.");
    return false;
  }
  int cellFlag = 0;
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  auto* packed = vtkFloatArray::SafeDownCast(vtkAbstractMapper::GetScalars(image, this->ScalarMode,
    this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag));
  std::array<int, 3> texels;
  for (int axis = 0; axis < 3; ++axis)
  {
    texels[axis] = std::max(1, image->GetDimensions()[axis] - (cellFlag == 1 ? 1 : 0));
  }
  const bool linear = property->GetInterpolationType() == VTK_LINEAR_INTERPOLATION;
  const auto refuse = [&](const char* what, const char* remedy)
  {
    vtkErrorMacro("The graphics driver refuses a texture of "
      << texels[0] << " x " << texels[1] << " x " << texels[2] << " " << what << ". " << remedy);
    return false;
  };
  if (!this->MoreAttributes)
  {
    this->AttributeTexture->ReleaseGraphicsResources(window);
  }
  else if (!this->AttributeTexture->Upload(window, this->MoreAttributes, texels, linear))
  {
    return refuse("x 16 bytes for the fifth to eighth attribute",
      "Let regions share their tertiary attributes, or use fewer voxels.");
  }
  if (!property->GetShade() || this->ShadeByOpacity)
  {
    this->GradientTexture->ReleaseGraphicsResources(window);
  }
  else if (!this->GradientTexture->Upload(window,
             this->ShadingValues ? this->ShadingValues : packed, texels, linear))
  {
    return refuse("x 8 bytes for the gradients of shading",
      "Switch shading off, or use fewer voxels.");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCRayCastMapper::GPURender(vtkRenderer* ren, vtkVolume* vol)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  window->MakeCurrent();
  if (!this->UploadTextures(window, vol->GetProperty()))
  {
    return;
  }
  const bool shaded = vol->GetProperty()->GetShade() != 0;
  const bool hasGradients = shaded && !this->ShadeByOpacity;
  this->HasCropped = this->HasCropped || this->Visible.CropFlags >= 0;
  this->Texture->Activate();
  this->BrickTexture->Activate();
  if (hasGradients)
  {
    this->GradientTexture->Activate();
    vol->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("in_tfcGradients",
      this->GradientTexture->GetTextureUnit());
  }
  // Compiled once, the shader has the sampler whether or not this block has a texture for it.
  const bool more =
    ((this->Features | this->Tables.FeaturesUsed) & vtkTFCShaderTables::MoreAttributes) != 0;
  vtkTFCTexture3D* third = this->BrickTexture.get();
  if (more && this->MoreAttributes)
  {
    third = this->AttributeTexture.get();
    third->Activate();
  }
  if (more)
  {
    vol->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("in_tfcMoreAttributes",
      third->GetTextureUnit());
  }
  InstallReplacements(vol->GetShaderProperty(),
    MakeDefinitions(this->Features | this->Tables.FeaturesUsed, this->HasCropped, shaded,
      this->ShadeByOpacity) +
      MakeBlending(this->Blending) + (ren->GetSelector() ? "#define TFC_SELECTION 1\n" : ""));
  this->SetUniforms(vol);
  this->Superclass::GPURender(ren, vol);
  if (hasGradients)
  {
    this->GradientTexture->Deactivate();
  }
  if (more && this->MoreAttributes)
  {
    this->AttributeTexture->Deactivate();
  }
  this->BrickTexture->Deactivate();
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
void vtkTFCRayCastMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UnitDistance: " << this->UnitDistance << "\n";
  os << indent << "Table texels: " << this->Tables.Texels.size() << "\n";
}
