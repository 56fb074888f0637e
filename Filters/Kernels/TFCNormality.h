// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief D'Agostino's K-squared test of normality.
 *
 * K^2 = Z1(g1)^2 + Z2(b2)^2 of the sample skewness g1 = m3 / m2^1.5 and the sample kurtosis
 * b2 = m4 / m2^2 (3 for a normal distribution), with central moments m_i that divide by n. Z1 is
 * D'Agostino's transformation (Biometrika 57, 1970) and Z2 that of Anscombe and Glynn
 * (Biometrika 70, 1983); under normality both are nearly standard normal, and K^2 nearly
 * chi-squared with 2 degrees of freedom, whose quantile is -2 ln(alpha) exactly.
 *
 * Conventions where formulas fail:
 * - n < 7: Z1 is undefined; the callers do not test. n = 7: Z1 is its limit.
 * - m2 = 0, identical samples: K^2 = 0, they pass.
 * - g1 = 0, symmetric samples: Z1 = 0 (some libraries return 1.04 there).
 * - the denominator of Z2 is 0: Z2 is infinite, the samples are rejected.
 */

#ifndef TFCNormality_h
#define TFCNormality_h

#include <cmath>
#include <limits>

namespace tfc
{
/**
 * Fewest samples that the test is used for.
 */
constexpr int SmallestNormalitySample = 8;

/**
 * The test's constants for samples of one size n >= 7:
 * Z1 = SkewnessDelta * asinh(SkewnessScale * g1) and
 * Z2 = (KurtosisCenter - cbrt(KurtosisNumerator / (1 + KurtosisScale * (b2 - KurtosisMean)))) /
 * KurtosisWidth.
 */
struct NormalityConstants
{
  double SkewnessScale, SkewnessDelta;
  double KurtosisMean, KurtosisScale, KurtosisNumerator, KurtosisCenter, KurtosisWidth;

  explicit NormalityConstants(double n)
  {
    const double y = std::sqrt((n + 1.) * (n + 3.) / (6. * (n - 2.)));
    const double beta2 = 3. * (n * n + 27. * n - 70.) * (n + 1.) * (n + 3.) /
      ((n - 2.) * (n + 5.) * (n + 7.) * (n + 9.));
    // W^2 is 1 at n = 7, where delta * asinh(Y / a) has the limit Y: a W^2 just above 1 gives it.
    const double w2 = std::fmax(std::sqrt(2. * (beta2 - 1.)) - 1., 1. + 1e-9);
    this->SkewnessDelta = 1. / std::sqrt(0.5 * std::log(w2));
    this->SkewnessScale = y * std::sqrt((w2 - 1.) / 2.);

    this->KurtosisMean = 3. * (n - 1.) / (n + 1.);
    const double variance =
      24. * n * (n - 2.) * (n - 3.) / ((n + 1.) * (n + 1.) * (n + 3.) * (n + 5.));
    const double skewness = 6. * (n * n - 5. * n + 2.) / ((n + 7.) * (n + 9.)) *
      std::sqrt(6. * (n + 3.) * (n + 5.) / (n * (n - 2.) * (n - 3.)));
    const double a =
      6. + 8. / skewness * (2. / skewness + std::sqrt(1. + 4. / (skewness * skewness)));
    this->KurtosisScale = std::sqrt(2. / (a - 4.) / variance);
    this->KurtosisNumerator = 1. - 2. / a;
    this->KurtosisCenter = 1. - 2. / (9. * a);
    this->KurtosisWidth = std::sqrt(2. / (9. * a));
  }

  double GetZ1(double skewness) const
  {
    return this->SkewnessDelta * std::asinh(this->SkewnessScale * skewness);
  }

  double GetZ2(double kurtosis) const
  {
    const double denominator = 1. + this->KurtosisScale * (kurtosis - this->KurtosisMean);
    if (denominator == 0.)
    {
      return -std::numeric_limits<double>::infinity();
    }
    return (this->KurtosisCenter - std::cbrt(this->KurtosisNumerator / denominator)) /
      this->KurtosisWidth;
  }
};

/**
 * K^2 of n >= 7 samples with the central moments m2, m3 and m4.
 */
inline double NormalityStatistic(double n, double m2, double m3, double m4)
{
  if (!(m2 > 0.))
  {
    return 0.;
  }
  const NormalityConstants constants(n);
  const double z1 = constants.GetZ1(m3 / (m2 * std::sqrt(m2)));
  const double z2 = constants.GetZ2(m4 / (m2 * m2));
  return z1 * z1 + z2 * z2;
}

/**
 * The samples pass as normal while K^2 is below this value.
 */
inline double NormalityCritical(double alpha)
{
  return -2. * std::log(alpha);
}
}

#endif
