// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCTriangleShape.h"

#include "vtkObjectFactory.h"
#include "vtkTFCState.h"

vtkStandardNewMacro(vtkTFCTriangleShape);

//------------------------------------------------------------------------------
vtkTFCTriangleShape::vtkTFCTriangleShape()
{
  this->Values->Type = vtkTFCShapeType::Triangle;
  this->Values->Points = { { { 0, 0 } }, { { 1, 0 } }, { { 0, 1 } } };
}

//------------------------------------------------------------------------------
void vtkTFCTriangleShape::SetPoints(double x0, double y0, double x1, double y1, double x2,
  double y2)
{
  vtkTFCShapeState values = *this->Values;
  values.Points = { { { x0, y0 } }, { { x1, y1 } }, { { x2, y2 } } };
  this->SetValues(values);
}

//------------------------------------------------------------------------------
void vtkTFCTriangleShape::GetPoint(int index, double point[2]) const
{
  const bool known = index >= 0 && static_cast<size_t>(index) < this->Values->Points.size();
  point[0] = known ? this->Values->Points[index][0] : 0.0;
  point[1] = known ? this->Values->Points[index][1] : 0.0;
}
