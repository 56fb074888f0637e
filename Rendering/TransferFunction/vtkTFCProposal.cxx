// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCProposal.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkTFCEllipseShape.h"
#include "vtkTFCRegion.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkTFCProposal);

namespace
{
constexpr int GRID = 64;
constexpr int SMOOTHINGS = 4; // of variance 1 each: a standard deviation of 2 bins
constexpr double BACKGROUND_SHARE = 0.25;
constexpr double WIDTH = 2.5; // standard deviations
// Ratio of a peak to its pass: a clear one, and one that will do while there are fewer than ENOUGH.
constexpr double CLEAR = 3;
constexpr double WEAK = 1.1;
constexpr size_t ENOUGH = 2;
constexpr double APART = 0.08; // axis units

using Plane = std::vector<double>;

struct Peak
{
  int Cell = 0;
  double Height = 0; // logarithm
  double Pass = 0;   // logarithm; where it meets a higher one
  double Count = 0;
  double Center[2] = { 0, 0 }; // axis units
  double Radii[2] = { 0, 0 };
  double Angle = 0;
};

Plane Coarsen(vtkTFCSparseHistogram* histogram)
{
  const int nx = histogram->GetNumberOfBins(0);
  const int ny = histogram->GetNumberOfBins(1);
  Plane fine(static_cast<size_t>(nx) * ny);
  histogram->GetPlane(fine.data());
  Plane coarse(static_cast<size_t>(GRID) * GRID, 0.);
  for (int j = 0; j < ny; ++j)
  {
    for (int i = 0; i < nx; ++i)
    {
      // By the centre of the bin: bins need not be a multiple of the grid.
      const int x = static_cast<int>((i + 0.5) * GRID / nx);
      const int y = static_cast<int>((j + 0.5) * GRID / ny);
      coarse[static_cast<size_t>(y) * GRID + x] += fine[static_cast<size_t>(j) * nx + i];
    }
  }
  return coarse;
}

// Binomial weights 1 4 6 4 1 along one axis; the border is repeated.
Plane Smooth(const Plane& plane, int dx, int dy)
{
  static const double weights[5] = { 1 / 16., 4 / 16., 6 / 16., 4 / 16., 1 / 16. };
  Plane result(plane.size());
  for (int j = 0; j < GRID; ++j)
  {
    for (int i = 0; i < GRID; ++i)
    {
      double sum = 0;
      for (int k = -2; k <= 2; ++k)
      {
        const int x = std::clamp(i + k * dx, 0, GRID - 1);
        const int y = std::clamp(j + k * dy, 0, GRID - 1);
        sum += weights[k + 2] * plane[static_cast<size_t>(y) * GRID + x];
      }
      result[static_cast<size_t>(j) * GRID + i] = sum;
    }
  }
  return result;
}

int Find(std::vector<int>& parents, int i)
{
  while (parents[i] != i)
  {
    i = parents[i] = parents[parents[i]];
  }
  return i;
}

// Cells from high to low join the basin of a neighbour; where two basins meet is the pass of the
// lower one. `basin` becomes the peak's cell of every cell above its own pass.
std::vector<Peak> FindPeaks(const Plane& heights, std::vector<int>& basin)
{
  const int size = GRID * GRID;
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b) { return heights[a] > heights[b]; });
  std::vector<int> parents(size, -1);
  basin.assign(size, -1);
  std::vector<Peak> peaks;
  std::vector<int> peakOf(size, -1);
  for (int cell : order)
  {
    if (!(heights[cell] > 0))
    {
      break;
    }
    std::vector<int> roots;
    for (int dy = -1; dy <= 1; ++dy)
    {
      for (int dx = -1; dx <= 1; ++dx)
      {
        const int x = cell % GRID + dx;
        const int y = cell / GRID + dy;
        if (x >= 0 && x < GRID && y >= 0 && y < GRID && parents[y * GRID + x] >= 0)
        {
          roots.push_back(Find(parents, y * GRID + x));
        }
      }
    }
    if (roots.empty())
    {
      parents[cell] = basin[cell] = cell;
      Peak peak;
      peak.Cell = cell;
      peak.Height = heights[cell];
      peakOf[cell] = static_cast<int>(peaks.size());
      peaks.push_back(peak);
      continue;
    }
    // The highest of them takes the others in.
    const int highest = *std::max_element(roots.begin(), roots.end(),
      [&](int a, int b) { return heights[a] < heights[b] || (heights[a] == heights[b] && a > b); });
    for (int root : roots)
    {
      if (root != highest && parents[root] == root)
      {
        peaks[peakOf[root]].Pass = heights[cell];
        parents[root] = highest;
      }
    }
    parents[cell] = basin[cell] = highest;
  }
  return peaks;
}

