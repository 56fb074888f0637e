// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Who cannot see or cannot use a mouse: names of widgets, and the way to them by keyboard.
 */

#ifndef pqTFCReach_h
#define pqTFCReach_h

#include <QStringList>

class QWidget;

/**
 * Makes the buttons of a tool bar reachable with Tab, which Qt's tool bars leave out.
 */
void pqTFCLetTabReach(QWidget* toolBar);

/**
 * The parts of one of ParaView's composite widgets (a slider and a line of text) get the name and
 * the tool tip of the whole: they, not the whole, have the focus.
 */
void pqTFCNameParts(QWidget* widget);

/**
 * Every visible widget below `parent` that takes the keyboard or the mouse and has no name that a
 * screen reader could say, or no way to it with Tab, and the headers and cells of tables without a
 * name: sorted paths of object names, each with what is wrong.
 */
QStringList pqTFCOutOfReach(QWidget* parent);

#endif
