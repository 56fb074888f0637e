// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCEllipseShape.h"

#include "vtkObjectFactory.h"
#include "vtkTFCState.h"

vtkStandardNewMacro(vtkTFCEllipseShape);

//------------------------------------------------------------------------------
vtkTFCEllipseShape::vtkTFCEllipseShape()
{
  this->Values->Type = vtkTFCShapeType::Ellipse;
}

//------------------------------------------------------------------------------
void vtkTFCEllipseShape::SetCenter(double x, double y)
{
  vtkTFCShapeState values = *this->Values;
  values.Center = { { x, y } };
  this->SetValues(values);
}

//------------------------------------------------------------------------------
void vtkTFCEllipseShape::GetCenter(double center[2]) const
{
  center[0] = this->Values->Center[0];
  center[1] = this->Values->Center[1];
}

//------------------------------------------------------------------------------
void vtkTFCEllipseShape::SetRadii(double x, double y)
{
  vtkTFCShapeState values = *this->Values;
  values.HalfSize = { { x, y } };
  this->SetValues(values);
}

//------------------------------------------------------------------------------
void vtkTFCEllipseShape::GetRadii(double radii[2]) const
{
  radii[0] = this->Values->HalfSize[0];
  radii[1] = this->Values->HalfSize[1];
}

//------------------------------------------------------------------------------
void vtkTFCEllipseShape::SetAngle(double angle)
{
  vtkTFCShapeState values = *this->Values;
  values.Angle = angle;
  this->SetValues(values);
}

//------------------------------------------------------------------------------
double vtkTFCEllipseShape::GetAngle() const
{
  return this->Values->Angle;
}
