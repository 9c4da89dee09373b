// SPDX-License-Identifier: BSD-3-Clause
#include "app/application.h"

#include <QDesktopServices>
#include <QGuiApplication>
#include <QMessageBox>
#include <QTimer>
#include <QUrl>
#include <utility>

#include "app/recording/cut_words.h"
#include "app/recording/felt_words.h"
#include "app/window/device/device_controller.h"
#include "app/window/edits/cut_controller.h"
#include "app/window/edits/edit_controller.h"
#include "app/window/edits/surface_controller.h"
#include "app/window/opening/opening_controller.h"
#include "app/window/opening/pacs_controller.h"
#include "app/window/opening/start_controller.h"
#include "app/window/program/crash_controller.h"
#include "app/window/program/help_controller.h"
#include "app/window/program/log_controller.h"
#include "app/window/program/preferences_controller.h"
#include "app/window/program/recent_places.h"
#include "app/window/scan/shared_state.h"
#include "app/window/sessions/export_controller.h"
#include "app/window/sessions/recording_controller.h"
#include "app/window/sessions/replay_controller.h"
#include "app/window/structures/report_controller.h"
#include "app/window/structures/structures_controller.h"
#include "app/window/structures/walls_controller.h"
#include "app/window/touch/hand_controller.h"
#include "app/window/touch/isosurface_controller.h"
#include "app/window/touch/measurement_controller.h"
#include "app/window/touch/tool_controller.h"
#include "app/window/views/before_controller.h"
#include "app/window/views/grey_keeper.h"
#include "app/window/views/journal_controller.h"
#include "app/window/views/marks_controller.h"
#include "app/window/views/picture_controller.h"
#include "app/window/views/screenshot_controller.h"
#include "app/window/views/view_controller.h"
#include "app/window/views/view_file_controller.h"
#include "resources/messages/messages.h"
#include "ui/views/volume_view.h"
#include "ui/window/loading.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace app {

/// The window and its controllers, and what connects them.
class Application::Parts : public QObject {
 public:
  Parts(Application& application, Arguments arguments);
  ~Parts() override;

  void start();
  void end();

  ui::MainWindow window;
  SharedState shared;
  PreferencesController preferences;
  OpeningController opening;
  StartController starting{window, preferences};
  ViewController view{window, shared};
  // from here on, panels stand in the window in the order of their controllers
  IsosurfaceController isosurface{window.views(), window.messages(), window.panels(), shared};
  HandController hand;
  EditController edit{window, shared};
  ToolController tool{hand.panel(), window.panels(), shared};
  CutController cut{window, shared};
  GreyKeeper grey{window.views().slices(), shared};
  PictureController picture{window.views(), window.touch(), shared};
  BeforeController before{window.views(), window.messages(), shared};
  DeviceController device;
  MeasurementController measurement{window.panels(), shared};
  MarksController marks{window.views(), window.menus(),  window.panels(),
                        window.bar(),   window.escape(), shared};
  StructuresController structures;
  WallsController walls{window.messages(), shared};
  ViewFileController view_file;
  JournalController journal;
  RecordingController recording;
  ReplayController replay{window.views(), window.messages(),  window.loading(),
                          window.touch(), window.replayBar(), shared};
  SurfaceController surface{window, shared};
  ExportController exporting{window.views(), window.messages(),      window.loading(),
                             shared,         recording.recordings(), marks.measures()};
  ReportController reporting{window.messages(), window.loading(), shared, recording.recordings(),
                             structures};
  ScreenshotController screenshot;
  HelpController help{window.menus(), window.messages()};
  PacsController pacs;
  LogController log;
  CrashController crash;

 private:
  /// Opens what the command line names, or shows how to begin.
  void begin();
  // what happens to a scan that is loaded, in this order, and to one that is not
  void prepareScene(bool new_volume, bool placed);
  void showScene(bool new_volume);
  void refuseScan(const haptics::Error& error);
  // and to a recording
  void openReplay();
  void closeReplay();
  /// Ends touch, recording and measurement.
  void close();
  void noteHand(const QString& id);
  /// Whether a file is being written that is not there before it is whole.
  bool isWriting();
  /// Asks what becomes of such a file. Returns false if the window is to stay.
  bool settleWriting();
  /// A file is whole, or was not written: why, for the user.
  void endWriting(const QString& why);
  /// Whether a burr has cut what is no edit yet.
  bool hasStrokes() { return cut.hasCut() || edit.hasStrokes(); }

