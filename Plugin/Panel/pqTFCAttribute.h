// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCAttribute
 * @brief Something in the data that can be an axis or a tertiary attribute: a component of an array
 * of the points or the cells, or its magnitude (component -1).
 */

#ifndef pqTFCAttribute_h
#define pqTFCAttribute_h

#include <QString>

#include <string>

struct pqTFCAttribute
{
  std::string Array;
  int Component = 0;
  QString Label;
  double Range[2] = { 0, 1 }; ///< finite extent over all processes
  bool Integral = false;      ///< an array of integers
  bool OnPoints = false;      ///< the points have an array of this name, or
  bool OnCells = false;       ///< the cells, or both

  /// All attributes of a transfer function must be of points, or all of cells.
  bool goesWith(const pqTFCAttribute& other) const
  {
    return (this->OnPoints && other.OnPoints) || (this->OnCells && other.OnCells);
  }
};

#endif
