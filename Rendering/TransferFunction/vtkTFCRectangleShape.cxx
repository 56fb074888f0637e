// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRectangleShape.h"

#include "vtkObjectFactory.h"
#include "vtkTFCState.h"

vtkStandardNewMacro(vtkTFCRectangleShape);

//------------------------------------------------------------------------------
vtkTFCRectangleShape::vtkTFCRectangleShape()
{
  this->Values->Type = vtkTFCShapeType::Rectangle;
}

//------------------------------------------------------------------------------
void vtkTFCRectangleShape::SetCenter(double x, double y)
{
  vtkTFCShapeState values = *this->Values;
  values.Center = { { x, y } };
  this->SetValues(values);
}

//------------------------------------------------------------------------------
void vtkTFCRectangleShape::GetCenter(double center[2]) const
{
  center[0] = this->Values->Center[0];
  center[1] = this->Values->Center[1];
}

//------------------------------------------------------------------------------
void vtkTFCRectangleShape::SetHalfSize(double x, double y)
{
  vtkTFCShapeState values = *this->Values;
  values.HalfSize = { { x, y } };
  this->SetValues(values);
}

//------------------------------------------------------------------------------
void vtkTFCRectangleShape::GetHalfSize(double halfSize[2]) const
{
  halfSize[0] = this->Values->HalfSize[0];
  halfSize[1] = this->Values->HalfSize[1];
}

//------------------------------------------------------------------------------
void vtkTFCRectangleShape::SetAngle(double angle)
{
  vtkTFCShapeState values = *this->Values;
  values.Angle = angle;
  this->SetValues(values);
}

//------------------------------------------------------------------------------
double vtkTFCRectangleShape::GetAngle() const
{
  return this->Values->Angle;
}
