// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// What happens at a sample: found, classified, lit by VTK and composited front to back.

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
// between for the latter.
vec3 g_tfcColor;

float computeOpacity(vec4 attributes)
{
  vec4 classified = tfcClassify(attributes, g_tfcCell);
  g_tfcColor = classified.rgb;
  return tfcPieceOpacity(classified.a);
}

vec4 computeColor(vec4 attributes, float opacity)
{
  vec4 color = vec4(g_tfcColor, opacity);
#ifdef TFC_SHADED
  if (opacity > 0.0)
  {
    color = clamp(computeLighting(color, 0, 0.0), 0.0, 1.0);
  }
#endif
  return color;
}

void tfcComposite()
{
  g_srcColor = computeColor(g_tfcAttributes, computeOpacity(g_tfcAttributes));
  g_srcColor.rgb *= g_srcColor.a;
  g_fragColor += (1.0 - g_fragColor.a) * g_srcColor;
}
