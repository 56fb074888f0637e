// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Weight of a region at a point in axis units: the normalised distance d inside the shape and the
// fall-off w(d), as Plugin/Documentation/state-format.md defines them. Zero outside.
// What the model does not use is not compiled (see vtkTFCShaderTables::Features).

const int TFC_ELLIPSE = 0;
const int TFC_RECTANGLE = 1;

const int TFC_CONSTANT = 0;
const int TFC_LINEAR = 1;
const int TFC_SMOOTH = 2;
const int TFC_GAUSSIAN = 3;

#ifdef TFC_POLYGONS
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
#endif

// `steepness` is 1 / width.
float tfcFalloff(int type, float steepness, float d)
{
  float linear = min(1.0, (1.0 - d) * steepness);
  float weight = type == TFC_SMOOTH ? linear * linear * (3.0 - 2.0 * linear) : linear;
#ifdef TFC_GAUSSIANS
  float scaled = d * steepness;
  weight = type == TFC_GAUSSIAN ? exp(-0.5 * scaled * scaled) : weight;
#endif
  return type == TFC_CONSTANT ? 1.0 : weight;
}

// place and turn are the first two texels of a record (see vtkTFCShaderTables.h).
float tfcRegionWeight(vec4 place, vec4 turn, vec2 p)
{
  int type = int(turn.w);
  int shape = type & 3;
  int falloff = (type >> 2) & 3;
  vec2 offset = p - place.xy;
  vec2 q = vec2(dot(place.zw, offset), dot(turn.xy, offset));
  float d = shape == TFC_RECTANGLE ? max(abs(q.x), abs(q.y)) : length(q);
#ifdef TFC_POLYGONS
  int edges = shape > TFC_RECTANGLE ? int(place.y) : 0;
  float polygon = tfcPolygonDistance(p, int(place.x), edges, place.z);
  d = shape > TFC_RECTANGLE ? polygon : d;
#endif
  return d <= 1.0 ? tfcFalloff(falloff, turn.z, d) : 0.0;
}
