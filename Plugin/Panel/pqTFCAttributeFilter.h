// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCAttributeFilter
 * @brief Adds the filter that gives the active data what they lack: another attribute, or a uniform
 * grid. Its output is shown instead of its input.
 *
 * One step of undo each. A property filter that takes longer than half a second can be cancelled
 * (see pqTFCCancelableUpdate): then there is no filter and no step of undo, and all is as it was.
 */

#ifndef pqTFCAttributeFilter_h
#define pqTFCAttributeFilter_h

class QString;
class pqTFCDocument;

class pqTFCAttributeFilter
{
public:
  /// The uniform grid of the active data.
  static void resampleToImage();

  /// Cell arrays as point arrays; the transfer function goes on with them.
  static void cellsToPoints(pqTFCDocument* document);

  /// The gradient magnitude of the primary attribute; it takes the secondary axis.
  static void computeGradient(pqTFCDocument* document);

  /// A property filter of the primary attribute; the transfer function stays as it is.
  static void compute(pqTFCDocument* document, const char* filter, const QString& title);
};

#endif
