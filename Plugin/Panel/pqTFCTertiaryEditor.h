// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCTertiaryEditor
 * @brief The selected region's own 1D function: attribute, opacity, optional colours, over the
 * attribute's histogram of the voxels in the region.
 *
 * The histogram is weighted by the region's shape and fall-off and follows while the region is
 * dragged. Opacity and colours are edited with ParaView's own transfer function widget, or typed as
 * points (pqTFCPointsField).
 */

#ifndef pqTFCTertiaryEditor_h
#define pqTFCTertiaryEditor_h

#include <QWidget>

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class QCheckBox;
class QLabel;
class pqTFCAdvice;
class pqTFCDocument;
class pqTFCTertiaryBox;
class pqTransferFunctionWidget;
class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkTFCRegion;
class vtkTable;

class pqTFCTertiaryEditor : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

  /// For tests: ground and curve of the opacity as they are drawn.
  Q_PROPERTY(QString colors READ colors)
  /// And the histogram: middle and count of each bin.
  Q_PROPERTY(QString histogram READ histogram)

public:
  pqTFCTertiaryEditor(pqTFCDocument* document, pqTFCAdvice* advice, QWidget* parent = nullptr);
  ~pqTFCTertiaryEditor() override;

  /// Sum of the histogram that is shown: voxels in the region. -1 while there is none.
  double total() const { return this->Total; }

  pqTransferFunctionWidget* opacityWidget() const { return this->Opacity; }
  QString colors() const;
  QString histogram() const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private Q_SLOTS:
  void refresh();
  void onPointsModified();
  void onUseColors(bool use);

private:
  Q_DISABLE_COPY(pqTFCTertiaryEditor)

  void showFunctions(vtkTFCRegion* region);
  void showHistogram(vtkTFCRegion* region);
  void write(vtkTFCRegion* region);
  void writeLive(vtkTFCRegion* region);
  void followPalette();
  /// A key in one of the functions; whether it is used up.
  bool onKey(QObject* function, int key);
  /// Of the colours' current point, in a dialog.
  void chooseColor();

  pqTFCDocument* Document;
  pqTFCTertiaryBox* Attribute;
  QCheckBox* UseColors;
  QWidget* Functions;
  pqTransferFunctionWidget* Opacity;
  pqTransferFunctionWidget* Colors;
  QLabel* Ends[2];
  QLabel* Caption;
  vtkNew<vtkPiecewiseFunction> OpacityFunction;
  vtkNew<vtkColorTransferFunction> ColorFunction; ///< of the region, when it has one
  vtkNew<vtkColorTransferFunction> RegionColor;   ///< constant, for the histogram
  std::vector<double> Shown;                      ///< what they were made from beside nodes
  double Total = -1;
  vtkSmartPointer<vtkTable> Histogram; ///< that is shown
  bool Refreshing = false;
  bool Pressed = false;       ///< a mouse button is down in one of the functions
  bool DoubleClicked = false; ///< in the colours
};

#endif
