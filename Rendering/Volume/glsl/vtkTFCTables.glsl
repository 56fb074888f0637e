// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The transfer function as numbers: one RGBA float buffer texture.
// vtkTFCShaderTables writes it and documents the records.

uniform samplerBuffer in_tfcTables;
uniform int in_tfcGridSize; // the index grid has this many cells along each axis
float g_tfcGridSize;        // the same, see tfcBeginClassification()

vec4 tfcFetch(int texel)
{
  return texelFetch(in_tfcTables, texel);
}

// What there is in the grid cell of a point in cells: records of regions in texels [x, y), or a
// patch at texel z; w = 1. All 0 where nothing is.
vec4 tfcCell(vec2 place)
{
  vec2 cell = floor(clamp(place, 0.0, g_tfcGridSize - 1.0));
  return tfcFetch(max(int(cell.y * g_tfcGridSize + cell.x), 0)); // whatever NaN is as an integer
}
