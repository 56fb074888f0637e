// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Threaded loops of this project, independent of the host application's SMP settings.
 *
 * vtkSMPTools runs serially when the application selected the Sequential backend, which is the
 * default of Debian's ParaView. These helpers run on the STDThread backend in a local scope, so
 * that neither the application's nor another plugin's setting changes.
 *
 * The number of threads is the environment variable TFC_NUM_THREADS when it is a positive integer,
 * else the number of hardware threads. Results of this project's filters do not depend on it.
 */

#ifndef vtkTFCThreads_h
#define vtkTFCThreads_h

#include "vtkTFCFiltersModule.h" // For export macro

#include "vtkType.h" // For vtkIdType

#include <functional> // For std::function

class vtkAlgorithm;

namespace vtkTFCThreads
{
/**
 * Number of threads that For() uses: at least 1.
 */
VTKTFCFILTERS_EXPORT int GetNumberOfThreads();

/**
 * Call body(begin, end) on disjoint ranges that cover [first, last), in parallel. `grain` is the
 * smallest range worth a thread (0: one range per thread). The body must not call into a
 * vtkAlgorithm.
 */
VTKTFCFILTERS_EXPORT void For(vtkIdType first, vtkIdType last, vtkIdType grain,
  const std::function<void(vtkIdType, vtkIdType)>& body);

/**
 * The same in consecutive parts, with `owner`'s progress moving from `progressBegin` to
 * `progressEnd` and its abort flag looked at between parts, both on the calling thread. Returns
 * false when it was aborted: then some ranges were not visited. A null owner reports nothing.
 */
VTKTFCFILTERS_EXPORT bool ForWithProgress(vtkIdType first, vtkIdType last, vtkIdType grain,
  vtkAlgorithm* owner, double progressBegin, double progressEnd,
  const std::function<void(vtkIdType, vtkIdType)>& body);
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCThreads.h
