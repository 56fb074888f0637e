// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTFCClassify and vtkTFCAttributeReader: array types, associations, blanking, bad data, threads.
#include "ModelTesting.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTFCAttributeReader.h"
#include "vtkTFCClassify.h"
#include "vtkUniformGrid.h"

#include <cmath>
#include <cstdlib>
#include <limits>

using namespace ModelTesting;

namespace
{
vtkSmartPointer<vtkImageData> Image(int x, int y, int z)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(x, y, z);
  return image;
}

// Image data that can be blanked.
vtkSmartPointer<vtkUniformGrid> Grid(int x, int y, int z)
{
  auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->SetDimensions(x, y, z);
  return grid;
}

template <typename Function>
void AddArray(vtkDataSetAttributes* data, vtkIdType count, const char* name, const Function& value,
  const vtkSmartPointer<vtkDataArray>& array = vtkSmartPointer<vtkDoubleArray>::New())
{
  array->SetName(name);
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetComponent(i, 0, value(i));
  }
  data->AddArray(array);
}

// A smooth volume with P in [0, 10], S in [-1, 1] and T, and a state that uses all three.
vtkSmartPointer<vtkImageData> Volume(int n)
{
  auto image = Image(n, n, n);
  const vtkIdType count = image->GetNumberOfPoints();
  AddArray(image->GetPointData(), count, "P",
    [](vtkIdType i) { return 5 + 5 * std::sin(0.01 * static_cast<double>(i)); });
  AddArray(image->GetPointData(), count, "S",
    [](vtkIdType i) { return std::cos(0.007 * static_cast<double>(i)); });
  AddArray(image->GetPointData(), count, "T",
    [](vtkIdType i) { return static_cast<double>(i % 100); });
  return image;
}

std::string VolumeState()
{
  return State(
    R"({"id": 5, "shape": {"type": "ellipse", "center": [5, 0], "radii": [4, 0.8], "angle": 30},
      "color": [1, 0.5, 0], "opacity": 0.7, "tertiary": {"array": "T", "opacity": [[0, 0], [99, 1]]}},
    {"id": 2, "shape": {"type": "polygon", "points": [[1, -0.5], [9, -0.2], [6, 0.9]]}, "color": [0, 0, 1]})");
}

vtkDataSet* Classify(vtkTFCClassify* filter, vtkDataObject* input, const std::string& state)
{
  filter->SetInputDataObject(input);
  filter->SetTransferFunction(state.c_str());
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

void ExpectPassedThrough(vtkDataSet* output)
{
  ASSERT_NE(output, nullptr);
  EXPECT_FALSE(output->GetPointData()->HasArray("tfc_rgba"));
  EXPECT_FALSE(output->GetCellData()->HasArray("tfc_rgba"));
}

// Values 0..7 in every type, read as doubles.
void CheckArray(const vtkSmartPointer<vtkDataArray>& array, double largest = 7)
{
  auto image = Image(2, 2, 2);
  AddArray(
    image->GetPointData(), 8, "A",
    [largest](vtkIdType i) { return std::min(static_cast<double>(i), largest); }, array);
  vtkTFCAttributeReader reader;
  std::string error;
  ASSERT_TRUE(reader.Bind(image, { { "A", 0 } }, error)) << error;
  double values[6];
  reader.Read(0, 1, 6, values);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(values[i], std::min(i + 1.0, largest)) << array->GetClassName();
  }
  double range[2];
  reader.FiniteRange(0, range);
  EXPECT_EQ(range[0], 0);
  EXPECT_EQ(range[1], largest) << array->GetClassName();
}
}

TEST(AttributeReader, EveryScalarType)
{
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    CheckArray(vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type)));
  }
  CheckArray(vtkSmartPointer<vtkBitArray>::New(), 1);
  CheckArray(vtkSmartPointer<vtkSOADataArrayTemplate<float>>::New());
  CheckArray(vtkSmartPointer<vtkSOADataArrayTemplate<long long>>::New());
  CheckArray(vtkSmartPointer<vtkAOSDataArrayTemplate<unsigned short>>::New());
}

