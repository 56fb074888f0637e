// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCSamples.h"

#include "vtkArrayDispatch.h"
#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstring>

namespace
{
//------------------------------------------------------------------------------
/**
 * Reads a block of tuples; `Value(i, c)` gives component c of tuple i.
 */
template <typename Real, typename Getter>
void ReadWith(int components, int component, vtkIdType first, vtkIdType count, Real* out,
  Getter&& value)
{
  if (component >= 0)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      out[i] = static_cast<Real>(value(first + i, component));
    }
    return;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    double sum = 0.;
    for (int c = 0; c < components; ++c)
    {
      const double v = static_cast<double>(value(first + i, c));
      sum += v * v;
    }
    out[i] = static_cast<Real>(std::sqrt(sum));
  }
}

//------------------------------------------------------------------------------
template <typename Real>
struct ReadWorker
{
  int Component;
  vtkIdType First, Count;
  Real* Out;

  // Arrays of structures, which nearly all are: plain strided loads.
  template <typename T>
  void operator()(vtkAOSDataArrayTemplate<T>* array) const
  {
    const T* data = array->GetPointer(0);
    const int n = array->GetNumberOfComponents();
    ReadWith(n, this->Component, this->First, this->Count, this->Out,
      [=](vtkIdType i, int c) { return data[i * n + c]; });
  }

  template <typename Array>
  void operator()(Array* array) const
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    ReadWith(array->GetNumberOfComponents(), this->Component, this->First, this->Count, this->Out,
      [&](vtkIdType i, int c) { return static_cast<double>(tuples[i][c]); });
  }
};

//------------------------------------------------------------------------------
template <typename Real>
void ReadArray(vtkDataArray* array, int component, vtkIdType first, vtkIdType count, Real* out)
{
  const ReadWorker<Real> worker{ component, first, count, out };
  if (vtkArrayDispatch::Dispatch::Execute(array, worker))
  {
    return;
  }
  // Bits are packed, and have no pointer to a value.
  const int n = array->GetNumberOfComponents();
  if (auto* bits = vtkBitArray::SafeDownCast(array))
  {
    const unsigned char* bytes = bits->GetPointer(0);
    ReadWith(n, component, first, count, out,
      [=](vtkIdType i, int c)
      {
        const vtkIdType bit = i * n + c;
        return (bytes[bit / 8] >> (7 - bit % 8)) & 1;
      });
    return;
  }
  ReadWith(n, component, first, count, out,
    [=](vtkIdType i, int c) { return array->GetComponent(i, c); });
}
}

namespace vtkTFCSamples
{
//------------------------------------------------------------------------------
void Read(vtkDataArray* array, int component, vtkIdType first, vtkIdType count, float* out)
{
  ReadArray(array, component, first, count, out);
}

//------------------------------------------------------------------------------
void Read(vtkDataArray* array, int component, vtkIdType first, vtkIdType count, double* out)
{
  ReadArray(array, component, first, count, out);
}

//------------------------------------------------------------------------------
vtkUnsignedCharArray* GetGhosts(vtkDataSetAttributes* attributes)
{
  return vtkUnsignedCharArray::SafeDownCast(
    attributes->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
}

//------------------------------------------------------------------------------
unsigned char GetHiddenBit(int association)
{
  return association == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? static_cast<unsigned char>(vtkDataSetAttributes::HIDDENCELL)
    : static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT);
}

//------------------------------------------------------------------------------
unsigned char GetDuplicateBit(int association)
{
  return association == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATECELL)
    : static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATEPOINT);
}

//------------------------------------------------------------------------------
std::string ListArrays(vtkDataSetAttributes* attributes)
{
  std::string names;
  for (int i = 0; attributes && i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && array->GetName() &&
      std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) != 0)
    {
      names += (names.empty() ? "'" : ", '") + std::string(array->GetName()) + "'";
    }
  }
  return names.empty() ? "none" : names;
}
}
