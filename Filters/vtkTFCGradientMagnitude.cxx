// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCGradientMagnitude.h"

#include "Kernels/TFCGradient.h"
#include "vtkTFCSimd.h"
#include "vtkTFCThreads.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTFCGradientMagnitude);

//------------------------------------------------------------------------------
bool vtkTFCGradientMagnitude::ComputeProperties(const Field& field,
  const std::vector<float*>& outputs)
{
  // Squares of large values overflow float, those of small ones vanish: compute in units of a power
  // of two near the largest difference per world unit, which costs nothing and rounds nothing.
  double steepest = 0.;
  for (const double spacing : field.Spacing)
  {
    steepest = std::max(steepest, (field.Range[1] - field.Range[0]) / spacing);
  }
  const int exponent = steepest > 0. ? std::ilogb(steepest) : 0;
  float weights[3];
  for (int a = 0; a < 3; ++a)
  {
    weights[a] = static_cast<float>(std::ldexp(1. / field.Spacing[a], -exponent));
  }
  const float scale = static_cast<float>(std::ldexp(1., exponent));

  const tfc::Index width = field.End[0] - field.Begin[0];
  const tfc::Index height = field.End[1] - field.Begin[1];
  const tfc::Index rows = height * (field.End[2] - field.Begin[2]);
  return vtkTFCThreads::ForWithProgress(0, rows, 64, this, 0.15, 1.,
    vtkTFCSimd::Vectorize(
      [&](vtkIdType begin, vtkIdType end)
      {
        for (tfc::Index row = begin; row < end; ++row)
        {
          const tfc::Index y = field.Begin[1] + row % height, z = field.Begin[2] + row / height;
          float* out = outputs[0] + row * width;
          if (field.HasInvalid)
          {
            tfc::GradientSquaredRow<true>(field.Values, field.Size, y, z, field.Begin[0],
              field.End[0], weights, out);
          }
          else
          {
            tfc::GradientSquaredRow<false>(field.Values, field.Size, y, z, field.Begin[0],
              field.End[0], weights, out);
          }
          tfc::RootRow(out, width, scale);
        }
      }));
}

//------------------------------------------------------------------------------
void vtkTFCGradientMagnitude::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