TEST(AttributeReader, ComponentsAndMagnitude)
{
  auto image = Image(2, 1, 1);
  vtkNew<vtkFloatArray> aos;
  vtkNew<vtkSOADataArrayTemplate<double>> soa;
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(aos), static_cast<vtkDataArray*>(soa) })
  {
    array->SetName("V");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(2);
    array->SetTuple3(0, 1, 2, 2);
    array->SetTuple3(1, -3, 0, 4);
    image->GetPointData()->AddArray(array);
    vtkTFCAttributeReader reader;
    std::string error;
    ASSERT_TRUE(reader.Bind(image, { { "V", 2 }, { "V", -1 } }, error));
    double values[2];
    reader.Read(0, 0, 2, values);
    EXPECT_EQ(values[0], 2);
    EXPECT_EQ(values[1], 4);
    reader.Read(1, 0, 2, values);
    EXPECT_DOUBLE_EQ(values[0], 3);
    EXPECT_DOUBLE_EQ(values[1], 5);
    EXPECT_FALSE(reader.Bind(image, { { "V", 3 } }, error));
    EXPECT_NE(error.find("Component 3 of the array 'V' does not exist: it has 3 components"),
      std::string::npos)
      << error;
  }
}

TEST(AttributeReader, RangeIsFiniteAndLeavesHiddenOut)
{
  auto image = Grid(6, 1, 1);
  const double values[] = { std::nan(""), -4, 1e35, HUGE_VAL, -HUGE_VAL, 3 };
  AddArray(image->GetPointData(), 6, "A", [&](vtkIdType i) { return values[i]; });
  image->BlankPoint(2);
  vtkTFCAttributeReader reader;
  std::string error;
  ASSERT_TRUE(reader.Bind(image, { { "A", 0 } }, error));
  EXPECT_TRUE(reader.HasHidden());
  EXPECT_TRUE(reader.IsHidden(2));
  double range[2];
  reader.FiniteRange(0, range);
  EXPECT_EQ(range[0], -4);
  EXPECT_EQ(range[1], 3);
}

TEST(AttributeReader, ErrorsNameTheArrays)
{
  auto image = Image(3, 3, 3);
  AddArray(image->GetPointData(), 27, "P", [](vtkIdType) { return 0; });
  AddArray(image->GetCellData(), 8, "C", [](vtkIdType) { return 0; });
  vtkNew<vtkStringArray> text;
  text->SetName("words");
  text->SetNumberOfValues(27);
  image->GetPointData()->AddArray(text);
  vtkTFCAttributeReader reader;
  std::string error;
  EXPECT_FALSE(reader.Bind(image, { { "P", 0 }, { "Q", 0 } }, error));
  EXPECT_NE(error.find("There is no array 'Q' in the data. Point arrays: 'P'; cell arrays: 'C'."),
    std::string::npos)
    << error;
  EXPECT_FALSE(reader.Bind(image, { { "words", 0 } }, error)) << "text is not numbers";
  EXPECT_FALSE(reader.Bind(image, { { "P", 0 }, { "C", 0 } }, error));
  EXPECT_NE(error.find("'P' is a point array (27 values); 'C' is a cell array (8 values)"),
    std::string::npos)
    << error;
  AddArray(image->GetPointData(), 5, "short", [](vtkIdType) { return 0; });
  EXPECT_FALSE(reader.Bind(image, { { "P", 0 }, { "short", 0 } }, error));
  EXPECT_EQ(error, "The array 'short' has 5 values for 27 points.");
  EXPECT_EQ(reader.GetNumberOfTuples(), 0);
}

