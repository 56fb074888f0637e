// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCJsonFields.h"

#include "vtkTFCState.h"

#include <cmath>

//------------------------------------------------------------------------------
std::string vtkTFCJsonFields::Printable(const std::string& text, size_t limit)
{
  std::string out;
  for (const char c : text.substr(0, limit))
  {
    out += (c >= 0x20 && c < 0x7f) ? c : '?';
  }
  return text.size() > limit ? out + "..." : out;
}

//------------------------------------------------------------------------------
std::string vtkTFCJsonFields::Describe(const Json* value)
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
bool vtkTFCJsonFields::Fail(const std::string& path, const std::string& expected, const Json* got)
{
  return this->Fail(path, "expected " + expected + ", got " + Describe(got));
}

//------------------------------------------------------------------------------
bool vtkTFCJsonFields::Fail(const std::string& path, const std::string& message)
{
  this->Error = (path.empty() ? std::string("state") : path) + ": " + message;
  return false;
}

//------------------------------------------------------------------------------
bool vtkTFCJsonFields::CheckKeys(const Json& object, const std::string& path,
  const std::set<std::string>& known, std::map<std::string, std::string>* extras)
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
bool vtkTFCJsonFields::ReadNumber(const Json* value, const std::string& path, double& out)
{
  if (!value || !value->is_number() || !vtkTFCIsNumber(value->get<double>()))
  {
    return this->Fail(path, "a number", value);
  }
  out = value->get<double>();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCJsonFields::ReadFraction(const Json* value, const std::string& path, double& out)
{
  if (!value || !value->is_number() || !(value->get<double>() >= 0 && value->get<double>() <= 1))
  {
    return this->Fail(path, "a number in [0, 1]", value);
  }
  out = value->get<double>();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTFCJsonFields::ReadInteger(const Json* value, const std::string& path, int low, int high,
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
bool vtkTFCJsonFields::ReadText(const Json* value, const std::string& path, bool emptyAllowed,
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
