// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Quantiles and maps of values against closed forms, and their note in a state.
#include "ModelTesting.h"
#include "vtkNew.h"
#include "vtkTFCQuantiles.h"
#include "vtkTFCTransferFunction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
std::vector<double> Sorted(std::mt19937& random, int n)
{
  std::uniform_real_distribution<double> value(-50, 200);
  std::vector<double> list;
  for (int i = 0; i < n; ++i)
  {
    list.push_back(value(random));
  }
  std::sort(list.begin(), list.end());
  return list;
}
}

TEST(Quantiles, OfAnEvenDistributionAreEven)
{
  const auto q = vtkTFCQuantiles::FromCounts(std::vector<double>(10, 7), -1, 4, 6);
  ASSERT_EQ(q.size(), 6U);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(q[i], -1 + i, 1e-12);
  }
}

TEST(Quantiles, SkipWhatIsEmpty)
{
  // Three quarters of the samples in the first bin of [0, 4], a quarter in the last.
  const auto q = vtkTFCQuantiles::FromCounts({ 3, 0, 0, 1 }, 0, 4, 5);
  const std::vector<double> expected = { 0, 1. / 3, 2. / 3, 1, 4 };
  ASSERT_EQ(q.size(), expected.size());
  for (size_t i = 0; i < q.size(); ++i)
  {
    EXPECT_NEAR(q[i], expected[i], 1e-12);
  }
  EXPECT_TRUE(vtkTFCQuantiles::FromCounts({ 0, 0 }, 0, 1).empty());
  EXPECT_TRUE(vtkTFCQuantiles::FromCounts({}, 0, 1).empty());
  EXPECT_TRUE(vtkTFCQuantiles::FromCounts({ 1, 2 }, 3, 3).empty());
  EXPECT_TRUE(vtkTFCQuantiles::FromCounts({ 1, 2 }, std::nan(""), 3).empty());
}

TEST(Quantiles, AgreeWithSortedSamplesWithinABin)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal(10, 3);
  std::vector<double> samples(20001);
  for (double& v : samples)
  {
    v = normal(random);
  }
  std::sort(samples.begin(), samples.end());
  const double low = samples.front();
  const double high = samples.back();
  std::vector<double> counts(512, 0);
  for (double v : samples)
  {
    counts[std::min(511, static_cast<int>((v - low) / (high - low) * 512))] += 1;
  }
  const auto q = vtkTFCQuantiles::FromCounts(counts, low, high);
  ASSERT_EQ(q.size(), 65U);
  EXPECT_TRUE(std::is_sorted(q.begin(), q.end()));
  for (size_t k = 0; k < q.size(); ++k)
  {
    EXPECT_NEAR(q[k], samples[(samples.size() - 1) * k / 64], 1.001 * (high - low) / 512);
  }
}

TEST(ValueMap, GoesFromListToListAndNeverDecreases)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial)
  {
    const auto from = Sorted(random, 17);
    const auto to = Sorted(random, 17);
    const vtkTFCValueMap map(from, to);
    for (size_t i = 0; i < from.size(); ++i)
    {
      EXPECT_NEAR(map(from[i]), to[i], 1e-10);
    }
    double before = map(-400);
    for (double v = -400; v < 500; v += 0.37)
    {
      EXPECT_GE(map(v), before);
      before = map(v);
    }
  }
}

TEST(ValueMap, IsTheIdentityForEqualLists)
{
  std::mt19937 random(2);
  const auto list = Sorted(random, 65);
  const vtkTFCValueMap map(list, list);
  EXPECT_TRUE(map.IsIdentity());
  EXPECT_EQ(map(0.1), 0.1);
  // What is no map changes nothing.
  EXPECT_EQ(vtkTFCValueMap({ 2, 2 }, { 0, 1 })(7), 7);
  EXPECT_EQ(vtkTFCValueMap({ 1, 2, 3 }, { 0, 1 })(7), 7);
  EXPECT_EQ(vtkTFCValueMap({}, {})(7), 7);
}

