// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <functional>

#include "app/window/loader.h"
#include "app/window/preferences_controller.h"
#include "app/window/series_choice.h"
#include "app/window/shared_state.h"
#include "ui/main_window.h"

namespace app {

/// Opens what the user chooses or drops, asks what must be asked, shows what was loaded, and
/// remembers where it was.
class OpeningController : public QObject {
  Q_OBJECT
 public:
  /// Not `asks`: what needs an answer is refused. `free_memory`: bytes that may be filled; any
  /// thread.
  OpeningController(ui::MainWindow& window, SharedState& shared, PreferencesController& preferences,
                    std::function<double()> free_memory, bool asks);

  /// In place of what is being loaded. `what`: the word for it beside the progress.
  void load(LoadRequest request, const QString& what);
  /// A path of volumes or of a recording.
  void open(const QString& path);

 signals:
  void recordingWanted(const std::filesystem::path& path);
  void loading();
  /// `shared.shown` is the new scene, which is not yet touched nor on view. `new_volume`: its
  /// isovalue is new as well; `placed`: the newest snapshot is of the scene before, in the same
  /// volume.
  void loaded(bool new_volume, bool placed);
  /// It is on view now.
  void shown(bool new_volume);
  /// What was shown before stays.
  void failed(const haptics::Error& error);

 private:
  void openDropped(const QStringList& paths);
  void adopt(const Loaded& loaded);
  void refuse(const LoadRequest& request, const haptics::Error& error);
  void keepPlace(const std::filesystem::path& place);
  void forgetPlaces();
  void showPlaces();

  ui::MainWindow& window_;
  SharedState& shared_;
  PreferencesController& preferences_;
  bool asks_;
  Loader loader_;
  SeriesChoice choice_;
};

}  // namespace app
