// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCShape.h"

#include "vtkTFCEllipseShape.h"
#include "vtkTFCPolygonShape.h"
#include "vtkTFCRectangleShape.h"
#include "vtkTFCState.h"
#include "vtkTFCTriangleShape.h"

#include <cstring>

//------------------------------------------------------------------------------
vtkTFCShape::vtkTFCShape()
  : Values(new vtkTFCShapeState)
{
}

//------------------------------------------------------------------------------
vtkTFCShape::~vtkTFCShape() = default;

//------------------------------------------------------------------------------
const char* vtkTFCShape::GetTypeName() const
{
  return vtkTFCShapeNames[static_cast<int>(this->Values->Type)];
}

//------------------------------------------------------------------------------
vtkTFCShape* vtkTFCShape::NewShape(const char* typeName)
{
  for (size_t i = 0; typeName && i < vtkTFCShapeNames.size(); ++i)
  {
    if (std::strcmp(typeName, vtkTFCShapeNames[i]) == 0)
    {
      switch (static_cast<vtkTFCShapeType>(i))
      {
        case vtkTFCShapeType::Ellipse:
          return vtkTFCEllipseShape::New();
        case vtkTFCShapeType::Rectangle:
          return vtkTFCRectangleShape::New();
        case vtkTFCShapeType::Triangle:
          return vtkTFCTriangleShape::New();
        case vtkTFCShapeType::Polygon:
          return vtkTFCPolygonShape::New();
      }
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkTFCShape::SetValues(const vtkTFCShapeState& values)
{
  if (values == *this->Values)
  {
    return true;
  }
  std::string field;
  std::string wrong = vtkTFCCheckShape(values, &field);
  if (values.Type != this->Values->Type)
  {
    field = "type";
    wrong = std::string("expected ") + this->GetTypeName();
  }
  if (!wrong.empty())
  {
    vtkErrorMacro(<< field << ": " << wrong);
    return false;
  }
  *this->Values = values;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCShape::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Type: " << this->GetTypeName() << "\n";
  if (this->Values->Points.empty())
  {
    os << indent << "Center: " << this->Values->Center[0] << " " << this->Values->Center[1] << "\n";
    os << indent << "HalfSize: " << this->Values->HalfSize[0] << " " << this->Values->HalfSize[1]
       << "\n";
    os << indent << "Angle: " << this->Values->Angle << "\n";
  }
  for (const auto& point : this->Values->Points)
  {
    os << indent << "Point: " << point[0] << " " << point[1] << "\n";
  }
}
