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
 * "occlusion is first for a < 0.72, radius is first for a > 0.72".
 *
 * Attributes are point arrays: `name` of a single-component array, `name:2` for a component (from
 * 0) or `name:magnitude`. NaN, infinities, blanked points and the fill values are no data;
 * correlations use the points where both attributes have data, entropies those where one has.
 * Histograms: NumberOfBins equal bins between minimum and maximum, or one bin per value for integer
 * arrays whose range fits (see Kernels/TFCHistogram.h).
 *
 * On several processes every point counts once and the numbers are those of one process (up to
 * rounding). TablesOnAllProcesses says who gets the rows. Structured pieces share faces, which is
 * taken care of; the pieces of an unstructured grid must flag shared points as duplicates.
 * All processes of the controller must update the filter together.
 *
 * Two threaded passes over the data (range and mean; sums and histograms) in double precision;
 * results do not depend on the number of threads. Memory: 1 byte per point on several processes.
 */

#ifndef vtkTFCCombinationScore_h
#define vtkTFCCombinationScore_h

#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For std::string
#include <vector> // For std::vector

class vtkMultiProcessController;
class vtkPointData;

namespace vtkTFCAttributeStatistics
{
struct Attribute;
}

class VTKTFCFILTERS_EXPORT vtkTFCCombinationScore : public vtkTableAlgorithm
{
public:
  static vtkTFCCombinationScore* New();
  vtkTypeMacro(vtkTFCCombinationScore, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The attributes to compare. None: all single-component numeric point arrays. The primary and
   * secondary attribute are added when they are not among them.
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
   * Histogram bins, 2 to 65536. Default 256.
   */
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
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
  bool TablesOnAllProcesses = true;
  vtkMultiProcessController* Controller = nullptr;

private:
  std::string FindAttributes(vtkPointData* points,
    std::vector<vtkTFCAttributeStatistics::Attribute>& attributes) const;

  vtkTFCCombinationScore(const vtkTFCCombinationScore&) = delete;
  void operator=(const vtkTFCCombinationScore&) = delete;
};

#endif
