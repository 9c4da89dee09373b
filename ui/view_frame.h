// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QWidget>

class QLabel;
class QToolButton;

namespace ui {

/// The coloured frame around a view, with its buttons in the upper right corner: a menu, if the
/// view has one, and one that makes the view as large as all of them, or gives the others back. At
/// its foot a line says what the mouse does in the view.
class ViewFrame : public QWidget {
  Q_OBJECT
 public:
  ViewFrame(QWidget* view, const QColor& colour, bool has_menu, QWidget* parent = nullptr);

  QWidget& view() { return *view_; }
  /// Whether the button gives the others back.
  void setMaximised(bool maximised);
  void setHint(const QString& hint);
  void setHintShown(bool shown);
  QSize minimumSizeHint() const override;

 signals:
  /// The user wants no hints, in any view.
  void hintsUnwanted();
  void maximiseWanted();
  void menuWanted(QPoint at);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();

  QWidget* view_;
  QColor colour_;
  QToolButton* menu_ = nullptr;
  QToolButton* maximise_;
  QLabel* hint_;
  QToolButton* hide_hint_;
  QString hint_words_;
  bool hint_shown_ = true;
};

}  // namespace ui
