// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqTFCProbe.h"

#include "pqDataRepresentation.h"
#include "pqTFCAdvice.h"
#include "pqTFCDocument.h"
#include "pqTFCStateLink.h"
#include "pqView.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkTFCTableInformation.h"
#include "vtkTFCTransferFunction.h"
#include "vtkTransform.h"

#include <QMouseEvent>
#include <QStringList>
#include <QWidget>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

constexpr int LARGEST_CLICK = 3; // pixels from press to release

//-----------------------------------------------------------------------------
// From the eye through a place of the viewport, 0 to 1 from its lower left corner, to the far
// plane.
std::array<std::array<double, 3>, 2> FindLine(vtkCamera* camera, double x, double y, double aspect)
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1));
  matrix->Invert();
  std::array<std::array<double, 3>, 2> ends;
  for (int end = 0; end < 2; ++end)
  {
    double point[4] = { 2 * x - 1, 2 * y - 1, end ? 1.0 : -1.0, 1 };
    matrix->MultiplyPoint(point, point);
    ends[end] = { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
  }
  // The eye is on the line through both, as far before the near plane as that is from it.
  const double* range = camera->GetClippingRange();
  for (int axis = 0; axis < 3; ++axis)
  {
    ends[0][axis] -= (ends[1][axis] - ends[0][axis]) * range[0] / (range[1] - range[0]);
  }
  return ends;
}

//-----------------------------------------------------------------------------
// The transform of a representation, by rows.
std::array<double, 16> FindTransform(vtkSMProxy* representation)
{
  const auto get = [representation](const char* name, double values[3])
  { vtkSMPropertyHelper(representation, name).Get(values, 3); };
  double position[3] = { 0, 0, 0 };
  double orientation[3] = { 0, 0, 0 };
  double scale[3] = { 1, 1, 1 };
  double origin[3] = { 0, 0, 0 };
  get("Position", position);
  get("Orientation", orientation);
  get("Scale", scale);
  get("Origin", origin);
  // As vtkProp3D does.
  vtkNew<vtkTransform> transform;
  transform->PostMultiply();
  transform->Translate(-origin[0], -origin[1], -origin[2]);
  transform->Scale(scale);
  transform->RotateY(orientation[1]);
  transform->RotateX(orientation[0]);
  transform->RotateZ(orientation[2]);
  transform->Translate(origin[0] + position[0], origin[1] + position[1], origin[2] + position[2]);
  std::array<double, 16> matrix;
  std::copy_n(transform->GetMatrix()->GetData(), 16, matrix.begin());
  return matrix;
}

}

//-----------------------------------------------------------------------------
pqTFCProbe::pqTFCProbe(pqTFCDocument* document, pqTFCAdvice* advice, QObject* parentObject)
  : Superclass(parentObject)
  , Document(document)
  , Advice(advice)
{
  // What was found in other data says nothing about these.
  QObject::connect(document, &pqTFCDocument::targetChanged, this, &pqTFCProbe::restart);
}

//-----------------------------------------------------------------------------
QString pqTFCProbe::text() const
{
  return this->Values.isEmpty() ? this->Regions : this->Regions + ": " + this->Values;
}

//-----------------------------------------------------------------------------
double pqTFCProbe::value(const std::string& array, int component) const
{
  if (!this->Location)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // The table has a column for the array, or one for each of its components.
  const double scalar = this->Location->GetNumber(array, 0);
  if (!std::isnan(scalar))
  {
    return scalar;
  }
  const auto get = [&](int c)
  { return this->Location->GetNumber(array + "_" + std::to_string(c), 0); };
  if (component >= 0)
  {
    return get(component);
  }
  double squares = get(0) * get(0);
  for (int c = 1; !std::isnan(get(c)); ++c)
  {
    squares += get(c) * get(c);
  }
  return std::sqrt(squares);
}

//-----------------------------------------------------------------------------
void pqTFCProbe::setActive(bool active)
{
  this->Active = active;
  this->restart();
}

//-----------------------------------------------------------------------------
void pqTFCProbe::restart()
{
  this->watch();
  this->Regions = this->Active ? tr("Click into the 3D view.") : QString();
  this->Values.clear();
  this->Location = nullptr;
  Q_EMIT this->lost();
  Q_EMIT this->told();
}

//-----------------------------------------------------------------------------
void pqTFCProbe::watch()
{
  if (this->Viewport)
  {
    this->Viewport->removeEventFilter(this);
  }
  pqDataRepresentation* representation = this->Document->link()->representation();
  pqView* view = representation ? representation->getView() : nullptr;
  this->Viewport = this->Active && view ? view->widget() : nullptr;
  if (this->Viewport)
  {
    this->Viewport->installEventFilter(this);
  }
}

