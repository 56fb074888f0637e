// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Volumes with balls, and what vtkTFCFeatureSize makes of them.
 */

#ifndef FeatureSizeVolumes_h
#define FeatureSizeVolumes_h

#include "FilterVolumes.h"
#include "vtkTFCFeatureSize.h"

#include "vtkFloatArray.h"
#include "vtkPolyData.h"

#include <cmath>
#include <random>
#include <vector>

namespace testing_volumes
{
struct Ball
{
  double Center[3];
  double Radius;
  double Contrast;
};

/**
 * The sum of the balls' contrasts, samples counted from 0.
 */
inline Function MakeBalls(const std::vector<Ball>& balls, double spacingX = 1.,
  double spacingY = 1., double spacingZ = 1.)
{
  return [=](int x, int y, int z)
  {
    double value = 0.;
    for (const Ball& ball : balls)
    {
      const double dx = x * spacingX - ball.Center[0], dy = y * spacingY - ball.Center[1],
                   dz = z * spacingZ - ball.Center[2];
      const bool inside = dx * dx + dy * dy + dz * dz <= ball.Radius * ball.Radius;
      value += inside ? ball.Contrast : 0.;
    }
    return value;
  };
}

/**
 * The balls of the noisy phantom: radii 6, 10 and 18.
 */
inline std::vector<Ball> GetThreeBalls()
{
  return { { { 20., 22., 24. }, 6., 0.4 }, { { 30., 66., 58. }, 10., 0.4 },
    { { 72., 38., 50. }, 18., 0.4 } };
}
constexpr int PhantomSize[3] = { 96, 88, 80 };

/**
 * The same with normal noise.
 */
inline Function AddNoise(const Function& f, double sigma, unsigned int seed)
{
  auto random = std::make_shared<std::mt19937>(seed);
  auto normal = std::make_shared<std::normal_distribution<double>>(0., sigma);
  return [=](int x, int y, int z) { return f(x, y, z) + (*normal)(*random); };
}

/**
 * The size array at a sample counted from 0.
 */
inline double GetSizeAt(vtkImageData* image, vtkDataArray* sizes, double x, double y, double z)
{
  const int* n = image->GetDimensions();
  const auto round = [](double v) { return static_cast<vtkIdType>(std::lround(v)); };
  return sizes->GetTuple1((round(z) * n[1] + round(y)) * n[0] + round(x));
}

/**
 * A column of the blobs.
 */
inline vtkDataArray* GetColumn(vtkTFCFeatureSize* filter, const char* name)
{
  return filter->GetBlobs()->GetPointData()->GetArray(name);
}

/**
 * The blob with the strongest response; -1 without blobs.
 */
inline vtkIdType FindStrongest(vtkTFCFeatureSize* filter)
{
  vtkDataArray* response = GetColumn(filter, "response");
  vtkIdType best = -1;
  for (vtkIdType i = 0; i < response->GetNumberOfTuples(); ++i)
  {
    const bool stronger =
      best < 0 || std::fabs(response->GetTuple1(i)) > std::fabs(response->GetTuple1(best));
    best = stronger ? i : best;
  }
  return best;
}
}

#endif
