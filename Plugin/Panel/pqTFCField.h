// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqTFCField
 * @brief A line of text that shows a value until somebody types another one.
 *
 * show() does not disturb what is being typed; typed() says whether there is something new.
 * (QLineEdit::isModified() would be false for what tests and screen readers enter.)
 */

#ifndef pqTFCField_h
#define pqTFCField_h

#include <QLineEdit>

class pqTFCField : public QLineEdit
{
  Q_OBJECT
  typedef QLineEdit Superclass;

public:
  pqTFCField(QWidget* parent = nullptr)
    : Superclass(parent)
  {
  }

  bool typed() const { return this->text() != this->Shown; }

  /// What was typed has been read: from now on it is what is shown.
  void accept() { this->Shown = this->text(); }

  /// Show a value; while something else is being typed, only when forced.
  void show(const QString& text, bool force)
  {
    if (force || !this->hasFocus() || !this->typed())
    {
      this->Shown = text;
      if (text != this->text())
      {
        this->setText(text);
        this->setCursorPosition(0);
      }
    }
  }

private:
  Q_DISABLE_COPY(pqTFCField)

  QString Shown;
};

#endif
