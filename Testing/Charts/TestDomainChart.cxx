// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Mouse and keys sent to the domain chart through an interactor, and what the model becomes.
#include "ChartScene.h"

#include "vtkCommand.h"
#include "vtkTFCEllipseShape.h"
#include "vtkTFCPolygonShape.h"
#include "vtkTFCTriangleShape.h"

#include <gtest/gtest.h>

using tfctest::BoxOf;
using tfctest::ChartScene;
using tfctest::ExpectOneEdit;

namespace
{
// A pixel is about a quarter of a unit of the first axis, and 0.005 of the second.
constexpr double X = 0.3;
constexpr double Y = 0.007;

void ExpectBox(vtkTFCRegion* region, double x, double y, double hx, double hy)
{
  const auto box = BoxOf(region);
  EXPECT_NEAR(box[0], x, X);
  EXPECT_NEAR(box[1], y, Y);
  EXPECT_NEAR(box[2], hx, X);
  EXPECT_NEAR(box[3], hy, Y);
}
}

TEST(DomainChart, DraggingWithAToolCreatesARegionThere)
{
  const int tools[] = { vtkTFCDomainChart::Ellipse, vtkTFCDomainChart::Rectangle };
  for (int tool : tools)
  {
    ChartScene scene;
    scene.Chart->SetTool(tool);
    scene.Counts.clear();
    scene.Drag(120, -0.4, 160, 0.2);
    ASSERT_EQ(scene.Model->GetNumberOfRegions(), 1);
    vtkTFCRegion* region = scene.Model->GetRegion(0);
    ExpectBox(region, 140, -0.1, 20, 0.3);
    EXPECT_STREQ(region->GetShape()->GetTypeName(),
      tool == vtkTFCDomainChart::Ellipse ? "ellipse" : "rectangle");
    ExpectOneEdit(scene);
    EXPECT_EQ(scene.Chart->GetTool(), vtkTFCDomainChart::Select);
    EXPECT_EQ(scene.Chart->GetSelection(), std::vector<int>({ region->GetId() }));
    EXPECT_FALSE(region->HasTertiary()) << "all voxels are visible at first";
  }
}

TEST(DomainChart, TriangleAndClickWithoutADrag)
{
  ChartScene scene;
  scene.Chart->SetTool(vtkTFCDomainChart::Triangle);
  scene.Drag(120, -0.4, 160, 0.2);
  ASSERT_EQ(scene.Model->GetNumberOfRegions(), 1);
  auto* triangle = vtkTFCTriangleShape::SafeDownCast(scene.Model->GetRegion(0)->GetShape());
  ASSERT_TRUE(triangle);
  double tip[2];
  triangle->GetPoint(2, tip);
  EXPECT_NEAR(tip[0], 140, X);
  EXPECT_NEAR(tip[1], 0.2, Y);

  scene.Chart->SetTool(vtkTFCDomainChart::Ellipse);
  scene.Click(180, 0.6);
  ASSERT_EQ(scene.Model->GetNumberOfRegions(), 2);
  ExpectBox(scene.Model->GetRegion(1), 180, 0.6, 100 / 16.0, 2 / 16.0);
}

TEST(DomainChart, PolygonByClicks)
{
  ChartScene scene;
  scene.Chart->SetTool(vtkTFCDomainChart::Polygon);
  scene.Counts.clear();
  scene.Click(120, -0.5);
  scene.Click(180, -0.5);
  scene.Click(180, 0.5);
  scene.MoveTo(150, 0.6);
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 0);
  scene.Click(150, 0.8);
  scene.Click(120, -0.5);
  ASSERT_EQ(scene.Model->GetNumberOfRegions(), 1);
  auto* polygon = vtkTFCPolygonShape::SafeDownCast(scene.Model->GetRegion(0)->GetShape());
  ASSERT_TRUE(polygon);
  EXPECT_EQ(polygon->GetNumberOfPoints(), 4);
  double p[2];
  polygon->GetPoint(3, p);
  EXPECT_NEAR(p[0], 150, X);
  EXPECT_NEAR(p[1], 0.8, Y);
  ExpectOneEdit(scene);

  // A double click ends it as well, and two points are none.
  scene.Chart->SetTool(vtkTFCDomainChart::Polygon);
  scene.Click(110, 0.5);
  scene.Click(130, 0.5);
  scene.DoubleClick(130, 0.8);
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 2);
  scene.Chart->SetTool(vtkTFCDomainChart::Polygon);
  scene.Click(110, 0.5);
  scene.DoubleClick(130, 0.5);
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 2);
  EXPECT_NE(scene.Message.find("three corners"), std::string::npos);
}

