// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/number_box.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>

namespace ui {
NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  // wheel and arrow keys change it; buttons of some pixels would be hard to hit
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  // else the first digits of what is refused in the end would count
  setKeyboardTracking(false);
  // a value that is set or comes back is not typed
  connect(lineEdit(), &QLineEdit::textChanged, this, &NumberBox::typedChanged);
  connect(this, &NumberBox::valueChanged, this, &NumberBox::typedChanged);
  connect(this, &NumberBox::editingFinished, this, &NumberBox::typedChanged);
}

std::optional<double> NumberBox::numberIn(QString text) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return minimum();
  if (!prefix().isEmpty() && text.startsWith(prefix())) text.remove(0, prefix().size());
  // twice where a number was pasted with its unit before the field's own
  while (!suffix().isEmpty() && text.endsWith(suffix())) text.chop(suffix().size());
  text = text.trimmed();
  static const QRegularExpression number(QStringLiteral("^([+-]?)([0-9]*)(?:[.,]([0-9]*))?$"));
  const QRegularExpressionMatch match = number.match(text.replace(QChar(0x2212), '-'));
  const QString whole = match.captured(2), fraction = match.captured(3);
  if (!match.hasMatch() || (whole.isEmpty() && fraction.isEmpty())) return {};
  if (fraction.size() > decimals()) return {};
  const double value =
      QStringLiteral("%1%2.%3").arg(match.captured(1), whole, fraction + '0').toDouble();
  if (value < minimum() || value > maximum()) return {};
  return value;
}

QValidator::State NumberBox::validate(QString& text, int&) const {
  return numberIn(text) ? QValidator::Acceptable : QValidator::Intermediate;
}

void NumberBox::fixup(QString&) const {}

double NumberBox::valueFromText(const QString& text) const {
  return numberIn(text).value_or(value());
}

QString NumberBox::textFromValue(double value) const {
  QString text = QString::number(value, 'f', decimals());
  if (locale().decimalPoint() == QLatin1String(",")) text.replace('.', ',');
  return text;
}

void NumberBox::stepBy(int steps) {
  const bool fine = QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier);
  if (!fine_step_ || !fine) return QDoubleSpinBox::stepBy(steps);
  setValue(value() + steps * *fine_step_);
  selectAll();
}

void NumberBox::keyPressEvent(QKeyEvent* event) {
  const bool refused = !typed();
  QDoubleSpinBox::keyPressEvent(event);
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && refused) event->accept();
}

NumberBox* numberBox(const NumberAsked& asked) {
  constexpr int kLeastWidth = 70;  // px
  auto* number = new NumberBox;
  number->setObjectName(asked.name);
  number->setAccessibleName(asked.accessible);
  number->setRange(asked.least, asked.most);
  number->setSingleStep(asked.step);
  number->setDecimals(asked.decimals);
  number->setSuffix(asked.suffix);
  number->setMinimumWidth(kLeastWidth);
  number->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return number;
}

NumberBox* cutEnergyBox(const char* name) {
  return numberBox({.name = name,
                    .accessible = NumberBox::tr("Energy that a cubic millimetre takes"),
                    .least = 0.01,
                    .most = 100.0,
                    .step = 0.1,
                    .decimals = 2,
                    .suffix = NumberBox::tr(" J/mm³")});
}

}  // namespace ui
