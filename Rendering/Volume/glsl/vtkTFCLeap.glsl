// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Leaps of a ray over bricks in which the transfer function shows nothing.
//
// A leap goes to a later piece of the ray and moves none, so the picture is the same with leaps and
// without. vtkTFCBrickActivity finds the bricks and their distances.

uniform sampler3D in_tfcBricks; // chessboard distance to the nearest active brick, of 255
uniform float in_tfcBrickSize;  // in texels of the volume

vec3 g_tfcBrickOrigin; // u = 0 in bricks
vec3 g_tfcBrickStep;   // bricks per sample distance
vec3 g_tfcInverseBrickStep;
vec3 g_tfcForward; // 1 for axes along which the ray goes up, else 0
ivec3 g_tfcLastBrick;

// Called once per ray, after tfcBeginRay().
void tfcBeginLeaps()
{
  vec3 bricks = vec3(textureSize(in_volume[0], 0)) / in_tfcBrickSize;
  g_tfcBrickOrigin = g_tfcOrigin * bricks - 0.5 / in_tfcBrickSize;
  g_tfcBrickStep = g_dirStep * bricks;
  g_tfcForward = step(0.0, g_tfcBrickStep);
  g_tfcInverseBrickStep =
    1.0 / mix(min(g_tfcBrickStep, -1e-20), max(g_tfcBrickStep, 1e-20), g_tfcForward);
  g_tfcLastBrick = textureSize(in_tfcBricks, 0) - 1;
}

// Move to the middle of the next piece in an active brick, this one or a later one.
void tfcLeap()
{
  bool leaping;
  do
  {
    tfcPlaceSample();
    vec3 place = g_tfcBrickOrigin + g_tfcMiddle * g_tfcBrickStep;
    ivec3 brick = clamp(ivec3(floor(place)), ivec3(0), g_tfcLastBrick);
    float distance = floor(255.0 * texelFetch(in_tfcBricks, brick, 0).x + 0.5);
    // The bricks that are nearer than `distance` are empty; u where the ray leaves them.
    vec3 wall = vec3(brick) + mix(vec3(1.0 - distance), vec3(distance), g_tfcForward);
    vec3 reach = (wall - place) * g_tfcInverseBrickStep;
    float leave = g_tfcMiddle + min(reach.x, min(reach.y, reach.z));
    // The first piece whose middle is not before that, a little less against rounding.
    int next = int(ceil(leave * (1.0 - 1e-6) - 1e-3 + g_tfcPhase - 0.5));
    leaping = distance > 0.0 && g_tfcWeight > 0.0;
    g_tfcInterval = leaping ? max(g_tfcInterval + 1, next) : g_tfcInterval;
  } while (leaping);
}
