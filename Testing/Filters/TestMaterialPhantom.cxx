// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Golden values from an independent implementation in NumPy with the same counter-based noise.
#include "FilterVolumes.h"

#include "Filters/Kernels/TFCPhantom.h"
#include "Filters/vtkTFCMaterialPhantom.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace
{

const float* Intensity(vtkTFCMaterialPhantom* phantom)
{
  return vtkFloatArray::SafeDownCast(phantom->GetOutput()->GetPointData()->GetArray("intensity"))
    ->GetPointer(0);
}

const unsigned char* Material(vtkTFCMaterialPhantom* phantom)
{
  return vtkUnsignedCharArray::SafeDownCast(
    phantom->GetOutput()->GetPointData()->GetArray("material"))
    ->GetPointer(0);
}

struct Golden
{
  int Size;
  double Mean;
  double Deviation;
  std::array<int, 6> Counts;
};

class PhantomSizes : public testing::TestWithParam<Golden>
{
};

}

TEST_P(PhantomSizes, HaveTheGoldenStatistics)
{
  const Golden& golden = GetParam();
  vtkNew<vtkTFCMaterialPhantom> phantom;
  phantom->SetDimensions(golden.Size, golden.Size, golden.Size);
  phantom->Update();
  const vtkIdType count = phantom->GetOutput()->GetNumberOfPoints();
  const float* values = Intensity(phantom);
  const unsigned char* labels = Material(phantom);
  double sum = 0;
  double squares = 0;
  std::array<int, 6> counts = {};
  for (vtkIdType i = 0; i < count; ++i)
  {
    sum += values[i];
    squares += double(values[i]) * values[i];
    ++counts.at(labels[i]);
  }
  const double mean = sum / static_cast<double>(count);
  EXPECT_NEAR(mean, golden.Mean, 6e-7);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(count) - mean * mean), golden.Deviation,
    6e-6);
  EXPECT_EQ(counts, golden.Counts);
  EXPECT_FLOAT_EQ(values[0], 0.48170537F);
  EXPECT_FLOAT_EQ(values[1], 0.35510862F);
  EXPECT_FLOAT_EQ(values[2], 0.14351745F);
}

INSTANTIATE_TEST_SUITE_P(Three, PhantomSizes,
  testing::Values(Golden{ 32, .298880, .210591, { 22216, 4648, 5426, 72, 374, 32 } },
    Golden{ 64, .298371, .210763, { 177776, 37320, 43234, 576, 3004, 234 } },
    Golden{ 128, .297949, .210613, { 1422888, 297184, 346562, 4524, 24096, 1898 } }));

TEST(MaterialPhantom, APartIsWhatTheWholeHasThere)
{
  vtkNew<vtkTFCMaterialPhantom> whole;
  whole->SetDimensions(20, 17, 9);
  whole->Update();
  vtkNew<vtkTFCMaterialPhantom> part;
  part->SetDimensions(20, 17, 9);
  const int extent[6] = { 3, 11, 5, 16, 2, 4 };
  part->UpdateExtent(extent);
  ASSERT_EQ(part->GetOutput()->GetNumberOfPoints(), 9 * 12 * 3);
  vtkIdType i = 0;
  for (int z = 2; z <= 4; ++z)
  {
    for (int y = 5; y <= 16; ++y)
    {
      for (int x = 3; x <= 11; ++x, ++i)
      {
        const vtkIdType j = x + 20 * (y + 17 * z);
        ASSERT_EQ(Intensity(part)[i], Intensity(whole)[j]);
        ASSERT_EQ(Material(part)[i], Material(whole)[j]);
      }
    }
  }
}

TEST(MaterialPhantom, ElementaryFunctions)
{
  for (int i = 1; i < 100000; ++i)
  {
    const double u = i / 100000.;
    ASSERT_NEAR(tfc::PhantomLog(u), std::log(u), 4e-16 * std::max(1., -std::log(u)));
    ASSERT_NEAR(tfc::PhantomCosine(u), std::cos(2. * 3.14159265358979323846 * u), 1e-15);
  }
  for (const double u : { 0x1.0p-54, 0x1.fffffffffffffp-1, 0.5, std::sqrt(0.5) })
  {
    ASSERT_NEAR(tfc::PhantomLog(u), std::log(u), 1e-15 * std::max(1., -std::log(u)));
  }
  for (const std::uint64_t i : { 0ULL, 1ULL, 0xffffffffULL, 0x100000000ULL, 0x1fffffffffffffULL })
  {
    EXPECT_EQ(tfc::PhantomToDouble(i), static_cast<double>(i));
  }
}

TEST(MaterialPhantom, SameBitsOnEveryProcessor)
{
  const char* const levels[] = { "baseline", "avx2", "avx512" };
  vtkNew<vtkTFCMaterialPhantom> phantoms[3];
  for (int i = 0; i < 3; ++i)
  {
    const testing_volumes::SimdLimit limit(levels[i]);
    phantoms[i]->SetDimensions(301, 9, 8);
    phantoms[i]->Update();
  }
  for (vtkIdType j = 0; j < phantoms[0]->GetOutput()->GetNumberOfPoints(); ++j)
  {
    ASSERT_EQ(Intensity(phantoms[0])[j], Intensity(phantoms[1])[j]);
    ASSERT_EQ(Intensity(phantoms[0])[j], Intensity(phantoms[2])[j]);
    ASSERT_EQ(Material(phantoms[0])[j], Material(phantoms[2])[j]);
  }
}

TEST(MaterialPhantom, ThreadsDoNotMatter)
{
  vtkNew<vtkTFCMaterialPhantom> phantoms[2];
  for (const int i : { 0, 1 })
  {
    setenv("TFC_NUM_THREADS", i ? "5" : "1", 1);
    phantoms[i]->SetDimensions(33, 20, 11);
    phantoms[i]->Update();
  }
  unsetenv("TFC_NUM_THREADS");
  for (vtkIdType i = 0; i < phantoms[0]->GetOutput()->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(Intensity(phantoms[0])[i], Intensity(phantoms[1])[i]);
  }
}

TEST(MaterialPhantom, WithoutNoiseAreThePlainMeans)
{
  vtkNew<vtkTFCMaterialPhantom> phantom;
  phantom->SetDimensions(24, 24, 24);
  phantom->SetNoiseScale(0);
  phantom->Update();
  const float means[6] = { .2F, .6F, .4F, .6F, .8F, .8F };
  for (vtkIdType i = 0; i < phantom->GetOutput()->GetNumberOfPoints(); ++i)
  {
    ASSERT_FLOAT_EQ(Intensity(phantom)[i], means[Material(phantom)[i]]);
  }
}

TEST(MaterialPhantom, OneSampleIsAVolume)
{
  vtkNew<vtkTFCMaterialPhantom> phantom;
  phantom->SetDimensions(1, 1, 1);
  phantom->Update();
  EXPECT_EQ(phantom->GetOutput()->GetNumberOfPoints(), 1);
}