  void wireOpening();
  void wireTouch();
  void wireDevice();
  void wireSessions();
  void wireViews();
  void wireProgram();
  void wireLeaving();

  Application& application_;
  Arguments arguments_;
  bool asked_ = false;                   ///< the user was asked about what would be lost
  std::function<void()> after_strokes_;  ///< waits until all are edits
  bool background_ = false;              ///< the window is gone, and a file is still being written
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
ReportController& Application::reporting() { return parts_->reporting; }
ExportController& Application::exporting() { return parts_->exporting; }
EditController& Application::editing() { return parts_->edit; }
MarksController& Application::marks() { return parts_->marks; }
ViewFileController& Application::viewFile() { return parts_->view_file; }
StructuresController& Application::structures() { return parts_->structures; }
Replay* Application::replay() { return parts_->replay.replay(); }

Application::Parts::Parts(Application& application, Arguments arguments)
    : preferences(window, arguments.screenshot.empty()),
      opening(window, shared, preferences, arguments.free_memory, arguments.screenshot.empty()),
      hand(window.views(), window.messages(), window.panels(), window.touch(), shared,
           arguments.hand, preferences.firstStiffness()),
      device(window.views(), window.messages(), window.panels(), window.touch(), window.startPage(),
             shared, preferences, arguments.devices),
      structures(window.views(), window.messages(), window.loading(), window.menus(),
                 window.panels(), shared, preferences, arguments.free_memory),
      view_file(window.views(), window.messages(), window.loading(), window.menus(), shared, marks,
                arguments.screenshot.empty()),
      journal(window.messages(), shared, preferences, view_file, arguments.journal),
      recording(window, shared,
                arguments.recordings.empty()
                    ? std::filesystem::path(preferences.present().recordings.toStdString())
                    : arguments.recordings),
      screenshot(window, shared, arguments.screenshot, arguments.screenshot_after),
      pacs(window.messages(), window.menus(), arguments.fetch_program),
      log(window.views(), window.messages(), window.menus(), shared, arguments.state),
      crash(window.messages(), arguments.state),
      application_(application),
      arguments_(std::move(arguments)) {
  window.views().volume().setSurfaceWish(arguments_.surface);
  wireOpening();
  wireTouch();
  wireDevice();
  wireSessions();
  wireViews();
  wireProgram();
  wireLeaving();
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
  const bool notice = arguments_.notice && !preferences.present().notice_seen;
  if (!notice) begin();  // beside it the window is shown
  window.show();
  picture.start();
  if (notice) {
    preferences.showNotice();
    if (!window.isVisible()) return;  // closed meanwhile
    begin();
  }
  recording.offerRecovery();
  if (arguments_.screenshot.empty()) crash.look();
  if (!arguments_.load.path && arguments_.paths.isEmpty()) journal.look();
}

void Application::Parts::begin() {
  if (!arguments_.labels.empty()) screenshot.await();
  LoadRequest request = arguments_.load;
  if (!arguments_.paths.isEmpty()) return opening.openTogether(arguments_.paths, request);
  if (request.path && QString::fromStdString(request.path->extension().string())
                              .compare(QLatin1String(kViewEnding), Qt::CaseInsensitive) == 0) {
    return emit opening.viewWanted(*request.path);  // a view may know its scan
  }
  if (request.path || request.phantom)
    return opening.load(std::move(request), Application::tr("Loading"));
  starting.drawLastScans();
  screenshot.prepare(true);
}

void Application::Parts::prepareScene(bool new_volume, bool placed) {
  measurement.showScene();
  recording.describeScene();  // a recording knows a scene before the session has it
  hand.adopt(new_volume, placed);
}

void Application::Parts::showScene(bool new_volume) {
  isosurface.showScene(new_volume);
  tool.show();
  recording.setReady(!shared.replaying);
  replay.showScene();
  edit.showScene();
  cut.showScene(edit.edits());
  before.showScene();
  hand.resume();  // after the panels: a hand that cannot be opened has the last word
  device.openWaiting();
  screenshot.prepare(new_volume);
  emit application_.adopted();
  if (arguments_.notice) starting.offerTour();
  marks.showScene();
  structures.showScene();
  walls.showScene();
  if (!arguments_.labels.empty()) structures.open(std::exchange(arguments_.labels, {}));
  if (new_volume) grey.showScene();
  journal.showScene();
  view_file.showScene(new_volume);  // its marks come after those of the scan before are gone
  log.noteScene(new_volume);
}

void Application::Parts::refuseScan(const haptics::Error& error) {
  tool.show();
  measurement.resume();
  screenshot.fail(QString::fromStdString(resources::sentence(error)));
  starting.drawLastScans();
  // where the user has a choice, the scan may still come
  const bool asked = error.kind == haptics::Error::Kind::Correctable ||
                     error.reason == kWhichSeries || error.reason == kTooLarge ||
                     error.reason == kMissingSlices;
  if (!asked) view_file.drop();
  log.noteRefusal(error);
}

void Application::Parts::openReplay() {
  screenshot.prepare(true);
  recording.recording().stop();
  measurement.end(Application::tr("The measurement was cancelled: a recording is being replayed."));
  // the hand lets go: what is seen is what was
  shared.session.close();
  shared.snapshot = {};
  device.forget(Application::tr("A recording was opened: the device was disconnected."));
  recording.setReady(false);
  edit.setReplaying(true);
  cut.setReplaying(true);
}

void Application::Parts::closeReplay() {
  recording.setReady(shared.shown.has_value());
  hand.reopen();
  edit.setReplaying(false);
  cut.setReplaying(false);
  walls.showScene();
}

void Application::Parts::close() {
  measurement.end({});
  replay.drop();
  shared.session.close();
  recording.recording().end();
}

void Application::Parts::noteHand(const QString& id) {
  // what follows tells one device from others of its kind, and is nobody's business
  recording.note("hand", id.section(':', 0, 0));
}

bool Application::Parts::isWriting() {
  return exporting.task().isRunning() || edit.isSaving() || surface.isWriting();
}

bool Application::Parts::settleWriting() {
  if (!isWriting()) return true;
  switch (window.messages().askToFinish()) {
    case ui::Unfinished::Cancel:
      return false;
    case ui::Unfinished::Stop:
      exporting.task().cancel();
      edit.stopSaving();
      surface.stopWriting();
      return true;
    case ui::Unfinished::Finish:
      break;
  }
  background_ = isWriting();
  if (background_) QGuiApplication::setQuitOnLastWindowClosed(false);
  return true;
}

void Application::Parts::endWriting(const QString& why) {
  if (!background_ || isWriting()) return;
  if (!why.isEmpty())
    QMessageBox::warning(nullptr, Application::tr("The file was not written"), why);
  emit application_.finished(0);
}

void Application::Parts::wireOpening() {
  using Opening = OpeningController;
  connect(&opening, &Opening::loaded, this, &Parts::prepareScene);
  connect(&opening, &Opening::shown, this, &Parts::showScene);
  connect(&opening, &Opening::failed, this, &Parts::refuseScan);
  connect(&opening, &Opening::loading, &measurement, &MeasurementController::pause);
  connect(&opening, &Opening::loading, &starting, &StartController::stopDrawing);
  connect(&opening, &Opening::pictureReplaced, &isosurface,
          [this] { isosurface.showScene(false); });
  connect(&window.touch(), &ui::TouchState::worded, &structures, &StructuresController::showNear);
  connect(&structures, &StructuresController::watchGiven, &walls, &WallsController::setWatch);
  connect(&walls, &WallsController::made, &opening, &Opening::replace);
  connect(&opening, &Opening::surveyed, &structures, &StructuresController::know);
  connect(&opening, &Opening::structuresWanted, &structures, &StructuresController::openFound);
  connect(&structures, &StructuresController::nearChanged, &picture, &PictureController::showNear);
  picture.nameSolidsBy([this](const auto& p_W_mm) { return structures.solidAt(p_W_mm); });
  connect(&structures, &StructuresController::nearChanged, &window.touch(),
          &ui::TouchState::showNear);
  connect(&window, &ui::MainWindow::dropped, &structures, &StructuresController::sort);
  connect(&window.menus(), &ui::Menus::openWanted, &structures,
          [this](const QString& path) { structures.sort({path}); });
  connect(&window.menus(), &ui::Menus::structuresTried, this, [this] {
    structures.awaitPhantom(kPhantomOfStructures);
    opening.load({.phantom = kPhantomOfStructures}, Application::tr("Making the phantom"));
  });
  connect(&structures, &StructuresController::scanWanted, &opening,
          [this](const QStringList& paths) { opening.openTogether(paths); });
  connect(&opening, &Opening::recordingWanted, &replay, &ReplayController::open);
  connect(&opening, &Opening::viewWanted, this, [this](const std::filesystem::path& path) {
    screenshot.await();
    view_file.open(path);
  });
  connect(&opening, &Opening::placesForgotten, &journal, &JournalController::forget);
  connect(&tool, &ToolController::wanted, &opening, &Opening::load);
  connect(&edit, &EditController::edited, &opening, &Opening::replace);
  connect(&edit, &EditController::renewed, &opening, &Opening::renew);
  connect(&edit, &EditController::pictured, &opening, &Opening::replacePicture);
  connect(&opening, &Opening::pictureReplaced, &cut, [this](bool seen) {
    if (!seen) cut.showLive();
  });
  connect(
      &pacs, &PacsController::openWanted, &opening,
      [this](const QString& folder, const QString& name) { opening.open(folder, {.name = name}); });
}

void Application::Parts::wireTouch() {
  using Isosurface = IsosurfaceController;
  connect(&isosurface, &Isosurface::changed, &tool, &ToolController::showFieldSoon);
  connect(&isosurface, &Isosurface::changed, &marks.measures(), &ui::Measures::surfaceChanged);
  connect(&isosurface, &Isosurface::changed, &edit, &EditController::endPreview);
  connect(&isosurface, &Isosurface::changed, &walls, &WallsController::showIsovalue);
  connect(&hand, &HandController::opened, &device, [this] {
    device.forget(Application::tr("Another hand was chosen: the device was disconnected."));
  });
  connect(&hand, &HandController::changed, this, [this](const QString& id) {
    measurement.end(
        Application::tr("The measurement was cancelled: another hand took the device."));
    noteHand(id);
  });
  connect(&hand, &HandController::lookWanted, &picture, &PictureController::look);
  connect(&hand, &HandController::replayEndWanted, &replay, &ReplayController::close);
  connect(&view, &ViewController::toolPlaced, &hand, &HandController::bring);
  connect(&view, &ViewController::toolLifted, &hand, &HandController::lift);
  connect(&edit, &EditController::liftWanted, &view, &ViewController::liftTool);
  connect(&hand, &HandController::changed, &edit,
          [this] { edit.setDeviceHeld(hand.holdsDevice()); });
  using Cut = CutController;
  connect(&cut, &Cut::toolWanted, &tool,
          [this](const QString& name) { tool.changeTool({.name = name.toStdString()}); });
  edit.setCutting([this] { return cut.isCutting(); });
  connect(&cut, &Cut::strokeMade, &edit, &EditController::addStroke);
  connect(&cut, &Cut::freshWanted, &edit, &EditController::renew);
  connect(&edit, &EditController::failed, &cut, &Cut::forgetWaiting);
  connect(&cut, &Cut::undoWanted, &edit, &EditController::undo);
  connect(&cut, &Cut::redoWanted, &edit, &EditController::redo);
  connect(&edit, &EditController::stepsChanged, &cut, &Cut::setSteps);
  connect(&cut, &Cut::lawChosen, &recording, [this](const QString& words, double scene) {
    recording.note(kCutLawEvent, words, scene);
  });
  connect(&edit, &EditController::noted, &recording,
          [this](const QString& what) { recording.note("edit", what); });
}

void Application::Parts::wireDevice() {
  using Device = DeviceController;
  connect(&device, &Device::taking, &replay, &ReplayController::close);
  connect(&device, &Device::taken, &hand, &HandController::takeDevice);
  connect(&device, &Device::forgotten, &hand, &HandController::forgetDevice);
  connect(&device, &Device::released, &hand, &HandController::reopen);
  connect(&device, &Device::stiffnessWanted, &hand, &HandController::setStiffness);
  connect(&device, &Device::forceChanged, &recording,
          [this](const QString& transition) { recording.note("force", transition); });
}

void Application::Parts::wireSessions() {
  recording.setUncut([this](const std::function<void()>& then) { cut.whenUncut(then); });
  recording.setScans([this] { return namesOf(preferences.present().place_hashes); });
  connect(&recording, &RecordingController::openWanted, &replay, &ReplayController::open);
  connect(&recording, &RecordingController::exportWanted, &exporting,
          &ExportController::exportRecording);
  connect(&recording, &RecordingController::reportWanted, &reporting,
          &ReportController::reportRecording);
  connect(&reporting, &ReportController::momentWanted, &replay, &ReplayController::openAt);
  connect(&reporting, &ReportController::pageWanted, this, [this](const QString& path) {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path)))
      window.messages().showMessage(
          Application::tr("No program here shows pages. The report is \"%1\".").arg(path));
  });
  connect(&recording, &RecordingController::deleting, &replay, &ReplayController::closeFile);
  connect(&recording, &RecordingController::starting, &replay, &ReplayController::close);
  connect(&recording, &RecordingController::started, this, [this] {
    noteHand(QString::fromStdString(hand.name()));
    // with a value: since the beginning
    if (!structures.felt().isEmpty()) recording.note(kFeltEvent, structures.felt(), 1.0);
    cut.tellLaw();
  });
  connect(&structures, &StructuresController::feltChanged, &recording,
          [this](const QString& felt) { recording.note(kFeltEvent, felt); });
  connect(&replay, &ReplayController::opened, this, &Parts::openReplay);
  connect(&replay, &ReplayController::closed, this, &Parts::closeReplay);
  connect(&replay, &ReplayController::refused, &screenshot, &ScreenshotController::fail);
  connect(&replay, &ReplayController::isovalueShown, &isosurface, &IsosurfaceController::show);
  connect(&replay, &ReplayController::forcesCleared, &picture, &PictureController::clearForces);
  connect(&replay, &ReplayController::forcesAppended, &picture, &PictureController::appendForces);
}

