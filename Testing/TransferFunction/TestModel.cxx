// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The model as an object: state round trip, equal states, ids, modification times, setters, ranges.
#include "ModelTesting.h"

#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkTFCEllipseShape.h"
#include "vtkTFCPolygonShape.h"
#include "vtkTFCRectangleShape.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTriangleShape.h"

#include <clocale>
#include <cmath>

using namespace ModelTesting;

namespace
{
const char* const Full = R"({"format": "transfer-function-combination", "version": 1,
  "x-note": {"by": ["me", 1.5, null]},
  "primary": {"array": "P", "component": 0, "range": [900, 1010]},
  "secondary": {"array": "T\u00e9", "component": -1, "range": null},
  "blend": "over",
  "regions": [
    {"id": 4, "name": "eye \"core\"", "visible": true,
     "shape": {"type": "ellipse", "center": [930, 20], "radii": [12, 4], "angle": 12.5},
     "falloff": {"type": "gaussian", "width": 0.5}, "color": [0.84, 0.15, 0.16], "opacity": 0.6,
     "tertiary": {"array": "QVAPOR", "component": 2, "range": [0, 20],
                  "opacity": [[0, 0], [8, 0], [8, 1], [20, 1]], "color": [[0, 0, 0, 0], [1, 1, 1, 1]]}},
    {"id": 2, "shape": {"type": "rectangle", "center": [0.1, 1e-300], "halfsize": [1e300, 5e-324]}, "x-a": true},
    {"id": 7, "visible": false, "shape": {"type": "triangle", "points": [[0, 0], [1, 0.1], [0.3, 3]]}},
    {"id": 1, "shape": {"type": "polygon", "points": [[0, 0], [1, 0], [1, 1], [0.1, 2], [0, 1]]}, "tertiary": null}]})";

std::string Ellipse(int id, const std::string& extra = "")
{
  return R"({"id": )" + std::to_string(id) +
    R"(, "shape": {"type": "ellipse", "center": [5, 0], "radii": [1, 1]})" + extra + "}";
}
}

TEST(State, RoundTripIsCanonicalAndExact)
{
  vtkNew<vtkTFCTransferFunction> one;
  ASSERT_TRUE(one->SetState(Full)) << one->GetLastError();
  const std::string text = one->GetState();
  vtkNew<vtkTFCTransferFunction> two;
  ASSERT_TRUE(two->SetState(text.c_str())) << two->GetLastError();
  EXPECT_EQ(two->GetState(), text);
  EXPECT_NE(text.find("5e-324"), std::string::npos);
  EXPECT_NE(text.find(R"("x-note": {"by":["me",1.5,null]})"), std::string::npos);
  EXPECT_NE(text.find(R"("x-a": true)"), std::string::npos);
  EXPECT_NE(text.find(R"("range": null)"), std::string::npos);
  EXPECT_EQ(one->GetAxisArray(vtkTFCTransferFunction::Secondary), "T\xc3\xa9");
}

TEST(State, DoublesSurviveExactly)
{
  const double values[] = { 0.1, 1.0 / 3, 1e22, 123456789.123456789, 4.9e-324, -2.5e-17 };
  for (const double value : values)
  {
    vtkNew<vtkTFCTransferFunction> one;
    vtkTFCRegion* region = one->AddNewRegion("ellipse");
    vtkTFCEllipseShape::SafeDownCast(region->GetShape())->SetCenter(value, -value);
    vtkNew<vtkTFCTransferFunction> two;
    ASSERT_TRUE(two->SetState(one->GetState().c_str())) << two->GetLastError();
    double center[2];
    vtkTFCEllipseShape::SafeDownCast(two->GetRegion(0)->GetShape())->GetCenter(center);
    EXPECT_EQ(center[0], value);
    EXPECT_EQ(center[1], -value);
  }
}

TEST(State, DoesNotDependOnTheLocale)
{
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(Full));
  const std::string text = model->GetState();
  // Not every machine has it; then this checks nothing.
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  vtkNew<vtkTFCTransferFunction> other;
  EXPECT_TRUE(other->SetState(text.c_str())) << other->GetLastError();
  EXPECT_EQ(other->GetState(), text);
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(State, EmptyTextIsAnEmptyModel)
{
  for (const char* text : { "", " \n", static_cast<const char*>(nullptr) })
  {
    vtkNew<vtkTFCTransferFunction> model;
    ASSERT_TRUE(model->SetState(Full));
    ASSERT_TRUE(model->SetState(text));
    EXPECT_EQ(model->GetNumberOfRegions(), 0);
    EXPECT_FALSE(model->HasAxes());
    vtkNew<vtkTFCTransferFunction> fresh;
    EXPECT_EQ(model->GetState(), fresh->GetState());
    EXPECT_TRUE(fresh->SetState(model->GetState().c_str()));
  }
}

