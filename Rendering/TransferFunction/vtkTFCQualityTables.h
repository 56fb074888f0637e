// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The output tables of vtkTFCClassificationQuality, whose documentation defines the columns.
 */

#ifndef vtkTFCQualityTables_h
#define vtkTFCQualityTables_h

#include "vtkTFCCompiledModel.h" // For regions

#include <string> // For names
#include <vector> // For lists

class vtkTFCTransferFunction;
class vtkTable;

namespace vtkTFCQualityCounts
{
struct Counts;
}

namespace vtkTFCQualityTables
{
/**
 * What was counted, over all processes.
 */
struct Result
{
  const vtkTFCTransferFunction& Model;
  const std::vector<vtkTFCCompiledRegion>& Regions; ///< the columns of the counts after "none"
  const std::vector<double>& Labels;                ///< ascending
  const vtkTFCQualityCounts::Counts& Data;
  const std::vector<std::vector<double>>& Best; ///< [histogram][label]; the first: axes alone
  const std::vector<std::string>& Names;        ///< what each histogram has beyond the axes
};

///@{
/**
 * Add the columns to an empty table, with rows or without.
 */
void FillQuality(const Result& result, bool rows, vtkTable* table);
void FillConfusion(const Result& result, bool rows, vtkTable* table);
///@}
}

#endif
// VTK-HeaderTest-Exclude: vtkTFCQualityTables.h
