// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCOutline.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Point = vtkTFCOutline::Point;

// Boxes thinner than this fraction of an axis cannot be seen, and round to nothing.
constexpr double SMALLEST = 1e-9;

Point Rotate(const Point& p, double degrees)
{
  const double c = std::cos(vtkMath::RadiansFromDegrees(degrees));
  const double s = std::sin(vtkMath::RadiansFromDegrees(degrees));
  return { c * p[0] - s * p[1], s * p[0] + c * p[1] };
}

double AngleOf(const Point& center, const Point& p)
{
  return vtkMath::DegreesFromRadians(std::atan2(p[1] - center[1], p[0] - center[0]));
}

double NormalizeAngle(double degrees)
{
  const double turned = std::remainder(degrees, 360.0);
  return turned == -180.0 ? 180.0 : turned;
}

// Twice the signed area of a triangle.
double Cross(const Point& a, const Point& b, const Point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Nearest point of the segment ab to p, with distances measured in units of `scale`.
Point NearestOnSegment(const Point& a, const Point& b, const Point& p, const Point& scale,
  double& distance)
{
  const double dx = (b[0] - a[0]) / scale[0];
  const double dy = (b[1] - a[1]) / scale[1];
  const double px = (p[0] - a[0]) / scale[0];
  const double py = (p[1] - a[1]) / scale[1];
  const double length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp((px * dx + py * dy) / length, 0.0, 1.0) : 0.0;
  distance = std::hypot(px - t * dx, py - t * dy);
  return { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) };
}
}

bool vtkTFCOutline::IsValid() const
{
  const auto finite = [](const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); };
  if (this->IsBox())
  {
    return finite(this->Center) && finite(this->HalfSize) && std::isfinite(this->Angle) &&
      this->HalfSize[0] > SMALLEST && this->HalfSize[1] > SMALLEST;
  }
  if (this->Points.size() < 3 || (this->Type == Types::Triangle && this->Points.size() != 3) ||
    !std::all_of(this->Points.begin(), this->Points.end(), finite))
  {
    return false;
  }
  for (size_t i = 2; i < this->Points.size(); ++i)
  {
    for (size_t k = 1; k < i; k = 2 * k + 1)
    {
      if (std::abs(Cross(this->Points[0], this->Points[k], this->Points[i])) > SMALLEST * SMALLEST)
      {
        return true;
      }
    }
  }
  return false;
}

vtkTFCOutline vtkTFCOutline::Between(Types type, const Point& a, const Point& b)
{
  vtkTFCOutline outline;
  outline.Type = type;
  outline.Center = { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2 };
  outline.HalfSize = { std::abs(b[0] - a[0]) / 2, std::abs(b[1] - a[1]) / 2 };
  if (type == Types::Triangle)
  {
    // Base on the side where the drag began, tip where it goes.
    outline.Points = { a, { b[0], a[1] }, { outline.Center[0], b[1] } };
  }
  return outline;
}

vtkTFCOutline vtkTFCOutline::FromPoints(std::vector<Point> points)
{
  vtkTFCOutline outline;
  outline.Type = Types::Polygon;
  outline.Points = std::move(points);
  return outline;
}

Point vtkTFCOutline::ToLocal(const Point& p) const
{
  return Rotate({ p[0] - this->Center[0], p[1] - this->Center[1] }, -this->Angle);
}

Point vtkTFCOutline::FromLocal(const Point& p) const
{
  const Point turned = Rotate(p, this->Angle);
  return { this->Center[0] + turned[0], this->Center[1] + turned[1] };
}

std::vector<Point> vtkTFCOutline::GetPolyline(int segments) const
{
  if (!this->IsBox())
  {
    return this->Points;
  }
  const double hx = this->HalfSize[0];
  const double hy = this->HalfSize[1];
  std::vector<Point> line;
  if (this->Type == Types::Rectangle)
  {
    for (const Point& p :
      { Point{ -hx, -hy }, Point{ hx, -hy }, Point{ hx, hy }, Point{ -hx, hy } })
    {
      line.push_back(this->FromLocal(p));
    }
    return line;
  }
  line.reserve(segments);
  for (int i = 0; i < segments; ++i)
  {
    const double t = 2 * vtkMath::Pi() * i / segments;
    line.push_back(this->FromLocal({ hx * std::cos(t), hy * std::sin(t) }));
  }
  return line;
}

std::array<double, 4> vtkTFCOutline::GetBounds() const
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 4> bounds = { { infinity, -infinity, infinity, -infinity } };
  for (const Point& p : this->GetPolyline())
  {
    bounds[0] = std::min(bounds[0], p[0]);
    bounds[1] = std::max(bounds[1], p[0]);
    bounds[2] = std::min(bounds[2], p[1]);
    bounds[3] = std::max(bounds[3], p[1]);
  }
  return bounds;
}

