// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTFCSparseHistogram and vtkTFCJointHistogram against counting sample by sample.
#include "FilterVolumes.h"

#include "Filters/vtkTFCJointHistogram.h"
#include "Filters/vtkTFCSparseHistogram.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkShortArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

using namespace testing_volumes;

namespace
{
constexpr int N = 23;
using Bins = std::map<std::pair<unsigned int, unsigned short>, double>;

/**
 * P (short), S (double, some NaN), T (float, some NaN and infinite), V (three components).
 */
vtkSmartPointer<vtkImageData> MakeAttributes()
{
  auto image = MakeImage(N, N, N);
  auto* points = image->GetPointData();
  points->AddArray(MakeArray<vtkShortArray>("P", N, N, N,
    [](int x, int y, int z) { return std::floor(20. * Noise(x, y, z)); }));
  points->AddArray(MakeArray("S", N, N, N,
    [](int x, int y, int z) { return x % 7 == 2 ? NaN : Noise(y, z, x) + 0.1 * x; }));
  points->AddArray(MakeArray<vtkFloatArray>("T", N, N, N,
    [](int x, int y, int z) {
      return y % 11 == 3 ? NaN : z % 13 == 5 ? HUGE_VAL : Noise(z, x, y) * 3.;
    }));
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("V");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    vectors->InsertNextTuple3(static_cast<double>(i % 5), -2., static_cast<double>(i % 3));
  }
  points->AddArray(vectors);
  return image;
}

struct Axis
{
  double Minimum, Maximum;
  int Count;
  int Bin(double v) const
  {
    return !(v >= Minimum && v <= Maximum) ? -1
      : Minimum == Maximum
      ? 0
      : std::min(Count - 1,
          static_cast<int>(std::floor((v - Minimum) / (Maximum - Minimum) * Count)));
  }
};

/**
 * The definition, sample by sample.
 */
Bins CountAll(const std::vector<std::array<double, 3>>& samples, const Axis axes[3])
{
  Bins bins;
  for (const auto& s : samples)
  {
    const int i = axes[0].Bin(s[0]), j = axes[1].Bin(s[1]), k = axes[2].Bin(s[2]);
    if (i >= 0 && j >= 0)
    {
      bins[{ static_cast<unsigned int>(j * axes[0].Count + i),
        static_cast<unsigned short>(k < 0 ? axes[2].Count : k) }] += 1.;
    }
  }
  return bins;
}

Bins GetBins(vtkTFCSparseHistogram* histogram)
{
  Bins bins;
  for (size_t e = 0; e < histogram->GetCounts().size(); ++e)
  {
    bins[{ histogram->GetCells()[e], histogram->GetTertiaryBins()[e] }] = histogram->GetCounts()[e];
  }
  EXPECT_EQ(bins.size(), histogram->GetCounts().size());
  return bins;
}

std::vector<std::array<double, 3>> GetSamples(vtkDataSetAttributes* data, const char* p,
  const char* s, const char* t)
{
  std::vector<std::array<double, 3>> samples;
  for (vtkIdType i = 0; i < data->GetArray(p)->GetNumberOfTuples(); ++i)
  {
    samples.push_back({ data->GetArray(p)->GetTuple1(i), data->GetArray(s)->GetTuple1(i),
      data->GetArray(t)->GetTuple1(i) });
  }
  return samples;
}

const Axis Axes[3] = { { -15., 50., 13 }, { 0., 3., 17 }, { -2., 4., 9 } };

void Prepare(vtkTFCJointHistogram* filter, vtkDataObject* input, bool ranges = true)
{
  const char* names[3] = { "P", "S", "T" };
  filter->SetInputDataObject(input);
  for (int axis = 0; axis < 3; ++axis)
  {
    filter->SetArray(axis, names[axis]);
    filter->SetNumberOfBins(axis, Axes[axis].Count);
    if (ranges)
    {
      filter->SetRange(axis, Axes[axis].Minimum, Axes[axis].Maximum);
    }
  }
}

/**
 * A small histogram with entries in cells 0, 0 and 5 of 2 * 3.
 */
void FillSmall(vtkTFCSparseHistogram* histogram)
{
  histogram->SetAxis(0, 0., 2., 2);
  histogram->SetAxis(1, -1., 2., 3);
  histogram->SetAxis(2, 10., 50., 4);
  EXPECT_TRUE(histogram->SetEntries({ 0, 0, 5 }, { 1, 4, 3 }, { 2., 3., 7. }));
}
}

