// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributePacker.h"

#include "vtkTFCAttributeReader.h"
#include "vtkTFCDistributedImage.h"
#include "vtkTFCThreads.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{

//------------------------------------------------------------------------------
// One array of ghost flags into NaNs of the packed values.
void ApplyBlanking(vtkUnsignedCharArray* ghosts, unsigned char hidden, vtkIdType count,
  int channels, float* packed)
{
  if (!ghosts || ghosts->GetNumberOfTuples() < count)
  {
    return;
  }
  const unsigned char* flags = ghosts->GetPointer(0);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  vtkTFCThreads::For(0, count, 65536,
    [=](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (flags[i] & hidden)
        {
          std::fill(packed + channels * i, packed + channels * (i + 1), nan);
        }
      }
    });
}

//------------------------------------------------------------------------------
// Repeat the single layer of every one-voxel-thick axis of a point image; innermost axis first, in
// place from the end, so that nothing is read after it was overwritten.
void RepeatLayers(const int source[3], const int packed[3], int channels, float* values)
{
  for (int k = packed[2] - 1; k >= 0; --k)
  {
    for (int j = packed[1] - 1; j >= 0; --j)
    {
      for (int i = packed[0] - 1; i >= 0; --i)
      {
        const vtkIdType to = i + packed[0] * (j + static_cast<vtkIdType>(packed[1]) * k);
        const vtkIdType from = std::min(i, source[0] - 1) +
          source[0] *
            (std::min(j, source[1] - 1) +
              static_cast<vtkIdType>(source[1]) * std::min(k, source[2] - 1));
        for (int c = 0; c < channels; ++c)
        {
          values[channels * to + c] = values[channels * from + c];
        }
      }
    }
  }
}

}

//------------------------------------------------------------------------------
// Times are unique in a process, so a new array at an old address is noticed; a shallow copy of the
// dataset is not a change.
std::string vtkTFCAttributePacker::MakeFingerprint(vtkImageData* source,
  const std::vector<vtkTFCAttribute>& attributes)
{
  std::ostringstream key;
  key.precision(17);
  for (const int i : { 0, 1, 2, 3, 4, 5 })
  {
    key << source->GetExtent()[i] << ' ';
  }
  for (const int i : { 0, 1, 2 })
  {
    key << source->GetOrigin()[i] << ' ' << source->GetSpacing()[i] << ' ';
  }
  for (int i = 0; i < 9; ++i)
  {
    key << source->GetDirectionMatrix()->GetData()[i] << ' ';
  }
  const auto add = [&key](vtkAbstractArray* array)
  { key << array << '@' << (array ? array->GetMTime() : 0) << ' '; };
  add(source->GetPointGhostArray());
  add(source->GetCellGhostArray());
  for (const auto& attribute : attributes)
  {
    add(source->GetPointData()->GetAbstractArray(attribute.Array.c_str()));
    add(source->GetCellData()->GetAbstractArray(attribute.Array.c_str()));
    key << attribute.Component << ' ';
  }
  return key.str();
}

//------------------------------------------------------------------------------
bool vtkTFCAttributePacker::MapToChannels(const std::vector<vtkTFCAttribute>& attributes)
{
  std::vector<vtkTFCStoredAttribute> stored;
  for (size_t i = 0; i < attributes.size(); ++i)
  {
    const auto& attribute = attributes[i];
    if (i < 2)
    {
      // The shader reads the axes from the first two channels.
      if (this->Channels.size() < 2 || !(this->Channels[i] == attribute))
      {
        return false;
      }
      stored.push_back(this->ChannelStorage[i]);
      continue;
    }
    const auto found = std::find(this->Channels.begin(), this->Channels.end(), attribute);
    if (found == this->Channels.end())
    {
      return false;
    }
    stored.push_back(this->ChannelStorage[found - this->Channels.begin()]);
  }
  this->Stored = stored;
  return true;
}

//------------------------------------------------------------------------------
void vtkTFCAttributePacker::CopyGeometry(vtkImageData* source)
{
  int extent[6];
  double origin[3];
  double spacing[3];
  source->GetExtent(extent);
  source->GetOrigin(origin);
  source->GetSpacing(spacing);
  // Without a controller: what this block holds besides ghosts needs nobody else.
  const vtkTFCDistributedImage block(source, vtkDataObject::FIELD_ASSOCIATION_POINTS, nullptr);
  std::copy(block.GetInnerExtent().begin(), block.GetInnerExtent().end(), this->OwnedExtent);

  // A layer needs a thickness to be seen: the spacing along its axis, or where that is zero (some
  // 2D files) the largest of the others.
  const double largest =
    std::max({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  vtkMatrix3x3* direction = source->GetDirectionMatrix();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (spacing[axis] == 0.0)
    {
      spacing[axis] = largest > 0.0 ? largest : 1.0;
    }
    if (extent[2 * axis] == extent[2 * axis + 1])
    {
      ++extent[2 * axis + 1];
      ++this->OwnedExtent[2 * axis + 1];
      for (int i = 0; i < 3; ++i)
      {
        origin[i] -= 0.5 * spacing[axis] * direction->GetElement(i, axis);
      }
    }
  }
  this->Image = vtkSmartPointer<vtkImageData>::New();
  this->Image->SetExtent(extent);
  this->Image->SetOrigin(origin);
  this->Image->SetSpacing(spacing);
  this->Image->SetDirectionMatrix(direction);
}

//------------------------------------------------------------------------------
bool vtkTFCAttributePacker::IsCurrent(vtkImageData* source) const
{
  return this->Image && this->Fingerprint == MakeFingerprint(source, this->Channels);
}

//------------------------------------------------------------------------------
// The channels from `first` on, of which those without an attribute are 0.
vtkSmartPointer<vtkFloatArray> vtkTFCAttributePacker::Pack(const vtkTFCAttributeReader& reader,
  int first, int channels, vtkImageData* source)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("tfc_attributes");
  array->SetNumberOfComponents(channels);
  array->SetNumberOfTuples(
    this->CellData ? this->Image->GetNumberOfCells() : this->Image->GetNumberOfPoints());
  float* packed = array->GetPointer(0);
  const int used = std::min(channels, static_cast<int>(this->ChannelStorage.size()) - first);
  vtkTFCThreads::For(0, reader.GetNumberOfTuples(), 16384,
    [&](vtkIdType begin, vtkIdType end)
    {
      constexpr vtkIdType chunk = 512;
      std::array<double, chunk> values;
      for (vtkIdType at = begin; at < end; at += chunk)
      {
        const vtkIdType length = std::min(chunk, end - at);
        for (int c = 0; c < channels; ++c)
        {
          float* out = packed + channels * at + c;
          if (c >= used)
          {
            for (vtkIdType i = 0; i < length; ++i)
            {
              out[channels * i] = 0.0F;
            }
            continue;
          }
          reader.Read(first + c, at, length, values.data());
          const double offset = this->ChannelStorage[first + c].Offset;
          const double factor = 1.0 / this->ChannelStorage[first + c].Scale;
          for (vtkIdType i = 0; i < length; ++i)
          {
            out[channels * i] = static_cast<float>((values[i] - offset) * factor);
          }
        }
      }
    });
  if (first > 0 && !this->CellData &&
    this->Image->GetNumberOfPoints() != reader.GetNumberOfTuples())
  {
    // The first array is blanked before.
    RepeatLayers(source->GetDimensions(), this->Image->GetDimensions(), channels, packed);
  }
  return array;
}

