// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCPointsField
 * @brief The points of the selected region's 1D function as a line of text: those of the opacity,
 * or those of the colour. See pqTFCRegionText.h for what can be typed.
 *
 * The field of the colour shows only while the region has colour points; emptying it takes them
 * away.
 */

#ifndef pqTFCPointsField_h
#define pqTFCPointsField_h

#include "pqTFCField.h"

class pqTFCDocument;

class pqTFCPointsField : public pqTFCField
{
  Q_OBJECT
  typedef pqTFCField Superclass;

public:
  enum Kinds
  {
    Opacities,
    Colors
  };

  pqTFCPointsField(pqTFCDocument* document, Kinds kind, QWidget* parent = nullptr);
  ~pqTFCPointsField() override;

private Q_SLOTS:
  void refresh(bool force = false);
  void onTyped();

private:
  Q_DISABLE_COPY(pqTFCPointsField)

  pqTFCDocument* Document;
  Kinds Kind;
};

#endif
