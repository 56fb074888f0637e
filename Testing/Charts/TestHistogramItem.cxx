// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture of the joint histogram: scales in numbers, and where it is drawn in pixels.
#include "ChartScene.h"

#include "vtkImageData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <cmath>

using tfctest::ChartScene;

TEST(HistogramItem, ScalesAreAsDocumented)
{
  vtkNew<vtkTFCHistogramItem> item;
  std::vector<double> counts(100);
  for (int i = 0; i < 100; ++i)
  {
    counts[i] = i;
  }
  item->SetCounts(counts.data(), 10, 10, { { 0, 1, 0, 1 } });
  EXPECT_EQ(item->GetBrightness(0), 0);
  EXPECT_DOUBLE_EQ(item->GetBrightness(50), std::log(51.0) / std::log(100.0));
  item->SetScale(vtkTFCHistogramItem::Linear);
  EXPECT_DOUBLE_EQ(item->GetBrightness(50), 50 / 99.0);
  item->SetScale(vtkTFCHistogramItem::Percentile);
  item->SetPercentile(50);
  // The filled bins hold 1 to 99: half of them hold at most 50.
  EXPECT_DOUBLE_EQ(item->GetBrightness(25), 0.5);
  EXPECT_DOUBLE_EQ(item->GetBrightness(80), 1);
  EXPECT_EQ(item->GetCount(0.95, 0.95), 99);
  EXPECT_EQ(item->GetCount(1, 0), 9);
  EXPECT_EQ(item->GetCount(1.01, 0), -1);
  EXPECT_EQ(item->GetCount(std::nan(""), 0), -1);
  item->SetCounts(nullptr, 0, 0, { { 0, 1, 0, 1 } });
  EXPECT_EQ(item->GetCount(0.5, 0.5), -1);
}

// Ranges far from 0 and very different from each other: where stock items lose their picture.
TEST(HistogramItem, IsWhereItsDataAre)
{
  ChartScene scene;
  const double ranges[4] = { 101225, 101425, 290, 290.002 };
  scene.Chart->SetAxisRanges(ranges);
  const double counts[4] = { 0, 9, 0, 0 };
  scene.Chart->GetHistogram()->SetCounts(counts, 2, 2, { { 101225, 101425, 290, 290.002 } });
  scene.Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(scene.View->GetRenderWindow());
  grab->ReadFrontBufferOff();
  grab->Update();
  const auto darkness = [&](double x, double y)
  {
    const auto p = scene.Pixel(x, y);
    return 255 - grab->GetOutput()->GetScalarComponentAsDouble(p[0], p[1], 0, 0);
  };
  EXPECT_GT(darkness(101400, 290.0002), 150);
  EXPECT_LT(darkness(101250, 290.0002), 5);
  EXPECT_LT(darkness(101400, 290.0018), 5);
  EXPECT_LT(darkness(101250, 290.0018), 5);
}

// A region's filling is the model's weight: full inside, nothing outside, half in its fall-off.
TEST(HistogramItem, RegionsShowTheirWeight)
{
  ChartScene scene;
  vtkTFCRegion* region = scene.AddRectangle(150, 0, 40, 0.8);
  region->SetFalloff(vtkTFCRegion::Linear, 0.5);
  region->SetColor(1, 0, 0);
  region->SetOpacity(1);
  scene.Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(scene.View->GetRenderWindow());
  grab->ReadFrontBufferOff();
  grab->Update();
  const auto red = [&](double x, double y)
  {
    const auto p = scene.Pixel(x, y);
    return 255 - grab->GetOutput()->GetScalarComponentAsDouble(p[0], p[1], 0, 1);
  };
  // 0.25 + 0.45 * opacity at weight 1.
  EXPECT_NEAR(red(150, 0.05), 255 * 0.7, 4);
  // d = 0.75: weight 0.5.
  EXPECT_NEAR(red(180, 0.05), 255 * 0.35, 6);
  EXPECT_LT(red(195, 0.05), 5);
}