TEST(ClassifyVolume, EqualsTheClassifierOnEveryPoint)
{
  const auto image = Volume(20);
  vtkNew<vtkTFCClassify> filter;
  vtkDataSet* output = Classify(filter, image, VolumeState());
  auto* rgba = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("tfc_rgba"));
  auto* region = vtkIntArray::SafeDownCast(output->GetPointData()->GetArray("tfc_region"));
  auto* opacity = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("tfc_opacity"));
  ASSERT_TRUE(rgba && region && opacity);
  EXPECT_EQ(rgba->GetNumberOfComponents(), 4);
  const vtkTFCClassifier classifier(Compile(VolumeState()));
  int seen[6] = { 0, 0, 0, 0, 0, 0 };
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    std::vector<double> values;
    for (const char* name : { "P", "S", "T" })
    {
      values.push_back(image->GetPointData()->GetArray(name)->GetComponent(i, 0));
    }
    const auto sample = Evaluate(classifier, values);
    for (int c = 0; c < 4; ++c)
    {
      ASSERT_EQ(rgba->GetTypedComponent(i, c), sample.RGBA[c]);
    }
    ASSERT_EQ(region->GetValue(i), sample.Region);
    ASSERT_EQ(opacity->GetValue(i), sample.Opacity);
    ++seen[sample.Region];
  }
  EXPECT_GT(seen[0], 0);
  EXPECT_GT(seen[2], 0);
  EXPECT_GT(seen[5], 0);
}

TEST(ClassifyVolume, DoesNotDependOnThreads)
{
  const auto image = Volume(50);
  std::vector<float> first;
  for (const char* threads : { "1", "2", "7" })
  {
    ::setenv("TFC_NUM_THREADS", threads, 1);
    vtkNew<vtkTFCClassify> filter;
    // Automatic ranges too.
    vtkDataSet* output = Classify(filter, image,
      R"({"format": "transfer-function-combination", "version": 1, "primary": {"array": "P"},
        "secondary": {"array": "S"}, "regions": [{"id": 1, "shape":
        {"type": "ellipse", "center": [5, 0], "radii": [4, 0.8]}}]})");
    auto* opacity = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("tfc_opacity"));
    ASSERT_NE(opacity, nullptr);
    const float* values = opacity->GetPointer(0);
    const std::vector<float> all(values, values + opacity->GetNumberOfValues());
    first = first.empty() ? all : first;
    EXPECT_EQ(all, first);
  }
  ::unsetenv("TFC_NUM_THREADS");
  EXPECT_GT(*std::max_element(first.begin(), first.end()), 0.9F);
}

TEST(ClassifyVolume, CellData)
{
  auto image = Image(4, 4, 2);
  AddArray(image->GetCellData(), 9, "P", [](vtkIdType i) { return static_cast<double>(i); });
  AddArray(image->GetCellData(), 9, "S", [](vtkIdType) { return 0; });
  AddArray(image->GetPointData(), 32, "P", [](vtkIdType) { return 0; });
  vtkNew<vtkTFCClassify> filter;
  vtkDataSet* output = Classify(filter, image, State(Everywhere(1, 1, "[1, 0, 0]")));
  EXPECT_FALSE(output->GetPointData()->HasArray("tfc_rgba"));
  ASSERT_TRUE(output->GetCellData()->HasArray("tfc_rgba"));
  EXPECT_EQ(output->GetCellData()->GetArray("tfc_region")->GetNumberOfTuples(), 9);
  EXPECT_EQ(output->GetCellData()->GetArray("tfc_region")->GetComponent(8, 0), 1);
}