TEST(DomainChart, LassoFromManyMoves)
{
  ChartScene scene;
  scene.Chart->SetTool(vtkTFCDomainChart::Lasso);
  scene.Counts.clear();
  const auto at = [](double t) {
    return std::array<double, 2>{ 150 + 20 * std::cos(t), 0.4 * std::sin(t) };
  };
  scene.Send(vtkCommand::MouseMoveEvent, scene.Pixel(170, 0));
  scene.Send(vtkCommand::LeftButtonPressEvent, scene.Pixel(170, 0));
  for (int i = 0; i < 300; ++i)
  {
    const auto p = at(i * 0.0205);
    scene.MoveTo(p[0], p[1]);
  }
  scene.Render();
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 0);
  scene.Send(vtkCommand::LeftButtonReleaseEvent, scene.Pixel(170, 0));
  ASSERT_EQ(scene.Model->GetNumberOfRegions(), 1);
  auto* polygon = vtkTFCPolygonShape::SafeDownCast(scene.Model->GetRegion(0)->GetShape());
  ASSERT_TRUE(polygon);
  EXPECT_LE(polygon->GetNumberOfPoints(), 40);
  const auto outline = vtkTFCOutline::FromShape(polygon, { { 100, 200, -1, 1 } });
  // pi a b in axis units.
  EXPECT_NEAR(outline.GetArea(), 3.14159 * 20 / 100 * 0.4 / 2, 0.03 * 3.14159 * 0.04);
  ExpectOneEdit(scene);

  // A stroke that encloses nothing says so and changes nothing.
  scene.Chart->SetTool(vtkTFCDomainChart::Lasso);
  scene.Drag(120, 0.7, 180, 0.7);
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 1);
  EXPECT_NE(scene.Message.find("encloses nothing"), std::string::npos);
}

TEST(DomainChart, MovingIsOneEditAndExact)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 20, 0.2);
  scene.Counts.clear();
  scene.Drag(150, 0, 170, 0.4);
  ExpectBox(region, 170, 0.4, 20, 0.2);
  ExpectOneEdit(scene);
  EXPECT_GE(scene.Counts[vtkCommand::InteractionEvent], 4) << "live, not only at the end";
}

TEST(DomainChart, ARegionStaysOnTheAxes)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 10, 0.2);
  scene.DragPixels(scene.Pixel(150, 0), { 511, 479 });
  scene.DragPixels(scene.Pixel(198, 0.98), { 2000, 2000 });
  const auto box = BoxOf(region);
  EXPECT_NEAR(box[0], 200, 3 * X);
  EXPECT_LE(box[0], 200 + 1e-9);
  EXPECT_LE(box[1], 1 + 1e-9);
  EXPECT_NE(scene.Message.find("stays on the axes"), std::string::npos);
}

TEST(DomainChart, HandlesResizeTurnAndChangeTheFalloff)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 20, 0.4);
  scene.Click(150, 0);
  scene.Counts.clear();
  // Upper right corner; the lower left one stays.
  scene.Drag(170, 0.4, 180, 0.6);
  ExpectBox(region, 155, 0.1, 25, 0.5);
  ExpectOneEdit(scene);
  // The width of the smooth fall-off, 0.25, is at 3/4 from the centre to the left.
  scene.Drag(155 - 0.75 * 25, 0.1, 155 - 0.4 * 25, 0.1);
  EXPECT_NEAR(region->GetFalloffWidth(), 0.6, 0.02);
  // The handle to turn is 16 pixels above the upper side; to the right of the centre is -90.
  auto from = scene.Pixel(155, 0.6);
  from[1] += 16;
  const auto center = scene.Pixel(155, 0.1);
  scene.DragPixels(from, { center[0] + 100, center[1] });
  auto* shape = vtkTFCRectangleShape::SafeDownCast(region->GetShape());
  EXPECT_NEAR(shape->GetAngle(), -90, 1);
}

