// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCHistogramCache
 * @brief Joint histograms from the server, kept on the client.
 *
 * request() answers at once from what is there. When the histogram is not there, or older than the
 * data, it is fetched a little later, outside of any drag and not while the data change again and
 * again, because fetching blocks the window (ParaView 5.11 handles no events while a server works):
 * one histogram at a time, with arrived() after each. One hidden
 * filter per input stays on the server; only histograms are sent, never data.
 */

#ifndef pqTFCHistogramCache_h
#define pqTFCHistogramCache_h

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

class pqOutputPort;
class vtkSMSourceProxy;
class vtkTFCSparseHistogram;

/// Component of an array with the range that is counted.
struct pqTFCAxis
{
  std::string Array;
  int Component = 0;
  double Range[2] = { 0, 1 };
  bool Integral = false; ///< values are whole numbers
  bool operator<(const pqTFCAxis& other) const;
};

class pqTFCHistogramCache : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqTFCHistogramCache(QObject* parent = nullptr);
  ~pqTFCHistogramCache() override;

  /// Where the data are; another input drops all histograms.
  void setInput(pqOutputPort* port, double time);

  /// The data changed: what is there stays until it is fetched anew.
  void setStale();

  /// Three axes; the third without an array name stands for a histogram of two.
  using Key = std::vector<pqTFCAxis>;

  /// A histogram; null when it is not there yet. What is returned may be stale.
  vtkTFCSparseHistogram* request(const Key& key);

  /// Counts of one axis in fine bins over its range, fetched at once; empty when that fails.
  std::vector<double> distribution(const pqTFCAxis& axis);

  ///@{
  /// Whether this one, or any, was requested and is still to come.
  bool isWanted(const Key& key) const;
  bool isFetching() const { return !this->Wanted.empty(); }
  ///@}

  /// Nothing is fetched while something is dragged.
  void setPaused(bool paused);

  /// Fetch all that is wanted now instead of in a moment.
  void fetchNow();

Q_SIGNALS:
  void arrived();

private Q_SLOTS:
  void fetch();
  void clear();

private:
  Q_DISABLE_COPY(pqTFCHistogramCache)

  struct Entry
  {
    vtkSmartPointer<vtkTFCSparseHistogram> Histogram;
    bool Stale = false;
    unsigned int LastUse = 0;
  };
  vtkSmartPointer<vtkTFCSparseHistogram> compute(const Key& key);
  vtkSmartPointer<vtkTFCSparseHistogram> compute(const Key& key, int primaryBins,
    int secondaryBins);

  QPointer<pqOutputPort> Port;
  double Time = 0;
  vtkSmartPointer<vtkSMSourceProxy> Filter;
  std::map<Key, Entry> Entries;
  std::vector<Key> Wanted;
  unsigned int Uses = 0;
  bool Paused = false;
  QTimer Timer;
};

#endif
