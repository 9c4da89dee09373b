// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "haptics/snapshot.h"
#include "ui/panels/force_plot.h"

class QLabel;

namespace ui {

/// The force on the hand: now, in large figures, and over the last seconds as a plot.
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
