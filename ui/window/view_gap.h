// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "ui/controls/spoken.h"

namespace ui {

/// The border between views. It is dragged with the mouse, or moved with the arrow keys while it
/// has the focus.
class ViewGap : public QWidget, public Spoken {
  Q_OBJECT
 public:
  explicit ViewGap(QWidget* parent);

  /// Whether it stands between views that are side by side.
  void setUpright(bool upright);

  QAccessible::Role spokenRole() const override { return QAccessible::Splitter; }

 signals:
  /// To the right or down, px.
  void moved(int by);
  /// The views shall have their first sizes again.
  void resetWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool upright_ = true;
  QPoint pressed_;
};

}  // namespace ui
