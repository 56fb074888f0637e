// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The transfer function as numbers: one RGBA float texture of 1024 texels a row, read as a list.
// vtkTFCShaderTables writes it and documents the records.

uniform sampler2D in_tfcTables;
uniform int in_tfcGridSize;       // the index grid has this many cells along each axis
uniform int in_tfcCandidateBase;  // first texel of the candidate lists, four entries a texel

vec4 tfcFetch(int texel)
{
  return texelFetch(in_tfcTables, ivec2(texel & 1023, texel >> 10), 0);
}

// Regions that may be non-zero in the grid cell of a point in axis units: (first entry, count).
ivec2 tfcCandidates(vec2 p)
{
  ivec2 cell = min(ivec2(p * float(in_tfcGridSize)), ivec2(in_tfcGridSize - 1));
  return ivec2(tfcFetch(cell.y * in_tfcGridSize + cell.x).xy);
}

// First texel of the region of a candidate entry.
int tfcCandidateRegion(int entry)
{
  return int(tfcFetch(in_tfcCandidateBase + (entry >> 2))[entry & 3]);
}
