// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCAdvice
 * @brief What the advice's filters say about the data of the editor: scores of attributes, pairs of
 * axes, and what splits a region.
 *
 * Answers come from filters on the server (passes over the data), so they are kept until data or
 * axes change, those of splits() until a region changes its outline or fall-off: that filter stays
 * and keeps its histograms, so its next answer needs no pass. See Plugin/Documentation/advice.md
 * for what the numbers mean.
 */

#ifndef pqTFCAdvice_h
#define pqTFCAdvice_h

#include <QByteArray>
#include <QObject>
#include <QString>

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class pqTFCDocument;
class vtkSMProxy;
class vtkSMSourceProxy;
class vtkTFCTableInformation;
class vtkTFCTransferFunction;

class pqTFCAdvice : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqTFCAdvice(pqTFCDocument* document, QObject* parent = nullptr);
  ~pqTFCAdvice() override;

  /// An attribute as a candidate for the tertiary one. The score depends on the balance a:
  /// -a |correlation| + (1 - a) entropy / largest entropy.
  struct Candidate
  {
    std::string Array;
    int Component = 0;
    QString Label;
    double Correlation = 0; ///< with the primary attribute
    double Entropy = 0;     ///< bits
    double LargestEntropy = 1;
    double Score(double balance) const;
  };
  /// Candidates for the axes of the document, best first for a balance of 0.4; empty when the
  /// filter cannot say.
  const std::vector<Candidate>& candidates();
  /// What candidates() would return if that needs no computation, else empty.
  const std::vector<Candidate>& knownCandidates() const { return this->Candidates; }

  /// A pair of attributes for the axes.
  struct Pair
  {
    std::string Primary;
    std::string Secondary;
    QString Kind;
    double Score = 0;
  };
  const std::vector<Pair>& pairs();

  /// How an attribute splits the voxels of a region.
  struct Split
  {
    int Region = 0; ///< its id
    QString Attribute;
    double Power = 0;  ///< 0 to 1
    double Cut = 0;    ///< data units
    double Below = 0;  ///< part of the region
    QString KeepAbove; ///< "tertiary" of the region's state, JSON
    QString KeepBelow;
  };
  /// Of a visible region, best attribute first.
  std::vector<Split> splits(int region);
  /// The filter of splits() is no longer needed.
  void releaseSplits();

  /// Set a region's "tertiary" to such a text, as one edit.
  void apply(int region, const QString& tertiary);

  /// Run a filter over the edited data on the server; the table of its first output, which is empty
  /// when it failed, and of another into `second`.
  vtkSmartPointer<vtkTFCTableInformation> run(const char* filter,
    const std::function<void(vtkSMProxy*)>& prepare, vtkTFCTableInformation* second = nullptr);

public Q_SLOTS:
  /// All answers: the data have changed.
  void forget();

private:
  Q_DISABLE_COPY(pqTFCAdvice)

  vtkSmartPointer<vtkSMSourceProxy> makeFilter(const char* name) const;
  vtkSmartPointer<vtkTFCTableInformation> gather(vtkSMSourceProxy* filter,
    vtkTFCTableInformation* second = nullptr) const;
  bool hasMoreThanAxes() const;
  void computeSplits();

  pqTFCDocument* Document;
  std::vector<Candidate> Candidates;
  std::string CandidatesAxes; ///< what they were computed for
  std::vector<Pair> Pairs;
  bool HasPairs = false;
  std::vector<Split> Splits;
  QByteArray SplitsState; ///< what of the state they depend on
  vtkSmartPointer<vtkSMSourceProxy> SplitFilter;
};

#endif
