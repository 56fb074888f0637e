// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCState.h"

#include "vtkTFCJsonFields.h"

#include <map>

namespace
{
using Json = vtkTFCJsonFields::Json;

//------------------------------------------------------------------------------
// Finds what a parser would only find after building the document, and nesting that would make any
// later recursion unsafe.
bool CheckText(const std::string& text, std::string& error)
{
  if (text.size() > vtkTFCLimits::Bytes)
  {
    error = "expected at most " + std::to_string(vtkTFCLimits::Bytes) + " bytes of JSON, got " +
      std::to_string(text.size());
    return false;
  }
  int depth = 0;
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i)
  {
    const char c = text[i];
    if (quoted)
    {
      i += (c == '\\') ? 1 : 0;
      quoted = (c != '"');
    }
    else if (c == '"')
    {
      quoted = true;
    }
    else if (c == '[' || c == '{')
    {
      if (++depth > vtkTFCLimits::Depth)
      {
        error = "expected JSON nested at most " + std::to_string(vtkTFCLimits::Depth) +
          " deep, got more at byte " + std::to_string(i + 1);
        return false;
      }
    }
    else if (c == ']' || c == '}')
    {
      --depth;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// The rules of the format, one method per object.
class Reader : private vtkTFCJsonFields
{
public:
  using vtkTFCJsonFields::vtkTFCJsonFields;

  bool ReadRoot(const Json& root, vtkTFCState& state);

private:
  bool ReadRange(const Json* value, const std::string& path, bool& hasRange,
    std::array<double, 2>& range);
  bool ReadAttribute(const Json& object, const std::string& path, vtkTFCAttribute& attribute,
    bool& hasRange, std::array<double, 2>& range);
  bool ReadAxis(const Json* value, const std::string& path, vtkTFCAxisState& axis);
  bool ReadShape(const Json* value, const std::string& path, vtkTFCShapeState& shape);
  bool ReadFalloff(const Json* value, const std::string& path, vtkTFCRegionState& region);
  bool ReadColor(const Json* value, const std::string& path, std::array<double, 3>& color);
  bool ReadTertiary(const Json* value, const std::string& path, vtkTFCTertiaryState& tertiary);
  bool ReadRegion(const Json& value, const std::string& path, vtkTFCRegionState& region);
};

//------------------------------------------------------------------------------
bool Reader::ReadRange(const Json* value, const std::string& path, bool& hasRange,
  std::array<double, 2>& range)
{
  hasRange = value && !value->is_null();
  if (!hasRange)
  {
    return true;
  }
  if (!this->ReadRow(value, path, range))
  {
    return false;
  }
  return range[0] < range[1] ||
    this->Fail(path,
      "expected [low, high] with low < high, got [" + vtkTFCNumberText(range[0]) + ", " +
        vtkTFCNumberText(range[1]) + "]");
}

//------------------------------------------------------------------------------
bool Reader::ReadAttribute(const Json& object, const std::string& path, vtkTFCAttribute& attribute,
  bool& hasRange, std::array<double, 2>& range)
{
  const Json* component = Find(object, "component");
  attribute.Component = 0;
  return this->ReadText(Find(object, "array"), path + ".array", false, attribute.Array) &&
    (!component ||
      this->ReadInteger(component, path + ".component", -1, vtkTFCLimits::Component,
        "a component index (-1: vector magnitude)", attribute.Component)) &&
    this->ReadRange(Find(object, "range"), path + ".range", hasRange, range);
}

//------------------------------------------------------------------------------
bool Reader::ReadAxis(const Json* value, const std::string& path, vtkTFCAxisState& axis)
{
  axis = vtkTFCAxisState();
  if (!value || value->is_null())
  {
    return true;
  }
  if (!value->is_object())
  {
    return this->Fail(path, "an object with \"array\", or null", value);
  }
  axis.Set = true;
  return this->CheckKeys(*value, path, { "array", "component", "range" }, nullptr) &&
    this->ReadAttribute(*value, path, axis.Attribute, axis.HasRange, axis.Range);
}

//------------------------------------------------------------------------------
bool Reader::ReadShape(const Json* value, const std::string& path, vtkTFCShapeState& shape)
{
  if (!value || !value->is_object())
  {
    return this->Fail(path, "an object with \"type\"", value);
  }
  int type = 0;
  if (!this->ReadWord(Find(*value, "type"), path + ".type", vtkTFCShapeNames, type))
  {
    return false;
  }
  shape.Type = static_cast<vtkTFCShapeType>(type);
  if (shape.Type == vtkTFCShapeType::Ellipse || shape.Type == vtkTFCShapeType::Rectangle)
  {
    const char* size = shape.Type == vtkTFCShapeType::Ellipse ? "radii" : "halfsize";
    const Json* angle = Find(*value, "angle");
    if (!this->CheckKeys(*value, path, { "type", "center", size, "angle" }, nullptr) ||
      !this->ReadRow(Find(*value, "center"), path + ".center", shape.Center) ||
      !this->ReadRow(Find(*value, size), path + "." + size, shape.HalfSize) ||
      (angle && !this->ReadNumber(angle, path + ".angle", shape.Angle)))
    {
      return false;
    }
  }
  else if (!this->CheckKeys(*value, path, { "type", "points" }, nullptr) ||
    !this->ReadRows(Find(*value, "points"), path + ".points", vtkTFCLimits::Points, shape.Points))
  {
    return false;
  }
  std::string field;
  const std::string wrong = vtkTFCCheckShape(shape, &field);
  return wrong.empty() || this->Fail(path + "." + field, wrong);
}

//------------------------------------------------------------------------------
bool Reader::ReadFalloff(const Json* value, const std::string& path, vtkTFCRegionState& region)
{
  if (!value->is_object())
  {
    return this->Fail(path, "an object with \"type\" and \"width\"", value);
  }
  int type = 0;
  if (!this->CheckKeys(*value, path, { "type", "width" }, nullptr) ||
    !this->ReadWord(Find(*value, "type"), path + ".type", vtkTFCFalloffNames, type))
  {
    return false;
  }
  region.Falloff = static_cast<vtkTFCFalloffType>(type);
  const Json* width = Find(*value, "width");
  if (width && !(width->is_number() && width->get<double>() > 0 && width->get<double>() <= 1))
  {
    return this->Fail(path + ".width", "a number in (0, 1]", width);
  }
  region.Width = width ? width->get<double>() : region.Width;
  return true;
}

//------------------------------------------------------------------------------
bool Reader::ReadColor(const Json* value, const std::string& path, std::array<double, 3>& color)
{
  if (!value->is_array() || value->size() != color.size())
  {
    return this->Fail(path, "[red, green, blue]", value);
  }
  for (size_t i = 0; i < color.size(); ++i)
  {
    if (!this->ReadFraction(&(*value)[i], path + "[" + std::to_string(i) + "]", color[i]))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool Reader::ReadTertiary(const Json* value, const std::string& path, vtkTFCTertiaryState& tertiary)
{
  if (!value || value->is_null())
  {
    return true;
  }
  if (!value->is_object())
  {
    return this->Fail(path, "an object with \"array\" and \"opacity\", or null", value);
  }
  tertiary.Set = true;
  const Json* color = Find(*value, "color");
  const bool hasColor = color && !color->is_null();
  if (!this->CheckKeys(*value, path, { "array", "component", "range", "opacity", "color" },
        nullptr) ||
    !this->ReadAttribute(*value, path, tertiary.Attribute, tertiary.HasRange, tertiary.Range) ||
    !this->ReadRows(Find(*value, "opacity"), path + ".opacity", vtkTFCLimits::Nodes,
      tertiary.Opacity) ||
    (hasColor && !this->ReadRows(color, path + ".color", vtkTFCLimits::Nodes, tertiary.Color)))
  {
    return false;
  }
  std::string field;
  std::string wrong = vtkTFCCheckNodes(tertiary.Opacity, &field);
  if (!wrong.empty())
  {
    return this->Fail(path + ".opacity" + field, wrong);
  }
  // An empty colour list means the same as none: the region's colour.
  wrong = tertiary.Color.empty() ? std::string() : vtkTFCCheckNodes(tertiary.Color, &field);
  return wrong.empty() || this->Fail(path + ".color" + field, wrong);
}

//------------------------------------------------------------------------------
bool Reader::ReadRegion(const Json& value, const std::string& path, vtkTFCRegionState& region)
{
  if (!value.is_object())
  {
    return this->Fail(path, "an object", &value);
  }
  if (!this->CheckKeys(value, path,
        { "id", "name", "visible", "shape", "falloff", "color", "opacity", "tertiary" },
        &region.Extras) ||
    !this->ReadInteger(Find(value, "id"), path + ".id", 1, vtkTFCLimits::Id,
      "an integer from 1 to 999999999", region.Id))
  {
    return false;
  }
  region.Name = "region " + std::to_string(region.Id);
  const Json* name = Find(value, "name");
  if (name && !this->ReadText(name, path + ".name", true, region.Name))
  {
    return false;
  }
  if (const Json* visible = Find(value, "visible"))
  {
    if (!visible->is_boolean())
    {
      return this->Fail(path + ".visible", "true or false", visible);
    }
    region.Visible = visible->get<bool>();
  }
  const Json* falloff = Find(value, "falloff");
  const Json* color = Find(value, "color");
  const Json* opacity = Find(value, "opacity");
  return (!falloff || this->ReadFalloff(falloff, path + ".falloff", region)) &&
    (!color || this->ReadColor(color, path + ".color", region.Color)) &&
    (!opacity || this->ReadFraction(opacity, path + ".opacity", region.Opacity)) &&
    this->ReadShape(Find(value, "shape"), path + ".shape", region.Shape) &&
    this->ReadTertiary(Find(value, "tertiary"), path + ".tertiary", region.Tertiary);
}

//------------------------------------------------------------------------------
bool Reader::ReadRoot(const Json& root, vtkTFCState& state)
{
  if (!root.is_object())
  {
    return this->Fail("", "an object", &root);
  }
  const Json* format = Find(root, "format");
  if (!format || *format != "transfer-function-combination")
  {
    return this->Fail("format", "\"transfer-function-combination\"", format);
  }
  // The version before the keys: a newer file may well have keys that this reader does not know.
  int version = 0;
  if (!this->ReadInteger(Find(root, "version"), "version", 1, vtkTFCLimits::Id,
        "a version number from 1", version))
  {
    return false;
  }
  if (version > 1)
  {
    return this->Fail("version",
      "version " + std::to_string(version) + " is newer than this plugin reads (1)");
  }
  if (!this->CheckKeys(root, "",
        { "format", "version", "primary", "secondary", "blend", "regions" }, &state.Extras) ||
    !this->ReadAxis(Find(root, "primary"), "primary", state.Axes[0]) ||
    !this->ReadAxis(Find(root, "secondary"), "secondary", state.Axes[1]))
  {
    return false;
  }
  if (const Json* blend = Find(root, "blend"))
  {
    int type = 0;
    if (!this->ReadWord(blend, "blend", vtkTFCBlendNames, type))
    {
      return false;
    }
    state.Blend = static_cast<vtkTFCBlendType>(type);
  }
  const Json* regions = Find(root, "regions");
  if (!regions)
  {
    return true;
  }
  if (!regions->is_array() || regions->size() > vtkTFCLimits::Regions)
  {
    return this->Fail("regions",
      "a list of at most " + std::to_string(vtkTFCLimits::Regions) + " regions", regions);
  }
  state.Regions.resize(regions->size());
  std::map<int, size_t> ids;
  for (size_t i = 0; i < state.Regions.size(); ++i)
  {
    const std::string path = "regions[" + std::to_string(i) + "]";
    if (!this->ReadRegion((*regions)[i], path, state.Regions[i]))
    {
      return false;
    }
    const auto added = ids.emplace(state.Regions[i].Id, i);
    if (!added.second)
    {
      return this->Fail(path + ".id",
        "expected an id of its own, got " + std::to_string(state.Regions[i].Id) +
          ", which regions[" + std::to_string(added.first->second) + "] has");
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool vtkTFCReadState(const std::string& text, vtkTFCState& state, std::string& error)
{
  state = vtkTFCState();
  error.clear();
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
  {
    return true;
  }
  if (!CheckText(text, error))
  {
    error = "state: " + error;
    return false;
  }
  try
  {
    if (!Reader(error).ReadRoot(Json::parse(text), state))
    {
      return false;
    }
  }
  catch (const Json::exception& problem)
  {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: ..." without its tag.
    const std::string what = problem.what();
    const size_t tag = what.find("] ");
    error = "state: expected valid JSON, got a " +
      vtkTFCJsonFields::Printable(tag == std::string::npos ? what : what.substr(tag + 2), 200);
    return false;
  }
  // What is written must be readable too; canonical text can be longer than what was given.
  const size_t size = vtkTFCWriteState(state).size();
  if (size > vtkTFCLimits::Bytes)
  {
    error = "state: expected at most " + std::to_string(vtkTFCLimits::Bytes) +
      " bytes in canonical form, got " + std::to_string(size);
    return false;
  }
  return true;
}
