// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// One ray as a sequence of intervals.
//
// The ray is cut at the multiples of the sample distance, counted from the eye, and at the ends of
// what is visible of this block. Each piece is classified at its middle and weighs its own length
// (midpoint rule). Cuts do not depend on where a block begins, so two blocks that share a face, in
// one process or on two ranks, add up to what one block would have given.
//
// Positions are texture coordinates; u counts sample distances from the entry into the volume.

uniform vec3 in_tfcBoxMin;        // visible part of the block
uniform vec3 in_tfcBoxMax;
uniform vec3 in_tfcUpperMargin;   // for rays along the upper faces, which the next block may have
uniform int in_tfcClipCount;      // clipping planes: visible where dot(plane, vec4(p, 1)) >= 0
uniform vec4 in_tfcClipPlanes[16];
uniform vec3 in_tfcCropMin;       // the two cropping planes of each axis
uniform vec3 in_tfcCropMax;
uniform int in_tfcCropFlags;      // bit r: cropping region r is visible; -1: no cropping

#ifdef TFC_SLICE
uniform vec4 in_tfcSlicePlane;    // 0 on the plane that is shown
#endif

vec3 g_tfcSegmentStart; // start of the segment that a render pass asked for
vec3 g_tfcOrigin;       // u = 0
float g_tfcBegin;       // visible u
float g_tfcEnd;
float g_tfcPhase;       // u of the cut before the entry, negated
float g_tfcInterval;    // number of the current piece, a whole number
float g_tfcWeight;      // length of the current piece, in sample distances
vec4 g_tfcAttributes;   // at the middle of the current piece
float g_tfcMiddle;      // u of its middle
float g_tfcWorldStep;   // world length of one sample distance

vec3 computeRayDirection();

void tfcKeep(bool inside)
{
  if (!inside)
  {
    g_tfcEnd = g_tfcBegin - 1.0;
  }
}

// Intersect the visible u with f0 + u * slope >= 0.
void tfcClipHalfSpace(float f0, float slope)
{
  if (slope > 0.0)
  {
    g_tfcBegin = max(g_tfcBegin, -f0 / slope);
  }
  else if (slope < 0.0)
  {
    g_tfcEnd = min(g_tfcEnd, -f0 / slope);
  }
  else
  {
    tfcKeep(f0 >= 0.0);
  }
}

#ifdef TFC_SLICE
// Make the point in the plane the only piece of the ray, of length 1. A point in the face between
// two blocks belongs to the upper one; the tolerances are larger than rounding.
void tfcKeepSlice()
{
  float slope = dot(in_tfcSlicePlane.xyz, g_dirStep);
  float u = -dot(in_tfcSlicePlane, vec4(g_tfcOrigin, 1.0)) / slope;
  vec3 place = g_tfcOrigin + u * g_dirStep;
  bool hit = abs(slope) > 0.0 && u >= g_tfcBegin - 1e-2 && u <= g_tfcEnd + 1e-2;
  bool inside = all(greaterThanEqual(place, in_tfcBoxMin - 1e-6)) &&
    all(lessThanEqual(place, in_tfcBoxMax + 2.0 * in_tfcUpperMargin));
  g_tfcPhase = 0.5 - u;
  g_tfcInterval = 0.0;
  g_tfcBegin = u - 0.5;
  g_tfcEnd = u + 0.5;
  tfcKeep(hit && inside);
}
#endif

