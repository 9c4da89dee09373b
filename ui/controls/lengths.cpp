// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/lengths.h"

namespace ui {
namespace {

LengthUnit& presentLengthUnit() {
  static LengthUnit unit = LengthUnit::Millimetres;
  return unit;
}

LengthTeller& lengthTeller() {
  static LengthTeller teller;
  return teller;
}

}  // namespace

LengthUnit lengthUnit() { return presentLengthUnit(); }

void setLengthUnit(LengthUnit unit) {
  if (unit == presentLengthUnit()) return;
  presentLengthUnit() = unit;
  emit lengthTeller().changed();
}

QString lengthUnitName() {
  return lengthUnit() == LengthUnit::Centimetres ? QStringLiteral("cm") : QStringLiteral("mm");
}

double mmPerLengthUnit() { return lengthUnit() == LengthUnit::Centimetres ? 10.0 : 1.0; }

int lengthDecimals(int decimals_mm) {
  return lengthUnit() == LengthUnit::Centimetres ? decimals_mm + 1 : decimals_mm;
}

void whenLengthUnitChanges(QObject& context, const std::function<void()>& tell) {
  QObject::connect(&lengthTeller(), &LengthTeller::changed, &context, tell);
}

}  // namespace ui
