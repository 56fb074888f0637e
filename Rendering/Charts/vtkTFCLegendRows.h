// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The rows of a legend: colour, name and tertiary function of each region.
 */

#ifndef vtkTFCLegendRows_h
#define vtkTFCLegendRows_h

#include <array>  // For places and colours
#include <string> // For names
#include <vector> // For rows

class vtkContext2D;
class vtkTFCRegion;
class vtkTFCTransferFunction;

class vtkTFCLegendRows
{
public:
  struct Style
  {
    std::array<double, 3> Color = { { 1, 1, 1 } };
    int FontSize = 12;
    double Scale = 1; ///< pixels a point
  };

  /// Read the visible regions of a model.
  void Update(vtkTFCTransferFunction* model);
  bool IsEmpty() const { return this->Rows.empty(); }

  /// Draw into left, bottom, width, height in pixels, from the top.
  void Paint(vtkContext2D* painter, const std::array<double, 4>& rectangle, const Style& style);

  /// Rows that did not fit at the last Paint().
  int GetNumberOfMissingRows() const { return this->Missing; }

private:
  using Node = std::array<double, 2>;
  using ColorNode = std::array<double, 4>;

  struct Row
  {
    std::string Name;
    std::string Attribute; ///< empty: no function
    std::array<double, 3> Color;
    std::array<double, 2> Range;
    std::vector<Node> Opacity;
    std::vector<ColorNode> Colors;
  };

  static Row MakeRow(vtkTFCRegion* region);
  void PaintName(vtkContext2D* painter, const Row& row, double x, double top, double width,
    const Style& style) const;
  void PaintFunction(vtkContext2D* painter, const Row& row, const std::array<double, 4>& box,
    const Style& style) const;

  std::vector<Row> Rows;
  int Missing = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCLegendRows.h
