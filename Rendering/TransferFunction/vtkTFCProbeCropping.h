// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which places of a volume a display crops away, for probes of it.
 */

#ifndef vtkTFCProbeCropping_h
#define vtkTFCProbeCropping_h

#include <array> // For positions

struct vtkTFCProbeCropping
{
  bool Enabled = false;
  /// Two planes along each axis, low and high, as positions along the axes of the data.
  std::array<double, 6> Planes = { { 0, 0, 0, 0, 0, 0 } };
  /// Bit x + 3 y + 9 z for what is visible: 0 before both planes, 1 between, 2 behind them.
  int Flags = 0x2000;

  bool Hides(const std::array<double, 3>& position) const
  {
    int region = 0;
    int factor = 1;
    for (int axis = 0; axis < 3; ++axis, factor *= 3)
    {
      region += factor * (position[axis] >= this->Planes[2 * axis] ? 1 : 0);
      region += factor * (position[axis] >= this->Planes[2 * axis + 1] ? 1 : 0);
    }
    return this->Enabled && (this->Flags >> region & 1) == 0;
  }
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCProbeCropping.h
