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
vec3 g_tfcBrickCrossing; // sample distances to cross a brick along each axis
vec3 g_tfcForward;       // 1 for axes along which the ray goes up, else 0
ivec3 g_tfcLastBrick;
float g_tfcFirstMiddle; // number of the piece with its middle at u = 0, less a margin

// Called once per ray, after tfcBeginRay().
void tfcBeginLeaps()
{
  vec3 bricks = vec3(textureSize(in_volume[0], 0)) / in_tfcBrickSize;
  g_tfcBrickOrigin = g_tfcOrigin * bricks - 0.5 / in_tfcBrickSize;
  g_tfcBrickStep = g_dirStep * bricks;
  g_tfcForward = step(0.0, g_tfcBrickStep);
  g_tfcBrickCrossing = 1.0 / max(abs(g_tfcBrickStep), 1e-20);
  g_tfcLastBrick = textureSize(in_tfcBricks, 0) - 1;
  g_tfcFirstMiddle = g_tfcPhase - 0.5 - 1e-3;
}

// Move to the middle of the next piece in an active brick, this one or a later one.
void tfcLeap()
{
  bool leaping;
  do
  {
    tfcPlaceSample();
    vec3 place = g_tfcBrickOrigin + g_tfcMiddle * g_tfcBrickStep;
    vec3 corner = floor(place);
    ivec3 brick = clamp(ivec3(corner), ivec3(0), g_tfcLastBrick);
    float distance = 255.0 * texelFetch(in_tfcBricks, brick, 0).x;
    // The bricks that are nearer than `distance` are empty; u where the ray leaves them. Places
    // beyond the border are taken for a brick more, which is on the safe side.
    vec3 ahead = abs(g_tfcForward - (place - corner)); // in this brick
    vec3 reach = (distance - 1.0 + ahead) * g_tfcBrickCrossing;
    float leave = g_tfcMiddle + min(reach.x, min(reach.y, reach.z));
    // The first piece whose middle is not before that, a little less against rounding.
    float next = ceil(leave * (1.0 - 1e-6) + g_tfcFirstMiddle);
    leaping = distance > 0.5 && g_tfcWeight > 0.0;
    g_tfcInterval = leaping ? max(g_tfcInterval + 1.0, next) : g_tfcInterval;
  } while (leaping);
}
