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
uniform vec2 in_tfcAxisChannel;    // channels of the primary and the secondary attribute
uniform int in_tfcBlendOver;
uniform float in_tfcInverseUnitDistance;

vec3 g_tfcColor; // of the last classified sample

// Colour in rgb and the opacity per unit distance in a.
vec4 tfcClassify(vec4 attributes)
{
  vec2 axes = vec2(attributes[int(in_tfcAxisChannel.x)], attributes[int(in_tfcAxisChannel.y)]);
  vec2 p = axes * in_tfcAxisScale + in_tfcAxisBias;
  // Written so that NaN fails: no region outside the axes, nor where there is no data.
  if (!(p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0))
  {
    return vec4(0.0);
  }

  vec3 colorSum = vec3(0.0);
  float alphaSum = 0.0;
  float transparency = 1.0;
  ivec2 candidates = tfcCandidates(p);
  for (int i = 0; i < candidates.y; ++i)
  {
    int region = tfcCandidateRegion(candidates.x + i);
    vec4 head = tfcFetch(region);
    vec4 size = tfcFetch(region + 2); // and tertiary channel or -1, first opacity node
    float weight = tfcRegionWeight(head, tfcFetch(region + 1), size.xy, p);
    if (weight <= 0.0)
    {
      continue;
    }
    vec4 color = tfcFetch(region + 3); // and number of opacity nodes
    float alpha = head.z * weight;
    if (size.z >= 0.0)
    {
      float v = attributes[int(size.z)];
      int nodes = int(color.w);
      alpha *= tfcTertiaryOpacity(int(size.w), nodes, v);
      if (alpha > 0.0 && head.w > 0.0)
      {
        color.rgb = tfcPiecewiseLinear(int(size.w) + nodes, int(head.w), v);
      }
    }
    if (alpha <= 0.0)
    {
      continue;
    }
    float contribution = in_tfcBlendOver != 0 ? transparency * alpha : alpha;
    colorSum += contribution * color.rgb;
    alphaSum += contribution;
    transparency *= 1.0 - alpha;
  }
  return alphaSum > 0.0 ? vec4(colorSum / alphaSum, 1.0 - transparency) : vec4(0.0);
}

// The two functions that VTK's ray casting loop calls. Opacity is per unit distance in the model
// and corrected here for the length of the current piece.
float computeOpacity(vec4 attributes)
{
  vec4 classified = tfcClassify(attributes);
  g_tfcColor = classified.rgb;
  float units = g_tfcWeight * g_tfcWorldStep * in_tfcInverseUnitDistance;
  if (!(classified.a > 0.0 && units > 0.0))
  {
    return 0.0;
  }
  return classified.a < 1.0 ? 1.0 - pow(1.0 - classified.a, units) : 1.0;
}
