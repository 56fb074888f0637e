// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The legend in the overlay of a view, by the colours of its pixels.
#include "vtkTFCEllipseShape.h"
#include "vtkTFCLegendItem.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

namespace
{

constexpr int WIDTH = 800;
constexpr int HEIGHT = 600;

using Color = std::array<int, 3>;

class Legend : public testing::Test
{
protected:
  Legend()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(WIDTH, HEIGHT);
    this->Window->SetMultiSamples(0);
    this->Window->SetDPI(72);
    this->Window->AddRenderer(this->Renderer);
    this->Actor->GetScene()->AddItem(this->Item);
    this->Actor->GetScene()->SetRenderer(this->Renderer);
    this->Renderer->AddActor(this->Actor);
    this->Model->SetAxis(0, "temperature");
    this->Model->SetAxis(1, "humidity");
    this->Model->SetAxisRange(0, 100, 200);
    this->Model->SetAxisRange(1, -1, 1);
    this->Item->SetTransferFunction(this->Model);
  }

  vtkTFCRegion* Add(const char* name, double x, double y, const std::array<double, 3>& color)
  {
    vtkTFCRegion* region = this->Model->AddNewRegion("ellipse");
    auto* shape = vtkTFCEllipseShape::SafeDownCast(region->GetShape());
    shape->SetCenter(x, y);
    shape->SetRadii(15, 0.3);
    region->SetName(name);
    region->SetColor(color[0], color[1], color[2]);
    return region;
  }

  static void SetFunction(vtkTFCRegion* region, const std::vector<std::array<double, 2>>& nodes,
    const std::vector<std::array<double, 4>>& colors = {})
  {
    vtkNew<vtkDoubleArray> opacity;
    opacity->SetNumberOfComponents(2);
    for (const auto& node : nodes)
    {
      opacity->InsertNextTuple(node.data());
    }
    vtkNew<vtkDoubleArray> color;
    color->SetNumberOfComponents(4);
    for (const auto& node : colors)
    {
      color->InsertNextTuple(node.data());
    }
    ASSERT_TRUE(
      region->SetTertiary("vorticity", 0, opacity, colors.empty() ? nullptr : color.Get()));
  }

  void Render(const char* name = nullptr)
  {
    this->Window->Render();
    this->Window->GetPixelData(0, 0, WIDTH - 1, HEIGHT - 1, 1, this->Pixels);
    // To look at: set TFC_WRITE_PICTURES to a folder.
    const char* folder = std::getenv("TFC_WRITE_PICTURES");
    if (folder && name)
    {
      vtkNew<vtkWindowToImageFilter> picture;
      picture->SetInput(this->Window);
      vtkNew<vtkPNGWriter> writer;
      writer->SetInputConnection(picture->GetOutputPort());
      writer->SetFileName((std::string(folder) + "/" + name + ".png").c_str());
      writer->Write();
    }
  }

  Color At(double x, double y)
  {
    const auto* p =
      this->Pixels->GetPointer(3 * (static_cast<vtkIdType>(y) * WIDTH + static_cast<vtkIdType>(x)));
    return { p[0], p[1], p[2] };
  }

  // Number of pixels in a part of the window that satisfy a test.
  int Count(double x0, double y0, double x1, double y1, const std::function<bool(const Color&)>& is)
  {
    int count = 0;
    for (int y = static_cast<int>(y0); y < y1; ++y)
    {
      for (int x = static_cast<int>(x0); x < x1; ++x)
      {
        count += is(this->At(x, y)) ? 1 : 0;
      }
    }
    return count;
  }

  // Pixels of the plot for data values of the axes.
  std::array<double, 2> ToPixel(double x, double y) const
  {
    const auto& plot = this->Item->GetPlot();
    return { plot[0] + (x - 100) / 100 * plot[2], plot[1] + (y + 1) / 2 * plot[3] };
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkContextActor> Actor;
  vtkNew<vtkTFCLegendItem> Item;
  vtkNew<vtkTFCTransferFunction> Model;
  vtkNew<vtkUnsignedCharArray> Pixels;
};

bool IsRed(const Color& c)
{
  return c[0] > 60 && c[0] > 2 * c[1] && c[0] > 2 * c[2];
}

bool IsGreen(const Color& c)
{
  return c[1] > 60 && c[1] > 2 * c[0] && c[1] > 2 * c[2];
}

bool IsBlue(const Color& c)
{
  return c[2] > 60 && c[2] > 2 * c[0] && c[2] > 2 * c[1];
}

bool IsLit(const Color& c)
{
  return c[0] + c[1] + c[2] > 30;
}

}

