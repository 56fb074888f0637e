// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How coarse a moving picture has to be to keep the frame rate that was asked for.
 *
 * Pixels and samples along the ray are what a frame costs: at a level (i, s), pixels of i x i and
 * steps of s times the sample distance, about 1 / (i^2 s) of a full frame. Levels are (1, 1), (2,
 * 1), (2, 2), (3, 2), (4, 2), (4, 4). A finer level than the last is taken only when it would use
 * at most 70 % of the time, so that pictures do not flicker between two.
 */

#ifndef vtkTFCFrameBudget_h
#define vtkTFCFrameBudget_h

#include "vtkTFCVolumeModule.h" // For export macro

class VTKTFCVOLUME_EXPORT vtkTFCFrameBudget
{
public:
  struct Level
  {
    int Image = 1; ///< side of a pixel
    int Step = 1;  ///< factor of the sample distance
  };

  /// The finest level for a frame of `seconds`, the coarsest if none is quick enough; the full
  /// picture as long as no frame was reported.
  Level Choose(double seconds) const;

  /// What a frame took.
  void Report(const Level& level, double seconds);

private:
  double FullFrame = 0; // estimated seconds at level (1, 1)
  double LastSpeedUp = 1;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCFrameBudget.h
