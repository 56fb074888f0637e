// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The look of the chart against pictures that somebody has looked at. To renew one, run with
// TFC_WRITE_BASELINES=1 and look at it again.
#include "ChartScene.h"

#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkTFCEllipseShape.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <cstdlib>

using tfctest::ChartScene;

namespace
{
// Three populations of a volume, on 128 x 128 bins.
void FillHistogram(ChartScene& scene)
{
  std::vector<double> counts(128 * 128);
  const double peaks[3][5] = { { 0.15, 0.1, 0.05, 0.05, 1e4 }, { 0.5, 0.3, 0.1, 0.06, 3e3 },
    { 0.75, 0.7, 0.08, 0.12, 500 } };
  for (int j = 0; j < 128; ++j)
  {
    for (int i = 0; i < 128; ++i)
    {
      double count = 0;
      for (const auto& p : peaks)
      {
        const double x = ((i + 0.5) / 128 - p[0]) / p[2];
        const double y = ((j + 0.5) / 128 - p[1]) / p[3];
        count += p[4] * std::exp(-(x * x + y * y) / 2);
      }
      counts[j * 128 + i] = std::floor(count);
    }
  }
  scene.Chart->GetHistogram()->SetCounts(counts.data(), 128, 128, { { 100, 200, -1, 1 } });
}

void AddRegions(ChartScene& scene)
{
  vtkTFCRegion* box = scene.AddRectangle(120, -0.7, 12, 0.2);
  box->SetName("air");
  vtkTFCRegion* ellipse = scene.Model->AddNewRegion("ellipse");
  auto* shape = vtkTFCEllipseShape::SafeDownCast(ellipse->GetShape());
  shape->SetCenter(150, -0.4);
  shape->SetRadii(22, 0.25);
  shape->SetAngle(25);
  double color[3];
  vtkTFCRegion::GetPaletteColor(1, color);
  ellipse->SetColor(color[0], color[1], color[2]);
  ellipse->SetName("tissue");
  scene.Chart->SetTool(vtkTFCDomainChart::Triangle);
  scene.Drag(160, 0, 190, 0.8);
  scene.Model->GetRegion(2)->SetVisible(false);
  scene.Chart->SetSelection({ ellipse->GetId() });
  scene.Send(vtkCommand::MouseMoveEvent, { 2, 2 });
}

void Compare(ChartScene& scene, const std::string& name)
{
  scene.Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(scene.View->GetRenderWindow());
  grab->ReadFrontBufferOff();
  grab->Update();
  const std::string baseline = TFC_BASELINES "/" + name + ".png";
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  if (std::getenv("TFC_WRITE_BASELINES"))
  {
    writer->SetFileName(baseline.c_str());
    writer->Write();
    return;
  }
  vtkNew<vtkPNGReader> reader;
  ASSERT_TRUE(reader->CanReadFile(baseline.c_str())) << baseline;
  reader->SetFileName(baseline.c_str());
  vtkNew<vtkImageDifference> difference;
  difference->SetInputConnection(grab->GetOutputPort());
  difference->SetImageConnection(reader->GetOutputPort());
  difference->Update();
  // Letters differ between versions of FreeType; a region that is not drawn is thousands.
  EXPECT_LT(difference->GetThresholdedError(), 400)
    << "see " << name << ".png in the test's folder";
  if (difference->GetThresholdedError() >= 400)
  {
    writer->SetFileName((name + ".png").c_str());
    writer->Write();
  }
}
}

TEST(ChartPicture, RegionsOnTheHistogram)
{
  ChartScene scene;
  FillHistogram(scene);
  AddRegions(scene);
  Compare(scene, "ChartLight");
}

TEST(ChartPicture, DarkZoomedAndProbed)
{
  ChartScene scene;
  FillHistogram(scene);
  AddRegions(scene);
  scene.Chart->SetDark(true);
  scene.View->GetRenderer()->SetBackground(0.2, 0.2, 0.2);
  scene.Chart->GetHistogram()->SetColorMap(vtkTFCHistogramItem::Viridis);
  const double view[4] = { 0.1, 0.9, 0.05, 0.85 };
  scene.Chart->SetViewRange(view);
  scene.Chart->SetProbe(165, 0.1);
  Compare(scene, "ChartDark");
}
