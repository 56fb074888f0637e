// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The samples of this process as floats in which NaN marks every invalid one.
 *
 * Invalid are NaN, infinities, magnitudes beyond half of the largest float (so that the difference
 * of two valid samples is finite) and blanked points or cells. A single-component float array
 * without samples to hide is used in place; anything else is converted to a copy of 4 bytes per
 * sample. One or two threaded passes over the array.
 */

#ifndef vtkTFCLocalSamples_h
#define vtkTFCLocalSamples_h

#include "vtkTFCFiltersModule.h" // For export macro
#include "vtkTFCLargeBuffer.h"

#include <limits>

class vtkAlgorithm;
class vtkDataArray;
class vtkUnsignedCharArray;

/**
 * What one look at the samples tells.
 */
struct VTKTFCFILTERS_NO_EXPORT vtkTFCSurvey
{
  float Minimum = std::numeric_limits<float>::infinity();
  float Maximum = -std::numeric_limits<float>::infinity();
  bool HasNaN = false;
  bool HasOther = false; ///< invalid samples that are not NaN yet

  void Add(const vtkTFCSurvey& other);

  /**
   * Survey of `count` values; quick, not threaded.
   */
  static vtkTFCSurvey Look(const float* values, vtkIdType count);
};

class VTKTFCFILTERS_NO_EXPORT vtkTFCLocalSamples
{
public:
  /**
   * `component` -1 is the magnitude; `ghosts` may be null; `association` as in vtkDataObject.
   */
  vtkTFCLocalSamples(vtkDataArray* array, int component, vtkUnsignedCharArray* ghosts,
    int association);

  /**
   * Whether Load() will need a copy for certain, of 4 bytes per sample.
   */
  bool NeedsCopy() const;

  /**
   * Fill Values and Found; false when `owner` was aborted, whose progress moves in [from, to].
   */
  bool Load(vtkAlgorithm* owner, double from, double to);

  const float* Values = nullptr;
  vtkTFCSurvey Found;

private:
  bool HasBlanked(vtkIdType first, vtkIdType count) const;

  vtkDataArray* Array;
  int Component;
  unsigned char Hidden;
  const unsigned char* Ghosts = nullptr;
  vtkTFCLargeBuffer::Pointer Copy;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCLocalSamples.h
