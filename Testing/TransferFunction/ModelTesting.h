// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the model share: states from parts, evaluation of single samples, caught
// errors.
#ifndef ModelTesting_h
#define ModelTesting_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkTFCClassifier.h"
#include "vtkTFCTransferFunction.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace ModelTesting
{
/// A state with axes P in [0, 10] and S in [-1, 1] and these regions (JSON objects, comma
/// separated).
inline std::string State(const std::string& regions, const std::string& blend = "mix")
{
  return R"({"format": "transfer-function-combination", "version": 1,
    "primary": {"array": "P", "range": [0, 10]}, "secondary": {"array": "S", "range": [-1, 1]},
    "blend": ")" +
    blend + R"(", "regions": [)" + regions + "]}";
}

/// A region with a constant fall-off that covers the whole plane.
inline std::string Everywhere(int id, double opacity, const std::string& color,
  const std::string& tertiary = "null")
{
  return R"({"id": )" + std::to_string(id) +
    R"(, "shape": {"type": "rectangle", "center": [5, 0], "halfsize": [100, 100]},
      "falloff": {"type": "constant"}, "color": )" +
    color + ", \"opacity\": " + std::to_string(opacity) + ", \"tertiary\": " + tertiary + "}";
}

/// Remembers the errors and warnings of an object, and keeps them from the output window.
class Catcher
{
public:
  explicit Catcher(vtkObject* object)
    : Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        auto* catcher = static_cast<Catcher*>(self);
        (event == vtkCommand::ErrorEvent ? catcher->Errors : catcher->Warnings) +=
          static_cast<const char*>(text);
      });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
  }
  ~Catcher() { this->Object->RemoveObserver(this->Command); }
  Catcher(const Catcher&) = delete;
  void operator=(const Catcher&) = delete;

  std::string Errors;
  std::string Warnings;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
};

struct Sample
{
  std::array<float, 4> RGBA;
  int Region;
  float Opacity;
};

/// One sample: primary, secondary, then the tertiary attributes in order of first use.
inline Sample Evaluate(const vtkTFCClassifier& classifier, const std::vector<double>& values)
{
  std::vector<const double*> pointers;
  for (const double& value : values)
  {
    pointers.push_back(&value);
  }
  Sample sample;
  classifier.Classify(1, pointers.data(), sample.RGBA.data(), &sample.Region, &sample.Opacity);
  return sample;
}

inline vtkTFCCompiledModel Compile(const std::string& state)
{
  vtkNew<vtkTFCTransferFunction> model;
  EXPECT_TRUE(model->SetState(state.c_str())) << model->GetLastError();
  return model->Compile();
}

inline Sample Evaluate(const std::string& state, const std::vector<double>& values)
{
  return Evaluate(vtkTFCClassifier(Compile(state)), values);
}
}

#endif
