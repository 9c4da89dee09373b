// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/warning_label.h"

#include <QPainter>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kSideBar = 3;  // px

}  // namespace

WarningLabel::WarningLabel(QWidget* parent) : QLabel(parent) {}

void WarningLabel::setWarning(bool warning) {
  if (warning == warning_) return;
  warning_ = warning;
  if (warning)
    setContentsMargins(kSideBar + 7, 4, 6, 4);
  else
    setContentsMargins(0, 0, 0, 0);
  update();
}

void WarningLabel::paintEvent(QPaintEvent* event) {
  if (warning_) {
    QPainter painter(this);
    painter.fillRect(rect(), style::colours().attention_ground);
    painter.fillRect(QRect(0, 0, kSideBar, height()), style::colours().attention);
  }
  QLabel::paintEvent(event);
}

}  // namespace ui