void Application::Parts::wireViews() {
  connect(&picture, &PictureController::refreshing, this, [this] {
    recording.refresh();
    device.refresh();
    cut.refresh();
    edit.refresh();
    marks.refresh();
    structures.refresh();
    // not here: it may ask
    if (after_strokes_ && !hasStrokes())
      QTimer::singleShot(0, this, std::exchange(after_strokes_, {}));
  });
  connect(&picture, &PictureController::snapshotTaken, &device, &DeviceController::showForce);
  using File = ViewFileController;
  connect(&view_file, &File::scanWanted, &opening,
          [this](const std::filesystem::path& path, const haptics::Grid& grid) {
            opening.load({.path = path, .grid = grid}, Application::tr("Reading"));
          });
  connect(&view_file, &File::editsWanted, &edit, &EditController::restore);
  view_file.setKnown({.place =
                          [this](const VolumeHash& hash) {
                            const QString hex = QString::fromStdString(hexOf(hash));
                            const QString place =
                                placeWith(preferences.present().place_hashes, hex);
                            return std::filesystem::path(place.toStdString());
                          },
                      .tools =
                          [this] {
                            std::vector<std::filesystem::path> files;
                            for (const QString& file : preferences.present().tools)
                              files.emplace_back(file.toStdString());
                            return files;
                          }});
  connect(&view_file, &File::toolWanted, &tool, &ToolController::changeTool);
  connect(&view_file, &File::poseWanted, &view, &ViewController::bringBack);
  connect(&view_file, &File::isovalueWanted, &isosurface, &IsosurfaceController::set);
  connect(&view_file, &File::refused, &screenshot, &ScreenshotController::fail);
  connect(&view_file, &File::finished, &screenshot, &ScreenshotController::arrived);
  connect(&structures, &StructuresController::opened, &screenshot,
          [this] { screenshot.arrived(true); });
  connect(&structures, &StructuresController::refused, &screenshot, &ScreenshotController::fail);
  connect(&screenshot, &ScreenshotController::finished, &application_, &Application::finished);
  connect(&window.messages(), &ui::Messages::folderWanted, this, [this](const QString& folder) {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
      window.messages().showMessage(
          Application::tr("No program here shows folders. The file is in \"%1\".").arg(folder));
  });
}

