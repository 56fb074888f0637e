// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCRegionForm
 * @brief Colour, opacity, fall-off and geometry of the selected region, to be typed.
 */

#ifndef pqTFCRegionForm_h
#define pqTFCRegionForm_h

#include <QWidget>

class QComboBox;
class QLabel;
class pqColorChooserButton;
class pqDoubleRangeWidget;
class pqTFCDocument;
class pqTFCField;

class pqTFCRegionForm : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  pqTFCRegionForm(pqTFCDocument* document, QWidget* parent = nullptr);
  ~pqTFCRegionForm() override;

private Q_SLOTS:
  void refresh();
  void onColor();
  void onFalloff(int type);
  void onGeometry();

private:
  Q_DISABLE_COPY(pqTFCRegionForm)

  pqTFCDocument* Document;
  pqColorChooserButton* Color;
  pqDoubleRangeWidget* Opacity;
  QComboBox* Falloff;
  pqDoubleRangeWidget* Width;
  QLabel* GeometryLabel;
  pqTFCField* Geometry;
  bool Refreshing = false;
};

#endif
