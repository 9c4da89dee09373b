// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <functional>

namespace ui {

/// The unit in which measures and slices write lengths. Voxels, tools and the fields of edits stay
/// in millimetres.
enum class LengthUnit { Millimetres, Centimetres };

/// GUI thread, as all of it.
LengthUnit lengthUnit();
void setLengthUnit(LengthUnit unit);

/// "mm" or "cm".
QString lengthUnitName();
/// How many millimetres it has.
double mmPerLengthUnit();
/// The decimals that show as much as so many do in millimetres.
int lengthDecimals(int decimals_mm);

/// Says that the unit has changed; whenLengthUnitChanges() listens.
class LengthTeller : public QObject {
  Q_OBJECT
 signals:
  void changed();
};

/// Calls `tell` whenever the unit has changed until `context` goes.
void whenLengthUnitChanges(QObject& context, const std::function<void()>& tell);

}  // namespace ui
