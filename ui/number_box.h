// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace ui {

/// A field for a number. It takes a point and a comma as decimal mark in every language, and shows
/// the language's own; digits are never grouped. With no decimals it takes whole numbers only.
///
/// Every key is shown as it was typed, because a key that is dropped would make another number of
/// the rest ("120.5" would become 1205). What is no number, has too many decimals or lies outside
/// the range is refused as a whole when the field is left or Enter is pressed: the value before
/// comes back. The value changes only then.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit NumberBox(QWidget* parent = nullptr);

  /// What the value would be if the field were left now; none: what stands there is refused.
  std::optional<double> typed() const { return numberIn(text()); }

  QValidator::State validate(QString& text, int& position) const override;
  /// Nothing is mended.
  void fixup(QString& text) const override;
  double valueFromText(const QString& text) const override;
  QString textFromValue(double value) const override;

 signals:
  /// typed() may have changed.
  void typedChanged();

 protected:
  /// Enter on what is refused does not go on to the button that Enter presses in a dialog.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::optional<double> numberIn(QString text) const;
};

}  // namespace ui
