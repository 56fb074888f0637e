// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Every way in which a state can be wrong, with the message that a user gets.
#include "ModelTesting.h"

#include <chrono>

using namespace ModelTesting;

namespace
{
struct Case
{
  std::string Text;
  std::string Message;
};

// The default region, with some key replaced or added.
std::string Region(const std::string& fields, const std::string& id = "1")
{
  const bool hasShape = fields.find("\"shape\"") != std::string::npos;
  return "{\"id\": " + id + ", " + fields +
    (hasShape ? "}" : R"(, "shape": {"type": "ellipse", "center": [0, 0], "radii": [1, 1]}})");
}

std::string InRegion(const std::string& fields)
{
  return State(Region(fields));
}

std::string Shape(const std::string& shape)
{
  return InRegion("\"shape\": " + shape);
}

std::string Tertiary(const std::string& fields)
{
  return InRegion("\"tertiary\": {" + fields + "}");
}

std::string Root(const std::string& fields)
{
  return R"({"format": "transfer-function-combination", "version": 1, )" + fields + "}";
}

void Check(const std::vector<Case>& cases)
{
  for (const Case& c : cases)
  {
    vtkNew<vtkTFCTransferFunction> model;
    Catcher catcher(model);
    EXPECT_FALSE(model->SetState(c.Text.c_str())) << c.Text;
    EXPECT_NE(model->GetLastError().find(c.Message), std::string::npos)
      << c.Text << "\n  gave:     " << model->GetLastError() << "\n  expected: " << c.Message;
    EXPECT_NE(catcher.Errors.find(c.Message), std::string::npos);
    EXPECT_EQ(model->GetNumberOfRegions(), 0);
    for (const char letter : model->GetLastError())
    {
      EXPECT_TRUE(letter >= 0x20 && letter < 0x7f) << "not printable in: " << model->GetLastError();
    }
  }
}
}

TEST(StateErrors, Document)
{
  Check({
    { "{", "state: expected valid JSON, got a parse error at line 1, column 2" },
    { "not json", "state: expected valid JSON, got a parse error at line 1" },
    { "[]", "state: expected an object, got a list of 0" },
    { "3", "state: expected an object, got 3" },
    { "{}", "format: expected \"transfer-function-combination\", got nothing" },
    { R"({"format": "other"})",
      "format: expected \"transfer-function-combination\", got \"other\"" },
    { R"({"format": "transfer-function-combination"})", "version: expected a version number" },
    { R"({"format": "transfer-function-combination", "version": "1"})", "version: expected" },
    { R"({"format": "transfer-function-combination", "version": 0})", "version: expected" },
    { R"({"format": "transfer-function-combination", "version": 2, "new": 1})",
      "version: version 2 is newer than this plugin reads (1)" },
    { Root(R"("primry": null)"), "primry: unknown key; expected one of blend, format, primary" },
    { Root(R"("blend": "add")"), "blend: expected one of mix, over, got \"add\"" },
    { Root(R"("blend": null)"), "blend: expected one of mix, over, got null" },
    { Root(R"("regions": {})"),
      "regions: expected a list of at most 10000 regions, got an object" },
    { Root(R"("regions": [3])"), "regions[0]: expected an object, got 3" },
  });
}

TEST(StateErrors, Axes)
{
  Check({
    { Root(R"("primary": "P")"), "primary: expected an object with \"array\", or null, got \"P\"" },
    { Root(R"("primary": {})"), "primary.array: expected a non-empty text, got nothing" },
    { Root(R"("primary": {"array": ""})"), "primary.array: expected a non-empty text, got \"\"" },
    { Root(R"("primary": {"array": "a\u0000b"})"), "primary.array: expected a text without null" },
    { Root(R"("secondary": {"array": 3})"), "secondary.array: expected a non-empty text, got 3" },
    { Root(R"("primary": {"array": "P", "component": 0.5})"),
      "primary.component: expected a component index (-1: vector magnitude), got 0.5" },
    { Root(R"("primary": {"array": "P", "component": -2})"), "primary.component: expected" },
    { Root(R"("primary": {"array": "P", "component": 1e99})"), "primary.component: expected" },
    { Root(R"("primary": {"array": "P", "component": null})"), "primary.component: expected" },
    { Root(R"("primary": {"array": "P", "range": [1, 1]})"),
      "primary.range: expected [low, high] with low < high, got [1, 1]" },
    { Root(R"("primary": {"array": "P", "range": [2, 1.5]})"), "got [2, 1.5]" },
    { Root(R"("primary": {"array": "P", "range": [2]})"),
      "primary.range: expected a list of 2 numbers, got a list of 1" },
    { Root(R"("primary": {"array": "P", "range": [0, "1"]})"),
      "primary.range[1]: expected a number, got \"1\"" },
    { Root(R"("primary": {"array": "P", "range": [0, 1e305]})"), "primary.range[1]: expected" },
    { Root(R"("primary": {"array": "P", "min": 0})"), "primary.min: unknown key" },
  });
}

