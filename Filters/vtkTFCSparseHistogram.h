// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCSparseHistogram
 * @brief A joint histogram over two or three axes of which only occupied cells are kept.
 *
 * Axis 0 is the primary, 1 the secondary, 2 the tertiary attribute. A value v of an axis from min
 * to max with n bins is in bin min(n - 1, floor((v - min) / (max - min) n)); both ends belong to
 * the axis, and on a constant axis (min = max) that one value is in bin 0. A sample whose primary
 * or secondary value is NaN or outside is not counted. One whose tertiary value is NaN or outside
 * is counted in the bin "no tertiary", whose index is the number of tertiary bins: the plane (the
 * marginal over the tertiary) does not depend on the tertiary attribute. Without a tertiary
 * attribute axis 2 has one bin that holds all.
 *
 * Entries are sorted by cell, j * bins0 + i for primary bin i and secondary bin j, then by tertiary
 * bin; no two are for the same bin. Memory: 14 bytes per entry. Counts are whole numbers up to
 * 2^53, so that sums are exact in any order.
 *
 * vtkTFCJointHistogram makes them from data.
 */

#ifndef vtkTFCSparseHistogram_h
#define vtkTFCSparseHistogram_h

#include "vtkObject.h"
#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkWrappingHints.h"    // For VTK_WRAPEXCLUDE

#include <algorithm> // For std::min
#include <array>     // For axes
#include <vector>    // For entries

class VTKTFCFILTERS_EXPORT vtkTFCSparseHistogram : public vtkObject
{
public:
  static vtkTFCSparseHistogram* New();
  vtkTypeMacro(vtkTFCSparseHistogram, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Most bins of an axis.
  static constexpr int MostBins = 16384;

  ///@{
  /**
   * Range (data units, minimum <= maximum, both finite) and bins (1 to MostBins) of axis 0, 1 or 2.
   * Setting an axis removes all entries. Default: [0, 1], one bin.
   */
  void SetAxis(int axis, double minimum, double maximum, int bins);
  int GetNumberOfBins(int axis) const;
  void GetRange(int axis, double range[2]) const;
  ///@}

  /**
   * Bin of a value on an axis; -1 for NaN and for values outside.
   */
  int GetBin(int axis, double value) const
  {
    const Axis& a = this->Axes[static_cast<size_t>(std::min(2, std::max(0, axis)))];
    if (!(value >= a.Minimum && value <= a.Maximum))
    {
      return -1;
    }
    if (a.Minimum == a.Maximum)
    {
      return 0;
    }
    const double bin = (value - a.Minimum) / (a.Maximum - a.Minimum) * a.Bins;
    return std::min(a.Bins - 1, static_cast<int>(bin));
  }

  /**
   * Value in the middle of a bin, data units.
   */
  double GetBinCenter(int axis, int bin) const;

  ///@{
  /**
   * The entries: cell, tertiary bin and count, at the same index of three lists.
   */
  VTK_WRAPEXCLUDE const std::vector<unsigned int>& GetCells() const { return this->Cells; }
  VTK_WRAPEXCLUDE const std::vector<unsigned short>& GetTertiaryBins() const
  {
    return this->TertiaryBins;
  }
  VTK_WRAPEXCLUDE const std::vector<double>& GetCounts() const { return this->Counts; }
  vtkIdType GetNumberOfEntries() const { return static_cast<vtkIdType>(this->Counts.size()); }
  ///@}

  /**
   * Replace the entries. Returns false, with an error, and changes nothing when they are not as
   * described above for the axes: sorted, within the axes, counts above 0.
   */
  VTK_WRAPEXCLUDE bool SetEntries(std::vector<unsigned int> cells,
    std::vector<unsigned short> tertiaryBins, std::vector<double> counts);

  /**
   * Sum of all counts.
   */
  double GetTotal() const;

  /**
   * Fill bins0 * bins1 counts, primary fastest. Cost: the cells and the entries.
   */
  VTK_WRAPEXCLUDE void GetPlane(double* counts) const;

  /**
   * Fill bins2 values: the tertiary attribute's histogram with every cell's count multiplied by its
   * weight (bins0 * bins1 of them, primary fastest). The bin "no tertiary" is left out. Cost: the
   * entries, not the voxels.
   */
  VTK_WRAPEXCLUDE void GetConditional(const float* weights, double* counts) const;

  /**
   * Add the counts of another histogram. Returns false, with an error, when the axes differ.
   */
  bool Merge(const vtkTFCSparseHistogram* other);

  ///@{
  /**
   * To and from a flat buffer, in this machine's byte order. Load() checks everything: for a buffer
   * that is no histogram, is cut short or comes from a machine with another byte order it returns
   * false, with an error, and changes nothing.
   */
  VTK_WRAPEXCLUDE void Save(std::vector<unsigned char>& buffer) const;
  VTK_WRAPEXCLUDE bool Load(const std::vector<unsigned char>& buffer);
  ///@}

  /**
   * Take over axes and entries.
   */
  void DeepCopy(const vtkTFCSparseHistogram* other);

protected:
  vtkTFCSparseHistogram() = default;
  ~vtkTFCSparseHistogram() override = default;

private:
  vtkTFCSparseHistogram(const vtkTFCSparseHistogram&) = delete;
  void operator=(const vtkTFCSparseHistogram&) = delete;

  struct Axis
  {
    double Minimum = 0.;
    double Maximum = 1.;
    int Bins = 1;
  };
  static const char* CheckAxis(double minimum, double maximum, double bins);

  std::array<Axis, 3> Axes;
  std::vector<unsigned int> Cells;
  std::vector<unsigned short> TertiaryBins;
  std::vector<double> Counts;
};

#endif
