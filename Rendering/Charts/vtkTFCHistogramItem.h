// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCHistogramItem
 * @brief The joint histogram of the two axes as a picture in the domain chart.
 *
 * Counts become colours on the CPU, once per histogram, scale or colour map: a few milliseconds for
 * 512 x 512 bins. Empty bins are transparent.
 *
 * Not vtkPlotHistogram2D: its picture vanishes for ranges far from 0 (such as 101225 to 101425 Pa),
 * because it ignores the shift and scale that vtkChart gives it (VTK 9.2,
 * Charts/Core/vtkPlotHistogram2D.cxx:72).
 */

#ifndef vtkTFCHistogramItem_h
#define vtkTFCHistogramItem_h

#include "vtkContextItem.h"
#include "vtkSmartPointer.h"     // For the picture
#include "vtkTFCChartsModule.h"  // For export macro
#include "vtkTFCDomainMapping.h" // For the mapping
#include "vtkWrappingHints.h"    // For VTK_WRAPEXCLUDE

#include <vector> // For counts

class vtkImageData;

class VTKTFCCHARTS_EXPORT vtkTFCHistogramItem : public vtkContextItem
{
public:
  static vtkTFCHistogramItem* New();
  vtkTypeMacro(vtkTFCHistogramItem, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Counts, primary fastest, of equal bins between the ranges {primary low, high, secondary low,
   * high} in data units. nx or ny of 0 removes the histogram.
   */
  VTK_WRAPEXCLUDE void SetCounts(const double* counts, int nx, int ny,
    const vtkTFCOutline::Ranges& ranges);
  bool HasCounts() const { return !this->Counts.empty(); }

  /**
   * The count at a position in data units; -1 outside the histogram or without one.
   */
  double GetCount(double x, double y) const;

  /**
   * How counts become brightness s in [0, 1], m the largest count. Linear: count / m. Logarithmic:
   * log(1 + count) / log(1 + m). Percentile: count / p, at most 1, where p is the count that
   * `Percentile` percent of the bins that are not empty do not exceed. Default Logarithmic, 95.
   */
  enum Scales
  {
    Linear,
    Logarithmic,
    Percentile
  };
  void SetScale(int scale);
  int GetScale() const { return this->Scale; }
  void SetPercentile(double percent);
  double GetPercentile() const { return this->Percent; }

  /**
   * Colours from few to many: Gray (light to dark, the other way round on a dark ground), Viridis
   * or Inferno, which are even in brightness and safe for colour-blind eyes. Default Gray, so that
   * the colours of regions stand out.
   */
  enum ColorMaps
  {
    Gray,
    Viridis,
    Inferno
  };
  void SetColorMap(int map);
  int GetColorMap() const { return this->Map; }

  /**
   * 0 to 1 for a count, as documented at Scales; for tests and legends.
   */
  double GetBrightness(double count) const;

  VTK_WRAPEXCLUDE void SetMapping(const vtkTFCDomainMapping* mapping) { this->Mapping = mapping; }
  bool Paint(vtkContext2D* painter) override;

protected:
  vtkTFCHistogramItem();
  ~vtkTFCHistogramItem() override;

private:
  vtkTFCHistogramItem(const vtkTFCHistogramItem&) = delete;
  void operator=(const vtkTFCHistogramItem&) = delete;

  void UpdatePicture();

  const vtkTFCDomainMapping* Mapping = nullptr;
  std::vector<double> Counts;
  int Size[2] = { 0, 0 };
  vtkTFCOutline::Ranges Ranges = { { 0, 1, 0, 1 } };
  int Scale = Logarithmic;
  double Percent = 95;
  int Map = Gray;
  double Largest = 0; ///< of the counts
  double PercentileCount = 0;
  bool PictureIsDark = false;
  vtkSmartPointer<vtkImageData> Picture; ///< null: to be made
};

#endif
