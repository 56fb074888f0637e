// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCValueMark
 * @brief A vertical line at a value of a chart's bottom axis, with the value beside it.
 *
 * For charts of others, ParaView's transfer function widget for one: it is an item of the scene,
 * after the chart, and not one of the chart's plots, which come and go. A value outside of the
 * axis, or NaN (default), draws nothing. The axis may be hidden, but not logarithmic.
 */

#ifndef vtkTFCValueMark_h
#define vtkTFCValueMark_h

#include "vtkContextItem.h"
#include "vtkTFCChartsModule.h" // For export macro
#include "vtkWeakPointer.h"     // For the chart

#include <limits> // For NaN

class vtkChart;

class VTKTFCCHARTS_EXPORT vtkTFCValueMark : public vtkContextItem
{
public:
  static vtkTFCValueMark* New();
  vtkTypeMacro(vtkTFCValueMark, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetChart(vtkChart* chart);

  ///@{
  /**
   * Where the line is, in the units of the axis. True from SetValue() when that is another place.
   */
  bool SetValue(double value);
  double GetValue() const { return this->Value; }
  ///@}

  /**
   * Distance of the line from the left side of the scene as of the last Paint(), in pixels; NaN
   * when nothing was drawn.
   */
  double GetPosition() const { return this->Position; }

  bool Paint(vtkContext2D* painter) override;

protected:
  vtkTFCValueMark();
  ~vtkTFCValueMark() override;

private:
  vtkTFCValueMark(const vtkTFCValueMark&) = delete;
  void operator=(const vtkTFCValueMark&) = delete;

  vtkWeakPointer<vtkChart> Chart;
  double Value = std::numeric_limits<double>::quiet_NaN();
  double Position = std::numeric_limits<double>::quiet_NaN();
};

#endif
