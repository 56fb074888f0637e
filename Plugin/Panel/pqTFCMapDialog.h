// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCMapDialog
 * @brief Fits a transfer function that was made for other data: asks which attribute stands for
 * each one that is missing, and whether values are kept or rescaled, by range or by quantile.
 *
 * Attributes of the same name stand for themselves. What rescaling does is in vtkTFCRescale.h; by
 * quantile needs the quantiles that files and presets of the editor carry (vtkTFCQuantiles), and
 * goes by range for an attribute without them.
 */

#ifndef pqTFCMapDialog_h
#define pqTFCMapDialog_h

#include <QDialog>

#include "vtkTFCQuantiles.h"

#include <string>
#include <vector>

class QComboBox;
class QRadioButton;
class pqTFCDocument;
struct pqTFCAttribute;
class vtkTFCTransferFunction;

class pqTFCMapDialog : public QDialog
{
  Q_OBJECT
  typedef QDialog Superclass;

public:
  pqTFCMapDialog(pqTFCDocument* document, vtkTFCTransferFunction* model, QWidget* parent = nullptr);
  ~pqTFCMapDialog() override;

  /// Whether the data lack anything that the model names, or what they have of it has another
  /// extent, by more than a hundredth, than in the data that the model was made for.
  bool isNeeded() const;

  /// Change the model as chosen.
  void apply();

private:
  Q_DISABLE_COPY(pqTFCMapDialog)

  /// An attribute that the model names.
  struct Name
  {
    std::string Array;
    int Component = 0;
    std::vector<double> Quantiles; ///< of the data that the model was made for
    QComboBox* Choice = nullptr;   ///< null: these data have it
  };
  void collect(const std::string& array, int component);
  void makeChoice(Name& name, int index);
  bool hasOtherExtent(const Name& name) const;
  const pqTFCAttribute* choice(const Name& name) const;

  pqTFCDocument* Document;
  vtkTFCTransferFunction* Model;
  std::vector<vtkTFCQuantiles::Entry> Entries;
  std::vector<Name> Names;
  QRadioButton* Keep;
  QRadioButton* ByRange;
  QRadioButton* ByQuantile;
};

#endif
