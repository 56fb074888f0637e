// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCAdviceDialog
 * @brief The advice in numbers: pairs of axes, the score of every attribute with the balance as a
 * slider, and what splits the selected region. Every row can be followed with one button.
 */

#ifndef pqTFCAdviceDialog_h
#define pqTFCAdviceDialog_h

#include <QDialog>

#include "pqTFCAdvice.h"

class QLabel;
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
  void fillAxes();
  void fillScores();
  void fillSplits();

private:
  Q_DISABLE_COPY(pqTFCAdviceDialog)

  void useTertiary(int row);
  QTableWidget* makeTable(const QString& name, const QStringList& columns);

  pqTFCDocument* Document;
  pqTFCAdvice* Advice;
  std::vector<pqTFCAdvice::Candidate> Candidates; ///< in the order of the table
  QTableWidget* Axes;
  QTableWidget* Scores;
  QTableWidget* Splits;
  QLabel* Region;
  pqDoubleRangeWidget* Balance;
};

#endif