TEST(StateErrors, Region)
{
  const std::string two = Region("\"name\": \"a\"") + "," + Region("\"name\": \"b\"");
  Check({
    { State("{}"), "regions[0].id: expected an integer from 1 to 999999999, got nothing" },
    { State(Region("\"name\": \"a\"", "0")), "regions[0].id: expected an integer from 1" },
    { State(Region("\"name\": \"a\"", "1.5")), "regions[0].id: expected an integer from 1" },
    { State(Region("\"name\": \"a\"", "99999999999")), "regions[0].id: expected" },
    { State(Region("\"name\": \"a\"", "true")), "regions[0].id: expected" },
    { State(two), "regions[1].id: expected an id of its own, got 1, which regions[0] has" },
    { State(R"({"id": 1})"), "regions[0].shape: expected an object with \"type\", got nothing" },
    { InRegion("\"name\": 3"), "regions[0].name: expected a text, got 3" },
    { InRegion("\"visible\": 1"), "regions[0].visible: expected true or false, got 1" },
    { InRegion("\"colour\": [0, 0, 0]"), "regions[0].colour: unknown key; expected one of color" },
    { InRegion("\"color\": \"red\""),
      "regions[0].color: expected [red, green, blue], got \"red\"" },
    { InRegion("\"color\": [0, 0]"), "regions[0].color: expected [red, green, blue]" },
    { InRegion("\"color\": [0, 0, 255]"),
      "regions[0].color[2]: expected a number in [0, 1], got 255" },
    { InRegion("\"opacity\": -0.1"), "regions[0].opacity: expected a number in [0, 1], got -0.1" },
    { InRegion("\"opacity\": null"), "regions[0].opacity: expected a number in [0, 1], got null" },
    { InRegion("\"falloff\": \"smooth\""), "regions[0].falloff: expected an object" },
    { InRegion("\"falloff\": {\"type\": \"box\"}"),
      "regions[0].falloff.type: expected one of constant, linear, smooth, gaussian, got \"box\"" },
    { InRegion("\"falloff\": {\"width\": 1}"), "regions[0].falloff.type: expected one of" },
    { InRegion("\"falloff\": {\"type\": \"linear\", \"width\": 0}"),
      "regions[0].falloff.width: expected a number in (0, 1], got 0" },
    { InRegion("\"falloff\": {\"type\": \"linear\", \"width\": 1.5}"), "falloff.width: expected" },
    { InRegion("\"falloff\": {\"type\": \"linear\", \"sigma\": 1}"), "falloff.sigma: unknown key" },
  });
}

TEST(StateErrors, Shape)
{
  const std::string third = Region("\"name\": \"a\"") + "," + Region("\"name\": \"b\"", "2") + "," +
    Region(R"("shape": {"type": "ellipse", "center": [0, 0], "radii": [-3, 1]})", "3");
  Check({
    { State(third), "regions[2].shape.radii[0]: expected a number > 0, got -3" },
    { Shape("3"), "regions[0].shape: expected an object with \"type\", got 3" },
    { Shape("{}"),
      "shape.type: expected one of ellipse, rectangle, triangle, polygon, got nothing" },
    { Shape(R"({"type": "circle"})"), "polygon, got \"circle\"" },
    { Shape(R"({"type": "ellipse", "radii": [1, 1]})"),
      "shape.center: expected a list of 2 numbers" },
    { Shape(R"({"type": "ellipse", "center": [0, 0]})"),
      "shape.radii: expected a list of 2 numbers" },
    { Shape(R"({"type": "ellipse", "center": [0, 0], "radii": [1, 0]})"),
      "shape.radii[1]: expected a number > 0, got 0" },
    { Shape(R"({"type": "ellipse", "center": [0, null], "radii": [1, 1]})"),
      "shape.center[1]: expected a number, got null" },
    { Shape(R"({"type": "ellipse", "center": [0, 0], "radii": [1, 1], "angle": "5"})"),
      "shape.angle: expected a number, got \"5\"" },
    { Shape(R"({"type": "ellipse", "center": [0, 0], "halfsize": [1, 1]})"),
      "shape.halfsize: unknown key; expected one of angle, center, radii, type" },
    { Shape(R"({"type": "rectangle", "center": [0, 0], "halfsize": [1, -1e-9]})"),
      "shape.halfsize[1]: expected a number > 0, got -1e-09" },
    { Shape(R"({"type": "triangle", "points": [[0, 0], [1, 0]]})"),
      "shape.points: expected 3 points, got 2" },
    { Shape(R"({"type": "triangle", "points": [[0, 0], [0.1, 0.1], [0.3, 0.3]]})"),
      "shape.points: expected points that enclose an area, got points on one line" },
    { Shape(R"({"type": "triangle", "points": [[0, 0], [0, 0], [0, 0]]})"), "on one line" },
    { Shape(R"({"type": "triangle", "points": [[0, 0], [1, 0], [0]]})"),
      "shape.points[2]: expected a list of 2 numbers, got a list of 1" },
    { Shape(R"({"type": "polygon", "points": []})"),
      "shape.points: expected 3 to 10000 points, got 0" },
    { Shape(R"({"type": "polygon", "points": [[0, 0], [1, 0], [3, 0], [4, 0]]})"), "on one line" },
    { Shape(R"({"type": "polygon", "points": [[0, 0], [1, 0], [1e301, 1]]})"),
      "shape.points[2][0]: expected a number, got 1e+301" },
    { Shape(R"({"type": "polygon", "center": [0, 0]})"), "shape.center: unknown key" },
  });
}

