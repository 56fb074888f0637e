// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A domain chart in an offscreen window, with mouse events sent through its interactor as a
 * user's are.
 */

#ifndef TFC_Testing_ChartScene_h
#define TFC_Testing_ChartScene_h

#include "vtkTFCDomainChart.h"
#include "vtkTFCEllipseShape.h"
#include "vtkTFCHistogramItem.h"
#include "vtkTFCRectangleShape.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include "vtkCallbackCommand.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>

namespace tfctest
{

/// Axes from 100 to 200 and from -1 to 1, 512 x 480 pixels.
class ChartScene
{
public:
  ChartScene()
  {
    this->View->GetRenderWindow()->SetOffScreenRendering(1);
    this->View->GetRenderWindow()->SetSize(512, 480);
    this->View->GetRenderWindow()->SetMultiSamples(0);
    this->View->GetRenderWindow()->SetDPI(72);
    this->View->GetInteractor()->Initialize();
    this->View->GetScene()->AddItem(this->Chart);
    this->Model->SetAxis(0, "a");
    this->Model->SetAxis(1, "b");
    this->Model->SetAxisRange(0, 100, 200);
    this->Model->SetAxisRange(1, -1, 1);
    const double ranges[4] = { 100, 200, -1, 1 };
    this->Chart->SetTransferFunction(this->Model);
    this->Chart->SetAxisRanges(ranges);
    this->Chart->SetAxisTitles("a", "b");
    this->Events->SetClientData(this);
    this->Events->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* data)
      {
        auto* scene = static_cast<ChartScene*>(self);
        ++scene->Counts[event];
        if (event == vtkTFCDomainChart::MessageEvent)
        {
          scene->Message = static_cast<const char*>(data);
        }
      });
    this->Chart->AddObserver(vtkCommand::AnyEvent, this->Events);
    this->Render();
    this->Counts.clear();
  }

  // The chart outlives the counts, and reports its own end.
  ~ChartScene() { this->Chart->RemoveObserver(this->Events); }
  ChartScene(const ChartScene&) = delete;
  ChartScene& operator=(const ChartScene&) = delete;

  void Render() { this->View->GetRenderWindow()->Render(); }

  /// Pixels of a point in data units, rounded as a mouse is.
  std::array<int, 2> Pixel(double x, double y) const
  {
    const vtkTFCDomainMapping& map = this->Chart->GetMapping();
    const auto p = map.ToPixel(map.FromData({ x, y }));
    return { static_cast<int>(std::lround(p[0])), static_cast<int>(std::lround(p[1])) };
  }

  void Send(unsigned long event, std::array<int, 2> pixel, bool control = false, bool shift = false,
    bool alt = false)
  {
    this->View->GetInteractor()->SetEventInformation(pixel[0], pixel[1], control, shift);
    this->View->GetInteractor()->SetAltKey(alt);
    this->View->GetInteractor()->InvokeEvent(event);
  }

  void MoveTo(double x, double y) { this->Send(vtkCommand::MouseMoveEvent, this->Pixel(x, y)); }

  void Click(double x, double y, bool control = false, bool shift = false)
  {
    const auto p = this->Pixel(x, y);
    this->Send(vtkCommand::MouseMoveEvent, p, control, shift);
    this->Send(vtkCommand::LeftButtonPressEvent, p, control, shift);
    this->Send(vtkCommand::LeftButtonReleaseEvent, p, control, shift);
    this->Render();
  }

  /// As Qt sends it: press, release, double click, release.
  void DoubleClick(double x, double y)
  {
    this->Click(x, y);
    this->Send(vtkCommand::LeftButtonDoubleClickEvent, this->Pixel(x, y));
    this->Send(vtkCommand::LeftButtonReleaseEvent, this->Pixel(x, y));
    this->Render();
  }

  /// In five steps; pixels are those before the drag.
  void DragPixels(std::array<int, 2> from, std::array<int, 2> to, bool control = false,
    bool shift = false)
  {
    this->Send(vtkCommand::MouseMoveEvent, from, control, shift);
    this->Send(vtkCommand::LeftButtonPressEvent, from, control, shift);
    for (int i = 1; i <= 5; ++i)
    {
      this->Send(vtkCommand::MouseMoveEvent,
        { from[0] + (to[0] - from[0]) * i / 5, from[1] + (to[1] - from[1]) * i / 5 }, control,
        shift);
      this->Render();
    }
    this->Send(vtkCommand::LeftButtonReleaseEvent, to, control, shift);
    this->Render();
  }

  void Drag(double x0, double y0, double x1, double y1, bool control = false, bool shift = false)
  {
    this->DragPixels(this->Pixel(x0, y0), this->Pixel(x1, y1), control, shift);
  }

  /// A rectangle region in the model.
  vtkTFCRegion* AddRectangle(double x, double y, double hx, double hy)
  {
    vtkTFCRegion* region = this->Model->AddNewRegion("rectangle");
    auto* shape = vtkTFCRectangleShape::SafeDownCast(region->GetShape());
    shape->SetCenter(x, y);
    shape->SetHalfSize(hx, hy);
    double color[3];
    vtkTFCRegion::GetPaletteColor(this->Model->GetNumberOfRegions() - 1, color);
    region->SetColor(color[0], color[1], color[2]);
    this->Render();
    return region;
  }

  vtkNew<vtkContextView> View;
  vtkNew<vtkTFCDomainChart> Chart;
  vtkNew<vtkTFCTransferFunction> Model;
  vtkNew<vtkCallbackCommand> Events;
  std::map<unsigned long, int> Counts;
  std::string Message;
};

/// Centre and half sizes of a rectangle or an ellipse.
inline std::array<double, 4> BoxOf(vtkTFCRegion* region)
{
  std::array<double, 4> box = { { 0, 0, 0, 0 } };
  if (auto* r = vtkTFCRectangleShape::SafeDownCast(region->GetShape()))
  {
    r->GetCenter(box.data());
    r->GetHalfSize(&box[2]);
  }
  else if (auto* e = vtkTFCEllipseShape::SafeDownCast(region->GetShape()))
  {
    e->GetCenter(box.data());
    e->GetRadii(&box[2]);
  }
  return box;
}

/// Everything since the counts were cleared was one edit.
inline void ExpectOneEdit(ChartScene& scene)
{
  EXPECT_EQ(scene.Counts[vtkCommand::StartInteractionEvent], 1);
  EXPECT_GE(scene.Counts[vtkCommand::InteractionEvent], 1);
  EXPECT_EQ(scene.Counts[vtkCommand::EndInteractionEvent], 1);
}

}

#endif
