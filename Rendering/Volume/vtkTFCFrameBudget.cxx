// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCFrameBudget.h"

namespace
{

constexpr vtkTFCFrameBudget::Level Levels[] = { { 1, 1 }, { 2, 1 }, { 2, 2 }, { 3, 2 }, { 4, 2 },
  { 4, 4 } };

double FindSpeedUp(const vtkTFCFrameBudget::Level& level)
{
  return level.Image * level.Image * level.Step;
}

}

//------------------------------------------------------------------------------
vtkTFCFrameBudget::Level vtkTFCFrameBudget::Choose(double seconds) const
{
  Level chosen;
  for (const Level& level : Levels)
  {
    chosen = level;
    const double speedUp = FindSpeedUp(level);
    const double share = speedUp < this->LastSpeedUp ? 0.7 : 1.0;
    if (this->FullFrame <= share * seconds * speedUp)
    {
      break;
    }
  }
  return chosen;
}

//------------------------------------------------------------------------------
void vtkTFCFrameBudget::Report(const Level& level, double seconds)
{
  this->LastSpeedUp = FindSpeedUp(level);
  this->FullFrame = seconds * this->LastSpeedUp;
}
