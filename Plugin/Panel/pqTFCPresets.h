// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCPresets
 * @brief The menu of files: open and save transfer functions, presets, copy and paste of regions.
 *
 * Presets are .tfc.json files in the folder CombinedTransferFunctions of ParaView's settings.
 */

#ifndef pqTFCPresets_h
#define pqTFCPresets_h

#include <QMenu>

class pqTFCDocument;

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
  void fillPresets();

private:
  Q_DISABLE_COPY(pqTFCPresets)

  QString folder() const;

  pqTFCDocument* Document;
  QMenu* Presets;
};

#endif
