// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCClassifier
 * @brief Evaluates a compiled combined transfer function on samples: the CPU reference.
 *
 * For every region j a sample gets alpha_j = opacity_j * weight_j(primary, secondary) *
 * tertiary_j(value of its third attribute). Blend `mix`: alpha = 1 - prod(1 - alpha_j), colour =
 * sum(alpha_j c_j) / sum(alpha_j). Blend `over`: the first region is in front, colour is the
 * straight (not premultiplied) colour of the stack.
 *
 * All arithmetic is double precision. A sample whose primary or secondary value is NaN or outside
 * the range of its axis (in data units, both ends belong to it) is in no region. A region whose
 * tertiary value is NaN does not see the sample; infinite tertiary values take the end nodes.
 *
 * The object is immutable after construction; Classify() allocates nothing and may run on any
 * number of threads at once. Cost per sample: constant per region for ellipse, rectangle and
 * triangle, proportional to the number of points for polygons, logarithmic in the tertiary nodes;
 * samples outside a region's bounding box cost two comparisons.
 */

#ifndef vtkTFCClassifier_h
#define vtkTFCClassifier_h

#include "vtkTFCCompiledModel.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro

#include <array>   // For colours
#include <cstddef> // For size_t
#include <vector>  // For edges

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCClassifier
{
public:
  explicit vtkTFCClassifier(vtkTFCCompiledModel model);

  const vtkTFCCompiledModel& GetModel() const { return this->Model; }

  /**
   * Classify `count` samples. `attributes` holds one pointer per entry of GetModel().Attributes,
   * each to `count` values in data units. Any output may be null:
   * `rgba`: 4 values per sample in [0, 1], straight colour, 0 0 0 0 where nothing is;
   * `regionId`: id of the region with the largest contribution, 0 for none, the first of the list
   * among equals. The contribution is alpha_j for `mix`, and what of it the regions in front leave
   * for `over`;
   * `opacity`: the alpha of `rgba`.
   */
  void Classify(std::size_t count, const double* const* attributes, float* rgba,
    int* regionId = nullptr, float* opacity = nullptr) const;

  /**
   * Weight of a region in [0, 1] at a point in axis units: shape and fall-off, without opacity and
   * tertiary function. Does not look at the range of the axes. 0 for NaN.
   */
  static double RegionWeight(const vtkTFCCompiledRegion& region, double x, double y);

  /**
   * Weight of a fall-off in [0, 1] at normalised distance `d`: 0 for d > 1 and NaN.
   */
  static double FalloffWeight(vtkTFCFalloffType falloff, double width, double d);

  /**
   * Factor in [0, 1] of a region's tertiary function at a value in data units: 1 when the region
   * has none, 0 for NaN.
   */
  static double TertiaryOpacity(const vtkTFCCompiledRegion& region, double value);

  /**
   * Colour of a region where its tertiary attribute has this value: the region's colour when it has
   * no tertiary colours or the value is NaN.
   */
  static std::array<double, 3> TertiaryColor(const vtkTFCCompiledRegion& region, double value);

private:
  struct Edge
  {
    double X, Y, DX, DY, InverseSquare;
  };
  struct Chunk;

  static std::vector<Edge> MakeEdges(const vtkTFCCompiledRegion& region);
  static double EdgeDistance(const std::vector<Edge>& edges, double maximum, double x, double y);
  static void ApplyFalloff(const vtkTFCCompiledRegion& region, Chunk& chunk);
  void ClassifyRegion(std::size_t index, const double* const* attributes, std::size_t first,
    Chunk& chunk) const;

  vtkTFCCompiledModel Model;
  std::vector<std::vector<Edge>> Edges; ///< per region; empty unless triangle or polygon
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCClassifier.h
