// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scalars of any vtkDataArray as plain float or double, in blocks.
 *
 * The array's type is dispatched once per block, never per value; only exotic (implicit) arrays
 * fall back to a virtual call per value. Reading is safe from several threads.
 */

#ifndef vtkTFCSamples_h
#define vtkTFCSamples_h

#include "vtkTFCFiltersModule.h" // For export macro

#include "vtkType.h" // For vtkIdType

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;
class vtkUnsignedCharArray;

namespace vtkTFCSamples
{
/**
 * Component number that stands for the Euclidean norm of all components.
 */
constexpr int Magnitude = -1;

///@{
/**
 * Copy component `component` of the tuples [first, first + count) to `out`.
 */
VTKTFCFILTERS_EXPORT void Read(vtkDataArray* array, int component, vtkIdType first, vtkIdType count,
  float* out);
VTKTFCFILTERS_EXPORT void Read(vtkDataArray* array, int component, vtkIdType first, vtkIdType count,
  double* out);
///@}

/**
 * The ghost array of point or cell data (`association` of vtkDataObject), null when there is none
 * of the right type and size.
 */
VTKTFCFILTERS_EXPORT vtkUnsignedCharArray* GetGhosts(vtkDataSetAttributes* attributes);

/**
 * Bit of the ghost array that marks a blanked point or cell.
 */
VTKTFCFILTERS_EXPORT unsigned char GetHiddenBit(int association);

/**
 * Bit of the ghost array that marks a point or cell that another process owns.
 */
VTKTFCFILTERS_EXPORT unsigned char GetDuplicateBit(int association);

/**
 * Names of the numeric arrays other than the ghost array, for messages: "'a', 'b'" or "none".
 */
VTKTFCFILTERS_EXPORT std::string ListArrays(vtkDataSetAttributes* attributes);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCSamples.h
