// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCAttributeSamples
 * @brief Several attributes of a dataset, found by name and read in chunks as doubles.
 *
 * An attribute is an array of points or of cells: `name` of a single-component one, `name:2` for a
 * component (from 0), `name:magnitude` for the Euclidean norm. All attributes are of points when
 * all of them are there, else all of cells.
 *
 * Samples come as NaN where there is no data: NaN, infinities, magnitudes above a quarter of the
 * largest double (so that differences stay finite), blanked points or cells, samples that another
 * process owns, fill values. Reading is safe from several threads; the dataset must stay as it is.
 *
 * This is not a vtkObject: it lives within one RequestData().
 */

#ifndef vtkTFCAttributeSamples_h
#define vtkTFCAttributeSamples_h

#include "vtkTFCFiltersModule.h" // For export macro

#include "vtkType.h" // For vtkIdType

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkDataSetAttributes;

class VTKTFCFILTERS_EXPORT vtkTFCAttributeSamples
{
public:
  struct Attribute
  {
    std::string Label;
    vtkDataArray* Array = nullptr; ///< null on a process without samples
    int Component = 0;             ///< -1: the norm
    bool Integer = false;          ///< whether all values are integers
    int Bits = 64;                 ///< of one value of the array's type
  };

  /// What to look for: a text such as "velocity:2", or an array's exact name and a component.
  struct Request
  {
    static constexpr int FromText = -2;
    std::string Name;
    int Component = FromText;
  };

  /**
   * Find attributes. Without requests: all single-component numeric arrays but the ghost array, of
   * points when there are any, else of cells. `association` becomes FIELD_ASSOCIATION_POINTS or
   * FIELD_ASSOCIATION_CELLS of vtkDataObject. Returns what is wrong and what to do; empty when
   * nothing is.
   */
  static std::string Find(vtkDataSet* data, const std::vector<Request>& requests,
    std::vector<Attribute>& found, int& association);

  /// Partial results are kept per block, and added in the order of the blocks.
  static constexpr vtkIdType BlockSize = 65536;
  /// A chunk's samples of all attributes stay in the second-level cache.
  static constexpr vtkIdType ChunkSize = 2048;

  /**
   * `owned` has one byte per sample, or none when all of them count. The fill values of a float
   * array are the nearest floats.
   */
  vtkTFCAttributeSamples(vtkDataSet* data, int association, std::vector<Attribute> attributes,
    std::vector<unsigned char> owned, const std::vector<double>& fillValues);

  vtkIdType GetNumberOfSamples() const { return this->Count; }
  vtkIdType GetNumberOfBlocks() const { return (this->Count + BlockSize - 1) / BlockSize; }

  /**
   * body(first, count) for the chunks of one block.
   */
  template <typename Body>
  void ForChunks(vtkIdType block, Body&& body) const
  {
    const vtkIdType end = std::min(this->Count, (block + 1) * BlockSize);
    for (vtkIdType first = block * BlockSize; first < end; first += ChunkSize)
    {
      body(first, std::min(ChunkSize, end - first));
    }
  }

  /**
   * Samples [first, first + count) of attribute `i` in data units.
   */
  void Read(size_t i, vtkIdType first, vtkIdType count, double* out) const
  {
    this->ReadRaw(i, first, count, out);
    constexpr double largest = std::numeric_limits<double>::max() / 4;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (vtkIdType s = 0; s < count; ++s)
    {
      out[s] = std::fabs(out[s]) <= largest ? out[s] : nan;
    }
    if (this->Ghosts || !this->Owned.empty() || !this->Fill.empty())
    {
      this->RemoveOthers(i, first, count, out);
    }
  }

private:
  void ReadRaw(size_t i, vtkIdType first, vtkIdType count, double* out) const;
  void RemoveOthers(size_t i, vtkIdType first, vtkIdType count, double* out) const;

  std::vector<Attribute> Attributes;
  std::vector<unsigned char> Owned;
  std::vector<double> Fill, FloatFill;
  vtkIdType Count = 0;
  const unsigned char* Ghosts = nullptr;
  unsigned char Hidden = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributeSamples.h
