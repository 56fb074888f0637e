// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCAttributeAgreement
 * @brief The attributes that a filter compares, the same on all processes, or what is wrong.
 *
 * This is not a vtkObject: it lives within one RequestData().
 */

#ifndef vtkTFCAttributeAgreement_h
#define vtkTFCAttributeAgreement_h

#include "vtkTFCAttributeSamples.h"
#include "vtkTFCDistributedImage.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;

class vtkTFCAttributeAgreement
{
public:
  vtkTFCAttributeAgreement(vtkMultiProcessController* controller, std::vector<double> fillValues);

  /**
   * Note what is wrong with the parameters of scores: balance in [0, 1); bins 0 or 2 to 65536.
   */
  void CheckScoring(double balance, int bins);

  /**
   * Collective. Find the attributes `names` and `axes`; without names, all single-component numeric
   * arrays. Of arrays of points and of cells, those of the first axis' kind, or of the first
   * name's, are taken, with a warning. All leaves of composite data count together. Returns false,
   * on all processes, when something is wrong.
   */
  bool Find(vtkDataObject* input, const std::vector<std::string>& names,
    const std::vector<std::string>& axes);

  const std::string& GetProblem() const { return this->Problem; }
  const std::string& GetWarning() const { return this->Warning; }

  ///@{
  /**
   * After a successful Find(). The arrays are null on a process without samples, and those of the
   * first block otherwise. The image is for reductions; samples without those of others.
   */
  const std::vector<vtkTFCAttributeSamples::Attribute>& GetAttributes() const
  {
    return this->Attributes;
  }
  const vtkTFCDistributedImage& GetImage() const { return *this->Image; }
  const vtkTFCAttributeSamples& GetSamples() const { return this->Samples; }
  ///@}

private:
  vtkMultiProcessController* Controller;
  std::vector<vtkTFCAttributeSamples::Attribute> Attributes;
  std::unique_ptr<vtkTFCDistributedImage> Image;
  std::vector<double> FillValues;
  vtkTFCAttributeSamples Samples;
  std::string Problem, Warning;
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCAttributeAgreement.h
