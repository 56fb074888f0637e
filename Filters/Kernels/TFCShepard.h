// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Back projection of blobs to a size per sample (Correa and Ma 2008).
 *
 * Shepard's interpolation of the radii r_i of the blobs of one scale,
 *   S(x) = sum_i phi(q_i) r_i / sum_i phi(q_i),  q_i = |x - x_i| / r_i,
 * with Wendland's polynomial phi(q) = (1 - q)^4 (4q + 1) for q < 1, else 0: twice continuously
 * differentiable and positive definite in three dimensions. Of the scales' values the largest is
 * kept (Zhou, Schott and Hansen 2012, Section 4.1); samples that no blob reaches have 0.
 *
 * Cost: the blobs' volumes, r_i^3, and per slice and scale twice the area of the blobs' common
 * box. A row is computed from the blob's first sample in it, wherever the part of it that is wanted
 * begins: pieces of a volume give the same bits.
 */

#ifndef TFCShepard_h
#define TFCShepard_h

#include "TFCGradient.h"

#include <vector>

namespace tfc
{
/**
 * Wendland's polynomial psi_{3,1}.
 */
inline float Wendland(float q)
{
  const float p = q < 1.f ? 1.f - q : 0.f;
  const float square = p * p;
  return square * square * (4.f * q + 1.f);
}

/**
 * What a size is spread from: centre in samples of the whole volume, radius in units of length.
 */
struct SizedBlob
{
  double Position[3] = { 0., 0., 0. };
  double Radius = 0.;
};

/**
 * The part of the whole volume, [Begin, End), that is wanted, and the distances of samples.
 */
struct SizeBox
{
  Index Begin[3] = { 0, 0, 0 };
  Index End[3] = { 0, 0, 0 };
  double Spacing[3] = { 1., 1., 1. };

  Index GetWidth() const { return this->End[0] - this->Begin[0]; }
  Index GetHeight() const { return this->End[1] - this->Begin[1]; }
};

/**
 * Sums of one scale over a slice of the box.
 */
struct SizeWorkspace
{
  std::vector<float> Weighted;
  std::vector<float> Weights;
};

namespace detail
{
/**
 * The samples of axis `a` that lie within `reach` of the blob, as far as the box has them.
 */
inline void GetReached(const SizedBlob& blob, const SizeBox& box, int a, double reach, Index& begin,
  Index& end)
{
  const double samples = reach / box.Spacing[a];
  begin = std::max(box.Begin[a], static_cast<Index>(std::ceil(blob.Position[a] - samples)));
  end = std::min(box.End[a], static_cast<Index>(std::floor(blob.Position[a] + samples)) + 1);
}

inline void AddRow(const SizedBlob& blob, const SizeBox& box, double distanceSquared,
  float* __restrict weighted, float* __restrict weights)
{
  const double rest = blob.Radius * blob.Radius - distanceSquared;
  if (!(rest > 0.))
  {
    return;
  }
  Index begin, end;
  GetReached(blob, box, 0, std::sqrt(rest), begin, end);
  const Index origin = static_cast<Index>(std::floor(blob.Position[0]));
  const double scale = 1. / blob.Radius;
  const float step = static_cast<float>(box.Spacing[0] * scale);
  const float start =
    static_cast<float>((static_cast<double>(origin) - blob.Position[0]) * box.Spacing[0] * scale);
  const float across = static_cast<float>(distanceSquared * scale * scale);
  const float radius = static_cast<float>(blob.Radius);
  const int first = static_cast<int>(begin - origin), last = static_cast<int>(end - origin);
  const Index shift = origin - box.Begin[0];
  for (int i = first; i < last; ++i)
  {
    const float q = start + static_cast<float>(i) * step;
    const float phi = Wendland(std::sqrt(q * q + across));
    weighted[shift + i] += phi * radius;
    weights[shift + i] += phi;
  }
}
}

/**
 * Raise slice z (of the whole volume) of the sizes, `width * height` values, by the blobs of one
 * scale. The workspace is grown when needed.
 */
inline void RaiseSlice(const std::vector<SizedBlob>& blobs, const SizeBox& box, Index z,
  SizeWorkspace& work, float* sizes)
{
  const Index width = box.GetWidth(), height = box.GetHeight();
  Index low[2] = { box.End[0], box.End[1] }, high[2] = { box.Begin[0], box.Begin[1] };
  std::vector<const SizedBlob*> reaching;
  for (const SizedBlob& blob : blobs)
  {
    const double d = (static_cast<double>(z) - blob.Position[2]) * box.Spacing[2];
    const double rest = blob.Radius * blob.Radius - d * d;
    if (rest > 0.)
    {
      Index begin[2], end[2];
      for (int a = 0; a < 2; ++a)
      {
        detail::GetReached(blob, box, a, std::sqrt(rest), begin[a], end[a]);
      }
      if (begin[0] < end[0] && begin[1] < end[1])
      {
        reaching.push_back(&blob);
        for (int a = 0; a < 2; ++a)
        {
          low[a] = std::min(low[a], begin[a]);
          high[a] = std::max(high[a], end[a]);
        }
      }
    }
  }
  if (reaching.empty())
  {
    return;
  }
  work.Weighted.resize(width * height);
  work.Weights.resize(width * height);
  for (Index y = low[1]; y < high[1]; ++y)
  {
    const Index row = (y - box.Begin[1]) * width - box.Begin[0];
    std::fill(&work.Weighted[row + low[0]], &work.Weighted[row + high[0] - 1] + 1, 0.f);
    std::fill(&work.Weights[row + low[0]], &work.Weights[row + high[0] - 1] + 1, 0.f);
  }
  for (const SizedBlob* blob : reaching)
  {
    const double dz = (static_cast<double>(z) - blob->Position[2]) * box.Spacing[2];
    Index begin, end;
    detail::GetReached(*blob, box, 1, std::sqrt(blob->Radius * blob->Radius - dz * dz), begin, end);
    for (Index y = begin; y < end; ++y)
    {
      const double dy = (static_cast<double>(y) - blob->Position[1]) * box.Spacing[1];
      const Index row = (y - box.Begin[1]) * width;
      detail::AddRow(*blob, box, dy * dy + dz * dz, work.Weighted.data() + row,
        work.Weights.data() + row);
    }
  }
  for (Index y = low[1]; y < high[1]; ++y)
  {
    const Index row = (y - box.Begin[1]) * width;
    const float* __restrict weighted = work.Weighted.data() + row;
    const float* __restrict weights = work.Weights.data() + row;
    float* __restrict out = sizes + row;
    for (Index x = low[0] - box.Begin[0]; x < high[0] - box.Begin[0]; ++x)
    {
      const float size = weights[x] > 0.f ? weighted[x] / weights[x] : 0.f;
      out[x] = size > out[x] ? size : out[x];
    }
  }
}
}

#endif