TEST_F(Legend, ShowsTheRegionsWhereTheyAre)
{
  this->Add("warm", 130, -0.4, { { 1, 0, 0 } });
  this->Add("moist", 170, 0.5, { { 0, 1, 0 } });
  this->Render("legend_two");
  const auto warm = this->ToPixel(130, -0.4);
  const auto moist = this->ToPixel(170, 0.5);
  EXPECT_TRUE(IsRed(this->At(warm[0], warm[1])));
  EXPECT_TRUE(IsGreen(this->At(moist[0], moist[1])));
  const auto& plot = this->Item->GetPlot();
  EXPECT_FALSE(IsLit(this->At(plot[0] + 4, plot[1] + plot[3] - 4))) << "no region, no ground";
  // A swatch for each at the right of the plot, and nothing outside of the legend.
  EXPECT_GT(this->Count(plot[0] + plot[2] + 4, 0, WIDTH, HEIGHT, IsRed), 60);
  EXPECT_GT(this->Count(plot[0] + plot[2] + 4, 0, WIDTH, HEIGHT, IsGreen), 60);
  EXPECT_EQ(this->Count(0, 0, WIDTH * 0.55, HEIGHT, IsLit), 0);
  EXPECT_EQ(this->Count(0, HEIGHT * 0.4, WIDTH, HEIGHT, IsLit), 0);
}

TEST_F(Legend, DrawsTheFunctionOfTheTertiaryAttribute)
{
  // A ramp fills half of its box, a full one all of it.
  vtkTFCRegion* region = this->Add("front", 130, -0.4, { { 1, 0, 0 } });
  SetFunction(region, { { { 5, 1 } }, { { 25, 1 } } });
  this->Render("legend_full");
  const auto& plot = this->Item->GetPlot();
  const double right = plot[0] + plot[2] + 4;
  const int full = this->Count(right, 0, WIDTH, HEIGHT, IsRed);
  SetFunction(region, { { { 5, 0 } }, { { 25, 1 } } });
  this->Render("legend_ramp");
  const int ramp = this->Count(right, 0, WIDTH, HEIGHT, IsRed);
  SetFunction(region, { { { 5, 0 } }, { { 15, 0 } }, { { 15, 1 } }, { { 25, 1 } } });
  this->Render("legend_step");
  const int step = this->Count(right, 0, WIDTH, HEIGHT, IsRed);
  region->RemoveTertiary();
  this->Render();
  const int swatch = this->Count(right, 0, WIDTH, HEIGHT, IsRed);
  EXPECT_GT(full - swatch, 3000);
  EXPECT_NEAR(ramp - swatch, 0.5 * (full - swatch), 0.04 * (full - swatch));
  EXPECT_NEAR(step - swatch, 0.5 * (full - swatch), 0.04 * (full - swatch));
}

TEST_F(Legend, FillsAFunctionWithItsColors)
{
  vtkTFCRegion* region = this->Add("front", 130, -0.4, { { 1, 0, 0 } });
  SetFunction(region, { { { 5, 1 } }, { { 25, 1 } } },
    { { { 5, 0, 1, 0 } }, { { 15, 0, 1, 0 } }, { { 15, 0, 0, 1 } }, { { 25, 0, 0, 1 } } });
  this->Render("legend_colors");
  const auto& plot = this->Item->GetPlot();
  const double right = plot[0] + plot[2] + 4;
  const int green = this->Count(right, 0, WIDTH, HEIGHT, IsGreen);
  const int blue = this->Count(right, 0, WIDTH, HEIGHT, IsBlue);
  EXPECT_GT(green, 1500);
  EXPECT_NEAR(green, blue, 0.06 * green);
}

TEST_F(Legend, IsTheSameOnAScreenOfTwiceTheDensity)
{
  vtkTFCRegion* region = this->Add("front", 130, -0.4, { { 1, 0, 0 } });
  SetFunction(region, { { { 5, 0 } }, { { 25, 1 } } });
  this->Render();
  const auto plot = this->Item->GetPlot();
  const double right = plot[0] + plot[2] + 4;
  const int count = this->Count(right, 0, WIDTH, HEIGHT, IsRed);
  this->Window->SetSize(2 * WIDTH, 2 * HEIGHT);
  this->Window->SetDPI(144);
  this->Window->Render();
  const auto large = this->Item->GetPlot();
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(large[i], 2 * plot[i], 8) << i; // labels are as wide as their font
  }
  this->Window->GetPixelData(0, 0, 2 * WIDTH - 1, 2 * HEIGHT - 1, 1, this->Pixels);
  int red = 0;
  for (vtkIdType i = 0; i < this->Pixels->GetNumberOfTuples(); ++i)
  {
    const auto* p = this->Pixels->GetPointer(3 * i);
    red += i % (2 * WIDTH) > 2 * right && IsRed({ p[0], p[1], p[2] }) ? 1 : 0;
  }
  EXPECT_NEAR(red, 4 * count, 0.4 * count);
}

TEST_F(Legend, LeavesOutWhatIsInvisible)
{
  this->Render();
  EXPECT_EQ(this->Count(0, 0, WIDTH, HEIGHT, IsLit), 0) << "no regions";
  vtkTFCRegion* region = this->Add("hidden", 150, 0, { { 1, 0, 0 } });
  region->VisibleOff();
  this->Render();
  EXPECT_EQ(this->Count(0, 0, WIDTH, HEIGHT, IsLit), 0);
  region->VisibleOn();
  this->Render();
  EXPECT_GT(this->Count(0, 0, WIDTH, HEIGHT, IsLit), 100);
}

