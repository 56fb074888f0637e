// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCRegion.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkTFCEllipseShape.h"
#include "vtkTFCState.h"

#include <algorithm>

vtkStandardNewMacro(vtkTFCRegion);

namespace
{
constexpr const char* LOCKED = "x-locked";
}

namespace
{
//------------------------------------------------------------------------------
bool IsFraction(double value)
{
  return value >= 0 && value <= 1;
}

//------------------------------------------------------------------------------
template <size_t N>
bool FromArray(vtkDoubleArray* from, std::vector<std::array<double, N>>& to, std::string& wrong)
{
  if (!from || from->GetNumberOfComponents() != static_cast<int>(N))
  {
    wrong = ": expected an array with " + std::to_string(N) + " components";
    return false;
  }
  to.resize(from->GetNumberOfTuples());
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    from->GetTypedTuple(i, to[i].data());
  }
  std::string field;
  wrong = vtkTFCCheckNodes(to, &field);
  if (!wrong.empty())
  {
    wrong = field + ": " + wrong;
  }
  return wrong.empty();
}

//------------------------------------------------------------------------------
template <size_t N>
void ToArray(const std::vector<std::array<double, N>>& from, vtkDoubleArray* to)
{
  to->SetNumberOfComponents(N);
  to->SetNumberOfTuples(static_cast<vtkIdType>(from.size()));
  for (size_t i = 0; i < from.size(); ++i)
  {
    to->SetTypedTuple(static_cast<vtkIdType>(i), from[i].data());
  }
}
}

//------------------------------------------------------------------------------
vtkTFCRegion::vtkTFCRegion()
  : Values(new vtkTFCRegionState)
  , Shape(vtkSmartPointer<vtkTFCEllipseShape>::New())
{
}

//------------------------------------------------------------------------------
vtkTFCRegion::~vtkTFCRegion() = default;

//------------------------------------------------------------------------------
vtkMTimeType vtkTFCRegion::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Shape->GetMTime());
}

