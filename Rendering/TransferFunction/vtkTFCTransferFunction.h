// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCTransferFunction
 * @brief The combined transfer function: two axes and a list of regions, each with its own 1D
 * function of a third attribute.
 *
 * This is the model that filters, mappers and panels share. Its exchange form is JSON text, version
 * 1 of "transfer-function-combination"; all of it is in data units.
 *
 * Defaults when a key of the JSON is missing: axes null (then nothing can be drawn), axis component
 * 0, axis range null (automatic: the finite extent of the data, see ResolveRanges()), blend "mix",
 * regions []; in a region: name "region N", visible true, falloff smooth with width 0.25, color
 * [1, 1, 1], opacity 1, tertiary null, angle 0. Required: format, version, and in a region id (1 to
 * 999999999) and shape. Component -1 means the magnitude of the vector. Unknown keys are errors, so
 * that typing mistakes are found, except that the state and its regions keep keys that start
 * with "x-". Limits: 8 MiB of text, 10000 regions, points per polygon and nodes per function,
 * numbers up to 1e300.
 *
 * GetMTime() covers the regions and their shapes, and changes with every edit that changes
 * something and with the highlighted region, and only then.
 */

#ifndef vtkTFCTransferFunction_h
#define vtkTFCTransferFunction_h

#include "vtkObject.h"
#include "vtkTFCCompiledModel.h"          // For the result of Compile()
#include "vtkTFCTransferFunctionModule.h" // For export macro
#include "vtkWrappingHints.h"             // For VTK_WRAPEXCLUDE

#include <memory> // For std::unique_ptr
#include <string> // For the state
#include <vector> // For attributes

class vtkTFCRegion;
struct vtkTFCState;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCTransferFunction : public vtkObject
{
public:
  static vtkTFCTransferFunction* New();
  vtkTypeMacro(vtkTFCTransferFunction, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Newest of the axes, the list, every region and every shape.
   */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The whole model as JSON. SetState() checks everything before it changes anything: on an error
   * it returns false, raises the message, keeps the previous state in force and GetLastError()
   * names the field and what was expected (empty after a success). A state equal to the current one
   * changes nothing. Regions are matched by id: a region that stays is the same object, updated. An
   * empty or null text is a model without axes and regions.
   */
  bool SetState(const char* json);
  std::string GetState() const;
  const std::string& GetLastError() const { return this->LastError; }
  ///@}

  ///@{
  /**
   * Whether the model was proposed by a program and nobody has edited it yet: kept in the state as
   * "x-proposal". Editors say so and clear it with the first edit. Default false.
   */
  void SetProposal(bool proposal);
  bool GetProposal() const;
  ///@}

  ///@{
  /**
   * A note in the state: JSON text under a key that starts with "x-". An empty text removes the
   * note. SetNote() returns false with an error, and changes nothing, for another key or for what
   * is not JSON. GetNote() is empty when there is none.
   */
  bool SetNote(const char* key, const std::string& json);
  std::string GetNote(const char* key) const;
  ///@}

  enum Axes
  {
    Primary = 0,
    Secondary = 1
  };

  ///@{
  /**
   * The attribute of an axis (Primary or Secondary): array name and component, -1 for the magnitude
   * of the vector. A null or empty name removes the axis. Changing it leaves the range as it is.
   */
  void SetAxis(int axis, const char* array, int component = 0);
  const std::string& GetAxisArray(int axis) const;
  int GetAxisComponent(int axis) const;
  bool HasAxes() const;
  ///@}

  ///@{
  /**
   * The extent of an axis in data units, low < high. Without one it is automatic, and
   * GetAxisRange() returns false.
   */
  void SetAxisRange(int axis, double low, double high);
  void ClearAxisRange(int axis);
  bool HasAxisRange(int axis) const;
  bool GetAxisRange(int axis, double range[2]) const;
  ///@}

  /**
   * The ranges to use for data whose finite extents (over all ranks and blocks) are `primary` and
   * `secondary`: the model's own where it has one, else the data's. An extent that is empty or not
   * finite counts as [0, 1], one of a single value v as v -+ max(0.5, |v| / 2). Null: [0, 1].
   * `used` becomes {primary low, high, secondary low, high}. Changes nothing in the model.
   */
  void ResolveRanges(const double primary[2], const double secondary[2], double used[4]) const;

  ///@{
  /**
   * How regions that share a sample combine: Mix (order does not matter) or Over (the first region
   * of the list is in front). Default Mix.
   */
  enum BlendTypes
  {
    Mix,
    Over
  };
  void SetBlend(int blend);
  int GetBlend() const;
  ///@}

  ///@{
  /**
   * The regions, in list order. AddRegion() appends a region, gives it the largest id ever used
   * plus one and returns that; 0 when it is null or already in a list. AddNewRegion() makes one
   * with a shape of that type ("ellipse", ...) and returns it, null for an unknown type.
   */
  int GetNumberOfRegions() const;
  vtkTFCRegion* GetRegion(int index) const;
  vtkTFCRegion* GetRegionById(int id) const;
  int AddRegion(vtkTFCRegion* region);
  vtkTFCRegion* AddNewRegion(const char* shapeType);
  void RemoveRegion(vtkTFCRegion* region);
  void RemoveAllRegions();
  void MoveRegion(int from, int to);
  ///@}

  ///@{
  /**
   * Id of a region that Compile() lets stand out: all others have HighlightDimming times their
   * opacity. It is a look, no edit: the state has nothing of it. 0, or the id of a region that
   * takes no part in classification: none. Default 0.
   */
  static constexpr double HighlightDimming = 0.02;
  void SetHighlightedRegion(int id);
  int GetHighlightedRegion() const { return this->HighlightedRegion; }
  ///@}

  /**
   * The attributes that an evaluation needs, as listed in vtkTFCCompiledModel::Attributes.
   */
  VTK_WRAPEXCLUDE std::vector<vtkTFCAttribute> GetAttributes() const;

  ///@{
  /**
   * The model as plain numbers for evaluation, in the axis units of `used` (see ResolveRanges());
   * the second form takes [0, 1] for automatic axes. Cost: tens of microseconds, and about a
   * millisecond for a polygon that was not in the previous call. Not thread-safe.
   */
  VTK_WRAPEXCLUDE vtkTFCCompiledModel Compile(const double used[4]) const;
  VTK_WRAPEXCLUDE vtkTFCCompiledModel Compile() const;
  ///@}

protected:
  vtkTFCTransferFunction();
  ~vtkTFCTransferFunction() override;

private:
  vtkTFCTransferFunction(const vtkTFCTransferFunction&) = delete;
  void operator=(const vtkTFCTransferFunction&) = delete;

  vtkTFCState CollectState() const;
  int NewId();
  bool CheckAxis(int axis) const;

  struct Internals;
  std::unique_ptr<Internals> Internal;
  int HighlightedRegion = 0;
  std::string LastError;
};

#endif
