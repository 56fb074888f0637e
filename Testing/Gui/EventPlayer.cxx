// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Loaded into paraview by LD_PRELOAD: events that ParaView's playback lacks.
// "cancel", with the name of a window that will show progress: its button is clicked as soon as the
// window is there, which is inside of the next event.
// "color", with a colour: chosen in the next dialog that asks for one.
// "drop", with the path of a file: dropped as a file manager does it, from outside, onto any
// widget; Qt finds the one that takes it.
// "near", with a property, a tolerance and numbers: the property holds these numbers.
// "palette", with two colours: ground and text of the whole program.
// "save", with a property and the path of a file: writes the property there, for a script.
// "stroke", with a number of moves and two frequencies: the left button drags along their Lissajous
// curve around the middle of the domain in the chart.
// "wheel", with place in the widget (0 to 1, from the upper left) and angle in eighths of a degree.
#include "pqApplicationCore.h"
#include "pqCoreTestUtility.h"
#include "pqEventPlayer.h"
#include "pqWidgetEventPlayer.h"

#include <QApplication>
#include <QColorDialog>
#include <QDebug>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QMouseEvent>
#include <QPalette>
#include <QPushButton>
#include <QRegularExpression>
#include <QTimer>
#include <QUrl>
#include <QWheelEvent>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

// Waits for a window that `act` takes, once. What it does there has to be posted: for when the
// window processes its events.
class TFCWindowWaiter : public QObject
{
  Q_OBJECT

public:
  using Act = std::function<bool(QWidget*)>;

  TFCWindowWaiter(Act act, QObject* parent)
    : QObject(parent)
    , TryToAct(std::move(act))
  {
    QApplication::instance()->installEventFilter(this);
  }

protected:
  bool eventFilter(QObject* object, QEvent* event) override
  {
    auto* widget = qobject_cast<QWidget*>(object);
    if (event->type() == QEvent::Show && widget && this->TryToAct(widget))
    {
      this->deleteLater();
    }
    return false;
  }

private:
  Act TryToAct;
};

namespace
{
bool Cancel(QWidget* window, const QString& name)
{
  auto* button = window->objectName() == name ? window->findChild<QPushButton*>() : nullptr;
  for (const QEvent::Type type : { QEvent::MouseButtonPress, QEvent::MouseButtonRelease })
  {
    if (button)
    {
      QApplication::postEvent(button,
        new QMouseEvent(type, button->rect().center(), Qt::LeftButton, Qt::LeftButton,
          Qt::NoModifier));
    }
  }
  return button != nullptr;
}

bool ChooseColor(QWidget* window, const QColor& color)
{
  auto* dialog = qobject_cast<QColorDialog*>(window);
  if (dialog)
  {
    QMetaObject::invokeMethod(
      dialog,
      [dialog, color]()
      {
        dialog->setCurrentColor(color);
        dialog->accept();
      },
      Qt::QueuedConnection);
  }
  return dialog != nullptr;
}
}

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
      new TFCWindowWaiter([arguments](QWidget* w) { return Cancel(w, arguments); }, this);
      return true;
    }
    if (command == "color")
    {
      const QColor color(arguments);
      new TFCWindowWaiter([color](QWidget* w) { return ChooseColor(w, color); }, this);
      return true;
    }
    if (command == "wheel" && widget)
    {
      const QStringList numbers = arguments.split(' ');
      const QPointF place(numbers[0].toDouble() * widget->width(),
        numbers[1].toDouble() * widget->height());
      QWheelEvent event(place, widget->mapToGlobal(place.toPoint()), QPoint(),
        QPoint(0, numbers[2].toInt()), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
      QApplication::sendEvent(widget, &event);
      return true;
    }
    if (command == "stroke" && widget)
    {
      const QStringList numbers = arguments.split(' ');
      stroke(widget, numbers[0].toInt(), numbers[1].toDouble(), numbers[2].toDouble());
      return true;
    }
    if (command == "save")
    {
      QFile file(arguments.section(' ', 1));
      const QByteArray text = this->property(object, arguments.section(' ', 0, 0));
      error = text.isEmpty() || !file.open(QIODevice::WriteOnly) || file.write(text) != text.size();
      return true;
    }
    if (command == "near")
    {
      error = !this->isNear(object, arguments.split(' '));
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

private:
  static void stroke(QWidget* widget, int moves, double a, double b)
  {
    for (int i = -1; i <= moves; ++i)
    {
      const double angle = 2 * M_PI * std::max(i, 0) / moves;
      const QPointF place((0.55 + 0.2 * std::sin(a * angle)) * widget->width(),
        (0.43 + 0.2 * std::sin(b * angle + 1)) * widget->height());
      const QEvent::Type type = i < 0 ? QEvent::MouseButtonPress
        : i < moves                   ? QEvent::MouseMove
                                      : QEvent::MouseButtonRelease;
      QMouseEvent event(type, place, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
        i < moves ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
      QApplication::sendEvent(widget, &event);
    }
    QCoreApplication::processEvents();
  }

  static QByteArray property(QObject* object, const QString& name)
  {
    const QVariant value = object->property(name.toUtf8().constData());
    if (!value.isValid())
    {
      qCritical() << object << "has no property" << name;
    }
    return value.toString().toUtf8();
  }

  static bool isNear(QObject* object, const QStringList& arguments)
  {
    static const QRegularExpression separators("[\\s,;:]+");
    const QString text = property(object, arguments[0]);
    const QStringList found = text.split(separators, Qt::SkipEmptyParts);
    bool same = found.size() == arguments.size() - 2;
    for (int i = 0; same && i < found.size(); ++i)
    {
      bool isNumber = false;
      const double difference = found[i].toDouble(&isNumber) - arguments[i + 2].toDouble();
      same = isNumber && std::abs(difference) <= arguments[1].toDouble();
    }
    if (!same)
    {
      qCritical() << arguments[0] << "is" << text << "and not near" << arguments.mid(2);
    }
    return same;
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
