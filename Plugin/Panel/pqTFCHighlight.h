// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCHighlight
 * @brief The region under the pointer stands out in the 3D view, the others are dimmed.
 *
 * The parts of the panel say through hover() where the pointer is. Once it rests there, the
 * property `HighlightedRegion` of the edited representation is set: an internal one, of which state
 * files, undo and trace know nothing. It is 0 again as soon as the pointer leaves, something is
 * edited, the panel is closed or another representation is edited.
 */

#ifndef pqTFCHighlight_h
#define pqTFCHighlight_h

#include <QObject>
#include <QPointer>
#include <QTimer>

class pqDataRepresentation;
class pqTFCDocument;

class pqTFCHighlight : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqTFCHighlight(pqTFCDocument* document, QObject* parent = nullptr);
  ~pqTFCHighlight() override;

  bool isEnabled() const { return this->Enabled; }

  /// The region that stands out, 0 for none. Does not wait until the pointer rests.
  int region();

public Q_SLOTS:
  /// On or off, kept in ParaView's settings. Default on.
  void setEnabled(bool enabled);
  /// Id of the region under the pointer, 0 for none.
  void hover(int region);
  void clear();

private Q_SLOTS:
  void showWanted();
  void renderStill();

private:
  Q_DISABLE_COPY(pqTFCHighlight)

  pqTFCDocument* Document;
  QPointer<pqDataRepresentation> Representation; ///< with the region that stands out
  QTimer Rest;
  QTimer Still;
  int Wanted = 0;
  int Shown = 0;
  bool Enabled = true;
};

#endif