TEST(ClassifyVolume, BlankedAndNaNGetZero)
{
  auto image = Grid(5, 3, 2);
  AddArray(image->GetPointData(), 30, "P", [](vtkIdType i) { return i == 7 ? std::nan("") : 5.0; });
  AddArray(image->GetPointData(), 30, "S", [](vtkIdType) { return 0; });
  image->BlankPoint(3);
  vtkNew<vtkTFCClassify> filter;
  vtkDataSet* output = Classify(filter, image, State(Everywhere(1, 1, "[1, 0, 0]")));
  vtkDataArray* region = output->GetPointData()->GetArray("tfc_region");
  vtkDataArray* rgba = output->GetPointData()->GetArray("tfc_rgba");
  for (int i = 0; i < 30; ++i)
  {
    const bool in = i != 3 && i != 7;
    EXPECT_EQ(region->GetComponent(i, 0), in ? 1 : 0) << i;
    EXPECT_EQ(rgba->GetComponent(i, 0), in ? 1 : 0) << i;
    EXPECT_EQ(rgba->GetComponent(i, 3), in ? 1 : 0) << i;
  }

  auto cells = Grid(4, 2, 2);
  AddArray(cells->GetCellData(), 3, "P", [](vtkIdType) { return 5; });
  AddArray(cells->GetCellData(), 3, "S", [](vtkIdType) { return 0; });
  cells->BlankCell(1);
  output = Classify(filter, cells, State(Everywhere(1, 1, "[1, 0, 0]")));
  region = output->GetCellData()->GetArray("tfc_region");
  EXPECT_EQ(region->GetComponent(0, 0), 1);
  EXPECT_EQ(region->GetComponent(1, 0), 0);
}

TEST(ClassifyVolume, ThinAndEmptyVolumes)
{
  for (const auto& size : { std::array<int, 3>{ 1, 1, 1 }, { 5, 1, 1 }, { 1, 4, 3 }, { 0, 0, 0 } })
  {
    auto image = Image(size[0], size[1], size[2]);
    const vtkIdType count = image->GetNumberOfPoints();
    AddArray(image->GetPointData(), count, "P", [](vtkIdType) { return 5; });
    AddArray(image->GetPointData(), count, "S", [](vtkIdType) { return 0; });
    vtkNew<vtkTFCClassify> filter;
    Catcher catcher(filter);
    vtkDataSet* output = Classify(filter, image, State(Everywhere(1, 1, "[1, 0, 0]")));
    EXPECT_EQ(catcher.Errors, "");
    EXPECT_EQ(output->GetPointData()->HasArray("tfc_rgba"), count > 0 ? 1 : 0);
  }
}

TEST(ClassifyVolume, AutomaticRangesOfConstantAndEmptyData)
{
  auto image = Image(3, 3, 3);
  AddArray(image->GetPointData(), 27, "P", [](vtkIdType) { return 5; });
  AddArray(image->GetPointData(), 27, "S", [](vtkIdType) { return std::nan(""); });
  vtkNew<vtkTFCClassify> filter;
  const std::string state =
    R"({"format": "transfer-function-combination", "version": 1, "primary": {"array": "P"},
      "secondary": {"array": ")";
  const std::string rest = R"("}, "regions": [{"id": 1, "shape": {"type": "ellipse",
    "center": [5, 5], "radii": [1, 1]}}]})";
  vtkDataSet* output = Classify(filter, image, state + "P" + rest);
  EXPECT_EQ(output->GetPointData()->GetArray("tfc_region")->GetComponent(13, 0), 1);
  output = Classify(filter, image, state + "S" + rest);
  EXPECT_EQ(output->GetPointData()->GetArray("tfc_region")->GetComponent(13, 0), 0);
}

TEST(ClassifyVolume, MissingArrayPassesTheInputWithAnError)
{
  const auto image = Volume(5);
  vtkNew<vtkTFCClassify> filter;
  Catcher catcher(filter);
  ExpectPassedThrough(Classify(filter, image,
    State(Everywhere(1, 1, "[1, 0, 0]", R"({"array": "U", "opacity": [[0, 1]]})"))));
  EXPECT_NE(catcher.Errors.find("There is no array 'U'"), std::string::npos);
  EXPECT_NE(catcher.Errors.find("'P', 'S', 'T'"), std::string::npos);
  EXPECT_TRUE(
    vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->HasArray("P"));
}

