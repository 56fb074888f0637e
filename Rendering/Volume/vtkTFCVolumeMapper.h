// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCVolumeMapper
 * @brief Ray casts a vtkImageData with a combined transfer function.
 *
 * Every sample of a ray is classified after interpolating the attributes (post-classification):
 * each region of the transfer function weighs the primary and secondary attribute by its 2D shape
 * and the tertiary attribute by its own 1D function (Zhou, Schott, Hansen, "Transfer Function
 * Combinations", Computers & Graphics 36(6), 2012). Samples are composited front to back; the
 * model's opacities hold per ScalarOpacityUnitDistance of the volume's property (world units) and
 * are corrected for the length of each step, 1 - (1 - alpha)^(step / unit).
 *
 * Input: a vtkImageData with the attributes as point arrays or as cell arrays, of any numeric type,
 * a vtkRectilinearGrid (resampled, see vtkTFCImageBlocks) or any composite of them, whose blocks
 * may differ in extent, spacing and resolution and should not overlap. Blocks that lack an
 * attribute are not drawn; that none has it is an error. Images too large for a 3D texture or for
 * MemoryLimit are drawn in pieces. Blocks are drawn back to front; rays are cut alike in all, so no
 * seams appear. At most two axes and six different tertiary attributes at a time, any number of
 * regions. NaN values and blanked points or cells are invisible; ghost cells are used for gradients
 * and not drawn. One-voxel-thick images are drawn as slabs of one voxel.
 *
 * Supported: shading of the volume's property with VTK's lights (the gradient is that of
 * the primary attribute, of ShadingArray or of the classified opacity), opaque and translucent
 * geometry, up to 16 clipping planes, cropping (27 regions, planes in the image's model coordinates
 * along its index axes), parallel and perspective cameras.
 *
 * Blend modes (vtkVolumeMapper::SetBlendMode()), with the pieces i of a ray, their lengths l_i in
 * unit distances, opacities a_i per unit distance and colours c_i with light; the result is a
 * colour C that is multiplied by its opacity A already:
 *   composite (COMPOSITE_BLEND), front to back: b_i = 1 - (1 - a_i)^l_i, T_i = prod(1 - b_j, j <
 * i), C = sum(T_i b_i c_i), A = sum(T_i b_i); maximum by opacity (MAXIMUM_INTENSITY_BLEND): m = the
 * first i with the largest a_i, C = a_m c_m, A = a_m; additive (ADDITIVE_BLEND), emission without
 * absorption: C = min(1, sum(l_i a_i c_i)) by channel, A = min(1, sum(l_i a_i)); average of what is
 * visible (AVERAGE_INTENSITY_BLEND): C = sum(l_i a_i c_i) / L and A = sum(l_i a_i) / L with the
 * visible length L = sum(l_i, a_i > 0); slice (SLICE_BLEND): what lies in the vtkPlane that is the
 * SliceFunction of the volume's property, in world coordinates, C = a c and A = a without light.
 * Maximum, additive and average need whole rays: several blocks, and a
 * dataset that is Distributed, are an error, and rays behind translucent geometry with depth
 * peeling are two each. Minimum intensity and isosurface are an error: they are about one scalar,
 * which there is none of here.
 *
 * While the window asks for one frame per second or more, pixels and steps become as coarse as it
 * takes (vtkTFCFrameBudget); at rest the picture is full again. Several blocks are blended in
 * floating point (vtkTFCBlendBuffer), 16 bytes a pixel.
 *
 * Edits of the transfer function upload a small table (vtkTFCShaderTables) and never build a
 * shader; the mapper's modification time does not include the model's. Changing an attribute to one
 * that is not on the GPU packs and uploads the volume again.
 *
 * Errors (missing array, too many attributes, ...) are raised once per cause with vtkErrorMacro,
 * and GetLastError() has the text. A transfer function that does not fit the data leaves the
 * previous one in force; when there is none for this data, nothing is drawn.
 *
 * The volume's property is set to dependent components and 1D mode: VTK then hands all channels of
 * the packed texture to the classification. Its colour and opacity functions are not used.
 *
 * Memory besides the input: 16 bytes a voxel on the CPU and 16 on the GPU, half of that as long as
 * no region has a tertiary attribute of its own, twice that with more than two of them; for
 * skipping empty space 0.5 on the CPU; with shading 8 more on the GPU. The transfer function takes
 * some 100 KB, at most 20 MB.
 *
 * It derives from vtkMultiBlockVolumeMapper because ParaView's vtkPVLODVolume renders no other
 * mapper without selected scalars.
 */

#ifndef vtkTFCVolumeMapper_h
#define vtkTFCVolumeMapper_h

#include "vtkMultiBlockVolumeMapper.h"
#include "vtkSmartPointer.h"    // For the model
#include "vtkTFCVolumeModule.h" // For export macro

#include <array>  // For ranges
#include <memory> // For the implementation
#include <string> // For errors

class vtkTFCTransferFunction;

class VTKTFCVOLUME_EXPORT vtkTFCVolumeMapper : public vtkMultiBlockVolumeMapper
{
public:
  static vtkTFCVolumeMapper* New();
  vtkTypeMacro(vtkTFCVolumeMapper, vtkMultiBlockVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The model. Null or without regions: nothing is drawn. Default: null.
   */
  void SetTransferFunction(vtkTFCTransferFunction* model);
  vtkTFCTransferFunction* GetTransferFunction() const;
  ///@}

  ///@{
  /**
   * Values of the primary and secondary attribute at the ends of an axis for which the model gives
   * no range. Where the data is distributed they must be those of all ranks. Default: empty, which
   * stands for the finite range in the input.
   */
  void SetAutomaticRanges(const double primary[2], const double secondary[2]);
  void ClearAutomaticRanges();
  ///@}

  ///@{
  /**
   * World distance between samples along a ray, or 0 for half the mean spacing of the input.
   * Default: 0.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * Whether the pieces of a ray begin at a random fraction of the sample distance, another one for
   * each pixel: noise instead of rings where samples are too far apart. Default: off.
   */
  vtkSetMacro(UseJittering, bool);
  vtkGetMacro(UseJittering, bool);
  vtkBooleanMacro(UseJittering, bool);
  ///@}

  ///@{
  /**
   * MiB of textures on the GPU at a time, or 0 for no limit. What is larger is drawn in slabs, each
   * uploaded for every frame: slow, but it draws. Default: 0.
   */
  vtkSetClampMacro(MemoryLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  ///@{
  /**
   * Longest side of a 3D texture in voxels, or 0 for what the driver allows. Longer images are
   * drawn in pieces. Default: 0.
   */
  vtkSetClampMacro(LongestTextureSide, int, 0, VTK_INT_MAX);
  vtkGetMacro(LongestTextureSide, int);
  ///@}

  ///@{
  /**
   * Whether rays leap over bricks of 4^3 voxels, larger ones in large volumes, in which the
   * transfer function can show nothing. The picture is the same; only tests have a reason to switch
   * it off. Default: on.
   */
  vtkSetMacro(EmptySpaceSkipping, bool);
  vtkGetMacro(EmptySpaceSkipping, bool);
  vtkBooleanMacro(EmptySpaceSkipping, bool);
  ///@}

  ///@{
  /**
   * Name of the array whose gradient is the normal of shading, component 0, with values on points
   * or cells as the attributes have. Empty: the primary attribute. An array that cannot be used is
   * an error, and the primary attribute is taken. Costs 4 bytes a voxel on the CPU. Default: empty.
   */
  vtkSetStdStringFromCharMacro(ShadingArray);
  vtkGetCharFromStdStringMacro(ShadingArray);
  ///@}

  ///@{
  /**
   * Whether the normal of shading is the gradient of the classified opacity, by central differences
   * over a voxel on each side, instead of an array's: right for surfaces that a tertiary function
   * makes, at six samples more where something is visible, and no memory. Default: off.
   */
  vtkSetMacro(ShadeByOpacity, bool);
  vtkGetMacro(ShadeByOpacity, bool);
  vtkBooleanMacro(ShadeByOpacity, bool);
  ///@}

  enum RendererType
  {
    AutoRenderer = 0,
    GPURenderer = 1,
    CPURenderer = 2
  };

  ///@{
  /**
   * What draws: OpenGL, or VTK's ray caster on the CPU (vtkTFCFallbackRenderer says what is
   * different there). AutoRenderer is OpenGL where the driver has what it needs, else the CPU, with
   * one warning that says why. The CPU draws a single image or grid with composite blending in one
   * process; anything else is an error. Default: AutoRenderer.
   */
  vtkSetClampMacro(Renderer, int, AutoRenderer, CPURenderer);
  vtkGetMacro(Renderer, int);
  ///@}

  ///@{
  /**
   * Whether other processes draw other parts of the dataset, with which this one's picture is
   * composited. Default: off.
   */
  vtkSetMacro(Distributed, bool);
  vtkGetMacro(Distributed, bool);
  ///@}

  /**
   * Whether the last Render() drew on the CPU.
   */
  bool GetUsedCPU() const { return this->UsedCPU; }

  /**
   * Number of times that the data was classified for the CPU.
   */
  int GetNumberOfClassifications() const;

  /**
   * What was wrong at the last Render(), or an empty string.
   */
  const std::string& GetLastError() const { return this->LastError; }

  /**
   * Uploads of tables so far; one for each edit that was rendered.
   */
  int GetNumberOfTableUploads() const;

  /**
   * Number of times the attributes were packed and uploaded.
   */
  int GetNumberOfVolumeUploads() const;

  double* GetBounds() override;
  using vtkAbstractVolumeMapper::GetBounds;

  void Render(vtkRenderer* ren, vtkVolume* vol) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkTFCVolumeMapper();
  ~vtkTFCVolumeMapper() override;

private:
  vtkTFCVolumeMapper(const vtkTFCVolumeMapper&) = delete;
  void operator=(const vtkTFCVolumeMapper&) = delete;

  bool ChooseRenderer(vtkRenderer* ren, vtkVolume* vol, std::string& error);
  bool Prepare(vtkRenderer* ren, vtkVolume* vol, std::string& error);
  bool PrepareForCPU(std::string& error);
  void RenderBlocks(vtkRenderer* ren, vtkVolume* vol);

  class Internals;
  std::unique_ptr<Internals> Internal;
  vtkSmartPointer<vtkTFCTransferFunction> TransferFunction;
  double SampleDistance = 0;
  int MemoryLimit = 0;
  int LongestTextureSide = 0;
  bool EmptySpaceSkipping = true;
  bool UseJittering = false;
  bool ShadeByOpacity = false;
  int Renderer = AutoRenderer;
  std::string ShadingArray;
  bool UsedCPU = false;
  bool Distributed = false;
  bool HasAutomaticRanges = false;
  std::array<std::array<double, 2>, 2> AutomaticRanges = { { { 0, 1 }, { 0, 1 } } };
  std::string LastError;
};

#endif
