// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Gradient of the shaded attribute for VTK's lighting: one fetch (see vtkTFCGradientTexture.h); or of
// the classified opacity: six samples more.
//
// A gradient is a covector: with texture coordinates t = A p + const of data coordinates p, the
// gradient by p is transpose(A) times that by t.
//
// VTK lights in one of two ways. With a single headlight it wants the gradient in data coordinates.
// Otherwise it multiplies what it gets by in_textureToEye and takes that for the normal in eye
// coordinates, which is not the way of a covector and tilts normals by the proportions of the
// block; so it gets what in_textureToEye maps to the right normal.

#ifndef TFC_SHADE_BY_OPACITY
uniform sampler3D in_tfcGradients; // only set when there is shading
#endif

mat3 g_tfcGradientToLight;

// Called once per ray.
void tfcBeginLight()
{
  mat3 dataToTexture = mat3(ip_inverseTextureDataAdjusted);
#ifdef TOTAL_NUMBER_LIGHTS
  g_tfcGradientToLight = inverse(mat3(in_textureToEye[0])) * mat3(in_modelViewMatrix) *
    transpose(dataToTexture * mat3(in_inverseVolumeMatrix[0]));
  // VTK takes g_dataPos for a place in the box of the points, half a voxel off at its faces: texels
  // are in the middle (still so in August 2026).
  g_texToView = in_modelViewMatrix * in_volumeMatrix[0] * inverse(ip_inverseTextureDataAdjusted);
#else
  g_tfcGradientToLight = transpose(dataToTexture);
#endif
}

#ifdef TFC_SHADE_BY_OPACITY
// Opacity per unit distance of the transfer function at any place.
float tfcOpacityAt(vec3 position)
{
  vec4 attributes = texture(in_volume[0], position);
#ifdef TFC_MORE_ATTRIBUTES
  g_tfcMoreAttributes = texture(in_tfcMoreAttributes, position);
#endif
  vec3 cell;
  bool found = tfcFindCell(attributes, cell);
  float opacity = tfcClassify(attributes, cell).a;
  return found ? opacity : 0.0;
}

// Differences of the classified opacity over a texel on each side, less where the data ends.
vec3 tfcSlope(vec3 position)
{
  vec3 texel = 1.0 / vec3(textureSize(in_volume[0], 0));
  vec3 slope;
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 above = position;
    vec3 below = position;
    above[axis] = min(position[axis] + texel[axis], 1.0 - 0.5 * texel[axis]);
    below[axis] = max(position[axis] - texel[axis], 0.5 * texel[axis]);
    float span = above[axis] - below[axis];
    slope[axis] = span > 0.0 ? (tfcOpacityAt(above) - tfcOpacityAt(below)) / span : 0.0;
  }
  return slope;
}
#else
vec3 tfcSlope(vec3 position)
{
  return texture(in_tfcGradients, position).xyz;
}
#endif

vec4 computeGradient(in vec3 position, in int component, in sampler3D volume, in int index)
{
  vec3 slope = tfcSlope(position);
  return vec4(g_tfcGradientToLight * slope, -1.0);
}
