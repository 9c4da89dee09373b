// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

namespace ui {

/// The time of ticks with this number of points. CPU time, s.
struct TickTimes {
  int points = 0;
  double median = 0.0, p99 = 0.0, longest = 0.0;
  bool carried = false;  ///< fast enough
};

/// Tick time over the number of points, both logarithmic, below the budget or not: a mark at the
/// 99th percentile, a bar from the median to the longest.
class LoadPlot : public QWidget {
  Q_OBJECT
 public:
  explicit LoadPlot(QWidget* parent = nullptr);

  /// `present` is the tool as it is, `tried` others of its shape, fewest points first; `budget` in
  /// s.
  void show(const TickTimes& present, std::vector<TickTimes> tried, double budget);
  using QWidget::show;

  QSize sizeHint() const override { return {260, 190}; }
  QSize minimumSizeHint() const override { return {180, 170}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  TickTimes present_;
  std::vector<TickTimes> tried_;
  double budget_ = 0.0;
};

}  // namespace ui
