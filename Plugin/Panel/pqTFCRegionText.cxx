// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCRegionText.h"

#include "pqTFCDocument.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTFCOutline.h"
#include "vtkTFCRegion.h"
#include "vtkTFCShape.h"

#include <QColor>
#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <QStringList>

#include <array>
#include <cmath>
#include <vector>

namespace
{
constexpr double LARGEST = 1e300; // of the state
constexpr int COORDINATE = 7;     // digits
constexpr int VALUE = 6;
constexpr int OPACITY = 4;
constexpr vtkTFCOutline::Ranges DATA_UNITS = { { 0, 1, 0, 1 } };

QString Translate(const char* text)
{
  return QCoreApplication::translate("pqTFCRegionText", text);
}

QString Number(double value, int digits)
{
  return QString::number(value, 'g', digits);
}

QStringList Words(const QString& text)
{
  static const QRegularExpression separators("[\\s,;:()\\[\\]]+");
  return text.split(separators, Qt::SkipEmptyParts);
}

QString ColorWord(const double color[3])
{
  return QColor::fromRgbF(color[0], color[1], color[2]).name();
}

bool ReadNumber(const QString& word, double& value)
{
  bool isNumber = false;
  value = word.toDouble(&isNumber);
  return isNumber && std::abs(value) <= LARGEST; // false for NaN
}

bool ReadColor(const QString& word, double color[3])
{
  const QColor read(word);
  color[0] = read.redF();
  color[1] = read.greenF();
  color[2] = read.blueF();
  return read.isValid() && read.alpha() == 255;
}

// Everything that is shown of a region's numbers, and the digits that are not shown.
class Digits
{
public:
  explicit Digits(int digits)
    : Shown(digits)
  {
  }

  void Add(double value)
  {
    const QString word = Number(value, this->Shown);
    if (!this->Values.contains(word))
    {
      this->Values[word] = value;
    }
  }

  bool Read(const QString& word, double& value) const
  {
    const auto found = this->Values.constFind(word);
    value = found == this->Values.cend() ? 0 : *found;
    return found != this->Values.cend() || ReadNumber(word, value);
  }

private:
  int Shown;
  QHash<QString, double> Values;
};

// The numbers of an outline as they are listed.
std::vector<double> Numbers(const vtkTFCOutline& outline)
{
  if (outline.IsBox())
  {
    return { outline.Center[0], outline.Center[1], outline.HalfSize[0], outline.HalfSize[1],
      outline.Angle };
  }
  std::vector<double> numbers;
  for (const vtkTFCOutline::Point& point : outline.Points)
  {
    numbers.insert(numbers.end(), point.begin(), point.end());
  }
  return numbers;
}

// Ranges like those of the axes, so that an outline of any unit can be checked, but with sizes that
// are powers of two: going there and back changes no digit.
vtkTFCOutline::Ranges CheckingRanges(pqTFCDocument* document)
{
  double ranges[4];
  vtkTFCOutline::Ranges exact = DATA_UNITS;
  for (int i = 0; i < 2 && document->axisRanges(ranges); ++i)
  {
    const double size = std::exp2(std::round(std::log2(ranges[2 * i + 1] - ranges[2 * i])));
    exact[2 * i + 1] = std::isnormal(size) ? size : 1;
  }
  return exact;
}

vtkTFCOutline MakeOutline(vtkTFCOutline::Types type, const std::vector<double>& n,
  const vtkTFCOutline::Ranges& ranges)
{
  vtkTFCOutline outline;
  outline.Type = type;
  const auto point = [&](size_t i) {
    return vtkTFCOutline::Point{ { n[i] / ranges[1], n[i + 1] / ranges[3] } };
  };
  if (outline.IsBox())
  {
    outline.Center = point(0);
    outline.HalfSize = point(2);
    outline.Angle = n[4];
    return outline;
  }
  for (size_t i = 0; i + 1 < n.size(); i += 2)
  {
    outline.Points.push_back(point(i));
  }
  return outline;
}

// Nodes of a 1D function from pairs of a value and what `readRest` makes of the other word.
template <typename ReadRest>
bool ReadNodes(const QString& text, const Digits& digits, const ReadRest& readRest,
  vtkDoubleArray* nodes)
{
  const QStringList words = Words(text);
  double before[2] = { -HUGE_VAL, -HUGE_VAL };
  double node[4];
  for (int i = 0; i + 1 < words.size(); i += 2)
  {
    // Two points at a value are a step, three are one too many.
    if (!digits.Read(words[i], node[0]) || node[0] < before[1] || node[0] == before[0] ||
      !readRest(words[i + 1], node + 1))
    {
      return false;
    }
    before[0] = before[1];
    before[1] = node[0];
    nodes->InsertNextTuple(node);
  }
  return words.size() % 2 == 0;
}

bool SetNodes(pqTFCDocument* document, vtkTFCRegion* region, const QString& label,
  vtkDoubleArray* opacities, vtkDoubleArray* colors)
{
  const std::string array = region->GetTertiaryArray();
  document->edit(label,
    [&]()
    {
      region->SetTertiary(array.c_str(), region->GetTertiaryComponent(), opacities,
        colors->GetNumberOfTuples() > 0 ? colors : nullptr);
    });
  return true;
}

bool Refuse(pqTFCDocument* document, const QString& message)
{
  document->say(message);
  return false;
}

bool RefuseWithoutTertiary(pqTFCDocument* document)
{
  return Refuse(document, Translate("Choose a tertiary attribute for the region first."));
}
}

