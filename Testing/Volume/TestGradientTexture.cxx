// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCGradientTexture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

//------------------------------------------------------------------------------
float FromHalf(std::uint16_t half)
{
  const int exponent = half >> 10 & 31;
  const int mantissa = half & 1023;
  const float size = exponent > 0 ? std::ldexp(1024.0F + mantissa, exponent - 25)
                                  : std::ldexp(static_cast<float>(mantissa), -24);
  return half & 0x8000 ? -size : size;
}

//------------------------------------------------------------------------------
// A lattice of two channels of which the second must not matter.
struct Lattice
{
  std::array<int, 3> Size;
  std::vector<float> Values;

  template <typename Function>
  Lattice(std::array<int, 3> size, Function function)
    : Size(size)
  {
    for (int z = 0; z < size[2]; ++z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        for (int x = 0; x < size[0]; ++x)
        {
          this->Values.push_back(function(x, y, z));
          this->Values.push_back(1000.0F * (x % 2));
        }
      }
    }
  }

  float& At(int x, int y, int z) { return this->Values[2 * this->Index(x, y, z)]; }
  size_t Index(int x, int y, int z) const { return x + this->Size[0] * (y + this->Size[1] * z); }

  std::array<float, 3> GetGradient(int x, int y, int z) const
  {
    const auto texels = vtkTFCGradientTexture::MakeTexels(this->Values.data(), 2, this->Size);
    EXPECT_EQ(texels.size(), 2 * this->Values.size());
    const std::uint16_t* texel = texels.data() + 4 * this->Index(x, y, z);
    EXPECT_EQ(texel[3], 0);
    return { FromHalf(texel[0]), FromHalf(texel[1]), FromHalf(texel[2]) };
  }
};

Lattice MakeRamp(std::array<int, 3> size)
{
  return { size, [](int x, int y, int z) { return 0.03F * x - 0.02F * y + 0.0001F * z; } };
}

constexpr float Precision = 1.0F / 2048; // of a half float

}

TEST(GradientTexture, OfARampIsItsSlopeAlsoAtTheBorder)
{
  const Lattice ramp = MakeRamp({ 7, 5, 6 });
  for (int x = 0; x < 7; ++x)
  {
    for (int y = 0; y < 5; ++y)
    {
      for (int z = 0; z < 6; ++z)
      {
        // By texture coordinates, in units of the longest axis.
        const auto gradient = ramp.GetGradient(x, y, z);
        EXPECT_NEAR(gradient[0], 0.03F, 0.03F * Precision);
        EXPECT_NEAR(gradient[1], -0.02F * 5 / 7, 0.02F * Precision);
        EXPECT_NEAR(gradient[2], 0.0001F * 6 / 7, 0.0001F * Precision + 1e-7F);
      }
    }
  }
}

TEST(GradientTexture, IsACentralDifference)
{
  const Lattice lattice({ 5, 5, 5 },
    [](int x, int y, int z) { return 0.01F * x * x + 0.02F * y * z; });
  const auto gradient = lattice.GetGradient(2, 1, 3);
  EXPECT_NEAR(gradient[0], 0.04F, 1e-4F);
  EXPECT_NEAR(gradient[1], 0.06F, 1e-4F);
  EXPECT_NEAR(gradient[2], 0.02F, 1e-4F);
}

TEST(GradientTexture, IsOneSidedBesideAVoxelWithoutData)
{
  Lattice ramp = MakeRamp({ 6, 6, 6 });
  ramp.At(3, 3, 3) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NEAR(ramp.GetGradient(2, 3, 3)[0], 0.03F, 0.03F * Precision);
  EXPECT_NEAR(ramp.GetGradient(4, 3, 3)[0], 0.03F, 0.03F * Precision);
  EXPECT_NEAR(ramp.GetGradient(3, 3, 3)[0], 0.03F, 0.03F * Precision); // from both sides
  ramp.At(2, 2, 2) = std::numeric_limits<float>::infinity();
  for (const float component : ramp.GetGradient(2, 2, 3))
  {
    EXPECT_TRUE(std::abs(component) <= 1.0F);
  }
}

TEST(GradientTexture, HasNoDerivativeAlongAnAxisWithOneVoxel)
{
  const auto gradient = MakeRamp({ 4, 1, 3 }).GetGradient(1, 0, 1);
  EXPECT_EQ(gradient[1], 0);
  EXPECT_NEAR(gradient[0], 0.03F, 0.03F * Precision);
}
