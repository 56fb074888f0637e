// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCChartWidget
 * @brief The domain chart as a Qt widget: rendering, keys, palette, scaling.
 */

#ifndef pqTFCChartWidget_h
#define pqTFCChartWidget_h

#include <QVTKOpenGLNativeWidget.h>

#include <QImage>
#include <QVector>

#include "vtkNew.h"

class vtkContextView;
class vtkEventQtSlotConnect;
class vtkTFCDomainChart;

class pqTFCChartWidget : public QVTKOpenGLNativeWidget
{
  Q_OBJECT
  typedef QVTKOpenGLNativeWidget Superclass;

  /// For tests: the ends of the axes that are in sight, in data units; scale and colours of the
  /// histogram; and a number for each different picture.
  Q_PROPERTY(QString view READ view)
  Q_PROPERTY(QString look READ look)
  Q_PROPERTY(int pictureNumber READ pictureNumber)

public:
  pqTFCChartWidget(QWidget* parent = nullptr);
  ~pqTFCChartWidget() override;

  vtkTFCDomainChart* chart() const;

  QString view() const;
  QString look() const;
  /// Counts the different pictures that were asked for, as pqTFCPanel::stateNumber() does states.
  int pictureNumber();

  /// Draw soon; many calls in one round of the event loop draw once.
  void renderLater();

Q_SIGNALS:
  void editStarted();
  void edited();
  void editFinished();
  void selectionChanged();
  void toolChanged();
  void hovered();
  void said(const QString& message);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;

private Q_SLOTS:
  void onChartEvent(vtkObject* caller, unsigned long event, void* client, void* data);
  void renderNow();

private:
  Q_DISABLE_COPY(pqTFCChartWidget)

  void followPalette();

  vtkNew<vtkTFCDomainChart> Chart;
  vtkNew<vtkContextView> View;
  vtkNew<vtkEventQtSlotConnect> Events;
  bool RenderPending = false;
  QVector<QImage> Pictures; ///< in the order of pictureNumber()
};

#endif
