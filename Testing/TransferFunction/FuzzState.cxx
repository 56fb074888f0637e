// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: any bytes as a state. What cannot be read must say why; what can must survive
// the round trip, compile, and evaluate to numbers in [0, 1] everywhere. See README.md for how to
// run it.
#include "vtkTFCClassifier.h"
#include "vtkTFCState.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace
{
void Require(bool condition, const char* what)
{
  if (!condition)
  {
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
  }
}

void CheckEvaluation(const vtkTFCState& state)
{
  std::array<std::array<double, 2>, 2> used = { { { { 0, 1 } }, { { 0, 1 } } } };
  for (size_t axis = 0; axis < 2; ++axis)
  {
    if (state.Axes[axis].HasRange)
    {
      used[axis] = state.Axes[axis].Range;
    }
  }
  vtkTFCPoleCache cache;
  const vtkTFCClassifier classifier(vtkTFCCompileState(state, used, &cache));
  const auto& model = classifier.GetModel();
  Require(model.Attributes.size() >= 2, "two axes");

  std::array<std::vector<double>, 2> values;
  for (size_t axis = 0; axis < 2; ++axis)
  {
    for (const double t : { -0.5, 0.0, 0.1, 0.4999, 0.5, 0.9, 1.0, 1.5 })
    {
      values[axis].push_back(used[axis][0] + t * (used[axis][1] - used[axis][0]));
    }
    values[axis].push_back(std::numeric_limits<double>::quiet_NaN());
    values[axis].push_back(std::numeric_limits<double>::infinity());
  }
  const size_t count = values[0].size() * values[1].size();
  std::vector<std::vector<double>> columns(model.Attributes.size());
  std::vector<const double*> pointers;
  for (size_t a = 0; a < columns.size(); ++a)
  {
    for (size_t i = 0; i < count; ++i)
    {
      const size_t k = a == 0 ? i % values[0].size() : i / values[0].size();
      columns[a].push_back(a < 2 ? values[a][k] : values[(i + a) % 2][(i * 7 + a) % 10]);
    }
    pointers.push_back(columns[a].data());
  }
  std::vector<float> rgba(4 * count);
  std::vector<int> region(count);
  classifier.Classify(count, pointers.data(), rgba.data(), region.data());
  for (const float value : rgba)
  {
    Require(value >= 0 && value <= 1, "colours and opacities in [0, 1]");
  }
  for (const int id : region)
  {
    bool known = id == 0;
    for (const auto& compiled : model.Regions)
    {
      known = known || compiled.Id == id;
    }
    Require(known, "region ids of the state");
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  vtkTFCState state;
  std::string error;
  if (!vtkTFCReadState(text, state, error))
  {
    Require(!error.empty(), "an error has a message");
    for (const char c : error)
    {
      Require(c >= 0x20 && c < 0x7f, "messages are printable");
    }
    return 0;
  }
  Require(error.empty(), "no message without an error");
  const std::string canonical = vtkTFCWriteState(state);
  vtkTFCState again;
  Require(vtkTFCReadState(canonical, again, error), "canonical text can be read");
  Require(again == state, "the round trip keeps the state");
  Require(vtkTFCWriteState(again) == canonical, "canonical text is canonical");
  CheckEvaluation(state);
  return 0;
}
