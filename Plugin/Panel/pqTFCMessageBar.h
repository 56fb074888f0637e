// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCMessageBar
 * @brief One sentence at the top of the editor: what is missing, or what just went wrong, and the
 * button that does something about it. Hidden while there is nothing to say.
 */

#ifndef pqTFCMessageBar_h
#define pqTFCMessageBar_h

#include <QString>
#include <QWidget>

#include "pqTFCDataProblem.h"

class QLabel;
class QPushButton;
class pqTFCDocument;

class pqTFCMessageBar : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  pqTFCMessageBar(pqTFCDocument* document, QWidget* parent = nullptr);
  ~pqTFCMessageBar() override;

  /// Empty while hidden.
  QString text() const;

private Q_SLOTS:
  void refresh();
  void act();
  void say(const QString& message);

private:
  Q_DISABLE_COPY(pqTFCMessageBar)

  /// Both axes are the same attribute.
  bool isDiagonal() const;
  /// Ask which arrays stand for those that the data lack.
  void replaceArrays();

  pqTFCDocument* Document;
  QLabel* Message;
  QPushButton* MessageButton;
  QString Said; ///< until the next edit
  pqTFCDataProblem Problem;
};

#endif
