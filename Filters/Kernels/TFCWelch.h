// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Welch's t-test: have two samples the same mean, whatever their variances?
 *
 * t = (mean1 - mean2) / sqrt(u + w) with u = s1^2 / n1, w = s2^2 / n2 and s^2 that divides by n -
 * 1; nu = (u + w)^2 / (u^2 / (n1 - 1) + w^2 / (n2 - 1)) degrees of freedom (Welch, Biometrika 34,
 * 1947). The means are similar where |t| is at most Student's two-sided quantile.
 *
 * Conventions where formulas fail:
 * - an empty sample is similar to every other;
 * - a single value has no variance: it is taken to be that of the other sample, which makes the
 * test Student's, with n1 + n2 - 2 degrees of freedom;
 * - both variances 0, also by the previous rule: similar only if the means are equal.
 */

#ifndef TFCWelch_h
#define TFCWelch_h

#include <algorithm>
#include <cmath>

namespace tfc
{
/**
 * Natural logarithm of the probability that |T| > t > 0 for Student's T with nu degrees of freedom.
 */
inline double LogStudentTail(double t, double nu)
{
  // The regularised incomplete beta function I_x(a, b) with x = nu / (nu + t^2), a = nu / 2 and
  // b = 1 / 2, by its continued fraction (Lentz's method), which converges fast on one side of the
  // mean only; the other side is the complement.
  const double t2 = t * t;
  const double logX = -std::log1p(t2 / nu), log1MinusX = -std::log1p(nu / t2);
  const double logBeta = std::lgamma(0.5 * nu) + std::lgamma(0.5) - std::lgamma(0.5 * nu + 0.5);
  const bool direct = std::exp(logX) < (0.5 * nu + 1.) / (0.5 * nu + 2.5);
  const double x = std::exp(direct ? logX : log1MinusX);
  const double a = direct ? 0.5 * nu : 0.5, b = direct ? 0.5 : 0.5 * nu;
  constexpr double tiny = 1e-300;
  const auto guard = [](double v) { return std::fabs(v) < tiny ? tiny : v; };
  double c = 1., d = 1. / guard(1. - (a + b) * x / (a + 1.)), fraction = d;
  for (int m = 1; m < 1000; ++m)
  {
    const double even = m * (b - m) * x / ((a + 2 * m - 1.) * (a + 2 * m));
    d = 1. / guard(1. + even * d);
    c = guard(1. + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1.));
    d = 1. / guard(1. + odd * d);
    c = guard(1. + odd / c);
    fraction *= d * c;
    if (std::fabs(d * c - 1.) < 1e-15)
    {
      break;
    }
  }
  const double logFront = 0.5 * nu * logX + 0.5 * log1MinusX - logBeta;
  const double result = logFront + std::log(fraction / a);
  return direct ? result : std::log1p(-std::exp(std::min(result, -1e-16)));
}

/**
 * The same in the limit of infinitely many degrees of freedom.
 */
inline double LogNormalTail(double t)
{
  // erfc() vanishes beyond 38; its expansion is exact to 1e-6 from 30 on.
  return t < 30. ? std::log(std::erfc(t / std::sqrt(2.)))
                 : -0.5 * t * t + 0.5 * std::log(2. / 3.14159265358979323846) - std::log(t) +
      std::log1p(-1. / (t * t));
}

/**
 * Student's two-sided quantile: P(|T| > result) = alpha for nu > 0 degrees of freedom, infinity
 * included. `start` is a guess. Relative error 1e-8 for alpha in [1e-100, 0.9999].
 */
inline double StudentCritical(double alpha, double nu, double start = 1.)
{
  const double logAlpha = std::log(alpha);
  const double pi = 3.14159265358979323846;
  const bool normal = nu > 1e5;
  const double logNorm = normal
    ? -0.5 * std::log(2. * pi)
    : std::lgamma(0.5 * nu + 0.5) - std::lgamma(0.5 * nu) - 0.5 * std::log(nu * pi);
  // ln P is a concave function of ln t: Newton's method converges from everywhere.
  double s = std::log(start);
  for (int i = 0; i < 1000; ++i)
  {
    const double t = std::exp(s);
    const double logTail = normal ? LogNormalTail(t) : LogStudentTail(t, nu);
    const double logDensity =
      logNorm - (normal ? 0.5 * t * t : 0.5 * (nu + 1.) * std::log1p(t * t / nu));
    const double change = (logTail - logAlpha) / (2. * std::exp(logDensity + s - logTail));
    s += std::min(std::max(change, -2.), 2.);
    if (std::fabs(change) < 1e-10)
    {
      break;
    }
  }
  const double t = std::exp(s);
  // First terms of the expansion around the normal quantile.
  return normal ? t + (t * t * t + t) / (4. * nu) : t;
}

/**
 * Count, mean and variance (n - 1) of a sample.
 */
struct SampleMoments
{
  double Count, Mean, Variance;
};

/**
 * What the test compares: similar where Difference^2 <= quantile^2 * Variance, with the quantile
 * for 1 / InverseFreedom degrees of freedom.
 */
struct WelchComparison
{
  double Difference, Variance, InverseFreedom;

  WelchComparison(const SampleMoments& first, const SampleMoments& second)
  {
    const double n1 = first.Count, n2 = second.Count;
    const double u = (n1 < 2. ? second.Variance : first.Variance) / n1;
    const double w = (n2 < 2. ? first.Variance : second.Variance) / n2;
    this->Difference = first.Mean - second.Mean;
    this->Variance = u + w;
    const double part = this->Variance > 0. ? u / this->Variance : 0.;
    this->InverseFreedom = n1 < 2. || n2 < 2.
      ? 1. / std::max(n1 + n2 - 2., 1.)
      : part * part / (n1 - 1.) + (1. - part) * (1. - part) / (n2 - 1.);
  }
};

/**
 * Whether the two samples are similar at level alpha.
 */
inline bool WelchSimilar(const SampleMoments& first, const SampleMoments& second, double alpha)
{
  if (first.Count < 1. || second.Count < 1.)
  {
    return true;
  }
  const WelchComparison test(first, second);
  const double t = StudentCritical(alpha, 1. / test.InverseFreedom);
  return test.Difference * test.Difference <= t * t * test.Variance;
}
}

#endif