void Application::Parts::wireProgram() {
  connect(&structures, &StructuresController::tissuesWanted, &edit, &EditController::setTissues);
  connect(&edit, &EditController::failed, &structures, &StructuresController::forgetChoice);
  connect(&structures, &StructuresController::fileChanged, &journal,
          &JournalController::setStructures);
  connect(&journal, &JournalController::structuresWanted, &structures, &StructuresController::open);
  connect(&opening, &OpeningController::loading, &log, &LogController::noteLoading);
  connect(&hand, &HandController::changed, &log, &LogController::noteHand);
  connect(&device, &DeviceController::taken, &log, &LogController::noteHand);
  connect(&device, &DeviceController::forceChanged, &log, &LogController::noteForce);
  connect(&device, &DeviceController::forgotten, &log, &LogController::noteServo);
  connect(&recording.recording(), &SessionRecording::statusChanged, &log,
          &LogController::noteRecording);
  connect(&recording.recording(), &SessionRecording::finished, &log, &LogController::noteRecorded);
  using Choices = PreferencesController;
  connect(&preferences, &Choices::stiffnessChosen, &device, &DeviceController::setStiffness);
  const auto chooseRate = [this] { shared.session.chooseRate(preferences.servoRate()); };
  chooseRate();
  connect(&preferences, &Choices::servoRateChosen, this, chooseRate);
  connect(&preferences, &Choices::recordingsChosen, &recording,
          [this](const QString& folder) { recording.setFolder(folder.toStdString()); });
  // the menu has the entries of the edits by now
  window.menus().offerPreferences();
}