TEST(StateErrors, Tertiary)
{
  Check({
    { InRegion("\"tertiary\": \"T\""), "regions[0].tertiary: expected an object with \"array\"" },
    { Tertiary(R"("opacity": [[0, 1]])"),
      "tertiary.array: expected a non-empty text, got nothing" },
    { Tertiary(R"("array": "T")"), "tertiary.opacity: expected a list" },
    { Tertiary(R"("array": "T", "opacity": [])"),
      "tertiary.opacity: expected 1 to 10000 nodes, got 0" },
    { Tertiary(R"("array": "T", "opacity": [[0, 1, 2]])"),
      "tertiary.opacity[0]: expected a list of 2 numbers, got a list of 3" },
    { Tertiary(R"("array": "T", "opacity": [[0, 1.1]])"),
      "tertiary.opacity[0][1]: expected a number in [0, 1], got 1.1" },
    { Tertiary(R"("array": "T", "opacity": [[1, 1], [0, 0]])"),
      "tertiary.opacity[1][0]: expected values in increasing order, got 0 after 1" },
    { Tertiary(R"("array": "T", "opacity": [[1, 1], [1, 0], [1, 0.5]])"),
      "tertiary.opacity[2][0]: expected at most two nodes" },
    { Tertiary(R"("array": "T", "opacity": [[0, 1]], "color": [[0, 1, 1]])"),
      "tertiary.color[0]: expected a list of 4 numbers" },
    { Tertiary(R"("array": "T", "opacity": [[0, 1]], "color": [[0, 1, 1, -1]])"),
      "tertiary.color[0][3]: expected a number in [0, 1], got -1" },
    { Tertiary(R"("array": "T", "opacity": [[0, 1]], "range": [3, 2])"),
      "tertiary.range: expected" },
    { Tertiary(R"("array": "T", "opacity": [[0, 1]], "component": -3)"), "tertiary.component" },
    { Tertiary(R"("array": "T", "opacities": [[0, 1]])"), "tertiary.opacities: unknown key" },
  });
}

TEST(StateErrors, NumbersThatAreNone)
{
  Check({
    { InRegion("\"opacity\": NaN"), "state: expected valid JSON, got a parse error" },
    { InRegion("\"opacity\": Infinity"), "state: expected valid JSON" },
    { InRegion("\"opacity\": 1e999"), "number overflow parsing '1e999'" },
    { InRegion("\"opacity\": 0x1"), "state: expected valid JSON" },
  });
}

TEST(StateErrors, BytesThatAreNoText)
{
  Check({
    { InRegion("\"name\": \"\xff\xfe\""), "state: expected valid JSON" },
    { InRegion("\"name\": \"\xc3\""), "state: expected valid JSON" },
    { "\x01\x02\x03", "state: expected valid JSON" },
    { InRegion("\"\xc3\xa9t\xc3\xa9\": 1"), "regions[0].??t??: unknown key" },
  });
}

TEST(StateErrors, GarbageFailsFast)
{
  const size_t size = 10 * 1024 * 1024;
  const std::string deep(1024 * 1024, '[');
  std::string braces;
  for (int i = 0; i < 100000; ++i)
  {
    braces += "{\"x-a\":";
  }
  const std::vector<Case> cases = {
    { std::string(size, 'x'), "state: expected at most 8388608 bytes of JSON, got 10485760" },
    { std::string(size, '['), "state: expected at most 8388608 bytes of JSON" },
    { std::string(size / 2, 'x'), "state: expected valid JSON" },
    { deep, "state: expected JSON nested at most 32 deep, got more at byte 33" },
    { braces, "state: expected JSON nested at most 32 deep" },
    { Root("\"x-text\": \"" + std::string(size / 2, 'a')), "state: expected valid JSON" },
  };
  for (const Case& c : cases)
  {
    vtkNew<vtkTFCTransferFunction> model;
    Catcher catcher(model);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_FALSE(model->SetState(c.Text.c_str()));
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    // Tenths of a second; the bound leaves room for sanitizers on a busy machine.
    EXPECT_LT(time.count(), 20);
    EXPECT_NE(model->GetLastError().find(c.Message), std::string::npos) << model->GetLastError();
    EXPECT_LT(model->GetLastError().size(), 400u);
  }
}

TEST(StateErrors, ExtensionKeysAreKeptOnlyWhereDocumented)
{
  vtkNew<vtkTFCTransferFunction> model;
  EXPECT_TRUE(model->SetState(Root(R"("x-panel": {"zoom": 2})").c_str()));
  Check({ { Shape(R"({"type": "ellipse", "center": [0, 0], "radii": [1, 1], "x-a": 1})"),
    "regions[0].shape.x-a: unknown key" } });
}
