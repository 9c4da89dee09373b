// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "haptics/snapshot.h"
#include "ui/panels/force_plot.h"

class QLabel;

namespace ui {

/// The force on the hand: the present value in large figures, and a plot of the last seconds.
class ForcePanel : public QWidget {
  Q_OBJECT
 public:
  explicit ForcePanel(QWidget* parent = nullptr);
  void display(const haptics::Snapshot& snapshot);
  void clear() { plot_->clear(); }
  void append(std::span<const haptics::ForceSample> points) { plot_->append(points); }

 private:
  QLabel* force_;
  QLabel* torque_;
  QLabel* state_;
  ForcePlot* plot_;
};

}  // namespace ui
