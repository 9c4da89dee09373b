// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

namespace ui {

/// Says over the window, while files are dragged there, that they are opened if they are let go.
class DropArea : public QWidget {
  Q_OBJECT
 public:
  explicit DropArea(QWidget* parent);
  /// Shows it over a part of its window.
  void cover(const QWidget& part);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace ui
