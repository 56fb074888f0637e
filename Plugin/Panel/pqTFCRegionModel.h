// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCRegionModel
 * @brief The regions as a table for Qt's views: one row per region, in list order, and every
 * property of a region in a column, where it is edited as text, see pqTFCRegionText.h.
 *
 * Every edit is one step of undo; what cannot be read is refused with a message. A locked region
 * can be shown, hidden and unlocked. Cells and headers have names for screen readers.
 */

#ifndef pqTFCRegionModel_h
#define pqTFCRegionModel_h

#include <QAbstractTableModel>
#include <QIcon>
#include <QStringList>

class pqTFCDocument;
class vtkTFCRegion;

class pqTFCRegionModel : public QAbstractTableModel
{
  Q_OBJECT
  typedef QAbstractTableModel Superclass;

public:
  /// Name has the check box for visibility and the colour; Lock is a check box.
  enum Columns
  {
    Name,
    Opacity,
    Falloff,
    Width,
    Tertiary,
    Lock,
    Color,
    Shape,
    OpacityPoints,
    ColorPoints,
    TertiaryRange,
    NumberOfColumns
  };
  /// For settings, and object names.
  static QString columnName(int column);
  /// In the order of vtkTFCRegion::FalloffTypes.
  static QStringList falloffs();

  pqTFCRegionModel(pqTFCDocument* document, QObject* parent = nullptr);
  ~pqTFCRegionModel() override;

  int rowCount(const QModelIndex& parent = QModelIndex()) const override;
  int columnCount(const QModelIndex& parent = QModelIndex()) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  vtkTFCRegion* region(int row) const;

private Q_SLOTS:
  void refresh();

private:
  Q_DISABLE_COPY(pqTFCRegionModel)

  QString text(vtkTFCRegion* region, int column) const;
  QIcon swatch(vtkTFCRegion* region) const;
  bool setText(vtkTFCRegion* region, int column, const QString& text);
  bool setNumber(vtkTFCRegion* region, int column, const QString& text);
  bool setTertiary(vtkTFCRegion* region, const QVariant& value);

  pqTFCDocument* Document;
  int Rows = 0;
};

#endif
