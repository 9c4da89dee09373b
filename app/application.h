// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/window/device/device_catalogue.h"
#include "app/window/scan/load_request.h"
#include "datasets/readers/files/refusal.h"
#include "ui/props/surface_choice.h"

namespace haptics {
class Session;
struct Snapshot;
}  // namespace haptics
namespace ui {
class MainWindow;
}

namespace app {

class EditController;
class ExportController;
class MarksController;
class Replay;
class ReportController;
class SessionRecording;
class StructuresController;
class ViewFileController;
struct Loaded;

/// The options of the command line.
struct Arguments {
  LoadRequest load = {};              ///< default: none, an empty window
  std::filesystem::path labels = {};  ///< structures of the first scan; empty: none
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
  std::filesystem::path journal = {};     ///< folder of work that is not saved yet; empty: none
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
  ui::MainWindow& window();
  haptics::Session& session();
  const haptics::Snapshot& snapshot() const;
  /// The volume and scene on view; none before the first volume.
  const std::optional<Loaded>& shown() const;
  SessionRecording& recording();
  ExportController& exporting();
  ReportController& reporting();
  EditController& editing();
  MarksController& marks();
  ViewFileController& viewFile();
  StructuresController& structures();
  /// The recording that is being replayed; null: none.
  Replay* replay();

 signals:
  /// The screenshot was written, or writing it failed.
  void finished(int exit_code);
  /// The session has adopted a scene.
  void adopted();

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace app
