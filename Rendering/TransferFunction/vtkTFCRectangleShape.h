// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCRectangleShape
 * @brief A rectangle; JSON {"type": "rectangle", "center", "halfsize", "angle"}.
 *
 * Normalised distance, in axis units: max(|x'| / hx, |y'| / hy), where (x', y') is the offset from
 * the centre turned back by the angle. 0 at the centre, 1 on the outline.
 */

#ifndef vtkTFCRectangleShape_h
#define vtkTFCRectangleShape_h

#include "vtkTFCShape.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCRectangleShape : public vtkTFCShape
{
public:
  static vtkTFCRectangleShape* New();
  vtkTypeMacro(vtkTFCRectangleShape, vtkTFCShape);

  ///@{
  /**
   * Centre, data units of the two axes. Default (0, 0).
   */
  void SetCenter(double x, double y);
  void GetCenter(double center[2]) const;
  ///@}

  ///@{
  /**
   * Half of the two side lengths, each in data units of its axis, before rotation, > 0. Default (1,
   * 1).
   */
  void SetHalfSize(double x, double y);
  void GetHalfSize(double halfSize[2]) const;
  ///@}

  ///@{
  /**
   * Rotation in degrees, counter-clockwise, in axis units. Default 0.
   */
  void SetAngle(double angle);
  double GetAngle() const;
  ///@}

protected:
  vtkTFCRectangleShape();
  ~vtkTFCRectangleShape() override = default;

private:
  vtkTFCRectangleShape(const vtkTFCRectangleShape&) = delete;
  void operator=(const vtkTFCRectangleShape&) = delete;
};

#endif
