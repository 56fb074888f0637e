// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Weighted means over balls of a scalar lattice, by Fourier transforms.
 *
 * mean(x) = sum_o w(o) f(x + o) / sum_o w(o), over the offsets o of a BallKernel for which x + o
 * lies in the lattice and is valid (not NaN). Exact up to rounding: numerator and, if there are
 * invalid samples, denominator are convolutions, whose zero padding keeps the borders apart;
 * without invalid samples the denominator comes from BallKernel::SumRow().
 *
 * Three passes, those of EvenConvolution, for the caller to spread over threads.
 *
 * Real is float, which is accurate to about 1e-6 of the largest |f - offset|, or double where sums
 * of few among many samples must not drown: where there are invalid samples.
 *
 * Cost: that of an EvenConvolution for the numerator, and of another for a denominator with invalid
 * samples; the same for all radii up to its padding. Memory: GetSize() values.
 */

#ifndef TFCBallMean_h
#define TFCBallMean_h

#include "TFCBallKernel.h"
#include "TFCBallSpectrum.h"
#include "TFCConvolution.h"

#include <vector>

namespace tfc
{
template <typename Real>
class BallMean
{
public:
  /**
   * Means of `values`, a lattice of `size` samples, for the block [begin, end) of it. `offset` is a
   * value near the samples, subtracted from them. `masked` says whether there may be NaN. `run` is
   * that of BallSpectrum.
   */
  template <typename Run>
  BallMean(const float* values, const Index size[3], const Index begin[3], const Index end[3],
    float offset, bool masked, const BallKernel& kernel, Run&& run)
    : Values(values)
    , Offset(offset)
    , Fields(masked ? 2 : 1)
    , Kernel(kernel)
    , Convolution(size, begin, end, kernel.GetReach())
    , Spectrum(kernel, this->Convolution.GetLengths(), this->Convolution.GetScale(), run)
  {
    std::copy_n(size, 3, this->Size);
    std::copy_n(begin, 3, this->Begin);
    std::copy_n(end, 3, this->End);
  }

  /**
   * Number of Real values that the passes need: their argument `spectrum`.
   */
  Index GetSize() const { return this->Fields * this->Convolution.GetSize(); }

  /**
   * Number of units of Filter().
   */
  Index GetNumberOfUnits() const { return this->Convolution.GetNumberOfFrequencies(); }

  /**
   * Buffers of one thread.
   */
  struct Workspace
  {
    typename EvenConvolution<Real>::Workspace Convolution;
    typename BallSpectrum<Real>::Workspace Spectrum;
    AlignedVector<Real> Sums; // of two slices, of each field
    std::vector<Real> Weights, Profile;
  };

  /**
   * Pass 1 for the slices z and z + 1 of the lattice, z even.
   */
  void Forward(Index z, Real* spectrum, Workspace& work) const
  {
    const float offset = this->Offset;
    this->Convolution.Forward(
      z, this->Values,
      [offset](float value)
      { return IsValid(value) ? static_cast<Real>(value) - static_cast<Real>(offset) : Real(0); },
      spectrum, work.Convolution);
    if (this->Fields == 2)
    {
      this->Convolution.Forward(
        z, this->Values, [](float value) { return IsValid(value) ? Real(1) : Real(0); },
        spectrum + this->Convolution.GetSize(), work.Convolution);
    }
  }

  /**
   * Pass 2 for one unit.
   */
  void Filter(Index unit, Real* spectrum, Workspace& work) const
  {
    const Real* response = this->Spectrum.GetPlane(unit, work.Spectrum);
    for (Index field = 0; field < this->Fields; ++field)
    {
      this->Convolution.Filter(unit, response, spectrum + field * this->Convolution.GetSize(),
        work.Convolution);
    }
  }

  /**
   * Pass 3 for the slices z and z + 1 of the lattice, Begin <= z < End, z - Begin even, into
   * `means`, which begins at slice z of the block: NaN for an invalid sample.
   */
  void Backward(Index z, const Real* spectrum, Workspace& work, float* means) const
  {
    const Index pitch = this->Convolution.GetPitch(), width = this->End[0] - this->Begin[0];
    const Index height = this->End[1] - this->Begin[1], plane = 2 * height * pitch;
    work.Sums.resize(static_cast<size_t>(this->Fields * plane));
    work.Weights.resize(static_cast<size_t>(pitch));
    for (Index field = 0; field < this->Fields; ++field)
    {
      this->Convolution.Backward(z, spectrum + field * this->Convolution.GetSize(),
        work.Sums.data() + field * plane, work.Convolution);
    }
    const Index rows = std::min<Index>(2, this->End[2] - z) * height;
    for (Index row = 0; row < rows; ++row)
    {
      const Index y = this->Begin[1] + row % height, slice = z + row / height;
      const Real* sums = work.Sums.data() + row * pitch + this->Begin[0];
      const Real* weights = sums + plane;
      if (this->Fields == 1)
      {
        this->Kernel.SumRow(y, slice, this->Begin[0], this->End[0], work.Profile,
          work.Weights.data());
        weights = work.Weights.data();
      }
      Divide(sums, weights,
        this->Values + (slice * this->Size[1] + y) * this->Size[0] + this->Begin[0], this->Offset,
        width, means + row * width);
    }
  }

private:
  static void Divide(const Real* __restrict sums, const Real* __restrict weights,
    const float* __restrict samples, float offset, Index count, float* __restrict means)
  {
    TFC_INDEPENDENT
    for (Index x = 0; x < count; ++x)
    {
      const Real mean = static_cast<Real>(offset) + sums[x] / weights[x];
      // NaN where the sample is; where not, the sample's own weight keeps the divisor from 0.
      means[x] = static_cast<float>(mean) + (samples[x] - samples[x]);
    }
  }

  const float* Values;
  float Offset;
  Index Fields; // values, and which are valid
  const BallKernel& Kernel;
  EvenConvolution<Real> Convolution;
  BallSpectrum<Real> Spectrum;
  Index Size[3], Begin[3], End[3];
};
}

#endif
