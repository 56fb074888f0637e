// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCRegionHistograms
 * @brief Joint histograms for the regions of a transfer function, kept from call to call, and what
 * they say about each region.
 *
 * There is one joint histogram (vtkTFCJointHistogram) per different tertiary attribute and range;
 * it is computed again only when the data, an axis, that attribute or the bins change. Weights of
 * regions are those of vtkTFCClassifier at the centres of the bins.
 *
 * This is not a vtkObject.
 */

#ifndef vtkTFCRegionHistograms_h
#define vtkTFCRegionHistograms_h

#include "vtkSmartPointer.h"
#include "vtkTFCClassifier.h"             // For weights
#include "vtkTFCTransferFunctionModule.h" // For export macro
#include "vtkType.h"                      // For vtkMTimeType

#include <map>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkDataSet;
class vtkMultiProcessController;
class vtkTFCJointHistogram;
class vtkTFCRegion;
class vtkTFCSparseHistogram;
class vtkTFCTransferFunction;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCRegionHistograms
{
public:
  /// The tertiary attribute's histogram over the voxels of one region.
  struct Conditional
  {
    int Id = 0;           ///< of the region
    std::string Label;    ///< of the attribute: "name", "name:2" or "name:magnitude"
    double Minimum = 0.;  ///< of the range, data units
    double BinWidth = 0.; ///< data units
    std::vector<double> Counts;

    double GetBinCenter(int bin) const { return this->Minimum + (bin + 0.5) * this->BinWidth; }
  };

  vtkTFCRegionHistograms();
  ~vtkTFCRegionHistograms();
  vtkTFCRegionHistograms(const vtkTFCRegionHistograms&) = delete;
  void operator=(const vtkTFCRegionHistograms&) = delete;

  /**
   * Collective. Bring the histograms up to date with `input` (image data or a tree of it) and the
   * visible regions of `model`, which must have axes. `extra` are attributes whose histograms are
   * wanted for all regions too. Returns what is wrong and what to do; empty when nothing is. The
   * owner's progress moves from 0 to 1.
   */
  std::string Update(vtkDataObject* input, vtkTFCTransferFunction* model, int bins,
    vtkMultiProcessController* controller, vtkAlgorithm* owner,
    const std::vector<vtkTFCAttribute>& extra = {});

  /**
   * Whether the owner of the latest Update() was aborted: then there are no histograms. The same on
   * all processes.
   */
  bool WasAborted() const { return this->Aborted; }

  /**
   * The joint histogram of one of the tertiary attributes, or of none: their planes are the same.
   */
  const vtkTFCSparseHistogram* GetJoint() const;

  /**
   * One for every visible region with a tertiary attribute, in list order.
   */
  const std::vector<Conditional>& GetConditionals() const { return this->Conditionals; }

  /**
   * Ids of the visible regions, in list order.
   */
  const std::vector<int>& GetRegionIds() const { return this->Ids; }

  /**
   * The histogram of the extra attribute `index` over a region, given by its index among the
   * visible ones.
   */
  Conditional GetExtra(size_t index, size_t region) const;

  /**
   * The histogram of the third axis of `histogram` over one region of `model`: every count times
   * the weight, of shape and fall-off alone, in the middle of its bin of the plane. Visibility,
   * opacity and tertiary function of the region play no part. `ranges` are those of the axes as
   * vtkTFCTransferFunction::ResolveRanges() returns them. Cost: cells and entries, not voxels.
   */
  static std::vector<double> MakeConditional(const vtkTFCSparseHistogram* histogram,
    const vtkTFCTransferFunction* model, vtkTFCRegion* region, const double ranges[4]);

  /**
   * How a table names an attribute.
   */
  static std::string GetLabel(const vtkTFCAttribute& attribute);

private:
  struct Joint;
  Joint& GetOrMake(const vtkTFCAttribute* tertiary, const double range[2]);
  Conditional MakeConditional(const Joint& joint, size_t region) const;
  void FillWeights(vtkTFCCompiledModel model);

  std::map<std::string, Joint> Joints;
  std::vector<const Joint*> ExtraJoints;
  std::vector<Conditional> Conditionals;
  std::vector<int> Ids;                    ///< of the visible regions
  std::vector<std::vector<float>> Weights; ///< per region, of the cells of the plane
  vtkTFCAttribute Axes[2];
  double Ranges[2][2];
  int Bins = 0;
  bool Aborted = false;
  vtkDataObject* Input = nullptr; ///< only compared
  vtkMTimeType InputTime = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCRegionHistograms.h
