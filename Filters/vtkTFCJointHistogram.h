// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCJointHistogram
 * @brief Joint histogram of a primary, a secondary and, if wanted, a tertiary attribute.
 *
 * One pass over the data yields a vtkTFCSparseHistogram, which then answers every conditional
 * histogram at the cost of bins, not of voxels. Input: a dataset, or a composite one whose leaves
 * are taken together. The attributes are components of arrays, all of points or all of cells.
 *
 * Not counted: NaN and infinite values, blanked (HIDDENPOINT, HIDDENCELL) and duplicate samples
 * (of other processes), what is outside of the range of the first two axes; see
 * vtkTFCSparseHistogram for the third. On several processes every sample counts once, and all
 * processes get the same histogram, which does not depend on their number: the pieces of one
 * structured dataset share faces, which is taken care of; in composite and unstructured data what
 * is shared must be flagged as duplicate. All processes of the controller must update together.
 *
 * Output, a table of the entries: `cell` (secondary bin times bins of the primary axis plus primary
 * bin), `tertiary_bin` (the number of bins stands for "no tertiary") and `count`.
 *
 * Errors leave an empty histogram: an array or component that does not exist, attributes of points
 * and cells mixed, an axis without any finite value, wrong bins or ranges.
 *
 * Threaded, in integers: the result does not depend on the number of threads. Memory: up to 64
 * bytes per occupied bin and thread while counting, and up to 1 byte per sample for the samples of
 * other processes. An axis without a range costs one more pass over its attribute.
 */

#ifndef vtkTFCJointHistogram_h
#define vtkTFCJointHistogram_h

#include "vtkNew.h"              // For the histogram
#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <array>  // For axes
#include <string> // For names
#include <vector> // For ranges

class vtkDataSet;
class vtkMultiProcessController;
class vtkTFCSparseHistogram;

class VTKTFCFILTERS_EXPORT vtkTFCJointHistogram : public vtkTableAlgorithm
{
public:
  static vtkTFCJointHistogram* New();
  vtkTypeMacro(vtkTFCJointHistogram, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The attribute of axis 0 (primary), 1 (secondary) or 2 (tertiary): name of an array and
   * component, -1 for the magnitude. The first two must be set; a null or empty name removes one.
   */
  void SetArray(int axis, const char* name, int component = 0);
  const char* GetArray(int axis) const;
  int GetComponent(int axis) const;
  ///@}

  ///@{
  /**
   * The range of an axis in data units, minimum <= maximum. Default: none, the finite extent of the
   * attribute over all blocks and processes.
   */
  void SetRange(int axis, double minimum, double maximum);
  void ClearRange(int axis);
  ///@}

  ///@{
  /**
   * Bins of an axis, 1 to vtkTFCSparseHistogram::MostBins. Default 256.
   */
  void SetNumberOfBins(int axis, int bins);
  int GetNumberOfBins(int axis) const;
  ///@}

  /**
   * The histogram after Update(): never null, without entries after an error.
   */
  vtkTFCSparseHistogram* GetHistogram() const { return this->Histogram; }

  ///@{
  /**
   * On: every process has the table. Off: the lowest process has the rows and the others have the
   * same columns without rows. The histogram is on all processes. Default on.
   */
  vtkSetMacro(TablesOnAllProcesses, bool);
  vtkGetMacro(TablesOnAllProcesses, bool);
  vtkBooleanMacro(TablesOnAllProcesses, bool);
  ///@}

  ///@{
  /**
   * The processes that share the data. Default: the global controller. Null: this process alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkTFCJointHistogram();
  ~vtkTFCJointHistogram() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs) override;

private:
  vtkTFCJointHistogram(const vtkTFCJointHistogram&) = delete;
  void operator=(const vtkTFCJointHistogram&) = delete;

  bool CheckIndex(int axis);
  std::string Compute(const std::vector<vtkDataSet*>& blocks);
  void FillTable(vtkTable* table) const;

  struct Axis
  {
    std::string Array;
    int Component = 0;
    bool HasRange = false;
    double Range[2] = { 0., 1. };
    int Bins = 256;
  };
  std::array<Axis, 3> Axes;
  vtkNew<vtkTFCSparseHistogram> Histogram;
  bool TablesOnAllProcesses = true;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
