// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPixmap>
#include <QTimer>
#include <QWidget>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "haptics/snapshot.h"
#include "ui/controls/spoken.h"

namespace ui {

/// Force and torque over the last ten seconds. Every tick is kept; a pixel shows the least and
/// the greatest of its ticks, so a spike of one tick is visible. The plot is painted at most twenty
/// times a second, and not while all visible curves are flat.
class ForcePlot : public QWidget, public Spoken {
  Q_OBJECT
 public:
  static constexpr double kSeconds = 10.0;

  explicit ForcePlot(QWidget* parent = nullptr);
  void append(std::span<const haptics::ForceSample> points);
  void clear();
  float greatestForce() const { return greatest_force_; }  ///< N, greatest force in the plot
  /// How often the curves were drawn. They are kept: the view below may paint the plot more often.
  int drawings() const { return drawings_; }
  QSize sizeHint() const override { return {208, 76}; }
  QSize minimumSizeHint() const override { return {160, 60}; }

  QAccessible::Role spokenRole() const override { return QAccessible::Chart; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Column {
    float least_force, greatest_force, least_torque, greatest_torque;
    bool any;
  };
  /// The time since which both curves have been flat, to half a pixel.
  struct Level {
    double since = 0.0;  ///< s
    float least_force = 0.0F, greatest_force = 0.0F, least_torque = 0.0F, greatest_torque = 0.0F;
  };
  std::vector<Column> columns(int count, double from, double to) const;
  QRect area() const { return rect().adjusted(0, 18, 0, -1); }
  void level(const haptics::ForceSample& point);
  void draw();
  void drawAnew();
  std::vector<haptics::ForceSample> ring_;
  std::size_t next_ = 0;
  bool full_ = false;
  double newest_ = 0.0;
  float greatest_force_ = 0.0F;
  float greatest_torque_ = 0.0F;
  double force_top_ = 1.0, torque_top_ = 0.01;  ///< N and N·m, values at the upper edge
  std::optional<Level> level_;
  double painted_ = 0.0;  ///< s: time of the newest point in the last painting
  QTimer pause_;          ///< runs between two drawings
  QPixmap drawn_;         ///< null: it is to be drawn anew
  int drawings_ = 0;
  bool waits_ = false;  ///< something came meanwhile
};

}  // namespace ui
