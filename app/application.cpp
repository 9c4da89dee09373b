// SPDX-License-Identifier: BSD-3-Clause
#include "app/application.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QPixmap>
#include <array>
#include <cstddef>
#include <cstdio>

#include "app/film/face.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/core/output_file.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/smoothing.h"
#include "resources/named_tools.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/performance_panel.h"
#include "ui/panels/recording_panel.h"
#include "ui/volume_view.h"

namespace app {
namespace {

using haptics::HandKind;

constexpr int kDisplayMs = 16;  // 60 Hz
constexpr int kRestMs = 300;
constexpr const char* kTrilinear = "trilinear";
constexpr const char* kSpline = "spline";
constexpr std::size_t kSamplesAtOnce = 4096;
// A fine mesh of more voxels than this would take seconds to draw where there is no GPU.
constexpr std::int64_t kFineVoxels = 24'000'000;

struct Hand {
  const char* id;
  HandKind kind;
  const char* label;
};
constexpr std::array<Hand, 8> kHands{{
    {"mouse", HandKind::Mouse, QT_TRANSLATE_NOOP("app::Application", "Mouse")},
    {"tap", HandKind::Tap, QT_TRANSLATE_NOOP("app::Application", "Simulated: tap")},
    {"slide", HandKind::Slide, QT_TRANSLATE_NOOP("app::Application", "Simulated: slide")},
    {"wedge", HandKind::Wedge, QT_TRANSLATE_NOOP("app::Application", "Simulated: wedge")},
    {"pry", HandKind::Pry, QT_TRANSLATE_NOOP("app::Application", "Simulated: pry")},
    {"hook", HandKind::Hook, QT_TRANSLATE_NOOP("app::Application", "Simulated: hook")},
    {"jerk", HandKind::Jerk, QT_TRANSLATE_NOOP("app::Application", "Simulated: jerk")},
    {"twist", HandKind::Twist, QT_TRANSLATE_NOOP("app::Application", "Simulated: twist")},
}};

const Hand* handOf(const std::string& name) {
  for (const Hand& hand : kHands)
    if (name == hand.id) return &hand;
  return nullptr;
}

}  // namespace

QString labelOf(const ToolSource& tool) {
  return tool.file ? QString::fromStdString(tool.file->filename().string())
                   : QString::fromStdString(tool.name);
}

std::optional<HandKind> handNamed(const std::string& name) {
  const Hand* hand = handOf(name);
  return hand == nullptr ? std::nullopt : std::optional{hand->kind};
}

Application::Application(Arguments arguments)
    : arguments_(std::move(arguments)),
      preferences_(loadPreferences()),
      loader_(arguments_.free_memory),
      hand_(arguments_.hand),
      watch_(arguments_.devices),
      recordings_(arguments_.recordings),
      recording_(session_, recordings_, identity_),
      samples_(kSamplesAtOnce),
      points_(kSamplesAtOnce) {
  settings_.stiffness = preferences_.stiffness;
  QList<ui::Choice> hands, tools;
  for (const Hand& hand : kHands) hands.append({hand.id, tr(hand.label)});
  for (const std::string& tool : resources::namedTools())
    tools.append({QString::fromStdString(tool), QString::fromStdString(tool)});
  QStringList phantoms;
  for (const std::string& name : datasets::phantomNames())
    phantoms.append(QString::fromStdString(name));
  window_.devicePanel().setHands(hands);
  window_.devicePanel().setTools(tools);
  window_.devicePanel().showStiffness(settings_.stiffness);
  window_.devicePanel().setFields({{kTrilinear, tr("As scanned")}, {kSpline, tr("Smoothed")}});
  window_.setPhantoms(phantoms);
  window_.view().setSurfaceWish(arguments_.surface);
  connectWindow();
  connectOpening();
  connectLoader();
  connectChoosing();
  connectMeasurement();
  connectRecording();
  connectExport();
  connectDevices();
  display_.setInterval(kDisplayMs);
  display_.setTimerType(Qt::PreciseTimer);
  connect(&display_, &QTimer::timeout, this, &Application::refresh);
}

Application::~Application() {
  // a window that goes says so, to what has gone before it
  window_.disconnect(this);
  window_.view().disconnect(this);
  window_.hapticDevicePanel().disconnect(this);
  display_.stop();
  measurement_.cancel();
  replay_.reset();
  session_.close();
  recording_.end();
}

void Application::start() {
  if (!preferences_.geometry.isEmpty() && arguments_.screenshot.empty()) {
    window_.restoreGeometry(preferences_.geometry);
    window_.restoreState(preferences_.layout);
  }
  window_.show();
  display_.start();
  LoadRequest request = arguments_.load;
  if (!request.path && !request.phantom) request.phantom = "demo";
  load(std::move(request), tr("Loading"));
  offerRecovery();
  if (arguments_.notice && !preferences_.notice_seen) {
    window_.showNotice();
    preferences_.notice_seen = true;
    remember();
  }
}

void Application::connectWindow() {
  ui::DevicePanel& device = window_.devicePanel();
  connect(&window_, &ui::MainWindow::phantomWanted, this,
          [this](const QString& name) { load({.phantom = name.toStdString()}, tr("Making")); });
  connect(&window_, &ui::MainWindow::cancelWanted, this, [this] {
    loader_.cancel();
    export_.cancel();
  });
  connect(&window_, &ui::MainWindow::isovalueChanged, this, [this](double isovalue) {
    settings_.isovalue = isovalue;
    session_.set(settings_);
    field_rest_.start();
  });
  connect(&window_, &ui::MainWindow::forceOffWanted, this, [this] { session_.forceOff(); });
  connect(&window_, &ui::MainWindow::forceOnWanted, this, [this] { session_.arm(); });
  connect(&window_, &ui::MainWindow::closing, this, [this] {
    endMeasuring({});
    replay_.reset();
    session_.close();
    recording_.end();
    remember();
  });
  connect(&window_.view(), &ui::VolumeView::handPulled, this,
          [this](const haptics::Pose& X_WH) { session_.pull(X_WH); });
  connect(&window_.view(), &ui::VolumeView::fineMeshWanted, this, &Application::makeFineMesh);
  connect(&device, &ui::DevicePanel::handChosen, this, [this](const QString& id) {
    const std::string name = id.toStdString();
    if (!replay_) return void(openHand(name));
    hand_ = name;
    closeReplay();
  });
  connect(&device, &ui::DevicePanel::toolChosen, this,
          [this](const QString& id) { changeTool({.name = id.toStdString()}); });
  connect(&device, &ui::DevicePanel::toolFileChosen, this,
          [this](const QString& path, const QString& unit) {
            changeTool({.name = path.toStdString(),
                        .file = std::filesystem::path(path.toStdString()),
                        .unit = unit.toStdString()});
          });
  connect(&device, &ui::DevicePanel::stiffnessChanged, this, [this](double stiffness) {
    settings_.stiffness = stiffness;
    session_.set(settings_);
  });
  connect(&device, &ui::DevicePanel::frictionChanged, this, [this](double coefficient) {
    settings_.friction = coefficient;
    session_.set(settings_);
  });
  connect(&device, &ui::DevicePanel::fieldChosen, this, &Application::changeField);
  field_rest_.setSingleShot(true);
  field_rest_.setInterval(kRestMs);
  connect(&field_rest_, &QTimer::timeout, this, &Application::showField);
}

void Application::connectLoader() {
  connect(&loader_, &Loader::progressed, &window_, &ui::MainWindow::showProgress);
  connect(&loader_, &Loader::loaded, this, &Application::adopt);
  connect(&loader_, &Loader::failed, this, &Application::onFailed);
}

void Application::load(LoadRequest request, const QString& what) {
  window_.clearMessage();
  window_.showLoading(what);
  // loading would disturb it, and end it anyway
  endMeasuring(tr("The measurement was cancelled: something else is being loaded."));
  window_.performancePanel().setReady(false);
  if (!request.keep) closeBrowser();
  request.options = options_;
  if (shown_) request.previous = shown_->scene;
  loader_.start(std::move(request));
}

void Application::adopt(const Loaded& loaded) {
  const bool new_volume = !shown_ || shown_->picture.volume != loaded.picture.volume;
  // whether the last snapshot is of the scene that is about to go
  const bool placed = shown_ && snapshot_.scene == shown_->scene->id;
  shown_ = loaded;
  window_.endLoading();
  if (new_volume) keepPlace(loaded.place);
  ui::PerformancePanel& performance = window_.performancePanel();
  performance.showNothing({});  // what was measured was another scene
  QList<ui::LeftOut> left_out;
  for (const haptics::PlanLine& line : loaded.scene->planned)
    if (line.left_out)
      left_out.push_back({QString::fromStdString(line.what), QString::fromStdString(line.why)});
  performance.showLeftOut(left_out);
  performance.setReady(true);
  if (!loaded.note.isEmpty()) window_.showMessage(loaded.note);
  // with another tool the isovalue is the slider's, which may have moved meanwhile
  if (new_volume) settings_.isovalue = loaded.isovalue;
  // a simulated hand aims at its scene, so a new one needs a new hand; what the user holds goes on
  recording_.describe(loaded.scene, loaded.tool.file ? std::string{} : loaded.tool.name);
  const bool mouse = handNamed(hand_) == HandKind::Mouse;
  const bool live = session_.isOpen() && (mouse || connected_);
  if (!live) {
    session_.close();
    session_.set(settings_);
    session_.adopt(loaded.scene, loaded.start);
  } else {
    std::optional<haptics::Pose> start;
    if (!new_volume && placed)
      start = haptics::legalPoseNear(*loaded.scene, settings_.isovalue, snapshot_.X_WP);
    // the hand comes along where the tool starts elsewhere
    if (!start && mouse) {
      session_.pull(loaded.start);
      window_.view().setMouseHand(true);
    }
    session_.adopt(loaded.scene, start.value_or(loaded.start));
    // not before the scene: in the old volume this isovalue may make everything solid
    session_.set(settings_);
  }
  if (new_volume) window_.show(loaded.picture, settings_.isovalue, loaded.title);
  window_.show(loaded.scene->tool.mesh);
  const QString label = labelOf(loaded.tool);
  window_.devicePanel().showTool(QString::fromStdString(loaded.tool.name), label);
  showField();
  window_.recordingPanel().setReady(!replay_);
  // where a simulated hand finds nothing to aim at, the mouse may
  if (replay_) {
    replayed_scene_.reset();
    identity_.seek(loaded.picture.volume);
    showReplayed(replayed_to_);
  } else if (!live && !openHand(hand_) && handNamed(hand_) != HandKind::Mouse)
    openHand("mouse");
  if (!arguments_.screenshot.empty() && new_volume)
    QTimer::singleShot(static_cast<int>(arguments_.screenshot_after * 1000.0), this,
                       &Application::takeScreenshot);
  emit adopted();
}

void Application::onFailed(const LoadRequest& request, const haptics::Error& error) {
  window_.endLoading();
  if (shown_) {
    options_.field = shown_->scene->field.kind();
    showField();
    window_.performancePanel().setReady(true);
    window_.devicePanel().showTool(QString::fromStdString(shown_->tool.name),
                                   labelOf(shown_->tool));
  }
  const QString why = QString::fromStdString(error.what);
  if (arguments_.screenshot.empty()) {
    if (error.reason == kWhichSeries) return browseSeries();
    if (error.kind == haptics::Error::Kind::Correctable) return offerCorrection(request, why);
    if (error.reason == kMissingSlices && offerLargestPart(request)) return;
    if (error.reason == kTooLarge && offerPart(request, why)) return;
  }
  if (error.kind != haptics::Error::Kind::Cancelled) window_.showMessage(why);
  if (!arguments_.screenshot.empty()) {
    std::fprintf(stderr, "%s\n", error.what.c_str());
    emit finished(3);
  }
}

bool Application::openHand(const std::string& name) {
  const Hand* hand = handOf(name);
  if (hand == nullptr) return false;
  const auto opened = session_.open(hand->kind);
  if (!opened) {
    window_.showMessage(QString::fromStdString(opened.error().what));
    window_.devicePanel().showHand(QString::fromStdString(hand_), hand_label_);
    return false;
  }
  forgetDevice(tr("Another hand was chosen: the device was disconnected."));
  showHand(name, tr(hand->label), hand->kind == HandKind::Mouse);
  // a simulated hand aims where it likes: show where
  look_from_tool_ = hand->kind != HandKind::Mouse;
  return true;
}

void Application::showHand(const std::string& id, const QString& label, bool is_mouse) {
  endMeasuring(tr("The measurement was cancelled: another hand took the device."));
  snapshot_ = {};  // of the new loop nothing is known yet, and its counts begin at zero
  window_.view().setMouseHand(is_mouse);
  hand_ = id;
  hand_label_ = label;
  // which of several is nobody's business: a device's own name may tell whose it is
  recording_.note("hand", QString::fromStdString(id.substr(0, id.find(':'))));
  window_.showHandInUse(QString::fromStdString(id), label);
}

void Application::changeTool(const ToolSource& tool) {
  if (!shown_) return;
  load({.keep = kept(), .tool = tool, .isovalue = settings_.isovalue}, tr("Preparing the tool"));
}

void Application::changeField(const QString& id) {
  options_.field = id == kSpline ? haptics::FieldKind::CubicSpline : haptics::FieldKind::Trilinear;
  if (!shown_) return;
  load({.keep = kept(), .tool = shown_->tool, .isovalue = settings_.isovalue},
       tr("Preparing the field"));
}

Kept Application::kept() const { return {shown_->picture, shown_->title, shown_->place}; }

void Application::showField() {
  if (!shown_) return;
  if (shown_->scene->field.kind() == haptics::FieldKind::Trilinear)
    return window_.devicePanel().showField(kTrilinear, {});
  const haptics::SmoothingEffect effect =
      haptics::smoothingEffect(*shown_->picture.volume, settings_.isovalue);
  window_.devicePanel().showField(
      kSpline, tr("Smoothing erases %1 % of this solid and adds %2 %: what is felt is not all that "
                  "is seen.")
                   .arg(effect.erased * 100.0, 0, 'f', 1)
                   .arg(effect.gained * 100.0, 0, 'f', 1));
}

void Application::refresh() {
  session_.collectGarbage();
  recording_.refresh();
  noteCamera();
  while (const std::size_t count = session_.forces(samples_)) {
    for (std::size_t i = 0; i < count; ++i)
      points_[i] = {samples_[i].time, static_cast<float>(samples_[i].force),
                    static_cast<float>(samples_[i].torque)};
    window_.appendForces(std::span{points_}.first(count));
    if (count < samples_.size()) break;
  }
  tellOfForce();
  // poses of the old scene would mislead in the new one
  if (!session_.latest(snapshot_) || !shown_) return;
  if (snapshot_.scene != shown_->scene->id) return window_.displayForce(snapshot_);
  window_.display(snapshot_);
  if (look_from_tool_) {
    look_from_tool_ = false;
    window_.view().lookFromTool();
  }
}

void Application::makeFineMesh(double isovalue) {
  if (!shown_) return;
  mesh_next_ = isovalue;
  if (mesher_.isRunning()) return;
  mesh_next_.reset();
  mesher_.start(
      [isovalue, volume = shown_->picture.volume, mirrored = shown_->picture.mirrored()](
          const background::Watch&) -> haptics::Expected<vtkSmartPointer<vtkPolyData>> {
        const auto image = volume->grid.voxelCount() <= kFineVoxels
                               ? ui::imageOf(*volume)
                               : ui::reducedImageOf(*volume, kFineVoxels);
        return ui::isosurfaceMesh(image, isovalue, mirrored);
      },
      [this, isovalue, volume = shown_->picture.volume](
          const haptics::Expected<vtkSmartPointer<vtkPolyData>>& mesh) {
        // without one the reduced mesh stays
        const bool same = shown_ && shown_->picture.volume == volume;
        if (same && mesh && *mesh) window_.view().showFine(*mesh, isovalue);
        if (mesh_next_ && !(same && *mesh_next_ == isovalue)) makeFineMesh(*mesh_next_);
      });
}

void Application::takeScreenshot() {
  if (shown_ && !shown_->place.empty() && mayShowAFace(*shown_->picture.volume, settings_.isovalue))
    std::fprintf(stderr,
                 "At this isovalue skin is drawn, and a face can tell who the patient is: look at "
                 "the picture before you pass it on.\n");
  QBuffer picture;
  const QString ending = QFileInfo(QString::fromStdString(arguments_.screenshot)).suffix();
  const bool drawn = window_.grab().save(&picture, ending.isEmpty() ? "PNG" : qPrintable(ending));
  const bool saved =
      drawn && haptics::writeFile(arguments_.screenshot,
                                  {picture.data().constData(), std::size_t(picture.data().size())});
  if (!saved) std::fprintf(stderr, "The picture could not be written.\n");
  emit finished(saved ? 0 : 4);
}

void Application::remember() {
  preferences_.geometry = window_.saveGeometry();
  preferences_.layout = window_.saveState();
  preferences_.stiffness = own_stiffness_.value_or(settings_.stiffness);
  preferences_.mapping = mapping_;
  if (arguments_.screenshot.empty()) savePreferences(preferences_);
}

}  // namespace app
