// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCPresetDialog
 * @brief Presets with their pictures: apply, save, rename, delete.
 *
 * It edits the folder only; what Apply does with the data is up to who listens to applied(). A
 * preset that cannot be read is listed with a warning sign, and says why when it is selected.
 */

#ifndef pqTFCPresetDialog_h
#define pqTFCPresetDialog_h

#include <QDialog>

#include "pqTFCPresetFolder.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QPushButton;

class pqTFCPresetDialog : public QDialog
{
  Q_OBJECT
  typedef QDialog Superclass;

  /// For tests: names in the order of the list, "NAME (unreadable)" for those that cannot be read;
  /// the message; and the colour in the middle of the selected preset's picture.
  Q_PROPERTY(QString presets READ presets)
  Q_PROPERTY(QString message READ message)
  Q_PROPERTY(QString pictureColor READ pictureColor)

public:
  pqTFCPresetDialog(pqTFCPresetFolder* folder, QWidget* parent = nullptr);
  ~pqTFCPresetDialog() override;

  QString presets() const;
  QString message() const;
  QString pictureColor() const;

  /// Show what went wrong; an empty text removes the last one.
  void say(const QString& message);

  /// Read the folder again.
  void refresh(const QString& select = QString());

Q_SIGNALS:
  void applied(const QString& path);
  /// Save the current transfer function under a name.
  void saved(const QString& name);

private Q_SLOTS:
  void onSelection();
  void onRenamed(QListWidgetItem* item);
  void onDelete();

private:
  Q_DISABLE_COPY(pqTFCPresetDialog)

  const pqTFCPresetFolder::Preset* current() const;

  pqTFCPresetFolder* Folder;
  QVector<pqTFCPresetFolder::Preset> Presets;
  QListWidget* List;
  QLabel* Message;
  QLineEdit* Name;
  QPushButton* Apply;
  QPushButton* Rename;
  QPushButton* Delete;
};

#endif
