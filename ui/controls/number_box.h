// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace ui {

/// A field for a number. It takes a point and a comma as decimal mark in every language, and shows
/// the language's own; digits are never grouped. With no decimals it takes whole numbers only.
///
/// Every key is shown as it was typed: dropping a key would change the number ("120.5" would become
/// 1205). The text is checked when the field is left or Enter is pressed, and the value changes
/// only then. Text that is not a number, has too many decimals or is outside the range is refused
/// as a whole, and the previous value returns.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit NumberBox(QWidget* parent = nullptr);

  /// The value if the field were left now; empty if the text would be refused.
  std::optional<double> typed() const { return numberIn(text()); }
  /// What arrows and wheel add while Shift is held, in place of singleStep().
  void setFineStep(double step) { fine_step_ = step; }

  void stepBy(int steps) override;

  QValidator::State validate(QString& text, int& position) const override;
  /// Does not correct the text.
  void fixup(QString& text) const override;
  double valueFromText(const QString& text) const override;
  QString textFromValue(double value) const override;

 signals:
  /// typed() may have changed.
  void typedChanged();

 protected:
  /// If the text is refused, Enter does not press the default button of a dialog.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::optional<double> numberIn(QString text) const;

  std::optional<double> fine_step_;
};

/// How a number is asked for.
struct NumberAsked {
  const char* name;    ///< of the field, for who looks for it
  QString accessible;  ///< what screen readers say
  double least = 0.0, most = 1.0, step = 1.0;
  int decimals = 0;
  QString suffix = {};
};
/// A field that takes the room there is.
NumberBox* numberBox(const NumberAsked& asked);

/// What it takes to cut a material [J/mm³].
NumberBox* cutEnergyBox(const char* name);

}  // namespace ui
