// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTFCAttributeAgreement.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <utility>

namespace
{
using Attribute = vtkTFCAttributeSamples::Attribute;

//------------------------------------------------------------------------------
/**
 * The attributes to compare, the axes among them, or what is wrong. `others` names those that are
 * left out because they are of cells and the first one of points, or the other way round.
 */
std::string FindAttributes(vtkDataSet* data, std::vector<std::string> wanted,
  const std::vector<std::string>& axes, std::vector<Attribute>& attributes, int& association,
  std::string& others)
{
  if (wanted.empty())
  {
    std::string problem = vtkTFCAttributeSamples::Find(data, {}, attributes, association);
    if (!problem.empty())
    {
      return problem;
    }
    for (const Attribute& attribute : attributes)
    {
      wanted.push_back(attribute.Label);
    }
  }
  const auto exists = [&](const std::vector<vtkTFCAttributeSamples::Request>& requests)
  { return vtkTFCAttributeSamples::Find(data, requests, attributes, association).empty(); };
  const std::string first = axes.empty() ? wanted.front() : axes.front();
  std::vector<vtkTFCAttributeSamples::Request> requests;
  const auto add = [&](const std::string& name)
  {
    const bool known = std::any_of(requests.begin(), requests.end(),
      [&](const vtkTFCAttributeSamples::Request& request) { return request.Name == name; });
    // Lists of all arrays, such as ParaView's, contain the flags: they are no data.
    if (!known && name != vtkDataSetAttributes::GhostArrayName())
    {
      requests.push_back({ name });
    }
  };
  for (const std::string& name : wanted)
  {
    if (exists({ { first } }) && exists({ { name } }) && !exists({ { first }, { name } }))
    {
      others += (others.empty() ? "'" : ", '") + name + "'";
    }
    else
    {
      add(name);
    }
  }
  std::for_each(axes.begin(), axes.end(), add);
  return vtkTFCAttributeSamples::Find(data, requests, attributes, association);
}

//------------------------------------------------------------------------------
/**
 * What processes must agree on, as one text, and back. Line feeds end entries.
 */
std::string Describe(const std::vector<Attribute>& attributes)
{
  std::string text;
  for (const Attribute& attribute : attributes)
  {
    text += (attribute.Integer ? "i" : "f") + attribute.Label + '\n';
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<Attribute> FromDescription(const std::string& text)
{
  std::vector<Attribute> attributes;
  for (size_t begin = 0; begin < text.size();)
  {
    const size_t end = text.find('\n', begin);
    Attribute attribute;
    attribute.Integer = text[begin] == 'i';
    attribute.Label = text.substr(begin + 1, end - begin - 1);
    attributes.push_back(attribute);
    begin = end + 1;
  }
  return attributes;
}
}

//------------------------------------------------------------------------------
vtkTFCAttributeAgreement::vtkTFCAttributeAgreement(vtkMultiProcessController* controller,
  std::vector<double> fillValues)
  : Controller(controller)
  , FillValues(std::move(fillValues))
{
}

//------------------------------------------------------------------------------
void vtkTFCAttributeAgreement::CheckScoring(double balance, int bins)
{
  if (!(balance >= 0. && balance < 1.))
  {
    this->Problem = "Balance is " + std::to_string(balance) + ". Set it to 0 or more, below 1.";
  }
  else if (bins < 0 || bins == 1 || bins > 65536)
  {
    this->Problem = "NumberOfBins is " + std::to_string(bins) +
      ". Set it to 2 to 65536, or to 0 for as many as the values have bits for.";
  }
}

//------------------------------------------------------------------------------
bool vtkTFCAttributeAgreement::Find(vtkDataObject* input, const std::vector<std::string>& names,
  const std::vector<std::string>& axes)
{
  std::vector<vtkDataSet*> blocks = vtkCompositeDataSet::GetDataSets<vtkDataSet>(input);
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [](vtkDataSet* block) { return block->GetNumberOfPoints() == 0; }),
    blocks.end());
  const bool isEmpty = blocks.empty();
  int association = -1;
  std::vector<std::vector<Attribute>> ofBlocks(blocks.size());
  std::string& problem = this->Problem;
  for (size_t b = 0; b < blocks.size() && problem.empty(); ++b)
  {
    std::string others;
    int found;
    problem = FindAttributes(blocks[b], names, axes, ofBlocks[b], found, others);
    if (problem.empty() && b > 0 &&
      (found != association || Describe(ofBlocks[b]) != Describe(ofBlocks[0])))
    {
      problem = "The blocks hold different arrays, or in another order. List those that all have "
                "in Arrays.";
    }
    association = found;
    if (problem.empty() && !others.empty())
    {
      this->Warning = "Arrays of points and of cells cannot be compared. Left out: " + others +
        ". Convert them with Cell Data to Point Data, or take them off Arrays.";
    }
  }
  if (!isEmpty)
  {
    this->Attributes = ofBlocks[0];
  }

  // From here on every process takes the same way, whatever it found. A single dataset is a piece
  // of one whole; the blocks of a composite one are not.
  vtkNew<vtkImageData> nothing;
  double kind = problem.empty() ? association : -1.;
  vtkTFCDistributedImage(nothing, 0, this->Controller).Maximum(&kind, 1);
  const int common = std::max(0, static_cast<int>(kind));
  const bool composite = vtkCompositeDataSet::SafeDownCast(input) != nullptr;
  this->Image = std::make_unique<vtkTFCDistributedImage>(
    composite || isEmpty ? nothing.Get() : blocks[0], common, this->Controller);
  if (!this->Image->Any(!isEmpty) && problem.empty())
  {
    problem = "The input is empty. Connect a volume with at least one point.";
  }
  const std::string mine = Describe(this->Attributes);
  const std::string shared = this->Image->ShareText(!isEmpty, mine);
  if (problem.empty() && !isEmpty && (shared != mine || kind != association))
  {
    problem = "The processes hold different arrays, or in another order. List those that all "
              "have in Arrays.";
  }
  if (!this->Image->All(problem.empty()))
  {
    problem = problem.empty()
      ? "Another process cannot use its piece of the input: see the message there."
      : problem;
    return false;
  }
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    auto owned = composite ? vtkTFCDistributedImage(blocks[b], common, nullptr).GetOwnedSamples()
                           : this->Image->GetOwnedSamples();
    this->Samples.Add(blocks[b], common, ofBlocks[b], std::move(owned), this->FillValues);
  }
  if (isEmpty)
  {
    this->Attributes = FromDescription(shared);
  }
  return true;
}
