// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCPanel
 * @brief The dock "Combined Transfer Functions": an editor of the property `TransferFunction` of
 * the active "Combined Volume" representation.
 *
 * It puts the parts together: axes, chart, list of regions, their values, and the 1D function of
 * the selected one. They share a pqTFCDocument and know nothing of each other.
 */

#ifndef pqTFCPanel_h
#define pqTFCPanel_h

#include <QDockWidget>
#include <QString>

class QLabel;
class QToolButton;
class pqTFCAdvice;
class pqTFCAxisBar;
class pqTFCChartWidget;
class pqTFCDocument;
class pqTFCHighlight;
class pqTFCMessageBar;
class pqTFCPresets;
class pqTFCProbe;
class pqTFCProbeMark;
class pqTFCTertiaryEditor;

class pqTFCPanel : public QDockWidget
{
  Q_OBJECT
  typedef QDockWidget Superclass;

  /// For tests: the JSON text as the property has it, and what the panel says.
  Q_PROPERTY(QString state READ state)
  Q_PROPERTY(int stateNumber READ stateNumber)
  Q_PROPERTY(QString message READ message)
  Q_PROPERTY(int regions READ regions)
  Q_PROPERTY(QString selectedShape READ selectedShape)
  Q_PROPERTY(int selectedCorners READ selectedCorners)
  Q_PROPERTY(int voxelsInPlane READ voxelsInPlane)
  Q_PROPERTY(int voxelsInRegion READ voxelsInRegion)
  Q_PROPERTY(double millisecondsPerEvent READ millisecondsPerEvent)
  Q_PROPERTY(QString probe READ probe)
  Q_PROPERTY(QString probedTertiary READ probedTertiary)
  Q_PROPERTY(bool fresh READ isFresh)
  Q_PROPERTY(int staleNotes READ staleNotes)
  Q_PROPERTY(int highlighted READ highlighted)
  Q_PROPERTY(QString outOfReach READ outOfReach)

public:
  pqTFCPanel(QWidget* parent = nullptr);
  ~pqTFCPanel() override;

  QString state() const;
  /// Counts the different states that were asked for: undo is right when an old number returns.
  int stateNumber();
  QString message() const;
  int regions() const;
  QString selectedShape() const;
  /// Of a polygon; 0 for all else.
  int selectedCorners() const;
  int voxelsInPlane();
  int voxelsInRegion() const;
  /// Of the last drag, see pqTFCDocument.
  double millisecondsPerEvent() const;

  /// What the last click into the view found; empty while the probe is off.
  QString probe() const;

  /// Waits until the histograms have come by themselves; false when they do not.
  bool isFresh() const;
  /// How often the chart has said that its histogram is out of date.
  int staleNotes() const { return this->StaleNotes; }

  /// Value and place of the mark over the 1D function, 0.0 to 1.0; empty while there is none.
  QString probedTertiary() const;

  /// Id of the region that stands out in the view, 0 for none.
  int highlighted() const;

  /// Parts without a name or a way to them by keyboard, see pqTFCReach.h.
  QString outOfReach() const;

protected:
  /// Transfer function files can be dropped anywhere on the panel.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private Q_SLOTS:
  void onTargetChanged();
  void onChanged(bool live);
  void onHistograms();
  void onHover();
  void highlightHovered();

private:
  Q_DISABLE_COPY(pqTFCPanel)

  void updateChart();

  pqTFCDocument* Document;
  pqTFCAdvice* Advice;
  pqTFCChartWidget* Chart;
  pqTFCAxisBar* Axes;
  pqTFCTertiaryEditor* Tertiary;
  pqTFCMessageBar* Messages;
  QLabel* Status;
  QToolButton* AtProbe; ///< where the status is of a probed place
  pqTFCPresets* Presets;
  pqTFCProbe* Probe;
  pqTFCProbeMark* Mark;
  pqTFCHighlight* Highlight;
  QStringList States; ///< in the order of stateNumber()
  QString EditLabel;  ///< of the edit that goes on in the chart
  int StaleNotes = 0;
  bool StaleShown = false;
};

#endif
