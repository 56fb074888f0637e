// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCAttributeReader
 * @brief Finds the attributes of a transfer function in a dataset and hands them out as doubles.
 *
 * Every VTK scalar type is read (bit, char, id and 64-bit integers included), with one dispatch on
 * the array's type per block, see vtkTFCSamples. Integers beyond 2^53 round to the nearest double.
 * Component -1 is the magnitude of the tuple.
 *
 * All attributes come from the same kind of data: points when all are there, else cells. The
 * dataset must outlive the reader and not change; then the const methods may run on any number of
 * threads.
 */

#ifndef vtkTFCAttributeReader_h
#define vtkTFCAttributeReader_h

#include "vtkTFCCompiledModel.h"          // For vtkTFCAttribute
#include "vtkTFCTransferFunctionModule.h" // For export macro
#include "vtkType.h"                      // For vtkIdType

#include <string> // For errors
#include <vector> // For attributes

class vtkDataArray;
class vtkDataSet;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCAttributeReader
{
public:
  /**
   * Find the attributes. On failure returns false and a message for the user: which array is
   * missing and which there are, which component does not exist, which arrays differ in kind or
   * size; the reader is then empty.
   */
  bool Bind(vtkDataSet* data, const std::vector<vtkTFCAttribute>& attributes, std::string& error);

  /**
   * vtkDataObject::POINT or vtkDataObject::CELL.
   */
  int GetAssociation() const { return this->Association; }

  /**
   * Number of points or cells.
   */
  vtkIdType GetNumberOfTuples() const { return this->NumberOfTuples; }

  /**
   * Values [begin, begin + count) of an attribute (index into Bind()'s list), data units. The range
   * is not checked.
   */
  void Read(int attribute, vtkIdType begin, vtkIdType count, double* out) const;

  /**
   * The same for all attributes, each to its own `stride` values of `out`, as vtkTFCClassifier
   * wants them: blanked samples have NaN as first attribute, which is in no region.
   */
  void ReadAll(vtkIdType begin, vtkIdType count, vtkIdType stride, double* out) const;

  ///@{
  /**
   * Whether some, or this, point or cell is blanked (HIDDENPOINT, HIDDENCELL of vtkGhostType).
   */
  bool HasHidden() const { return this->Ghosts != nullptr; }
  bool IsHidden(vtkIdType index) const
  {
    return this->Ghosts && (this->Ghosts[index] & this->HiddenBit) != 0;
  }
  ///@}

  /**
   * Smallest and largest finite value of an attribute over what is not hidden; {inf, -inf} when
   * there is none. Threaded; cost: one pass.
   */
  void FiniteRange(int attribute, double range[2]) const;

private:
  struct Source
  {
    vtkDataArray* Array;
    int Component;
  };

  std::vector<Source> Sources;
  int Association = 0;
  vtkIdType NumberOfTuples = 0;
  const unsigned char* Ghosts = nullptr;
  unsigned char HiddenBit = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributeReader.h