//------------------------------------------------------------------------------
int vtkTFCRegion::GetId() const
{
  return this->Values->Id;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetName(const char* name)
{
  const std::string text = name ? name : "";
  if (text != this->Values->Name)
  {
    this->Values->Name = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const std::string& vtkTFCRegion::GetName() const
{
  return this->Values->Name;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetVisible(bool visible)
{
  if (visible != this->Values->Visible)
  {
    this->Values->Visible = visible;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkTFCRegion::GetVisible() const
{
  return this->Values->Visible;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetLocked(bool locked)
{
  if (locked != this->GetLocked())
  {
    if (locked)
    {
      this->Values->Extras[LOCKED] = "true";
    }
    else
    {
      this->Values->Extras.erase(LOCKED);
    }
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkTFCRegion::GetLocked() const
{
  const auto locked = this->Values->Extras.find(LOCKED);
  return locked != this->Values->Extras.end() && locked->second == "true";
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetShape(vtkTFCShape* shape)
{
  if (!shape)
  {
    vtkErrorMacro("A region needs a shape, got none.");
    return;
  }
  if (shape != this->Shape)
  {
    this->Shape = shape;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTFCShape* vtkTFCRegion::GetShape() const
{
  return this->Shape;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetFalloff(int type, double width)
{
  if (type < Constant || type > Gaussian || !(width > 0 && width <= 1))
  {
    vtkErrorMacro("falloff: expected a type from 0 to 3 and a width in (0, 1], got "
      << type << " and " << width);
    return;
  }
  const auto falloff = static_cast<vtkTFCFalloffType>(type);
  if (falloff != this->Values->Falloff || width != this->Values->Width)
  {
    this->Values->Falloff = falloff;
    this->Values->Width = width;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkTFCRegion::GetFalloffType() const
{
  return static_cast<int>(this->Values->Falloff);
}

//------------------------------------------------------------------------------
double vtkTFCRegion::GetFalloffWidth() const
{
  return this->Values->Width;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::GetPaletteColor(int n, double color[3])
{
  static const unsigned char palette[8][3] = { { 230, 159, 0 }, { 86, 180, 233 }, { 0, 158, 115 },
    { 213, 94, 0 }, { 0, 114, 178 }, { 204, 121, 167 }, { 240, 228, 66 }, { 153, 153, 153 } };
  for (int c = 0; c < 3; ++c)
  {
    color[c] = palette[(n % 8 + 8) % 8][c] / 255.0;
  }
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetColor(double red, double green, double blue)
{
  if (!IsFraction(red) || !IsFraction(green) || !IsFraction(blue))
  {
    vtkErrorMacro(
      "color: expected numbers in [0, 1], got " << red << ", " << green << ", " << blue);
    return;
  }
  const std::array<double, 3> color = { { red, green, blue } };
  if (color != this->Values->Color)
  {
    this->Values->Color = color;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCRegion::GetColor(double color[3]) const
{
  std::copy_n(this->Values->Color.begin(), 3, color);
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetOpacity(double opacity)
{
  if (!IsFraction(opacity))
  {
    vtkErrorMacro("opacity: expected a number in [0, 1], got " << opacity);
    return;
  }
  if (opacity != this->Values->Opacity)
  {
    this->Values->Opacity = opacity;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkTFCRegion::GetOpacity() const
{
  return this->Values->Opacity;
}

//------------------------------------------------------------------------------
bool vtkTFCRegion::SetTertiary(const char* array, int component, vtkDoubleArray* nodes,
  vtkDoubleArray* colors)
{
  vtkTFCTertiaryState values = this->Values->Tertiary;
  std::string wrong;
  values.Set = true;
  values.Attribute.Array = array ? array : "";
  values.Attribute.Component = component;
  values.Color.clear();
  if (values.Attribute.Array.empty())
  {
    wrong = ".array: expected a non-empty text";
  }
  else if (component < -1 || component > vtkTFCLimits::Component)
  {
    wrong = ".component: expected a component index (-1: vector magnitude)";
  }
  else if (!FromArray(nodes, values.Opacity, wrong))
  {
    wrong = ".opacity" + wrong;
  }
  else if (colors && colors->GetNumberOfTuples() > 0 && !FromArray(colors, values.Color, wrong))
  {
    wrong = ".color" + wrong;
  }
  if (!wrong.empty())
  {
    vtkErrorMacro("tertiary" << wrong);
    return false;
  }
  if (!(values == this->Values->Tertiary))
  {
    this->Values->Tertiary = values;
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::RemoveTertiary()
{
  if (this->Values->Tertiary.Set)
  {
    this->Values->Tertiary = vtkTFCTertiaryState();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkTFCRegion::HasTertiary() const
{
  return this->Values->Tertiary.Set;
}

//------------------------------------------------------------------------------
const std::string& vtkTFCRegion::GetTertiaryArray() const
{
  return this->Values->Tertiary.Attribute.Array;
}

//------------------------------------------------------------------------------
int vtkTFCRegion::GetTertiaryComponent() const
{
  return this->Values->Tertiary.Attribute.Component;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetTertiaryRange(double low, double high)
{
  if (!(low < high) || !vtkTFCIsNumber(low) || !vtkTFCIsNumber(high))
  {
    vtkErrorMacro("tertiary.range: expected low < high, got " << low << ", " << high);
    return;
  }
  vtkTFCTertiaryState& tertiary = this->Values->Tertiary;
  const std::array<double, 2> range = { { low, high } };
  if (!tertiary.HasRange || tertiary.Range != range)
  {
    tertiary.HasRange = true;
    tertiary.Range = range;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTFCRegion::ClearTertiaryRange()
{
  if (this->Values->Tertiary.HasRange)
  {
    this->Values->Tertiary.HasRange = false;
    this->Values->Tertiary.Range = { { 0, 1 } };
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkTFCRegion::GetTertiaryRange(double range[2]) const
{
  std::copy_n(this->Values->Tertiary.Range.begin(), 2, range);
  return this->Values->Tertiary.HasRange;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::GetTertiaryOpacityNodes(vtkDoubleArray* nodes) const
{
  ToArray(this->Values->Tertiary.Opacity, nodes);
}

//------------------------------------------------------------------------------
void vtkTFCRegion::GetTertiaryColorNodes(vtkDoubleArray* nodes) const
{
  ToArray(this->Values->Tertiary.Color, nodes);
}

//------------------------------------------------------------------------------
vtkTFCRegionState vtkTFCRegion::GetValues() const
{
  vtkTFCRegionState values = *this->Values;
  values.Shape = this->Shape->GetValues();
  return values;
}

//------------------------------------------------------------------------------
void vtkTFCRegion::SetValues(const vtkTFCRegionState& values)
{
  if (values == this->GetValues())
  {
    return;
  }
  if (values.Shape.Type != this->Shape->GetValues().Type)
  {
    this->Shape.TakeReference(
      vtkTFCShape::NewShape(vtkTFCShapeNames[static_cast<int>(values.Shape.Type)]));
  }
  this->Shape->SetValues(values.Shape);
  *this->Values = values;
  this->Values->Shape = vtkTFCShapeState();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTFCRegion::DeepCopy(vtkTFCRegion* other)
{
  vtkTFCRegionState values = other->GetValues();
  values.Id = this->Values->Id;
  this->SetValues(values);
}

//------------------------------------------------------------------------------
void vtkTFCRegion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const vtkTFCRegionState& values = *this->Values;
  os << indent << "Id: " << values.Id << "\n";
  os << indent << "Name: " << values.Name << "\n";
  os << indent << "Visible: " << values.Visible << "\n";
  os << indent << "Falloff: " << vtkTFCFalloffNames[this->GetFalloffType()] << " " << values.Width
     << "\n";
  os << indent << "Color: " << values.Color[0] << " " << values.Color[1] << " " << values.Color[2]
     << "\n";
  os << indent << "Opacity: " << values.Opacity << "\n";
  os << indent << "Tertiary: "
     << (values.Tertiary.Set ? values.Tertiary.Attribute.Array : std::string("(none)")) << "\n";
  os << indent << "Shape:\n";
  this->Shape->PrintSelf(os, indent.GetNextIndent());
}
