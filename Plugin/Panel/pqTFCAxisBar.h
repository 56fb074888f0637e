// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCAxisBar
 * @brief Attribute and range of the two axes, and the button that swaps them.
 */

#ifndef pqTFCAxisBar_h
#define pqTFCAxisBar_h

#include <QWidget>

class QComboBox;
class QToolButton;
class pqTFCDocument;
class pqTFCField;

class pqTFCAxisBar : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  pqTFCAxisBar(pqTFCDocument* document, QWidget* parent = nullptr);
  ~pqTFCAxisBar() override;

public Q_SLOTS:
  /// Exchange the axes, with the shapes of the regions mirrored: the same voxels stay selected.
  void swap();
  /// Ranges follow the data again.
  void useDataRanges();

private Q_SLOTS:
  void fillAttributes();
  void refresh();
  void onAttribute(int axis, int index);
  void onRange(int axis);

private:
  Q_DISABLE_COPY(pqTFCAxisBar)

  pqTFCDocument* Document;
  QComboBox* Attributes[2];
  pqTFCField* Ends[2][2];
  QToolButton* Swap;
};

#endif
