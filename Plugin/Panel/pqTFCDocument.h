// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCDocument
 * @brief What the parts of the editor share: the transfer function, the selected regions, the
 * attributes of the data and the histograms.
 *
 * Every part changes the model through edit() (one undo step), or through begin(), live() and
 * commit() while something is dragged, and shows what changed() says. No part knows another.
 */

#ifndef pqTFCDocument_h
#define pqTFCDocument_h

#include <QObject>
#include <QString>

#include "pqTFCAttribute.h"
#include "pqTFCHistogramCache.h"
#include "pqTFCStateLink.h"
#include "vtkNew.h"

#include <functional>
#include <string>
#include <vector>

class vtkEventQtSlotConnect;
class vtkTFCRegion;
class vtkTFCTransferFunction;

class pqTFCDocument : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqTFCDocument(QObject* parent = nullptr);
  ~pqTFCDocument() override;

  vtkTFCTransferFunction* model() const;
  pqTFCStateLink* link() { return &this->Link; }
  bool isReady() const { return this->Link.situation() == pqTFCStateLink::Ready; }
  QString state() const;

  ///@{
  /// Edits. The label names the undo step.
  void edit(const QString& label, const std::function<void()>& change);
  void begin();
  void live();
  void commit(const QString& label);
  /// Replace everything by a text; false, with a message, when it cannot be read.
  bool replace(const QString& label, const QString& json);
  ///@}

  /// Mean time of live() since begin(), for the benchmark: the way into the property and everything
  /// that the parts compute, without drawing.
  double millisecondsPerEvent() const;

  ///@{
  /// Ids of the selected regions; activeRegion() is the only selected one, or null.
  const std::vector<int>& selection() const { return this->Selection; }
  void setSelection(const std::vector<int>& ids);
  vtkTFCRegion* activeRegion() const;
  ///@}

  ///@{
  /// Attributes of the data: points first, then cells whose names are not among them.
  const std::vector<pqTFCAttribute>& attributes() const { return this->Attributes; }
  const pqTFCAttribute* findAttribute(const std::string& array, int component) const;
  QString labelOf(const std::string& array, int component) const;
  ///@}

  /// Give a region an attribute (by its index) as tertiary one, as an edit; -1 takes it away. All
  /// voxels of the region stay visible until the user says otherwise.
  void setTertiary(vtkTFCRegion* region, int index);

  /// Time of the view that shows the data.
  double time() const;

  /// Ranges of the axes as the renderer uses them; false without axes.
  bool axisRanges(double ranges[4]) const;
  /// Range of a region's tertiary attribute: its own, the data's, or that of its nodes.
  void tertiaryRange(vtkTFCRegion* region, double range[2]) const;

  ///@{
  /// Histograms; null while they are on their way. `weights` are those of the region's cells, as
  /// GetConditional() wants them.
  vtkTFCSparseHistogram* plane();
  vtkTFCSparseHistogram* joint(vtkTFCRegion* region);
  bool conditional(vtkTFCRegion* region, std::vector<double>& counts, double range[2]);
  /// `number` quantiles of an attribute, see vtkTFCQuantiles: counted on the server in 4096 bins
  /// over its extent, at once. Empty when there are none.
  std::vector<double> quantiles(const pqTFCAttribute& attribute, int number);
  /// Whether plane(), or joint() of a region, was requested and is still to come.
  bool isStale(vtkTFCRegion* region) const;
  /// Whether the data have the arrays for it, all of points or all of cells.
  bool hasArrays(vtkTFCRegion* region) const;
  bool isFetching() const { return this->Cache.isFetching(); }
  void fetchNow() { this->Cache.fetchNow(); }
  ///@}

public Q_SLOTS:
  /// One sentence for the user, shown in the panel.
  void say(const QString& message) { Q_EMIT this->said(message); }

Q_SIGNALS:
  void targetChanged();
  void attributesChanged();
  /// The model changed; live while something is dragged.
  void changed(bool live);
  void selectionChanged();
  void histogramsChanged();
  void said(const QString& message);

private Q_SLOTS:
  void onTargetChanged();
  void onDataChanged();
  void readState();
  void onModelError();

private:
  Q_DISABLE_COPY(pqTFCDocument)

  void collectAttributes();
  pqTFCAxis axis(int index, const double ranges[4]) const;
  bool histogramAxes(vtkTFCRegion* region, std::vector<pqTFCAxis>& axes) const;

  vtkNew<vtkTFCTransferFunction> Model;
  vtkNew<vtkEventQtSlotConnect> Events;
  pqTFCStateLink Link;
  pqTFCHistogramCache Cache;
  std::vector<pqTFCAttribute> Attributes;
  std::vector<int> Selection;
  double LiveTime = 0; ///< ms, of the current or last drag
  int LiveEvents = 0;
};

#endif
