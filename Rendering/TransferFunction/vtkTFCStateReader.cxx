// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCState.h"

#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
using Json = nlohmann::json;

//------------------------------------------------------------------------------
// Text of unknown origin, fit for a one-line message: short and printable.
std::string Printable(const std::string& text, size_t limit = 60)
{
  std::string out;
  for (const char c : text.substr(0, limit))
  {
    out += (c >= 0x20 && c < 0x7f) ? c : '?';
  }
  return text.size() > limit ? out + "..." : out;
}

//------------------------------------------------------------------------------
std::string Describe(const Json* value)
{
  if (!value)
  {
    return "nothing";
  }
  switch (value->type())
  {
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "a list of " + std::to_string(value->size());
    case Json::value_t::string:
      return "\"" + Printable(value->get_ref<const std::string&>()) + "\"";
    default:
      return value->dump();
  }
}

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
// Each Read...() returns false after setting the error of the first field that is wrong. `path` is
// the path of the field itself.
class Reader
{
public:
  explicit Reader(std::string& error)
    : Error(error)
  {
  }

  bool ReadRoot(const Json& root, vtkTFCState& state);

private:
  bool Fail(const std::string& path, const std::string& expected, const Json* got)
  {
    return this->Fail(path, "expected " + expected + ", got " + Describe(got));
  }
  bool Fail(const std::string& path, const std::string& message)
  {
    this->Error = (path.empty() ? std::string("state") : path) + ": " + message;
    return false;
  }

  static const Json* Find(const Json& object, const char* key)
  {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }

  bool CheckKeys(const Json& object, const std::string& path, const std::set<std::string>& known,
    vtkTFCExtras* extras);
  bool ReadNumber(const Json* value, const std::string& path, double& out);
  bool ReadFraction(const Json* value, const std::string& path, double& out);
  bool ReadInteger(const Json* value, const std::string& path, int low, int high,
    const char* expected, int& out);
  bool ReadText(const Json* value, const std::string& path, bool emptyAllowed, std::string& out);
  template <size_t N>
  bool ReadWord(const Json* value, const std::string& path, const std::array<const char*, N>& words,
    int& out);
  template <size_t N>
  bool ReadRow(const Json* value, const std::string& path, std::array<double, N>& out);
  template <size_t N>
  bool ReadRows(const Json* value, const std::string& path, size_t limit,
    std::vector<std::array<double, N>>& out);
  bool ReadRange(const Json* value, const std::string& path, bool& hasRange,
    std::array<double, 2>& range);
  bool ReadAttribute(const Json& object, const std::string& path, vtkTFCAttribute& attribute,
    bool& hasRange, std::array<double, 2>& range);
  bool ReadAxis(const Json* value, const std::string& path, vtkTFCAxisState& axis);
  bool ReadShape(const Json* value, const std::string& path, vtkTFCShapeState& shape);
  bool ReadTertiary(const Json* value, const std::string& path, vtkTFCTertiaryState& tertiary);
  bool ReadRegion(const Json& value, const std::string& path, vtkTFCRegionState& region);

  std::string& Error;
};

//------------------------------------------------------------------------------
bool Reader::CheckKeys(const Json& object, const std::string& path,
  const std::set<std::string>& known, vtkTFCExtras* extras)
{
  for (const auto& item : object.items())
  {
    if (known.count(item.key()))
    {
      continue;
    }
    if (extras && item.key().compare(0, 2, "x-") == 0)
    {
      (*extras)[item.key()] = item.value().dump();
      continue;
    }
    std::string list;
    for (const std::string& key : known)
    {
      list += (list.empty() ? "" : ", ") + key;
    }
    return this->Fail((path.empty() ? "" : path + ".") + Printable(item.key()),
      "unknown key; expected one of " + list + (extras ? ", or a key that starts with x-" : ""));
  }
  return true;
}

//------------------------------------------------------------------------------
bool Reader::ReadNumber(const Json* value, const std::string& path, double& out)
{
  if (!value || !value->is_number() || !vtkTFCIsNumber(value->get<double>()))
  {
    return this->Fail(path, "a number", value);
  }
  out = value->get<double>();
  return true;
}

//------------------------------------------------------------------------------
bool Reader::ReadFraction(const Json* value, const std::string& path, double& out)
{
  if (!value || !value->is_number() || !(value->get<double>() >= 0 && value->get<double>() <= 1))
  {
    return this->Fail(path, "a number in [0, 1]", value);
  }
  out = value->get<double>();
  return true;
}

