// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Proposed regions: normal populations whose places and spreads are known; marks in the state.
#include "vtkNew.h"
#include "vtkTFCEllipseShape.h"
#include "vtkTFCProposal.h"
#include "vtkTFCRegion.h"
#include "vtkTFCSparseHistogram.h"
#include "vtkTFCTransferFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
struct Population
{
  double X, Y, SX, SY, Size;
};

// Expected counts of normal populations on 256 x 256 bins of [-100, 100] x [0, 1].
void Fill(vtkTFCSparseHistogram* histogram, const std::vector<Population>& populations)
{
  histogram->SetAxis(0, -100, 100, 256);
  histogram->SetAxis(1, 0, 1, 256);
  std::vector<unsigned int> cells;
  std::vector<double> counts;
  for (int j = 0; j < 256; ++j)
  {
    for (int i = 0; i < 256; ++i)
    {
      double count = 0;
      for (const Population& p : populations)
      {
        const double x = (histogram->GetBinCenter(0, i) - p.X) / p.SX;
        const double y = (histogram->GetBinCenter(1, j) - p.Y) / p.SY;
        count += p.Size * std::exp(-(x * x + y * y) / 2) / (p.SX / 200 * p.SY * 256 * 256 * 6.2832);
      }
      if (std::floor(count) > 0)
      {
        cells.push_back(j * 256 + i);
        counts.push_back(std::floor(count));
      }
    }
  }
  ASSERT_TRUE(histogram->SetEntries(cells, std::vector<unsigned short>(cells.size(), 0), counts));
}

void MakeAxes(vtkTFCTransferFunction* tf)
{
  tf->SetAxis(0, "a");
  tf->SetAxis(1, "b");
}
}

TEST(Proposal, FindsPopulationsButNotTheBackground)
{
  vtkNew<vtkTFCSparseHistogram> histogram;
  Fill(histogram,
    { { -80, 0.1, 6, 0.03, 6e6 }, { 20, 0.3, 8, 0.04, 1e6 }, { 60, 0.7, 8, 0.05, 2e5 } });
  vtkNew<vtkTFCTransferFunction> tf;
  MakeAxes(tf);
  vtkNew<vtkTFCProposal> proposal;
  ASSERT_EQ(proposal->ProposeRegions(histogram, tf), 2);
  EXPECT_TRUE(tf->GetProposal());
  const double expected[2][4] = { { 20, 0.3, 8, 0.04 }, { 60, 0.7, 8, 0.05 } };
  for (int i = 0; i < 2; ++i)
  {
    auto* ellipse = vtkTFCEllipseShape::SafeDownCast(tf->GetRegion(i)->GetShape());
    ASSERT_TRUE(ellipse);
    double center[2];
    ellipse->GetCenter(center);
    // A bin of the search is 1/64 of an axis.
    EXPECT_NEAR(center[0], expected[i][0], 200. / 64);
    EXPECT_NEAR(center[1], expected[i][1], 1. / 64);
    double radii[2];
    ellipse->GetRadii(radii);
    // 2.5 standard deviations of a normal peak down to a tenth of its height: between one and two
    // and a half, whatever axis is the longer one.
    const double longer = std::max(radii[0] / 200, radii[1]);
    const double sigma = std::max(expected[i][2] / 200, expected[i][3]);
    EXPECT_GT(longer, sigma);
    EXPECT_LT(longer, 2.6 * sigma);
  }
  EXPECT_LT(tf->GetRegion(0)->GetOpacity(), tf->GetRegion(1)->GetOpacity())
    << "the larger population hides more";
}

TEST(Proposal, OnePopulationIsBetterThanNone)
{
  vtkNew<vtkTFCSparseHistogram> histogram;
  Fill(histogram, { { 0, 0.5, 10, 0.05, 1e6 } });
  vtkNew<vtkTFCTransferFunction> tf;
  MakeAxes(tf);
  vtkNew<vtkTFCProposal> proposal;
  EXPECT_GE(proposal->ProposeRegions(histogram, tf), 1);
}

TEST(Proposal, AnEmptyHistogramChangesNothing)
{
  vtkNew<vtkTFCSparseHistogram> histogram;
  vtkNew<vtkTFCTransferFunction> tf;
  MakeAxes(tf);
  const std::string before = tf->GetState();
  vtkNew<vtkTFCProposal> proposal;
  EXPECT_EQ(proposal->ProposeRegions(histogram, tf), 0);
  EXPECT_EQ(proposal->ProposeRegions(nullptr, tf), 0);
  EXPECT_EQ(tf->GetState(), before);
}

TEST(Proposal, ItsMarkAndLocksAreInTheState)
{
  vtkNew<vtkTFCTransferFunction> tf;
  MakeAxes(tf);
  const std::string plain = tf->GetState();
  vtkTFCRegion* region = tf->AddNewRegion("ellipse");
  const std::string unlocked = tf->GetState();
  tf->SetProposal(true);
  region->SetLocked(true);
  vtkNew<vtkTFCTransferFunction> other;
  ASSERT_TRUE(other->SetState(tf->GetState().c_str()));
  EXPECT_TRUE(other->GetProposal());
  EXPECT_TRUE(other->GetRegion(0)->GetLocked());
  other->SetProposal(false);
  other->GetRegion(0)->SetLocked(false);
  EXPECT_EQ(other->GetState(), unlocked);
  EXPECT_NE(plain, unlocked);

  // A copy is a region of its own.
  vtkNew<vtkTFCRegion> copy;
  copy->DeepCopy(region);
  const int id = tf->AddRegion(copy);
  EXPECT_NE(id, region->GetId());
  EXPECT_NE(copy->GetShape(), region->GetShape());
  EXPECT_TRUE(copy->GetLocked());
  EXPECT_EQ(copy->GetName(), region->GetName());
}
