// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCThreads.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace vtkTFCThreads
{

//------------------------------------------------------------------------------
int GetNumberOfThreads()
{
  if (const char* text = std::getenv("TFC_NUM_THREADS"))
  {
    const long wanted = std::strtol(text, nullptr, 10);
    if (wanted > 0)
    {
      return static_cast<int>(std::min(wanted, 1024L));
    }
  }
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

//------------------------------------------------------------------------------
void For(vtkIdType first, vtkIdType last, vtkIdType grain,
  const std::function<void(vtkIdType, vtkIdType)>& body)
{
  if (first >= last)
  {
    return;
  }
  const int threads = GetNumberOfThreads();
  if (threads == 1)
  {
    body(first, last);
    return;
  }
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
    [&]() { vtkSMPTools::For(first, last, grain, body); });
}

//------------------------------------------------------------------------------
bool ForWithProgress(vtkIdType first, vtkIdType last, vtkIdType grain, vtkAlgorithm* owner,
  double progressBegin, double progressEnd, const std::function<void(vtkIdType, vtkIdType)>& body)
{
  if (!owner)
  {
    For(first, last, grain, body);
    return true;
  }
  // Twenty parts: fine enough to abort soon and to see the bar move, coarse enough that starting
  // the threads costs nothing next to the work.
  constexpr vtkIdType parts = 20;
  const vtkIdType count = last - first;
  for (vtkIdType part = 0; part < parts; ++part)
  {
    if (owner->GetAbortExecute())
    {
      return false;
    }
    For(first + count * part / parts, first + count * (part + 1) / parts, grain, body);
    owner->UpdateProgress(progressBegin + (progressEnd - progressBegin) * (part + 1) / parts);
  }
  return !owner->GetAbortExecute();
}

}