TEST(DomainChart, VerticesByDoubleClick)
{
  ChartScene scene;
  scene.Chart->SetTool(vtkTFCDomainChart::Triangle);
  scene.Drag(120, -0.4, 180, 0.4);
  scene.Counts.clear();
  scene.DoubleClick(150, -0.4);
  vtkTFCRegion* region = scene.Model->GetRegion(0);
  auto* polygon = vtkTFCPolygonShape::SafeDownCast(region->GetShape());
  ASSERT_TRUE(polygon) << "a triangle with four corners is a polygon";
  EXPECT_EQ(polygon->GetNumberOfPoints(), 4);
  ExpectOneEdit(scene);
  scene.Drag(150, -0.4, 150, -0.7);
  double p[2];
  polygon->GetPoint(1, p);
  EXPECT_NEAR(p[1], -0.7, Y);
  scene.DoubleClick(150, -0.7);
  EXPECT_EQ(vtkTFCPolygonShape::SafeDownCast(region->GetShape())->GetNumberOfPoints(), 3);
}

TEST(DomainChart, SelectionByClickBandAndKeys)
{
  ChartScene scene;
  vtkTFCRegion* large = scene.AddRectangle(150, 0, 30, 0.6);
  vtkTFCRegion* small = scene.AddRectangle(150, 0, 5, 0.1);
  vtkTFCRegion* corner = scene.AddRectangle(110, 0.8, 4, 0.1);
  using Ids = std::vector<int>;
  scene.Click(150, 0);
  EXPECT_EQ(scene.Chart->GetSelection(), Ids({ small->GetId() })) << "the smallest one";
  scene.Click(130, 0.3);
  EXPECT_EQ(scene.Chart->GetSelection(), Ids({ large->GetId() }));
  scene.Click(110, 0.8, true);
  EXPECT_EQ(scene.Chart->GetSelection(), Ids({ large->GetId(), corner->GetId() }));
  // Both move together.
  scene.Drag(130, 0.3, 140, 0.3);
  ExpectBox(large, 160, 0, 30, 0.6);
  ExpectBox(corner, 120, 0.8, 4, 0.1);
  scene.Click(195, -0.9);
  EXPECT_TRUE(scene.Chart->GetSelection().empty());
  scene.Drag(105, 0.6, 130, 0.95);
  EXPECT_EQ(scene.Chart->GetSelection(), Ids({ corner->GetId() }));
  EXPECT_TRUE(scene.Chart->HandleKey("a", false, true));
  EXPECT_EQ(scene.Chart->GetSelection().size(), 3u);
  scene.Chart->HandleKey("Escape", false, false);
  EXPECT_TRUE(scene.Chart->HandleKey("Tab", false, false));
  EXPECT_EQ(scene.Chart->GetSelection(), Ids({ large->GetId() }));
  EXPECT_TRUE(scene.Chart->HandleKey("Tab", false, false));
  EXPECT_EQ(scene.Chart->GetSelection(), Ids({ small->GetId() }));
  scene.Counts.clear();
  EXPECT_TRUE(scene.Chart->HandleKey("Delete", false, false));
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 2);
  ExpectOneEdit(scene);
}

TEST(DomainChart, KeysMoveAndDuplicate)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 20, 0.2);
  scene.Chart->SetSelection({ region->GetId() });
  const double pixel = scene.Chart->GetMapping().PixelSize()[0] * 100;
  EXPECT_TRUE(scene.Chart->HandleKey("Right", true, false));
  EXPECT_NEAR(BoxOf(region)[0], 150 + 10 * pixel, 1e-9);
  EXPECT_TRUE(scene.Chart->HandleKey("Left", false, false));
  EXPECT_NEAR(BoxOf(region)[0], 150 + 9 * pixel, 1e-9);
  EXPECT_TRUE(scene.Chart->HandleKey("d", false, true));
  ASSERT_EQ(scene.Model->GetNumberOfRegions(), 2);
  EXPECT_EQ(scene.Model->GetRegion(1)->GetName(), region->GetName() + " copy");
  EXPECT_TRUE(scene.Chart->HandleKey("l", false, false));
  EXPECT_EQ(scene.Chart->GetTool(), vtkTFCDomainChart::Lasso);
}

