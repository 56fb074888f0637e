// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCTableInformation
 * @brief A table that a filter made on the server, such as scores, brought to the client.
 *
 * Gathered with vtkSMProxy::GatherInformation() from the proxy of a filter whose output `Port` is a
 * vtkTable, after UpdatePipeline(). Only the first process is asked: the advice's filters reduce
 * over all processes and have their rows there. Columns are numbers or texts, one value per row.
 */

#ifndef vtkTFCTableInformation_h
#define vtkTFCTableInformation_h

#include "vtkPVInformation.h"
#include "vtkTFCInformationModule.h" // For export macro

#include <string> // For names and texts
#include <vector> // For columns

class VTKTFCINFORMATION_EXPORT vtkTFCTableInformation : public vtkPVInformation
{
public:
  static vtkTFCTableInformation* New();
  vtkTypeMacro(vtkTFCTableInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Output port of the filter. Default 0.
   */
  vtkSetMacro(Port, int);
  vtkGetMacro(Port, int);
  ///@}

  ///@{
  /**
   * What was gathered. A row or a column that does not exist is NaN and an empty text; a number is
   * its text as well, a text that is no number is NaN.
   */
  int GetNumberOfRows() const;
  double GetNumber(const std::string& column, int row) const;
  std::string GetText(const std::string& column, int row) const;
  ///@}

  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkTFCTableInformation();
  ~vtkTFCTableInformation() override;

private:
  vtkTFCTableInformation(const vtkTFCTableInformation&) = delete;
  void operator=(const vtkTFCTableInformation&) = delete;

  struct Column
  {
    std::string Name;
    std::vector<std::string> Values;
  };
  std::vector<Column> Columns;
  int Port = 0;
};

#endif
