// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterVolumes.h"

#include "Filters/vtkTFCLocalStatistics.h"
#include "Filters/vtkTFCMaterialPhantom.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkShortArray.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

using namespace testing_volumes;

namespace
{
using Results = std::map<std::string, std::vector<float>>;

const std::vector<std::string> Suffixes{ "_mean", "_stddev", "_radius", "_skewness", "_kurtosis" };

/**
 * Sum of uniform numbers, nearly normal with mean 5 and deviation 1.
 */
double Normal(int x, int y, int z)
{
  double sum = 0.;
  for (int i = 0; i < 12; ++i)
  {
    sum += (Noise(x + 31 * i, y - 57 * i, z + 1000 * i) + 1.) / 4.;
  }
  return sum - 1.;
}

vtkSmartPointer<vtkTFCLocalStatistics> MakeFilter(double radius, double alpha = 0.01)
{
  auto filter = vtkSmartPointer<vtkTFCLocalStatistics>::New();
  filter->SetMaximumRadius(radius);
  filter->SetConfidenceLevel(alpha);
  filter->MomentsOn();
  return filter;
}

/**
 * All outputs by suffix; empty after an error.
 */
Results RunFilter(vtkTFCLocalStatistics* filter, vtkImageData* image,
  int association = vtkDataObject::POINT)
{
  Results results;
  Compute(filter, image, "a", association);
  for (const std::string& suffix : Suffixes)
  {
    auto* array = vtkFloatArray::SafeDownCast(
      filter->GetImageDataOutput()->GetAttributes(association)->GetArray(("a" + suffix).c_str()));
    if (array)
    {
      results[suffix].assign(array->GetPointer(0),
        array->GetPointer(0) + array->GetNumberOfValues());
    }
  }
  return results;
}

bool SameBits(const Results& a, const Results& b)
{
  return !a.empty() &&
    std::equal(a.begin(), a.end(), b.begin(), b.end(),
      [](const auto& p, const auto& q)
      {
        return p.second.size() == q.second.size() &&
          std::memcmp(p.second.data(), q.second.data(), p.second.size() * sizeof(float)) == 0;
      });
}

/**
 * `other`, whose sample at(i) is sample i of `results`: radii equal but for one in a thousand, and
 * where they are equal mean = scale * mean + shift and so on.
 */
void ExpectSame(const Results& results, const Results& other,
  const std::function<size_t(size_t)>& at, double scale = 1., double shift = 0.)
{
  ASSERT_EQ(results.size(), 5u);
  ASSERT_EQ(other.size(), 5u);
  const auto& radius = results.at("_radius");
  size_t differences = 0;
  const double sign = scale < 0. ? -1. : 1.;
  for (size_t i = 0; i < radius.size(); ++i)
  {
    const size_t j = at(i);
    if (radius[i] != other.at("_radius")[j])
    {
      ++differences;
      continue;
    }
    const double size = std::fabs(scale);
    ASSERT_NEAR(scale * results.at("_mean")[i] + shift, other.at("_mean")[j], 1e-5 * size);
    ASSERT_NEAR(size * results.at("_stddev")[i], other.at("_stddev")[j], 1e-5 * size);
    ASSERT_NEAR(sign * results.at("_skewness")[i], other.at("_skewness")[j], 1e-4);
    ASSERT_NEAR(results.at("_kurtosis")[i], other.at("_kurtosis")[j], 2e-4);
  }
  EXPECT_LE(differences, radius.size() / 1000);
}
}

TEST(LocalStatistics, ArraysAndDefaults)
{
  vtkNew<vtkTFCLocalStatistics> filter;
  EXPECT_EQ(filter->GetMaximumRadius(), 6.);
  EXPECT_EQ(filter->GetConfidenceLevel(), 0.001);
  EXPECT_FALSE(filter->GetMoments());
  EXPECT_EQ(filter->GetLengthUnit(), vtkTFCLocalStatistics::VOXELS);
  const auto image = MakeVolume(20, 12, 11, Normal);
  EXPECT_EQ(RunFilter(filter.Get(), image).size(), 3u);
  filter->MomentsOn();
  const auto results = RunFilter(filter.Get(), image);
  EXPECT_EQ(results.size(), 5u);
  const auto& radius = results.at("_radius");
  EXPECT_EQ(*std::max_element(radius.begin(), radius.end()), 6.f);
  EXPECT_GE(*std::min_element(radius.begin(), radius.end()), 1.f);
}

