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
 * - index grid: GridSize x GridSize cells over the axes' unit square, (first candidate, count, 0,
 * 0); a cell lists every region whose bounding box touches it, so cost per sample follows the
 * number of regions that overlap there, not their total number
 * - candidates: texel index of a region, four to a texel; in list order within a cell
 * - regions, RegionTexels each:
 *   [0] shape + 4 * fall-off, width, opacity, number of colour nodes (0: constant colour)
 *   [1] ellipse, rectangle: centre x, y, cosine, sine; triangle, polygon: first edge, edges, 1/E
 *   [2] ellipse, rectangle: 1/half size x, y; all: tertiary channel (-1: none), first opacity node
 *   [3] colour, number of opacity nodes; the colour nodes follow the opacity nodes
 * - edges (x0, y0, x1, y1) and nodes (value, y...) of the regions
 *
 * Axis positions are in axis units, tertiary values in stored units (see vtkTFCAttributePacker).
 * Size: 16 bytes a texel; GridSize^2 + 4 per region + edges + nodes + candidates texels, e.g. 270
 * KB for 8 simple regions.
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
  static constexpr int GridSize = 128;
  static constexpr int RegionTexels = 4;
  static constexpr int RowLength = 1024;

  /// Padded to whole rows of RowLength texels.
  std::vector<std::array<float, 4>> Texels;
  int CandidateBase = 0;

  /// stored -> axis units of the primary and secondary attribute: axis = stored * Scale + Bias.
  std::array<float, 2> AxisScale = { 1, 1 };
  std::array<float, 2> AxisBias = { 0, 0 };
  std::array<float, 2> AxisChannel = { 0, 1 };
  bool BlendOver = false;

  /**
   * Write the tables of `model`, whose attribute i is stored as stored[i].
   * O(GridSize^2 + sum over regions of the cells that the bounding box touches).
   */
  static vtkTFCShaderTables Build(const vtkTFCCompiledModel& model,
    const std::vector<vtkTFCStoredAttribute>& stored);
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCShaderTables.h
