// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How the domain chart maps data units and axis units to pixels, and what its items look
 * like. A plain value that the chart shares with its items.
 */

#ifndef vtkTFCDomainMapping_h
#define vtkTFCDomainMapping_h

#include "vtkTFCOutline.h" // For points and ranges

struct vtkTFCDomainMapping
{
  using Point = vtkTFCOutline::Point;

  vtkTFCOutline::Ranges Ranges = { { 0, 1, 0, 1 } }; ///< data units at 0 and 1 of the axes
  std::array<double, 4> View = { { 0, 1, 0, 1 } };   ///< what is shown, in axis units
  std::array<double, 4> Plot = { { 0, 0, 1, 1 } };   ///< left, bottom, width, height in pixels
  double Scale = 1;                                  ///< pixels per point of 1/72 inch
  bool Dark = false;                                 ///< light lines on a dark ground

  Point ToPixel(const Point& axis) const
  {
    return { this->Plot[0] +
        (axis[0] - this->View[0]) / (this->View[1] - this->View[0]) * this->Plot[2],
      this->Plot[1] + (axis[1] - this->View[2]) / (this->View[3] - this->View[2]) * this->Plot[3] };
  }
  Point ToAxis(const Point& pixel) const
  {
    return {
      this->View[0] + (pixel[0] - this->Plot[0]) / this->Plot[2] * (this->View[1] - this->View[0]),
      this->View[2] + (pixel[1] - this->Plot[1]) / this->Plot[3] * (this->View[3] - this->View[2])
    };
  }
  Point ToData(const Point& axis) const
  {
    const auto& r = this->Ranges;
    return { r[0] + axis[0] * (r[1] - r[0]), r[2] + axis[1] * (r[3] - r[2]) };
  }
  Point FromData(const Point& data) const
  {
    const auto& r = this->Ranges;
    return { (data[0] - r[0]) / (r[1] - r[0]), (data[1] - r[2]) / (r[3] - r[2]) };
  }
  /// Size of one pixel in axis units.
  Point PixelSize() const
  {
    return { (this->View[1] - this->View[0]) / this->Plot[2],
      (this->View[3] - this->View[2]) / this->Plot[3] };
  }
  bool InPlot(const Point& pixel) const
  {
    return pixel[0] >= this->Plot[0] && pixel[0] <= this->Plot[0] + this->Plot[2] &&
      pixel[1] >= this->Plot[1] && pixel[1] <= this->Plot[1] + this->Plot[3];
  }
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCDomainMapping.h
