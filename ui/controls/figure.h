// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

#include "ui/controls/spoken.h"

namespace ui {

/// A figure that a screen reader reads with its name and unit, and that changes without being said.
class Figure : public QLabel, public Spoken {
 public:
  /// `unit`: what stands behind the figure in a label of its own; may be empty.
  explicit Figure(const QString& name, const QString& unit = {}) : unit_(unit) {
    offerSpoken();
    setAccessibleName(name);
  }

  QAccessible::Role spokenRole() const override { return QAccessible::StaticText; }
  QString spokenName() const override {
    return QStringLiteral("%1: %2 %3").arg(accessibleName(), text(), unit_).trimmed();
  }

 private:
  QString unit_;
};

}  // namespace ui
