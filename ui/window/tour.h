// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointer>
#include <QWidget>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace ui {

/// One thing that the tour tells about.
struct TourStep {
  QWidget* target;  ///< the control, a part of the window
  QString title, sentence;
  std::function<void()> reveal = {};  ///< brings the control into view; empty: it is in view
};

/// Short explanations, one after another, each in a bubble beside the control that it is about. The
/// window can be used meanwhile. The bubble follows its control, and never takes the focus by
/// itself, since Space in the 3-D view takes the force away.
class Tour : public QWidget {
  Q_OBJECT
 public:
  explicit Tour(QWidget& window);

  /// Shows the first step. A tour that is under way begins anew.
  void begin(std::vector<TourStep> steps);
  /// Ends the tour; returns whether there was one.
  bool close();
  /// The step on view, from 0; -1: none.
  int step() const { return step_; }

 signals:
  /// The user has seen the last step, or skipped the rest.
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// The side of the bubble at which its control is.
  enum class Side { None, Left, Right, Above, Below };

  void show(int step);
  void next();
  void end();
  void place();

  QWidget& window_;
  QLabel* title_;
  QLabel* sentence_;
  QLabel* count_;
  QPushButton* next_;
  std::vector<TourStep> steps_;
  QPointer<QWidget> target_;
  int step_ = -1;
  Side side_ = Side::None;
  QPoint tip_;  ///< where the bubble points, in its own pixels
};

}  // namespace ui
