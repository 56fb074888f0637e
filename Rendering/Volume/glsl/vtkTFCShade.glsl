// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// One sample: classified, lit by VTK and composited front to back.

// VTK's name for the colour of the sample that computeOpacity() classified last.
vec4 computeColor(vec4 attributes, float opacity)
{
  return clamp(computeLighting(vec4(g_tfcColor, opacity), 0, 0.0), 0.0, 1.0);
}

void tfcComposite(vec4 attributes)
{
  g_srcColor = vec4(0.0);
  g_srcColor.a = computeOpacity(attributes);
  if (g_srcColor.a > 0.0)
  {
    g_srcColor = computeColor(attributes, g_srcColor.a);
    g_srcColor.rgb *= g_srcColor.a;
    g_fragColor += (1.0 - g_fragColor.a) * g_srcColor;
  }
}
