// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The page that lists what keys and mouse do in the chart.
 */

#ifndef pqTFCKeysPage_h
#define pqTFCKeysPage_h

class QWidget;

/// Show the page until it is closed.
void pqTFCShowKeysPage(QWidget* parent);

#endif
