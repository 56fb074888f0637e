// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCProposal
 * @brief A first picture: fills an empty transfer function with axes and regions.
 *
 * Axes: the first pair of the filter AxisSuggestion; where it has none, the array that colours the
 * data, or the first one, with the next array. Regions: vtkTFCProposal. Only when somebody chooses
 * "Combined Volume" with an empty transfer function, so that undo can bring back the empty one.
 */

#ifndef pqTFCProposal_h
#define pqTFCProposal_h

#include <QObject>
#include <QTimer>

class pqTFCAdvice;
class pqTFCDocument;

class pqTFCProposal : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqTFCProposal(pqTFCDocument* document, pqTFCAdvice* advice, QObject* parent = nullptr);
  ~pqTFCProposal() override;

private Q_SLOTS:
  void later();
  void propose();

private:
  Q_DISABLE_COPY(pqTFCProposal)

  bool proposeAxes();

  pqTFCDocument* Document;
  pqTFCAdvice* Advice;
  QTimer Timer;
};

#endif
