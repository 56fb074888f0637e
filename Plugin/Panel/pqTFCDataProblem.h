// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCDataProblem
 * @brief Why the data cannot be drawn with the transfer function as it is: arrays that they do not
 * have, or not any more, and arrays of points mixed with arrays of cells.
 *
 * The transfer function is never changed by that: when the arrays are back, all is as it was.
 * Arrays of regions that are hidden are not needed and not mentioned.
 */

#ifndef pqTFCDataProblem_h
#define pqTFCDataProblem_h

#include <QCoreApplication>
#include <QString>

class pqTFCDocument;

class pqTFCDataProblem
{
  Q_DECLARE_TR_FUNCTIONS(pqTFCDataProblem)

public:
  enum Kinds
  {
    None,
    NoArrays, ///< neither points nor cells have any
    Missing,
    Mixed ///< some are of the points only, others of the cells only
  };
  Kinds Kind = None;
  QString Text; ///< what is wrong and what to do; empty for None

  static pqTFCDataProblem find(const pqTFCDocument* document);
};

#endif
