// SPDX-License-Identifier: BSD-3-Clause
#include "app/application.h"

#include <QDesktopServices>
#include <QUrl>
#include <utility>

#include "ui/volume_view.h"

namespace app {

Application::Application(Arguments arguments)
    : arguments_(std::move(arguments)),
      preferences_(window_, arguments_.screenshot.empty()),
      recordings_(arguments_.recordings.empty()
                      ? std::filesystem::path(preferences_.present().recordings.toStdString())
                      : arguments_.recordings),
      opening_(window_, shared_, preferences_, arguments_.free_memory,
               arguments_.screenshot.empty()),
      hand_(window_, shared_, arguments_.hand, preferences_.firstStiffness()),
      device_(window_, shared_, preferences_, arguments_.devices),
      recording_(window_, shared_, recordings_, identity_),
      replay_(window_, shared_, identity_),
      export_(window_, shared_, recordings_, identity_),
      screenshot_(window_, shared_, arguments_.screenshot, arguments_.screenshot_after) {
  window_.view().setSurfaceWish(arguments_.surface);
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
  connect(&window_, &ui::MainWindow::folderWanted, this, [this](const QString& folder) {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
      window_.showMessage(tr("No program here shows folders. The file is in \"%1\".").arg(folder));
  });
  connect(&window_, &ui::MainWindow::closing, this, [this] {
    close();
    preferences_.save();
  });
}

Application::~Application() {
  // a window that goes says so, to what has gone before it
  window_.disconnect(this);
  picture_.stop();
  close();
}

void Application::end() {
  window_.setCloseGuard({});
  window_.close();
}

void Application::start() {
  preferences_.restoreWindow();
  // nothing moves behind a notice that was not read yet
  const bool notice = arguments_.notice && !preferences_.present().notice_seen;
  if (!notice) begin();  // beside it the window is shown
  window_.show();
  picture_.start();
  if (notice) {
    preferences_.showNotice();
    if (!window_.isVisible()) return;  // closed meanwhile
    begin();
  }
  recording_.offerRecovery();
  if (arguments_.screenshot.empty()) crash_.look();
}

void Application::begin() {
  LoadRequest request = arguments_.load;
  arguments_.load.ahead.reset();  // what is not taken does not stay in memory
  if (!arguments_.paths.isEmpty()) return opening_.openTogether(arguments_.paths, request);
  if (request.path && request.path->extension() == kViewEnding)
    return view_file_.open(*request.path);  // a view may know its scan
  if (request.path || request.phantom) return opening_.load(std::move(request), tr("Loading"));
  start_.drawLastScans();
  screenshot_.prepare(true);
}

void Application::wireOpening() {
  using Opening = OpeningController;
  connect(&tool_, &ToolController::wanted, &opening_, &Opening::load);
  connect(&opening_, &Opening::loading, &measurement_, &MeasurementController::pause);
  // in this order: a recording knows a scene before the session has it
  connect(&opening_, &Opening::loaded, &measurement_, &MeasurementController::showScene);
  connect(&opening_, &Opening::loaded, &recording_, &RecordingController::describeScene);
  connect(&opening_, &Opening::loaded, &hand_, &HandController::adopt);
  // in this order: a view that is opened finds the panel of its scan, and a hand that cannot be
  // opened has the last word
  connect(&opening_, &Opening::shown, &isosurface_, &IsosurfaceController::showScene);
  connect(&opening_, &Opening::shown, &tool_, &ToolController::show);
  connect(&opening_, &Opening::shown, &recording_,
          [this] { recording_.setReady(!shared_.replaying); });
  connect(&opening_, &Opening::shown, &replay_, &ReplayController::showScene);
  connect(&opening_, &Opening::shown, &edit_, &EditController::showScene);
  connect(&opening_, &Opening::shown, &hand_, &HandController::resume);
  connect(&opening_, &Opening::shown, &device_, &DeviceController::openWaiting);
  connect(&opening_, &Opening::shown, &screenshot_, &ScreenshotController::prepare);
  connect(&opening_, &Opening::shown, this, &Application::adopted);
  connect(&opening_, &Opening::failed, &tool_, &ToolController::show);
  connect(&opening_, &Opening::failed, &measurement_, &MeasurementController::resume);
  connect(&opening_, &Opening::failed, &screenshot_, &ScreenshotController::fail);
  connect(&screenshot_, &ScreenshotController::finished, this, &Application::finished);
  connect(&pacs_, &PacsController::openWanted, &opening_,
          [this](const QString& folder, const QString& name) {
            opening_.open(folder, {.name = name});
          });
}

void Application::wireStart() {
  connect(&opening_, &OpeningController::loading, &start_, &StartController::stopDrawing);
  connect(&opening_, &OpeningController::failed, &start_, &StartController::drawLastScans);
  if (arguments_.notice)
    connect(&opening_, &OpeningController::shown, &start_, &StartController::offerTour);
}

void Application::wireIsosurface() {
  using Isosurface = IsosurfaceController;
  connect(&isosurface_, &Isosurface::changed, &tool_, &ToolController::showFieldSoon);
  connect(&isosurface_, &Isosurface::changed, &marks_.measures(), &ui::Measures::surfaceChanged);
  connect(&isosurface_, &Isosurface::changed, &edit_, &EditController::endPreview);
  connect(&replay_, &ReplayController::isovalueShown, &isosurface_, &Isosurface::show);
  connect(&view_file_, &ViewFileController::isovalueWanted, &isosurface_, &Isosurface::set);
}

void Application::wireHands() {
  connect(&hand_, &HandController::opened, &device_,
          [this] { device_.forget(tr("Another hand was chosen: the device was disconnected.")); });
  connect(&hand_, &HandController::changed, this, [this](const QString& id) {
    measurement_.end(tr("The measurement was cancelled: another hand took the device."));
    // which of several is nobody's business: a device's own name may tell whose it is
    noteHand(id);
  });
  connect(&view_, &ViewController::toolPlaced, &hand_, &HandController::bring);
  connect(&hand_, &HandController::lookWanted, &picture_, &PictureController::look);
  connect(&hand_, &HandController::replayEndWanted, &replay_, &ReplayController::close);
  connect(&device_, &DeviceController::taking, &replay_, &ReplayController::close);
  connect(&device_, &DeviceController::taken, &hand_, &HandController::takeDevice);
  connect(&device_, &DeviceController::forgotten, &hand_, &HandController::forgetDevice);
  connect(&device_, &DeviceController::released, &hand_, &HandController::reopen);
  connect(&device_, &DeviceController::stiffnessWanted, &hand_, &HandController::setStiffness);
  connect(&device_, &DeviceController::forceChanged, &recording_,
          [this](const QString& transition) { recording_.note("force", transition); });
  connect(&picture_, &PictureController::refreshing, &recording_, &RecordingController::refresh);
  connect(&picture_, &PictureController::refreshing, &device_, &DeviceController::refresh);
  connect(&picture_, &PictureController::snapshotTaken, &device_, &DeviceController::showForce);
}

void Application::noteHand(const QString& id) {
  // what follows tells one device from others of its kind, and is nobody's business
  recording_.note("hand", id.section(':', 0, 0));
}

void Application::wireRecordings() {
  connect(&opening_, &OpeningController::recordingWanted, &replay_, &ReplayController::open);
  connect(&recording_, &RecordingController::openWanted, &replay_, &ReplayController::open);
  connect(&recording_, &RecordingController::exportWanted, &export_,
          &ExportController::exportRecording);
  connect(&recording_, &RecordingController::deleting, &replay_, &ReplayController::closeFile);
  connect(&recording_, &RecordingController::starting, &replay_, &ReplayController::close);
  connect(&recording_, &RecordingController::started, this,
          [this] { noteHand(QString::fromStdString(hand_.name())); });
  connect(&replay_, &ReplayController::forcesCleared, &picture_, &PictureController::clearForces);
  connect(&replay_, &ReplayController::forcesAppended, &picture_, &PictureController::appendForces);
  connect(&replay_, &ReplayController::opened, this, [this] {
    recording_.recording().stop();
    measurement_.end(tr("The measurement was cancelled: a recording is being replayed."));
    // the hand lets go: what is seen is what was
    shared_.session.close();
    device_.forget(tr("A recording was opened: the device was disconnected."));
    recording_.setReady(false);
  });
  connect(&replay_, &ReplayController::closed, this, [this] {
    recording_.setReady(shared_.shown.has_value());
    hand_.reopen();
  });
}

void Application::wireEdits() {
  connect(&edit_, &EditController::edited, &opening_, &OpeningController::replace);
  connect(&edit_, &EditController::pictured, &opening_, &OpeningController::replacePicture);
  connect(&opening_, &OpeningController::pictureReplaced, &isosurface_,
          [this] { isosurface_.showScene(false); });
  connect(&edit_, &EditController::noted, &recording_,
          [this](const QString& what) { recording_.note("edit", what); });
  connect(&picture_, &PictureController::refreshing, &edit_, &EditController::refresh);
  connect(&replay_, &ReplayController::opened, &edit_, [this] { edit_.setReplaying(true); });
  connect(&replay_, &ReplayController::closed, &edit_, [this] { edit_.setReplaying(false); });
}

void Application::wireMarks() {
  // in this order: the marks of a view come after those of the scan before are gone
  connect(&opening_, &OpeningController::shown, &marks_, &MarksController::showScene);
  connect(&opening_, &OpeningController::shown, &view_file_, &ViewFileController::showScene);
  connect(&opening_, &OpeningController::failed, &view_file_, [this](const haptics::Error& error) {
    // where the user has a choice, the scan may still come
    for (const char* asked : {kWhichSeries, kTooLarge, kMissingSlices})
      if (error.reason == asked) return;
    view_file_.drop();
  });
  connect(&opening_, &OpeningController::viewWanted, &view_file_, &ViewFileController::open);
  connect(&picture_, &PictureController::refreshing, &marks_, &MarksController::refresh);
  connect(&view_file_, &ViewFileController::scanWanted, &opening_,
          [this](const std::filesystem::path& path) {
            opening_.open(QString::fromStdString(path.string()));
          });
  connect(&view_file_, &ViewFileController::editsWanted, &edit_, &EditController::restore);
  connect(&view_file_, &ViewFileController::toolWanted, &tool_,
          [this](const QString& name) { tool_.changeTool({.name = name.toStdString()}); });
}

void Application::wireLeaving() {
  using Leave = ViewFileController::Leave;
  window_.setCloseGuard([this] {
    return view_file_.leave(Leaving::Window, [this](bool saved) {
      if (saved) end();
    }) == Leave::Now;
  });
  opening_.setGuard([this](const std::function<void(bool)>& answer) {
    const Leave now = view_file_.leave(Leaving::Scan, answer);
    if (now != Leave::AfterSaving) answer(now == Leave::Now);
  });
}

void Application::wireLog() {
  connect(&opening_, &OpeningController::loading, &log_, &LogController::noteLoading);
  connect(&opening_, &OpeningController::shown, &log_, &LogController::noteScene);
  connect(&opening_, &OpeningController::failed, &log_, &LogController::noteRefusal);
  connect(&hand_, &HandController::changed, &log_, &LogController::noteHand);
  connect(&device_, &DeviceController::taken, &log_, &LogController::noteHand);
  connect(&device_, &DeviceController::forceChanged, &log_, &LogController::noteForce);
  connect(&device_, &DeviceController::forgotten, &log_, &LogController::noteServo);
  connect(&recording_.recording(), &SessionRecording::statusChanged, &log_,
          &LogController::noteRecording);
  connect(&recording_.recording(), &SessionRecording::finished, &log_,
          &LogController::noteRecorded);
  connect(&window_, &ui::MainWindow::closing, &log_, &LogController::noteServo);
}

void Application::wirePreferences() {
  using Choices = PreferencesController;
  connect(&preferences_, &Choices::stiffnessChosen, &device_, &DeviceController::setStiffness);
  const auto chooseRate = [this] { shared_.session.chooseRate(preferences_.servoRate()); };
  chooseRate();
  connect(&preferences_, &Choices::servoRateChosen, this, chooseRate);
  connect(&preferences_, &Choices::recordingsChosen, &recording_, [this](const QString& folder) {
    recordings_.setFolder(folder.toStdString());
    recording_.showRecordings();
  });
  // the menu has the entries of the edits by now
  window_.offerPreferences();
}

void Application::close() {
  measurement_.end({});
  replay_.drop();
  shared_.session.close();
  recording_.recording().end();
}

}  // namespace app
