// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What ParaView's transfer function widget draws with; it has no functions for these
 * (ParaView 5.11). Null when there is none.
 *
 * The scene stays the same for the life of the widget. initialize() of the widget makes new plots
 * in the chart.
 */

#ifndef pqTFCFunctionChart_h
#define pqTFCFunctionChart_h

class QWidget;
class vtkChart;
class vtkContextScene;
class vtkRenderer;

vtkRenderer* pqTFCFunctionRenderer(QWidget* widget);
vtkContextScene* pqTFCFunctionScene(QWidget* widget);
vtkChart* pqTFCFunctionChart(QWidget* widget);

#endif
