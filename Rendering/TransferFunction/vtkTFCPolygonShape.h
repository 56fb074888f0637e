// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCPolygonShape
 * @brief A closed polygon, e.g. of the lasso; JSON {"type": "polygon", "points": [[x, y], ...]}.
 *
 * Inside is by the even-odd rule, so outlines may cross themselves. Normalised distance, in axis
 * units: 1 - e / E, with e the distance to the nearest edge and E the largest such distance inside
 * (exact to 2e-4 of the longer side of the bounding box).
 */

#ifndef vtkTFCPolygonShape_h
#define vtkTFCPolygonShape_h

#include "vtkTFCShape.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro

class vtkPoints;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCPolygonShape : public vtkTFCShape
{
public:
  static vtkTFCPolygonShape* New();
  vtkTypeMacro(vtkTFCPolygonShape, vtkTFCShape);

  /**
   * The corners in order, data units of the two axes: x and y of each point, 3 to 10000 points that
   * are not all on one line; the last one is joined to the first. Returns false with an error, and
   * changes nothing, when they are not such. Default (0, 0), (1, 0), (0, 1).
   */
  bool SetPoints(vtkPoints* points);

  int GetNumberOfPoints() const;

  /**
   * One corner; (0, 0) when there is no such index.
   */
  void GetPoint(int index, double point[2]) const;

protected:
  vtkTFCPolygonShape();
  ~vtkTFCPolygonShape() override = default;

private:
  vtkTFCPolygonShape(const vtkTFCPolygonShape&) = delete;
  void operator=(const vtkTFCPolygonShape&) = delete;
};

#endif