TEST(LocalStatistics, BitsDoNotDependOnThreadsOrInstructions)
{
  for (const auto& [holes, radius] :
    { std::pair(false, 5.), { true, 5. }, { false, 11. }, { true, 11. } })
  {
    const auto image = MakeVolume<vtkFloatArray>(75, 30, 23,
      [&, holed = holes](int x, int y, int z)
      { return holed && (x + 3 * y + 5 * z) % 97 == 0 ? NaN : Normal(x, y, z); });
    const auto expected = RunFilter(MakeFilter(radius), image);
    for (const int number : { 1, 2, 4 })
    {
      const Threads threads(number);
      EXPECT_TRUE(SameBits(expected, RunFilter(MakeFilter(radius), image))) << number;
    }
    for (const char* level : { "baseline", "avx2", "avx512" })
    {
      const SimdLimit limit(level);
      EXPECT_TRUE(SameBits(expected, RunFilter(MakeFilter(radius), image))) << level;
    }
  }
}

TEST(LocalStatistics, CellsAndIntegers)
{
  const int n[3] = { 20, 14, 12 };
  const auto f = [](int x, int y, int z) { return std::floor(1000. * Normal(x, y, z)); };
  const auto points = RunFilter(MakeFilter(4.), MakeVolume<vtkFloatArray>(n[0], n[1], n[2], f));
  const auto image = MakeImage(n[0] + 1, n[1] + 1, n[2] + 1);
  image->GetCellData()->AddArray(MakeArray<vtkShortArray>("a", n[0], n[1], n[2], f));
  EXPECT_TRUE(SameBits(points, RunFilter(MakeFilter(4.), image, vtkDataObject::CELL)));
}

TEST(LocalStatistics, BlankedPointsAreNaN)
{
  const auto hidden = [](vtkIdType i) { return i % 11 == 3; };
  const auto f = [&](int x, int y, int z)
  { return hidden(x + 20 * (y + 14 * z)) ? NaN : Normal(x, y, z); };
  const auto expected = RunFilter(MakeFilter(4.), MakeVolume<vtkFloatArray>(20, 14, 12, f));
  const auto image = MakeVolume<vtkFloatArray>(20, 14, 12, Normal);
  Blank(image, hidden);
  const auto results = RunFilter(MakeFilter(4.), image);
  EXPECT_TRUE(SameBits(expected, results));
  for (const auto& entry : results)
  {
    for (size_t i = 0; i < entry.second.size(); ++i)
    {
      EXPECT_EQ(std::isnan(entry.second[i]), hidden(static_cast<vtkIdType>(i)));
    }
  }
}

TEST(LocalStatistics, ConstantAndLonely)
{
  for (const auto& n : { std::array<int, 3>{ 20, 9, 8 }, std::array<int, 3>{ 1, 7, 40 },
         std::array<int, 3>{ 1, 1, 30 }, std::array<int, 3>{ 9, 1, 1 } })
  {
    const auto constant =
      RunFilter(MakeFilter(6.), MakeVolume(n[0], n[1], n[2], [](int, int, int) { return 0.1; }));
    ASSERT_EQ(constant.size(), 5u);
    for (size_t i = 0; i < constant.at("_mean").size(); ++i)
    {
      EXPECT_EQ(constant.at("_mean")[i], 0.1f);
      EXPECT_EQ(constant.at("_stddev")[i], 0.f);
      EXPECT_EQ(constant.at("_radius")[i], 6.f);
      EXPECT_EQ(constant.at("_skewness")[i], 0.f);
      EXPECT_EQ(constant.at("_kurtosis")[i], 3.f);
    }
  }
  // The only valid voxel, and the only voxel.
  const auto lonely = RunFilter(MakeFilter(3.),
    MakeVolume(5, 5, 5, [](int x, int y, int z) { return x * y * z == 8 ? 4. : NaN; }));
  EXPECT_EQ(lonely.at("_mean")[62], 4.f);
  EXPECT_EQ(lonely.at("_stddev")[62], 0.f);
  EXPECT_EQ(lonely.at("_radius")[62], 3.f);
  const auto only =
    RunFilter(MakeFilter(1.), MakeVolume(1, 1, 1, [](int, int, int) { return -3.; }));
  EXPECT_EQ(only.at("_mean")[0], -3.f);
}

