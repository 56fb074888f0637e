// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Quantiles of the attributes that a transfer function was made for, and maps of values from
 * one data set to another. Plain values.
 *
 * A transfer function that is kept for other data carries the quantiles of its axes and tertiary
 * attributes in the note "x-quantiles": [{"array": name, "component": c, "values": [v0, ... vn-1]},
 * ...], with vk the value below which k / (n - 1) of all finite samples are, so that v0 and vn-1
 * are the extent. Data units; see Plugin/Documentation/state-format.md.
 */

#ifndef vtkTFCQuantiles_h
#define vtkTFCQuantiles_h

#include "vtkTFCTransferFunctionModule.h" // For export macro

#include <string> // For names
#include <vector> // For values

class vtkTFCTransferFunction;

/**
 * A piecewise linear map that takes from[i] to to[i] and never decreases. Beyond its ends it goes
 * on with the slope from end to end. Both lists are finite, do not decrease, and are equally long;
 * where some of `from` are equal, that value goes to the middle of theirs in `to`. With fewer than
 * two values, or all of `from` equal, it is the identity; it is exactly that, too, where the lists
 * are equal. Cost of a value: log(n).
 */
class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCValueMap
{
public:
  vtkTFCValueMap() = default;
  vtkTFCValueMap(const std::vector<double>& from, const std::vector<double>& to);

  double operator()(double value) const;
  bool IsIdentity() const { return this->From.empty(); }
  /// One slope everywhere because there are two ends only (or it is the identity).
  bool IsAffine() const { return this->From.size() <= 2; }

private:
  std::vector<double> From; ///< increasing
  std::vector<double> To;
};

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCQuantiles
{
public:
  /// How many are kept: the extent and 63 between.
  static constexpr int Number = 65;

  /// The quantiles of one attribute.
  struct Entry
  {
    std::string Array;
    int Component = 0; ///< -1: magnitude
    std::vector<double> Values;
  };

  /**
   * `number` (2 or more) quantiles of a histogram whose bins divide [low, high] evenly; samples are
   * spread evenly over their bin. The first is `low` and the last `high`, the ends of the data.
   * Empty when nothing is counted or not low < high. Cost: bins + number.
   */
  static std::vector<double> FromCounts(const std::vector<double>& counts, double low, double high,
    int number = Number);

  ///@{
  /**
   * The note of a transfer function. Load() leaves out entries that are not as described above: a
   * file from elsewhere is no reason to fail. An empty list removes the note.
   */
  static std::vector<Entry> Load(const vtkTFCTransferFunction* model);
  static void Store(vtkTFCTransferFunction* model, const std::vector<Entry>& entries);
  ///@}

  /// Values of an attribute in such a list; empty when it has none.
  static std::vector<double> Find(const std::vector<Entry>& entries, const std::string& array,
    int component);
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCQuantiles.h
