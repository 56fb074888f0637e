// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// The line over somebody else's chart: in which column of pixels it is, and when there is none.
#include "vtkTFCValueMark.h"

#include "vtkAxis.h"
#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

// A chart as ParaView's transfer function widget has it: hidden axes with a border of 8 pixels.
class ValueMark : public testing::Test
{
protected:
  static constexpr int Width = 300;
  static constexpr int Border = 8;

  ValueMark()
  {
    this->View->GetRenderWindow()->SetOffScreenRendering(1);
    this->View->GetRenderWindow()->SetSize(Width, 100);
    this->View->GetRenderWindow()->SetMultiSamples(0);
    this->View->GetRenderWindow()->SetDPI(72);
    this->Chart->SetRenderEmpty(true);
    this->Chart->SetAutoAxes(false);
    this->Chart->SetHiddenAxisBorder(Border);
    for (int i = 0; i < 4; ++i)
    {
      this->Chart->GetAxis(i)->SetVisible(false);
      this->Chart->GetAxis(i)->SetBehavior(vtkAxis::FIXED);
    }
    this->Chart->GetAxis(vtkAxis::BOTTOM)->SetUnscaledRange(-100, 300);
    this->View->GetScene()->AddItem(this->Chart);
    this->Mark->SetChart(this->Chart);
    this->View->GetScene()->AddItem(this->Mark);
  }

  // Columns with red in the middle of the picture's height.
  std::vector<int> RedColumns()
  {
    this->View->GetRenderWindow()->Render();
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(this->View->GetRenderWindow());
    grab->ReadFrontBufferOff();
    grab->Update();
    std::vector<int> columns;
    for (int x = 0; x < Width; ++x)
    {
      const auto channel = [&](int c)
      { return grab->GetOutput()->GetScalarComponentAsDouble(x, 40, 0, c); };
      if (channel(0) > channel(1) + 60)
      {
        columns.push_back(x);
      }
    }
    return columns;
  }

  vtkNew<vtkContextView> View;
  vtkNew<vtkChartXY> Chart;
  vtkNew<vtkTFCValueMark> Mark;
};

}

TEST_F(ValueMark, IsALineAtItsValue)
{
  for (double value : { -100.0, 0.0, 250.0, 300.0 })
  {
    EXPECT_TRUE(this->Mark->SetValue(value));
    EXPECT_FALSE(this->Mark->SetValue(value));
    const std::vector<int> columns = this->RedColumns();
    const double expected = Border + (value + 100) / 400 * (Width - 2 * Border);
    ASSERT_FALSE(columns.empty()) << value;
    EXPECT_LE(columns.back() - columns.front(), 2) << value;
    EXPECT_NEAR((columns.front() + columns.back()) / 2.0, expected, 1.5) << value;
    EXPECT_NEAR(this->Mark->GetPosition(), expected, 1) << value;
  }
  // The axis changes: the line follows.
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetUnscaledRange(200, 400);
  EXPECT_NEAR(this->RedColumns().front(), Border + 0.5 * (Width - 2 * Border), 2);
}

TEST_F(ValueMark, OutsideOfTheAxisIsNone)
{
  EXPECT_TRUE(this->RedColumns().empty()) << "no value yet";
  for (double value : { -100.1, 301.0, std::nan(""), HUGE_VAL })
  {
    this->Mark->SetValue(5);
    EXPECT_FALSE(this->RedColumns().empty());
    EXPECT_TRUE(this->Mark->SetValue(value));
    EXPECT_TRUE(this->RedColumns().empty()) << value;
    EXPECT_TRUE(std::isnan(this->Mark->GetPosition())) << value;
  }
  EXPECT_TRUE(this->Mark->SetValue(std::nan("")));
  EXPECT_FALSE(this->Mark->SetValue(std::nan("")));
  this->Mark->SetChart(nullptr);
  this->Mark->SetValue(5);
  EXPECT_TRUE(this->RedColumns().empty()) << "without a chart";
}
