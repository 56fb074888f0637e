// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// What happens at a sample: found, classified, lit by VTK and blended into the ray.
//
// Blending (vtkTFCVolumeMapper.h has the formulas): composited front to back unless TFC_MAXIMUM,
// TFC_ADDITIVE, TFC_AVERAGE or TFC_SLICE is defined. The latter use the opacity per unit distance
// and have no end before that of the ray; a slice is a ray with one piece, without light.

vec3 g_tfcCell; // what the transfer function has there (see tfcCell)

// Move to the next sample that some region may show. Samples in between are dealt with here, in a
// short loop of their own, so that on processors that run many rays in step none waits for the
// classification of others.
void tfcBeginSample()
{
  bool invisible;
  do
  {
    tfcLeap();
    g_tfcAttributes = texture(in_volume[0], g_dataPos);
    invisible = !tfcFindCell(g_tfcAttributes, g_tfcCell) && g_tfcWeight > 0.0;
    g_tfcInterval += invisible ? 1.0 : 0.0;
  } while (invisible);
}

// VTK's names: the opacity of the current sample, and its colour with light. The colour is left in
// between for the latter. Beyond the end of the ray, where pieces have no length, there is nothing.
vec3 g_tfcColor;
float g_tfcVisible; // unit distances of the ray with something to see

float computeOpacity(vec4 attributes)
{
#ifdef TFC_MORE_ATTRIBUTES
  g_tfcMoreAttributes = texture(in_tfcMoreAttributes, g_dataPos);
#endif
  vec4 classified = tfcClassify(attributes, g_tfcCell);
  g_tfcColor = classified.rgb;
#ifdef TFC_COMPOSITE
  return tfcPieceOpacity(classified.a);
#else
  return g_tfcWeight > 0.0 ? classified.a : 0.0;
#endif
}

vec4 computeColor(vec4 attributes, float opacity)
{
  vec4 color = vec4(g_tfcColor, opacity);
#if defined(TFC_SHADED) && !defined(TFC_SLICE)
  if (opacity > 0.0)
  {
    color = clamp(computeLighting(color, 0, 0.0), 0.0, 1.0);
  }
#endif
  return color;
}

void tfcBlend()
{
  g_srcColor = computeColor(g_tfcAttributes, computeOpacity(g_tfcAttributes));
  g_srcColor.rgb *= g_srcColor.a;
#ifdef TFC_COMPOSITE
  g_fragColor += (1.0 - g_fragColor.a) * g_srcColor;
#endif
#ifdef TFC_SLICE
  g_fragColor = g_srcColor;
#endif
#ifdef TFC_MAXIMUM
  g_fragColor = g_srcColor.a > g_fragColor.a ? g_srcColor : g_fragColor;
#endif
#if defined(TFC_ADDITIVE) || defined(TFC_AVERAGE)
  float units = g_tfcWeight * g_tfcUnits;
  g_fragColor += units * g_srcColor;
#ifdef TFC_AVERAGE
  g_tfcVisible += g_srcColor.a > 0.0 ? units : 0.0;
#endif
#endif
}

// Called once per ray.
void tfcBeginBlending()
{
  g_tfcVisible = 0.0;
}

// Called once per ray, behind its last sample.
void tfcEndBlending()
{
#ifdef TFC_AVERAGE
  g_fragColor = g_tfcVisible > 0.0 ? g_fragColor / g_tfcVisible : vec4(0.0);
#endif
#ifdef TFC_ADDITIVE
  g_fragColor = min(g_fragColor, 1.0);
#endif
}
