// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/window/replay.h"
#include "app/window/shared_state.h"
#include "app/window/volume_identity.h"
#include "ui/main_window.h"

namespace app {

/// Opens a recording and shows it over the volume on view, as the bar below the views wants it.
class ReplayController : public QObject {
  Q_OBJECT
 public:
  ReplayController(ui::MainWindow& window, SharedState& shared, VolumeIdentity& identity);

  void open(const std::filesystem::path& path);
  /// Shows what was on view before it was opened.
  void close();
  /// The same if this file is open.
  void closeFile(const std::filesystem::path& path);
  /// Lets go of it, as the window closes: nothing is shown any more.
  void drop();
  /// Another scene is on view.
  void showScene();
  /// The recording that is on view; null: none.
  Replay* replay() { return replay_.get(); }

 signals:
  /// One is about to be shown: whatever holds the device lets go.
  void opened();
  /// It was closed, and a hand may hold the device again.
  void closed();

 private:
  void connectBar();
  void show(double time);
  void compareVolumes();

  ui::MainWindow& window_;
  SharedState& shared_;
  VolumeIdentity& identity_;
  std::unique_ptr<Replay> replay_;
  std::optional<std::uint32_t> scene_;  ///< whose tool is on view
  std::optional<double> isovalue_;      ///< that is on view
  double shown_to_ = 0.0;               ///< s: what the plot of the force shows
  bool same_volume_ = false;            ///< on view is what was touched, as far as can be told
};

}  // namespace app
