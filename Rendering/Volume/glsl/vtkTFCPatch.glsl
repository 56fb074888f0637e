// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Many overlapping regions of a grid cell as one bilinear patch (see vtkTFCPatch.h).

#ifdef TFC_PATCHES

// Colour and opacity at a point in axis units; firstNode: texel of the first of the cell's nodes.
vec4 tfcPatch(int firstNode, vec2 p)
{
  const int last = TFC_PATCH_NODES - 1;
  vec2 inside = p * g_tfcGridSize;
  inside -= min(floor(inside), vec2(g_tfcGridSize - 1.0)); // p = 1 is in the last cell
  vec2 place = inside * float(last);
  ivec2 node = min(ivec2(place), ivec2(last - 1));
  vec2 t = place - vec2(node);
  int first = firstNode + node.y * TFC_PATCH_NODES + node.x;
  vec4 below = mix(tfcFetch(first), tfcFetch(first + 1), t.x);
  first += TFC_PATCH_NODES;
  vec4 above = mix(tfcFetch(first), tfcFetch(first + 1), t.x);
  vec4 value = mix(below, above, t.y);
  return vec4(value.a > 0.0 ? value.rgb / value.a : vec3(0.0), value.a);
}

#endif
