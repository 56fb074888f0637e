// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCCancelableUpdate.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqProgressManager.h"
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkSMSourceProxy.h"

#include <QApplication>
#include <QEvent>
#include <QProgressDialog>
#include <QScopedValueRollback>

//-----------------------------------------------------------------------------
bool pqTFCCancelableUpdate::run(vtkSMSourceProxy* source, double time, const QString& label)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(source->GetClientSideObject());
  if (!algorithm)
  {
    source->UpdatePipeline(time);
    return true;
  }
  const pqTFCCancelableUpdate update(algorithm, label);
  source->UpdatePipeline(time);
  const bool canceled = update.Dialog->wasCanceled();
  if (canceled)
  {
    // The next update starts again.
    algorithm->SetAbortExecute(0);
    algorithm->Modified();
  }
  return !canceled;
}

//-----------------------------------------------------------------------------
pqTFCCancelableUpdate::pqTFCCancelableUpdate(vtkAlgorithm* algorithm, const QString& label)
  : Algorithm(algorithm)
  , Dialog(new QProgressDialog(label, tr("Cancel"), 0, 100, pqCoreUtilities::mainWidget()))
{
  this->Dialog->setObjectName("TFCProgress");
  this->Dialog->setWindowTitle(tr("Combined Transfer Functions"));
  this->Dialog->setWindowModality(Qt::ApplicationModal);
  this->Dialog->setMinimumDuration(500);
  // It goes when the update has returned, not when the last report came.
  this->Dialog->setAutoReset(false);
  this->Dialog->setAutoClose(false);
  this->Dialog->setValue(0);
  this->Observer =
    algorithm->AddObserver(vtkCommand::ProgressEvent, this, &pqTFCCancelableUpdate::progress);
  QApplication::instance()->installEventFilter(this);
}

//-----------------------------------------------------------------------------
pqTFCCancelableUpdate::~pqTFCCancelableUpdate()
{
  this->Algorithm->RemoveObserver(this->Observer);
  delete this->Dialog;
}

//-----------------------------------------------------------------------------
void pqTFCCancelableUpdate::progress()
{
  if (this->Showing || this->Dialog->wasCanceled())
  {
    return;
  }
  const QScopedValueRollback<bool> showing(this->Showing, true);
  // ParaView takes all keys and buttons away from a program that shows progress. That the window is
  // modal is enough here.
  pqProgressManager* manager = pqApplicationCore::instance()->getProgressManager();
  const bool before = manager->unblockEvents(true);
  this->Dialog->setValue(static_cast<int>(99 * this->Algorithm->GetProgress()));
  manager->unblockEvents(before);
  if (this->Dialog->wasCanceled())
  {
    this->Algorithm->SetAbortExecute(1);
  }
}

//-----------------------------------------------------------------------------
bool pqTFCCancelableUpdate::eventFilter(QObject* object, QEvent* event)
{
  if (!this->Showing || event->type() != QEvent::Timer)
  {
    return this->Superclass::eventFilter(object, event);
  }
  for (QObject* owner = object; owner; owner = owner->parent())
  {
    if (owner == this->Dialog)
    {
      return false;
    }
  }
  // Not lost: a timer that does not get its event fires again.
  return true;
}
