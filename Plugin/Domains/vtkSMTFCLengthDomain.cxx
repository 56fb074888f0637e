// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMTFCLengthDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkSMTFCLengthDomain);

//------------------------------------------------------------------------------
void vtkSMTFCLengthDomain::Update(vtkSMProperty* vtkNotUsed(requestingProperty))
{
  this->LongestSide = 0.;
  vtkPVDataInformation* information = this->GetInputDataInformation("Input");
  if (!information)
  {
    return;
  }
  vtkSMProperty* unit = this->GetRequiredProperty("LengthUnit");
  const bool isWorld = unit && vtkSMUncheckedPropertyHelper(unit).GetAsInt() != 0;
  int extent[6];
  double bounds[6], longest = 0.;
  information->GetExtent(extent);
  information->GetBounds(bounds);
  for (int a = 0; a < 3; ++a)
  {
    const double samples = 1. + extent[2 * a + 1] - extent[2 * a];
    this->LongestSide = std::max(this->LongestSide, samples);
    longest = std::max(longest, isWorld ? bounds[2 * a + 1] - bounds[2 * a] : samples);
  }
  std::vector<vtkEntry> entries;
  if (this->LongestSide >= 1. && longest > 0.)
  {
    entries.emplace_back(0., longest * this->FractionOfRange);
  }
  this->SetEntries(entries);
}

//------------------------------------------------------------------------------
int vtkSMTFCLengthDomain::SetDefaultValues(vtkSMProperty* property, bool use_unchecked_values)
{
  auto* length = vtkSMDoubleVectorProperty::SafeDownCast(property);
  if (!length || this->LongestSide < 1.)
  {
    return 0;
  }
  const double fitting =
    std::max(this->Least, std::floor(this->LongestSide * this->FractionOfDefault));
  const double value = std::min(this->Most, fitting);
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(use_unchecked_values);
  for (unsigned int i = 0; i < length->GetNumberOfElements(); ++i)
  {
    helper.Set(i, value);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSMTFCLengthDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  element->GetScalarAttribute("fraction_of_range", &this->FractionOfRange);
  element->GetScalarAttribute("fraction_of_default", &this->FractionOfDefault);
  element->GetScalarAttribute("least", &this->Least);
  element->GetScalarAttribute("most", &this->Most);
  return this->Superclass::ReadXMLAttributes(property, element);
}

//------------------------------------------------------------------------------
void vtkSMTFCLengthDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FractionOfRange: " << this->FractionOfRange << "\n";
  os << indent << "FractionOfDefault: " << this->FractionOfDefault << "\n";
  os << indent << "Least: " << this->Least << "\n";
  os << indent << "Most: " << this->Most << "\n";
  os << indent << "LongestSide: " << this->LongestSide << "\n";
}
