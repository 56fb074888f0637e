// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The opacity of regions by the slider beside the selected one, and by keys.
#include "ChartScene.h"

#include "vtkTFCRegionItem.h"

#include <gtest/gtest.h>

#include <cmath>

using tfctest::BoxOf;
using tfctest::ChartScene;
using tfctest::ExpectOneEdit;

TEST(OpacitySlider, ChangesTheOpacity)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 20, 0.4);
  region->SetOpacity(0.5);
  scene.Click(150, 0);
  scene.Counts.clear();
  const auto box = BoxOf(region);
  // 18 pixels right of the region, 64 long, around the region's middle.
  auto from = scene.Pixel(170, 0);
  from[0] += 18;
  scene.DragPixels(from, { from[0] + 30, from[1] + 16 });
  EXPECT_NEAR(region->GetOpacity(), 0.75, 0.011) << "16 of 64 pixels, whatever it moves sideways";
  ExpectOneEdit(scene);
  EXPECT_EQ(BoxOf(region), box);
  // It is up there now; with Shift a tenth, to a thousandth.
  from[1] += 16;
  scene.DragPixels(from, { from[0], from[1] - 32 }, false, true);
  EXPECT_NEAR(region->GetOpacity(), 0.70, 0.011);
  EXPECT_NEAR(1000 * region->GetOpacity(), std::round(1000 * region->GetOpacity()), 1e-9);
  from[1] -= 3;
  scene.DragPixels(from, { from[0], from[1] + 200 });
  EXPECT_EQ(region->GetOpacity(), 1);
  from = scene.Pixel(170, 0);
  from[0] += 18;
  from[1] += 32;
  scene.DragPixels(from, { from[0], 5 });
  EXPECT_EQ(region->GetOpacity(), 0);
  // Still there to be dragged up again; Escape puts it back.
  from[1] -= 64;
  scene.Send(vtkCommand::MouseMoveEvent, from);
  scene.Send(vtkCommand::LeftButtonPressEvent, from);
  scene.Send(vtkCommand::MouseMoveEvent, { from[0], from[1] + 32 });
  EXPECT_NEAR(region->GetOpacity(), 0.5, 0.011);
  scene.Chart->HandleKey("Escape", false, false);
  EXPECT_EQ(region->GetOpacity(), 0);
}

TEST(OpacitySlider, IsWithinReachEverywhere)
{
  // At each border, larger than the plot, and tiny.
  const double boxes[][4] = { { 195, 0.95, 5, 0.05 }, { 105, -0.95, 5, 0.05 }, { 150, 0, 60, 1.2 },
    { 199.9, -0.999, 0.05, 0.001 }, { 160, 0, 38, 0.3 } };
  for (const auto& b : boxes)
  {
    ChartScene scene;
    vtkTFCRegion* region = scene.AddRectangle(b[0], b[1], b[2], b[3]);
    region->SetOpacity(0.5);
    scene.Chart->SetSelection({ region->GetId() });
    scene.Render();
    vtkNew<vtkTFCRegionItem> item;
    item->SetMapping(&scene.Chart->GetMapping());
    item->SetRegion(region);
    vtkTFCOutline::Point zero;
    vtkTFCOutline::Point one;
    item->GetOpacitySlider(zero, one);
    EXPECT_TRUE(scene.Chart->GetMapping().InPlot(zero)) << b[0];
    EXPECT_TRUE(scene.Chart->GetMapping().InPlot(one)) << b[0];
    EXPECT_NEAR(one[1] - zero[1], 64, 1e-9);
    const auto p = item->GetOpacityHandle();
    const std::array<int, 2> from = { static_cast<int>(std::lround(p[0])),
      static_cast<int>(std::lround(p[1])) };
    scene.DragPixels(from, { from[0], from[1] - 16 });
    EXPECT_NEAR(region->GetOpacity(), 0.25, 0.011) << b[0];
    EXPECT_EQ(BoxOf(region), (std::array<double, 4>{ b[0], b[1], b[2], b[3] }));
  }
}

TEST(OpacitySlider, KeysDoTheSame)
{
  ChartScene scene;
  vtkTFCRegion* one = scene.AddRectangle(150, 0, 20, 0.2);
  vtkTFCRegion* two = scene.AddRectangle(120, 0.5, 5, 0.2);
  vtkTFCRegion* locked = scene.AddRectangle(180, 0.5, 5, 0.2);
  one->SetOpacity(0.1);
  two->SetOpacity(0.98);
  locked->SetOpacity(0.5);
  locked->SetLocked(true);
  scene.Chart->SelectAll();
  scene.Counts.clear();
  EXPECT_TRUE(scene.Chart->HandleKey("PageUp", false, false));
  ExpectOneEdit(scene);
  EXPECT_EQ(one->GetOpacity(), 0.15);
  EXPECT_EQ(two->GetOpacity(), 1);
  EXPECT_TRUE(scene.Chart->HandleKey("PageDown", true, false));
  EXPECT_EQ(one->GetOpacity(), 0.14);
  EXPECT_EQ(two->GetOpacity(), 0.99);
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_TRUE(scene.Chart->HandleKey("Next", false, false));
  }
  EXPECT_EQ(one->GetOpacity(), 0);
  EXPECT_EQ(locked->GetOpacity(), 0.5);
  scene.Chart->SetSelection({ locked->GetId() });
  EXPECT_FALSE(scene.Chart->HandleKey("PageUp", false, false));
  scene.Chart->SetSelection({});
  EXPECT_FALSE(scene.Chart->HandleKey("PageUp", false, false));
}
