// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sums of the first four powers of samples, for 16 voxels of a row side by side.
 *
 * Sums are those of differences from a value of each lane that is close to its samples: only then
 * does float hold a fourth power. Every lane adds in an order that depends on nothing but the list
 * of offsets, with or without the test for NaN: sums of the same samples have the same bits.
 */

#ifndef TFCPowerSums_h
#define TFCPowerSums_h

#include "TFCGradient.h" // For Index

namespace tfc
{
constexpr int Lanes = 16;

/**
 * Number of samples and sums of their powers for each lane.
 */
struct PowerSums
{
  alignas(64) float Count[Lanes];
  alignas(64) float Sum[4][Lanes];
};

/**
 * Powers of one sample or of a few, while they are in registers.
 */
struct Powers
{
  float Count, Sum[4];

  Powers operator+(const Powers& other) const
  {
    return { this->Count + other.Count,
      { this->Sum[0] + other.Sum[0], this->Sum[1] + other.Sum[1], this->Sum[2] + other.Sum[2],
        this->Sum[3] + other.Sum[3] } };
  }
};

/**
 * Those of value - center; nothing for NaN if there may be NaN.
 */
template <bool Masked>
inline Powers GetPowers(float value, float center)
{
  const float a = Masked && value != value ? 0.f : value - center, square = a * a;
  return { Masked && value != value ? 0.f : 1.f, { a, square, square * a, square * square } };
}

/**
 * Adds the powers of p[offsets[o] + i] - center[i] for `count` offsets to the sums of lane i.
 * `Masked` must be true if there may be NaN, and only then samples are counted.
 */
template <bool Masked>
inline void AddPowers(const float* p, const Index* offsets, Index count,
  const float* __restrict center, PowerSums& sums)
{
  float* __restrict n = sums.Count;
  float* __restrict s1 = sums.Sum[0];
  float* __restrict s2 = sums.Sum[1];
  float* __restrict s3 = sums.Sum[2];
  float* __restrict s4 = sums.Sum[3];
  const auto add = [&](int i, const Powers& powers)
  {
    s1[i] += powers.Sum[0];
    s2[i] += powers.Sum[1];
    s3[i] += powers.Sum[2];
    s4[i] += powers.Sum[3];
    if constexpr (Masked)
    {
      n[i] += powers.Count;
    }
  };
  constexpr auto powers = GetPowers<Masked>;
  Index o = 0;
  // Eight samples at a time: the sums are loaded and stored once, and added up pairwise.
  for (; o + 8 <= count; o += 8)
  {
    const float* __restrict q0 = p + offsets[o];
    const float* __restrict q1 = p + offsets[o + 1];
    const float* __restrict q2 = p + offsets[o + 2];
    const float* __restrict q3 = p + offsets[o + 3];
    const float* __restrict q4 = p + offsets[o + 4];
    const float* __restrict q5 = p + offsets[o + 5];
    const float* __restrict q6 = p + offsets[o + 6];
    const float* __restrict q7 = p + offsets[o + 7];
    for (int i = 0; i < Lanes; ++i)
    {
      const float c = center[i];
      add(i,
        ((powers(q0[i], c) + powers(q1[i], c)) + (powers(q2[i], c) + powers(q3[i], c))) +
          ((powers(q4[i], c) + powers(q5[i], c)) + (powers(q6[i], c) + powers(q7[i], c))));
    }
  }
  if (o + 4 <= count)
  {
    const float* __restrict q0 = p + offsets[o];
    const float* __restrict q1 = p + offsets[o + 1];
    const float* __restrict q2 = p + offsets[o + 2];
    const float* __restrict q3 = p + offsets[o + 3];
    for (int i = 0; i < Lanes; ++i)
    {
      const float c = center[i];
      add(i, (powers(q0[i], c) + powers(q1[i], c)) + (powers(q2[i], c) + powers(q3[i], c)));
    }
    o += 4;
  }
  for (; o < count; ++o)
  {
    const float* __restrict q = p + offsets[o];
    for (int i = 0; i < Lanes; ++i)
    {
      add(i, powers(q[i], center[i]));
    }
  }
}

/**
 * Adds `part`, whose differences are from center[i], to `sums`, whose are from shift[i]: with d =
 * center - shift, (v - shift)^p = ((v - center) + d)^p by the binomial theorem.
 */
inline void AddShifted(const PowerSums& part, const float* __restrict center,
  const float* __restrict shift, PowerSums& sums)
{
  float* __restrict n = sums.Count;
  float* __restrict s1 = sums.Sum[0];
  float* __restrict s2 = sums.Sum[1];
  float* __restrict s3 = sums.Sum[2];
  float* __restrict s4 = sums.Sum[3];
  for (int i = 0; i < Lanes; ++i)
  {
    const float d = center[i] - shift[i], count = part.Count[i];
    const float p1 = part.Sum[0][i], p2 = part.Sum[1][i], p3 = part.Sum[2][i];
    const float p4 = part.Sum[3][i];
    // q_j = j p1 + n d.
    const float q1 = p1 + count * d, q2 = p1 + q1, q3 = p1 + q2, q4 = p1 + q3;
    n[i] += count;
    s1[i] += q1;
    s2[i] += p2 + d * q2;
    s3[i] += p3 + d * (3.f * p2 + d * q3);
    s4[i] += p4 + d * (4.f * p3 + d * (6.f * p2 + d * q4));
  }
}
}

#endif