TEST(SparseHistogram, PlaneAndConditional)
{
  vtkNew<vtkTFCSparseHistogram> histogram;
  FillSmall(histogram);
  double plane[6];
  histogram->GetPlane(plane);
  const double expected[6] = { 5, 0, 0, 0, 0, 7 };
  EXPECT_TRUE(std::equal(plane, plane + 6, expected));
  const float weights[6] = { 0.5f, 1, 1, 1, 1, 0.25f };
  double conditional[4];
  histogram->GetConditional(weights, conditional);
  const double tertiary[4] = { 0, 1, 0, 1.75 };
  EXPECT_TRUE(std::equal(conditional, conditional + 4, tertiary));
  EXPECT_EQ(histogram->GetTotal(), 12.);
  EXPECT_EQ(histogram->GetBin(0, 2.), 1);
  EXPECT_EQ(histogram->GetBin(0, 1.), 1);
  EXPECT_EQ(histogram->GetBin(0, -1e-9), -1);
  EXPECT_EQ(histogram->GetBin(1, NaN), -1);
  EXPECT_EQ(histogram->GetBinCenter(2, 1), 25.);
}

TEST(SparseHistogram, MergeSaveAndLoad)
{
  vtkNew<vtkTFCSparseHistogram> a, b, c;
  FillSmall(a);
  b->DeepCopy(a);
  EXPECT_TRUE(b->SetEntries({ 0, 4 }, { 1, 0 }, { 10., 1. }));
  EXPECT_TRUE(a->Merge(b));
  const Bins expected = { { { 0, 1 }, 12. }, { { 0, 4 }, 3. }, { { 4, 0 }, 1. }, { { 5, 3 }, 7. } };
  EXPECT_EQ(GetBins(a), expected);

  std::vector<unsigned char> buffer;
  a->Save(buffer);
  EXPECT_TRUE(c->Load(buffer));
  EXPECT_EQ(GetBins(c), expected);
  double range[2];
  c->GetRange(2, range);
  EXPECT_EQ(range[1], 50.);
  EXPECT_EQ(c->GetNumberOfBins(1), 3);

  // Every cut and every changed byte is either noticed or yields valid entries; nothing is lost.
  Errors errors(c);
  for (size_t length = 0; length < buffer.size(); ++length)
  {
    EXPECT_FALSE(c->Load(std::vector<unsigned char>(buffer.begin(), buffer.begin() + length)));
  }
  EXPECT_EQ(GetBins(c), expected);
  for (size_t at = 0; at < buffer.size(); ++at)
  {
    auto spoilt = buffer;
    spoilt[at] ^= 0x80;
    if (c->Load(spoilt))
    {
      for (const unsigned int cell : c->GetCells())
      {
        EXPECT_LT(cell, static_cast<unsigned int>(c->GetNumberOfBins(0) * c->GetNumberOfBins(1)));
      }
    }
  }
  EXPECT_TRUE(errors.Mention("no joint histogram"));
  EXPECT_TRUE(errors.Mention("byte order"));
}

TEST(SparseHistogram, BadInput)
{
  vtkNew<vtkTFCSparseHistogram> histogram;
  FillSmall(histogram);
  Errors errors(histogram);
  EXPECT_FALSE(histogram->SetEntries({ 1, 0 }, { 0, 0 }, { 1., 1. })) << "not sorted";
  EXPECT_FALSE(histogram->SetEntries({ 1, 1 }, { 2, 2 }, { 1., 1. })) << "twice";
  EXPECT_FALSE(histogram->SetEntries({ 6 }, { 0 }, { 1. })) << "no such cell";
  EXPECT_FALSE(histogram->SetEntries({ 0 }, { 5 }, { 1. })) << "no such bin";
  EXPECT_FALSE(histogram->SetEntries({ 0 }, { 0 }, { 0. })) << "nothing";
  EXPECT_FALSE(histogram->SetEntries({ 0 }, { 0, 1 }, { 1. })) << "lengths";
  EXPECT_EQ(histogram->GetNumberOfEntries(), 3);
  vtkNew<vtkTFCSparseHistogram> other;
  EXPECT_FALSE(histogram->Merge(other));
  EXPECT_FALSE(histogram->Merge(nullptr));
  EXPECT_TRUE(errors.Mention("same range and bins"));
  histogram->SetAxis(3, 0, 1, 5);
  EXPECT_TRUE(errors.Mention("axes are 0, 1 and 2"));
  histogram->SetAxis(0, 2, 1, 5);
  EXPECT_TRUE(errors.Mention("smaller one first"));
  histogram->SetAxis(0, 0, 1, 0);
  EXPECT_TRUE(errors.Mention("1 to 16384"));
  histogram->SetAxis(0, -1.7e308, 1.7e308, 4);
  EXPECT_TRUE(errors.Mention("longer"));
  EXPECT_EQ(histogram->GetNumberOfEntries(), 3) << "nothing has changed";
}

