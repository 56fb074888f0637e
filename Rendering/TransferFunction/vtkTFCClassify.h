// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCClassify
 * @brief Evaluates a combined transfer function on every point or cell of a volume.
 *
 * Input: vtkImageData, or a composite dataset of such blocks. Output: the input with three arrays,
 * on the points or cells that the attributes are on: `tfc_rgba` (float, 4 components in [0, 1]):
 * straight colour and opacity, 0 0 0 0 where nothing is; `tfc_region` (int): id of the region with
 * the largest contribution, 0 for none; `tfc_opacity` (float): the opacity again, as a scalar.
 * vtkTFCClassifier says how they are computed. NaN and blanked values get zero.
 *
 * Axes without a range take the finite extent of their attribute over all blocks and ranks, blanked
 * values left out. With a missing array, a component that does not exist or attributes of different
 * kinds on any rank, an error says so and the output is the input.
 *
 * Threaded (see vtkTFCThreads); the result does not depend on the number of threads or ranks.
 * Memory: 24 bytes per value for the arrays, nothing else that grows with the data.
 */

#ifndef vtkTFCClassify_h
#define vtkTFCClassify_h

#include "vtkNew.h" // For the model
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro

#include <string> // For the state

class vtkMultiProcessController;
class vtkTFCTransferFunction;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCClassify : public vtkPassInputTypeAlgorithm
{
public:
  static vtkTFCClassify* New();
  vtkTypeMacro(vtkTFCClassify, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The transfer function as JSON text (see vtkTFCTransferFunction). A text that cannot be read
   * raises an error and leaves the previous one in force. Default: empty, which classifies nothing.
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
   * Ranks over which automatic axis ranges are taken. Default: the global controller.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const { return this->Controller; }
  ///@}

  /**
   * Newest of the filter and its model.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkTFCClassify();
  ~vtkTFCClassify() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs) override;

private:
  vtkTFCClassify(const vtkTFCClassify&) = delete;
  void operator=(const vtkTFCClassify&) = delete;

  vtkNew<vtkTFCTransferFunction> Model;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
