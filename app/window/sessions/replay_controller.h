// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "app/background/task.h"
#include "app/window/scan/shared_state.h"
#include "app/window/sessions/replay.h"
#include "app/window/sessions/replayed_cuts.h"
#include "datasets/edits/edit.h"
#include "haptics/scene/scene.h"
#include "ui/panels/replay_bar.h"
#include "ui/window/loading.h"
#include "ui/window/messages.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace app {

/// Opens a recording and shows it over the volume on view, controlled by the bar below the views.
class ReplayController : public QObject {
  Q_OBJECT
 public:
  ReplayController(ui::Views& views, ui::Messages& messages, ui::Loading& loading,
                   ui::TouchState& touch, ui::ReplayBar& replay_bar, SharedState& shared);

  /// Reads the recording in the background, and shows it then.
  void open(const std::filesystem::path& path);
  /// Goes to a time of this recording [s], and opens it before if it is not on view.
  void openAt(const std::filesystem::path& path, double time);
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
  void showEdits(const RecordedScene& then);
  /// The scan with some of its edits.
  struct EditedScan {
    ui::Picture picture;
    std::shared_ptr<const haptics::Scene> scene;  ///< its field is what slices and clicks ask
  };
  /// What edits make of a scan: equal ones make the same volume.
  struct MadeOfScan {
    std::uint64_t digest = 0;  ///< of its voxels
    std::optional<datasets::TissueTable> tissues = {};
    bool operator==(const MadeOfScan&) const = default;
    static MadeOfScan of(std::uint64_t digest, std::span<const datasets::Edit> edits);
    static MadeOfScan of(const ui::Picture& picture);
  };
  void showOnView(const EditedScan& edited);
  /// Reads what a burr cut in the recording.
  void readCuts();
  /// Shows what was cut until the step on view, little by little.
  void showCuts();

  ui::Views& views_;
  ui::Messages& messages_;
  ui::Loading& loading_;
  ui::TouchState& touch_;
  ui::ReplayBar& replay_bar_;
  SharedState& shared_;
  background::Task<std::unique_ptr<Replay::Beginning>> opener_;
  std::unique_ptr<Replay> replay_;
  std::optional<double> first_;         ///< s, where the recording that is being read is shown
  std::optional<std::uint32_t> scene_;  ///< scene of the recording whose tool is on view
  std::optional<double> isovalue_;      ///< isovalue on view
  double shown_to_ = 0.0;               ///< s: end of the plotted force
  ui::Picture on_view_;                 ///< of the scan, with the edits of the recording
  MadeOfScan edits_;                    ///< on view, or being prepared
  background::Task<EditedScan> editor_;
  ReplayedCuts cuts_{views_};
  background::Task<std::vector<RecordedCut>> cut_reader_;
  QTimer cutting_;            ///< runs while the cuts on view are behind the step
  bool behind_ = false;       ///< and the user is told so
  bool same_volume_ = false;  ///< the volume on view is the recorded one, as far as known
};

}  // namespace app
