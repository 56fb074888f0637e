// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Gradient of the primary attribute for VTK's lighting.
//
// Central differences over one voxel, one-sided at the border of the texture and where a neighbour
// has no data. A gradient is a covector: with texture coordinates t = A p + const of data
// coordinates p, the gradient by p is transpose(A) times that by t.
//
// VTK lights in one of two ways. With a single headlight it wants the gradient in data coordinates.
// Otherwise it multiplies what it gets by in_textureToEye and takes that for the normal in eye
// coordinates, which is not the way of a covector and tilts normals by the proportions of the
// block; so it gets what in_textureToEye maps to the right normal.

uniform sampler3D in_tfcPrimary; // only set when there is shading

mat3 g_tfcGradientToLight;
vec3 g_tfcTexel; // size of one in texture coordinates

// Called once per ray.
void tfcBeginLight()
{
  g_tfcTexel = 1.0 / vec3(textureSize(in_volume[0], 0));
  mat3 dataToTexture = mat3(ip_inverseTextureDataAdjusted);
#ifdef TOTAL_NUMBER_LIGHTS
  g_tfcGradientToLight = inverse(mat3(in_textureToEye[0])) * mat3(in_modelViewMatrix) *
    transpose(dataToTexture * mat3(in_inverseVolumeMatrix[0]));
#else
  g_tfcGradientToLight = transpose(dataToTexture);
#endif
}

vec4 computeGradient(in vec3 position, in int component, in sampler3D volume, in int index)
{
  vec3 low = 0.5 * g_tfcTexel;
  float center = g_tfcAttributes.x; // VTK asks at the current sample
  vec3 slope;
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 ahead = position;
    vec3 behind = position;
    ahead[axis] = min(position[axis] + g_tfcTexel[axis], 1.0 - low[axis]);
    behind[axis] = max(position[axis] - g_tfcTexel[axis], low[axis]);
    float valueAhead = texture(in_tfcPrimary, ahead).x;
    float valueBehind = texture(in_tfcPrimary, behind).x;
    if (!(valueAhead == valueAhead))
    {
      valueAhead = center;
      ahead = position;
    }
    if (!(valueBehind == valueBehind))
    {
      valueBehind = center;
      behind = position;
    }
    float width = ahead[axis] - behind[axis];
    slope[axis] = width > 0.0 ? (valueAhead - valueBehind) / width : 0.0;
  }
  return vec4(g_tfcGradientToLight * slope, -1.0);
}
