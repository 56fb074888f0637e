// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Icons of the editor, drawn in the palette's colours: sharp at any scale, right on dark.
 */

#ifndef pqTFCIcons_h
#define pqTFCIcons_h

#include <QIcon>

class QPalette;

/// Tools as in vtkTFCDomainChart::Tools.
QIcon pqTFCToolIcon(int tool, const QPalette& palette);

#endif
