// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The transfer function as numbers: one RGBA float buffer texture.
// vtkTFCShaderTables writes it and documents the records.

uniform samplerBuffer in_tfcTables;
uniform int in_tfcGridSize; // the index grid has this many cells along each axis

vec4 tfcFetch(int texel)
{
  return texelFetch(in_tfcTables, texel);
}

// What there is in the grid cell of a point in axis units: records of regions in texels [x, y), or a
// patch at texel z. All 0 where nothing is.
ivec3 tfcCell(vec2 p)
{
  ivec2 cell = clamp(ivec2(p * float(in_tfcGridSize)), ivec2(0), ivec2(in_tfcGridSize - 1));
  return ivec3(tfcFetch(cell.y * in_tfcGridSize + cell.x).xyz);
}