// Called once per ray, when the entry, the end (opaque geometry) and the step are known.
void tfcBeginRay()
{
  float inverseSquare = 1.0 / dot(g_dirStep, g_dirStep);
  g_tfcOrigin = g_rayOrigin - g_rayJitter;

  // VTK puts the start one step behind the entry, and depth peeling once more; from the entry on is
  // what both mean. A segment that starts inside, behind translucent geometry, is one step off.
  vec3 offset = g_tfcSegmentStart - g_rayOrigin;
  float tolerance2 = 1e-6 / inverseSquare;
  vec3 twice = offset - g_rayJitter;
  bool atEntry = dot(offset, offset) < tolerance2 || dot(twice, twice) < tolerance2;
  g_tfcBegin = atEntry ? 0.0
    : max(0.0, dot(g_tfcSegmentStart - g_rayJitter - g_tfcOrigin, g_dirStep) * inverseSquare);
  g_tfcEnd = dot(g_terminatePos - g_tfcOrigin, g_dirStep) * inverseSquare;

  // The entry lies on the proxy geometry up to rounding: give rays along a face that much.
  for (int axis = 0; axis < 3; ++axis)
  {
    bool along = abs(g_dirStep[axis]) < 1e-12;
    float slope = along ? 0.0 : g_dirStep[axis];
    float lower = along ? 1e-6 : 0.0;
    float upper = along ? in_tfcUpperMargin[axis] : 0.0;
    tfcClipHalfSpace(g_tfcOrigin[axis] - in_tfcBoxMin[axis] + lower, slope);
    tfcClipHalfSpace(in_tfcBoxMax[axis] - g_tfcOrigin[axis] + upper, -slope);
  }
  for (int i = 0; i < in_tfcClipCount; ++i)
  {
    tfcClipHalfSpace(dot(in_tfcClipPlanes[i], vec4(g_tfcOrigin, 1.0)),
      dot(in_tfcClipPlanes[i].xyz, g_dirStep));
  }

  vec3 direction = (in_volumeMatrix[0] * vec4(computeRayDirection(), 0.0)).xyz;
  float scale = length(direction);
  g_tfcWorldStep = in_sampleDistance * scale;
  vec3 entry = (in_volumeMatrix[0] * vec4(ip_vertexPos, 1.0)).xyz;
  g_tfcPhase = fract(dot(entry - in_cameraPos, direction / scale) / g_tfcWorldStep + g_jitterValue);
  g_tfcInterval = floor(g_tfcBegin + g_tfcPhase);
#ifdef TFC_SLICE
  tfcKeepSlice();
#endif

  // With depth peeling there are two segments a pixel. Also nothing to do for NaN.
  g_fragColor = vec4(0.0);
  g_exit = !(g_tfcEnd > g_tfcBegin);
}

// Move to the middle of the current piece; beyond the end its weight is 0.
void tfcPlaceSample()
{
  float cut = g_tfcInterval - g_tfcPhase;
  float begin = max(cut, g_tfcBegin);
  float end = min(cut + 1.0, g_tfcEnd);
  g_tfcWeight = max(end - begin, 0.0);
  g_tfcMiddle = 0.5 * (begin + end);
  g_dataPos = g_tfcOrigin + g_tfcMiddle * g_dirStep;
}

// Step to the next piece; true when the ray is done.
bool tfcEndSample()
{
  g_tfcInterval += 1.0;
  bool behind = !(g_tfcInterval - g_tfcPhase < g_tfcEnd);
#if defined(TFC_SELECTION)
  // VTK then takes the voxel of the last sample for what is selected, from this opacity on.
  return behind || g_fragColor.a > 3.0 / 255.0;
#elif defined(TFC_COMPOSITE)
  return behind || g_fragColor.a > g_opacityThreshold;
#else
  return behind;
#endif
}

// Whether the current position lies in a cropping region that is switched off. Regions are counted
// as in vtkVolumeMapper: x fastest, 1 below the first plane, 2 between, 3 above.
bool tfcCropped()
{
#ifdef TFC_CROPPING
  if (in_tfcCropFlags < 0)
  {
    return false;
  }
  ivec3 region = ivec3(greaterThanEqual(g_dataPos, in_tfcCropMin)) +
    ivec3(greaterThanEqual(g_dataPos, in_tfcCropMax));
  return ((in_tfcCropFlags >> (region.x + 3 * region.y + 9 * region.z)) & 1) == 0;
#else
  return false;
#endif
}