TEST(State, EqualStateChangesNothing)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(Full));
  const auto time = model->GetMTime();
  ASSERT_TRUE(model->SetState(Full));
  ASSERT_TRUE(model->SetState(model->GetState().c_str()));
  EXPECT_EQ(model->GetMTime(), time);
}

TEST(State, DefaultsAreTheDocumentedOnes)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(State(Ellipse(12)).c_str()));
  vtkTFCRegion* region = model->GetRegion(0);
  double color[3];
  region->GetColor(color);
  EXPECT_EQ(region->GetName(), "region 12");
  EXPECT_TRUE(region->GetVisible());
  EXPECT_EQ(region->GetFalloffType(), vtkTFCRegion::Smooth);
  EXPECT_EQ(region->GetFalloffWidth(), 0.25);
  EXPECT_EQ(color[0] + color[1] + color[2], 3);
  EXPECT_EQ(region->GetOpacity(), 1);
  EXPECT_FALSE(region->HasTertiary());
  EXPECT_EQ(vtkTFCEllipseShape::SafeDownCast(region->GetShape())->GetAngle(), 0);
  EXPECT_EQ(model->GetBlend(), vtkTFCTransferFunction::Mix);
}

TEST(State, ErrorKeepsThePreviousState)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(Full));
  const std::string text = model->GetState();
  const auto time = model->GetMTime();
  Catcher catcher(model);
  EXPECT_FALSE(model->SetState(State(Ellipse(1) + "," + Ellipse(1)).c_str()));
  EXPECT_NE(catcher.Errors.find("regions[1].id"), std::string::npos);
  EXPECT_EQ(model->GetState(), text);
  EXPECT_EQ(model->GetMTime(), time);
  EXPECT_TRUE(model->SetState(Full));
  EXPECT_TRUE(model->GetLastError().empty());
}

TEST(Regions, AreUpdatedInPlace)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(State(Ellipse(1) + "," + Ellipse(2)).c_str()));
  vtkTFCRegion* one = model->GetRegionById(1);
  vtkTFCRegion* two = model->GetRegionById(2);
  vtkTFCShape* shape = two->GetShape();
  const auto oneTime = one->GetMTime();
  ASSERT_TRUE(model->SetState(State(Ellipse(2, R"(, "opacity": 0.5)") + "," + Ellipse(1)).c_str()));
  EXPECT_EQ(model->GetRegion(0), two);
  EXPECT_EQ(model->GetRegion(1), one);
  EXPECT_EQ(two->GetShape(), shape);
  EXPECT_EQ(two->GetOpacity(), 0.5);
  EXPECT_EQ(one->GetMTime(), oneTime);
  // Another type of shape: the region stays, its shape cannot.
  ASSERT_TRUE(model->SetState(
    State(R"({"id": 2, "shape": {"type": "triangle", "points": [[0, 0], [1, 0], [0, 1]]}})")
      .c_str()));
  EXPECT_EQ(model->GetRegion(0), two);
  EXPECT_NE(vtkTFCTriangleShape::SafeDownCast(two->GetShape()), nullptr);
}

TEST(Regions, IdsAreNeverReused)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(State(Ellipse(3) + "," + Ellipse(8)).c_str()));
  vtkNew<vtkTFCRegion> region;
  EXPECT_EQ(model->AddRegion(region), 9);
  EXPECT_EQ(region->GetName(), "region 9");
  model->RemoveRegion(region);
  model->RemoveRegion(model->GetRegionById(8));
  EXPECT_EQ(model->AddNewRegion("polygon")->GetId(), 10);
  model->RemoveAllRegions();
  EXPECT_EQ(model->AddNewRegion("triangle")->GetId(), 11);
  ASSERT_TRUE(model->SetState(State(Ellipse(999999999)).c_str()));
  EXPECT_EQ(model->AddNewRegion("rectangle")->GetId(), 1) << "after the last id, a free one";
}

