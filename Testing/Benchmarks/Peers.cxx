// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the benchmarks measure in C++: memory speed, and ITK's filters where ITK is
 * installed.
 *
 * usage: tfc_peers triad THREADS REPEATS
 *        tfc_peers gradient|diffusion FILE N THREADS REPEATS     (FILE: N^3 raw floats)
 * Prints one number per repeat: GB/s for the triad, milliseconds for a filter.
 */
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#ifdef TFC_HAS_ITK
#include "itkGradientAnisotropicDiffusionImageFilter.h"
#include "itkGradientMagnitudeImageFilter.h"
#include "itkImportImageFilter.h"
#include "itkMultiThreaderBase.h"
#include "itkVersion.h"
#endif

namespace
{
double Measure(const std::function<void()>& body)
{
  const auto start = std::chrono::steady_clock::now();
  body();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/**
 * a = b + s c over three arrays of 256 MiB, as STREAM counts it: 12 bytes per element.
 */
int Triad(int threads, int repeats)
{
  const size_t count = size_t{ 1 } << 26;
  std::vector<float> a(count), b(count, 1.f), c(count, 2.f);
  const auto all = [&]()
  {
    std::vector<std::thread> workers;
    for (int t = 0; t < threads; ++t)
    {
      workers.emplace_back(
        [&, t]()
        {
          const size_t end = count * (t + 1) / threads;
          for (size_t i = count * t / threads; i < end; ++i)
          {
            a[i] = b[i] + 3.f * c[i];
          }
        });
    }
    for (auto& worker : workers)
    {
      worker.join();
    }
  };
  all();
  for (int r = 0; r < repeats; ++r)
  {
    std::printf("%.3f\n", 12. * static_cast<double>(count) / Measure(all) / 1e9);
  }
  return 0;
}

#ifdef TFC_HAS_ITK
using Image = itk::Image<float, 3>;

template <typename Filter>
int Run(Filter* filter, const char* file, int n, int threads, int repeats)
{
  const size_t count = static_cast<size_t>(n) * n * n;
  std::vector<float> values(count);
  FILE* in = std::fopen(file, "rb");
  if (!in || std::fread(values.data(), sizeof(float), count, in) != count)
  {
    std::fprintf(stderr, "cannot read %zu floats from %s\n", count, file);
    return 1;
  }
  std::fclose(in);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
  auto import = itk::ImportImageFilter<float, 3>::New();
  Image::RegionType region;
  region.SetSize({ { static_cast<itk::SizeValueType>(n), static_cast<itk::SizeValueType>(n),
    static_cast<itk::SizeValueType>(n) } });
  import->SetRegion(region);
  import->SetImportPointer(values.data(), count, false);
  import->Update();
  filter->SetInput(import->GetOutput());
  filter->SetNumberOfWorkUnits(threads);
  for (int r = 0; r < repeats; ++r)
  {
    filter->Modified();
    std::printf("%.3f\n", 1e3 * Measure([&]() { filter->Update(); }));
  }
  return 0;
}
#endif
}

int main(int argc, char** argv)
{
  const std::string name = argc > 1 ? argv[1] : "";
  if (name == "triad" && argc == 4)
  {
    return Triad(std::atoi(argv[2]), std::atoi(argv[3]));
  }
#ifdef TFC_HAS_ITK
  if (name == "version")
  {
    std::printf("%s\n", itk::Version::GetITKVersion());
    return 0;
  }
  if (name == "gradient" && argc == 6)
  {
    auto filter = itk::GradientMagnitudeImageFilter<Image, Image>::New();
    return Run(filter.GetPointer(), argv[2], std::atoi(argv[3]), std::atoi(argv[4]),
      std::atoi(argv[5]));
  }
  if (name == "diffusion" && argc == 6)
  {
    auto filter = itk::GradientAnisotropicDiffusionImageFilter<Image, Image>::New();
    filter->SetNumberOfIterations(5);
    filter->SetTimeStep(0.0625);
    filter->SetConductanceParameter(2.);
    return Run(filter.GetPointer(), argv[2], std::atoi(argv[3]), std::atoi(argv[4]),
      std::atoi(argv[5]));
  }
#endif
  std::fprintf(stderr, "tfc_peers: '%s' is unknown or was not built\n", name.c_str());
  return 2;
}
