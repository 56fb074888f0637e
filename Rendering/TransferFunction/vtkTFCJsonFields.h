// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads fields of parsed JSON with errors that name the field. Private to the state reader.
 */

#ifndef vtkTFCJsonFields_h
#define vtkTFCJsonFields_h

#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

/**
 * Each Read...() returns false after setting the error of the first field that is wrong, as "path:
 * expected ..., got ...". `path` is the path of the field itself; a null `value` is a missing
 * field.
 */
class vtkTFCJsonFields
{
public:
  using Json = nlohmann::json;

  explicit vtkTFCJsonFields(std::string& error)
    : Error(error)
  {
  }

  /// Text of unknown origin, fit for a one-line message: short and printable.
  static std::string Printable(const std::string& text, size_t limit = 60);

  /// A field of an object, or null.
  static const Json* Find(const Json& object, const char* key)
  {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }

  bool Fail(const std::string& path, const std::string& expected, const Json* got);
  bool Fail(const std::string& path, const std::string& message);

  /// False when the object has a key that is not known. With `extras`, keys that start with "x-"
  /// are stored there as JSON text instead.
  bool CheckKeys(const Json& object, const std::string& path, const std::set<std::string>& known,
    std::map<std::string, std::string>* extras);

  /// A number of a magnitude that a state may hold.
  bool ReadNumber(const Json* value, const std::string& path, double& out);
  /// A number in [0, 1].
  bool ReadFraction(const Json* value, const std::string& path, double& out);
  /// An integer in [low, high]; `expected` is the words for the message.
  bool ReadInteger(const Json* value, const std::string& path, int low, int high,
    const char* expected, int& out);
  bool ReadText(const Json* value, const std::string& path, bool emptyAllowed, std::string& out);
  /// One of some words, as its index.
  template <size_t N>
  bool ReadWord(const Json* value, const std::string& path, const std::array<const char*, N>& words,
    int& out);
  /// A list of exactly N numbers.
  template <size_t N>
  bool ReadRow(const Json* value, const std::string& path, std::array<double, N>& out);
  /// A list of at most `limit` such lists.
  template <size_t N>
  bool ReadRows(const Json* value, const std::string& path, size_t limit,
    std::vector<std::array<double, N>>& out);

private:
  static std::string Describe(const Json* value);

  std::string& Error;
};

//------------------------------------------------------------------------------
template <size_t N>
bool vtkTFCJsonFields::ReadWord(const Json* value, const std::string& path,
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
bool vtkTFCJsonFields::ReadRow(const Json* value, const std::string& path,
  std::array<double, N>& out)
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
bool vtkTFCJsonFields::ReadRows(const Json* value, const std::string& path, size_t limit,
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

#endif
