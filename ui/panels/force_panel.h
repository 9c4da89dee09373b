// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "haptics/snapshot.h"
#include "ui/panels/force_plot.h"

class QLabel;

namespace ui {

/// The card in the corner of the 3-D view: the force on the hand in large figures, the torque, what
/// is touched, and a plot of the last seconds. It is dark in every theme, as the view is. Screen
/// readers are told where a force or a touch begins and ends, and what differs by kSaid, once a
/// second at most.
class ForcePanel : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kSaid = 0.5;  ///< N

  explicit ForcePanel(QWidget* parent = nullptr);
  void display(const haptics::Snapshot& snapshot);
  void clear() { plot_->clear(); }
  void append(std::span<const haptics::ForceSample> points) { plot_->append(points); }
  /// The force alone, where the view is small.
  void setCompact(bool compact);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void sayForce(const haptics::Snapshot& snapshot);
  void sayTouch(const haptics::Snapshot& snapshot);

  QLabel* force_;
  QLabel* torque_;
  QLabel* touch_;
  ForcePlot* plot_;
  double said_ = 0.0;       ///< N, as screen readers were told last
  double said_time_ = 0.0;  ///< s of the loop
  int said_touch_ = 0;      ///< 0: nothing is touched, 1: something, -1: the force is withheld
  double touch_time_ = 0.0;
};

}  // namespace ui
