// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCRegion
 * @brief One region of a combined transfer function: shape, fall-off, colour, opacity and the
 * region's own 1D function of a third attribute.
 *
 * A sample gets alpha = opacity * w(d) * t, with d the shape's normalised distance, w the fall-off
 * and t the tertiary function. Like shapes, regions are always valid: setters refuse what a state
 * may not hold, raise an error and change nothing. GetMTime() includes the shape.
 */

#ifndef vtkTFCRegion_h
#define vtkTFCRegion_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"              // For the shape
#include "vtkTFCTransferFunctionModule.h" // For export macro
#include "vtkWrappingHints.h"             // For VTK_WRAPEXCLUDE

#include <memory> // For std::unique_ptr
#include <string> // For names

class vtkDoubleArray;
class vtkTFCShape;
class vtkTFCTransferFunction;
struct vtkTFCRegionState;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCRegion : public vtkObject
{
public:
  static vtkTFCRegion* New();
  vtkTypeMacro(vtkTFCRegion, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Newest of the region and its shape.
   */
  vtkMTimeType GetMTime() override;

  /**
   * The fall-offs w(d) for 0 <= d <= 1, 0 beyond: constant 1; linear min(1, (1 - d) / width);
   * smooth the smoothstep of linear; gaussian exp(-d^2 / (2 width^2)).
   */
  enum FalloffTypes
  {
    Constant,
    Linear,
    Smooth,
    Gaussian
  };

  /**
   * Unique within a transfer function and stable over edits; 0 until the region is in one, which
   * assigns it.
   */
  int GetId() const;

  ///@{
  /**
   * UTF-8 text shown to users. Default "region N", N the id, given when the region is added.
   */
  void SetName(const char* name);
  const std::string& GetName() const;
  ///@}

  ///@{
  /**
   * Invisible regions take no part in classification. Default true.
   */
  void SetVisible(bool visible);
  bool GetVisible() const;
  vtkBooleanMacro(Visible, bool);
  ///@}

  ///@{
  /**
   * Whether editors refuse to change the region by accident: kept in the state as "x-locked".
   * Setters of this class do not look at it, and it takes no part in classification. Default false.
   */
  void SetLocked(bool locked);
  bool GetLocked() const;
  vtkBooleanMacro(Locked, bool);
  ///@}

  ///@{
  /**
   * The outline; never null. Default an ellipse. Setting null is an error.
   */
  void SetShape(vtkTFCShape* shape);
  vtkTFCShape* GetShape() const;
  ///@}

  ///@{
  /**
   * Fall-off: one of FalloffTypes, and its width in (0, 1]. Default Smooth, 0.25.
   */
  void SetFalloff(int type, double width);
  int GetFalloffType() const;
  double GetFalloffWidth() const;
  ///@}

  ///@{
  /**
   * Colour, each component in [0, 1]. Default white.
   */
  void SetColor(double red, double green, double blue);
  void GetColor(double color[3]) const;
  ///@}

  /**
   * The n-th of eight colours that people with colour-blindness can tell apart, for new regions: M.
   * Okabe and K. Ito, Color Universal Design (2008), with grey for black.
   */
  static void GetPaletteColor(int n, double color[3]);

  ///@{
  /**
   * Opacity in [0, 1] where fall-off and tertiary function are 1. Default 1.
   */
  void SetOpacity(double opacity);
  double GetOpacity() const;
  ///@}

  ///@{
  /**
   * The tertiary function. `nodes` has two components {value in data units, opacity in [0, 1]} and
   * `colors`, which may be null, four {value, red, green, blue}; values increase, and two nodes at
   * one value make a step whose second node holds from that value on. Both are piecewise linear
   * with their ends extended. `component` -1 is the vector magnitude. Returns false with an error
   * when something of this does not hold.
   */
  bool SetTertiary(const char* array, int component, vtkDoubleArray* nodes,
    vtkDoubleArray* colors = nullptr);
  void RemoveTertiary();
  bool HasTertiary() const;
  const std::string& GetTertiaryArray() const;
  int GetTertiaryComponent() const;
  ///@}

  ///@{
  /**
   * Extent of the tertiary attribute's axis in an editor, data units. It does not take part in
   * classification. GetTertiaryRange() returns false when it is automatic, which is the default.
   */
  void SetTertiaryRange(double low, double high);
  void ClearTertiaryRange();
  bool GetTertiaryRange(double range[2]) const;
  ///@}

  ///@{
  /**
   * Copies of the nodes; empty when there are none.
   */
  void GetTertiaryOpacityNodes(vtkDoubleArray* nodes) const;
  void GetTertiaryColorNodes(vtkDoubleArray* nodes) const;
  ///@}

  /**
   * Take over all values of another region but its id. The shape is copied, not shared.
   */
  void DeepCopy(vtkTFCRegion* other);

  ///@{
  /**
   * All values at once, for vtkTFCTransferFunction. SetValues() expects valid values, keeps the
   * shape object when its type stays, and calls Modified() only when something changes.
   */
  VTK_WRAPEXCLUDE vtkTFCRegionState GetValues() const;
  VTK_WRAPEXCLUDE void SetValues(const vtkTFCRegionState& values);
  ///@}

protected:
  vtkTFCRegion();
  ~vtkTFCRegion() override;

private:
  vtkTFCRegion(const vtkTFCRegion&) = delete;
  void operator=(const vtkTFCRegion&) = delete;

  std::unique_ptr<vtkTFCRegionState> Values; ///< its Shape is unused: the object below holds it
  vtkSmartPointer<vtkTFCShape> Shape;
};

#endif
