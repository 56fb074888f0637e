// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCCombinationScore
 * @brief Which attribute should be the tertiary one: correlations, entropies, scores and ranks.
 *
 * Port 0, table "Scores", best first: `attribute`, `correlation` (Pearson, with the primary
 * attribute, signed), `entropy` (bits), `score` (Eq. 3 of the paper: -a |R| + (1 - a) E / max E,
 * the maximum over all attributes) and `rank` (1 = best). The primary and the secondary
 * attribute, and attributes whose correlation is undefined because they are constant, are no
 * candidates: score NaN, rank 0, after the candidates. Port 1: the correlation matrix, a column
 * `attribute` and one column per attribute; NaN for constant attributes. Port 2, table "Stability":
 * how the ranking depends on the balance a: `from` and `to`, an interval of a, and `ranking`, the
 * candidates in it, best first; the field data array `summary` says it in a sentence, such as
 * "occlusion is first for a < 0.72, radius is first for a > 0.72", and whether wider bins rank
 * otherwise. Port 3, table "Stability over bins": `merged_bins` (1, 2, 4, 8: so many neighbouring
 * bins are taken as one for the entropies) and `ranking`, for the given a.
 *
 * Further columns of the scores, unless MeasureInformation is off, say what Pearson's R cannot:
 * with T the attribute and X, Y the axes (only X without a secondary one), all in bits of coarse
 * histograms: `mutual_information` I(T; X, Y), dependence of any kind on the axes;
 * `conditional_mutual_ information` I(T; X | Y), what T shares with the primary attribute alone;
 * `new_information` H(T | X, Y), what the 3D histogram separates beyond the 2D one; `separation`,
 * its part of H(T), 0 to 1. NaN for the axes. Formulas, source and the correction for few samples:
 * Kernels/TFCInformation.h. New information counts noise, too.
 *
 * Attributes are arrays, all of points or all of cells: `name` of a single-component array,
 * `name:2` for a component (from 0) or `name:magnitude`. NaN, infinities, blanked points or cells
 * and the fill values are no data; correlations use the samples where both attributes have data,
 * entropies those where one has, information those where the axes and the attribute have.
 * Histograms: NumberOfBins equal bins between minimum and maximum, or one bin per value for integer
 * arrays whose range fits (see Kernels/TFCHistogram.h).
 *
 * Of composite data all leaves are taken together. On several processes every point counts once and
 * the numbers are those of one process (up to rounding). TablesOnAllProcesses says who gets the
 * rows. Structured pieces share faces, which is taken care of; the pieces of an unstructured grid
 * must flag shared points as duplicates. All processes of the controller must update the filter
 * together.
 *
 * Three threaded passes over the data (range and mean; sums and histograms; information) in
 * doubles; results do not depend on the number of threads. Memory: 1 byte per point on several
 * processes.
 */

#ifndef vtkTFCCombinationScore_h
#define vtkTFCCombinationScore_h

#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For std::string
#include <vector> // For std::vector

class vtkMultiProcessController;

class VTKTFCFILTERS_EXPORT vtkTFCCombinationScore : public vtkTableAlgorithm
{
public:
  static vtkTFCCombinationScore* New();
  vtkTypeMacro(vtkTFCCombinationScore, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The attributes to compare. None: all single-component numeric arrays of points, or of cells
   * when no array of points is one. The primary and secondary attribute are added when they are
   * not among them.
   */
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{
  /**
   * The axes of the transfer function. Empty or "None": the first attribute is the primary one;
   * there is no secondary one.
   */
  vtkSetStringMacro(Primary);
  vtkGetStringMacro(Primary);
  vtkSetStringMacro(Secondary);
  vtkGetStringMacro(Secondary);
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
   * Histogram bins, 2 to 65536. Default 256. 0: by bit depth, one bin per value of an integer array
   * (256 for 8 bits), but no more than 65536, and 256 for floating point, which has no bit depth.
   * Entropies of attributes with different numbers of bins compare poorly.
   */
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * Whether to compute the columns about information: one more pass. Default on.
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
   * On: every process has the same tables. Off: the lowest process has the rows and the others have
   * the same columns without rows, so that gathering the pieces gives the table once. Default on.
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
  vtkTFCCombinationScore();
  ~vtkTFCCombinationScore() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::vector<std::string> Arrays;
  std::vector<double> FillValues;
  char* Primary = nullptr;
  char* Secondary = nullptr;
  double Balance = 0.4;
  int NumberOfBins = 256;
  bool MeasureInformation = true;
  bool TablesOnAllProcesses = true;
  vtkMultiProcessController* Controller = nullptr;

private:
  vtkTFCCombinationScore(const vtkTFCCombinationScore&) = delete;
  void operator=(const vtkTFCCombinationScore&) = delete;
};

#endif