bool vtkTFCOutline::Contains(const Point& p) const
{
  if (this->IsBox())
  {
    const Point local = this->ToLocal(p);
    const double x = local[0] / this->HalfSize[0];
    const double y = local[1] / this->HalfSize[1];
    return this->Type == Types::Ellipse ? x * x + y * y <= 1 : std::abs(x) <= 1 && std::abs(y) <= 1;
  }
  bool inside = false;
  for (size_t i = 0, j = this->Points.size() - 1; i < this->Points.size(); j = i++)
  {
    const Point& a = this->Points[i];
    const Point& b = this->Points[j];
    if ((a[1] > p[1]) != (b[1] > p[1]) &&
      p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0])
    {
      inside = !inside;
    }
  }
  return inside;
}

double vtkTFCOutline::GetArea() const
{
  const std::vector<Point> line = this->GetPolyline();
  double area = 0;
  for (size_t i = 0, j = line.size() - 1; i < line.size(); j = i++)
  {
    area += (line[j][0] * line[i][1] - line[i][0] * line[j][1]) / 2;
  }
  return std::abs(area);
}

std::vector<vtkTFCOutline::Handle> vtkTFCOutline::GetHandles(const Point& margin) const
{
  std::vector<Handle> handles;
  if (this->IsBox())
  {
    static const std::array<Point, 4> corners = { { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } };
    static const std::array<Point, 4> sides = { { { 0, -1 }, { 1, 0 }, { 0, 1 }, { -1, 0 } } };
    const double hx = this->HalfSize[0];
    const double hy = this->HalfSize[1];
    for (int i = 0; i < 4; ++i)
    {
      handles.push_back(
        { Handles::Corner, i, this->FromLocal({ hx * corners[i][0], hy * corners[i][1] }) });
    }
    for (int i = 0; i < 4; ++i)
    {
      handles.push_back(
        { Handles::Side, i, this->FromLocal({ hx * sides[i][0], hy * sides[i][1] }) });
    }
    handles.push_back({ Handles::Turn, 0, this->FromLocal({ 0, hy + margin[1] }) });
    return handles;
  }
  for (size_t i = 0; i < this->Points.size(); ++i)
  {
    handles.push_back({ Handles::Vertex, static_cast<int>(i), this->Points[i] });
  }
  const std::array<double, 4> b = this->GetBounds();
  handles.push_back({ Handles::Size, 0, { b[1] + margin[0], b[2] - margin[1] } });
  handles.push_back({ Handles::Turn, 0, { (b[0] + b[1]) / 2, b[3] + margin[1] } });
  return handles;
}

vtkTFCOutline vtkTFCOutline::Moved(const Point& offset) const
{
  vtkTFCOutline moved = *this;
  moved.Center = { this->Center[0] + offset[0], this->Center[1] + offset[1] };
  for (Point& p : moved.Points)
  {
    p = { p[0] + offset[0], p[1] + offset[1] };
  }
  return moved;
}

vtkTFCOutline vtkTFCOutline::Turned(double degrees) const
{
  vtkTFCOutline turned = *this;
  turned.Angle = NormalizeAngle(this->Angle + degrees);
  if (!this->IsBox())
  {
    const std::array<double, 4> b = this->GetBounds();
    const Point middle = { (b[0] + b[1]) / 2, (b[2] + b[3]) / 2 };
    for (Point& p : turned.Points)
    {
      const Point offset = Rotate({ p[0] - middle[0], p[1] - middle[1] }, degrees);
      p = { middle[0] + offset[0], middle[1] + offset[1] };
    }
  }
  return turned;
}

vtkTFCOutline vtkTFCOutline::Scaled(double x, double y, const Point& fixed) const
{
  vtkTFCOutline scaled = *this;
  scaled.HalfSize = { this->HalfSize[0] * x, this->HalfSize[1] * y };
  scaled.Center = { fixed[0] + (this->Center[0] - fixed[0]) * x,
    fixed[1] + (this->Center[1] - fixed[1]) * y };
  for (Point& p : scaled.Points)
  {
    p = { fixed[0] + (p[0] - fixed[0]) * x, fixed[1] + (p[1] - fixed[1]) * y };
  }
  return scaled;
}

