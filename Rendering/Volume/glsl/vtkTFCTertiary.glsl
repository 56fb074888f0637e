// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Piecewise linear functions over a tertiary attribute, ends extended. Of two nodes at one value
// the later holds at the value itself and beyond.

#ifdef TFC_TERTIARIES

#ifdef TFC_MORE_ATTRIBUTES
uniform sampler3D in_tfcMoreAttributes; // channels 4 to 7
vec4 g_tfcMoreAttributes;               // at the middle of the current piece
#endif

float tfcChannel(vec4 attributes, int channel)
{
#ifdef TFC_MORE_ATTRIBUTES
  attributes = channel < 4 ? attributes : g_tfcMoreAttributes;
  channel &= 3;
#endif
  vec2 pair = channel < 2 ? attributes.xy : attributes.zw;
  return (channel & 1) == 0 ? pair.x : pair.y;
}

// Opacity of a region times its tertiary function; 0 where the tertiary value is NaN. The pieces
// are chained in increasing order, (a, b, end, next): a + b v for v < end. A search starts at one
// of TFC_BUCKETS copies of pieces, which divide the stored values, 0 to 1, evenly.
float tfcTertiaryOpacity(int firstBucket, float v)
{
  float inside = clamp(v, -1.0, 2.0); // may be infinite
  int texel = firstBucket + clamp(int(inside * float(TFC_BUCKETS)), 0, TFC_BUCKETS - 1);
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
