// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCAxisSuggestion
 * @brief Which pairs of attributes can be the axes, and which tertiary attributes suit each pair.
 *
 * Pairs, by the rules of sections 3.2 and 5.5 of the paper:
 * - kind "value and gradient": `x` with `x_gradient`; kind "mean and deviation": `x_mean` with
 *   `x_stddev`: properties that belong together by their definition, which the property filters of
 *   this project name so;
 * - kind "multivariate": two arrays neither of which is made from another one (named as one of the
 *   property filters would, `x_occlusion` beside `x`), for data with at least two of them; the one
 *   with the higher entropy is the primary. The best NumberOfPairs of these are proposed.
 * Constant attributes are never proposed. A pair's score is Eq. 3 for both alike,
 * -a |R| + (1 - a) (E_p + E_q) / (2 max E): much information and little dependence. Associated
 * pairs come first, as the paper always takes them, then the multivariate ones, each by their
 * score.
 *
 * Output, table "Suggestions", per pair and best tertiary first: `pair` (1 = best), `kind`,
 * `primary`, `secondary`, `pair_score`, `tertiary`, `score` (Eq. 3 with the pair's primary),
 * `rank`, and with MeasureInformation `new_information` (bits) and `separation` as in
 * vtkTFCCombinationScore. Field data `summary`: the first proposal as a sentence. Without any pair
 * the table has no rows and the sentence says why.
 *
 * What is no data, which arrays can be compared, several processes and errors: as
 * vtkTFCCombinationScore. Cost: two passes over the data, and one per pair for the information.
 */

#ifndef vtkTFCAxisSuggestion_h
#define vtkTFCAxisSuggestion_h

#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For names
#include <vector> // For lists

class vtkMultiProcessController;

class VTKTFCFILTERS_EXPORT vtkTFCAxisSuggestion : public vtkTableAlgorithm
{
public:
  static vtkTFCAxisSuggestion* New();
  vtkTypeMacro(vtkTFCAxisSuggestion, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The attributes to look at. None: all single-component numeric arrays of points, or of cells
   * when no array of points is one.
   */
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{
  /**
   * Weight a of the correlation against the entropy, 0 <= a < 1. Default 0.4.
   */
  vtkSetMacro(Balance, double);
  vtkGetMacro(Balance, double);
  ///@}

  ///@{
  /**
   * Histogram bins, see vtkTFCCombinationScore. Default 256.
   */
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * How many multivariate pairs to propose, 0 or more. Default 3.
   */
  vtkSetClampMacro(NumberOfPairs, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfPairs, int);
  ///@}

  ///@{
  /**
   * Whether to compute the columns about information: one more pass per pair. Default on.
   */
  vtkSetMacro(MeasureInformation, bool);
  vtkGetMacro(MeasureInformation, bool);
  vtkBooleanMacro(MeasureInformation, bool);
  ///@}

  ///@{
  /**
   * Values that stand for "no data", such as 1e35. In float arrays the nearest float is meant.
   */
  void AddFillValue(double value);
  void ClearFillValues();
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
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkTFCAxisSuggestion();
  ~vtkTFCAxisSuggestion() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTFCAxisSuggestion(const vtkTFCAxisSuggestion&) = delete;
  void operator=(const vtkTFCAxisSuggestion&) = delete;

  std::vector<std::string> Arrays;
  std::vector<double> FillValues;
  double Balance = 0.4;
  int NumberOfBins = 256;
  int NumberOfPairs = 3;
  bool MeasureInformation = true;
  bool TablesOnAllProcesses = true;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
