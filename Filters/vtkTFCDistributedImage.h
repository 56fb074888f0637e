// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCDistributedImage
 * @brief One structured dataset whose pieces lie on several processes: who owns which sample, and
 * samples of other processes.
 *
 * A lattice is the grid of the points or of the cells of an image (or rectilinear or structured
 * grid). Each process holds an extent of it, possibly with ghost layers that the upstream pipeline
 * delivered. The extent without ghosts is that of the cells not flagged DUPLICATECELL, else
 * that of the points not flagged DUPLICATEPOINT, else all. Pieces share the points of their
 * common face: a sample is owned by the lowest rank whose extent without ghosts contains it.
 * Everything here is the identity for one process or without a controller.
 *
 * Other datasets (unstructured grids) have no lattice: owned is what is not flagged as duplicate.
 *
 * Except for the queries, the methods are collective: all processes of the controller must call
 * them in the same order.
 *
 * This is not a vtkObject: it lives within one RequestData().
 */

#ifndef vtkTFCDistributedImage_h
#define vtkTFCDistributedImage_h

#include "vtkTFCFiltersModule.h" // For export macro

#include "vtkType.h" // For vtkIdType

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataSet;
class vtkMultiProcessController;

class VTKTFCFILTERS_EXPORT vtkTFCDistributedImage
{
public:
  using Extent = std::array<int, 6>;

  /**
   * Collective. `association` is FIELD_ASSOCIATION_POINTS or FIELD_ASSOCIATION_CELLS of
   * vtkDataObject; `controller` may be null. The dataset may be empty on some processes.
   */
  vtkTFCDistributedImage(vtkDataSet* data, int association, vtkMultiProcessController* controller);

  /**
   * Number of processes, at least 1.
   */
  int GetNumberOfRanks() const { return this->NumberOfRanks; }

  /**
   * Points or cells, as constructed.
   */
  int GetAssociation() const { return this->Association; }

  ///@{
  /**
   * Lattice extents: the samples of this process with ghost layers, without them, and those of all
   * processes.
   */
  const Extent& GetLocalExtent() const { return this->Local[this->Rank]; }
  const Extent& GetInnerExtent() const { return this->Inner[this->Rank]; }
  const Extent& GetWholeExtent() const { return this->Whole; }
  ///@}

  /**
   * The samples of this process and `width` more in each direction, where the whole has them.
   */
  Extent GetGrownExtent(int width) const { return this->Grow(this->Rank, width); }

  /**
   * One byte per local sample, 1 where this process owns it; empty when it owns all of them.
   * Memory: 1 byte per sample, and none for one process without ghosts.
   */
  std::vector<unsigned char> GetOwnedSamples() const;

  /**
   * Collective. Fill `grown`, laid out by GetGrownExtent(width), with the samples of `local`, laid
   * out by GetLocalExtent(), of all processes; NaN where no process has the sample. The width may
   * exceed the thickness of pieces. Pairs of processes exchange in one global order, the lower rank
   * sending first, so that blocking messages cannot wait for each other. Memory: `grown` takes 4
   * bytes per sample, a message at most as much again for the part it carries.
   */
  void Exchange(const float* local, int width, float* grown) const;

  ///@{
  /**
   * Collective. Element-wise reductions over all processes, in place.
   */
  void Sum(double* values, vtkIdType count) const;
  void Sum(std::int64_t* values, vtkIdType count) const;
  void Minimum(double* values, vtkIdType count) const;
  void Maximum(double* values, vtkIdType count) const;
  ///@}

  ///@{
  /**
   * Collective. Whether every process says so; whether any does.
   */
  bool All(bool value) const;
  bool Any(bool value) const;
  ///@}

  /**
   * Collective. The text of the lowest rank that has one; empty when none has.
   */
  std::string ShareText(bool has, const std::string& text) const;

  /**
   * Collective. The lists of all processes, one after the other in the order of ranks.
   */
  std::vector<std::int64_t> Gather(const std::vector<std::int64_t>& values) const;

  /**
   * Number of samples of an extent; 0 for an empty one.
   */
  static vtkIdType GetNumberOfSamples(const Extent& extent);

private:
  Extent Grow(int rank, int width) const;
  void ReduceDoubles(double* values, vtkIdType count, int operation) const;

  vtkMultiProcessController* Controller = nullptr;
  int Rank = 0;
  int NumberOfRanks = 1;
  std::vector<Extent> Local; // per rank, ghosts included
  std::vector<Extent> Inner; // per rank, without ghosts
  Extent Whole;
  vtkDataSet* Data;
  int Association;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCDistributedImage.h
