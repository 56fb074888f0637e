// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCAttributeSamples
 * @brief Several attributes of datasets, found by name and read in chunks as doubles.
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
#include <cstdint>
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
   * Add the samples of a dataset, which must stay as it is. The attributes are the same, in the
   * same order, for all of them. `owned` has one byte per sample, or none when all of them count.
   * The fill values of a float array are the nearest floats.
   */
  void Add(vtkDataSet* data, int association, const std::vector<Attribute>& attributes,
    std::vector<unsigned char> owned, const std::vector<double>& fillValues);

  /**
   * Blocks of all datasets, one after the other: no block reaches over the end of one.
   */
  vtkIdType GetNumberOfBlocks() const { return static_cast<vtkIdType>(this->PartOfBlock.size()); }

  /**
   * body(first, count) for the chunks of one block.
   */
  template <typename Body>
  void ForChunks(vtkIdType block, Body&& body) const
  {
    const Part& part = this->Parts[this->PartOfBlock[static_cast<size_t>(block)]];
    const vtkIdType end = std::min(part.First + part.Count, (block + 1) * BlockSize);
    for (vtkIdType first = block * BlockSize; first < end; first += ChunkSize)
    {
      body(first, std::min(ChunkSize, end - first));
    }
  }

  /**
   * Samples [first, first + count) of attribute `i` in data units, as ForChunks() gives them.
   */
  void Read(size_t i, vtkIdType first, vtkIdType count, double* out) const
  {
    constexpr double largest = std::numeric_limits<double>::max() / 4;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Part& part = this->Parts[this->PartOfBlock[static_cast<size_t>(first / BlockSize)]];
    const vtkIdType local = first - part.First;
    // Plain floats, the normal case, are converted here, in the caller's instruction set.
    if (const float* floats = part.Floats[i])
    {
      for (vtkIdType s = 0; s < count; ++s)
      {
        const auto value = static_cast<double>(floats[local + s]);
        out[s] = std::fabs(value) <= largest ? value : nan;
      }
    }
    else
    {
      ReadRaw(part, i, local, count, out);
      for (vtkIdType s = 0; s < count; ++s)
      {
        out[s] = std::fabs(out[s]) <= largest ? out[s] : nan;
      }
    }
    if (part.Ghosts || !part.Owned.empty() || !part.Fill.empty())
    {
      RemoveOthers(part, i, local, count, out);
    }
  }

private:
  struct Part
  {
    std::vector<Attribute> Attributes;
    std::vector<const float*> Floats; ///< per attribute; null when it is not a list of floats
    std::vector<unsigned char> Owned;
    std::vector<double> Fill, FloatFill;
    vtkIdType First = 0; ///< number of its first sample: that of its first block
    vtkIdType Count = 0;
    const unsigned char* Ghosts = nullptr;
    unsigned char Hidden = 0;
  };
  static void ReadRaw(const Part& part, size_t i, vtkIdType first, vtkIdType count, double* out);
  static void RemoveOthers(const Part& part, size_t i, vtkIdType first, vtkIdType count,
    double* out);

  std::vector<Part> Parts;
  std::vector<std::uint32_t> PartOfBlock;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributeSamples.h
