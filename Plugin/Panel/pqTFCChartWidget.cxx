// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCChartWidget.h"

#include "vtkContextMouseEvent.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTFCDomainChart.h"
#include "vtkTFCHistogramItem.h"

#include <QKeyEvent>
#include <QTimer>

#include <cmath>

namespace
{
constexpr double ROUNDING = 1e-9; // of the axis

// The names that vtkTFCDomainChart::HandleKey() knows.
QString KeyName(const QKeyEvent* event)
{
  switch (event->key())
  {
    case Qt::Key_Left:
      return "Left";
    case Qt::Key_Right:
      return "Right";
    case Qt::Key_Up:
      return "Up";
    case Qt::Key_Down:
      return "Down";
    case Qt::Key_PageUp:
      return "PageUp";
    case Qt::Key_PageDown:
      return "PageDown";
    case Qt::Key_Delete:
      return "Delete";
    case Qt::Key_Backspace:
      return "Backspace";
    case Qt::Key_Tab:
      return "Tab";
    case Qt::Key_Backtab:
      return "Backtab";
    case Qt::Key_Escape:
      return "Escape";
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return "Return";
    default:
      // Not text(): with Control it is a control character.
      return event->key() >= Qt::Key_Space && event->key() <= Qt::Key_AsciiTilde
        ? QString(QChar(event->key())).toLower()
        : QString();
  }
}
}

//-----------------------------------------------------------------------------
pqTFCChartWidget::pqTFCChartWidget(QWidget* parentObject)
  : Superclass(parentObject)
{
  this->setObjectName("Chart");
  this->setAccessibleName(tr("Domain chart"));
  this->setAccessibleDescription(
    tr("Joint histogram of the two axes with the regions. All that can be done here can also be "
       "typed in the list and the fields below."));
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMinimumSize(180, 160);
  // As pqQVTKWidget does: baselines must not depend on the screen.
  this->setEnableHiDPI(!qEnvironmentVariableIsSet("DASHBOARD_TEST_FROM_CTEST"));

  vtkNew<vtkGenericOpenGLRenderWindow> window;
  this->setRenderWindow(window);
  this->View->SetRenderWindow(window);
  this->View->SetInteractor(window->GetInteractor());
  this->View->GetScene()->AddItem(this->Chart);
  this->followPalette();

  const std::array<unsigned long, 7> events = { { vtkCommand::StartInteractionEvent,
    vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent,
    vtkCommand::SelectionChangedEvent, vtkTFCDomainChart::ToolChangedEvent,
    vtkTFCDomainChart::HoverEvent, vtkTFCDomainChart::MessageEvent } };
  for (unsigned long event : events)
  {
    this->Events->Connect(this->Chart, event, this,
      SLOT(onChartEvent(vtkObject*, unsigned long, void*, void*)));
  }
  this->Events->Connect(this->Chart, vtkCommand::ModifiedEvent, this,
    SLOT(onChartEvent(vtkObject*, unsigned long, void*, void*)));
}

//-----------------------------------------------------------------------------
pqTFCChartWidget::~pqTFCChartWidget() = default;

//-----------------------------------------------------------------------------
vtkTFCDomainChart* pqTFCChartWidget::chart() const
{
  return this->Chart;
}

//-----------------------------------------------------------------------------
QString pqTFCChartWidget::view() const
{
  double view[4];
  double ranges[4];
  QStringList ends;
  this->Chart->GetViewRange(view);
  this->Chart->GetAxisRanges(ranges);
  for (int i = 0; i < 4; ++i)
  {
    const double* range = ranges + i / 2 * 2;
    const double size = range[1] - range[0];
    const double end = range[0] + view[i] * size;
    ends << QString::number(std::abs(end) < ROUNDING * size ? 0 : end, 'g', 4);
  }
  return ends.join(' ');
}

//-----------------------------------------------------------------------------
QString pqTFCChartWidget::look() const
{
  const QStringList scales = { "linear", "logarithmic", "percentile" };
  const QStringList colors = { "gray", "viridis", "inferno" };
  vtkTFCHistogramItem* histogram = this->Chart->GetHistogram();
  return scales[histogram->GetScale()] + " " + colors[histogram->GetColorMap()];
}

