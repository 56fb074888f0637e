// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCVisibilityOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using vtkTFCVisibilityOrder::Box;
using vtkTFCVisibilityOrder::Eye;

namespace
{

//------------------------------------------------------------------------------
// Cut a box at random planes into boxes that fill it.
void CutBox(const Box& box, int depth, std::mt19937& random, std::vector<Box>& boxes)
{
  if (depth == 0)
  {
    boxes.push_back(box);
    return;
  }
  const int axis = static_cast<int>(random() % 3);
  const double at = std::uniform_real_distribution<>(0.2, 0.8)(random);
  const double plane = box[2 * axis] + at * (box[2 * axis + 1] - box[2 * axis]);
  Box low = box;
  Box high = box;
  low[2 * axis + 1] = plane;
  high[2 * axis] = plane;
  CutBox(low, depth - 1, random, boxes);
  CutBox(high, depth - 1, random, boxes);
}

//------------------------------------------------------------------------------
// Where a ray enters a box, or a negative number.
double FindEntry(const Box& box, const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  double enter = 0;
  double leave = 1e9;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = (box[2 * axis] - from[axis]) / to[axis];
    const double b = (box[2 * axis + 1] - from[axis]) / to[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return leave > enter + 1e-9 ? enter : -1.0;
}

//------------------------------------------------------------------------------
// On every ray, a box that is entered later must have been drawn before.
void ExpectRaysInOrder(const std::vector<Box>& boxes, const Eye& eye, std::mt19937& random)
{
  const std::vector<int> order = vtkTFCVisibilityOrder::Find(boxes, eye);
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (size_t i = 0; i < boxes.size(); ++i)
  {
    ASSERT_EQ(sorted[i], static_cast<int>(i));
  }
  std::uniform_real_distribution<> unit(-1, 1);
  for (int ray = 0; ray < 300; ++ray)
  {
    std::array<double, 3> from = eye.Place;
    std::array<double, 3> to = { unit(random), unit(random), unit(random) };
    if (eye.Parallel)
    {
      to = eye.Place;
      for (int axis = 0; axis < 3; ++axis)
      {
        from[axis] = 3 * unit(random) - 20 * to[axis];
      }
    }
    double last = 1e9;
    for (const int i : order)
    {
      const double entry = FindEntry(boxes[i], from, to);
      if (entry >= 0)
      {
        ASSERT_LE(entry, last + 1e-9);
        last = entry;
      }
    }
  }
}

}

TEST(VisibilityOrder, FarBoxesComeFirstOnEveryRay)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<> place(-3, 3);
  for (int round = 0; round < 20; ++round)
  {
    std::vector<Box> boxes;
    CutBox({ -1, 1, -1, 1, -1, 1 }, 5, random, boxes);
    std::shuffle(boxes.begin(), boxes.end(), random);
    // Outside, and inside of the boxes.
    ExpectRaysInOrder(boxes, { { place(random), place(random), place(random) }, false }, random);
    ExpectRaysInOrder(boxes, { { place(random) / 4, place(random) / 4, place(random) / 4 }, false },
      random);
    ExpectRaysInOrder(boxes, { { place(random), place(random), place(random) }, true }, random);
  }
}

TEST(VisibilityOrder, AlongAnAxis)
{
  const std::vector<Box> slabs = { { 0, 1, 0, 1, 0, 1 }, { 0, 1, 0, 1, 1, 2 },
    { 0, 1, 0, 1, 2, 3 } };
  EXPECT_EQ(vtkTFCVisibilityOrder::Find(slabs, { { 0, 0, -1 }, true }),
    (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(vtkTFCVisibilityOrder::Find(slabs, { { 0, 0, 1 }, true }),
    (std::vector<int>{ 2, 1, 0 }));
}

TEST(VisibilityOrder, OverlapAndCirclesAreNoTrap)
{
  // Three bars, each in front of the next in a circle, and two equal boxes.
  const std::vector<Box> bars = { { 0, 3, 0, 1, 0, 1 }, { 2, 3, 0, 3, 1, 2 }, { 0, 3, 2, 3, 0, 1 },
    { 0, 1, 0, 3, 1, 2 }, { 0, 3, 0, 1, 0, 1 } };
  EXPECT_EQ(vtkTFCVisibilityOrder::Find(bars, { { 1, 2, 9 }, false }).size(), 5U);
  EXPECT_TRUE(vtkTFCVisibilityOrder::Find({}, { { 0, 0, 0 }, false }).empty());
}
