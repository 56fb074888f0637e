// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCRegionModel.h"

#include "pqTFCDocument.h"
#include "pqTFCRegionText.h"
#include "pqTFCTertiaryBox.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include <QColor>
#include <QLocale>
#include <QPixmap>

#include <array>

namespace
{
constexpr int DIGITS = 4; // of opacity and width

struct Column
{
  const char* Name;  // of an object
  const char* Title; // of the header
  const char* Said;  // by a screen reader
  const char* Help;
};

// In the order of pqTFCRegionModel::Columns.
const std::array<Column, pqTFCRegionModel::NumberOfColumns> COLUMNS = { {
  { "Name", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Region"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Name and visibility"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Name of the region; the box shows and hides it") },
  { "Opacity", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Opacity"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Opacity"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Opacity per unit distance, 0 to 1") },
  { "Falloff", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Fall-off"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Fall-off"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "constant, linear, smooth or gaussian") },
  { "Width", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Width"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Width of the fall-off"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel",
      "Part of the region in which the weight falls off, above 0 and up to 1") },
  { "Tertiary", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Tertiary"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Tertiary attribute"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel",
      "The attribute that decides within the region, or None") },
  { "Lock", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Lock"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Lock"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "A locked region cannot be edited by accident") },
  { "Color", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Colour"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Colour"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel",
      "#rrggbb or the name of a colour; double click opens a dialog") },
  { "Shape", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Shape"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Shape"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel",
      "ellipse or rectangle: centre x y; half of width and height; angle in degrees. triangle or "
      "polygon: corners x y; x y; ... In data units.") },
  { "OpacityPoints", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Opacity points"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Opacity over the tertiary attribute"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "value opacity; value opacity; ... by value") },
  { "ColorPoints", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Colour points"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Colours over the tertiary attribute"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel",
      "value #rrggbb; value #rrggbb; ... by value. Nothing: the colour of the region.") },
  { "TertiaryRange", QT_TRANSLATE_NOOP("pqTFCRegionModel", "Tertiary range"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel", "Range of the tertiary attribute"),
    QT_TRANSLATE_NOOP("pqTFCRegionModel",
      "The values that its histogram and function show: low high. Nothing: those of the data.") },
} };
}

//-----------------------------------------------------------------------------
QString pqTFCRegionModel::columnName(int column)
{
  return COLUMNS[column].Name;
}

//-----------------------------------------------------------------------------
QStringList pqTFCRegionModel::falloffs()
{
  return { "constant", "linear", "smooth", "gaussian" };
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
QString pqTFCRegionModel::text(vtkTFCRegion* region, int column) const
{
  switch (column)
  {
    case Name:
      return QString::fromUtf8(region->GetName().c_str());
    case Opacity:
      return QString::number(region->GetOpacity(), 'g', QLocale::FloatingPointShortest);
    case Falloff:
      return falloffs()[region->GetFalloffType()];
    case Width:
      return QString::number(region->GetFalloffWidth(), 'g', QLocale::FloatingPointShortest);
    case Tertiary:
      return region->HasTertiary()
        ? this->Document->labelOf(region->GetTertiaryArray(), region->GetTertiaryComponent())
        : tr("None");
    case Lock:
      return region->GetLocked() ? tr("locked") : tr("not locked");
    case Color:
      return pqTFCColorText(region);
    case Shape:
      return pqTFCShapeText(region);
    case OpacityPoints:
      return region->HasTertiary() ? pqTFCOpacityPointsText(region) : QString();
    case ColorPoints:
      return region->HasTertiary() ? pqTFCColorPointsText(region) : QString();
    default:
      return pqTFCTertiaryRangeText(region);
  }
}

//-----------------------------------------------------------------------------
QIcon pqTFCRegionModel::swatch(vtkTFCRegion* region) const
{
  double color[3];
  region->GetColor(color);
  // An icon with a selected state of its own: Qt would tint a plain colour in a selected row.
  QPixmap pixmap(16, 16);
  pixmap.fill(QColor::fromRgbF(color[0], color[1], color[2]));
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}

//-----------------------------------------------------------------------------
QVariant pqTFCRegionModel::data(const QModelIndex& index, int role) const
{
  vtkTFCRegion* region = this->region(index.row());
  const int column = index.column();
  if (!region)
  {
    return QVariant();
  }
  const QString text = this->text(region, column);
  const QString name = this->text(region, Name);
  switch (role)
  {
    case Qt::CheckStateRole:
      if (column == Name || column == Lock)
      {
        return (column == Name ? region->GetVisible() : region->GetLocked()) ? Qt::Checked
                                                                             : Qt::Unchecked;
      }
      return QVariant();
    case Qt::DecorationRole:
      return column == Name ? this->swatch(region) : QVariant();
    case Qt::AccessibleTextRole:
      return column == Name
        ? tr("%1, %2").arg(name, region->GetVisible() ? tr("visible") : tr("hidden"))
        : tr("%1: %2 %3").arg(name, tr(COLUMNS[column].Said), text.isEmpty() ? tr("none") : text);
    case Qt::ToolTipRole:
      // What may not fit into its column.
      return text.isEmpty() || column == Lock ? QVariant() : QVariant(text);
    case Qt::EditRole:
      return column == Lock ? QVariant() : QVariant(text);
    case Qt::DisplayRole:
      if (column == Opacity)
      {
        return QString::number(region->GetOpacity(), 'g', DIGITS);
      }
      if (column == Width)
      {
        return region->GetFalloffType() == vtkTFCRegion::Constant
          ? QString()
          : QString::number(region->GetFalloffWidth(), 'g', DIGITS);
      }
      return column == Lock ? QVariant() : QVariant(text);
    default:
      return QVariant();
  }
}

//-----------------------------------------------------------------------------
bool pqTFCRegionModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  vtkTFCRegion* region = this->region(index.row());
  const int column = index.column();
  if (!region || (role != Qt::CheckStateRole && role != Qt::EditRole))
  {
    return false;
  }
  if (role == Qt::CheckStateRole)
  {
    const bool on = value.toInt() == Qt::Checked;
    this->Document->edit(column == Lock ? tr("Lock region") : tr("Show or hide region"),
      [&]() { column == Lock ? region->SetLocked(on) : region->SetVisible(on); });
    return true;
  }
  // What was not changed keeps the digits that its text does not have.
  return (column != Tertiary && value.toString() == this->text(region, column)) ||
    (column == Tertiary ? this->setTertiary(region, value)
                        : this->setText(region, column, value.toString()));
}

