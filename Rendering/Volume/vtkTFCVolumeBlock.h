// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One image of a volume mapper: its packed attributes, its bricks and what draws it.
 *
 * The model and its axis ranges are the same for all blocks; the tables are each block's own, as
 * each stores its attributes by their range in it.
 */

#ifndef vtkTFCVolumeBlock_h
#define vtkTFCVolumeBlock_h

#include "vtkTFCAttributePacker.h"
#include "vtkTFCBrickRanges.h"
#include "vtkTFCCompiledModel.h"
#include "vtkTFCImageBlocks.h"
#include "vtkTFCRayCastMapper.h"
#include "vtkTFCShaderTables.h"
#include "vtkTFCShadingValues.h"

#include "vtkNew.h" // For the caster

#include <array>  // For ranges
#include <memory> // For lists of blocks
#include <string> // For errors
#include <vector> // For attributes

class vtkMatrix3x3;
class vtkMatrix4x4;
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;
class vtkWindow;

class vtkTFCVolumeBlock
{
public:
  /// Bring the packed attributes up to date with the model's. Returns false with `error` when they
  /// cannot be; what was drawn before then still can, as long as IsCurrent().
  bool Pack(const vtkTFCImageBlocks::Block& block, const std::vector<vtkTFCAttribute>& attributes,
    std::string& error);
  bool IsCurrent(const vtkTFCImageBlocks::Block& block) const;

  /// Finite values of axis 0 or 1 in this block; empty (min > max) where there are none.
  std::array<double, 2> GetRange(int axis) const { return this->Packer.GetRange(axis); }

  /// Write the tables and find the active bricks for a model, unless that was done for this
  /// `generation` of it. Returns the features that the shader needs, `features` among them.
  unsigned int Compile(const vtkTFCCompiledModel& model, unsigned int generation, bool skipping,
    unsigned int features);

  /// Find the values of the array by whose gradient to shade; with an empty name, or with `error`
  /// when it cannot be used, it is that of the primary attribute.
  void UpdateShading(const vtkTFCImageBlocks::Block& block, const std::string& array,
    std::string& error);

  /// Shade by the gradient of the classified opacity; builds a shader when it changes.
  void SetShadeByOpacity(bool byOpacity) { this->Caster->SetShadeByOpacity(byOpacity); }

  /// Whether pieces of rays begin at random; builds a shader when it changes.
  void SetJittering(bool jittering) { this->Caster->SetUseJittering(jittering); }

  /// How finely to draw: world distance between samples, and side of a pixel.
  struct Resolution
  {
    double SampleDistance = 1;
    int PixelSize = 1;
  };

  /// Draw with a shader that has `features`, settings taken from `mapper`.
  void Render(vtkRenderer* ren, vtkVolume* vol, vtkVolumeMapper* mapper,
    const Resolution& resolution, unsigned int features);

  /// Half the mean spacing of the image.
  double GetDefaultSampleDistance() const;
  /// Bounds of what is drawn along the axes of `frame`, a matrix from the coordinates of the image.
  std::array<double, 6> GetBounds(vtkMatrix4x4* frame) const;
  /// Directions of the image's axes.
  vtkMatrix3x3* GetDirection() const;
  /// Bytes of the attributes' texture.
  vtkIdType GetTextureBytes() const;

  /// Those of `blocks` that are drawable, farthest from the camera first.
  static std::vector<vtkTFCVolumeBlock*> FindOrder(
    const std::vector<std::unique_ptr<vtkTFCVolumeBlock>>& blocks, vtkRenderer* ren,
    vtkVolume* vol);

  /// Whether to draw it: set by Pack().
  void SetDrawable(bool drawable) { this->Drawable = drawable; }
  bool IsDrawable() const { return this->Drawable; }
  int GetNumberOfTableUploads() const { return this->Caster->GetNumberOfTableUploads(); }
  int GetNumberOfVolumeUploads() const { return static_cast<int>(this->Packer.GetGeneration()); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::array<int, 6> GetDrawnExtent() const;
  std::array<int, 3> GetTexels() const;
  void UpdateBricks(const vtkTFCCompiledModel& model, bool skipping, bool changed);
  vtkTFCRayCastMapper::Visibility FindVisibility(vtkVolumeMapper* mapper, vtkVolume* vol) const;

  vtkNew<vtkTFCRayCastMapper> Caster;
  vtkTFCAttributePacker Packer;
  std::array<int, 6> Drawn = { 0, -1, 0, -1, 0, -1 };
  bool Drawable = false;

  vtkTFCShaderTables Tables;
  unsigned int TablesGeneration = 0;
  unsigned int ModelGeneration = 0;
  unsigned int TablesPackGeneration = 0;

  vtkTFCShadingValues Shading;
  vtkTFCBrickRanges Ranges;
  vtkTFCBrickRanges MoreRanges; // of channels 4 to 7, where there are any
  unsigned int RangesPackGeneration = 0;
  bool Skipping = false; // whether the caster was given the distances of bricks
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCVolumeBlock.h
