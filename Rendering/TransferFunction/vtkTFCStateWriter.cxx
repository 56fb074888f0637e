// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCState.h"

#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

namespace
{
//------------------------------------------------------------------------------
// Bytes that are not UTF-8 (only setters can bring them in, not the reader) are replaced, so that
// what is written can always be read.
std::string Quoted(const std::string& text)
{
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

//------------------------------------------------------------------------------
template <typename List>
std::string Numbers(const List& values)
{
  std::string out = "[";
  for (const double value : values)
  {
    out += (out.size() > 1 ? ", " : "") + vtkTFCNumberText(value);
  }
  return out + "]";
}

//------------------------------------------------------------------------------
template <size_t N>
std::string Rows(const std::vector<std::array<double, N>>& rows)
{
  std::string out = "[";
  for (const auto& row : rows)
  {
    out += (out.size() > 1 ? ", " : "") + Numbers(row);
  }
  return out + "]";
}

//------------------------------------------------------------------------------
std::string Attribute(const vtkTFCAttribute& attribute, bool hasRange,
  const std::array<double, 2>& range)
{
  return "{\"array\": " + Quoted(attribute.Array) +
    ", \"component\": " + std::to_string(attribute.Component) +
    ", \"range\": " + (hasRange ? Numbers(range) : "null");
}

//------------------------------------------------------------------------------
std::string Axis(const vtkTFCAxisState& axis)
{
  return axis.Set ? Attribute(axis.Attribute, axis.HasRange, axis.Range) + "}" : "null";
}

//------------------------------------------------------------------------------
std::string Shape(const vtkTFCShapeState& shape)
{
  std::string out =
    std::string("{\"type\": \"") + vtkTFCShapeNames[static_cast<int>(shape.Type)] + "\", ";
  switch (shape.Type)
  {
    case vtkTFCShapeType::Ellipse:
    case vtkTFCShapeType::Rectangle:
      out += "\"center\": " + Numbers(shape.Center) +
        (shape.Type == vtkTFCShapeType::Ellipse ? ", \"radii\": " : ", \"halfsize\": ") +
        Numbers(shape.HalfSize) + ", \"angle\": " + vtkTFCNumberText(shape.Angle);
      break;
    case vtkTFCShapeType::Triangle:
    case vtkTFCShapeType::Polygon:
      out += "\"points\": " + Rows(shape.Points);
      break;
  }
  return out + "}";
}

//------------------------------------------------------------------------------
std::string Extras(const vtkTFCExtras& extras, const char* separator)
{
  std::string out;
  for (const auto& item : extras)
  {
    out += separator + Quoted(item.first) + ": " + item.second;
  }
  return out;
}

}

//------------------------------------------------------------------------------
std::string vtkTFCTertiaryText(const vtkTFCTertiaryState& tertiary)
{
  if (!tertiary.Set)
  {
    return "null";
  }
  std::string out = Attribute(tertiary.Attribute, tertiary.HasRange, tertiary.Range) +
    ", \"opacity\": " + Rows(tertiary.Opacity);
  if (!tertiary.Color.empty())
  {
    out += ", \"color\": " + Rows(tertiary.Color);
  }
  return out + "}";
}

namespace
{
//------------------------------------------------------------------------------
std::string Region(const vtkTFCRegionState& region)
{
  const char* next = ",\n     ";
  std::string out = "{\"id\": " + std::to_string(region.Id) + ", \"name\": " + Quoted(region.Name) +
    ", \"visible\": " + (region.Visible ? "true" : "false");
  out += next + ("\"shape\": " + Shape(region.Shape));
  out += next + std::string("\"falloff\": {\"type\": \"") +
    vtkTFCFalloffNames[static_cast<int>(region.Falloff)] +
    "\", \"width\": " + vtkTFCNumberText(region.Width) + "}";
  out += next + ("\"color\": " + Numbers(region.Color)) +
    ", \"opacity\": " + vtkTFCNumberText(region.Opacity);
  out += next + ("\"tertiary\": " + vtkTFCTertiaryText(region.Tertiary));
  return out + Extras(region.Extras, next) + "}";
}
}

//------------------------------------------------------------------------------
std::string vtkTFCWriteState(const vtkTFCState& state)
{
  std::string out = "{\"format\": \"transfer-function-combination\", \"version\": 1";
  out += ",\n \"primary\": " + Axis(state.Axes[0]);
  out += ",\n \"secondary\": " + Axis(state.Axes[1]);
  out += std::string(",\n \"blend\": \"") + vtkTFCBlendNames[static_cast<int>(state.Blend)] + "\"";
  out += Extras(state.Extras, ",\n ");
  out += ",\n \"regions\": [";
  for (size_t i = 0; i < state.Regions.size(); ++i)
  {
    out += (i > 0 ? ",\n    " : "\n    ") + Region(state.Regions[i]);
  }
  return out + "]}\n";
}
