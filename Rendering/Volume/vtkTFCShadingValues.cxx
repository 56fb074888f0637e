// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCShadingValues.h"

#include "vtkTFCAttributePacker.h"
#include "vtkTFCAttributeReader.h"
#include "vtkTFCThreads.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"

#include <algorithm>
#include <vector>

//------------------------------------------------------------------------------
bool vtkTFCShadingValues::Update(vtkImageData* source, const std::string& name, bool cells,
  const std::array<int, 3>& texels, std::string& error)
{
  if (name.empty())
  {
    this->Values = nullptr;
    this->Fingerprint.clear();
    return true;
  }
  const std::vector<vtkTFCAttribute> attributes = { { name, 0 } };
  const std::string fingerprint = vtkTFCAttributePacker::MakeFingerprint(source, attributes) + name;
  if (this->Values && this->Fingerprint == fingerprint)
  {
    return true;
  }
  this->Values = nullptr;
  vtkTFCAttributeReader reader;
  std::string reason;
  if (!reader.Bind(source, attributes, reason) ||
    (reader.GetAssociation() == vtkDataObject::CELL) != cells)
  {
    error = reason.empty() ? "the array '" + name + "' for shading must be a " +
        (cells ? "cell" : "point") + " array, as the attributes are."
                           : "array for shading: " + reason;
    return false;
  }
  double range[2];
  reader.FiniteRange(0, range);
  const double scale = range[1] > range[0] ? 1.0 / (range[1] - range[0]) : 0.0;

  std::array<vtkIdType, 3> size;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int points = source->GetDimensions()[axis];
    size[axis] = cells ? std::max(1, points - 1) : points;
  }
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->SetNumberOfValues(static_cast<vtkIdType>(texels[0]) * texels[1] * texels[2]);
  vtkTFCThreads::For(0, static_cast<vtkIdType>(texels[1]) * texels[2], 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> row(size[0]);
      for (vtkIdType r = begin; r < end; ++r)
      {
        const vtkIdType y = std::min<vtkIdType>(r % texels[1], size[1] - 1);
        const vtkIdType z = std::min<vtkIdType>(r / texels[1], size[2] - 1);
        reader.ReadAll(size[0] * (y + size[1] * z), size[0], size[0], row.data());
        float* to = values->GetPointer(r * texels[0]);
        for (vtkIdType x = 0; x < texels[0]; ++x)
        {
          to[x] = static_cast<float>((row[std::min(x, size[0] - 1)] - range[0]) * scale);
        }
      }
    });
  this->Values = values;
  this->Fingerprint = fingerprint;
  return true;
}
