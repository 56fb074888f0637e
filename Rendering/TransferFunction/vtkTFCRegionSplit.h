// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCRegionSplit
 * @brief Which attribute splits the voxels of each region of a transfer function best, and where.
 *
 * Input: vtkImageData, or a composite dataset of such blocks. For every visible region and every
 * attribute other than the axes, takes the attribute's histogram over the region's voxels, each
 * with the region's weight (shape and fall-off; see vtkTFCTransferFunctionHistogram), and looks for
 * two parts in it; Kernels/TFCSplit.h has formulas and sources. Output, table "Split", per region
 * in list order and best attribute first:
 * - `region` (id), `region_name`, `attribute`, `rank`: 1 = best, 0 when the region has no voxels or
 *   the attribute is constant there (the other columns are then NaN or empty);
 * - `power`: 0 to 1, separability times valley at the cut; `separability`: between-class variance
 *   over total variance at the best (Otsu's) threshold, 0 to 1, 0.64 for a single bell; `valley`:
 *   depth of the valley at the cut, 0 to 1, 0 for a single bell, 1 for a gap;
 * - `threshold` and `cut` (data units): the best threshold, and where the split is strongest;
 * - `below`: part of the weight below the cut; `voxels`: the weight;
 * - `keep_above` and `keep_below`: the value of the region's "tertiary" in the state that shows one
 *   part only, JSON text: a ramp over two bins at the cut.
 *
 * Histograms have NumberOfBins equal bins over the attribute's finite extent in the whole volume.
 * On several processes the table is that of one process. Errors, as of vtkTFCClassify, leave the
 * table empty. Cost: one pass over the data per attribute; histograms are kept while only regions
 * change. Memory: see vtkTFCJointHistogram.
 */

#ifndef vtkTFCRegionSplit_h
#define vtkTFCRegionSplit_h

#include "vtkNew.h"                       // For the model
#include "vtkTFCTransferFunctionModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <memory> // For the kept histograms
#include <string> // For the state
#include <vector> // For names

class vtkMultiProcessController;
class vtkTFCTransferFunction;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCRegionSplit : public vtkTableAlgorithm
{
public:
  static vtkTFCRegionSplit* New();
  vtkTypeMacro(vtkTFCRegionSplit, vtkTableAlgorithm);
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
   * The attributes to try: `name`, `name:2` or `name:magnitude`. None: all single-component numeric
   * arrays of the kind (points or cells) that the axes are of. The axes are left out.
   */
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{
  /**
   * Bins of every axis: 8 to 1024. Default 256.
   */
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * On: every process has the table. Off: the lowest process has the rows and the others have the
   * same columns without rows. Default on.
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
  vtkTFCRegionSplit();
  ~vtkTFCRegionSplit() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs) override;

private:
  vtkTFCRegionSplit(const vtkTFCRegionSplit&) = delete;
  void operator=(const vtkTFCRegionSplit&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
  std::vector<std::string> Arrays;
  vtkNew<vtkTFCTransferFunction> Model;
  int NumberOfBins = 256;
  bool TablesOnAllProcesses = true;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
