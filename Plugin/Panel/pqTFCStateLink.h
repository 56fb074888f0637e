// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCStateLink
 * @brief Which representation the editor edits, and the way of every edit into its property.
 *
 * Follows ParaView's active representation; when nothing is active (after a state file was loaded,
 * say), the first visible "Combined Volume" of the active view. The only thing that is ever written
 * is the property `TransferFunction`, so undo, trace, state files and Python see every edit.
 *
 * An edit is begin(), any number of live(), and commit(): one undo step and one line of trace,
 * however many events were between. live() and the drawing that it causes are not recorded.
 */

#ifndef pqTFCStateLink_h
#define pqTFCStateLink_h

#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>

#include "vtkNew.h"

class pqDataRepresentation;
class pqOutputPort;
class pqPipelineSource;
class vtkEventQtSlotConnect;
class vtkPVDataInformation;
class vtkSMProxy;

class pqTFCStateLink : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqTFCStateLink(QObject* parent = nullptr);
  ~pqTFCStateLink() override;

  /// Why there is nothing to edit, or Ready.
  enum Situation
  {
    NoData,     ///< no source is selected
    NotHere,    ///< the source has no representation in the view, which is none of 3D
    NotShown,   ///< nor in this one, where it can be shown
    NotAnImage, ///< the type cannot be offered for such data
    NoPlugin,   ///< the server does not know the type
    OtherType,  ///< a uniform grid in another representation
    Ready
  };
  Situation situation() const;

  pqDataRepresentation* representation() const;
  pqOutputPort* input() const;
  vtkPVDataInformation* dataInformation() const;

  /// The property's text; empty when there is nothing to edit.
  QString state() const;

  void begin();
  void live(const QString& state);
  void commit(const QString& state, const QString& label);
  bool isEditing() const { return this->Editing; }

  /// Make the active data a "Combined Volume", as one undo step, and show them in the active view
  /// where they are not. True when it is one now.
  bool makeCombinedVolume();

  /// Draw the view again: quickly while something is dragged.
  void render(bool interactive);

Q_SIGNALS:
  /// Another representation, or another situation.
  void targetChanged();
  /// The property was changed by somebody else: undo, the properties panel, Python.
  void stateChanged();
  /// New data, time step or arrays.
  void dataChanged();

private Q_SLOTS:
  void updateTarget();
  void onPropertyModified();
  void renderNow();

private:
  Q_DISABLE_COPY(pqTFCStateLink)

  vtkSMProxy* proxy() const;
  void write(const QString& state);
  pqDataRepresentation* findTarget() const;
  void show();

  QPointer<pqDataRepresentation> Representation;
  QPointer<pqPipelineSource> Source; ///< its input
  vtkNew<vtkEventQtSlotConnect> Events;
  QString Before; ///< the property at begin()
  bool Editing = false;
  bool Writing = false;
  Situation LastSituation = NoData;
  QTimer RenderTimer;
  bool RenderInteractive = false;
};

#endif
