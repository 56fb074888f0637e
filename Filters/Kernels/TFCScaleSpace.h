// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Plan of a scale space on a pyramid of lattices: when to diffuse, to halve, to look.
 *
 * A scale is the sigma of a Gaussian; its response is the scale-normalised Laplacian
 * sigma^2 Lap(L) (Lindeberg 1998). For a ball of radius r in D dimensions it is largest at the
 * centre and at sigma = r / sqrt(D), where it is -0.925 times the contrast (D = 3).
 *
 * The scales run geometrically from the one of the smallest to the one of the largest radius, with
 * one more on either side: a maximum needs neighbours in scale.
 *
 * Pyramid: once sigma reaches CoarseningSigma samples along an axis, every other sample of it is
 * dropped. The ones kept have even indices in the whole volume, so that pieces of it agree.
 *
 * The second difference sees a slightly wider Gaussian than the derivative: for a function of the
 * radius alone, by the variance h^2 / (2 (D + 2)). The diffusion takes that much less time.
 */

#ifndef TFCScaleSpace_h
#define TFCScaleSpace_h

#include "TFCDiffusion.h"

#include <vector>

namespace tfc
{
/**
 * Samples per sigma from which on half the resolution suffices, and the fewest samples that an axis
 * is halved to.
 */
constexpr double CoarseningSigma = 4.;
constexpr Index FewestCoarseSamples = 8;

/**
 * How far diffusion may differ from a Gaussian, relative to the variance squared: a ball's sigma
 * then is wrong by about four times as much.
 */
constexpr double FourthOrderTolerance = 0.004;

/**
 * The first and the last scale serve comparison only: they are no farther from their neighbours.
 */
constexpr double LargestGuardRatio = 1.5;

/**
 * What the plan depends on: the whole volume's samples per axis, their distances, and the radii, in
 * one unit of length. The conductance is a difference per shortest distance; linear if 0.
 */
struct ScaleSpaceParameters
{
  Index WholeSize[3] = { 1, 1, 1 };
  double Spacing[3] = { 1., 1., 1. };
  double SmallestRadius = 2.5;
  double LargestRadius = 25.;
  int NumberOfScales = 12;
  double Conductance = 0.;
};

/**
 * One thing to do, in this order: one step of diffusion, Halve the marked axes, or take the
 * Response.
 */
struct ScaleSpaceAction
{
  enum KindType
  {
    Diffuse,
    Halve,
    Respond
  };
  KindType Kind = Diffuse;
  Index Stride[3] = { 1, 1, 1 };      ///< of the lattice after the action, in samples of the volume
  bool BeginsCycle = true;            ///< Diffuse: the conductance comes from this very lattice
  bool Nonlinear = false;             ///< Diffuse
  DiffusionCoefficients Coefficients; ///< Diffuse
  float Weights[3] = { 0.f, 0.f, 0.f }; ///< Respond: for the Laplacian, times sigma^2
};

struct ScaleSpacePlan
{
  /// Samples in half a sigma of a scale, on a lattice with this distance of samples.
  static Index GetHalfSigma(double sigma, double distance)
  {
    return std::max<Index>(1, static_cast<Index>(std::lround(0.5 * sigma / distance)));
  }

  std::vector<ScaleSpaceAction> Actions;
  std::vector<double> Sigmas; ///< of the responses, in order
  int Dimension = 0;          ///< axes with more than one sample

