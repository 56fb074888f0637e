// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCPresetFolder.h"

#include "pqCoreUtilities.h"
#include "pqTFCThumbnail.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkTFCTransferFunction.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QPalette>
#include <QSaveFile>
#include <QUrl>

#include <algorithm>

namespace
{
const char* const SUFFIX = ".tfc.json";
// More than vtkTFCTransferFunction reads: not worth loading.
constexpr qint64 LARGEST_FILE = 8 * 1024 * 1024;

QString tr(const char* text)
{
  return QCoreApplication::translate("pqTFCPresetFolder", text);
}

QString Sentence(const std::string& error)
{
  const QString text = QString::fromStdString(error).trimmed();
  return text.endsWith('.') ? text : text + '.';
}
}

//-----------------------------------------------------------------------------
QString pqTFCPresetFolder::path()
{
  return pqCoreUtilities::getParaViewUserDirectory() + "/CombinedTransferFunctions";
}

//-----------------------------------------------------------------------------
QString pqTFCPresetFolder::fileOf(const QString& name)
{
  // What some system forbids, the sign itself, and a point at the start, which would hide it.
  static const QString odd("/\\:*?\"<>|%");
  QString file;
  for (const QChar c : name)
  {
    const bool hidden = file.isEmpty() && c == '.';
    file += hidden || c.unicode() < 32 || c.unicode() == 127 || odd.contains(c)
      ? QString("%%1").arg(c.unicode(), 2, 16, QChar('0')).toUpper()
      : QString(c);
  }
  return pqTFCPresetFolder::path() + "/" + file + SUFFIX;
}

//-----------------------------------------------------------------------------
QString pqTFCPresetFolder::read(const QString& path, vtkTFCTransferFunction* model)
{
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
  {
    return Sentence(file.errorString().toStdString());
  }
  if (file.size() > LARGEST_FILE)
  {
    return tr("It is too large.");
  }
  // What is wrong is the caller's to report.
  vtkNew<vtkCallbackCommand> nothing;
  nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  const unsigned long tag = model->AddObserver(vtkCommand::ErrorEvent, nothing);
  const QByteArray text = file.readAll();
  const bool valid = !text.trimmed().isEmpty() && model->SetState(text.constData());
  model->RemoveObserver(tag);
  if (valid)
  {
    return QString();
  }
  return text.trimmed().isEmpty() ? tr("It is empty.") : Sentence(model->GetLastError());
}

//-----------------------------------------------------------------------------
QString pqTFCPresetFolder::write(const QString& path, const QString& state)
{
  QSaveFile file(path);
  const QByteArray text = state.toUtf8();
  return !file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()
    ? file.errorString()
    : QString();
}

//-----------------------------------------------------------------------------
QVector<pqTFCPresetFolder::Preset> pqTFCPresetFolder::list(const QSize& picture,
  const QPalette& palette)
{
  QVector<Preset> presets;
  QHash<QString, Known> cache;
  const QFileInfoList files =
    QDir(this->path()).entryInfoList({ QString("*") + SUFFIX }, QDir::Files | QDir::Hidden);
  for (const QFileInfo& file : files)
  {
    Known known = this->Cache.value(file.filePath());
    const QRgb ground = palette.color(QPalette::Base).rgb();
    if (known.Time != file.lastModified() || known.Size != file.size() || known.Ground != ground ||
      (known.Found.Problem.isEmpty() && known.Found.Picture.size() != picture))
    {
      const QString name = file.fileName().chopped(static_cast<int>(qstrlen(SUFFIX)));
      known.Time = file.lastModified();
      known.Size = file.size();
      known.Ground = ground;
      known.Found.Name = QUrl::fromPercentEncoding(name.toUtf8());
      known.Found.Path = file.filePath();
      vtkNew<vtkTFCTransferFunction> model;
      known.Found.Problem = pqTFCPresetFolder::read(file.filePath(), model);
      known.Found.Picture =
        known.Found.Problem.isEmpty() ? pqTFCThumbnail(model, picture, palette) : QImage();
    }
    cache[file.filePath()] = known;
    presets.push_back(known.Found);
  }
  this->Cache = cache;
  std::sort(presets.begin(), presets.end(),
    [](const Preset& a, const Preset& b)
    { return QString::localeAwareCompare(a.Name, b.Name) < 0; });
  return presets;
}

//-----------------------------------------------------------------------------
QString pqTFCPresetFolder::save(const QString& name, const QString& state)
{
  if (name.trimmed().isEmpty())
  {
    return tr("Type a name for the preset.");
  }
  const QString path = this->fileOf(name.trimmed());
  if (QFileInfo::exists(path))
  {
    return tr("There is a preset %1 already: choose another name, or delete it first.").arg(name);
  }
  if (!QDir().mkpath(this->path()))
  {
    return tr("The folder %1 cannot be made.").arg(this->path());
  }
  const QString problem = pqTFCPresetFolder::write(path, state);
  return problem.isEmpty() ? problem : tr("%1 cannot be written: %2.").arg(path, problem);
}

//-----------------------------------------------------------------------------
QString pqTFCPresetFolder::rename(const Preset& preset, const QString& name)
{
  if (name.trimmed().isEmpty())
  {
    return tr("A preset needs a name.");
  }
  const QString path = this->fileOf(name.trimmed());
  if (path == preset.Path)
  {
    return QString();
  }
  if (QFileInfo::exists(path))
  {
    return tr("There is a preset %1 already: choose another name, or delete it first.").arg(name);
  }
  QFile file(preset.Path);
  return file.rename(path) ? QString()
                           : tr("%1 cannot be renamed: %2.").arg(preset.Name, file.errorString());
}

//-----------------------------------------------------------------------------
QString pqTFCPresetFolder::remove(const Preset& preset)
{
  QFile file(preset.Path);
  return file.remove() ? QString()
                       : tr("%1 cannot be deleted: %2.").arg(preset.Name, file.errorString());
}
