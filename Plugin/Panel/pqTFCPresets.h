// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCPresets
 * @brief The menu of files: open and save transfer functions, presets, copy and paste of regions.
 *
 * Files and presets are written with the quantiles of the attributes that they name, so that they
 * can be fitted to other data; opening one removes them.
 */

#ifndef pqTFCPresets_h
#define pqTFCPresets_h

#include <QMenu>
#include <QPointer>

#include "pqTFCPresetFolder.h"

class pqTFCDocument;
class pqTFCPresetDialog;

class pqTFCPresets : public QMenu
{
  Q_OBJECT
  typedef QMenu Superclass;

public:
  pqTFCPresets(pqTFCDocument* document, QWidget* parent = nullptr);
  ~pqTFCPresets() override;

  /// Replace the transfer function by a file's; says what is wrong and returns false otherwise.
  bool open(const QString& path);
  bool save(const QString& path);

public Q_SLOTS:
  void copyRegions();
  void pasteRegions();

private Q_SLOTS:
  void showPresets();

private:
  Q_DISABLE_COPY(pqTFCPresets)

  QString stateForFiles() const;

  pqTFCDocument* Document;
  pqTFCPresetFolder Folder;
  QPointer<pqTFCPresetDialog> Dialog;
};

#endif
