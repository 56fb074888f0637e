// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMTFCLengthDomain
 * @brief Range and default of a length that must fit the input volume.
 *
 * The range goes from 0 to `fraction_of_range` (default 1) times the longest side of the input, in
 * voxels. The default is `most` (default: no limit), or `fraction_of_default` (default 1 / 6) times
 * the longest side if that is less, a whole number of at least `least` (default 1) voxels: a radius
 * of 40 voxels is for volumes of 256, not of 32.
 *
 * Required properties: function "Input", and optionally "LengthUnit" (vtkTFCPropertyFilter): in
 * world units the range is in them, taken from the input's bounds.
 * @code{xml}
 * <TFCLengthDomain most="40" name="range">
 *   <RequiredProperties>
 *     <Property function="Input" name="Input" />
 *     <Property function="LengthUnit" name="LengthUnit" />
 *   </RequiredProperties>
 * </TFCLengthDomain>
 * @endcode
 */

#ifndef vtkSMTFCLengthDomain_h
#define vtkSMTFCLengthDomain_h

#include "vtkSMDoubleRangeDomain.h"
#include "vtkTFCDomainsModule.h" // For export macro

#include <limits> // For std::numeric_limits

class VTKTFCDOMAINS_EXPORT vtkSMTFCLengthDomain : public vtkSMDoubleRangeDomain
{
public:
  static vtkSMTFCLengthDomain* New();
  vtkTypeMacro(vtkSMTFCLengthDomain, vtkSMDoubleRangeDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* requestingProperty) override;
  int SetDefaultValues(vtkSMProperty* property, bool use_unchecked_values) override;

protected:
  vtkSMTFCLengthDomain() = default;
  ~vtkSMTFCLengthDomain() override = default;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMTFCLengthDomain(const vtkSMTFCLengthDomain&) = delete;
  void operator=(const vtkSMTFCLengthDomain&) = delete;

  double FractionOfRange = 1.;
  double FractionOfDefault = 1. / 6.;
  double Least = 1.;
  double Most = std::numeric_limits<double>::max();
  double LongestSide = 0.; // voxels; 0: not known
};

#endif
