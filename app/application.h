// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/window/crash_controller.h"
#include "app/window/device_controller.h"
#include "app/window/edit_controller.h"
#include "app/window/export_controller.h"
#include "app/window/hand_controller.h"
#include "app/window/help_controller.h"
#include "app/window/isosurface_controller.h"
#include "app/window/log_controller.h"
#include "app/window/marks_controller.h"
#include "app/window/measurement_controller.h"
#include "app/window/opening_controller.h"
#include "app/window/pacs_controller.h"
#include "app/window/picture_controller.h"
#include "app/window/preferences_controller.h"
#include "app/window/recording_controller.h"
#include "app/window/replay_controller.h"
#include "app/window/screenshot_controller.h"
#include "app/window/shared_state.h"
#include "app/window/start_controller.h"
#include "app/window/tool_controller.h"
#include "app/window/view_controller.h"
#include "app/window/view_file_controller.h"
#include "datasets/readers/files/refusal.h"
#include "ui/main_window.h"

namespace app {

/// The options of the command line.
struct Arguments {
  LoadRequest load = {};   ///< default: none, an empty window
  QStringList paths = {};  ///< files or folders to open, instead of load.path; empty: none
  std::string hand = "mouse";
  std::optional<ui::SurfaceMode> surface = {};
  std::string screenshot = {};    ///< PNG to write before quitting; empty: none
  double screenshot_after = 3.0;  ///< s to wait after a scene is shown
  bool notice = true;             ///< shows notice and tour, each until it was seen once
  std::function<double()> free_memory = datasets::freeMemory;  ///< bytes; any thread
  DeviceCatalogue devices = builtInCatalogue();
  QString fetch_program = {};             ///< palpate-fetch; empty: it is looked for
  std::filesystem::path recordings = {};  ///< folder of recordings; empty: that of the preferences
  std::filesystem::path state = {};       ///< folder of log and crash reports; empty: none
};

/// Makes the window and its controllers, and connects them. The controllers do the work.
class Application : public QObject {
  Q_OBJECT
 public:
  explicit Application(Arguments arguments);
  ~Application() override;

  void start();
  /// Closes the window without a question.
  void end();
  ui::MainWindow& window() { return window_; }
  haptics::Session& session() { return shared_.session; }
  const haptics::Snapshot& snapshot() const { return shared_.snapshot; }
  /// The volume and scene on view; none before the first volume.
  const std::optional<Loaded>& shown() const { return shared_.shown; }
  SessionRecording& recording() { return recording_.recording(); }
  ExportController& exporting() { return export_; }
  EditController& editing() { return edit_; }
  MarksController& marks() { return marks_; }
  ViewFileController& viewFile() { return view_file_; }
  /// The recording that is being replayed; null: none.
  Replay* replay() { return replay_.replay(); }

 signals:
  /// The screenshot was written, or writing it failed.
  void finished(int exit_code);
  /// The session has adopted a scene.
  void adopted();

 private:
  /// Opens what the command line names, or shows how to begin.
  void begin();
  void wireOpening();
  void wireStart();
  void wireIsosurface();
  void wireHands();
  void wireRecordings();
  void wireEdits();
  void wireMarks();
  void wireLeaving();
  void wireLog();
  void wirePreferences();
  void noteHand(const QString& id);
  /// Ends touch, recording and measurement.
  void close();

  Arguments arguments_;
  ui::MainWindow window_;
  SharedState shared_;
  PreferencesController preferences_;
  Recordings recordings_;
  VolumeIdentity identity_;
  OpeningController opening_;
  StartController start_{window_, preferences_};
  ViewController view_{window_, shared_};
  // from here on, panels stand in the window in the order of their controllers
  IsosurfaceController isosurface_{window_, shared_};
  HandController hand_;
  ToolController tool_{hand_.panel(), shared_};
  PictureController picture_{window_, shared_};
  DeviceController device_;
  MeasurementController measurement_{window_, shared_};
  MarksController marks_{window_, shared_};
  ViewFileController view_file_{window_, shared_, identity_, marks_};
  RecordingController recording_;
  ReplayController replay_;
  EditController edit_{window_, shared_};
  ExportController export_;
  ScreenshotController screenshot_;
  HelpController help_{window_};
  PacsController pacs_{window_, arguments_.fetch_program};
  LogController log_{window_, shared_, arguments_.state};
  CrashController crash_{window_, arguments_.state};
};

}  // namespace app
