// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCHistogramSplit.h"

#include "Kernels/TFCSplit.h"

//------------------------------------------------------------------------------
vtkTFCHistogramSplit vtkTFCHistogramSplit::Find(const std::vector<double>& counts, double samples)
{
  const tfc::Split split = tfc::FindSplit(counts, samples);
  return { split.Weight, split.Separability, split.Threshold, split.Valley, split.Power, split.Cut,
    split.Below };
}
