// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Loaded into paraview by LD_PRELOAD: events that ParaView's playback lacks.
// "drop", with the path of a file: dropped as a file manager does it, from outside, onto any
// widget; Qt finds the one that takes it. "palette", with two colours: ground and text of the whole
// program. "cancel", with the name of a window that will show progress: its button is clicked as
// soon as the window is there, which is inside of the next event.
#include "pqApplicationCore.h"
#include "pqCoreTestUtility.h"
#include "pqEventPlayer.h"
#include "pqWidgetEventPlayer.h"

#include <QApplication>
#include <QDebug>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPalette>
#include <QPushButton>
#include <QTimer>
#include <QUrl>
#include <QWidget>

// Waits for a window and clicks its button, once.
class TFCCanceler : public QObject
{
  Q_OBJECT

public:
  TFCCanceler(const QString& window, QObject* parent)
    : QObject(parent)
    , Window(window)
  {
    QApplication::instance()->installEventFilter(this);
  }

protected:
  bool eventFilter(QObject* object, QEvent* event) override
  {
    auto* widget = qobject_cast<QWidget*>(object);
    if (event->type() == QEvent::Show && widget && widget->objectName() == this->Window)
    {
      // Posted, for when the window is processing its events.
      auto* button = widget->findChild<QPushButton*>();
      for (const QEvent::Type type : { QEvent::MouseButtonPress, QEvent::MouseButtonRelease })
      {
        QApplication::postEvent(button,
          new QMouseEvent(type, button->rect().center(), Qt::LeftButton, Qt::LeftButton,
            Qt::NoModifier));
      }
      this->deleteLater();
    }
    return false;
  }

private:
  QString Window;
};

// Players are told apart by the names of their classes.
class TFCEventPlayer : public pqWidgetEventPlayer
{
  Q_OBJECT

public:
  using pqWidgetEventPlayer::playEvent;
  using pqWidgetEventPlayer::pqWidgetEventPlayer;

  bool playEvent(QObject* object, const QString& command, const QString& arguments,
    bool& error) override
  {
    auto* widget = qobject_cast<QWidget*>(object);
    if (command == "palette")
    {
      const QStringList colors = arguments.split(' ');
      QPalette palette{ QColor(colors[0]) };
      palette.setColor(QPalette::Base, QColor(colors[0]));
      palette.setColor(QPalette::Text, QColor(colors[1]));
      QApplication::setPalette(palette);
      return true;
    }
    if (command == "cancel")
    {
      new TFCCanceler(arguments, this);
      return true;
    }
    if (command != "drop" || !widget)
    {
      return false;
    }
    QMimeData data;
    data.setUrls({ QUrl::fromLocalFile(arguments) });
    const QPoint middle = widget->rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QApplication::sendEvent(widget, &enter);
    if (!enter.isAccepted())
    {
      qCritical() << "Nobody takes" << arguments;
      error = true;
      return true;
    }
    QDropEvent drop(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(widget, &drop);
    return true;
  }
};

namespace
{
// ParaView's core comes after Qt's application.
void Install()
{
  pqApplicationCore* core = pqApplicationCore::instance();
  if (core)
  {
    core->testUtility()->eventPlayer()->addWidgetEventPlayer(new TFCEventPlayer(core));
  }
  else
  {
    QTimer::singleShot(0, Install);
  }
}

void Start()
{
  if (qobject_cast<QApplication*>(QCoreApplication::instance()))
  {
    // Not for what ParaView starts, such as MPI's daemon.
    qunsetenv("LD_PRELOAD");
    QTimer::singleShot(0, Install);
  }
}
}

Q_COREAPP_STARTUP_FUNCTION(Start)
#include "EventPlayer.moc"
