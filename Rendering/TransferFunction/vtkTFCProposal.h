// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCProposal
 * @brief Regions for data that nobody has classified yet: the peaks of the joint histogram.
 *
 * A peak is a maximum of the logarithm of the counts, on bins of at least 1/64 of each axis and
 * smoothed with a standard deviation of two of them (binomial weights). Its prominence is its
 * height above the pass to the next higher peak (the persistence of topological data analysis). The
 * most prominent peaks are taken: those that rise to three times their pass, and weaker ones,
 * from 1.1 times, while there are fewer than two; none beside one that is taken already. The
 * highest peak is left out as background when it holds more than a quarter of all voxels and there
 * are others.
 *
 * Each peak becomes an ellipse: mean and covariance of the counts around it, down to a tenth of its
 * height or to the pass, 2.5 standard deviations wide. Populations of many voxels get a low
 * opacity, so that what is inside shows: 0.02 divided by their share of the voxels, within [0.02,
 * 0.4]. The result depends on the histogram alone.
 */

#ifndef vtkTFCProposal_h
#define vtkTFCProposal_h

#include "vtkObject.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro

class vtkTFCSparseHistogram;
class vtkTFCTransferFunction;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCProposal : public vtkObject
{
public:
  static vtkTFCProposal* New();
  vtkTypeMacro(vtkTFCProposal, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Most regions that are proposed, 1 to 8. Default 3.
   */
  vtkSetClampMacro(MaximumNumberOfRegions, int, 1, 8);
  vtkGetMacro(MaximumNumberOfRegions, int);
  ///@}

  /**
   * Replace the regions of `tf`, whose axes must be those of the histogram, and mark it as a
   * proposal. The ranges of the axes stay as they are. Returns the number of regions; 0, and an
   * unchanged `tf`, for an empty histogram.
   */
  int ProposeRegions(vtkTFCSparseHistogram* histogram, vtkTFCTransferFunction* tf);

protected:
  vtkTFCProposal() = default;
  ~vtkTFCProposal() override = default;

private:
  vtkTFCProposal(const vtkTFCProposal&) = delete;
  void operator=(const vtkTFCProposal&) = delete;

  int MaximumNumberOfRegions = 3;
};

#endif