//-----------------------------------------------------------------------------
bool pqTFCRegionModel::setText(vtkTFCRegion* region, int column, const QString& text)
{
  switch (column)
  {
    case Name:
      this->Document->edit(tr("Rename region"),
        [&]() { region->SetName(text.toUtf8().constData()); });
      return true;
    case Falloff:
    {
      const int falloff = falloffs().indexOf(text.trimmed().toLower());
      if (falloff < 0)
      {
        this->Document->say(tr("A fall-off is one of: %1.").arg(falloffs().join(", ")));
        return false;
      }
      this->Document->edit(tr("Change fall-off"),
        [&]() { region->SetFalloff(falloff, region->GetFalloffWidth()); });
      return true;
    }
    case Opacity:
    case Width:
      return this->setNumber(region, column, text);
    case Color:
      return pqTFCSetColor(this->Document, region, text);
    case Shape:
      return pqTFCSetGeometry(this->Document, region, text);
    case OpacityPoints:
      return pqTFCSetOpacityPoints(this->Document, region, text);
    case ColorPoints:
      return pqTFCSetColorPoints(this->Document, region, text);
    case TertiaryRange:
      return pqTFCSetTertiaryRange(this->Document, region, text);
    default:
      return false;
  }
}

//-----------------------------------------------------------------------------
bool pqTFCRegionModel::setNumber(vtkTFCRegion* region, int column, const QString& text)
{
  bool isNumber = false;
  const double number = text.toDouble(&isNumber);
  if (column == Opacity)
  {
    if (!isNumber || !(number >= 0) || number > 1)
    {
      this->Document->say(tr("An opacity is a number from 0 to 1."));
      return false;
    }
    this->Document->edit(tr("Change opacity"), [&]() { region->SetOpacity(number); });
    return true;
  }
  if (!isNumber || !(number > 0) || number > 1)
  {
    this->Document->say(tr("The width of a fall-off is a number above 0 and up to 1."));
    return false;
  }
  this->Document->edit(tr("Change fall-off"),
    [&]() { region->SetFalloff(region->GetFalloffType(), number); });
  return true;
}

//-----------------------------------------------------------------------------
bool pqTFCRegionModel::setTertiary(vtkTFCRegion* region, const QVariant& value)
{
  const auto& attributes = this->Document->attributes();
  const QString label = value.toString().trimmed();
  bool isIndex = value.type() == QVariant::Int;
  int chosen = value.toInt();
  if (!isIndex && label == tr("None"))
  {
    isIndex = true;
    chosen = -1;
  }
  for (size_t i = 0; i < attributes.size() && !isIndex; ++i)
  {
    if (attributes[i].Label == label)
    {
      isIndex = true;
      chosen = static_cast<int>(i);
    }
  }
  if (!isIndex)
  {
    this->Document->say(tr("The data have no attribute '%1'.").arg(label));
    return false;
  }
  if (chosen != pqTFCTertiaryBox::MISSING)
  {
    this->Document->setTertiary(region, chosen);
  }
  return true;
}

//-----------------------------------------------------------------------------
QVariant pqTFCRegionModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation != Qt::Horizontal || section < 0 || section >= NumberOfColumns)
  {
    return QVariant();
  }
  switch (role)
  {
    case Qt::DisplayRole:
      return tr(COLUMNS[section].Title);
    case Qt::AccessibleTextRole:
      return tr(COLUMNS[section].Said);
    case Qt::ToolTipRole:
      return tr(COLUMNS[section].Help);
    default:
      return QVariant();
  }
}

//-----------------------------------------------------------------------------
Qt::ItemFlags pqTFCRegionModel::flags(const QModelIndex& index) const
{
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  vtkTFCRegion* region = this->region(index.row());
  const int column = index.column();
  if (column == Name || column == Lock)
  {
    flags |= Qt::ItemIsUserCheckable;
  }
  const bool needsTertiary =
    column == OpacityPoints || column == ColorPoints || column == TertiaryRange;
  if (region && !region->GetLocked() && column != Lock && (region->HasTertiary() || !needsTertiary))
  {
    flags |= Qt::ItemIsEditable;
  }
  return flags;
}
