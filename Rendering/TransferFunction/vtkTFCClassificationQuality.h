// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCClassificationQuality
 * @brief How well a transfer function finds labelled materials, and how well any could.
 *
 * Input: vtkImageData with the attributes of the transfer function and an integer array of labels
 * (the truth), all on points or all on cells. Every voxel goes to the region that vtkTFCClassify
 * writes to `tfc_region`: that with the largest contribution, or none (NaN, outside of the axes).
 * Blanked voxels and those with ignored labels are left out of everything.
 *
 * Port 1, table "Confusion", a row per label, ascending: `label`, `none`, and `region ID` for every
 * visible region with an opacity, in list order: numbers of voxels.
 *
 * Port 0, table "Quality", a row per label with L voxels. The region is the one with the largest
 * Dice coefficient, of R voxels, B of them with the label (the first of the list among equals):
 * - `label`, `voxels` (L), `region` (id) and `region_name`; 0 and empty when no region has any;
 * - `precision` = B / R, `recall` = B / L, `dice` = 2 B / (L + R), `leakage` = (R - B) / R: the
 * part of the region that shows other labels. All in [0, 1], and 0 without a region;
 * - `axes_dice`: what the two axes alone could reach, and `best_dice`: that or the same with one of
 * the tertiary attributes in use, whichever is larger; `best_attribute`: which, empty for none;
 * - `limited_by`: "neither" when dice >= 0.95; else the larger part of what is missing: "regions"
 * when best_dice - dice > 1 - best_dice (other regions over the same attributes would do better),
 * "axes" otherwise (other attributes are needed).
 *
 * The best that any transfer function could do: a region selects a set in the space (primary,
 * secondary, tertiary), and several of them any union of boxes. So cells of a joint histogram are
 * chosen for each label, at the optimum, and judged on voxels that did not take part in the choice;
 * see vtkTFCLabelHistogram. Cells divide the ranges of the axes, and the finite extent of a
 * tertiary attribute, into NumberOfBins equal parts, and coarser ones by powers of two. It is an
 * estimate: smooth attributes make neighbouring voxels alike, also across the halves, and for small
 * labels a region with a clear border may do better than cells can learn.
 *
 * On several processes every voxel counts once and all numbers are exactly those of one process.
 * Errors leave empty tables: no integer label array, unknown arrays, attributes of different kinds,
 * more than 4096 labels or 4 million entries of the confusion table.
 *
 * Two threaded passes over the data, and one over axes without a range and over tertiary
 * attributes. Memory: up to 64 bytes per occupied cell, label, half and thread, for the axes alone
 * and again for each tertiary attribute; never more cells than voxels. 1 byte per voxel on several
 * processes.
 *
 * @sa vtkTFCClassify
 */

#ifndef vtkTFCClassificationQuality_h
#define vtkTFCClassificationQuality_h

#include "vtkNew.h"                       // For the model
#include "vtkTFCTransferFunctionModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For the state
#include <vector> // For labels

class vtkMultiProcessController;
class vtkTFCTransferFunction;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCClassificationQuality : public vtkTableAlgorithm
{
public:
  static vtkTFCClassificationQuality* New();
  vtkTypeMacro(vtkTFCClassificationQuality, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the array with the labels: of any integer type, one component, values below 2^53 in
   * magnitude. Must be set.
   */
  vtkSetStringMacro(LabelArray);
  vtkGetStringMacro(LabelArray);
  ///@}

  ///@{
  /**
   * The transfer function as JSON text (see vtkTFCTransferFunction). A text that cannot be read
   * raises an error and leaves the previous one in force. Must name both axes; without regions only
   * `axes_dice` and `best_dice` tell something.
   */
  void SetTransferFunction(const char* json);
  std::string GetTransferFunction() const;
  ///@}

  /**
   * The model itself, for edits without text. Never null.
   */
  vtkTFCTransferFunction* GetModel() const;

  ///@{
  /**
   * Bins per axis of the finest joint histograms: 2 to 1024. Default 64.
   */
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * Labels of voxels whose truth is not known. Default: none.
   */
  void AddIgnoredLabel(vtkIdType label);
  void ClearIgnoredLabels();
  ///@}

  ///@{
  /**
   * On: every process has the same tables. Off: the lowest process has the rows and the others have
   * the same columns without rows. Default on.
   */
  vtkSetMacro(TablesOnAllProcesses, bool);
  vtkGetMacro(TablesOnAllProcesses, bool);
  vtkBooleanMacro(TablesOnAllProcesses, bool);
  ///@}

  ///@{
  /**
   * The processes that share the data. Default: the global controller. Null: this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const { return this->Controller; }
  ///@}

  /**
   * Newest of the filter and its model.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkTFCClassificationQuality();
  ~vtkTFCClassificationQuality() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs) override;

private:
  vtkTFCClassificationQuality(const vtkTFCClassificationQuality&) = delete;
  void operator=(const vtkTFCClassificationQuality&) = delete;

  std::string CheckSettings() const;

  vtkNew<vtkTFCTransferFunction> Model;
  std::vector<double> IgnoredLabels;
  char* LabelArray = nullptr;
  int NumberOfBins = 64;
  bool TablesOnAllProcesses = true;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
