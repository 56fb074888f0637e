// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The geometry of a region's shape as an editor handles it: hit tests, handles and what
 * dragging them does. A plain value; everything is in axis units.
 *
 * Axis units: (v - low) / (high - low) of each axis, so that angles and distances mean the same as
 * in the model, whatever the units of the data.
 */

#ifndef vtkTFCOutline_h
#define vtkTFCOutline_h

#include "vtkSmartPointer.h"    // For new shapes
#include "vtkTFCChartsModule.h" // For export macro

#include <array>  // For points
#include <vector> // For lists of points

class vtkTFCShape;

class VTKTFCCHARTS_EXPORT vtkTFCOutline
{
public:
  using Point = std::array<double, 2>;
  /// {primary low, high, secondary low, high} in data units, low < high.
  using Ranges = std::array<double, 4>;

  enum class Types
  {
    Ellipse,
    Rectangle,
    Triangle,
    Polygon
  };

  /// What a handle does: Corner and Side resize a box, Vertex moves a corner of an outline, Size
  /// scales one, Turn rotates.
  enum class Handles
  {
    Corner,
    Side,
    Vertex,
    Size,
    Turn
  };
  struct Handle
  {
    Handles Kind = Handles::Vertex;
    int Index = 0;
    Point Position = { 0, 0 };
  };

  /// How a drag is constrained. Proportional keeps the ratio of the sides, and turns in steps of 15
  /// degrees; Symmetric keeps the centre where it is instead of the opposite side.
  struct Constraints
  {
    bool Proportional = false;
    bool Symmetric = false;
  };

  Types Type = Types::Ellipse;
  Point Center = { 0, 0 };
  Point HalfSize = { 0.1, 0.1 }; ///< radii of an ellipse
  double Angle = 0;              ///< degrees, counter-clockwise
  std::vector<Point> Points;     ///< triangle and polygon

  ///@{
  /**
   * From and to the model. Store() writes into a shape of the same type and returns false, without
   * raising the shape's error, when the outline encloses no area or is not finite.
   */
  static vtkTFCOutline FromShape(const vtkTFCShape* shape, const Ranges& ranges);
  bool Store(vtkTFCShape* shape, const Ranges& ranges) const;
  vtkSmartPointer<vtkTFCShape> NewShape(const Ranges& ranges) const;
  ///@}

  /**
   * Box, ellipse or triangle that fills the rectangle between two corners; polygons take all of
   * `points`.
   */
  static vtkTFCOutline Between(Types type, const Point& a, const Point& b);
  static vtkTFCOutline FromPoints(std::vector<Point> points);

  bool IsBox() const { return this->Type == Types::Ellipse || this->Type == Types::Rectangle; }
  bool IsValid() const;

  /**
   * The closed outline as points; an ellipse has `segments` of them.
   */
  std::vector<Point> GetPolyline(int segments = 96) const;

  /**
   * xmin, xmax, ymin, ymax.
   */
  std::array<double, 4> GetBounds() const;

  /**
   * Even-odd, as in the model.
   */
  bool Contains(const Point& p) const;
  double GetArea() const;

  /**
   * Handles; `margin` is how far outside the outline the handles Turn and Size lie, along each
   * axis.
   */
  std::vector<Handle> GetHandles(const Point& margin) const;

  /**
   * The outline after `handle` was dragged from one point to another. Never folds over: a box keeps
   * at least `smallest` along each axis.
   */
  vtkTFCOutline Drag(const Handle& handle, const Point& from, const Point& to,
    const Constraints& constraints, const Point& smallest) const;

  vtkTFCOutline Moved(const Point& offset) const;
  vtkTFCOutline Turned(double degrees) const;
  vtkTFCOutline Scaled(double x, double y, const Point& fixed) const;

  ///@{
  /**
   * Vertices of polygons. NearestEdge() is the index of the edge whose start is Points[index], with
   * the distance in units of `scale` along each axis. A triangle becomes a polygon when a vertex is
   * inserted. RemoveVertex() returns false when fewer than three would remain.
   */
  int NearestEdge(const Point& p, const Point& scale, double* distance) const;
  bool InsertVertex(int edge, const Point& p);
  bool RemoveVertex(int index);
  ///@}

  /**
   * The line along which the fall-off goes from the innermost point (d = 0) to the outline (d = 1):
   * where an editor puts the handle of its width. For polygons the innermost point is found on a
   * grid, to 1/48 of the bounding box.
   */
  void GetFalloffLine(Point& inner, Point& outer) const;

private:
  Point ToLocal(const Point& p) const;
  Point FromLocal(const Point& p) const;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCOutline.h
