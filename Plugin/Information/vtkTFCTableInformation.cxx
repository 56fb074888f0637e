// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTableInformation.h"

#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkMultiProcessStream.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <limits>

vtkStandardNewMacro(vtkTFCTableInformation);

//------------------------------------------------------------------------------
vtkTFCTableInformation::vtkTFCTableInformation()
{
  this->SetRootOnly(1);
}

//------------------------------------------------------------------------------
vtkTFCTableInformation::~vtkTFCTableInformation() = default;

//------------------------------------------------------------------------------
int vtkTFCTableInformation::GetNumberOfRows() const
{
  return this->Columns.empty() ? 0 : static_cast<int>(this->Columns[0].Values.size());
}

//------------------------------------------------------------------------------
std::string vtkTFCTableInformation::GetText(const std::string& column, int row) const
{
  for (const Column& c : this->Columns)
  {
    if (c.Name == column && row >= 0 && row < static_cast<int>(c.Values.size()))
    {
      return c.Values[row];
    }
  }
  return std::string();
}

//------------------------------------------------------------------------------
double vtkTFCTableInformation::GetNumber(const std::string& column, int row) const
{
  bool valid = false;
  const double number = vtkVariant(this->GetText(column, row)).ToDouble(&valid);
  return valid ? number : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
void vtkTFCTableInformation::CopyFromObject(vtkObject* object)
{
  this->Columns.clear();
  auto* filter = vtkAlgorithm::SafeDownCast(object);
  vtkTable* table = filter && this->Port >= 0 && this->Port < filter->GetNumberOfOutputPorts()
    ? vtkTable::SafeDownCast(filter->GetOutputDataObject(this->Port))
    : nullptr;
  if (!table)
  {
    vtkErrorMacro("Expected a filter with a table at output port "
      << this->Port << ", got " << (object ? object->GetClassName() : "nothing") << ".");
    return;
  }
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    Column column;
    column.Name = table->GetColumnName(c) ? table->GetColumnName(c) : "";
    for (vtkIdType r = 0; r < table->GetNumberOfRows(); ++r)
    {
      column.Values.push_back(table->GetValue(r, c).ToString(vtkVariant::DEFAULT_FORMATTING, 17));
    }
    this->Columns.push_back(column);
  }
}

//------------------------------------------------------------------------------
void vtkTFCTableInformation::AddInformation(vtkPVInformation* other)
{
  auto* that = vtkTFCTableInformation::SafeDownCast(other);
  if (that && this->GetNumberOfRows() == 0)
  {
    this->Columns = that->Columns;
  }
}

//------------------------------------------------------------------------------
void vtkTFCTableInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << static_cast<int>(this->Columns.size())
          << this->GetNumberOfRows();
  for (const Column& column : this->Columns)
  {
    *stream << column.Name.c_str();
    for (const std::string& value : column.Values)
    {
      *stream << value.c_str();
    }
  }
  *stream << vtkClientServerStream::End;
}

//------------------------------------------------------------------------------
void vtkTFCTableInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  this->Columns.clear();
  int columns = 0;
  int rows = 0;
  int argument = 2;
  bool valid = stream->GetArgument(0, 0, &columns) && stream->GetArgument(0, 1, &rows);
  const auto read = [&](std::string& text)
  {
    const char* value = nullptr;
    valid = valid && stream->GetArgument(0, argument++, &value);
    text = valid && value ? value : "";
  };
  for (int c = 0; c < columns && valid; ++c)
  {
    Column column;
    read(column.Name);
    for (int r = 0; r < rows && valid; ++r)
    {
      column.Values.emplace_back();
      read(column.Values.back());
    }
    this->Columns.push_back(column);
  }
  if (!valid)
  {
    this->Columns.clear();
    vtkErrorMacro("The server's answer holds no table: is the plugin's version the same there?");
  }
}

//------------------------------------------------------------------------------
void vtkTFCTableInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->Port;
}

//------------------------------------------------------------------------------
void vtkTFCTableInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  stream >> this->Port;
}

//------------------------------------------------------------------------------
void vtkTFCTableInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Port: " << this->Port << "\n";
  os << indent << "Columns: " << this->Columns.size() << "\n";
  os << indent << "Rows: " << this->GetNumberOfRows() << "\n";
}
