// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The state of a combined transfer function as plain values, its JSON form and its
 * compilation. Private to this module; needs no VTK object, so that it can be fuzzed alone.
 *
 * A vtkTFCState that vtkTFCReadState() returned is valid: every rule of the format holds.
 */

#ifndef vtkTFCState_h
#define vtkTFCState_h

#include "vtkTFCCompiledModel.h" // For the enumerations

#include <array>
#include <map>
#include <string>
#include <vector>

/// Limits that keep every later computation finite and affordable.
namespace vtkTFCLimits
{
constexpr double Number = 1e300;          ///< largest magnitude of any number
constexpr int Id = 999999999;             ///< largest region id
constexpr int Component = 1000000;        ///< largest component index
constexpr size_t Points = 10000;          ///< of one polygon
constexpr size_t Nodes = 10000;           ///< of one tertiary function
constexpr size_t Regions = 10000;         ///< of one transfer function
constexpr size_t Bytes = 8 * 1024 * 1024; ///< of the JSON text, as given and in canonical form
constexpr int Depth = 32;                 ///< of nested lists and objects
}

/// Unknown keys that start with "x-": key to JSON text.
using vtkTFCExtras = std::map<std::string, std::string>;

struct vtkTFCAxisState
{
  bool Set = false;
  vtkTFCAttribute Attribute;
  bool HasRange = false;
  std::array<double, 2> Range = { { 0, 1 } };
};

struct vtkTFCShapeState
{
  vtkTFCShapeType Type = vtkTFCShapeType::Ellipse;
  std::array<double, 2> Center = { { 0, 0 } };
  std::array<double, 2> HalfSize = { { 1, 1 } }; ///< the radii of an ellipse
  double Angle = 0;
  std::vector<std::array<double, 2>> Points;
};

struct vtkTFCTertiaryState
{
  bool Set = false;
  vtkTFCAttribute Attribute;
  bool HasRange = false;
  std::array<double, 2> Range = { { 0, 1 } };
  std::vector<std::array<double, 2>> Opacity;
  std::vector<std::array<double, 4>> Color;
};

struct vtkTFCRegionState
{
  int Id = 0;
  std::string Name;
  bool Visible = true;
  vtkTFCShapeState Shape;
  vtkTFCFalloffType Falloff = vtkTFCFalloffType::Smooth;
  double Width = 0.25;
  std::array<double, 3> Color = { { 1, 1, 1 } };
  double Opacity = 1;
  vtkTFCTertiaryState Tertiary;
  vtkTFCExtras Extras;
};

struct vtkTFCState
{
  std::array<vtkTFCAxisState, 2> Axes; ///< primary, secondary
  vtkTFCBlendType Blend = vtkTFCBlendType::Mix;
  std::vector<vtkTFCRegionState> Regions;
  vtkTFCExtras Extras;
};

bool operator==(const vtkTFCAxisState& a, const vtkTFCAxisState& b);
bool operator==(const vtkTFCShapeState& a, const vtkTFCShapeState& b);
bool operator==(const vtkTFCTertiaryState& a, const vtkTFCTertiaryState& b);
bool operator==(const vtkTFCRegionState& a, const vtkTFCRegionState& b);
bool operator==(const vtkTFCState& a, const vtkTFCState& b);

/// The words of the format, indexed by the enumerations.
extern const std::array<const char*, 4> vtkTFCShapeNames;
extern const std::array<const char*, 4> vtkTFCFalloffNames;
extern const std::array<const char*, 2> vtkTFCBlendNames;

/**
 * What is wrong with the values of a shape, or an empty text. `field` (when not null) receives the
 * key within the shape object, e.g. "radii[0]".
 */
std::string vtkTFCCheckShape(const vtkTFCShapeState& shape, std::string* field);

/**
 * What is wrong with tertiary nodes, or an empty text; `field` as above, relative to the list.
 * Nodes have increasing values, at most two share one, and what follows the value is in [0, 1].
 */
template <size_t N>
std::string vtkTFCCheckNodes(const std::vector<std::array<double, N>>& nodes, std::string* field);
extern template std::string vtkTFCCheckNodes<2>(const std::vector<std::array<double, 2>>&,
  std::string*);
extern template std::string vtkTFCCheckNodes<4>(const std::vector<std::array<double, 4>>&,
  std::string*);

/// Whether |value| is a number that a state may hold.
bool vtkTFCIsNumber(double value);

/// A number as the shortest text that reads back as the same number, in any locale.
std::string vtkTFCNumberText(double value);

/// The value of a region's "tertiary".
std::string vtkTFCTertiaryText(const vtkTFCTertiaryState& tertiary);

/**
 * Read JSON text. Returns false and one sentence in `error` that names the field, what was expected
 * and what is there; `state` is then unspecified. An empty text is an empty state.
 */
bool vtkTFCReadState(const std::string& text, vtkTFCState& state, std::string& error);

/// Canonical JSON text: equal states give equal texts, and reading it gives an equal state.
std::string vtkTFCWriteState(const vtkTFCState& state);

/// The attributes of a state, as vtkTFCCompiledModel::Attributes defines them.
std::vector<vtkTFCAttribute> vtkTFCCollectAttributes(const vtkTFCState& state);

/// Largest edge distances of the polygons compiled last, by their points in axis units.
using vtkTFCPoleCache = std::map<std::vector<std::array<double, 2>>, double>;

/**
 * Flatten a state. `used` are the ranges of the axes, low < high. Regions whose geometry vanishes
 * or overflows in axis units are left out. `cache` may be null; it is reduced to what was used.
 */
vtkTFCCompiledModel vtkTFCCompileState(const vtkTFCState& state,
  const std::array<std::array<double, 2>, 2>& used, vtkTFCPoleCache* cache);

/**
 * Largest distance from a point inside a closed even-odd outline to its nearest edge; 0 when
 * nothing is inside. Within 2e-4 of the size of the outline's bounding box of the largest, and a
 * local maximum to about 1e-10 of it. Cost: some thousand times the number of points.
 */
double vtkTFCMaximumEdgeDistance(const std::vector<std::array<double, 2>>& points);

#endif
