// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCProposal
 * @brief A first picture: fills an empty transfer function with axes and regions, and adds the
 * filters that give a dataset what it lacks.
 *
 * Axes: the first pair of the filter AxisSuggestion; where it has none, the array that colours the
 * data, or the first one, with the next array. Regions: vtkTFCProposal. Only when somebody chooses
 * "Combined Volume" with an empty transfer function, so that undo can bring back the empty one.
 */

#ifndef pqTFCProposal_h
#define pqTFCProposal_h

#include <QObject>
#include <QTimer>

class pqPipelineSource;
class pqTFCAdvice;
class pqTFCDocument;

class pqTFCProposal : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqTFCProposal(pqTFCDocument* document, pqTFCAdvice* advice, QObject* parent = nullptr);
  ~pqTFCProposal() override;

  /// Add the filter that makes a uniform grid of the active data, and show it.
  static void resampleToImage();

  /// Convert cell arrays to point arrays; the transfer function goes on with them.
  static void cellsToPoints(pqTFCDocument* document);

  /// Add the gradient magnitude of the primary attribute and put it on the secondary axis.
  static void computeGradient(pqTFCDocument* document);

  /// Add a property filter of the primary attribute; the transfer function stays as it is.
  static void compute(pqTFCDocument* document, const char* filter, const QString& title);

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
