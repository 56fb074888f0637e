// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A combined transfer function as the list of texels that the shader reads.
 *
 * Everything that an edit changes is in this list, so an edit costs one small upload: no shader and
 * no volume texture. Shapes, fall-offs and 1D functions are stored as their defining numbers and
 * evaluated in closed form in the shader; nothing is rasterised, so a region a thousandth of an
 * axis wide is as exact as a wide one.
 *
 * The list holds RGBA texels, in this order (see glsl/vtkTFC*.glsl):
 * - index grid: GridSize x GridSize cells over the axes' unit square, (first, end, 0, 1): the
 *   texels with the records of all regions that may be non-zero in the cell, so cost per sample
 *   follows the number of regions that overlap there, not their total number; or (0, 0, patch, 1);
 *   or zeros where nothing is
 * - edges (x0, y0, x1, y1) of polygons; tertiary functions: colour nodes (value, r, g, b), then
 *   (first colour node, number of them), then Buckets pieces and all pieces of opacity times
 *   tertiary function (a, b, end, next piece): a + b v for v < end
 * - records of regions, RecordTexels each, for every different set of regions, in list order:
 *   [0] ellipse, rectangle: centre x, y, and [1] (c, d, 1/width of the fall-off, shape + 4 *
 *       fall-off), where (a, b; c, d) with a, b in [0] turns and scales the shape to the unit one;
 *       triangle, polygon: first edge, number of edges, 1/E
 *   [1] also has 16 * channel of the tertiary attribute in its last number
 *   [2] opacity, colour; with the feature Tertiaries the first bucket in place of the opacity, for
 *       every region: without a tertiary function its one piece is the opacity
 * - patches, vtkTFCPatch::Nodes^2 texels each
 *
 * Axis positions are in axis units, tertiary values in stored units (see vtkTFCAttributePacker).
 * Size: 16 bytes a texel; GridSize^2 + RecordTexels for each region of each different set + edges +
 * functions, e.g. 300 KB for 8 simple regions. The grid becomes coarser before there are more than
 * LargestNumberOfRecords records (16 MB).
 */

#ifndef vtkTFCShaderTables_h
#define vtkTFCShaderTables_h

#include "vtkTFCVolumeModule.h" // For export macro

#include "vtkTFCCompiledModel.h" // For vtkTFCCompiledModel

#include <array>  // For texels
#include <vector> // For the list

/// How an attribute is stored on the GPU: stored = (value - Offset) / Scale in channel Channel.
struct vtkTFCStoredAttribute
{
  int Channel = 0;
  double Offset = 0;
  double Scale = 1;
};

struct VTKTFCVOLUME_EXPORT vtkTFCShaderTables
{
  static constexpr int LargestGridSize = 128;
  static constexpr size_t LargestNumberOfRecords = 1 << 18;
  static constexpr int RecordTexels = 3;
  static constexpr int Buckets = 64;

  std::vector<std::array<float, 4>> Texels;
  int GridSize = 1;

  /// What the shader must be able to do, as bits. Each costs time in every sample on a processor
  /// that executes both sides of a branch, so it is compiled only once a model uses it.
  enum Features : unsigned int
  {
    Polygons = 1, ///< also triangles
    Gaussians = 2,
    Tertiaries = 4,
    TertiaryColors = 8,
    Patches = 16,        ///< cells where many regions overlap
    MoreAttributes = 32, ///< channels beyond the fourth
    SeveralRegions = 64  ///< else the only record is kept for the whole ray
  };
  unsigned int FeaturesUsed = 0; ///< by the model, and those asked for

  /// stored -> axis units of the primary and secondary attribute, which are in channels 0 and 1:
  /// axis = stored * Scale + Bias.
  std::array<float, 2> AxisScale = { 1, 1 };
  std::array<float, 2> AxisBias = { 0, 0 };
  bool BlendOver = false;
  int FirstRecord = 0; ///< texel of the record of a single region

  /**
   * Write the tables of `model`, whose attribute i is stored as stored[i], for a shader that has
   * `features` besides those that the model uses.
   * O(GridSize^2 + sum over regions of the cells that the bounding box touches + records).
   */
  static vtkTFCShaderTables Build(const vtkTFCCompiledModel& model,
    const std::vector<vtkTFCStoredAttribute>& stored, unsigned int features = 0);
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCShaderTables.h