TEST(ValueMap, OfAffineDataIsAffine)
{
  std::mt19937 random(3);
  const auto from = Sorted(random, 65);
  std::vector<double> to;
  for (double v : from)
  {
    to.push_back(-7 + 0.25 * v);
  }
  const vtkTFCValueMap byQuantile(from, to);
  const vtkTFCValueMap byRange({ from.front(), from.back() }, { to.front(), to.back() });
  EXPECT_TRUE(byRange.IsAffine());
  for (double v = -300; v < 400; v += 1.7)
  {
    EXPECT_NEAR(byQuantile(v), -7 + 0.25 * v, 1e-10);
    EXPECT_NEAR(byRange(v), -7 + 0.25 * v, 1e-10);
  }
}

TEST(ValueMap, TakesEqualValuesToTheMiddle)
{
  const vtkTFCValueMap map({ 0, 1, 1, 1, 2 }, { 0, 10, 12, 20, 30 });
  EXPECT_EQ(map(1), 15);
  EXPECT_EQ(map(0.5), 7.5);
  EXPECT_EQ(map(2), 30);
}

TEST(Quantiles, AreKeptInTheState)
{
  vtkNew<vtkTFCTransferFunction> model;
  const std::string before = model->GetState();
  vtkTFCQuantiles::Store(model, { { "a \"b\"", -1, { 0.1, 0.2, 1e9 } }, { "T", 0, { 1, 2 } } });
  vtkNew<vtkTFCTransferFunction> copy;
  ASSERT_TRUE(copy->SetState(model->GetState().c_str()));
  const auto entries = vtkTFCQuantiles::Load(copy);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(vtkTFCQuantiles::Find(entries, "a \"b\"", -1), (std::vector<double>{ 0.1, 0.2, 1e9 }));
  EXPECT_TRUE(vtkTFCQuantiles::Find(entries, "T", 1).empty());
  vtkTFCQuantiles::Store(copy, {});
  EXPECT_EQ(copy->GetState(), before);
}

TEST(Quantiles, OfAnotherFormAreLeftOut)
{
  vtkNew<vtkTFCTransferFunction> model;
  for (const char* text : { "3", "[1, [2]]", "[{\"array\": \"a\"}]",
         "[{\"array\": \"a\", \"component\": 0, \"values\": [2, 1]}]",
         "[{\"array\": \"a\", \"component\": 0, \"values\": [1, \"x\"]}]",
         "[{\"array\": 5, \"component\": 0, \"values\": [1, 2]}]",
         "[{\"array\": \"a\", \"component\": 0.5, \"values\": [1, 2]}]" })
  {
    ASSERT_TRUE(model->SetNote("x-quantiles", text)) << text;
    EXPECT_TRUE(vtkTFCQuantiles::Load(model).empty()) << text;
  }
}

TEST(Notes, AreJsonUnderTheirKeys)
{
  vtkNew<vtkTFCTransferFunction> model;
  ModelTesting::Catcher errors(model);
  EXPECT_TRUE(model->SetNote("x-me", "{\"a\": [1, 2]}"));
  EXPECT_EQ(model->GetNote("x-me"), "{\"a\":[1,2]}");
  const vtkMTimeType time = model->GetMTime();
  EXPECT_TRUE(model->SetNote("x-me", "{\"a\":[1,2]}"));
  EXPECT_EQ(model->GetMTime(), time);
  const std::string state = model->GetState();
  EXPECT_EQ(errors.Errors, "");
  EXPECT_FALSE(model->SetNote("me", "1"));
  EXPECT_FALSE(model->SetNote(nullptr, "1"));
  EXPECT_FALSE(model->SetNote("x-me", "{"));
  EXPECT_FALSE(model->SetNote("x-me", "1, \"x-you\": 2"));
  EXPECT_FALSE(model->SetNote("x-\"", "1"));
  EXPECT_NE(errors.Errors.find("Expected a key that starts with x- and JSON"), std::string::npos);
  EXPECT_EQ(model->GetState(), state);
  EXPECT_TRUE(model->SetNote("x-me", ""));
  EXPECT_EQ(model->GetNote("x-me"), "");
}