TEST(JointHistogram, CountsSampleBySample)
{
  const auto image = MakeAttributes();
  const auto expected = CountAll(GetSamples(image->GetPointData(), "P", "S", "T"), Axes);
  for (const int threads : { 1, 2, 4 })
  {
    const Threads limit(threads);
    vtkNew<vtkTFCJointHistogram> filter;
    Prepare(filter, image);
    filter->Update();
    EXPECT_EQ(GetBins(filter->GetHistogram()), expected);
    vtkTable* table = filter->GetOutput();
    ASSERT_EQ(table->GetNumberOfRows(), filter->GetHistogram()->GetNumberOfEntries());
    EXPECT_EQ(table->GetValueByName(3, "count").ToDouble(), filter->GetHistogram()->GetCounts()[3]);
    EXPECT_EQ(table->GetValueByName(3, "cell").ToUnsignedInt(),
      filter->GetHistogram()->GetCells()[3]);
  }
  // The plane does not depend on the third attribute.
  vtkNew<vtkTFCJointHistogram> with, without;
  Prepare(with, image);
  Prepare(without, image);
  without->SetArray(2, nullptr);
  with->Update();
  without->Update();
  std::vector<double> a(13 * 17), b(13 * 17);
  with->GetHistogram()->GetPlane(a.data());
  without->GetHistogram()->GetPlane(b.data());
  EXPECT_EQ(a, b);
  EXPECT_EQ(without->GetHistogram()->GetNumberOfBins(2), 1);
}

TEST(JointHistogram, RangesAreThoseOfFiniteValues)
{
  const auto image = MakeAttributes();
  vtkNew<vtkTFCJointHistogram> filter;
  Prepare(filter, image, false);
  filter->Update();
  const auto samples = GetSamples(image->GetPointData(), "P", "S", "T");
  Axis axes[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[axis] = { HUGE_VAL, -HUGE_VAL, Axes[axis].Count };
    for (const auto& s : samples)
    {
      if (std::isfinite(s[axis]))
      {
        axes[axis].Minimum = std::min(axes[axis].Minimum, s[axis]);
        axes[axis].Maximum = std::max(axes[axis].Maximum, s[axis]);
      }
    }
    double range[2];
    filter->GetHistogram()->GetRange(axis, range);
    EXPECT_EQ(range[0], axes[axis].Minimum);
    EXPECT_EQ(range[1], axes[axis].Maximum);
  }
  EXPECT_EQ(GetBins(filter->GetHistogram()), CountAll(samples, axes));
}

TEST(JointHistogram, BlankedAndDuplicatePointsAreLeftOut)
{
  const auto image = MakeAttributes();
  auto samples = GetSamples(image->GetPointData(), "P", "S", "T");
  Blank(image, [](vtkIdType i) { return i % 3 == 0; });
  for (size_t i = 0; i < samples.size(); i += 3)
  {
    samples[i][0] = NaN;
  }
  vtkNew<vtkTFCJointHistogram> filter;
  Prepare(filter, image);
  filter->Update();
  EXPECT_EQ(GetBins(filter->GetHistogram()), CountAll(samples, Axes));

  // The last layer belongs to someone else.
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    image->GetPointData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  for (vtkIdType i = static_cast<vtkIdType>(N) * N * (N - 1); i < ghosts->GetNumberOfValues(); ++i)
  {
    ghosts->SetValue(i, ghosts->GetValue(i) | vtkDataSetAttributes::DUPLICATEPOINT);
    samples[static_cast<size_t>(i)][0] = NaN;
  }
  ghosts->Modified();
  filter->Modified();
  filter->Update();
  EXPECT_EQ(GetBins(filter->GetHistogram()), CountAll(samples, Axes));
}

