// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Colour of the sample that computeOpacity() classified last, lit by VTK.
vec4 computeColor(vec4 attributes, float opacity)
{
  return clamp(computeLighting(vec4(g_tfcColor, opacity), 0, 0.0), 0.0, 1.0);
}