TEST(Regions, CannotBeAddedTwice)
{
  vtkNew<vtkTFCTransferFunction> model;
  vtkNew<vtkTFCRegion> region;
  Catcher catcher(model);
  EXPECT_EQ(model->AddRegion(region), 1);
  EXPECT_EQ(model->AddRegion(region), 0);
  EXPECT_EQ(model->AddRegion(nullptr), 0);
  EXPECT_EQ(model->AddNewRegion("circle"), nullptr);
  EXPECT_NE(catcher.Errors.find("got circle"), std::string::npos);
  EXPECT_EQ(model->GetNumberOfRegions(), 1);
}

TEST(Regions, Move)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(State(Ellipse(1) + "," + Ellipse(2) + "," + Ellipse(3)).c_str()));
  const auto order = [&]()
  {
    return 100 * model->GetRegion(0)->GetId() + 10 * model->GetRegion(1)->GetId() +
      model->GetRegion(2)->GetId();
  };
  model->MoveRegion(0, 2);
  EXPECT_EQ(order(), 231);
  model->MoveRegion(2, 1);
  EXPECT_EQ(order(), 213);
  const auto time = model->GetMTime();
  model->MoveRegion(1, 1);
  model->MoveRegion(0, 3);
  EXPECT_EQ(model->GetMTime(), time);
}

TEST(MTime, CoversRegionsAndShapes)
{
  vtkNew<vtkTFCTransferFunction> model;
  vtkTFCRegion* region = model->AddNewRegion("ellipse");
  auto time = model->GetMTime();
  const auto changed = [&]()
  {
    const bool result = model->GetMTime() > time;
    time = model->GetMTime();
    return result;
  };
  auto* ellipse = vtkTFCEllipseShape::SafeDownCast(region->GetShape());
  ellipse->SetRadii(2, 3);
  EXPECT_TRUE(changed());
  ellipse->SetRadii(2, 3);
  EXPECT_FALSE(changed());
  region->SetColor(0, 0.5, 1);
  EXPECT_TRUE(changed());
  region->SetColor(0, 0.5, 1);
  EXPECT_FALSE(changed());
  model->SetAxis(vtkTFCTransferFunction::Primary, "P");
  EXPECT_TRUE(changed());
  model->SetAxisRange(vtkTFCTransferFunction::Primary, 0, 5);
  EXPECT_TRUE(changed());
  model->SetAxisRange(vtkTFCTransferFunction::Primary, 0, 5);
  EXPECT_FALSE(changed());
  model->Compile();
  EXPECT_FALSE(changed());
}

TEST(Setters, RefuseWhatAStateMayNotHold)
{
  vtkNew<vtkTFCTransferFunction> model;
  vtkTFCRegion* region = model->AddNewRegion("ellipse");
  model->SetAxis(0, "P");
  vtkTFCShape* shape = region->GetShape();
  auto* ellipse = vtkTFCEllipseShape::SafeDownCast(shape);
  const std::string before = model->GetState();
  Catcher shapeErrors(shape);
  Catcher regionErrors(region);
  Catcher modelErrors(model);
  ellipse->SetRadii(0, 1);
  EXPECT_NE(shapeErrors.Errors.find("radii[0]: expected a number > 0, got 0"), std::string::npos);
  ellipse->SetCenter(std::nan(""), 1);
  ellipse->SetAngle(HUGE_VAL);
  region->SetOpacity(1.5);
  region->SetColor(0, -0.1, 0);
  region->SetFalloff(vtkTFCRegion::Linear, 0);
  region->SetFalloff(4, 0.5);
  region->SetShape(nullptr);
  region->SetTertiaryRange(1, 1);
  vtkNew<vtkDoubleArray> nodes;
  EXPECT_FALSE(region->SetTertiary("T", 0, nodes));
  nodes->SetNumberOfComponents(2);
  EXPECT_FALSE(region->SetTertiary("T", 0, nodes));
  nodes->InsertNextTuple2(1, 0);
  nodes->InsertNextTuple2(0, 1);
  EXPECT_FALSE(region->SetTertiary("T", 0, nodes));
  EXPECT_NE(regionErrors.Errors.find("tertiary.opacity[1][0]"), std::string::npos);
  model->SetAxisRange(0, 2, 1);
  model->SetAxisRange(1, 0, 1);
  model->SetAxisRange(2, 0, 1);
  model->SetAxis(0, "P", -2);
  model->SetBlend(2);
  EXPECT_EQ(model->GetState(), before);

  vtkNew<vtkTFCPolygonShape> polygon;
  Catcher polygonErrors(polygon);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 1, 0);
  EXPECT_FALSE(polygon->SetPoints(points));
  points->InsertNextPoint(2, 2, 0);
  EXPECT_FALSE(polygon->SetPoints(points));
  EXPECT_EQ(polygon->GetNumberOfPoints(), 3);
  vtkNew<vtkTFCTriangleShape> triangle;
  Catcher triangleErrors(triangle);
  triangle->SetPoints(0, 0, 1, 2, 2, 4);
  double point[2];
  triangle->GetPoint(1, point);
  EXPECT_EQ(point[0], 1);
  EXPECT_EQ(point[1], 0);
  triangle->GetPoint(-1, point);
  triangle->GetPoint(3, point);
}