  /**
   * How far, in samples, the responses and a comparison with their neighbours reach: a sample per
   * step, but no more than six sigma. What lies beyond that changes them by less than rounding.
   */
  Index GetReach(double shortestDistance) const
  {
    Index reach = 0, last = 1;
    for (const ScaleSpaceAction& action : this->Actions)
    {
      last = std::max({ action.Stride[0], action.Stride[1], action.Stride[2] });
      reach += action.Kind == ScaleSpaceAction::Diffuse ? last : 0;
    }
    const double sigma = this->Sigmas.empty() ? 0. : this->Sigmas.back();
    return std::min(reach, static_cast<Index>(std::ceil(6. * sigma / shortestDistance))) + 3 * last;
  }
};

/**
 * The plan's own state while it is made: the lattice, and the variance reached.
 */
class ScaleSpacePlanner
{
public:
  explicit ScaleSpacePlanner(const ScaleSpaceParameters& parameters)
    : Parameters(parameters)
  {
    for (int a = 0; a < 3; ++a)
    {
      if (parameters.WholeSize[a] > 1)
      {
        this->Plan.Dimension += 1;
        this->Shortest = this->Shortest > 0. ? std::min(this->Shortest, parameters.Spacing[a])
                                             : parameters.Spacing[a];
      }
    }
    if (this->Plan.Dimension == 0)
    {
      return;
    }
    const int last = parameters.NumberOfScales;
    const double ratio =
      std::pow(parameters.LargestRadius / parameters.SmallestRadius, 1. / std::max(1, last - 1));
    const double first = parameters.SmallestRadius / std::sqrt(1. * this->Plan.Dimension);
    const double guard = std::min(ratio, LargestGuardRatio);
    const auto add = [this](double sigma)
    {
      this->Reach(sigma);
      this->Respond();
    };
    add(first / guard);
    for (int i = 0; i < last; ++i)
    {
      add(first * std::pow(ratio, i));
    }
    add(first * std::pow(ratio, last - 1) * guard);
  }

  ScaleSpacePlan Plan;

private:
  double GetSpacing(int a) const { return this->Parameters.Spacing[a] * this->Stride[a]; }
  bool IsUsed(int a) const { return this->Parameters.WholeSize[a] > 1; }

  /// What the second difference adds to the variance, on the present lattice.
  double GetExtraVariance() const
  {
    double sum = 0.;
    for (int a = 0; a < 3; ++a)
    {
      sum += this->IsUsed(a) ? this->GetSpacing(a) * this->GetSpacing(a) : 0.;
    }
    return sum / (2. * (this->Plan.Dimension + 2) * this->Plan.Dimension);
  }

  /// Sigma at which axis a may be halved; infinite when never.
  double GetHalvingSigma(int a) const
  {
    const Index samples = (this->Parameters.WholeSize[a] - 1) / this->Stride[a] + 1;
    return samples >= 2 * FewestCoarseSamples ? CoarseningSigma * this->GetSpacing(a)
                                              : std::numeric_limits<double>::infinity();
  }

  ScaleSpaceAction MakeAction(ScaleSpaceAction::KindType kind) const
  {
    ScaleSpaceAction action;
    action.Kind = kind;
    std::copy(this->Stride, this->Stride + 3, action.Stride);
    return action;
  }

  /**
   * The steps to a larger variance, in cycles of equal length: the fewest with which the result is
   * a Gaussian within FourthOrderTolerance. To the fourth order in the frequency w, differences in
   * space widen it by extra T w^4 / 2 and steps in time narrow it by sum tau^2 w^4 / 2: steps as
   * long as the extra variance make up for it.
   */
  std::vector<double> MakeSteps(double variance, double longestStable, int& cycleSteps)
  {
    const double time = 0.5 * (variance - this->Variance), extra = this->GetExtraVariance();
    const double tolerated = FourthOrderTolerance * variance * variance;
    for (int count = 1;; ++count)
    {
      for (int n = MaximumCycleSteps; n > 0; --n)
      {
        const int cycles = count / n;
        if (count % n != 0 || time > cycles * GetLongestCycle(n, longestStable))
        {
          continue;
        }
        const std::vector<double> cycle = MakeCycle(n, time / cycles);
        double error = this->FourthOrder - time * extra;
        for (const double step : cycle)
        {
          error += cycles * step * step;
        }
        if (error <= tolerated || (n == 1 && time <= extra * count))
        {
          this->FourthOrder = error;
          cycleSteps = n;
          std::vector<double> steps;
          for (int i = 0; i < cycles; ++i)
          {
            steps.insert(steps.end(), cycle.begin(), cycle.end());
          }
          return steps;
        }
      }
    }
  }

