// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCPolygonShape.h"

#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkTFCState.h"

vtkStandardNewMacro(vtkTFCPolygonShape);

//------------------------------------------------------------------------------
vtkTFCPolygonShape::vtkTFCPolygonShape()
{
  this->Values->Type = vtkTFCShapeType::Polygon;
  this->Values->Points = { { { 0, 0 } }, { { 1, 0 } }, { { 0, 1 } } };
}

//------------------------------------------------------------------------------
bool vtkTFCPolygonShape::SetPoints(vtkPoints* points)
{
  vtkTFCShapeState values = *this->Values;
  values.Points.clear();
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    values.Points.push_back({ { point[0], point[1] } });
  }
  return this->SetValues(values);
}

//------------------------------------------------------------------------------
int vtkTFCPolygonShape::GetNumberOfPoints() const
{
  return static_cast<int>(this->Values->Points.size());
}

//------------------------------------------------------------------------------
void vtkTFCPolygonShape::GetPoint(int index, double point[2]) const
{
  const bool known = index >= 0 && static_cast<size_t>(index) < this->Values->Points.size();
  point[0] = known ? this->Values->Points[index][0] : 0.0;
  point[1] = known ? this->Values->Points[index][1] : 0.0;
}
