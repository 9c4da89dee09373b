// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <cstddef>
#include <span>
#include <vector>

namespace ui {

/// What the plot needs of one tick.
struct ForcePoint {
  double time = 0.0;    ///< s
  float force = 0.0F;   ///< N
  float torque = 0.0F;  ///< N·m
};

/// Force and torque over the last ten seconds. Every tick is kept; a pixel shows the least and
/// the greatest of the ticks that fall on it, so that a spike of one tick is seen.
class ForcePlot : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kSeconds = 10.0;

  explicit ForcePlot(QWidget* parent = nullptr);
  void append(std::span<const ForcePoint> points);
  void clear();
  float greatestForce() const { return greatest_force_; }  ///< N, on view
  QSize sizeHint() const override { return {260, 150}; }
  QSize minimumSizeHint() const override { return {160, 90}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Column {
    float least_force, greatest_force, least_torque, greatest_torque;
    bool any;
  };
  std::vector<Column> columns(int count, double from, double to) const;
  std::vector<ForcePoint> ring_;
  std::size_t next_ = 0;
  bool full_ = false;
  double newest_ = 0.0;
  float greatest_force_ = 0.0F;
  float greatest_torque_ = 0.0F;
};

}  // namespace ui