//-----------------------------------------------------------------------------
bool pqTFCProbe::eventFilter(QObject* watched, QEvent* e)
{
  const bool press = e->type() == QEvent::MouseButtonPress;
  if (watched == this->Viewport && (press || e->type() == QEvent::MouseButtonRelease))
  {
    auto* mouse = static_cast<QMouseEvent*>(e);
    if (mouse->button() == Qt::LeftButton && press)
    {
      this->Pressed = mouse->pos();
    }
    else if (mouse->button() == Qt::LeftButton &&
      (mouse->pos() - this->Pressed).manhattanLength() <= LARGEST_CLICK)
    {
      this->pick((mouse->pos().x() + 0.5) / this->Viewport->width(),
        1.0 - (mouse->pos().y() + 0.5) / this->Viewport->height());
    }
  }
  return Superclass::eventFilter(watched, e);
}

//-----------------------------------------------------------------------------
void pqTFCProbe::pick(double x, double y)
{
  pqDataRepresentation* representation = this->Document->link()->representation();
  pqView* pqview = representation ? representation->getView() : nullptr;
  auto* view = vtkSMRenderViewProxy::SafeDownCast(pqview ? pqview->getProxy() : nullptr);
  if (!view || !this->Document->isReady())
  {
    return;
  }
  const auto line = FindLine(view->GetActiveCamera(), x, y,
    static_cast<double>(this->Viewport->width()) / std::max(1, this->Viewport->height()));
  vtkSMProxy* proxy = representation->getProxy();
  const auto transform = FindTransform(proxy);
  vtkNew<vtkTFCTableInformation> shares;
  shares->SetPort(1);
  const auto location = this->Advice->run(
    "RayProbe",
    [&](vtkSMProxy* filter)
    {
      const auto copy = [&](const char* to, const char* from)
      { vtkSMPropertyHelper(filter, to).Set(vtkSMPropertyHelper(proxy, from).GetAsDouble()); };
      vtkSMPropertyHelper(filter, "TransferFunction")
        .Set(vtkSMPropertyHelper(proxy, "TransferFunction").GetAsString());
      vtkSMPropertyHelper(filter, "StartPoint").Set(line[0].data(), 3);
      vtkSMPropertyHelper(filter, "EndPoint").Set(line[1].data(), 3);
      vtkSMPropertyHelper(filter, "Transform").Set(transform.data(), 16);
      for (const char* name :
        { "UseCropping", "CroppingOrigin", "CroppingScale", "CroppingRegionFlags" })
      {
        filter->GetProperty(name)->Copy(proxy->GetProperty(name));
      }
      copy("UnitDistance", "ScalarOpacityUnitDistance");
      copy("SampleDistance", "SampleDistance");
    },
    shares);
  if (location->GetNumberOfRows() == 0)
  {
    this->Regions = tr("Nothing of the volume is visible there.");
    this->Values.clear();
    this->Location = nullptr;
    Q_EMIT this->lost();
    Q_EMIT this->told();
    return;
  }

  // The regions by their part in the colour.
  std::vector<std::pair<double, int>> order;
  order.reserve(shares->GetNumberOfRows());
  for (int row = 0; row < shares->GetNumberOfRows(); ++row)
  {
    order.emplace_back(-shares->GetNumber("contribution", row), row);
  }
  std::sort(order.begin(), order.end());
  QStringList parts;
  for (const auto& part : order)
  {
    const int percent = static_cast<int>(std::lround(-100 * part.first));
    if (percent > 0)
    {
      parts << tr("%1 %2 %")
                 .arg(QString::fromStdString(shares->GetText("name", part.second)))
                 .arg(percent);
    }
  }
  this->Location = location;
  const int largest = static_cast<int>(shares->GetNumber("id", order[0].second));
  this->Document->setSelection({ largest });

  vtkTFCTransferFunction* model = this->Document->model();
  double values[2];
  QStringList numbers;
  for (int axis = 0; axis < 2; ++axis)
  {
    values[axis] = location->GetNumber(axis == 0 ? "primary" : "secondary", 0);
    numbers << QString("%1 %2")
                 .arg(this->Document->labelOf(model->GetAxisArray(axis),
                   model->GetAxisComponent(axis)))
                 .arg(values[axis], 0, 'g', 5);
  }
  this->Regions = parts.join(", ");
  this->Values = numbers.join(", ");
  Q_EMIT this->found(values[0], values[1]);
  Q_EMIT this->told();
}
