// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCAdviceDialog
 * @brief The advice in numbers: pairs of axes, the score of every attribute with the balance as a
 * slider, and what splits the selected region. Every row can be followed with one button.
 *
 * While it is open it follows the document: the selected region, edits, the active representation
 * and its data. Nothing is computed while something is dragged or an animation plays.
 */

#ifndef pqTFCAdviceDialog_h
#define pqTFCAdviceDialog_h

#include <QDialog>
#include <QTimer>

#include "pqTFCAdvice.h"

#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;
class pqDoubleRangeWidget;
class pqTFCDocument;

class pqTFCAdviceDialog : public QDialog
{
  Q_OBJECT
  typedef QDialog Superclass;

public:
  pqTFCAdviceDialog(pqTFCDocument* document, pqTFCAdvice* advice, QWidget* parent = nullptr);
  ~pqTFCAdviceDialog() override;

private Q_SLOTS:
  void followLater();
  void follow();
  void fillScores();

private:
  Q_DISABLE_COPY(pqTFCAdviceDialog)

  void fill();
  void fillAxes();
  void fillSplits();
  void useAxes(int row);
  void useTertiary(int row);
  void keep(int row, bool above);
  QTableWidget* makeTable(const QString& name, const QStringList& columns);
  /// The button of a row, made when it is missing: buttons stay, as one of them may be under way.
  QPushButton* button(QTableWidget* table, int row, int column, const QString& text,
    const QString& name);

  pqTFCDocument* Document;
  pqTFCAdvice* Advice;
  ///@{
  /// In the order of the tables.
  std::vector<pqTFCAdvice::Pair> Pairs;
  std::vector<pqTFCAdvice::Candidate> Candidates;
  std::vector<pqTFCAdvice::Split> Shown;
  ///@}
  QTimer Timer;
  QTableWidget* Axes;
  QTableWidget* Scores;
  QTableWidget* Splits;
  QLabel* AxesTitle;
  QLabel* Region;
  pqDoubleRangeWidget* Balance;
};

#endif