TEST(ClassifyVolume, WithoutAxesWarns)
{
  const auto image = Volume(5);
  vtkNew<vtkTFCClassify> filter;
  Catcher catcher(filter);
  ExpectPassedThrough(Classify(filter, image, ""));
  EXPECT_EQ(catcher.Errors, "");
  EXPECT_NE(catcher.Warnings.find("has no primary axis"), std::string::npos);
}

TEST(ClassifyVolume, BadStateKeepsThePrevious)
{
  const auto image = Volume(5);
  vtkNew<vtkTFCClassify> filter;
  Classify(filter, image, VolumeState());
  const std::string before = filter->GetTransferFunction();
  Catcher catcher(filter->GetModel());
  vtkDataSet* output = Classify(filter, image, "{\"format\": 3}");
  EXPECT_NE(catcher.Errors.find("format: expected"), std::string::npos);
  EXPECT_TRUE(output->GetPointData()->HasArray("tfc_rgba"));
  EXPECT_EQ(filter->GetTransferFunction(), before);
}

TEST(ClassifyVolume, RunsAgainOnlyWhenTheStateChanges)
{
  const auto image = Volume(5);
  vtkNew<vtkTFCClassify> filter;
  Classify(filter, image, VolumeState());
  const auto time = filter->GetMTime();
  filter->SetTransferFunction(filter->GetTransferFunction().c_str());
  EXPECT_EQ(filter->GetMTime(), time);
  filter->GetModel()->SetBlend(vtkTFCTransferFunction::Over);
  EXPECT_GT(filter->GetMTime(), time);
}

TEST(ClassifyVolume, CompositeDataSharesItsRanges)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int b = 0; b < 2; ++b)
  {
    auto image = Image(2, 1, 1);
    AddArray(image->GetPointData(), 2, "P",
      [b](vtkIdType i) { return static_cast<double>(2 * b + i); });
    AddArray(image->GetPointData(), 2, "S", [](vtkIdType) { return 0.25; });
    blocks->SetBlock(b, image);
  }
  blocks->SetNumberOfBlocks(3);
  vtkNew<vtkTFCClassify> filter;
  filter->SetInputData(blocks);
  // A radius of 1.5 around 1.5 reaches P from 0 to 3; with each block's own range the result is the
  // same only when centre and radius are data units of the common range.
  filter->SetTransferFunction(
    R"({"format": "transfer-function-combination", "version": 1, "primary": {"array": "P"},
    "secondary": {"array": "S", "range": [0, 1]}, "regions": [{"id": 1, "falloff": {"type": "linear",
    "width": 1}, "shape": {"type": "polygon", "points": [[-1, 0], [4, 0], [4, 1], [-1, 1]]}}]})");
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetNumberOfBlocks(), 3u);
  // In axis units (range [0, 3]): x from -1/3 to 4/3, y from 0 to 1, E = 0.5; the point (0, 0.25)
  // is 0.25 from the lower edge: d = 0.5.
  for (int b = 0; b < 2; ++b)
  {
    auto* block = vtkDataSet::SafeDownCast(output->GetBlock(b));
    EXPECT_NEAR(block->GetPointData()->GetArray("tfc_opacity")->GetComponent(b, 0), 0.5, 1e-6);
    EXPECT_FALSE(
      vtkDataSet::SafeDownCast(blocks->GetBlock(b))->GetPointData()->HasArray("tfc_opacity"));
  }
}

TEST(ClassifyVolume, ReplacesItsOwnArrays)
{
  const auto image = Volume(5);
  vtkNew<vtkTFCClassify> first;
  vtkNew<vtkTFCClassify> second;
  second->SetInputConnection(first->GetOutputPort());
  first->SetInputData(image);
  first->SetTransferFunction(VolumeState().c_str());
  second->SetTransferFunction(State("").c_str());
  second->Update();
  auto* output = vtkDataSet::SafeDownCast(second->GetOutputDataObject(0));
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 6);
  double range[2];
  output->GetPointData()->GetArray("tfc_opacity")->GetRange(range);
  EXPECT_EQ(range[1], 0);
}