void Measure(Peak& peak, const Plane& counts, const Plane& heights, const std::vector<int>& basin)
{
  const double level = std::max(peak.Pass, peak.Height - std::log(10.));
  double mean[2] = { 0, 0 };
  double square[3] = { 0, 0, 0 };
  for (int cell = 0; cell < GRID * GRID; ++cell)
  {
    if (basin[cell] == peak.Cell && heights[cell] >= level)
    {
      const int row = cell / GRID;
      const double x = (cell % GRID + 0.5) / GRID;
      const double y = (row + 0.5) / GRID;
      const double n = counts[cell];
      peak.Count += n;
      mean[0] += n * x;
      mean[1] += n * y;
      square[0] += n * x * x;
      square[1] += n * x * y;
      square[2] += n * y * y;
    }
  }
  if (!(peak.Count > 0))
  {
    return;
  }
  mean[0] /= peak.Count;
  mean[1] /= peak.Count;
  const double xx = square[0] / peak.Count - mean[0] * mean[0];
  const double xy = square[1] / peak.Count - mean[0] * mean[1];
  const double yy = square[2] / peak.Count - mean[1] * mean[1];
  // Axes of the covariance: eigenvalues of a symmetric 2 x 2 matrix.
  const double middle = (xx + yy) / 2;
  const double spread = std::hypot((xx - yy) / 2, xy);
  const double narrowest = 1.5 / GRID;
  std::copy(mean, mean + 2, peak.Center);
  peak.Radii[0] = std::clamp(WIDTH * std::sqrt(std::max(0., middle + spread)), narrowest, 0.35);
  peak.Radii[1] = std::clamp(WIDTH * std::sqrt(std::max(0., middle - spread)), narrowest, 0.35);
  peak.Angle = vtkMath::DegreesFromRadians(0.5 * std::atan2(2 * xy, xx - yy));
}
}

//------------------------------------------------------------------------------
int vtkTFCProposal::ProposeRegions(vtkTFCSparseHistogram* histogram, vtkTFCTransferFunction* tf)
{
  if (!histogram || !tf || histogram->GetNumberOfEntries() == 0)
  {
    return 0;
  }
  const Plane counts = Coarsen(histogram);
  const double total = std::accumulate(counts.begin(), counts.end(), 0.);
  Plane heights = counts;
  for (int i = 0; i < SMOOTHINGS; ++i)
  {
    heights = Smooth(Smooth(heights, 1, 0), 0, 1);
  }
  for (double& height : heights)
  {
    height = std::log1p(height);
  }
  std::vector<int> basin;
  std::vector<Peak> peaks = FindPeaks(heights, basin);
  const auto prominence = [](const Peak& peak) { return peak.Height - peak.Pass; };
  for (Peak& peak : peaks)
  {
    Measure(peak, counts, heights, basin);
  }
  // The first one is the highest.
  const Peak highest = peaks[0];
  if (highest.Count > BACKGROUND_SHARE * total)
  {
    peaks.erase(peaks.begin());
  }
  std::stable_sort(peaks.begin(), peaks.end(),
    [&](const Peak& a, const Peak& b) { return prominence(a) > prominence(b); });
  std::vector<Peak> chosen;
  for (const Peak& peak : peaks)
  {
    const bool apart = std::none_of(chosen.begin(), chosen.end(),
      [&](const Peak& other)
      {
        return std::hypot(peak.Center[0] - other.Center[0], peak.Center[1] - other.Center[1]) <
          APART + other.Radii[1];
      });
    const double least = std::log(chosen.size() < ENOUGH ? WEAK : CLEAR);
    if (peak.Count > 0 && apart && prominence(peak) > least &&
      chosen.size() < static_cast<size_t>(this->MaximumNumberOfRegions))
    {
      chosen.push_back(peak);
    }
  }
  if (chosen.empty())
  {
    chosen.push_back(highest);
  }

  double x[2];
  double y[2];
  histogram->GetRange(0, x);
  histogram->GetRange(1, y);
  tf->RemoveAllRegions();
  int number = 0;
  for (const Peak& peak : chosen)
  {
    vtkTFCRegion* region = tf->AddNewRegion("ellipse");
    auto* ellipse = vtkTFCEllipseShape::SafeDownCast(region->GetShape());
    ellipse->SetCenter(x[0] + peak.Center[0] * (x[1] - x[0]),
      y[0] + peak.Center[1] * (y[1] - y[0]));
    ellipse->SetRadii(peak.Radii[0] * (x[1] - x[0]), peak.Radii[1] * (y[1] - y[0]));
    ellipse->SetAngle(peak.Angle);
    double color[3];
    vtkTFCRegion::GetPaletteColor(number++, color);
    region->SetColor(color[0], color[1], color[2]);
    region->SetName(("peak " + std::to_string(number)).c_str());
    region->SetFalloff(vtkTFCRegion::Smooth, 0.5);
    region->SetOpacity(
      std::clamp(std::round(2000 / (std::max(1., peak.Count) / total * 1e3)) / 100, 0.02, 0.4));
  }
  tf->SetProposal(true);
  return number;
}

//------------------------------------------------------------------------------
void vtkTFCProposal::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumNumberOfRegions: " << this->MaximumNumberOfRegions << "\n";
}