TEST(JointHistogram, CellsComponentsAndBlocks)
{
  const auto image = MakeAttributes();
  vtkNew<vtkTFCJointHistogram> filter;
  Prepare(filter, image, false);
  filter->SetArray(0, "V", 0);
  filter->SetArray(1, "V", -1);
  filter->SetArray(2, "V", 2);
  filter->Update();
  double range[2];
  filter->GetHistogram()->GetRange(1, range);
  EXPECT_EQ(range[0], 2.);
  EXPECT_NEAR(range[1], std::sqrt(16. + 4. + 4.), 1e-6);
  EXPECT_EQ(filter->GetHistogram()->GetTotal(), static_cast<double>(N * N * N));

  auto cells = vtkSmartPointer<vtkImageData>::New();
  cells->SetDimensions(N + 1, N + 1, N + 1);
  for (const char* name : { "P", "S", "T" })
  {
    cells->GetCellData()->AddArray(image->GetPointData()->GetArray(name));
  }
  const auto expected = CountAll(GetSamples(image->GetPointData(), "P", "S", "T"), Axes);
  vtkNew<vtkTFCJointHistogram> ofCells;
  Prepare(ofCells, cells);
  ofCells->Update();
  EXPECT_EQ(GetBins(ofCells->GetHistogram()), expected);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(3);
  blocks->SetBlock(0, image);
  blocks->SetBlock(2, image);
  vtkNew<vtkTFCJointHistogram> ofBlocks;
  Prepare(ofBlocks, blocks);
  ofBlocks->Update();
  auto twice = expected;
  for (auto& entry : twice)
  {
    entry.second *= 2.;
  }
  EXPECT_EQ(GetBins(ofBlocks->GetHistogram()), twice);
}

TEST(JointHistogram, ConstantAxes)
{
  auto image = MakeImage(4, 4, 4);
  for (const char* name : { "P", "S", "T" })
  {
    image->GetPointData()->AddArray(MakeArray(name, 4, 4, 4, [](int, int, int) { return 7.; }));
  }
  vtkNew<vtkTFCJointHistogram> filter;
  Prepare(filter, image, false);
  filter->Update();
  EXPECT_EQ(GetBins(filter->GetHistogram()), (Bins{ { { 0, 0 }, 64. } }));
}

TEST(JointHistogram, BadInput)
{
  const auto image = MakeAttributes();
  image->GetPointData()->AddArray(MakeArray("empty", N, N, N, [](int, int, int) { return NaN; }));
  vtkNew<vtkDoubleArray> shorter;
  shorter->SetName("short");
  shorter->SetNumberOfTuples(5);
  image->GetPointData()->AddArray(shorter);
  vtkNew<vtkDoubleArray> onCells;
  onCells->SetName("cells");
  onCells->SetNumberOfTuples(image->GetNumberOfCells());
  image->GetCellData()->AddArray(onCells);
  const auto fails = [&](const std::function<void(vtkTFCJointHistogram*)>& change,
                       std::initializer_list<const char*> words, vtkDataObject* input = nullptr)
  {
    vtkNew<vtkTFCJointHistogram> filter;
    Prepare(filter, input ? input : image.Get());
    change(filter);
    Errors errors(filter);
    filter->Update();
    EXPECT_EQ(filter->GetHistogram()->GetNumberOfEntries(), 0);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
    for (const char* word : words)
    {
      EXPECT_TRUE(errors.Mention(word)) << word << " in " << errors.Text;
    }
  };
  fails([](auto* f) { f->SetArray(0, "nobody"); }, { "'nobody'", "'P'", "'cells'" });
  fails([](auto* f) { f->SetArray(0, "V", 3); }, { "no component '3'", "'V:2'" });
  fails([](auto* f) { f->SetArray(1, "cells"); },
    { "'cells' is a cell array", "Cell Data to Point" });
  fails([](auto* f) { f->SetArray(1, "short"); }, { "5 values", "12167 points" });
  fails([](auto* f) { f->SetArray(1, ""); }, { "secondary", "not set" });
  fails([](auto* f) { f->SetNumberOfBins(2, 0); }, { "Axis 2 has 0 bins" });
  fails([](auto* f) { f->SetRange(0, 3, 2); }, { "range of axis 0" });
  fails([](auto* f) { f->SetRange(0, NaN, 2); }, { "range of axis 0" });
  fails([](auto* f) { f->SetArray(2, "empty"), f->ClearRange(2); },
    { "'empty'", "no finite value" });
  fails([](auto*) {}, { "input is empty" }, vtkSmartPointer<vtkImageData>::New());
  vtkNew<vtkTFCJointHistogram> filter;
  Errors errors(filter);
  filter->SetArray(3, "P");
  EXPECT_TRUE(errors.Mention("no axis 3"));
}
