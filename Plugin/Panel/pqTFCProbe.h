// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCProbe
 * @brief Clicks in the 3D view: what is visible there, and which regions make it so.
 *
 * While it is active, a click (no drag) with the left button into the view of the edited
 * representation runs the filter RayProbe along the line of sight, on the server. The view still
 * gets its events.
 */

#ifndef pqTFCProbe_h
#define pqTFCProbe_h

#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QString>

#include "vtkSmartPointer.h"

#include <string>

class QWidget;
class pqTFCAdvice;
class pqTFCDocument;
class vtkTFCTableInformation;

class pqTFCProbe : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqTFCProbe(pqTFCDocument* document, pqTFCAdvice* advice, QObject* parent = nullptr);

  bool isActive() const { return this->Active; }
  /// What the last click found: the regions with their part in the colour, or why there are none;
  /// empty while the probe is off. text() has the values of the axes as well.
  const QString& regions() const { return this->Regions; }
  QString text() const;

  /// The attribute at the place that the last click found; NaN when there is none.
  double value(const std::string& array, int component) const;

  bool eventFilter(QObject* watched, QEvent* event) override;

public Q_SLOTS:
  void setActive(bool active);

Q_SIGNALS:
  /// Values of the two axes at the place, in data units.
  void found(double primary, double secondary);
  /// Nothing is visible there, or the probe was switched off.
  void lost();
  /// text() has changed.
  void told();

private:
  Q_DISABLE_COPY(pqTFCProbe)

  void restart();
  void watch();
  void pick(double x, double y);

  pqTFCDocument* Document;
  pqTFCAdvice* Advice;
  QPointer<QWidget> Viewport;
  QPoint Pressed;
  QString Regions;
  QString Values;
  vtkSmartPointer<vtkTFCTableInformation> Location; ///< null when nothing was found
  bool Active = false;
};

#endif
