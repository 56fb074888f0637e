// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCProbeMark
 * @brief The probe's point on the 1D axis of the selected region: a line in ParaView's transfer
 * function widget at the value that the region's tertiary attribute has there.
 */

#ifndef pqTFCProbeMark_h
#define pqTFCProbeMark_h

#include <QObject>

#include "vtkNew.h"

class pqTFCDocument;
class pqTFCProbe;
class pqTransferFunctionWidget;
class vtkTFCValueMark;

class pqTFCProbeMark : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  /// The widget shows the 1D function of the document's active region.
  pqTFCProbeMark(pqTFCDocument* document, pqTFCProbe* probe, pqTransferFunctionWidget* widget);
  ~pqTFCProbeMark() override;

  /// What is marked; NaN while nothing is.
  double value() const;
  /// Where the line was drawn last, from 0 at the left to 1 at the right side of the widget; NaN
  /// when it was not.
  double position() const;

private Q_SLOTS:
  void refresh();

private:
  Q_DISABLE_COPY(pqTFCProbeMark)

  pqTFCDocument* Document;
  pqTFCProbe* Probe;
  pqTransferFunctionWidget* Widget;
  vtkNew<vtkTFCValueMark> Mark;
};

#endif
