// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCComputeMenu
 * @brief Attributes of the primary axis that the data do not have yet: adds the filter that
 * computes one, with its defaults, and goes on with the same transfer function on its output.
 *
 * Progress and a button to cancel: see pqTFCCancelableUpdate. The parameters are in the properties
 * panel of the filter.
 */

#ifndef pqTFCComputeMenu_h
#define pqTFCComputeMenu_h

#include <QMenu>

class pqTFCDocument;

class pqTFCComputeMenu : public QMenu
{
  Q_OBJECT
  typedef QMenu Superclass;

public:
  pqTFCComputeMenu(pqTFCDocument* document, QWidget* parent = nullptr);

private Q_SLOTS:
  /// Offer what is missing only.
  void refresh();

private:
  Q_DISABLE_COPY(pqTFCComputeMenu)

  pqTFCDocument* Document;
};

#endif
