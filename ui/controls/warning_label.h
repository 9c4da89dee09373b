// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

namespace ui {

/// Words that can ask for attention: then they have a ground and a bar at their left.
class WarningLabel : public QLabel {
  Q_OBJECT
 public:
  explicit WarningLabel(QWidget* parent = nullptr);
  void setWarning(bool warning);
  bool warning() const { return warning_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool warning_ = false;
};

}  // namespace ui
