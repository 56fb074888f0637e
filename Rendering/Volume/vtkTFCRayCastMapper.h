// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCRayCastMapper
 * @brief Ray casts one packed block with the tables of a combined transfer function.
 *
 * Internal to vtkTFCVolumeMapper, which packs the attributes and decides what is visible. This
 * class is the only one that knows VTK's ray casting shader: it replaces the shader's tags for the
 * classification (glsl/vtkTFCClassify.glsl and what it calls) and for the ray
 * (glsl/vtkTFCRay.glsl: intervals cut at multiples of the sample distance from the eye), and sets
 * their uniforms. Lights, opaque geometry, depth peeling, picking and the off-centre viewport stay
 * VTK's.
 *
 * The input is a vtkImageData whose active scalars are two or four float components
 * (vtkTFCAttributePacker). The volume's property must have IndependentComponents off.
 *
 * The replacements live in the shader property of the rendered vtkVolume and stay there: do not
 * give that volume to another kind of GPU mapper afterwards.
 *
 * What no model has used so far (vtkTFCShaderTables::Features) is not compiled; its first use
 * builds a shader once.
 *
 * No setter here touches the modification time when the shader does not change, so nothing is
 * rebuilt when a region, a plane or the sample distance is edited.
 */

#ifndef vtkTFCRayCastMapper_h
#define vtkTFCRayCastMapper_h

#include "vtkFloatArray.h" // For arrays
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkSmartPointer.h"    // For arrays
#include "vtkTFCShaderTables.h" // For the tables
#include "vtkTFCVolumeModule.h" // For export macro

#include <array>  // For planes
#include <memory> // For the texture
#include <vector> // For planes

class vtkTFCAttributeTexture;
class vtkTFCBrickTexture;
class vtkTFCGradientTexture;
class vtkTFCTableTexture;
class vtkOpenGLRenderWindow;
class vtkVolumeProperty;

class VTKTFCVOLUME_EXPORT vtkTFCRayCastMapper : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkTFCRayCastMapper* New();
  vtkTypeMacro(vtkTFCRayCastMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  static constexpr int MaximumNumberOfClippingPlanes = 16;

  /// What of the block is drawn, in texture coordinates of the packed image (0..1 over the texels).
  struct Visibility
  {
    std::array<float, 3> BoxMin = { 0, 0, 0 };
    std::array<float, 3> BoxMax = { 1, 1, 1 };
    /// By how much rays that run along the upper faces may be off: 1e-6 against rounding, -1e-6
    /// where another block has the rays in the face.
    std::array<float, 3> UpperMargin = { 1e-6f, 1e-6f, 1e-6f };
    /// Visible where dot(plane, (x, y, z, 1)) >= 0; at most MaximumNumberOfClippingPlanes.
    std::vector<std::array<float, 4>> ClippingPlanes;
    std::array<float, 3> CropMin = { 0, 0, 0 };
    std::array<float, 3> CropMax = { 1, 1, 1 };
    /// Plane of slice blending, 0 on it.
    std::array<float, 4> SlicePlane = { 0, 0, 0, 0 };
    /// Bits of vtkVolumeMapper::CroppingRegionFlags, or -1 for no cropping.
    int CropFlags = -1;
  };

  void SetVisibility(const Visibility& visibility) { this->Visible = visibility; }

  /// The classification. `generation` must grow with every change.
  void SetTables(const vtkTFCShaderTables& tables, unsigned int generation);

  /// What the shader is compiled for; at least what the tables use.
  void SetFeatures(unsigned int features) { this->Features = features; }

  /// How the samples of a ray are blended: vtkVolumeMapper's COMPOSITE_BLEND,
  /// MAXIMUM_INTENSITY_BLEND, AVERAGE_INTENSITY_BLEND, ADDITIVE_BLEND or SLICE_BLEND. For VTK this
  /// mapper always composites, so that its own code for other modes stays out of the shader.
  void SetBlending(int mode) { this->Blending = mode; }

  /// What to shade by the gradient of, a value per texel, or null for the first packed attribute.
  /// It must live until the next call.
  void SetShadingValues(vtkFloatArray* values) { this->ShadingValues = values; }

  /// Shade by the gradient of the classified opacity instead.
  void SetShadeByOpacity(bool byOpacity) { this->ShadeByOpacity = byOpacity; }

  /// The vtkTFCBrickDistances for the input; before the first frame.
  void SetBricks(std::vector<unsigned char> distances, const std::array<int, 3>& dimensions,
    int brickSize);

  /// Channels 4 to 7 of the input's texels, or null.
  void SetMoreAttributes(vtkFloatArray* array) { this->MoreAttributes = array; }

  /// World distance between samples and over which the model's opacities hold.
  void SetDistances(double sampleDistance, double unitDistance);

  /// Draw one pixel for `size` x `size` of the window's, interpolated in between.
  void SetPixelSize(int size);

  /// Uploads of tables so far, for tests.
  int GetNumberOfTableUploads() const;

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkTFCRayCastMapper();
  ~vtkTFCRayCastMapper() override;

  void GPURender(vtkRenderer* ren, vtkVolume* vol) override;

private:
  vtkTFCRayCastMapper(const vtkTFCRayCastMapper&) = delete;
  void operator=(const vtkTFCRayCastMapper&) = delete;

  bool UploadTextures(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property);
  void SetUniforms(vtkVolume* vol);

  vtkTFCShaderTables Tables;
  unsigned int TablesGeneration = 0;
  unsigned int Features = 0;
  std::unique_ptr<vtkTFCTableTexture> Texture;
  std::vector<unsigned char> BrickDistances = { 0 };
  std::array<int, 3> BrickDimensions = { 1, 1, 1 };
  int BrickSize = 1;
  unsigned int BrickGeneration = 1;
  std::unique_ptr<vtkTFCBrickTexture> BrickTexture;
  std::unique_ptr<vtkTFCGradientTexture> GradientTexture;
  std::unique_ptr<vtkTFCAttributeTexture> AttributeTexture;
  vtkSmartPointer<vtkFloatArray> MoreAttributes;
  Visibility Visible;
  bool HasCropped = false; // other than a box: compiled only once it is needed
  double UnitDistance = 1;
  int Blending = COMPOSITE_BLEND;
  vtkFloatArray* ShadingValues = nullptr;
  bool ShadeByOpacity = false;
};

#endif