vtkTFCOutline vtkTFCOutline::Drag(const Handle& handle, const Point& from, const Point& to,
  const Constraints& constraints, const Point& smallest) const
{
  vtkTFCOutline result = *this;
  const std::array<double, 4> b = this->GetBounds();
  switch (handle.Kind)
  {
    case Handles::Vertex:
      result.Points[handle.Index][0] += to[0] - from[0];
      result.Points[handle.Index][1] += to[1] - from[1];
      break;
    case Handles::Turn:
    {
      const Point middle =
        this->IsBox() ? this->Center : Point{ (b[0] + b[1]) / 2, (b[2] + b[3]) / 2 };
      double turn = AngleOf(middle, to) - AngleOf(middle, from);
      if (constraints.Proportional)
      {
        turn = std::round((this->Angle + turn) / 15) * 15 - this->Angle;
      }
      result = this->Turned(turn);
      break;
    }
    case Handles::Size:
    {
      const Point fixed = { b[0], b[3] };
      double x = std::max(smallest[0], b[1] - b[0] + to[0] - from[0]) / (b[1] - b[0]);
      double y = std::max(smallest[1], b[3] - b[2] + from[1] - to[1]) / (b[3] - b[2]);
      if (constraints.Proportional)
      {
        x = y = std::max(x, y);
      }
      result = this->Scaled(x, y, fixed);
      break;
    }
    case Handles::Corner:
    case Handles::Side:
    {
      static const std::array<Point, 4> corners = { { { -1, -1 }, { 1, -1 }, { 1, 1 },
        { -1, 1 } } };
      static const std::array<Point, 4> sides = { { { 0, -1 }, { 1, 0 }, { 0, 1 }, { -1, 0 } } };
      const Point sign = (handle.Kind == Handles::Corner ? corners : sides)[handle.Index];
      const Point offset = Rotate({ to[0] - from[0], to[1] - from[1] }, -this->Angle);
      Point half = this->HalfSize;
      for (int i = 0; i < 2; ++i)
      {
        const double grow = sign[i] * offset[i] * (constraints.Symmetric ? 1.0 : 0.5);
        half[i] = std::max(smallest[i] / 2, half[i] + grow);
      }
      if (constraints.Proportional)
      {
        const double x = half[0] / this->HalfSize[0];
        const double y = half[1] / this->HalfSize[1];
        const double factor = sign[0] == 0 ? y : (sign[1] == 0 ? x : std::max(x, y));
        half = { this->HalfSize[0] * factor, this->HalfSize[1] * factor };
      }
      if (!constraints.Symmetric)
      {
        result.Center = this->FromLocal(
          { sign[0] * (half[0] - this->HalfSize[0]), sign[1] * (half[1] - this->HalfSize[1]) });
      }
      result.HalfSize = half;
      break;
    }
  }
  return result;
}

int vtkTFCOutline::NearestEdge(const Point& p, const Point& scale, double* distance) const
{
  int nearest = -1;
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < this->Points.size(); ++i)
  {
    double d;
    NearestOnSegment(this->Points[i], this->Points[(i + 1) % this->Points.size()], p, scale, d);
    if (d < smallest)
    {
      smallest = d;
      nearest = static_cast<int>(i);
    }
  }
  if (distance)
  {
    *distance = smallest;
  }
  return nearest;
}

bool vtkTFCOutline::InsertVertex(int edge, const Point& p)
{
  if (edge < 0 || edge >= static_cast<int>(this->Points.size()))
  {
    return false;
  }
  this->Type = Types::Polygon;
  this->Points.insert(this->Points.begin() + edge + 1, p);
  return true;
}

bool vtkTFCOutline::RemoveVertex(int index)
{
  if (this->Points.size() <= 3 || index < 0 || index >= static_cast<int>(this->Points.size()))
  {
    return false;
  }
  vtkTFCOutline less = *this;
  less.Points.erase(less.Points.begin() + index);
  if (!less.IsValid())
  {
    return false;
  }
  *this = less;
  return true;
}

void vtkTFCOutline::GetFalloffLine(Point& inner, Point& outer) const
{
  if (this->IsBox())
  {
    inner = this->Center;
    outer = this->FromLocal({ -this->HalfSize[0], 0 });
    return;
  }
  constexpr int steps = 48;
  const std::array<double, 4> b = this->GetBounds();
  // Many vertices make an exact search slow; the handle only needs a good place.
  const size_t stride = std::max<size_t>(1, this->Points.size() / 200);
  double largest = -1;
  inner = outer = this->Points[0];
  for (int j = 0; j < steps; ++j)
  {
    for (int i = 0; i < steps; ++i)
    {
      const Point p = { b[0] + (b[1] - b[0]) * (i + 0.5) / steps,
        b[2] + (b[3] - b[2]) * (j + 0.5) / steps };
      double smallest = std::numeric_limits<double>::infinity();
      Point nearest = p;
      for (size_t k = 0; k < this->Points.size() && smallest > largest; k += stride)
      {
        const size_t next = k + stride < this->Points.size() ? k + stride : 0;
        double d;
        const Point q = NearestOnSegment(this->Points[k], this->Points[next], p, { 1, 1 }, d);
        if (d < smallest)
        {
          smallest = d;
          nearest = q;
        }
      }
      if (smallest > largest && this->Contains(p))
      {
        largest = smallest;
        inner = p;
        outer = nearest;
      }
    }
  }
}
