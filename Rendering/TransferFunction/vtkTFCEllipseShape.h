// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCEllipseShape
 * @brief An ellipse; JSON {"type": "ellipse", "center", "radii", "angle"}.
 *
 * Normalised distance, in axis units: sqrt((x' / rx)^2 + (y' / ry)^2), where (x', y') is the offset
 * from the centre turned back by the angle. 0 at the centre, 1 on the outline.
 */

#ifndef vtkTFCEllipseShape_h
#define vtkTFCEllipseShape_h

#include "vtkTFCShape.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCEllipseShape : public vtkTFCShape
{
public:
  static vtkTFCEllipseShape* New();
  vtkTypeMacro(vtkTFCEllipseShape, vtkTFCShape);

  ///@{
  /**
   * Centre, data units of the two axes. Default (0, 0).
   */
  void SetCenter(double x, double y);
  void GetCenter(double center[2]) const;
  ///@}

  ///@{
  /**
   * Radii, each in data units of its axis, before rotation, > 0. Default (1, 1).
   */
  void SetRadii(double x, double y);
  void GetRadii(double radii[2]) const;
  ///@}

  ///@{
  /**
   * Rotation in degrees, counter-clockwise, in axis units. Default 0.
   */
  void SetAngle(double angle);
  double GetAngle() const;
  ///@}

protected:
  vtkTFCEllipseShape();
  ~vtkTFCEllipseShape() override = default;

private:
  vtkTFCEllipseShape(const vtkTFCEllipseShape&) = delete;
  void operator=(const vtkTFCEllipseShape&) = delete;
};

#endif
