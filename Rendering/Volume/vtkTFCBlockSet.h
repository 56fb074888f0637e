// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The blocks that a volume mapper draws, packed and classified by one model.
 *
 * It finds the images of the input (vtkTFCImageBlocks) within what the driver and the memory limit
 * allow, keeps a vtkTFCVolumeBlock for each, resolves the axis ranges that the model leaves open
 * and compiles the model once for all blocks.
 */

#ifndef vtkTFCBlockSet_h
#define vtkTFCBlockSet_h

#include "vtkTFCCompiledModel.h"
#include "vtkTFCImageBlocks.h"
#include "vtkTFCVolumeBlock.h"

#include <array>  // For ranges
#include <memory> // For blocks
#include <string> // For errors
#include <vector> // For blocks

class vtkDataObject;
class vtkOpenGLRenderWindow;
class vtkTFCTransferFunction;
class vtkWindow;

class vtkTFCBlockSet
{
public:
  using AxisRanges = std::array<std::array<double, 2>, 2>;

  /// As vtkTFCVolumeMapper has them.
  struct Settings
  {
    vtkDataObject* Input = nullptr;
    const AxisRanges* AutomaticRanges = nullptr; ///< null: those of the input
    std::string ShadingArray;
    bool HasGradients = false; ///< of the data, for shading
    bool EmptySpaceSkipping = true;
    int MemoryLimit = 0;
    int LongestTextureSide = 0;
  };

  /// Bring blocks and tables up to date. Returns whether there is something to draw: a model that
  /// does not fit the data is an error, and leaves what was drawn before in force as long as the
  /// data is the same.
  bool Update(vtkTFCTransferFunction* model, const Settings& settings,
    vtkOpenGLRenderWindow* window, std::string& error);

  const std::vector<std::unique_ptr<vtkTFCVolumeBlock>>& GetBlocks() const { return this->Blocks; }
  int GetNumberOfDrawableBlocks() const;
  /// What the shaders are compiled for: all that any model has needed so far.
  unsigned int GetFeatures() const { return this->Features; }
  /// Whether the textures of all blocks together are larger than the memory limit.
  bool IsStreaming() const { return this->Streaming; }
  int GetNumberOfTableUploads() const;
  int GetNumberOfVolumeUploads() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool FindBlocks(const Settings& settings, vtkOpenGLRenderWindow* window, std::string& error);
  bool PackAndCompile(vtkTFCTransferFunction* model, const Settings& settings, std::string& error);
  std::array<double, 4> ResolveRanges(vtkTFCTransferFunction* model,
    const std::vector<vtkTFCVolumeBlock*>& packed, const AxisRanges* automatic) const;
  void RemoveBlocks(vtkWindow* window);

  vtkTFCImageBlocks Images;
  std::vector<std::unique_ptr<vtkTFCVolumeBlock>> Blocks;
  bool Streaming = false;

  // The model with the axis ranges it was compiled for.
  vtkTFCCompiledModel Model;
  std::array<double, 4> UsedRanges = { 0, 1, 0, 1 };
  vtkMTimeType ModelTime = 0;
  vtkTFCTransferFunction* CompiledFrom = nullptr; // only compared
  unsigned int ModelGeneration = 0;
  unsigned int ImagesGeneration = 0;
  bool ModelOutdated = true;
  unsigned int Features = 0;
  int FormerTableUploads = 0; // of blocks that are gone
  int FormerVolumeUploads = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCBlockSet.h
