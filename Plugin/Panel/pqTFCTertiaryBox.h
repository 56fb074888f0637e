// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCTertiaryBox
 * @brief Chooses a region's tertiary attribute: "None", then the candidates with their scores, best
 * first, then the other attributes.
 *
 * The ranking is computed when the list is opened for the first time; before, and where there is
 * none, the order is that of the data.
 */

#ifndef pqTFCTertiaryBox_h
#define pqTFCTertiaryBox_h

#include <QComboBox>

class pqTFCAdvice;
class pqTFCDocument;

class pqTFCTertiaryBox : public QComboBox
{
  Q_OBJECT
  typedef QComboBox Superclass;

public:
  /// Item data: index into the document's attributes, -1 for none, MISSING for what the data lack.
  enum Data
  {
    MISSING = -2,
    AttributeRole = Qt::UserRole,
    ScoreRole
  };

  /// For the region with that id; 0: for the selected one.
  pqTFCTertiaryBox(pqTFCDocument* document, pqTFCAdvice* advice, QWidget* parent = nullptr,
    int region = 0);
  ~pqTFCTertiaryBox() override;

  void showPopup() override;

Q_SIGNALS:
  /// Index into the document's attributes, -1 for none; only when the user chooses another one.
  void chosen(int attribute);

private Q_SLOTS:
  void refresh();

private:
  Q_DISABLE_COPY(pqTFCTertiaryBox)

  pqTFCDocument* Document;
  pqTFCAdvice* Advice;
  int Region;
  bool Refreshing = false;
};

#endif