//------------------------------------------------------------------------------
bool vtkTFCAttributePacker::Update(vtkImageData* source,
  const std::vector<vtkTFCAttribute>& attributes, std::string& error)
{
  if (this->IsCurrent(source) && this->MapToChannels(attributes))
  {
    return true;
  }

  std::vector<vtkTFCAttribute> distinct;
  for (const auto& attribute : attributes)
  {
    if (distinct.size() < 2 ||
      std::find(distinct.begin(), distinct.end(), attribute) == distinct.end())
    {
      distinct.push_back(attribute);
    }
  }
  if (distinct.size() > MaximumNumberOfChannels)
  {
    std::ostringstream message;
    message << "the transfer function uses " << distinct.size() << " attributes, and at most "
            << MaximumNumberOfChannels
            << " can be rendered at once (two axes and six tertiary attributes). Let some regions "
               "share a tertiary attribute.";
    error = message.str();
    return false;
  }
  vtkTFCAttributeReader reader;
  if (!reader.Bind(source, distinct, error))
  {
    return false;
  }
  this->CellData = reader.GetAssociation() == vtkDataObject::CELL;
  this->CopyGeometry(source);
  this->Channels = distinct;
  this->ChannelStorage.clear();
  for (size_t c = 0; c < distinct.size(); ++c)
  {
    double range[2];
    vtkTFCStoredAttribute storage;
    storage.Channel = static_cast<int>(c);
    reader.FiniteRange(static_cast<int>(c), range);
    if (c < 2)
    {
      this->AxisRanges[c] = { range[0] <= range[1] ? range[0] : 1.0,
        range[0] <= range[1] ? range[1] : 0.0 };
    }
    if (range[0] <= range[1])
    {
      storage.Offset = range[0];
      storage.Scale = range[1] > range[0] ? range[1] - range[0] : 1.0;
    }
    this->ChannelStorage.push_back(storage);
  }

  const vtkIdType count = reader.GetNumberOfTuples();
  // Fewer channels are fewer bytes for every sample to fetch. VTK has no textures of three.
  const int channels = distinct.size() > 2 ? TextureChannels : 2;
  const auto array = this->Pack(reader, 0, channels, source);
  this->More = static_cast<int>(distinct.size()) > TextureChannels
    ? this->Pack(reader, TextureChannels, TextureChannels, source)
    : nullptr;
  float* packed = array->GetPointer(0);
  if (this->CellData)
  {
    ApplyBlanking(source->GetCellGhostArray(), vtkDataSetAttributes::HIDDENCELL, count, channels,
      packed);
    this->Image->GetCellData()->SetScalars(array);
  }
  else
  {
    ApplyBlanking(source->GetPointGhostArray(), vtkDataSetAttributes::HIDDENPOINT, count, channels,
      packed);
    if (this->Image->GetNumberOfPoints() != count)
    {
      RepeatLayers(source->GetDimensions(), this->Image->GetDimensions(), channels, packed);
    }
    this->Image->GetPointData()->SetScalars(array);
    vtkUnsignedCharArray* ghosts = source->GetCellGhostArray();
    if (ghosts && ghosts->GetNumberOfTuples() == source->GetNumberOfCells() &&
      source->HasAnyBlankCells())
    {
      vtkNew<vtkUnsignedCharArray> hidden;
      hidden->SetName(vtkDataSetAttributes::GhostArrayName());
      hidden->SetNumberOfTuples(ghosts->GetNumberOfTuples());
      std::transform(ghosts->GetPointer(0), ghosts->GetPointer(ghosts->GetNumberOfTuples()),
        hidden->GetPointer(0),
        [](unsigned char flags) -> unsigned char
        { return flags & vtkDataSetAttributes::HIDDENCELL; });
      this->Image->GetCellData()->AddArray(hidden);
    }
  }

  this->Fingerprint = MakeFingerprint(source, this->Channels);
  ++this->Generation;
  return this->MapToChannels(attributes);
}
