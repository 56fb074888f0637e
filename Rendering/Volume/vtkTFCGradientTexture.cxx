// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCGradientTexture.h"

#include "Kernels/TFCGradient.h"
#include "vtkTFCThreads.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cstring>

namespace
{

//------------------------------------------------------------------------------
// A half float of a number in [-1, 1], rounded to the nearest.
std::uint16_t ToHalf(float value)
{
  // Moves the exponent's bias from 127 to 15, small numbers included.
  const float scaled = value * 0x1p-112f;
  std::uint32_t bits;
  std::memcpy(&bits, &scaled, sizeof bits);
  const std::uint32_t sign = bits >> 16 & 0x8000u;
  return static_cast<std::uint16_t>(sign | ((bits & 0x7fffffffu) + 0x1000u) >> 13);
}

//------------------------------------------------------------------------------
// An attribute that is infinite has differences that are not numbers.
std::uint16_t MakeChannel(float difference)
{
  return ToHalf(difference == difference ? std::clamp(difference, -1.0f, 1.0f) : 0.0f);
}

}

//------------------------------------------------------------------------------
std::vector<std::uint16_t> vtkTFCGradientTexture::MakeTexels(const float* packed, int channels,
  const std::array<int, 3>& texels)
{
  const vtkIdType row = texels[0];
  const vtkIdType rows = static_cast<vtkIdType>(texels[1]) * texels[2];
  const vtkIdType strides[3] = { channels, channels * row, channels * row * texels[1] };
  const float longest = static_cast<float>(*std::max_element(texels.begin(), texels.end()));
  std::array<float, 3> weights;
  for (int axis = 0; axis < 3; ++axis)
  {
    weights[axis] = static_cast<float>(texels[axis]) / longest;
  }
  std::vector<std::uint16_t> values(4 * row * rows);
  vtkTFCThreads::For(0, rows, 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType r = begin; r < end; ++r)
      {
        const float* from = packed + r * strides[1];
        std::uint16_t* to = values.data() + 4 * r * row;
        std::array<vtkIdType, 3> place = { 0, r % texels[1], r / texels[1] };
        for (vtkIdType x = 0; x < row; ++x, from += channels, to += 4)
        {
          place[0] = x;
          const float center = *from;
          for (int axis = 0; axis < 3; ++axis)
          {
            const bool hasLow = place[axis] > 0;
            const bool hasHigh = place[axis] + 1 < texels[axis];
            to[axis] = MakeChannel(tfc::ValidDifference(hasLow ? from[-strides[axis]] : center,
              center, hasHigh ? from[strides[axis]] : center, hasLow, hasHigh, weights[axis]));
          }
          to[3] = 0;
        }
      }
    });
  return values;
}

//------------------------------------------------------------------------------
bool vtkTFCGradientTexture::Upload(vtkOpenGLRenderWindow* context, vtkFloatArray* packed,
  const std::array<int, 3>& texels, bool linear)
{
  const bool current =
    this->IsIn(context) && this->Source == packed && this->SourceTime == packed->GetMTime();
  if (!current)
  {
    const auto values = MakeTexels(packed->GetPointer(0), packed->GetNumberOfComponents(), texels);
    this->Source = nullptr;
    if (!this->CreateHalfFloats(context, texels, values.data()))
    {
      return false;
    }
    this->Source = packed;
    this->SourceTime = packed->GetMTime();
  }
  this->SetFilter(linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest);
  return true;
}
