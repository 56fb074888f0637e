// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCMapDialog
 * @brief Fits a transfer function that was made for other data: asks which attribute stands for
 * each one that is missing, and rescales what depends on it if wanted.
 *
 * Rescaling is linear, from the old range (that of the axis or the tertiary function; without one,
 * that of its nodes) to the new attribute's. An axis without a range is not rescaled.
 */

#ifndef pqTFCMapDialog_h
#define pqTFCMapDialog_h

#include <QDialog>

#include <string>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class pqTFCDocument;
class vtkTFCTransferFunction;

class pqTFCMapDialog : public QDialog
{
  Q_OBJECT
  typedef QDialog Superclass;

public:
  pqTFCMapDialog(pqTFCDocument* document, vtkTFCTransferFunction* model, QWidget* parent = nullptr);
  ~pqTFCMapDialog() override;

  /// Whether the data lack anything that the model names.
  bool isNeeded() const { return !this->Missing.empty(); }

  /// Change the model as chosen.
  void apply();

private:
  Q_DISABLE_COPY(pqTFCMapDialog)

  using Name = std::pair<std::string, int>; ///< array and component
  void collect(const std::string& array, int component);
  int choice(const std::string& array, int component) const;
  void mapAxes();
  void mapTertiaries();

  pqTFCDocument* Document;
  vtkTFCTransferFunction* Model;
  std::vector<Name> Missing;
  std::vector<QComboBox*> Choices;
  QCheckBox* Rescale;
};

#endif
