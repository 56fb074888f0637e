// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCDataProblem.h"

#include "pqTFCDocument.h"
#include "vtkTFCRegion.h"
#include "vtkTFCTransferFunction.h"

#include <QStringList>

#include <algorithm>

namespace
{
// More would fill the panel.
constexpr int MOST_NAMES = 3;

struct Use
{
  std::string Array;
  int Component;
  QString As;
};

std::vector<Use> FindUses(vtkTFCTransferFunction* model)
{
  std::vector<Use> uses;
  for (int i = 0; i < 2 && model->HasAxes(); ++i)
  {
    uses.push_back({ model->GetAxisArray(i), model->GetAxisComponent(i),
      i == 0 ? pqTFCDataProblem::tr("primary axis") : pqTFCDataProblem::tr("secondary axis") });
  }
  for (int i = 0; i < model->GetNumberOfRegions(); ++i)
  {
    vtkTFCRegion* region = model->GetRegion(i);
    if (region->GetVisible() && region->HasTertiary())
    {
      uses.push_back({ region->GetTertiaryArray(), region->GetTertiaryComponent(),
        QString::fromStdString(region->GetName()) });
    }
  }
  return uses;
}

QString NameOf(const Use& use, const pqTFCDocument* document)
{
  const auto& known = document->attributes();
  const bool hasArray = std::any_of(known.begin(), known.end(),
    [&](const pqTFCAttribute& attribute) { return attribute.Array == use.Array; });
  const QString array = QString::fromStdString(use.Array);
  if (!hasArray)
  {
    return array;
  }
  return use.Component < 0
    ? pqTFCDataProblem::tr("%1 with several components").arg(array)
    : pqTFCDataProblem::tr("%1 with component %2").arg(array).arg(use.Component);
}

QString Join(QStringList names)
{
  if (names.size() > MOST_NAMES)
  {
    const int more = names.size() - MOST_NAMES + 1;
    names = names.mid(0, MOST_NAMES - 1);
    names << pqTFCDataProblem::tr("%1 more").arg(more);
  }
  return names.join(", ");
}
}

//-----------------------------------------------------------------------------
pqTFCDataProblem pqTFCDataProblem::find(const pqTFCDocument* document)
{
  pqTFCDataProblem problem;
  if (!document->isReady())
  {
    return problem;
  }
  if (document->attributes().empty())
  {
    problem.Kind = NoArrays;
    problem.Text = tr("The data have no arrays, neither of points nor of cells: nothing can be "
                      "drawn. Switch some on in the reader, or choose other data.");
    return problem;
  }
  std::vector<Use> uses = FindUses(document->model());
  QStringList missing;
  QStringList points;
  QStringList cells;
  for (size_t i = 0; i < uses.size(); ++i)
  {
    const auto same = [&](const Use& other)
    { return other.Array == uses[i].Array && other.Component == uses[i].Component; };
    if (std::any_of(uses.begin(), uses.begin() + i, same))
    {
      continue;
    }
    const pqTFCAttribute* attribute = document->findAttribute(uses[i].Array, uses[i].Component);
    if (!attribute)
    {
      missing << QString("%1 (%2)").arg(NameOf(uses[i], document), uses[i].As);
    }
    else if (attribute->OnPoints != attribute->OnCells)
    {
      (attribute->OnPoints ? points : cells) << QString::fromStdString(uses[i].Array);
    }
  }
  if (!missing.isEmpty())
  {
    problem.Kind = Missing;
    problem.Text = tr("Nothing is drawn: the data have no array %1. Bring it back in the "
                      "pipeline, or choose another one for it. The transfer function is kept.")
                     .arg(Join(missing));
  }
  else if (!points.isEmpty() && !cells.isEmpty())
  {
    problem.Kind = Mixed;
    problem.Text = tr("Nothing is drawn: arrays of points (%1) and of cells (%2) do not go "
                      "together. Choose others, or convert:")
                     .arg(Join(points), Join(cells));
  }
  return problem;
}
