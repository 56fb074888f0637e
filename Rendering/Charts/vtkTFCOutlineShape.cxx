// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Outlines from and to the shapes of the model.
#include "vtkTFCOutline.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTFCEllipseShape.h"
#include "vtkTFCPolygonShape.h"
#include "vtkTFCRectangleShape.h"
#include "vtkTFCTriangleShape.h"

namespace
{
using Point = vtkTFCOutline::Point;

Point ToAxis(const double p[2], const vtkTFCOutline::Ranges& r)
{
  return { (p[0] - r[0]) / (r[1] - r[0]), (p[1] - r[2]) / (r[3] - r[2]) };
}

Point ToData(const Point& p, const vtkTFCOutline::Ranges& r)
{
  return { r[0] + p[0] * (r[1] - r[0]), r[2] + p[1] * (r[3] - r[2]) };
}
}

vtkTFCOutline vtkTFCOutline::FromShape(const vtkTFCShape* shape, const Ranges& r)
{
  vtkTFCOutline outline;
  // The getters of shapes that fill an array are const, SafeDownCast is not.
  auto* object = const_cast<vtkTFCShape*>(shape);
  double center[2];
  double half[2];
  double p[2];
  if (auto* ellipse = vtkTFCEllipseShape::SafeDownCast(object))
  {
    ellipse->GetCenter(center);
    ellipse->GetRadii(half);
    outline.Angle = ellipse->GetAngle();
  }
  else if (auto* rectangle = vtkTFCRectangleShape::SafeDownCast(object))
  {
    outline.Type = Types::Rectangle;
    rectangle->GetCenter(center);
    rectangle->GetHalfSize(half);
    outline.Angle = rectangle->GetAngle();
  }
  else if (auto* triangle = vtkTFCTriangleShape::SafeDownCast(object))
  {
    outline.Type = Types::Triangle;
    for (int i = 0; i < 3; ++i)
    {
      triangle->GetPoint(i, p);
      outline.Points.push_back(ToAxis(p, r));
    }
  }
  else if (auto* polygon = vtkTFCPolygonShape::SafeDownCast(object))
  {
    outline.Type = Types::Polygon;
    for (int i = 0; i < polygon->GetNumberOfPoints(); ++i)
    {
      polygon->GetPoint(i, p);
      outline.Points.push_back(ToAxis(p, r));
    }
  }
  if (outline.IsBox())
  {
    outline.Center = ToAxis(center, r);
    outline.HalfSize = { half[0] / (r[1] - r[0]), half[1] / (r[3] - r[2]) };
  }
  return outline;
}

bool vtkTFCOutline::Store(vtkTFCShape* shape, const Ranges& r) const
{
  if (!this->IsValid())
  {
    return false;
  }
  const Point center = ToData(this->Center, r);
  const Point half = { this->HalfSize[0] * (r[1] - r[0]), this->HalfSize[1] * (r[3] - r[2]) };
  if (auto* ellipse = vtkTFCEllipseShape::SafeDownCast(shape))
  {
    ellipse->SetCenter(center[0], center[1]);
    ellipse->SetRadii(half[0], half[1]);
    ellipse->SetAngle(this->Angle);
    return this->Type == Types::Ellipse;
  }
  if (auto* rectangle = vtkTFCRectangleShape::SafeDownCast(shape))
  {
    rectangle->SetCenter(center[0], center[1]);
    rectangle->SetHalfSize(half[0], half[1]);
    rectangle->SetAngle(this->Angle);
    return this->Type == Types::Rectangle;
  }
  std::vector<Point> data;
  data.reserve(this->Points.size());
  for (const Point& p : this->Points)
  {
    data.push_back(ToData(p, r));
  }
  if (auto* triangle = vtkTFCTriangleShape::SafeDownCast(shape))
  {
    triangle->SetPoints(data[0][0], data[0][1], data[1][0], data[1][1], data[2][0], data[2][1]);
    return this->Type == Types::Triangle;
  }
  auto* polygon = vtkTFCPolygonShape::SafeDownCast(shape);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : data)
  {
    points->InsertNextPoint(p[0], p[1], 0);
  }
  return polygon && polygon->SetPoints(points);
}

vtkSmartPointer<vtkTFCShape> vtkTFCOutline::NewShape(const Ranges& ranges) const
{
  static const std::array<const char*, 4> names = { { "ellipse", "rectangle", "triangle",
    "polygon" } };
  auto shape = vtkSmartPointer<vtkTFCShape>::Take(
    vtkTFCShape::NewShape(names[static_cast<size_t>(this->Type)]));
  return this->Store(shape, ranges) ? shape : nullptr;
}