//-----------------------------------------------------------------------------
int pqTFCChartWidget::pictureNumber()
{
  this->renderWindow()->Render();
  const QImage now = this->grabFramebuffer();
  if (!this->Pictures.contains(now))
  {
    this->Pictures << now;
  }
  return this->Pictures.indexOf(now);
}

//-----------------------------------------------------------------------------
void pqTFCChartWidget::onChartEvent(vtkObject*, unsigned long event, void*, void* data)
{
  switch (event)
  {
    case vtkCommand::StartInteractionEvent:
      Q_EMIT this->editStarted();
      break;
    case vtkCommand::InteractionEvent:
      Q_EMIT this->edited();
      break;
    case vtkCommand::EndInteractionEvent:
      Q_EMIT this->editFinished();
      break;
    case vtkCommand::SelectionChangedEvent:
      Q_EMIT this->selectionChanged();
      break;
    case vtkTFCDomainChart::ToolChangedEvent:
      this->setCursor(
        this->Chart->GetTool() == vtkTFCDomainChart::Select ? Qt::ArrowCursor : Qt::CrossCursor);
      Q_EMIT this->toolChanged();
      break;
    case vtkTFCDomainChart::HoverEvent:
      Q_EMIT this->hovered();
      break;
    case vtkTFCDomainChart::MessageEvent:
      Q_EMIT this->said(QString::fromUtf8(static_cast<const char*>(data)));
      break;
    default:
      this->renderLater();
  }
}

//-----------------------------------------------------------------------------
void pqTFCChartWidget::renderLater()
{
  if (!this->RenderPending)
  {
    this->RenderPending = true;
    QTimer::singleShot(0, this, &pqTFCChartWidget::renderNow);
  }
}

//-----------------------------------------------------------------------------
void pqTFCChartWidget::renderNow()
{
  this->RenderPending = false;
  if (this->isVisible())
  {
    this->renderWindow()->Render();
  }
}

//-----------------------------------------------------------------------------
void pqTFCChartWidget::keyPressEvent(QKeyEvent* e)
{
  const QString key = KeyName(e);
  const bool shift = e->modifiers() & Qt::ShiftModifier;
  const bool control = e->modifiers() & Qt::ControlModifier;
  if (key.isEmpty() || !this->Chart->HandleKey(key.toStdString(), shift, control))
  {
    e->ignore();
  }
}

//-----------------------------------------------------------------------------
void pqTFCChartWidget::keyReleaseEvent(QKeyEvent* e)
{
  e->ignore();
}

//-----------------------------------------------------------------------------
bool pqTFCChartWidget::event(QEvent* e)
{
  if (e->type() == QEvent::ShortcutOverride)
  {
    // Plain keys are the chart's while it has the focus, not those of ParaView's menus.
    auto* key = static_cast<QKeyEvent*>(e);
    const bool control = key->modifiers() & Qt::ControlModifier;
    const QString name = KeyName(key);
    if (!name.isEmpty() && (!control || name == "a" || name == "d"))
    {
      e->accept();
      return true;
    }
  }
  if (e->type() == QEvent::KeyPress || e->type() == QEvent::KeyRelease)
  {
    // Past VTK's widget: through its interactor the chart would get the key a second time, and
    // VTK's own keys (3 for stereo, e for exit) would act as well.
    return QOpenGLWidget::event(e);
  }
  if (e->type() == QEvent::Leave)
  {
    // VTK's scene does not tell its items that the pointer left the window.
    this->Chart->MouseLeaveEvent(vtkContextMouseEvent());
  }
  return this->Superclass::event(e);
}

//-----------------------------------------------------------------------------
bool pqTFCChartWidget::focusNextPrevChild(bool next)
{
  // Tab goes through the regions first, then on to the next widget.
  return this->Chart->HandleKey(next ? "Tab" : "Backtab", false, false) ||
    this->Superclass::focusNextPrevChild(next);
}

//-----------------------------------------------------------------------------
void pqTFCChartWidget::changeEvent(QEvent* e)
{
  this->Superclass::changeEvent(e);
  if (e->type() == QEvent::PaletteChange)
  {
    this->followPalette();
  }
}

//-----------------------------------------------------------------------------
void pqTFCChartWidget::followPalette()
{
  const QColor ground = this->palette().color(QPalette::Window);
  this->View->GetRenderer()->SetBackground(ground.redF(), ground.greenF(), ground.blueF());
  this->Chart->SetDark(ground.lightness() < 128);
}
