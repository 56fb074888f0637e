// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Weight of a region at a point in axis units: the normalised distance d inside the shape and the
// fall-off w(d), as Plugin/Documentation/state-format.md defines them. Zero outside.

const int TFC_ELLIPSE = 0;
const int TFC_RECTANGLE = 1;

const int TFC_CONSTANT = 0;
const int TFC_LINEAR = 1;
const int TFC_SMOOTH = 2;

// Squared distance from p to the segment (a, b) = (edge.xy, edge.zw).
float tfcSegmentDistance2(vec2 p, vec4 edge)
{
  vec2 ab = edge.zw - edge.xy;
  vec2 ap = p - edge.xy;
  float length2 = dot(ab, ab);
  float t = length2 > 0.0 ? clamp(dot(ap, ab) / length2, 0.0, 1.0) : 0.0;
  vec2 nearest = ap - t * ab;
  return dot(nearest, nearest);
}

// d = 1 - e/E, e the distance to the nearest edge and E its largest value inside; even-odd rule.
float tfcPolygonDistance(vec2 p, int firstEdge, int edgeCount, float inverseE)
{
  bool inside = false;
  float distance2 = 1e30;
  for (int i = 0; i < edgeCount; ++i)
  {
    vec4 edge = tfcFetch(firstEdge + i);
    if ((edge.y > p.y) != (edge.w > p.y) &&
      p.x < (edge.z - edge.x) * (p.y - edge.y) / (edge.w - edge.y) + edge.x)
    {
      inside = !inside;
    }
    distance2 = min(distance2, tfcSegmentDistance2(p, edge));
  }
  return inside ? max(0.0, 1.0 - sqrt(distance2) * inverseE) : 2.0;
}

float tfcFalloff(int type, float width, float d)
{
  if (type == TFC_CONSTANT)
  {
    return 1.0;
  }
  if (type == TFC_LINEAR || type == TFC_SMOOTH)
  {
    float linear = min(1.0, (1.0 - d) / width);
    return type == TFC_LINEAR ? linear : linear * linear * (3.0 - 2.0 * linear);
  }
  return exp(-d * d / (2.0 * width * width)); // gaussian
}

// head, geometry and size are the first three texels of a region (see vtkTFCShaderTables.h).
float tfcRegionWeight(vec4 head, vec4 geometry, vec2 inverseSize, vec2 p)
{
  float d;
  int shape = int(head.x) & 3;
  if (shape == TFC_ELLIPSE || shape == TFC_RECTANGLE)
  {
    // geometry: centre, cosine, sine
    vec2 q = p - geometry.xy;
    q = vec2(geometry.z * q.x + geometry.w * q.y, geometry.z * q.y - geometry.w * q.x);
    q *= inverseSize;
    d = shape == TFC_ELLIPSE ? length(q) : max(abs(q.x), abs(q.y));
  }
  else
  {
    // geometry: first edge, number of edges, 1/E
    d = tfcPolygonDistance(p, int(geometry.x), int(geometry.y), geometry.z);
  }
  return d <= 1.0 ? tfcFalloff(int(head.x) >> 2, head.y, d) : 0.0;
}
