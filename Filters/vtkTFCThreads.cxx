// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCThreads.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
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
  // Parts of about a tenth of a second: fine enough to abort soon and to see the bar move, coarse
  // enough that starting the threads costs nothing next to the work.
  const vtkIdType count = last - first;
  const vtkIdType smallest = std::max<vtkIdType>(grain, 1) * GetNumberOfThreads();
  vtkIdType part = std::max(smallest, count / 64);
  for (vtkIdType done = 0; done < count;)
  {
    if (owner->GetAbortExecute())
    {
      return false;
    }
    const vtkIdType next = std::min(count, done + part);
    const auto start = std::chrono::steady_clock::now();
    For(first + done, first + next, grain, body);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    done = next;
    part = time.count() < 0.05 ? 2 * part : time.count() > 0.2 ? part / 2 : part;
    part = std::max(part, smallest);
    owner->UpdateProgress(progressBegin +
      (progressEnd - progressBegin) * static_cast<double>(done) / static_cast<double>(count));
  }
  return !owner->GetAbortExecute();
}

}
