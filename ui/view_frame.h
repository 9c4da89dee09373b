// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QWidget>

class QToolButton;

namespace ui {

/// The coloured frame around a view, with its buttons in the upper right corner: a menu, if the
/// view has one, and one that makes the view as large as all of them, or gives the others back.
class ViewFrame : public QWidget {
  Q_OBJECT
 public:
  ViewFrame(QWidget* view, const QColor& colour, bool has_menu, QWidget* parent = nullptr);

  QWidget& view() { return *view_; }
  /// Whether the button gives the others back.
  void setMaximised(bool maximised);
  QSize minimumSizeHint() const override;

 signals:
  void maximiseWanted();
  void menuWanted(QPoint at);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* view_;
  QColor colour_;
  QToolButton* menu_ = nullptr;
  QToolButton* maximise_;
};

}  // namespace ui
