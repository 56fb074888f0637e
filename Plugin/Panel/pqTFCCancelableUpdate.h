// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCCancelableUpdate
 * @brief Updates a filter while a window shows its progress and a button that cancels it.
 *
 * The window appears when the filter is going to take longer than half a second. While it is open
 * nothing else takes input, and timers wait: nothing of ParaView runs inside the update.
 *
 * The filter has to look at vtkAlgorithm::AbortExecute, as all filters of this plugin do. With a
 * server there is no such window: ParaView's client waits for the server's answer and cannot
 * reach a filter that runs there. ParaView's own bar shows the progress.
 */

#ifndef pqTFCCancelableUpdate_h
#define pqTFCCancelableUpdate_h

#include <QObject>

class QProgressDialog;
class vtkAlgorithm;
class vtkSMSourceProxy;

class pqTFCCancelableUpdate : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  /// Update `source` at `time`. `label` says what is computed. False when it was cancelled: the
  /// output is empty then, until another update.
  static bool run(vtkSMSourceProxy* source, double time, const QString& label);

protected:
  /// Holds back timers of everything but the window.
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  Q_DISABLE_COPY(pqTFCCancelableUpdate)

  pqTFCCancelableUpdate(vtkAlgorithm* algorithm, const QString& label);
  ~pqTFCCancelableUpdate() override;

  void progress();

  vtkAlgorithm* Algorithm;
  QProgressDialog* Dialog;
  unsigned long Observer = 0;
  bool Showing = false; ///< events of the window are being processed
};

#endif