TEST(DomainChart, ReturnDrawsWithoutAMouse)
{
  ChartScene scene;
  scene.Counts.clear();
  EXPECT_TRUE(scene.Chart->HandleKey("r", false, false));
  EXPECT_TRUE(scene.Chart->HandleKey("Return", false, false));
  ASSERT_EQ(scene.Model->GetNumberOfRegions(), 1);
  ExpectBox(scene.Model->GetRegion(0), 150, 0, 100 / 16.0, 2 / 16.0);
  ExpectOneEdit(scene);
  EXPECT_EQ(scene.Chart->GetTool(), vtkTFCDomainChart::Select);
  EXPECT_FALSE(scene.Chart->HandleKey("Return", false, false));
}

// Around the probe's mark where it is shown, whatever the tool.
TEST(DomainChart, AddsARegionAtTheProbe)
{
  ChartScene scene;
  scene.Counts.clear();
  scene.Chart->SetProbe(120, 0.5);
  scene.Chart->SetTool(vtkTFCDomainChart::Lasso);
  EXPECT_TRUE(scene.Chart->AddRegion());
  ASSERT_EQ(scene.Model->GetNumberOfRegions(), 1);
  EXPECT_STREQ(scene.Model->GetRegion(0)->GetShape()->GetTypeName(), "ellipse");
  ExpectBox(scene.Model->GetRegion(0), 120, 0.5, 100 / 16.0, 2 / 16.0);
  ExpectOneEdit(scene);
  EXPECT_EQ(scene.Chart->GetTool(), vtkTFCDomainChart::Lasso);
  EXPECT_EQ(scene.Chart->GetSelection(), std::vector<int>{ scene.Model->GetRegion(0)->GetId() });
  // Outside of what is shown: in the middle, as without a probe; with the key as well.
  scene.Chart->SetProbe(1000, 0.5);
  EXPECT_TRUE(scene.Chart->HandleKey("r", false, false));
  EXPECT_TRUE(scene.Chart->HandleKey("Return", false, false));
  ASSERT_EQ(scene.Model->GetNumberOfRegions(), 2);
  ExpectBox(scene.Model->GetRegion(1), 150, 0, 100 / 16.0, 2 / 16.0);
  // A polygon that was begun is dropped.
  scene.Chart->SetTool(vtkTFCDomainChart::Polygon);
  scene.Click(130, 0);
  EXPECT_TRUE(scene.Chart->AddRegion());
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 3);
  scene.Chart->SetTransferFunction(nullptr);
  EXPECT_FALSE(scene.Chart->AddRegion());
}

TEST(DomainChart, KeysReachItThroughTheInteractor)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 20, 0.2);
  scene.Click(150, 0);
  scene.View->GetInteractor()->SetKeySym("Delete");
  scene.View->GetInteractor()->InvokeEvent(vtkCommand::KeyPressEvent);
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 0);
  EXPECT_TRUE(region != nullptr);
}

TEST(DomainChart, LockedRegionsAreSelectedOnly)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 20, 0.2);
  region->SetLocked(true);
  const std::string before = scene.Model->GetState();
  scene.Drag(150, 0, 170, 0.3);
  EXPECT_EQ(scene.Chart->GetSelection(), std::vector<int>({ region->GetId() }));
  scene.Drag(170, 0.2, 180, 0.3);
  scene.Chart->SetSelection({ region->GetId() });
  EXPECT_FALSE(scene.Chart->HandleKey("Delete", false, false));
  EXPECT_EQ(scene.Model->GetState(), before);
  EXPECT_NE(scene.Message.find("locked"), std::string::npos);
}