void Application::Parts::wireLeaving() {
  using Leave = ViewFileController::Leave;
  window.setCloseGuard([this] {
    const auto leave = view_file.leave(Leaving::Window, [this](bool saved) {
      if (!saved || !settleWriting()) return;
      asked_ = true;
      end();
    });
    asked_ = leave == Leave::Now && settleWriting();
    return asked_;
  });
  connect(&exporting.task(), &ExportTask::finished, this,
          [this](bool well, const QString& what) { endWriting(well ? QString{} : what); });
  connect(&edit, &EditController::saved, this,
          [this](bool, const QString& why) { endWriting(why); });
  connect(&surface, &SurfaceController::written, this,
          [this](bool, const QString& why) { endWriting(why); });
  view_file.setStrokes({.end =
                            [this] {
                              cut.rest(true);
                              return hasStrokes();
                            },
                        .allow = [this] { cut.rest(false); },
                        .whenEdits =
                            [this](std::function<void()> then) {
                              if (!hasStrokes()) return then();
                              after_strokes_ = std::move(then);
                            }});
  opening.setGuard([this](const std::function<void(bool)>& answer) {
    const Leave now = view_file.leave(Leaving::Scan, answer);
    if (now != Leave::AfterSaving) answer(now == Leave::Now);
  });
  connect(&window, &ui::MainWindow::closing, this, [this] {
    journal.close(asked_);
    close();
    preferences.save();
    log.noteServo();
  });
}

}  // namespace app
