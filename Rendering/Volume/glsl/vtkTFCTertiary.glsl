// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Piecewise linear functions over a tertiary attribute, ends extended. Of two nodes at one value
// the later holds at the value itself and beyond.

#ifdef TFC_TERTIARIES

float tfcChannel(vec4 attributes, float channel)
{
  vec2 pair = channel < 1.5 ? attributes.xy : attributes.zw;
  return channel == 0.0 || channel == 2.0 ? pair.x : pair.y;
}

// Opacity factor t of a region; 0 where the tertiary value is NaN. The pieces are chained in
// increasing order, (a, b, end, next): t = a + b v for v < end. A table of as many buckets as
// TFC_BUCKETS starts each search near its end. function: (channel, first bucket, low, scale).
float tfcTertiaryOpacity(vec4 function, float v)
{
  float buckets = float(TFC_BUCKETS);
  float position = clamp((v - function.z) * function.w, 0.0, buckets);
  int texel = int(function.y) + min(int(position), TFC_BUCKETS - 1);
  float inside = clamp(v, function.z, function.z + buckets / function.w); // may be infinite
  vec4 piece;
  bool beyond;
  do
  {
    // Repeating this changes nothing: llvmpipe does that for pixels that are done while others of
    // the same block go on, and forgets to keep their `piece`.
    piece = tfcFetch(texel);
    beyond = inside >= piece.z;
    texel = beyond ? int(piece.w) : texel;
  } while (beyond);
  return (v <= 0.0 || v > 0.0) ? clamp(piece.x + piece.y * inside, 0.0, 1.0) : 0.0;
}

#endif

#ifdef TFC_TERTIARY_COLORS

// Last node with value <= v, or -1.
int tfcLastNodeBefore(int firstNode, int count, float v)
{
  int low = -1;
  int high = count;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    if (tfcFetch(firstNode + middle).x <= v)
    {
      low = middle;
    }
    else
    {
      high = middle;
    }
  }
  return low;
}

// Colour by nodes (value, r, g, b).
vec3 tfcTertiaryColor(int firstNode, int count, float v)
{
  int node = tfcLastNodeBefore(firstNode, count, v);
  vec4 left = tfcFetch(firstNode + max(node, 0));
  vec4 right = tfcFetch(firstNode + min(node + 1, count - 1));
  float span = right.x - left.x;
  return mix(left.yzw, right.yzw, span > 0.0 ? clamp((v - left.x) / span, 0.0, 1.0) : 0.0);
}

#endif