TEST(DomainChart, EscapePutsTheModelBack)
{
  ChartScene scene;
  scene.AddRectangle(150, 0, 20, 0.2);
  scene.Model->SetProposal(true);
  const std::string before = scene.Model->GetState();
  scene.Send(vtkCommand::MouseMoveEvent, scene.Pixel(150, 0));
  scene.Send(vtkCommand::LeftButtonPressEvent, scene.Pixel(150, 0));
  scene.MoveTo(170, 0.5);
  EXPECT_NE(scene.Model->GetState(), before);
  EXPECT_FALSE(scene.Model->GetProposal()) << "an edited proposal is none";
  scene.Chart->HandleKey("Escape", false, false);
  EXPECT_EQ(scene.Model->GetState(), before);
  scene.MoveTo(180, 0.5);
  scene.Send(vtkCommand::LeftButtonReleaseEvent, scene.Pixel(180, 0.5));
  EXPECT_EQ(scene.Model->GetState(), before);
  EXPECT_EQ(scene.Counts[vtkCommand::StartInteractionEvent], 1);
  EXPECT_EQ(scene.Counts[vtkCommand::EndInteractionEvent], 1);
}

TEST(DomainChart, WheelZoomsAroundThePointerAndMiddlePans)
{
  ChartScene scene;
  scene.MoveTo(120, 0.5);
  scene.Send(vtkCommand::MouseWheelForwardEvent, scene.Pixel(120, 0.5));
  double view[4];
  scene.Chart->GetViewRange(view);
  EXPECT_LT(view[1] - view[0], 0.99);
  const auto pixel = scene.Pixel(120, 0.5);
  scene.Render();
  EXPECT_NEAR(pixel[0], scene.Pixel(120, 0.5)[0], 40);
  // What was under the pointer is still there, to a pixel.
  EXPECT_NEAR((0.2 - view[0]) / (view[1] - view[0]), 0.2, 0.003);
  scene.Send(vtkCommand::MouseMoveEvent, scene.Pixel(150, 0));
  scene.Send(vtkCommand::MiddleButtonPressEvent, scene.Pixel(150, 0));
  auto to = scene.Pixel(150, 0);
  to[0] -= 50;
  scene.Send(vtkCommand::MouseMoveEvent, to);
  scene.Send(vtkCommand::MiddleButtonReleaseEvent, to);
  double panned[4];
  scene.Chart->GetViewRange(panned);
  EXPECT_NEAR(panned[0] - view[0], 50 * scene.Chart->GetMapping().PixelSize()[0], 1e-9);
  const double wild[4] = { -1e30, 1e30, 0.5, 0.5 };
  scene.Chart->SetViewRange(wild);
  scene.Chart->GetViewRange(view);
  EXPECT_EQ(view[0], -1);
  EXPECT_NEAR(view[3] - view[2], 1e-6, 1e-12);
  scene.Render();
  scene.Chart->FitAll();
}

TEST(DomainChart, HoverSaysValuesCountAndRegion)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 20, 0.2);
  const double counts[4] = { 1, 2, 3, 4 };
  scene.Chart->GetHistogram()->SetCounts(counts, 2, 2, { { 100, 200, -1, 1 } });
  scene.MoveTo(160, 0.1);
  double data[2];
  double count;
  int id;
  ASSERT_TRUE(scene.Chart->GetHover(data, count, id));
  EXPECT_NEAR(data[0], 160, X);
  EXPECT_NEAR(data[1], 0.1, Y);
  EXPECT_EQ(count, 4);
  EXPECT_EQ(id, region->GetId());
  scene.Send(vtkCommand::MouseMoveEvent, { 2, 2 });
  EXPECT_FALSE(scene.Chart->GetHover(data, count, id));
}

TEST(DomainChart, NothingToEditIsNoTrouble)
{
  ChartScene scene;
  scene.Chart->SetTransferFunction(nullptr);
  scene.Chart->SetTool(vtkTFCDomainChart::Ellipse);
  scene.Drag(120, -0.4, 160, 0.2);
  scene.DoubleClick(120, 0);
  for (const char* key : { "Delete", "Left", "Tab", "d", "a", "Escape", "Return" })
  {
    scene.Chart->HandleKey(key, false, true);
    scene.Chart->HandleKey(key, true, false);
  }
  EXPECT_EQ(scene.Model->GetNumberOfRegions(), 0);
}