//-----------------------------------------------------------------------------
QString pqTFCColorText(vtkTFCRegion* region)
{
  double color[3];
  region->GetColor(color);
  return ColorWord(color);
}

//-----------------------------------------------------------------------------
bool pqTFCSetColor(pqTFCDocument* document, vtkTFCRegion* region, const QString& text)
{
  double color[3];
  if (!ReadColor(text.trimmed(), color))
  {
    return Refuse(document,
      Translate("A colour is #rrggbb or the name of one, such as crimson; got '%1'.").arg(text));
  }
  if (text.trimmed() != pqTFCColorText(region))
  {
    document->edit(Translate("Change colour"),
      [&]() { region->SetColor(color[0], color[1], color[2]); });
  }
  return true;
}

//-----------------------------------------------------------------------------
QString pqTFCGeometryText(vtkTFCRegion* region)
{
  const vtkTFCOutline outline = vtkTFCOutline::FromShape(region->GetShape(), DATA_UNITS);
  const std::vector<double> numbers = Numbers(outline);
  QStringList parts;
  for (size_t i = 0; i + 1 < numbers.size(); i += 2)
  {
    parts << Number(numbers[i], COORDINATE) + " " + Number(numbers[i + 1], COORDINATE);
  }
  if (outline.IsBox())
  {
    parts << Number(outline.Angle, COORDINATE);
  }
  return parts.join("; ");
}

//-----------------------------------------------------------------------------
QString pqTFCShapeText(vtkTFCRegion* region)
{
  return region->GetShape()->GetTypeName() + (" " + pqTFCGeometryText(region));
}

//-----------------------------------------------------------------------------
bool pqTFCSetGeometry(pqTFCDocument* document, vtkTFCRegion* region, const QString& text)
{
  static const QStringList kinds = { "ellipse", "rectangle", "triangle", "polygon" };
  const vtkTFCOutline before = vtkTFCOutline::FromShape(region->GetShape(), DATA_UNITS);
  std::vector<double> numbers = Numbers(before);
  Digits digits(COORDINATE);
  for (const double number : numbers)
  {
    digits.Add(number);
  }
  QStringList words = Words(text);
  vtkTFCOutline::Types type = before.Type;
  if (!words.empty() && kinds.contains(words[0].toLower()))
  {
    type = static_cast<vtkTFCOutline::Types>(kinds.indexOf(words.takeFirst().toLower()));
  }
  const bool box = type == vtkTFCOutline::Types::Ellipse || type == vtkTFCOutline::Types::Rectangle;
  // The kind alone: the numbers of the shape that is there.
  bool valid = !words.empty() || (type != before.Type && box == before.IsBox());
  if (!words.empty())
  {
    numbers.assign(words.size(), 0);
  }
  for (int i = 0; i < words.size(); ++i)
  {
    valid = valid && digits.Read(words[i], numbers[i]);
  }
  const vtkTFCOutline::Ranges ranges = CheckingRanges(document);
  valid = valid && (box ? numbers.size() == 5 : numbers.size() % 2 == 0);
  const vtkTFCOutline outline = valid ? MakeOutline(type, numbers, ranges) : vtkTFCOutline();
  if (!valid || !outline.IsValid())
  {
    return Refuse(document,
      box ? Translate("Expected five numbers: centre x y, half of width and height above 0, angle.")
          : Translate("Expected two numbers x y for each of %1 corners that are not on one line.")
              .arg(type == vtkTFCOutline::Types::Triangle ? "3" : "3 or more"));
  }
  document->edit(Translate("Change geometry"),
    [&]()
    {
      if (type == before.Type)
      {
        outline.Store(region->GetShape(), ranges);
      }
      else
      {
        region->SetShape(outline.NewShape(ranges));
      }
    });
  return true;
}

