// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "app/background/task.h"
#include "app/window/replay.h"
#include "app/window/shared_state.h"
#include "app/window/volume_identity.h"
#include "haptics/scene/scene.h"
#include "ui/main_window.h"

namespace app {

/// Opens a recording and shows it over the volume on view, controlled by the bar below the views.
class ReplayController : public QObject {
  Q_OBJECT
 public:
  ReplayController(ui::MainWindow& window, SharedState& shared, VolumeIdentity& identity);

  /// Reads the recording in the background, and shows it then.
  void open(const std::filesystem::path& path);
  /// Closes the recording and shows the live scene again.
  void close();
  /// The same if this file is open.
  void closeFile(const std::filesystem::path& path);
  /// Closes the recording without showing the live scene, as the window closes.
  void drop();
  /// Call it when another scene is on view.
  void showScene();
  /// The recording that is on view; null: none.
  Replay* replay() { return replay_.get(); }

 signals:
  /// A recording is about to be shown; the hand or device must be closed.
  void opened();
  /// Why a recording was not opened, as it is shown.
  void refused(const QString& why);
  /// The recording was closed; a hand may hold the device again.
  void closed();
  /// Another isovalue is to be shown over this picture, and not to be touched.
  void isovalueShown(const ui::Picture& picture, double isovalue);
  /// The plot of the force begins anew; these forces follow what it shows.
  void forcesCleared();
  void forcesAppended(std::span<const haptics::ForceSample> points);

 private:
  void connectBar();
  void begin(std::unique_ptr<Replay> replay);
  void show(double time);
  void compareVolumes();
  /// Shows the scan on view as it was when this scene was touched.
  void showEdits(const haptics::RecordedScene& then);
  /// The scan with some of its edits.
  struct EditedScan {
    ui::Picture picture;
    std::shared_ptr<const haptics::Scene> scene;  ///< its field is what slices and clicks ask
  };
  void showOnView(const EditedScan& edited);

  ui::MainWindow& window_;
  SharedState& shared_;
  VolumeIdentity& identity_;
  background::Task<std::unique_ptr<Replay::Beginning>> opener_;
  std::unique_ptr<Replay> replay_;
  std::optional<std::uint32_t> scene_;  ///< scene of the recording whose tool is on view
  std::optional<double> isovalue_;      ///< isovalue on view
  double shown_to_ = 0.0;               ///< s: end of the plotted force
  ui::Picture on_view_;                 ///< of the scan, with the edits of the recording
  std::uint64_t edits_ = 0;             ///< digest of the edits on view, or being prepared
  background::Task<EditedScan> editor_;
  bool same_volume_ = false;  ///< the volume on view is the recorded one, as far as known
};

}  // namespace app