TEST(LocalStatistics, FlipsAndTransposes)
{
  const int n = 24;
  const auto expected = RunFilter(MakeFilter(5.), MakeVolume(n, n, n, Normal));
  const auto flipped = RunFilter(MakeFilter(5.),
    MakeVolume(n, n, n, [&](int x, int y, int z) { return Normal(n - 1 - x, y, n - 1 - z); }));
  ExpectSame(expected, flipped,
    [&](size_t i) { return (n - 1 - i % n) + n * (i / n % n + n * (n - 1 - i / (n * n))); });
  const auto transposed = RunFilter(MakeFilter(5.),
    MakeVolume(n, n, n, [](int x, int y, int z) { return Normal(z, x, y); }));
  ExpectSame(expected, transposed,
    [&](size_t i) { return i / n % n + n * (i / (n * n) + n * (i % n)); });
}

TEST(LocalStatistics, AffineIntensity)
{
  const auto expected = RunFilter(MakeFilter(5.), MakeVolume(30, 24, 22, Normal));
  const std::array<double, 2> maps[] = { { -2., 0. }, { 1., -3. }, { 1e-6, 1e-7 }, { -1e30, 0. } };
  for (const auto& map : maps)
  {
    const auto results = RunFilter(MakeFilter(5.),
      MakeVolume(30, 24, 22,
        [&](int x, int y, int z) { return map[0] * Normal(x, y, z) + map[1]; }));
    ExpectSame(
      expected, results, [](size_t i) { return i; }, map[0], map[1]);
  }
}

TEST(LocalStatistics, WorldUnits)
{
  // Where the spacing is the same along all axes, it is a factor of lengths.
  const auto image = MakeVolume(24, 20, 18, Normal);
  const auto voxels = RunFilter(MakeFilter(4.), image);
  image->SetSpacing(0.3, 0.3, 0.3);
  EXPECT_TRUE(SameBits(voxels, RunFilter(MakeFilter(4.), image)));
  auto filter = MakeFilter(1.2);
  filter->SetLengthUnit(vtkTFCLocalStatistics::WORLD);
  auto world = RunFilter(filter, image);
  for (float& radius : world.at("_radius"))
  {
    radius = std::round(radius / 0.3f);
  }
  EXPECT_TRUE(SameBits(voxels, world));
  // A slice far from the next one is a sphere's only slice.
  image->SetSpacing(1., 1., 10.);
  filter->SetMaximumRadius(4.);
  const auto flat = RunFilter(filter, image);
  const auto slice = RunFilter(filter,
    []
    {
      auto single = MakeVolume(24, 20, 1, [](int x, int y, int) { return Normal(x, y, 5); });
      single->SetSpacing(1., 1., 0.);
      return single;
    }());
  for (size_t i = 0; i < 24 * 20; ++i)
  {
    EXPECT_EQ(flat.at("_radius")[5 * 24 * 20 + i], slice.at("_radius")[i]);
    EXPECT_NEAR(flat.at("_mean")[5 * 24 * 20 + i], slice.at("_mean")[i], 1e-6);
  }
}

TEST(LocalStatistics, PartOfTheExtent)
{
  const auto image = MakeVolume(30, 20, 16, Normal);
  const auto whole = RunFilter(MakeFilter(4.), image);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  producer->SetWholeExtent(image->GetExtent());
  auto filter = MakeFilter(4.);
  filter->SetInputConnection(producer->GetOutputPort());
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::POINT, "a");
  const int extent[6] = { 8, 20, 0, 7, 9, 15 };
  filter->UpdateExtent(extent);
  auto* part = filter->GetImageDataOutput();
  auto* means = part->GetPointData()->GetArray("a_mean");
  ASSERT_NE(means, nullptr);
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int x = extent[0]; x <= extent[1]; ++x)
    {
      int at[3] = { x, 3, z };
      const vtkIdType i = (x - 3) + 30 * (5 + vtkIdType{ 20 } * (z - 7));
      EXPECT_EQ(static_cast<float>(means->GetTuple1(part->ComputePointId(at))),
        whole.at("_mean")[static_cast<size_t>(i)]);
    }
  }
}

