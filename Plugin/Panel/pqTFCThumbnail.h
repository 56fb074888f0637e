// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A small picture of a transfer function: its domain with the regions.
 *
 * The domain is that of the axis ranges; where they are automatic, that of the quantiles which the
 * transfer function carries, else the box around the regions. A filling is the weight of the
 * fall-off, paler for small opacities but never invisible; the colour is the region's own. Hidden
 * regions are left out.
 */

#ifndef pqTFCThumbnail_h
#define pqTFCThumbnail_h

#include <QImage>
#include <QSize>

class QPalette;
class vtkTFCTransferFunction;

QImage pqTFCThumbnail(const vtkTFCTransferFunction* model, const QSize& size,
  const QPalette& palette);

#endif