//-----------------------------------------------------------------------------
QString pqTFCOpacityPointsText(vtkTFCRegion* region)
{
  vtkNew<vtkDoubleArray> nodes;
  region->GetTertiaryOpacityNodes(nodes);
  QStringList points;
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
  {
    points << Number(nodes->GetComponent(i, 0), VALUE) + " " +
        Number(nodes->GetComponent(i, 1), OPACITY);
  }
  return points.join("; ");
}

//-----------------------------------------------------------------------------
bool pqTFCSetOpacityPoints(pqTFCDocument* document, vtkTFCRegion* region, const QString& text)
{
  if (!region->HasTertiary())
  {
    return RefuseWithoutTertiary(document);
  }
  vtkNew<vtkDoubleArray> before;
  vtkNew<vtkDoubleArray> nodes;
  vtkNew<vtkDoubleArray> colors;
  region->GetTertiaryOpacityNodes(before);
  region->GetTertiaryColorNodes(colors);
  Digits values(VALUE);
  Digits opacities(OPACITY);
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    values.Add(before->GetComponent(i, 0));
    opacities.Add(before->GetComponent(i, 1));
  }
  nodes->SetNumberOfComponents(2);
  const auto readOpacity = [&](const QString& word, double* opacity)
  { return opacities.Read(word, *opacity) && *opacity >= 0 && *opacity <= 1; };
  if (!ReadNodes(text, values, readOpacity, nodes) || nodes->GetNumberOfTuples() == 0)
  {
    return Refuse(document,
      Translate(
        "Expected pairs of numbers, value and opacity: values increasing, opacities from 0 to 1."));
  }
  return SetNodes(document, region, Translate("Change tertiary function"), nodes, colors);
}

//-----------------------------------------------------------------------------
QString pqTFCColorPointsText(vtkTFCRegion* region)
{
  vtkNew<vtkDoubleArray> nodes;
  region->GetTertiaryColorNodes(nodes);
  QStringList points;
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
  {
    const double* node = nodes->GetTuple4(i);
    points << Number(node[0], VALUE) + " " + ColorWord(node + 1);
  }
  return points.join("; ");
}

//-----------------------------------------------------------------------------
bool pqTFCSetColorPoints(pqTFCDocument* document, vtkTFCRegion* region, const QString& text)
{
  if (!region->HasTertiary())
  {
    return RefuseWithoutTertiary(document);
  }
  vtkNew<vtkDoubleArray> before;
  vtkNew<vtkDoubleArray> nodes;
  vtkNew<vtkDoubleArray> opacities;
  region->GetTertiaryOpacityNodes(opacities);
  region->GetTertiaryColorNodes(before);
  Digits values(VALUE);
  QHash<QString, std::array<double, 3>> colors;
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    const double* node = before->GetTuple4(i);
    values.Add(node[0]);
    colors.insert(ColorWord(node + 1), { { node[1], node[2], node[3] } });
  }
  nodes->SetNumberOfComponents(4);
  const auto readColor = [&](const QString& word, double* color)
  {
    const auto known = colors.constFind(word);
    if (known != colors.cend())
    {
      std::copy(known->begin(), known->end(), color);
    }
    return known != colors.cend() || ReadColor(word, color);
  };
  if (!ReadNodes(text, values, readColor, nodes))
  {
    return Refuse(document,
      Translate("Expected pairs of value and colour: values increasing, colours as #rrggbb or by "
                "name. Without any, the colour of the region."));
  }
  return SetNodes(document, region, Translate("Change tertiary colours"), opacities, nodes);
}

//-----------------------------------------------------------------------------
QString pqTFCTertiaryRangeText(vtkTFCRegion* region)
{
  double range[2];
  return region->HasTertiary() && region->GetTertiaryRange(range)
    ? Number(range[0], VALUE) + " " + Number(range[1], VALUE)
    : QString();
}

//-----------------------------------------------------------------------------
bool pqTFCSetTertiaryRange(pqTFCDocument* document, vtkTFCRegion* region, const QString& text)
{
  if (!region->HasTertiary())
  {
    return RefuseWithoutTertiary(document);
  }
  double range[2];
  Digits digits(VALUE);
  if (region->GetTertiaryRange(range))
  {
    digits.Add(range[0]);
    digits.Add(range[1]);
  }
  const QStringList words = Words(text);
  if (!words.empty() &&
    (words.size() != 2 || !digits.Read(words[0], range[0]) || !digits.Read(words[1], range[1]) ||
      !(range[0] < range[1])))
  {
    return Refuse(document,
      Translate(
        "A range is two numbers, the smaller one first; or nothing, for that of the data."));
  }
  document->edit(Translate("Change tertiary range"),
    [&]() {
      words.empty() ? region->ClearTertiaryRange() : region->SetTertiaryRange(range[0], range[1]);
    });
  return true;
}