TEST(Setters, TertiaryRoundTrip)
{
  vtkNew<vtkTFCTransferFunction> model;
  vtkTFCRegion* region = model->AddNewRegion("rectangle");
  vtkNew<vtkDoubleArray> nodes;
  nodes->SetNumberOfComponents(2);
  nodes->InsertNextTuple2(0, 0.5);
  nodes->InsertNextTuple2(1, 1);
  vtkNew<vtkDoubleArray> colors;
  colors->SetNumberOfComponents(4);
  colors->InsertNextTuple4(0, 1, 0.5, 0.25);
  ASSERT_TRUE(region->SetTertiary("T", 2, nodes, colors));
  region->SetTertiaryRange(-1, 2);
  vtkNew<vtkTFCTransferFunction> copy;
  ASSERT_TRUE(copy->SetState(model->GetState().c_str())) << copy->GetLastError();
  vtkTFCRegion* other = copy->GetRegion(0);
  vtkNew<vtkDoubleArray> read;
  other->GetTertiaryColorNodes(read);
  double range[2];
  EXPECT_EQ(read->GetComponent(0, 2), 0.5);
  other->GetTertiaryOpacityNodes(read);
  EXPECT_EQ(read->GetNumberOfTuples(), 2);
  EXPECT_TRUE(other->GetTertiaryRange(range));
  EXPECT_EQ(range[0], -1);
  EXPECT_EQ(other->GetTertiaryArray(), "T");
  EXPECT_EQ(other->GetTertiaryComponent(), 2);
  other->RemoveTertiary();
  EXPECT_FALSE(other->HasTertiary());
}

TEST(Ranges, AutomaticOnesComeFromTheData)
{
  vtkNew<vtkTFCTransferFunction> model;
  model->SetAxis(0, "P");
  model->SetAxis(1, "S");
  model->SetAxisRange(1, -3, 3);
  const auto time = model->GetMTime();
  const double data[2] = { 10, 20 };
  double used[4];
  model->ResolveRanges(data, data, used);
  EXPECT_EQ(used[0], 10);
  EXPECT_EQ(used[1], 20);
  EXPECT_EQ(used[2], -3);
  EXPECT_EQ(used[3], 3);
  EXPECT_EQ(model->GetMTime(), time);
  EXPECT_FALSE(model->HasAxisRange(0));
  const double constant[2] = { -8, -8 };
  model->ResolveRanges(constant, nullptr, used);
  EXPECT_EQ(used[0], -12);
  EXPECT_EQ(used[1], -4);
  for (const auto& nothing :
    { std::array<double, 2>{ HUGE_VAL, -HUGE_VAL }, { std::nan(""), 1.0 }, { 2.0, 1.0 } })
  {
    model->ResolveRanges(nothing.data(), nullptr, used);
    EXPECT_EQ(used[0], 0);
    EXPECT_EQ(used[1], 1);
  }
}

TEST(Ranges, PolygonFollowsTheAxes)
{
  // The same outline under other axes is another one in axis units: nothing stale is reused.
  vtkNew<vtkTFCTransferFunction> model;
  model->AddNewRegion("polygon");
  const double narrow[4] = { 0, 1, 0, 1 };
  const double wide[4] = { 0, 10, 0, 10 };
  const double e = model->Compile(narrow).Regions[0].MaximumEdgeDistance;
  EXPECT_EQ(model->Compile(narrow).Regions[0].MaximumEdgeDistance, e);
  EXPECT_NEAR(model->Compile(wide).Regions[0].MaximumEdgeDistance, e / 10, 1e-9);
}

TEST(Objects, PrintThemselves)
{
  vtkNew<vtkTFCTransferFunction> model;
  ASSERT_TRUE(model->SetState(Full));
  std::ostringstream out;
  model->Print(out);
  for (int i = 0; i < model->GetNumberOfRegions(); ++i)
  {
    model->GetRegion(i)->Print(out);
  }
  EXPECT_NE(out.str().find("eye"), std::string::npos);
}