//------------------------------------------------------------------------------
bool Reader::ReadInteger(const Json* value, const std::string& path, int low, int high,
  const char* expected, int& out)
{
  // Through double: "1.0" is an integer too (other writers), and no conversion can overflow.
  const double number = value && value->is_number() ? value->get<double>() : std::nan("");
  if (!(number >= low && number <= high && number == std::floor(number)))
  {
    return this->Fail(path, expected, value);
  }
  out = static_cast<int>(number);
  return true;
}

//------------------------------------------------------------------------------
bool Reader::ReadText(const Json* value, const std::string& path, bool emptyAllowed,
  std::string& out)
{
  const char* expected = emptyAllowed ? "a text" : "a non-empty text";
  if (!value || !value->is_string())
  {
    return this->Fail(path, expected, value);
  }
  out = value->get_ref<const std::string&>();
  if (out.find('\0') != std::string::npos)
  {
    return this->Fail(path, "a text without null characters", value);
  }
  return (emptyAllowed || !out.empty()) || this->Fail(path, expected, value);
}

//------------------------------------------------------------------------------
template <size_t N>
bool Reader::ReadWord(const Json* value, const std::string& path,
  const std::array<const char*, N>& words, int& out)
{
  std::string list;
  for (size_t i = 0; i < N; ++i)
  {
    if (value && value->is_string() && value->get_ref<const std::string&>() == words[i])
    {
      out = static_cast<int>(i);
      return true;
    }
    list += std::string(i == 0 ? "" : ", ") + words[i];
  }
  return this->Fail(path, "one of " + list, value);
}

//------------------------------------------------------------------------------
template <size_t N>
bool Reader::ReadRow(const Json* value, const std::string& path, std::array<double, N>& out)
{
  if (!value || !value->is_array() || value->size() != N)
  {
    return this->Fail(path, "a list of " + std::to_string(N) + " numbers", value);
  }
  for (size_t i = 0; i < N; ++i)
  {
    if (!this->ReadNumber(&(*value)[i], path + "[" + std::to_string(i) + "]", out[i]))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
template <size_t N>
bool Reader::ReadRows(const Json* value, const std::string& path, size_t limit,
  std::vector<std::array<double, N>>& out)
{
  if (!value || !value->is_array() || value->size() > limit)
  {
    return this->Fail(path,
      "a list of at most " + std::to_string(limit) + " lists of " + std::to_string(N) + " numbers",
      value);
  }
  out.resize(value->size());
  for (size_t i = 0; i < out.size(); ++i)
  {
    if (!this->ReadRow(&(*value)[i], path + "[" + std::to_string(i) + "]", out[i]))
    {
      return false;
    }
  }
  return true;
}

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
  if (const Json* falloff = Find(value, "falloff"))
  {
    const std::string here = path + ".falloff";
    if (!falloff->is_object())
    {
      return this->Fail(here, "an object with \"type\" and \"width\"", falloff);
    }
    int type = static_cast<int>(region.Falloff);
    if (!this->CheckKeys(*falloff, here, { "type", "width" }, nullptr) ||
      !this->ReadWord(Find(*falloff, "type"), here + ".type", vtkTFCFalloffNames, type))
    {
      return false;
    }
    region.Falloff = static_cast<vtkTFCFalloffType>(type);
    const Json* width = Find(*falloff, "width");
    if (width && !(width->is_number() && width->get<double>() > 0 && width->get<double>() <= 1))
    {
      return this->Fail(here + ".width", "a number in (0, 1]", width);
    }
    region.Width = width ? width->get<double>() : region.Width;
  }
  if (const Json* color = Find(value, "color"))
  {
    if (!color->is_array() || color->size() != 3)
    {
      return this->Fail(path + ".color", "[red, green, blue]", color);
    }
    for (size_t i = 0; i < 3; ++i)
    {
      if (!this->ReadFraction(&(*color)[i], path + ".color[" + std::to_string(i) + "]",
            region.Color[i]))
      {
        return false;
      }
    }
  }
  const Json* opacity = Find(value, "opacity");
  return (!opacity || this->ReadFraction(opacity, path + ".opacity", region.Opacity)) &&
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
      Printable(tag == std::string::npos ? what : what.substr(tag + 2), 200);
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
