// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/window/device_controller.h"
#include "app/window/export_controller.h"
#include "app/window/hand_controller.h"
#include "app/window/measurement_controller.h"
#include "app/window/opening_controller.h"
#include "app/window/picture_controller.h"
#include "app/window/preferences_controller.h"
#include "app/window/recording_controller.h"
#include "app/window/replay_controller.h"
#include "app/window/screenshot_controller.h"
#include "app/window/shared_state.h"
#include "app/window/tool_controller.h"
#include "datasets/readers/files/refusal.h"
#include "ui/main_window.h"

namespace app {

/// What the command line asks for.
struct Arguments {
  LoadRequest load = {};  ///< nothing to load: the demo phantom
  std::string hand = "mouse";
  std::optional<ui::SurfaceMode> surface = {};
  std::string screenshot = {};    ///< a PNG to write, then quit; or empty
  double screenshot_after = 3.0;  ///< s of running with a scene
  bool notice = true;
  std::function<double()> free_memory = datasets::freeMemory;  ///< bytes; any thread
  DeviceCatalogue devices = builtInCatalogue();
  std::filesystem::path recordings = {};  ///< where sessions are kept; empty: the user's folder
};

/// Makes the window and its controllers, and connects them. What happens is in the controllers.
class Application : public QObject {
  Q_OBJECT
 public:
  explicit Application(Arguments arguments);
  ~Application() override;

  void start();
  ui::MainWindow& window() { return window_; }
  haptics::Session& session() { return shared_.session; }
  const haptics::Snapshot& snapshot() const { return shared_.snapshot; }
  /// What is seen and touched; none before the first volume.
  const std::optional<Loaded>& shown() const { return shared_.shown; }
  SessionRecording& recording() { return recording_.recording(); }
  ExportController& exporting() { return export_; }
  /// The recording that is being replayed; null: the hand is at work.
  Replay* replay() { return replay_.replay(); }

 signals:
  /// The screenshot was written, or could not be.
  void finished(int exit_code);
  /// A scene is being touched.
  void adopted();

 private:
  void wireOpening();
  void wireHands();
  void wireRecordings();
  void noteHand(const QString& id);
  /// Ends whatever touches, records or measures.
  void close();

  Arguments arguments_;
  ui::MainWindow window_;
  SharedState shared_;
  Recordings recordings_;
  VolumeIdentity identity_;
  PreferencesController preferences_;
  OpeningController opening_;
  ToolController tool_{window_, shared_};
  HandController hand_;
  DeviceController device_;
  PictureController picture_{window_, shared_};
  MeasurementController measurement_{window_, shared_};
  RecordingController recording_;
  ReplayController replay_;
  ExportController export_;
  ScreenshotController screenshot_;
};

}  // namespace app
