// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCBlobSearch
 * @brief Carries out the plan of a scale space (TFCScaleSpace.h) on a lattice and collects the
 * blobs.
 *
 * Threads, progress and abort for the kernels: vtkTFCFeatureSize says what is computed. Two
 * lattices of responses are kept; each new one completes a triple of scales, in which
 * the maxima are looked for. A triple that spans a change of resolution is compared on the coarser
 * lattice.
 *
 * Memory: NumberOfBuffers floats per sample. Not a vtkObject: it lives within one RequestData().
 */

#ifndef vtkTFCBlobSearch_h
#define vtkTFCBlobSearch_h

#include "Kernels/TFCBlobs.h"
#include "Kernels/TFCPyramid.h"
#include "Kernels/TFCScaleSpace.h"
#include "vtkTFCLargeBuffer.h"

#include "vtkType.h" // For vtkIdType

#include <array>      // For std::array
#include <functional> // For std::function
#include <vector>     // For std::vector

class vtkAlgorithm;

class vtkTFCBlobSearch
{
public:
  static constexpr int NumberOfBuffers = 5;

  ///@{
  /**
   * The lattice: its samples, their number per axis and where the first lies in the whole volume;
   * their distances in the plan's unit.
   */
  const float* Values = nullptr;
  tfc::Index Size[3] = { 0, 0, 0 };
  tfc::Index Offset[3] = { 0, 0, 0 };
  double Spacing[3] = { 1., 1., 1. };
  bool HasInvalid = false;
  ///@}

  ///@{
  /**
   * Values scaled to [0, 1]; outside of them 0. What to look for, and the response that it exceeds.
   */
  double Range[2] = { 0., 1. };
  bool FindBright = true;
  bool FindDark = false;
  double Threshold = 0.1;
  ///@}

  double ProgressBegin = 0.;
  double ProgressEnd = 1.;

  /**
   * Find the blobs, with progress of and until abort by `owner`. Returns false when aborted.
   */
  bool Run(const tfc::ScaleSpacePlan& plan, vtkAlgorithm* owner);

  /**
   * The result: per scale of the plan the blobs by z, y, x; of a sample bright ones first.
   */
  std::vector<std::vector<tfc::Blob>> Blobs;

private:
  using Body = std::function<void(vtkIdType, vtkIdType)>;

  bool Scale();
  bool Diffuse(const tfc::ScaleSpaceAction& action);
  bool Halve(const tfc::ScaleSpaceAction& action);
  bool Respond(const tfc::ScaleSpaceAction& action, const std::vector<double>& sigmas);
  bool Find(const float* response, const std::vector<double>& sigmas);
  bool ForSlices(const tfc::CoarseLattice& lattice, double cost, const Body& body);
  double GetTotalCost(const tfc::ScaleSpacePlan& plan) const;

  float* Take();
  void Release(float* buffer);

  vtkAlgorithm* Owner = nullptr;
  double Cost = 0.;
  double TotalCost = 1.;
  tfc::CoarseLattice Lattice;
  std::array<vtkTFCLargeBuffer::Pointer, NumberOfBuffers> Buffers;
  std::vector<float*> Free;
  float* Current = nullptr; // the diffused intensity
  float* Cycle = nullptr;   // the same at the beginning of the cycle
  float* Older = nullptr;   // the responses of the scale before the last
  float* Old = nullptr;     // those of the last scale
  int NumberOfResponses = 0;
  bool IsHalved = false; // since the last response
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCBlobSearch.h
