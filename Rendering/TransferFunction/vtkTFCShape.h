// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCShape
 * @brief The outline of a region in the plane of the primary and the secondary attribute.
 *
 * Coordinates are data units of the two axes. Angles are degrees, counter-clockwise, and taken in
 * axis units: in the unit square that the two axis ranges map to, so a rotated shape keeps its look
 * when the axes have unrelated units.
 *
 * A shape is always valid: setters refuse values that a state may not hold (not finite, radii <= 0,
 * points that enclose no area), raise an error and leave the shape as it was.
 *
 * Subclasses are containers of numbers; vtkTFCTransferFunction::Compile() turns them into what is
 * evaluated.
 */

#ifndef vtkTFCShape_h
#define vtkTFCShape_h

#include "vtkObject.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro
#include "vtkWrappingHints.h"             // For VTK_WRAPEXCLUDE

#include <memory> // For std::unique_ptr

struct vtkTFCShapeState;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCShape : public vtkObject
{
public:
  vtkTypeMacro(vtkTFCShape, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The word of the JSON state: "ellipse", "rectangle", "triangle" or "polygon".
   */
  const char* GetTypeName() const;

  /**
   * A new shape from such a word; null for any other. The caller owns it.
   */
  VTK_NEWINSTANCE static vtkTFCShape* NewShape(const char* typeName);

  ///@{
  /**
   * All values at once, for vtkTFCTransferFunction. SetValues() calls Modified() only when
   * something changes, and returns false with an error when the values are invalid or of another
   * type.
   */
  VTK_WRAPEXCLUDE const vtkTFCShapeState& GetValues() const { return *this->Values; }
  VTK_WRAPEXCLUDE bool SetValues(const vtkTFCShapeState& values);
  ///@}

protected:
  vtkTFCShape();
  ~vtkTFCShape() override;

  std::unique_ptr<vtkTFCShapeState> Values;

private:
  vtkTFCShape(const vtkTFCShape&) = delete;
  void operator=(const vtkTFCShape&) = delete;
};

#endif
