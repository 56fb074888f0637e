// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCPresetFolder
 * @brief The folder of presets: .tfc.json files in CombinedTransferFunctions of ParaView's
 * settings.
 *
 * A preset may have any name: characters that a file name cannot have, or that mean something in
 * it, are written as %XX. Nothing is ever overwritten, and a file that cannot be read stays as it
 * is and is listed with what is wrong. Pictures are drawn when a file is first listed, and again
 * when it changes.
 */

#ifndef pqTFCPresetFolder_h
#define pqTFCPresetFolder_h

#include <QDateTime>
#include <QHash>
#include <QImage>
#include <QSize>
#include <QString>
#include <QVector>

class QPalette;
class vtkTFCTransferFunction;

class pqTFCPresetFolder
{
public:
  struct Preset
  {
    QString Name;
    QString Path;
    QString Problem; ///< why it cannot be read; empty when it can
    QImage Picture;  ///< null when it cannot be read
  };

  static QString path();

  /// All presets by name.
  QVector<Preset> list(const QSize& picture, const QPalette& palette);

  ///@{
  /// What went wrong, for the user; empty after a success.
  QString save(const QString& name, const QString& state);
  QString rename(const Preset& preset, const QString& name);
  QString remove(const Preset& preset);
  ///@}

  ///@{
  /// Read and write a file; what went wrong, or empty. A write is whole or not at all. The model
  /// keeps its state when the file cannot be read.
  static QString read(const QString& path, vtkTFCTransferFunction* model);
  static QString write(const QString& path, const QString& state);
  ///@}

private:
  static QString fileOf(const QString& name);

  struct Known
  {
    QDateTime Time;
    qint64 Size = 0;
    QRgb Ground = 0;
    Preset Found;
  };
  QHash<QString, Known> Cache; ///< by path
};

#endif
