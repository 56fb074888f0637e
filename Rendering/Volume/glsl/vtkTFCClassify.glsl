// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Attributes of one sample -> colour and opacity (Zhou, Schott, Hansen 2012, Eq. 1 and 2).
//
// alpha_j = opacity_j * w_j(primary, secondary) * t_j(tertiary_j) for every region j, then
// mix:  alpha = 1 - prod(1 - alpha_j), colour = sum(alpha_j c_j) / sum(alpha_j)
// over: the first region of the list is in front.
// vtkTFCClassifier is the same on the CPU; a test compares the two.

uniform vec2 in_tfcAxisScale;      // stored value -> axis units
uniform vec2 in_tfcAxisBias;
uniform int in_tfcBlendOver;
uniform int in_tfcFirstRecord;     // texel
uniform float in_tfcInverseUnitDistance;

// Software renderers read a uniform inside a loop for every pixel anew, also when it has been copied
// before. What is computed once per ray is kept.
#ifdef TFC_SEVERAL_REGIONS
vec2 g_tfcCellScale; // stored value -> cells of the index grid
vec2 g_tfcCellBias;
float g_tfcCellSize; // in axis units
bool g_tfcBlendOver;
#else
vec2 g_tfcAxisScale;
vec2 g_tfcAxisBias;
vec4 g_tfcRecord[TFC_RECORD_TEXELS];
#endif
float g_tfcUnits; // sample distance in unit distances

// Called once per ray, after tfcBeginRay().
void tfcBeginClassification()
{
#ifdef TFC_SEVERAL_REGIONS
  g_tfcGridSize = float(in_tfcGridSize);
  g_tfcCellScale = in_tfcAxisScale * g_tfcGridSize;
  g_tfcCellBias = in_tfcAxisBias * g_tfcGridSize;
  g_tfcCellSize = 1.0 / g_tfcGridSize;
  g_tfcBlendOver = in_tfcBlendOver != 0;
#else
  // Added to nothing, so that what is kept is no copy of a uniform.
  g_tfcAxisScale = in_tfcAxisScale + g_tfcWorldStep * 0.0;
  g_tfcAxisBias = in_tfcAxisBias + g_tfcWorldStep * 0.0;
  for (int i = 0; i < TFC_RECORD_TEXELS; ++i)
  {
    g_tfcRecord[i] = tfcFetch(in_tfcFirstRecord + i);
  }
#endif
  g_tfcUnits = g_tfcWorldStep * in_tfcInverseUnitDistance;
}

// Colour and opacity of a region with a 2D weight, by its record (see vtkTFCShaderTables.h).
vec4 tfcClassifyRegion(vec4 attributes, vec4 turn, vec4 paint, float weight)
{
#ifdef TFC_TERTIARIES
  float v = tfcChannel(attributes, int(turn.w) >> 4);
  float alpha = weight * tfcTertiaryOpacity(int(paint.x), v);
  vec3 color = paint.yzw;
#ifdef TFC_TERTIARY_COLORS
  vec4 nodes = tfcFetch(int(paint.x) - 1); // first, count
  if (nodes.y > 0.0 && alpha > 0.0)
  {
    color = tfcTertiaryColor(int(nodes.x), int(nodes.y), v);
  }
#endif
  return vec4(color, alpha);
#else
  return vec4(paint.yzw, weight * paint.x);
#endif
}

#ifdef TFC_SEVERAL_REGIONS
// Whether there may be something at a sample, and what tfcCell() has there. The axes are in the first
// two channels.
bool tfcFindCell(vec4 attributes, out vec3 cell)
{
  vec2 place = attributes.xy * g_tfcCellScale + g_tfcCellBias;
  // Written so that NaN fails: no region outside the axes, nor where there is no data.
  bool inside = place.x >= 0.0 && place.x <= g_tfcGridSize && place.y >= 0.0 &&
    place.y <= g_tfcGridSize;
  vec4 found = tfcCell(place);
  cell = found.xyz;
  return inside && found.w > 0.0;
}

// Colour in rgb and the opacity per unit distance in a, by the records of regions in a cell.
vec4 tfcClassifyRegions(vec4 attributes, vec2 p, ivec2 records)
{
  vec3 colorSum = vec3(0.0);
  float alphaSum = 0.0;
  float transparency = 1.0;
  do
  {
    vec4 turn = tfcFetch(records.x + 1);
    vec4 paint = tfcFetch(records.x + 2);
    float weight = tfcRegionWeight(tfcFetch(records.x), turn, p);
    vec4 region = tfcClassifyRegion(attributes, turn, paint, weight);
    float contribution = g_tfcBlendOver ? transparency * region.a : region.a;
    colorSum += contribution * region.rgb;
    alphaSum += contribution;
    transparency *= 1.0 - region.a;
    records.x += TFC_RECORD_TEXELS;
  } while (records.x < records.y);
  return alphaSum > 0.0 ? vec4(colorSum * (1.0 / alphaSum), 1.0 - transparency) : vec4(0.0);
}

// The same by what the cell has.
vec4 tfcClassify(vec4 attributes, vec3 cell)
{
  vec2 p = (attributes.xy * g_tfcCellScale + g_tfcCellBias) * g_tfcCellSize;
  vec4 classified = vec4(0.0);
  if (cell.x < cell.y)
  {
    classified = tfcClassifyRegions(attributes, p, ivec2(cell.xy));
  }
#ifdef TFC_PATCHES
  vec4 patched = tfcPatch(int(cell.z), p);
  classified = cell.z > 0.0 ? patched : classified;
#endif
  return classified;
}
#else
// The same for a single region, whose record is read once per ray: its weight takes the place of
// the cell.
bool tfcFindCell(vec4 attributes, out vec3 cell)
{
  vec2 p = attributes.xy * g_tfcAxisScale + g_tfcAxisBias;
  bool inside = p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0;
  cell = vec3(tfcRegionWeight(g_tfcRecord[0], g_tfcRecord[1], p), 0.0, 0.0);
  return inside && cell.x > 0.0;
}

vec4 tfcClassify(vec4 attributes, vec3 cell)
{
  vec4 region = tfcClassifyRegion(attributes, g_tfcRecord[1], g_tfcRecord[2], cell.x);
  return region.a > 0.0 ? region : vec4(0.0);
}
#endif

// Opacity of the current piece of the ray, where it is `opacity` per unit distance.
float tfcPieceOpacity(float opacity)
{
  float units = g_tfcWeight * g_tfcUnits;
  return units > 0.0 ? 1.0 - pow(1.0 - opacity, units) : 0.0;
}
