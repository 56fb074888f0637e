// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One volume in a window, and its pixels, for tests of the mapper against numbers.
 */

#ifndef TFC_Testing_VolumeScene_h
#define TFC_Testing_VolumeScene_h

#include "vtkTFCTransferFunction.h"
#include "vtkTFCVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace tfctest
{

/// Add a point array with value f(x, y, z) at every point of `image`.
inline void AddField(vtkImageData* image, const char* name,
  const std::function<double(double, double, double)>& f)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    array->SetValue(i, f(p[0], p[1], p[2]));
  }
  image->GetPointData()->AddArray(array);
}

inline vtkSmartPointer<vtkImageData> MakeImage(int nx, int ny, int nz)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(nx, ny, nz);
  return image;
}

/// RGB in 0..255, row 0 at the bottom.
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Values;

  const unsigned char* At(int x, int y) const
  {
    return &this->Values[3 * (static_cast<size_t>(y) * this->Width + x)];
  }
};

struct Difference
{
  double Mean = 0;
  int Largest = 0;
};

inline Difference Compare(const Picture& a, const Picture& b)
{
  Difference result;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    const int d = std::abs(int(a.Values[i]) - int(b.Values[i]));
    result.Mean += d;
    result.Largest = std::max(result.Largest, d);
  }
  result.Mean /= static_cast<double>(a.Values.size());
  return result;
}

/// A window with a black background, one volume, no multisampling.
class VolumeScene
{
public:
  explicit VolumeScene(int size)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(this->Renderer);
    this->Mapper->SetTransferFunction(this->Model);
    this->Volume->SetMapper(this->Mapper);
    this->Volume->GetProperty()->SetInterpolationTypeToLinear();
    this->Renderer->AddVolume(this->Volume);
  }

  /// Look along -z at a point, with `worldHeight` world units over the window's height.
  void LookAlongZ(double x, double y, double z, double worldHeight)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(x, y, z);
    camera->SetPosition(x, y, z + 1000);
    camera->SetViewUp(0, 1, 0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(worldHeight / 2);
  }

  Picture Render()
  {
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    Picture picture;
    picture.Width = this->Window->GetSize()[0];
    picture.Height = this->Window->GetSize()[1];
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, picture.Width - 1, picture.Height - 1, 1, pixels);
    picture.Values.assign(pixels->GetPointer(0),
      pixels->GetPointer(0) + pixels->GetNumberOfValues());
    return picture;
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkTFCVolumeMapper> Mapper;
  vtkNew<vtkTFCTransferFunction> Model;
};

/// State with axes "x" and "y" over the given ranges and regions as JSON text.
inline std::string MakeState(const std::string& regions, const std::string& xRange = "[0, 1]",
  const std::string& yRange = "[0, 1]", const std::string& blend = "mix")
{
  return R"({"format": "transfer-function-combination", "version": 1,
    "primary": {"array": "x", "component": 0, "range": )" +
    xRange + R"(}, "secondary": {"array": "y", "component": 0, "range": )" + yRange +
    R"(}, "blend": ")" + blend + R"(", "regions": [)" + regions + "]}";
}

/// A region that covers both axes entirely with a constant opacity and colour: fog.
inline std::string MakeFog(double opacity, const std::string& color = "[1, 1, 1]")
{
  return R"({"id": 1, "shape": {"type": "rectangle", "center": [0.5, 0.5], "halfsize": [2, 2]},
    "falloff": {"type": "constant"}, "color": )" +
    color + R"(, "opacity": )" + std::to_string(opacity) + "}";
}

}

#endif
