// Gradient of the primary attribute for VTK's lighting.
//
// Central differences over one voxel, one-sided at the border of the texture and where a neighbour has
// no data. VTK lights in one of two ways and expects the gradient accordingly: in data coordinates for
// a single headlight, else as a vector in texture coordinates that in_textureToEye takes to eye
// coordinates. A gradient is a covector, so the first step to either is the gradient in data
// coordinates; VTK's own function leaves that step out, which tilts normals by the block's proportions.

vec4 computeGradient(in vec3 position, in int component, in sampler3D volume, in int index)
{
  int channel = int(in_tfcAxisChannel.x);
  vec3 size = vec3(textureSize(volume, 0));
  vec3 low = 0.5 / size;
  float center = texture(volume, position)[channel];
  vec3 slope;
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 ahead = position;
    vec3 behind = position;
    ahead[axis] = min(position[axis] + 1.0 / size[axis], 1.0 - low[axis]);
    behind[axis] = max(position[axis] - 1.0 / size[axis], low[axis]);
    float valueAhead = texture(volume, ahead)[channel];
    float valueBehind = texture(volume, behind)[channel];
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
  // t = A p + const for data coordinates p: the gradient by p is transpose(A) times that by t.
  vec3 gradient = slope * mat3(ip_inverseTextureDataAdjusted);
#ifdef TOTAL_NUMBER_LIGHTS
  vec3 world = gradient * mat3(in_inverseVolumeMatrix[0]);
  gradient = mat3(in_inverseTextureDatasetMatrix[0]) * mat3(in_inverseVolumeMatrix[0]) * world;
#endif
  return vec4(gradient, -1.0);
}
