// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCTransferFunctionHistogram
 * @brief What a combined transfer function's axes and regions select: histograms.
 *
 * Input: vtkImageData, or a composite dataset of such blocks, with the attributes of the transfer
 * function, all on points or all on cells.
 *
 * Port 0: the joint histogram of the two axes as an image of NumberOfBins x NumberOfBins points in
 * data units of the axes: a point is the centre of a bin, its `count` (double) the number of voxels
 * there. Voxels outside of the ranges, NaN and blanked ones are in none.
 *
 * Port 1, table "Conditional": for every visible region with a tertiary attribute the columns
 * `region ID NAME`, the bin centres of the attribute NAME in data units, and `region ID count`: the
 * histogram of the attribute over the voxels in the region, each with the region's weight (shape
 * and fall-off, in [0, 1], without opacity and tertiary function) at the centre of its 2D bin. The
 * weights come from vtkTFCClassifier, as in vtkTFCClassify. Rows are the bins: NumberOfBins equal
 * parts of the region's tertiary range, or, when it is automatic, of the attribute's finite extent.
 *
 * On several processes every voxel counts once and the numbers are those of one process; see
 * vtkTFCJointHistogram. Errors, as of vtkTFCClassify, leave the outputs empty.
 *
 * Cost: one pass over the data per different tertiary attribute and range; see vtkTFCJointHistogram
 * for time and memory. Histograms are kept: when only regions change, no pass is needed.
 */

#ifndef vtkTFCTransferFunctionHistogram_h
#define vtkTFCTransferFunctionHistogram_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkNew.h"                       // For the model
#include "vtkTFCTransferFunctionModule.h" // For export macro

#include <memory> // For the kept histograms
#include <string> // For the state

class vtkMultiProcessController;
class vtkTFCTransferFunction;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCTransferFunctionHistogram : public vtkDataObjectAlgorithm
{
public:
  static vtkTFCTransferFunctionHistogram* New();
  vtkTypeMacro(vtkTFCTransferFunctionHistogram, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The transfer function as JSON text (see vtkTFCTransferFunction). A text that cannot be read
   * raises an error and leaves the previous one in force. Must name both axes.
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
   * Bins of every axis: 2 to 1024. Default 256.
   */
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * On: every process has the outputs. Off: only the lowest process has. Default on.
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
  vtkTFCTransferFunctionHistogram();
  ~vtkTFCTransferFunctionHistogram() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs) override;

private:
  vtkTFCTransferFunctionHistogram(const vtkTFCTransferFunctionHistogram&) = delete;
  void operator=(const vtkTFCTransferFunctionHistogram&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
  vtkNew<vtkTFCTransferFunction> Model;
  int NumberOfBins = 256;
  bool TablesOnAllProcesses = true;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
