// SPDX-License-Identifier: BSD-3-Clause
#include "app/application.h"

#include <QDesktopServices>
#include <QUrl>
#include <utility>

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
#include "resources/messages/messages.h"
#include "ui/main_window.h"
#include "ui/volume_view.h"

namespace app {

/// The window and its controllers, and what connects them.
class Application::Parts : public QObject {
 public:
  Parts(Application& application_, Arguments arguments_);
  ~Parts() override;

  void start();
  void end();
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

  Application& application;
  Arguments arguments;
  ui::MainWindow window;
  SharedState shared;
  PreferencesController preferences;
  Recordings recordings;
  VolumeIdentity identity;
  OpeningController opening;
  StartController starting{window, preferences};
  ViewController view{window, shared};
  // from here on, panels stand in the window in the order of their controllers
  IsosurfaceController isosurface{window, shared};
  HandController hand;
  ToolController tool{hand.panel(), shared};
  PictureController picture{window, shared};
  DeviceController device;
  MeasurementController measurement{window, shared};
  MarksController marks{window, shared};
  ViewFileController view_file;
  RecordingController recording;
  ReplayController replay;
  EditController edit{window, shared};
  ExportController exporting;
  ScreenshotController screenshot;
  HelpController help{window};
  PacsController pacs{window, arguments.fetch_program};
  LogController log{window, shared, arguments.state};
  CrashController crash{window, arguments.state};
  bool view_awaited = false;  ///< a view is being opened, of which a picture may be wanted
};

Application::Application(Arguments arguments)
    : parts_(std::make_unique<Parts>(*this, std::move(arguments))) {}
Application::~Application() = default;

void Application::start() { parts_->start(); }
void Application::end() { parts_->end(); }
ui::MainWindow& Application::window() { return parts_->window; }
haptics::Session& Application::session() { return parts_->shared.session; }
const haptics::Snapshot& Application::snapshot() const { return parts_->shared.snapshot; }
const std::optional<Loaded>& Application::shown() const { return parts_->shared.shown; }
SessionRecording& Application::recording() { return parts_->recording.recording(); }
ExportController& Application::exporting() { return parts_->exporting; }
EditController& Application::editing() { return parts_->edit; }
MarksController& Application::marks() { return parts_->marks; }
ViewFileController& Application::viewFile() { return parts_->view_file; }
Replay* Application::replay() { return parts_->replay.replay(); }

Application::Parts::Parts(Application& application_, Arguments arguments_)
    : application(application_),
      arguments(std::move(arguments_)),
      preferences(window, arguments.screenshot.empty()),
      recordings(arguments.recordings.empty()
                     ? std::filesystem::path(preferences.present().recordings.toStdString())
                     : arguments.recordings),
      opening(window, shared, preferences, arguments.free_memory, arguments.screenshot.empty()),
      hand(window, shared, arguments.hand, preferences.firstStiffness()),
      device(window, shared, preferences, arguments.devices),
      view_file(window, shared, identity, marks, arguments.screenshot.empty()),
      recording(window, shared, recordings, identity),
      replay(window, shared, identity),
      exporting(window, shared, recordings, identity),
      screenshot(window, shared, arguments.screenshot, arguments.screenshot_after) {
  window.view().setSurfaceWish(arguments.surface);
  wireOpening();
  wireStart();
  wireIsosurface();
  wireHands();
  wireRecordings();
  wireEdits();
  wireMarks();
  wireLeaving();
  wireLog();
  wirePreferences();
  connect(&window, &ui::MainWindow::folderWanted, this, [this](const QString& folder) {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
      window.showMessage(
          Application::tr("No program here shows folders. The file is in \"%1\".").arg(folder));
  });
  connect(&window, &ui::MainWindow::closing, this, [this] {
    close();
    preferences.save();
  });
}

Application::Parts::~Parts() {
  // a window that goes says so, to what has gone before it
  window.disconnect(this);
  picture.stop();
  close();
}

void Application::Parts::end() {
  window.setCloseGuard({});
  window.close();
}

void Application::Parts::start() {
  preferences.restoreWindow();
  // nothing moves behind a notice that was not read yet
  const bool notice = arguments.notice && !preferences.present().notice_seen;
  if (!notice) begin();  // beside it the window is shown
  window.show();
  picture.start();
  if (notice) {
    preferences.showNotice();
    if (!window.isVisible()) return;  // closed meanwhile
    begin();
  }
  recording.offerRecovery();
  if (arguments.screenshot.empty()) crash.look();
}

void Application::Parts::begin() {
  LoadRequest request = arguments.load;
  arguments.load.ahead.reset();  // what is not taken does not stay in memory
  if (!arguments.paths.isEmpty()) return opening.openTogether(arguments.paths, request);
  if (request.path && QString::fromStdString(request.path->extension().string())
                              .compare(QLatin1String(kViewEnding), Qt::CaseInsensitive) == 0) {
    return emit opening.viewWanted(*request.path);  // a view may know its scan
  }
  if (request.path || request.phantom)
    return opening.load(std::move(request), Application::tr("Loading"));
  starting.drawLastScans();
  screenshot.prepare(true);
}

void Application::Parts::wireOpening() {
  using Opening = OpeningController;
  connect(&tool, &ToolController::wanted, &opening, &Opening::load);
  connect(&opening, &Opening::loading, &measurement, &MeasurementController::pause);
  // in this order: a recording knows a scene before the session has it
  connect(&opening, &Opening::loaded, &measurement, &MeasurementController::showScene);
  connect(&opening, &Opening::loaded, &recording, &RecordingController::describeScene);
  connect(&opening, &Opening::loaded, &hand, &HandController::adopt);
  // in this order: a view that is opened finds the panel of its scan, and a hand that cannot be
  // opened has the last word
  connect(&opening, &Opening::shown, &isosurface, &IsosurfaceController::showScene);
  connect(&opening, &Opening::shown, &tool, &ToolController::show);
  connect(&opening, &Opening::shown, &recording, [this] { recording.setReady(!shared.replaying); });
  connect(&opening, &Opening::shown, &replay, &ReplayController::showScene);
  connect(&opening, &Opening::shown, &edit, &EditController::showScene);
  connect(&opening, &Opening::shown, &hand, &HandController::resume);
  connect(&opening, &Opening::shown, &device, &DeviceController::openWaiting);
  connect(&opening, &Opening::shown, &screenshot, [this](bool new_volume) {
    if (!view_awaited) screenshot.prepare(new_volume);
  });
  connect(&opening, &Opening::shown, &application, &Application::adopted);
  connect(&opening, &Opening::failed, &tool, &ToolController::show);
  connect(&opening, &Opening::failed, &measurement, &MeasurementController::resume);
  connect(&opening, &Opening::failed, &screenshot, [this](const haptics::Error& error) {
    view_awaited = false;
    screenshot.fail(QString::fromStdString(resources::sentence(error)));
  });
  connect(&screenshot, &ScreenshotController::finished, &application, &Application::finished);
  connect(
      &pacs, &PacsController::openWanted, &opening,
      [this](const QString& folder, const QString& name) { opening.open(folder, {.name = name}); });
}

void Application::Parts::wireStart() {
  connect(&opening, &OpeningController::loading, &starting, &StartController::stopDrawing);
  connect(&opening, &OpeningController::failed, &starting, &StartController::drawLastScans);
  if (arguments.notice)
    connect(&opening, &OpeningController::shown, &starting, &StartController::offerTour);
}

void Application::Parts::wireIsosurface() {
  using Isosurface = IsosurfaceController;
  connect(&isosurface, &Isosurface::changed, &tool, &ToolController::showFieldSoon);
  connect(&isosurface, &Isosurface::changed, &marks.measures(), &ui::Measures::surfaceChanged);
  connect(&isosurface, &Isosurface::changed, &edit, &EditController::endPreview);
  connect(&replay, &ReplayController::isovalueShown, &isosurface, &Isosurface::show);
  connect(&view_file, &ViewFileController::isovalueWanted, &isosurface, &Isosurface::set);
}

void Application::Parts::wireHands() {
  connect(&hand, &HandController::opened, &device, [this] {
    device.forget(Application::tr("Another hand was chosen: the device was disconnected."));
  });
  connect(&hand, &HandController::changed, this, [this](const QString& id) {
    measurement.end(
        Application::tr("The measurement was cancelled: another hand took the device."));
    // which of several is nobody's business: a device's own name may tell whose it is
    noteHand(id);
  });
  connect(&view, &ViewController::toolPlaced, &hand, &HandController::bring);
  connect(&hand, &HandController::lookWanted, &picture, &PictureController::look);
  connect(&hand, &HandController::replayEndWanted, &replay, &ReplayController::close);
  connect(&device, &DeviceController::taking, &replay, &ReplayController::close);
  connect(&device, &DeviceController::taken, &hand, &HandController::takeDevice);
  connect(&device, &DeviceController::forgotten, &hand, &HandController::forgetDevice);
  connect(&device, &DeviceController::released, &hand, &HandController::reopen);
  connect(&device, &DeviceController::stiffnessWanted, &hand, &HandController::setStiffness);
  connect(&device, &DeviceController::forceChanged, &recording,
          [this](const QString& transition) { recording.note("force", transition); });
  connect(&picture, &PictureController::refreshing, &recording, &RecordingController::refresh);
  connect(&picture, &PictureController::refreshing, &device, &DeviceController::refresh);
  connect(&picture, &PictureController::snapshotTaken, &device, &DeviceController::showForce);
}

void Application::Parts::noteHand(const QString& id) {
  // what follows tells one device from others of its kind, and is nobody's business
  recording.note("hand", id.section(':', 0, 0));
}

void Application::Parts::wireRecordings() {
  connect(&opening, &OpeningController::recordingWanted, &replay, &ReplayController::open);
  connect(&recording, &RecordingController::openWanted, &replay, &ReplayController::open);
  connect(&recording, &RecordingController::exportWanted, &exporting,
          &ExportController::exportRecording);
  connect(&recording, &RecordingController::deleting, &replay, &ReplayController::closeFile);
  connect(&recording, &RecordingController::starting, &replay, &ReplayController::close);
  connect(&recording, &RecordingController::started, this,
          [this] { noteHand(QString::fromStdString(hand.name())); });
  connect(&replay, &ReplayController::forcesCleared, &picture, &PictureController::clearForces);
  connect(&replay, &ReplayController::forcesAppended, &picture, &PictureController::appendForces);
  connect(&replay, &ReplayController::refused, &screenshot, &ScreenshotController::fail);
  connect(&replay, &ReplayController::opened, &screenshot, [this] { screenshot.prepare(true); });
  connect(&replay, &ReplayController::opened, this, [this] {
    recording.recording().stop();
    measurement.end(
        Application::tr("The measurement was cancelled: a recording is being replayed."));
    // the hand lets go: what is seen is what was
    shared.session.close();
    device.forget(Application::tr("A recording was opened: the device was disconnected."));
    recording.setReady(false);
  });
  connect(&replay, &ReplayController::closed, this, [this] {
    recording.setReady(shared.shown.has_value());
    hand.reopen();
  });
}

void Application::Parts::wireEdits() {
  connect(&edit, &EditController::edited, &opening, &OpeningController::replace);
  connect(&edit, &EditController::pictured, &opening, &OpeningController::replacePicture);
  connect(&opening, &OpeningController::pictureReplaced, &isosurface,
          [this] { isosurface.showScene(false); });
  connect(&edit, &EditController::noted, &recording,
          [this](const QString& what) { recording.note("edit", what); });
  connect(&picture, &PictureController::refreshing, &edit, &EditController::refresh);
  connect(&replay, &ReplayController::opened, &edit, [this] { edit.setReplaying(true); });
  connect(&replay, &ReplayController::closed, &edit, [this] { edit.setReplaying(false); });
}

void Application::Parts::wireMarks() {
  // in this order: the marks of a view come after those of the scan before are gone
  connect(&opening, &OpeningController::shown, &marks, &MarksController::showScene);
  connect(&opening, &OpeningController::shown, &view_file, &ViewFileController::showScene);
  connect(&opening, &OpeningController::failed, &view_file, [this](const haptics::Error& error) {
    // where the user has a choice, the scan may still come
    for (const char* asked : {kWhichSeries, kTooLarge, kMissingSlices})
      if (error.reason == asked) return;
    view_file.drop();
  });
  connect(&opening, &OpeningController::viewWanted, this,
          [this](const std::filesystem::path& path) {
            view_awaited = true;
            view_file.open(path);
          });
  connect(&picture, &PictureController::refreshing, &marks, &MarksController::refresh);
  connect(&view_file, &ViewFileController::scanWanted, &opening,
          [this](const std::filesystem::path& path) {
            opening.load({.path = path}, Application::tr("Reading"));
          });
  connect(&view_file, &ViewFileController::refused, &screenshot, [this](const QString& sentence) {
    view_awaited = false;
    screenshot.fail(sentence);
  });
  connect(&view_file, &ViewFileController::finished, &screenshot, [this](bool done) {
    if (!std::exchange(view_awaited, false)) return;
    done ? screenshot.prepare(true) : screenshot.fail(Application::tr("The view was not opened."));
  });
  connect(&view_file, &ViewFileController::editsWanted, &edit, &EditController::restore);
  connect(&view_file, &ViewFileController::toolWanted, &tool,
          [this](const QString& name) { tool.changeTool({.name = name.toStdString()}); });
}

void Application::Parts::wireLeaving() {
  using Leave = ViewFileController::Leave;
  window.setCloseGuard([this] {
    return view_file.leave(Leaving::Window, [this](bool saved) {
      if (saved) end();
    }) == Leave::Now;
  });
  opening.setGuard([this](const std::function<void(bool)>& answer) {
    const Leave now = view_file.leave(Leaving::Scan, answer);
    if (now != Leave::AfterSaving) answer(now == Leave::Now);
  });
}

void Application::Parts::wireLog() {
  connect(&opening, &OpeningController::loading, &log, &LogController::noteLoading);
  connect(&opening, &OpeningController::shown, &log, &LogController::noteScene);
  connect(&opening, &OpeningController::failed, &log, &LogController::noteRefusal);
  connect(&hand, &HandController::changed, &log, &LogController::noteHand);
  connect(&device, &DeviceController::taken, &log, &LogController::noteHand);
  connect(&device, &DeviceController::forceChanged, &log, &LogController::noteForce);
  connect(&device, &DeviceController::forgotten, &log, &LogController::noteServo);
  connect(&recording.recording(), &SessionRecording::statusChanged, &log,
          &LogController::noteRecording);
  connect(&recording.recording(), &SessionRecording::finished, &log, &LogController::noteRecorded);
  connect(&window, &ui::MainWindow::closing, &log, &LogController::noteServo);
}

void Application::Parts::wirePreferences() {
  using Choices = PreferencesController;
  connect(&preferences, &Choices::stiffnessChosen, &device, &DeviceController::setStiffness);
  const auto chooseRate = [this] { shared.session.chooseRate(preferences.servoRate()); };
  chooseRate();
  connect(&preferences, &Choices::servoRateChosen, this, chooseRate);
  connect(&preferences, &Choices::recordingsChosen, &recording, [this](const QString& folder) {
    recordings.setFolder(folder.toStdString());
    recording.showRecordings();
  });
  // the menu has the entries of the edits by now
  window.offerPreferences();
}

void Application::Parts::close() {
  measurement.end({});
  replay.drop();
  shared.session.close();
  recording.recording().end();
}

}  // namespace app
