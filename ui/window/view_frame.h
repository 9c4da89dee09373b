// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QWidget>

class QLabel;
class QToolButton;

namespace ui {

class ForcePanel;

/// A view under a line in its colour, with its buttons in the upper right corner: a menu, if the
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
  /// Shows the force in the lower right corner of the view: the figure alone where the view is
  /// small, and not at all where it would cover the most of it.
  void setCard(ForcePanel& card);
  QSize minimumSizeHint() const override;

 signals:
  /// The user wants no hints, in any view.
  void hintsUnwanted();
  void maximiseWanted();
  void menuWanted(QPoint at);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();
  void placeCard(const QRect& view);

  QWidget* view_;
  QColor colour_;
  QToolButton* menu_ = nullptr;
  QToolButton* maximise_;
  QLabel* hint_;
  QToolButton* hide_hint_;
  QString hint_words_;
  bool hint_shown_ = true;
  bool maximised_ = false;
  ForcePanel* card_ = nullptr;
};

}  // namespace ui
