// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <utility>

#include "app/window/opening/series_choice.h"
#include "app/window/program/preferences_controller.h"
#include "app/window/scan/loader.h"
#include "app/window/scan/shared_state.h"
#include "ui/window/loading.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/start_page.h"
#include "ui/window/views.h"

namespace app {

/// Opens the paths that the user chooses or drops, asks the necessary questions, shows the loaded
/// volume, and remembers its place.
class OpeningController : public QObject {
  Q_OBJECT
 public:
  /// If not `asks`, a request that needs an answer is refused. `free_memory`: returns the free
  /// memory in bytes; called on any thread.
  OpeningController(ui::MainWindow& window, SharedState& shared, PreferencesController& preferences,
                    std::function<double()> free_memory, bool asks);

  /// Loads a request and cancels the present one. `what`: the text beside the progress.
  void load(LoadRequest request, const QString& what);
  /// Takes another volume and scene of the scan on view, after an edit. Its picture may follow.
  void replace(const app::Loaded& loaded);
  /// The same scene with a stroke of a burr, which the touch has already.
  void renew(const app::Loaded& loaded);
  /// `seen`: its voxels are on view already.
  void replacePicture(const ui::Picture& picture, bool seen);
  /// A path of volumes, of a recording or of a view. `request`: the options of the command line.
  void open(const QString& path, LoadRequest request = {});
  /// One or more paths. Several files of one folder open the folder, whose series are listed; of
  /// other paths the first is opened, and a message says so.
  void openTogether(const QStringList& paths, const LoadRequest& request = {});
  /// Asked before another scan takes the place of the one on view. Its answer is given to the
  /// argument, at once or later.
  using Guard = std::function<void(std::function<void(bool may_go)> answer)>;
  void setGuard(Guard guard) { guard_ = std::move(guard); }

 signals:
  /// What lies at the path of a request; the scan follows, or is refused.
  void surveyed(const app::Surveyed& surveyed);
  /// The user chose structures from the list of series.
  void structuresWanted(const datasets::StructuresFound& found);
  void recordingWanted(const std::filesystem::path& path);
  void viewWanted(const std::filesystem::path& path);
  void loading();
  /// `shared.shown` has the new scene, which is not yet on view or in the session. `new_volume`:
  /// the volume and its isovalue are new. `placed`: the newest snapshot is of the previous scene in
  /// the same volume.
  void loaded(bool new_volume, bool placed);
  /// The new scene is on view.
  void shown(bool new_volume);
  /// The user wants nothing remembered of what was open.
  void placesForgotten();
  /// So is the picture of its volume, which came later.
  void pictureReplaced(bool seen);
  /// Loading failed; the previous volume stays on view.
  void failed(const haptics::Error& error);

 private:
  void take(const Loaded& loaded);
  void adopt(const Loaded& loaded);
  void refuse(const LoadRequest& request, const haptics::Error& error);
  void keepPlace(const std::filesystem::path& place);
  std::optional<ToolSource> rememberedTool() const;
  void forgetPlaces();
  void showPlaces();

  ui::MainWindow& window_;
  ui::Views& views_;
  ui::Messages& messages_;
  ui::Loading& loading_;
  ui::Menus& menus_;
  ui::StartPage& start_;
  SharedState& shared_;
  PreferencesController& preferences_;
  bool asks_;
  Guard guard_;
  int asked_ = 0;  ///< counts scans and requests: an answer is for the newest
  QString what_;   ///< what the loader is at
  Loader loader_;
  SeriesChoice choice_;
  std::optional<ToolSource> tool_;  ///< that the user chose last
};

}  // namespace app
