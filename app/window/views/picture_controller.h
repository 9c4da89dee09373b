// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/window/scan/shared_state.h"
#include "app/window/views/fine_mesher.h"
#include "ui/panels/force_panel.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace app {

/// Keeps the picture up to date: the newest snapshot and forces at display rate, and without a
/// usable GPU the fine mesh of the surface. Its panel shows the force.
class PictureController : public QObject {
  Q_OBJECT
 public:
  PictureController(ui::Views& views, ui::TouchState& touch, SharedState& shared);

  void start() { display_.start(); }
  void stop() { display_.stop(); }
  /// Whether the view turns to the tool at the next snapshot.
  void look(bool at_tool) { look_ = at_tool; }
  /// Clears the plot of the force, and appends to it.
  void clearForces() { panel_->clear(); }
  void appendForces(std::span<const haptics::ForceSample> points) { panel_->append(points); }
  /// What tells the name of the solid structure at a place [mm]; empty: none is there.
  void nameSolidsBy(std::function<QString(const Eigen::Vector3d& p_W_mm)> name) {
    solid_at_ = std::move(name);
  }
  /// Shows how near structures are, beside the force.
  void showNear(const std::vector<ui::StructureNear>& near, const ui::NearLimits& limits) {
    panel_->showNear(near, limits);
  }

 signals:
  /// A picture is about to be drawn; emitted sixty times a second.
  void refreshing();
  /// `shared.snapshot` is new, and a scene is on view.
  void snapshotTaken();

 private:
  void refresh();
  std::optional<ui::TouchedValue> touchedIn(const haptics::Snapshot& snapshot) const;
  void showForces();

  ui::Views& views_;
  ui::TouchState& touch_;
  SharedState& shared_;
  ui::ForcePanel* panel_;
  QTimer display_;
  std::function<QString(const Eigen::Vector3d&)> solid_at_ = [](const auto&) { return QString{}; };
  std::vector<haptics::ForceSample> samples_;
  bool look_ = false;
  FineMesher mesher_;
};

}  // namespace app
