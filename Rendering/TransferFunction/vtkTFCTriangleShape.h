// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCTriangleShape
 * @brief A triangle; JSON {"type": "triangle", "points": [[x, y], [x, y], [x, y]]}.
 *
 * Normalised distance, in axis units: 1 - e / E, with e the distance to the nearest edge and E the
 * inradius. 0 at the incentre, 1 on the outline. Either orientation of the points is fine.
 */

#ifndef vtkTFCTriangleShape_h
#define vtkTFCTriangleShape_h

#include "vtkTFCShape.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCTriangleShape : public vtkTFCShape
{
public:
  static vtkTFCTriangleShape* New();
  vtkTypeMacro(vtkTFCTriangleShape, vtkTFCShape);

  /**
   * The three corners, data units of the two axes, not on one line. Default (0, 0), (1, 0), (0, 1).
   */
  void SetPoints(double x0, double y0, double x1, double y1, double x2, double y2);

  /**
   * Corner 0, 1 or 2; (0, 0) for any other index.
   */
  void GetPoint(int index, double point[2]) const;

protected:
  vtkTFCTriangleShape();
  ~vtkTFCTriangleShape() override = default;

private:
  vtkTFCTriangleShape(const vtkTFCTriangleShape&) = delete;
  void operator=(const vtkTFCTriangleShape&) = delete;
};

#endif