  /// Diffuse up to a variance.
  void Diffuse(double variance, bool nonlinear)
  {
    if (!(variance > this->Variance))
    {
      return;
    }
    double sum = 0.;
    for (int a = 0; a < 3; ++a)
    {
      sum += this->IsUsed(a) ? 1. / (this->GetSpacing(a) * this->GetSpacing(a)) : 0.;
    }
    int cycleSteps = 1;
    const std::vector<double> steps = this->MakeSteps(variance, 0.5 / sum, cycleSteps);
    for (size_t i = 0; i < steps.size(); ++i)
    {
      ScaleSpaceAction action = this->MakeAction(ScaleSpaceAction::Diffuse);
      action.BeginsCycle = !nonlinear || i % cycleSteps == 0;
      action.Nonlinear = nonlinear;
      for (int a = 0; a < 3; ++a)
      {
        const double h = this->GetSpacing(a);
        const double edge = nonlinear ? this->Shortest / (h * this->Parameters.Conductance) : 0.;
        action.Coefficients.Flux[a] =
          this->IsUsed(a) ? static_cast<float>(steps[i] / (h * h)) : 0.f;
        // Bounded: what is smaller than any difference of floats need not be told from 0.
        action.Coefficients.Edge[a] =
          this->IsUsed(a) ? static_cast<float>(std::min(edge * edge, 1e15)) : 0.f;
      }
      this->Plan.Actions.push_back(action);
    }
    this->Variance = variance;
  }

  void Reach(double sigma)
  {
    if (this->Parameters.Conductance > 0. && this->Variance == 0.)
    {
      // Single voxels of noise have the strongest gradients of all: without some smoothing, they
      // would be what is preserved. Beyond about a sample it would only blur.
      const double h = this->Shortest;
      this->Diffuse(std::min(sigma * sigma - this->GetExtraVariance(), h * h), false);
    }
    for (;;)
    {
      double next = std::numeric_limits<double>::infinity();
      for (int a = 0; a < 3; ++a)
      {
        next = std::min(next, this->IsUsed(a) ? this->GetHalvingSigma(a) : next);
      }
      if (!(next < sigma))
      {
        break;
      }
      this->Diffuse(next * next, this->Parameters.Conductance > 0.);
      for (int a = 0; a < 3; ++a)
      {
        // The tolerance keeps axes of equal spacing together.
        const bool halve = this->IsUsed(a) && this->GetHalvingSigma(a) <= next * (1. + 1e-6);
        this->Stride[a] *= halve ? 2 : 1;
      }
      this->Plan.Actions.push_back(this->MakeAction(ScaleSpaceAction::Halve));
    }
    this->Diffuse(sigma * sigma - this->GetExtraVariance(), this->Parameters.Conductance > 0.);
  }

  void Respond()
  {
    ScaleSpaceAction action = this->MakeAction(ScaleSpaceAction::Respond);
    const double variance = this->Variance + this->GetExtraVariance();
    for (int a = 0; a < 3; ++a)
    {
      const double h = this->GetSpacing(a);
      action.Weights[a] = this->IsUsed(a) ? static_cast<float>(variance / (h * h)) : 0.f;
    }
    this->Plan.Actions.push_back(action);
    this->Plan.Sigmas.push_back(std::sqrt(variance));
  }

  ScaleSpaceParameters Parameters;
  Index Stride[3] = { 1, 1, 1 };
  double Shortest = 0.;
  double Variance = 0.;
  double FourthOrder = 0.; ///< sum of tau^2 - extra T, see MakeSchedule()
};
}

#endif
