// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCHistogramInformation.h"

#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"
#include "vtkTFCJointHistogram.h"
#include "vtkTFCSparseHistogram.h"

#include <vector>

vtkStandardNewMacro(vtkTFCHistogramInformation);

//------------------------------------------------------------------------------
vtkTFCHistogramInformation::vtkTFCHistogramInformation()
{
  this->SetRootOnly(1);
}

//------------------------------------------------------------------------------
vtkTFCHistogramInformation::~vtkTFCHistogramInformation() = default;

//------------------------------------------------------------------------------
void vtkTFCHistogramInformation::CopyFromObject(vtkObject* object)
{
  auto* filter = vtkTFCJointHistogram::SafeDownCast(object);
  if (!filter)
  {
    vtkErrorMacro("Expected a vtkTFCJointHistogram, got "
      << (object ? object->GetClassName() : "nothing") << ".");
    return;
  }
  this->Histogram->DeepCopy(filter->GetHistogram());
}

//------------------------------------------------------------------------------
void vtkTFCHistogramInformation::AddInformation(vtkPVInformation* other)
{
  // Of several servers (data and render), one has the data.
  auto* that = vtkTFCHistogramInformation::SafeDownCast(other);
  if (that && this->Histogram->GetNumberOfEntries() == 0)
  {
    this->Histogram->DeepCopy(that->Histogram);
  }
}

//------------------------------------------------------------------------------
void vtkTFCHistogramInformation::CopyToStream(vtkClientServerStream* stream)
{
  std::vector<unsigned char> buffer;
  this->Histogram->Save(buffer);
  stream->Reset();
  *stream << vtkClientServerStream::Reply
          << vtkClientServerStream::InsertArray(buffer.data(), static_cast<int>(buffer.size()))
          << vtkClientServerStream::End;
}

//------------------------------------------------------------------------------
void vtkTFCHistogramInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  vtkTypeUInt32 length = 0;
  if (!stream->GetArgumentLength(0, 0, &length))
  {
    vtkErrorMacro(
      "The server's answer holds no histogram: is the plugin's version the same there?");
    return;
  }
  std::vector<unsigned char> buffer(length);
  if (stream->GetArgument(0, 0, buffer.data(), length))
  {
    this->Histogram->Load(buffer);
  }
}

//------------------------------------------------------------------------------
void vtkTFCHistogramInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Entries: " << this->Histogram->GetNumberOfEntries() << "\n";
}
