// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCHistogramInformation
 * @brief The histogram of a vtkTFCJointHistogram, brought from the server to the client.
 *
 * Gathered with vtkSMProxy::GatherInformation() from a proxy of that filter after UpdatePipeline().
 * The filter has reduced over all processes already, so only the first one is asked.
 */

#ifndef vtkTFCHistogramInformation_h
#define vtkTFCHistogramInformation_h

#include "vtkNew.h" // For the histogram
#include "vtkPVInformation.h"
#include "vtkTFCInformationModule.h" // For export macro

class vtkTFCSparseHistogram;

class VTKTFCINFORMATION_EXPORT vtkTFCHistogramInformation : public vtkPVInformation
{
public:
  static vtkTFCHistogramInformation* New();
  vtkTypeMacro(vtkTFCHistogramInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Without entries until gathered, and after an error on the server.
   */
  vtkTFCSparseHistogram* GetHistogram() const { return this->Histogram; }

  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;

protected:
  vtkTFCHistogramInformation();
  ~vtkTFCHistogramInformation() override;

private:
  vtkTFCHistogramInformation(const vtkTFCHistogramInformation&) = delete;
  void operator=(const vtkTFCHistogramInformation&) = delete;

  vtkNew<vtkTFCSparseHistogram> Histogram;
};

#endif
