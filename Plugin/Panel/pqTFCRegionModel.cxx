// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCRegionModel.h"

#include "pqTFCDocument.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QStringList>

#include <algorithm>

namespace
{
const QStringList& FalloffNames()
{
  static const QStringList names = { "constant", "linear", "smooth", "gaussian" };
  return names;
}
}

//-----------------------------------------------------------------------------
pqTFCRegionModel::pqTFCRegionModel(pqTFCDocument* document, QObject* parentObject)
  : Superclass(parentObject)
  , Document(document)
{
  QObject::connect(document, &pqTFCDocument::changed, this, &pqTFCRegionModel::refresh);
  QObject::connect(document, &pqTFCDocument::attributesChanged, this, &pqTFCRegionModel::refresh);
  this->refresh();
}

//-----------------------------------------------------------------------------
pqTFCRegionModel::~pqTFCRegionModel() = default;

//-----------------------------------------------------------------------------
void pqTFCRegionModel::refresh()
{
  const int rows = this->Document->model()->GetNumberOfRegions();
  if (rows > this->Rows)
  {
    this->beginInsertRows(QModelIndex(), this->Rows, rows - 1);
    this->Rows = rows;
    this->endInsertRows();
  }
  else if (rows < this->Rows)
  {
    this->beginRemoveRows(QModelIndex(), rows, this->Rows - 1);
    this->Rows = rows;
    this->endRemoveRows();
  }
  if (rows)
  {
    Q_EMIT this->dataChanged(this->index(0, 0), this->index(rows - 1, NumberOfColumns - 1));
  }
}

//-----------------------------------------------------------------------------
vtkTFCRegion* pqTFCRegionModel::region(int row) const
{
  return row >= 0 && row < this->Document->model()->GetNumberOfRegions()
    ? this->Document->model()->GetRegion(row)
    : nullptr;
}

//-----------------------------------------------------------------------------
int pqTFCRegionModel::rowCount(const QModelIndex& parentIndex) const
{
  return parentIndex.isValid() ? 0 : this->Rows;
}

//-----------------------------------------------------------------------------
int pqTFCRegionModel::columnCount(const QModelIndex& parentIndex) const
{
  return parentIndex.isValid() ? 0 : NumberOfColumns;
}

//-----------------------------------------------------------------------------
QVariant pqTFCRegionModel::data(const QModelIndex& index, int role) const
{
  vtkTFCRegion* region = this->region(index.row());
  if (!region)
  {
    return QVariant();
  }
  const QString name = QString::fromUtf8(region->GetName().c_str());
  if (role == Qt::CheckStateRole && (index.column() == Name || index.column() == Lock))
  {
    const bool on = index.column() == Name ? region->GetVisible() : region->GetLocked();
    return on ? Qt::Checked : Qt::Unchecked;
  }
  if (role == Qt::DecorationRole && index.column() == Name)
  {
    double color[3];
    region->GetColor(color);
    // An icon with a selected state of its own: Qt would tint a plain colour in a selected row.
    QPixmap swatch(16, 16);
    swatch.fill(QColor::fromRgbF(color[0], color[1], color[2]));
    QIcon icon(swatch);
    icon.addPixmap(swatch, QIcon::Selected);
    return icon;
  }
  if (role == Qt::AccessibleTextRole && index.column() == Name)
  {
    return tr("%1, %2").arg(name, region->GetVisible() ? tr("visible") : tr("hidden"));
  }
  if (role == Qt::AccessibleTextRole && index.column() == Lock)
  {
    return region->GetLocked() ? tr("locked") : tr("not locked");
  }
  if (role != Qt::DisplayRole && role != Qt::EditRole)
  {
    return QVariant();
  }
  switch (index.column())
  {
    case Name:
      return name;
    case Opacity:
      return region->GetOpacity();
    case Falloff:
      return FalloffNames()[region->GetFalloffType()];
    case Width:
      return region->GetFalloffType() == vtkTFCRegion::Constant && role == Qt::DisplayRole
        ? QVariant(QString())
        : QVariant(region->GetFalloffWidth());
    case Tertiary:
      return region->HasTertiary()
        ? this->Document->labelOf(region->GetTertiaryArray(), region->GetTertiaryComponent())
        : tr("None");
    default:
      return QVariant();
  }
}

//-----------------------------------------------------------------------------
bool pqTFCRegionModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  vtkTFCRegion* region = this->region(index.row());
  if (!region)
  {
    return false;
  }
  if (role == Qt::CheckStateRole)
  {
    const bool on = value.toInt() == Qt::Checked;
    this->Document->edit(index.column() == Lock ? tr("Lock region") : tr("Show or hide region"),
      [&]() { index.column() == Lock ? region->SetLocked(on) : region->SetVisible(on); });
    return true;
  }
  if (role != Qt::EditRole)
  {
    return false;
  }
  bool isNumber = false;
  const double number = value.toDouble(&isNumber);
  const int falloff = FalloffNames().indexOf(value.toString().trimmed().toLower());
  switch (index.column())
  {
    case Name:
      this->Document->edit(tr("Rename region"),
        [&]() { region->SetName(value.toString().toUtf8().constData()); });
      return true;
    case Opacity:
      if (!isNumber || number < 0 || number > 1)
      {
        this->Document->say(tr("An opacity is a number from 0 to 1."));
        return false;
      }
      this->Document->edit(tr("Change opacity"), [&]() { region->SetOpacity(number); });
      return true;
    case Falloff:
      if (falloff < 0)
      {
        this->Document->say(tr("A fall-off is one of: %1.").arg(FalloffNames().join(", ")));
        return false;
      }
      this->Document->edit(tr("Change fall-off"),
        [&]() { region->SetFalloff(falloff, region->GetFalloffWidth()); });
      return true;
    case Width:
      if (!isNumber || !(number > 0) || number > 1)
      {
        this->Document->say(tr("The width of a fall-off is a number above 0 and up to 1."));
        return false;
      }
      this->Document->edit(tr("Change fall-off"),
        [&]() { region->SetFalloff(region->GetFalloffType(), number); });
      return true;
    default:
      return false;
  }
}

//-----------------------------------------------------------------------------
QVariant pqTFCRegionModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  static const QStringList names = { tr("Region"), tr("Opacity"), tr("Fall-off"), tr("Width"),
    tr("Tertiary"), tr("Lock") };
  return orientation == Qt::Horizontal && role == Qt::DisplayRole && section < names.size()
    ? QVariant(names[section])
    : QVariant();
}

//-----------------------------------------------------------------------------
Qt::ItemFlags pqTFCRegionModel::flags(const QModelIndex& index) const
{
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  vtkTFCRegion* region = this->region(index.row());
  if (index.column() == Name || index.column() == Lock)
  {
    flags |= Qt::ItemIsUserCheckable;
  }
  if (region && !region->GetLocked() && index.column() <= Width)
  {
    flags |= Qt::ItemIsEditable;
  }
  return flags;
}
