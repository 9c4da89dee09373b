// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

#include "ui/controls/spoken.h"

namespace ui {

/// The time of ticks with this number of points. CPU time, s.
struct TickTimes {
  int points = 0;
  double median = 0.0, p99 = 0.0, longest = 0.0;
  bool carried = false;  ///< carried by this machine
};

/// Tick time over the number of points, both logarithmic, with a line at the budget. Each number of
/// points has a mark at the 99th percentile and a bar from the median to the longest.
class LoadPlot : public QWidget, public Spoken {
  Q_OBJECT
 public:
  explicit LoadPlot(QWidget* parent = nullptr);

  /// `present` is the present tool; `tried` are tools of its shape with other numbers of points,
  /// fewest first; `budget` in s.
  void show(const TickTimes& present, std::vector<TickTimes> tried, double budget);
  using QWidget::show;

  QSize sizeHint() const override { return {260, 190}; }
  QSize minimumSizeHint() const override { return {180, 170}; }

  QAccessible::Role spokenRole() const override { return QAccessible::Chart; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  TickTimes present_;
  std::vector<TickTimes> tried_;
  double budget_ = 0.0;
};

}  // namespace ui