TEST_F(Legend, ManyRegionsSayHowManyAreMissing)
{
  for (int i = 0; i < 40; ++i)
  {
    double color[3];
    vtkTFCRegion::GetPaletteColor(i, color);
    vtkTFCRegion* region =
      this->Add(("a region with a rather long name " + std::to_string(i)).c_str(), 110 + 2 * i,
        -0.5 + 0.025 * i, { { color[0], color[1], color[2] } });
    SetFunction(region, { { { 0, 0 } }, { { 1.0 + i, 1 } } });
  }
  this->Item->SetSize(0.6, 0.6);
  this->Render("legend_many");
  EXPECT_GT(this->Item->GetNumberOfMissingRows(), 20);
  EXPECT_LT(this->Item->GetNumberOfMissingRows(), 40);
  // All stays inside, half a label apart.
  EXPECT_EQ(this->Count(0, 0, WIDTH * 0.37, HEIGHT, IsLit), 0);
  EXPECT_EQ(this->Count(0, HEIGHT * 0.64, WIDTH, HEIGHT, IsLit), 0);
}

TEST_F(Legend, LocationsAreThoseOfScalarBars)
{
  this->Add("warm", 150, 0, { { 1, 0, 0 } });
  const struct
  {
    int Location;
    bool Left, Right, Lower, Upper;
  } cases[] = { { vtkTFCLegendItem::LowerLeftCorner, true, false, true, false },
    { vtkTFCLegendItem::LowerRightCorner, false, true, true, false },
    { vtkTFCLegendItem::UpperLeftCorner, true, false, false, true },
    { vtkTFCLegendItem::UpperRightCorner, false, true, false, true } };
  for (const auto& c : cases)
  {
    this->Item->SetLocation(c.Location);
    this->Render();
    EXPECT_EQ(this->Count(0, 0, WIDTH / 2, HEIGHT, IsLit) > 0, c.Left) << c.Location;
    EXPECT_EQ(this->Count(WIDTH / 2, 0, WIDTH, HEIGHT, IsLit) > 0, c.Right) << c.Location;
    EXPECT_EQ(this->Count(0, 0, WIDTH, HEIGHT / 2, IsLit) > 0, c.Lower) << c.Location;
    EXPECT_EQ(this->Count(0, HEIGHT / 2, WIDTH, HEIGHT, IsLit) > 0, c.Upper) << c.Location;
  }
  this->Item->SetLocation(vtkTFCLegendItem::AnyLocation);
  this->Item->SetPosition(0.25, 0.5);
  this->Render();
  EXPECT_EQ(this->Count(0, 0, WIDTH * 0.24, HEIGHT, IsLit), 0);
  EXPECT_EQ(this->Count(0, 0, WIDTH, HEIGHT * 0.49, IsLit), 0);
  EXPECT_GT(this->Count(0, 0, WIDTH, HEIGHT, IsLit), 100);
}

TEST_F(Legend, AutomaticRangesGiveNumbersOnceTheyAreKnown)
{
  this->Add("warm", 150, 0, { { 1, 0, 0 } });
  this->Model->ClearAxisRange(0);
  this->Model->ClearAxisRange(1);
  this->Render();
  const int without = this->Count(0, 0, WIDTH, HEIGHT, IsLit);
  const double primary[2] = { 100, 200 };
  const double secondary[2] = { -1, 1 };
  this->Item->SetAutomaticRanges(primary, secondary);
  this->Render("legend_automatic");
  EXPECT_GT(this->Count(0, 0, WIDTH, HEIGHT, IsLit), without + 100);
  const auto center = this->ToPixel(150, 0);
  EXPECT_TRUE(IsRed(this->At(center[0], center[1])));
}

TEST_F(Legend, ASmallOneHasRoomForTheRegions)
{
  this->Add("warm", 130, -0.4, { { 1, 0, 0 } });
  this->Item->SetFontSize(24);
  this->Item->SetSize(0.3, 0.3);
  this->Render("legend_small");
  const auto& plot = this->Item->GetPlot();
  EXPECT_GT(plot[2], 40);
  EXPECT_GT(plot[3], 80);
}

TEST_F(Legend, FollowsEditsOfTheModel)
{
  vtkTFCRegion* region = this->Add("warm", 130, -0.4, { { 1, 0, 0 } });
  this->Render();
  vtkTFCEllipseShape::SafeDownCast(region->GetShape())->SetCenter(170, 0.4);
  region->SetColor(0, 1, 0);
  this->Render();
  const auto before = this->ToPixel(130, -0.4);
  const auto after = this->ToPixel(170, 0.4);
  EXPECT_FALSE(IsLit(this->At(before[0], before[1])));
  EXPECT_TRUE(IsGreen(this->At(after[0], after[1])));
}
