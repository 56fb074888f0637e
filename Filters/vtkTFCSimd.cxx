// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCSimd.h"

#include <cstdlib>
#include <string>

namespace vtkTFCSimd
{

//------------------------------------------------------------------------------
namespace
{
Level GetBest()
{
#if TFC_HAS_SIMD_LEVELS
  // These also ask whether the operating system saves the wide registers.
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
    __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
  {
    return Level::AVX512;
  }
  if (__builtin_cpu_supports("avx2"))
  {
    return Level::AVX2;
  }
#endif
  return Level::Baseline;
}
}

//------------------------------------------------------------------------------
Level GetLevel()
{
  static const Level best = GetBest();
  const char* wanted = std::getenv("TFC_SIMD");
  if (wanted)
  {
    for (const Level level : { Level::Baseline, Level::AVX2, Level::AVX512 })
    {
      if (std::string(wanted) == GetName(level) && level < best)
      {
        return level;
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
const char* GetName(Level level)
{
  switch (level)
  {
    case Level::AVX512:
      return "avx512";
    case Level::AVX2:
      return "avx2";
    default:
      return "baseline";
  }
}

}
