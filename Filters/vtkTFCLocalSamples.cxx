// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCLocalSamples.h"

#include "vtkTFCSamples.h"
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
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const vtkIdType first = block * BlockSize;
        surveys[block] = body(first, std::min(BlockSize, count - first));
      }
    });
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
  // Independent lanes instead of one chain of comparisons.
  constexpr int width = 16;
  float low[width], high[width];
  int nan[width] = {}, other[width] = {};
  vtkTFCSurvey result;
  std::fill_n(low, width, result.Minimum);
  std::fill_n(high, width, result.Maximum);
  const auto look = [&](int lane, float v)
  {
    const bool valid = std::fabs(v) <= LargestValid;
    const float forLow = valid ? v : std::numeric_limits<float>::infinity();
    const float forHigh = valid ? v : -std::numeric_limits<float>::infinity();
    low[lane] = forLow < low[lane] ? forLow : low[lane];
    high[lane] = forHigh > high[lane] ? forHigh : high[lane];
    nan[lane] |= v != v;
    other[lane] |= !valid & (v == v);
  };
  vtkIdType i = 0;
  for (; i + width <= count; i += width)
  {
    for (int lane = 0; lane < width; ++lane)
    {
      look(lane, values[i + lane]);
    }
  }
  for (; i < count; ++i)
  {
    look(0, values[i]);
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
