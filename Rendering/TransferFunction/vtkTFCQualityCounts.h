// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The passes over the data of vtkTFCClassificationQuality: which labels there are, what the
 * transfer function makes of them, and where in the space of the attributes they lie.
 *
 * Everything is counted in integers, on this process's own samples: sums over processes and threads
 * are exact in any order. Threaded, in chunks without allocations.
 */

#ifndef vtkTFCQualityCounts_h
#define vtkTFCQualityCounts_h

#include "vtkTFCLabelHistogram.h" // For entries

#include <array>   // For extents and halves
#include <cstdint> // For counts
#include <vector>  // For lists

class vtkAlgorithm;
class vtkTFCAttributeReader;
class vtkTFCClassifier;

namespace vtkTFCQualityCounts
{
/**
 * A piece of a labelled volume. Samples with an ignored label, blanked ones and those of other
 * processes are left out of everything.
 */
struct Source
{
  const vtkTFCAttributeReader* Reader = nullptr;
  int LabelAttribute = 0;           ///< which of the reader's attributes holds the labels
  std::array<int, 6> Extent;        ///< of the samples, for the choice of halves
  std::vector<unsigned char> Owned; ///< 1 where the sample is this process's; empty: everywhere
  std::vector<double> Ignored;      ///< labels
};

/**
 * The half of the sample at a place of the lattice: depends on nothing else.
 */
inline std::uint32_t GetHalf(std::uint64_t x, std::uint64_t y, std::uint64_t z)
{
  // Mixing as in the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
  std::uint64_t h = x * 0x9E3779B97F4A7C15u + y * 0xC2B2AE3D27D4EB4Fu + z * 0x165667B19E3779F9u + 1;
  h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
  return static_cast<std::uint32_t>((h ^ (h >> 31)) >> 63);
}

/**
 * The distinct labels, ascending; at most vtkTFCLabelHistogram::MostLabels + 1 of them, as more are
 * an error anyway. Returns false when the owner was aborted.
 */
bool FindLabels(const Source& source, vtkAlgorithm* owner, std::vector<double>& labels);

/**
 * Axes of the joint histograms. Samples outside of the range of the first two, and NaN, are in no
 * cell; the infinite and those beyond the range of a third one are in its first or last bin.
 */
struct Binning
{
  int Bins = 64;
  /// Per attribute of the reader, data units.
  std::vector<std::array<double, 2>> Ranges;
  /// The third attribute of each histogram, -1 for none. The first two are attributes 0 and 1.
  std::vector<int> Third;
};

struct Counts
{
  /// [label][column]: column 0 is for no region, then the regions of the classifier's model.
  std::vector<std::int64_t> Confusion;
  /// [label][half]
  std::vector<std::array<std::int64_t, 2>> Totals;
  /// Per histogram, not merged.
  std::vector<std::vector<vtkTFCLabelHistogram::Entry>> Histograms;
};

/**
 * Classify and count. Returns false when the owner was aborted.
 */
bool Count(const Source& source, const vtkTFCClassifier& classifier,
  const std::vector<double>& labels, const Binning& binning, vtkAlgorithm* owner, Counts& counts);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCQualityCounts.h
