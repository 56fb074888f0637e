// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCLocalSamples.h"

#include "Kernels/TFCVector.h"
#include "vtkTFCSamples.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include "vtkFloatArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr vtkIdType BlockSize = 65536;
constexpr float LargestValid = std::numeric_limits<float>::max() / 2;

//------------------------------------------------------------------------------
/**
 * Visits the samples in blocks: body(first, count) returns a survey.
 */
template <typename Body>
bool SurveyBlocks(vtkIdType count, vtkAlgorithm* owner, double from, double to, vtkTFCSurvey& total,
  const Body& body)
{
  const vtkIdType blocks = (count + BlockSize - 1) / BlockSize;
  std::vector<vtkTFCSurvey> surveys(static_cast<size_t>(blocks));
  const bool done = vtkTFCThreads::ForWithProgress(0, blocks, 1, owner, from, to,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType block = begin; block < end; ++block)
        {
          const vtkIdType first = block * BlockSize;
          surveys[block] = body(first, std::min(BlockSize, count - first));
        }
      }));
  for (const vtkTFCSurvey& survey : surveys)
  {
    total.Add(survey);
  }
  return done;
}

vtkFloatArray* AsScalarFloats(vtkDataArray* array, int component)
{
  auto* floats = vtkFloatArray::SafeDownCast(array);
  return floats && floats->GetNumberOfComponents() == 1 && component == 0 ? floats : nullptr;
}
}

//------------------------------------------------------------------------------
void vtkTFCSurvey::Add(const vtkTFCSurvey& other)
{
  this->Minimum = std::min(this->Minimum, other.Minimum);
  this->Maximum = std::max(this->Maximum, other.Maximum);
  this->HasNaN = this->HasNaN || other.HasNaN;
  this->HasOther = this->HasOther || other.HasOther;
}

//------------------------------------------------------------------------------
vtkTFCSurvey vtkTFCSurvey::Look(const float* values, vtkIdType count)
{
  // Independent lanes instead of one chain of comparisons, four values at a time in each.
  constexpr int width = 16;
  float low[width], high[width];
  int nan[width] = {}, other[width] = {};
  vtkTFCSurvey result;
  const float infinity = std::numeric_limits<float>::infinity();
  std::fill_n(low, width, infinity);
  std::fill_n(high, width, -infinity);
  const auto lower = [=](float v) { return std::fabs(v) <= LargestValid ? v : infinity; };
  const auto higher = [=](float v) { return std::fabs(v) <= LargestValid ? v : -infinity; };
  const auto smaller = [](float a, float b) { return a < b ? a : b; };
  const auto larger = [](float a, float b) { return a > b ? a : b; };
  const auto isNaN = [](float v) { return v != v ? 1 : 0; };
  const auto isOther = [](float v) { return std::fabs(v) > LargestValid ? 1 : 0; };
  vtkIdType i = 0;
  for (; i + 4 * width <= count; i += 4 * width)
  {
    const float* __restrict a = values + i;
    const float* __restrict b = a + width;
    const float* __restrict c = b + width;
    const float* __restrict d = c + width;
    TFC_INDEPENDENT
    for (int l = 0; l < width; ++l)
    {
      const float ab = smaller(lower(a[l]), lower(b[l])), cd = smaller(lower(c[l]), lower(d[l]));
      low[l] = smaller(low[l], smaller(ab, cd));
      const float top = larger(higher(a[l]), higher(b[l])),
                  bottom = larger(higher(c[l]), higher(d[l]));
      high[l] = larger(high[l], larger(top, bottom));
      nan[l] |= isNaN(a[l]) | isNaN(b[l]) | isNaN(c[l]) | isNaN(d[l]);
      other[l] |= isOther(a[l]) | isOther(b[l]) | isOther(c[l]) | isOther(d[l]);
    }
  }
  for (; i < count; ++i)
  {
    low[0] = smaller(low[0], lower(values[i]));
    high[0] = larger(high[0], higher(values[i]));
    nan[0] |= isNaN(values[i]);
    other[0] |= isOther(values[i]);
  }
  for (int lane = 0; lane < width; ++lane)
  {
    result.Minimum = std::min(result.Minimum, low[lane]);
    result.Maximum = std::max(result.Maximum, high[lane]);
    result.HasNaN = result.HasNaN || nan[lane];
    result.HasOther = result.HasOther || other[lane];
  }
  return result;
}

//------------------------------------------------------------------------------
vtkTFCLocalSamples::vtkTFCLocalSamples(vtkDataArray* array, int component,
  vtkUnsignedCharArray* ghosts, int association)
  : Array(array)
  , Component(component)
  , Hidden(vtkTFCSamples::GetHiddenBit(association))
{
  if (ghosts && ghosts->GetNumberOfValues() == array->GetNumberOfTuples())
  {
    this->Ghosts = ghosts->GetPointer(0);
  }
}

//------------------------------------------------------------------------------
bool vtkTFCLocalSamples::NeedsCopy() const
{
  return !AsScalarFloats(this->Array, this->Component);
}

//------------------------------------------------------------------------------
bool vtkTFCLocalSamples::HasBlanked(vtkIdType first, vtkIdType count) const
{
  const unsigned char hidden = this->Hidden;
  return this->Ghosts &&
    std::any_of(this->Ghosts + first, this->Ghosts + first + count,
      [=](unsigned char flags) { return (flags & hidden) != 0; });
}

//------------------------------------------------------------------------------
bool vtkTFCLocalSamples::Load(vtkAlgorithm* owner, double from, double to)
{
  const vtkIdType count = this->Array->GetNumberOfTuples();
  if (!this->NeedsCopy())
  {
    const float* values = AsScalarFloats(this->Array, this->Component)->GetPointer(0);
    const bool done = SurveyBlocks(count, owner, from, to, this->Found,
      [&](vtkIdType first, vtkIdType n)
      {
        vtkTFCSurvey survey = vtkTFCSurvey::Look(values + first, n);
        survey.HasOther = survey.HasOther || this->HasBlanked(first, n);
        return survey;
      });
    if (!done || !this->Found.HasOther)
    {
      this->Values = values;
      return done;
    }
  }
  this->Copy = vtkTFCLargeBuffer::Allocate(count);
  this->Values = this->Copy.get();
  this->Found = vtkTFCSurvey();
  return SurveyBlocks(count, owner, from, to, this->Found,
    [&](vtkIdType first, vtkIdType n)
    {
      float* values = this->Copy.get() + first;
      vtkTFCSamples::Read(this->Array, this->Component, first, n, values);
      for (vtkIdType i = 0; i < n; ++i)
      {
        const bool hidden = this->Ghosts && (this->Ghosts[first + i] & this->Hidden);
        if (hidden || !(std::fabs(values[i]) <= LargestValid))
        {
          values[i] = std::numeric_limits<float>::quiet_NaN();
        }
      }
      return vtkTFCSurvey::Look(values, n);
    });
}
