// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A combined transfer function flattened into plain numbers, ready to be evaluated.
 *
 * This is what the CPU evaluation (vtkTFCClassifier) and the tables of the shader are both made
 * from, so that there is one place where data units become axis units and where defaults,
 * visibility and array names are resolved. It holds no VTK object and is a snapshot: edits of the
 * model make a new one.
 *
 * Axis units: x = (v - range[0]) / (range[1] - range[0]), so that each axis runs from 0 to 1.
 */

#ifndef vtkTFCCompiledModel_h
#define vtkTFCCompiledModel_h

#include "vtkTFCTransferFunctionModule.h" // For export macro

#include <array>  // For points and nodes
#include <string> // For array names
#include <vector> // For lists

/// One component of a named array of the dataset.
struct vtkTFCAttribute
{
  std::string Array;
  int Component = 0;
  bool operator==(const vtkTFCAttribute& other) const
  {
    return this->Component == other.Component && this->Array == other.Array;
  }
};

enum class vtkTFCShapeType
{
  Ellipse,
  Rectangle,
  Triangle,
  Polygon
};

enum class vtkTFCFalloffType
{
  Constant,
  Linear,
  Smooth,
  Gaussian
};

enum class vtkTFCBlendType
{
  Mix,
  Over
};

/// One visible region. All geometry is in axis units.
struct vtkTFCCompiledRegion
{
  int Id = 0;
  vtkTFCShapeType Shape = vtkTFCShapeType::Ellipse;
  vtkTFCFalloffType Falloff = vtkTFCFalloffType::Smooth;
  double Width = 0.25; ///< of the fall-off, in (0, 1]

  /// Ellipse and rectangle: centre, radii or half sizes before rotation, cosine and sine of the
  /// counter-clockwise angle.
  std::array<double, 2> Center = { 0, 0 };
  std::array<double, 2> HalfSize = { 0, 0 };
  double Cosine = 1;
  double Sine = 0;

  /// Triangle and polygon: the closed outline, and E, the largest distance from a point inside to
  /// the nearest edge (so that d = 1 - e/E).
  std::vector<std::array<double, 2>> Points;
  double MaximumEdgeDistance = 0;

  /// xmin, xmax, ymin, ymax of the set where the weight can be non-zero (not cut to [0, 1]).
  std::array<double, 4> Bounds = { 0, 0, 0, 0 };

  std::array<double, 3> Color = { 1, 1, 1 };
  double Opacity = 1;

  /// Index into vtkTFCCompiledModel::Attributes, or -1 when the region has no tertiary function.
  int Tertiary = -1;
  /// Nodes {value, opacity} with increasing value, data units; never empty when Tertiary >= 0.
  /// Two nodes may share a value: a step, whose later node holds at the value itself and beyond.
  std::vector<std::array<double, 2>> TertiaryOpacity;
  /// Nodes {value, r, g, b}; empty: the region's colour holds everywhere.
  std::vector<std::array<double, 4>> TertiaryColor;
};

struct VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCCompiledModel
{
  /// [0] is the primary, [1] the secondary attribute, then every distinct tertiary attribute of a
  /// visible region in order of first use. An attribute in two roles is listed once per axis role,
  /// but a tertiary attribute that equals an axis refers to that axis's index.
  std::vector<vtkTFCAttribute> Attributes;
  /// Data values at 0 and 1 of the two axes.
  std::array<std::array<double, 2>, 2> Range = { { { 0, 1 }, { 0, 1 } } };
  vtkTFCBlendType Blend = vtkTFCBlendType::Mix;
  /// Visible regions with non-zero opacity, in list order.
  std::vector<vtkTFCCompiledRegion> Regions;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCCompiledModel.h
