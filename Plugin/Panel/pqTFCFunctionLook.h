// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gives ParaView's transfer function widget the colours of the palette: it is white whatever
 * the palette is (ParaView 5.11).
 *
 * The ground becomes the palette's base, axes and curve its text colour. To be called after
 * initialize() of the widget, which makes new plots, and when the palette changes.
 */

#ifndef pqTFCFunctionLook_h
#define pqTFCFunctionLook_h

#include <QString>

class QPalette;
class QWidget;

void pqTFCFollowPalette(QWidget* widget, const QPalette& palette);

/// For tests: colours of ground and curve as they are drawn, "#rrggbb #rrggbb".
QString pqTFCFunctionColors(QWidget* widget);

#endif
