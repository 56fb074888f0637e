// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Volumes for the filters' tests, and what they report.
 */

#ifndef FilterVolumes_h
#define FilterVolumes_h

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

namespace testing_volumes
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

using Function = std::function<double(int, int, int)>;

/**
 * Image of the given dimensions whose lower corner has the index (3, -2, 7).
 */
inline vtkSmartPointer<vtkImageData> MakeImage(int nx, int ny, int nz)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 3 + nx - 1, -2, -2 + ny - 1, 7, 7 + nz - 1);
  return image;
}

/**
 * Array `name` of type Array with f at the nx * ny * nz samples, counted from 0.
 */
template <typename Array = vtkDoubleArray>
vtkSmartPointer<Array> MakeArray(const char* name, int nx, int ny, int nz, const Function& f)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(nx) * ny * nz);
  vtkIdType id = 0;
  for (int z = 0; z < nz; ++z)
  {
    for (int y = 0; y < ny; ++y)
    {
      for (int x = 0; x < nx; ++x)
      {
        array->SetTuple1(id++, f(x, y, z));
      }
    }
  }
  return array;
}

/**
 * Image with one point array `a`.
 */
template <typename Array = vtkDoubleArray>
vtkSmartPointer<vtkImageData> MakeVolume(int nx, int ny, int nz, const Function& f)
{
  auto image = MakeImage(nx, ny, nz);
  image->GetPointData()->SetScalars(MakeArray<Array>("a", nx, ny, nz, f));
  return image;
}

/**
 * A function without structure, the same on every machine.
 */
inline double Noise(int x, int y, int z)
{
  unsigned int h = 374761393u * x + 668265263u * y + 2147483647u * z + 12345u;
  h = (h ^ (h >> 13)) * 1274126177u;
  return ((h ^ (h >> 16)) & 0xffff) / 65536. * 4. - 1.;
}

/**
 * Hide the points where `hidden` says so.
 */
inline void Blank(vtkImageData* image, const std::function<bool(vtkIdType)>& hidden)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    ghosts->InsertNextValue(hidden(i) ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  image->GetPointData()->AddArray(ghosts);
}

/**
 * Collects the errors of an object instead of printing them.
 */
class Errors
{
public:
  explicit Errors(vtkObject* object)
  {
    this->Command->SetClientData(&this->Text);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
      { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  bool Mention(const std::string& what) const { return this->Text.find(what) != std::string::npos; }
  std::string Text;

private:
  vtkNew<vtkCallbackCommand> Command;
};

/**
 * Sets TFC_NUM_THREADS while it lives.
 */
class Threads
{
public:
  explicit Threads(int number) { setenv("TFC_NUM_THREADS", std::to_string(number).c_str(), 1); }
  ~Threads() { unsetenv("TFC_NUM_THREADS"); }
};

/**
 * Limits the instruction set (vtkTFCSimd.h) while it lives.
 */
class SimdLimit
{
public:
  explicit SimdLimit(const char* name) { setenv("TFC_SIMD", name, 1); }
  ~SimdLimit() { unsetenv("TFC_SIMD"); }
};

/**
 * The bytes of a float array, to compare results bit for bit; empty without one.
 */
inline std::string GetBytes(vtkDataArray* array)
{
  auto* floats = vtkFloatArray::SafeDownCast(array);
  return floats ? std::string(reinterpret_cast<const char*>(floats->GetPointer(0)),
                    static_cast<size_t>(floats->GetNumberOfValues()) * sizeof(float))
                : std::string();
}

/**
 * Run a property filter on array `a` of the given association and return array `result`.
 */
template <typename Filter>
vtkDataArray* Compute(Filter* filter, vtkImageData* image, const char* result, int association = 0)
{
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, association, "a");
  filter->Update();
  return filter->GetImageDataOutput()->GetAttributes(association)->GetArray(result);
}
}

#endif