TEST(LocalStatistics, PhantomMediansAreTheTruth)
{
  // At half the size that the truth was measured at; spheres A and C are too small for a core.
  const int n = 128;
  vtkNew<vtkTFCMaterialPhantom> phantom;
  phantom->SetDimensions(n, n, n);
  phantom->Update();
  auto filter = MakeFilter(6., 0.1);
  filter->SetInputConnection(phantom->GetOutputPort());
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::POINT, "intensity");
  filter->Update();
  auto* data = filter->GetImageDataOutput()->GetPointData();
  // Cores by their distance from the centre, in voxels of n = 128; see TFCPhantom.h.
  struct Core
  {
    double Center[3], Low, High, Mean, Deviation;
  };
  const Core cores[] = { { { 0, 0, 0 }, 0.95, 2., 0.2, 0.1414 },
    { { 0, 0, 0 }, 0.76, 0.79, 0.6, 0.1118 }, { { -.2, -.2, 0 }, 0., 0.18, 0.8, 0.1315 } };
  for (const Core& core : cores)
  {
    std::vector<double> means, deviations;
    for (int i = 0; i < n * n * n; ++i)
    {
      const int index[3] = { i % n, i / n % n, i / (n * n) };
      double squared = 0.;
      for (int a = 0; a < 3; ++a)
      {
        const double d = 2. * (index[a] + 0.5) / n - 1. - core.Center[a];
        squared += d * d;
      }
      if (squared >= core.Low * core.Low && squared <= core.High * core.High)
      {
        means.push_back(data->GetArray("intensity_mean")->GetTuple1(i));
        deviations.push_back(data->GetArray("intensity_stddev")->GetTuple1(i));
      }
    }
    ASSERT_GT(means.size(), 500u);
    for (auto* values : { &means, &deviations })
    {
      std::nth_element(values->begin(), values->begin() + values->size() / 2, values->end());
    }
    EXPECT_NEAR(means[means.size() / 2], core.Mean, 0.005);
    EXPECT_NEAR(deviations[deviations.size() / 2], core.Deviation, 0.004);
  }
}

TEST(LocalStatistics, WrongParameters)
{
  const auto image = MakeVolume(9, 12, 4, Normal);
  const auto refuses = [&](vtkTFCLocalStatistics* filter, const std::string& what)
  {
    const Errors errors(filter);
    EXPECT_TRUE(RunFilter(filter, image).empty());
    EXPECT_TRUE(errors.Mention(what)) << "expected: " << what << "\nreported: " << errors.Text;
  };
  for (const double radius : { 0., -3., 0.99, NaN, static_cast<double>(INFINITY) })
  {
    refuses(MakeFilter(radius), "MaximumRadius is ");
  }
  refuses(MakeFilter(12.5), "MaximumRadius is 12.5 voxels, but the largest side of 'a' is 12");
  refuses(MakeFilter(1e300), "but the largest side");
  EXPECT_EQ(RunFilter(MakeFilter(12.), image).size(), 5u);
  for (const double alpha : { 0., 1., -0.1, 2., NaN })
  {
    refuses(MakeFilter(3., alpha), "ConfidenceLevel is ");
  }
  for (const double alpha : { 1e-300, 1. - 1e-9 })
  {
    EXPECT_EQ(RunFilter(MakeFilter(3., alpha), image).size(), 5u);
  }
  image->SetSpacing(0.5, 2., 0.7);
  const auto filter = MakeFilter(0.4);
  filter->SetLengthUnit(vtkTFCLocalStatistics::WORLD);
  refuses(filter, "smallest spacing of the volume is 0.5");
  filter->SetMaximumRadius(25.);
  refuses(filter, "25 world units, but the largest side of 'a' is 24");
}

TEST(LocalStatistics, ProgressAndAbort)
{
  const auto image = MakeVolume<vtkFloatArray>(64, 64, 64, Normal);
  const auto filter = MakeFilter(6.);
  std::vector<double> seen;
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(&seen);
  progress->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* data)
    {
      static_cast<std::vector<double>*>(client)->push_back(*static_cast<double*>(data));
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(*static_cast<double*>(data) > 0.5);
    });
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  EXPECT_TRUE(RunFilter(filter, image).empty());
  EXPECT_GT(seen.size(), 3u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_GT(*std::max_element(seen.begin(), seen.end()), 0.5);
}
