// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCVisibilityOrder.h"

#include <algorithm>
#include <numeric>

namespace
{

using vtkTFCVisibilityOrder::Box;
using vtkTFCVisibilityOrder::Eye;

//------------------------------------------------------------------------------
// Whether a line of sight may go through `box` and then through `other`, which do not overlap:
// along every axis on which they are apart, the eye must be on the far side of the box's face to
// the other.
bool Covers(const Box& box, const Box& other, const Eye& eye)
{
  bool apart = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Neighbours share a face up to the rounding of their origins.
    const double margin =
      1e-6 * std::min(box[2 * axis + 1] - box[2 * axis], other[2 * axis + 1] - other[2 * axis]);
    double before = 0; // how far the eye is behind the face
    if (box[2 * axis + 1] <= other[2 * axis] + margin)
    {
      before = eye.Parallel ? eye.Place[axis] : box[2 * axis + 1] - eye.Place[axis];
    }
    else if (other[2 * axis + 1] <= box[2 * axis] + margin)
    {
      before = eye.Parallel ? -eye.Place[axis] : eye.Place[axis] - box[2 * axis];
    }
    else
    {
      continue;
    }
    apart = true;
    if (!(before > 0.0))
    {
      return false;
    }
  }
  return apart;
}

//------------------------------------------------------------------------------
double Distance(const Box& box, const Eye& eye)
{
  double along = 0;
  double square = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double center = 0.5 * (box[2 * axis] + box[2 * axis + 1]);
    along += center * eye.Place[axis];
    square += (center - eye.Place[axis]) * (center - eye.Place[axis]);
  }
  return eye.Parallel ? along : square;
}

}

//------------------------------------------------------------------------------
std::vector<int> vtkTFCVisibilityOrder::Find(const std::vector<Box>& boxes, const Eye& eye)
{
  std::vector<int> candidates(boxes.size());
  std::iota(candidates.begin(), candidates.end(), 0);
  std::stable_sort(candidates.begin(), candidates.end(),
    [&](int a, int b) { return Distance(boxes[a], eye) > Distance(boxes[b], eye); });

  // A box is drawn once all are that it may cover.
  std::vector<int> waiting(boxes.size(), 0);
  std::vector<std::vector<int>> coverers(boxes.size());
  for (const int a : candidates)
  {
    for (const int b : candidates)
    {
      if (a != b && Covers(boxes[a], boxes[b], eye))
      {
        ++waiting[a];
        coverers[b].push_back(a);
      }
    }
  }
  std::vector<int> order;
  while (!candidates.empty())
  {
    auto next = std::find_if(candidates.begin(), candidates.end(),
      [&](int box) { return waiting[box] == 0; });
    next = next == candidates.end() ? candidates.begin() : next; // a circle
    order.push_back(*next);
    for (const int coverer : coverers[*next])
    {
      --waiting[coverer];
    }
    candidates.erase(next);
  }
  return order;
}
