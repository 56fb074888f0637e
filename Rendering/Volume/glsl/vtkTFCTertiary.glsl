// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Piecewise linear functions over a tertiary attribute: nodes (value, y...) in increasing order of
// value, ends extended. Of two nodes at one value the later holds at the value itself and beyond.

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

vec3 tfcPiecewiseLinear(int firstNode, int count, float v)
{
  int node = tfcLastNodeBefore(firstNode, count, v);
  vec4 left = tfcFetch(firstNode + max(node, 0));
  if (node < 0 || node == count - 1)
  {
    return left.yzw;
  }
  vec4 right = tfcFetch(firstNode + node + 1);
  return mix(left.yzw, right.yzw, (v - left.x) / (right.x - left.x));
}

// Opacity factor t of a region; 0 where the tertiary value is NaN.
float tfcTertiaryOpacity(int firstNode, int count, float v)
{
  return (v <= 0.0 || v > 0.0) ? tfcPiecewiseLinear(firstNode, count, v).x : 0.0;
}
