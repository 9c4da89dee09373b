// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/edit_controller.h"

#include <QLocale>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "app/window/edited_volume.h"
#include "app/window/sentence.h"
#include "app/window/start_pose.h"
#include "haptics/edit/edited.h"
#include "haptics/scene/legal_pose.h"
#include "ui/escape_filter.h"
#include "ui/volume_view.h"

namespace app {
namespace {

using haptics::Edit;
using ui::EditTool;
using ui::kMmPerM;

constexpr int kUntouchedMs = 100;
constexpr double kCm3PerM3 = 1e6;
constexpr double kAligned = 1.0 - 1e-6;  // cosine between an axis of the grid and one of W
constexpr double kAnyIntensity = std::numeric_limits<double>::infinity();
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::array<const char*, 3> kLowLetters{"R", "A", "I"}, kHighLetters{"L", "P", "S"};

/// Three significant figures, and cm³.
QString cm3Of(double volume) {
  const double cm3 = volume * kCm3PerM3;
  const double magnitude = cm3 > 0.0 ? std::floor(std::log10(cm3)) : 0.0;
  const int decimals = std::clamp(2 - static_cast<int>(magnitude), 0, 6);
  return EditController::tr("%1 cm³").arg(QLocale().toString(cm3, 'f', decimals));
}

/// How the edges of voxels along an axis of the grid are told in mm: in W if the axis is one of
/// W's, else along the grid from its outer face.
struct AxisNumbers {
  int letters = -1;  ///< axis of W; below 0: none
  double at_first_mm = 0.0, per_voxel_mm = 1.0;

  double mmOf(std::int64_t edge) const {
    return at_first_mm + per_voxel_mm * static_cast<double>(edge);
  }
  std::int64_t edgeAt(double mm) const { return std::llround((mm - at_first_mm) / per_voxel_mm); }
};

AxisNumbers numbersOf(const haptics::Volume& volume, int axis) {
  const haptics::Grid& grid = volume.grid;
  AxisNumbers numbers{.per_voxel_mm = grid.spacing[axis] * kMmPerM};
  if (!volume.orientation_known) return numbers;
  int along = 0;
  grid.direction.col(axis).cwiseAbs().maxCoeff(&along);
  const double cosine = grid.direction(along, axis);
  if (std::abs(cosine) < kAligned) return numbers;
  numbers.letters = along;
  numbers.per_voxel_mm *= cosine > 0.0 ? 1.0 : -1.0;
  haptics::Vec3 edge = haptics::Vec3::Zero();
  edge[axis] = -0.5;
  numbers.at_first_mm = grid.worldOf(edge)[along] * kMmPerM;
  return numbers;
}

/// The voxels of these runs that reach `least`.
std::shared_ptr<const ui::MarkedVoxels> marked(const haptics::Volume& volume,
                                               const haptics::Removal& removal, double least) {
  auto voxels = std::make_shared<ui::MarkedVoxels>(volume.grid);
  const auto& dims = volume.grid.dims;
  haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* first) {
    for (const haptics::VoxelRun& run : removal.runs) {
      const auto* row = first + (run.k * dims[1] + run.j) * dims[0];
      for (std::int64_t i = run.i; i < run.i + run.count; ++i)
        if (static_cast<double>(row[i]) >= least) voxels->add(i, run.j, run.k, 1);
    }
  });
  voxels->finish();
  return voxels;
}

bool lettersApply(const haptics::Volume& volume) {
  return numbersOf(volume, 0).letters >= 0 && numbersOf(volume, 1).letters >= 0 &&
         numbersOf(volume, 2).letters >= 0;
}

}  // namespace

EditController::EditController(ui::MainWindow& window, SharedState& shared)
    : window_(window),
      shared_(shared),
      panel_(new ui::EditPanel),
      // with its words: a load that ended meanwhile has put the bar away
      task_([&window](double fraction) {
        window.showLoading(tr("Editing"));
        window.showProgress(fraction);
      }),
      saver_([&window](double fraction) {
        window.showLoading(tr("Saving"));
        window.showProgress(fraction);
      }) {
  window.addPanel(panel_, tr("In the way"), tr("In the &way"), "editSection", ui::Tab::Scan);
  for (ui::Overlay* overlay :
       std::initializer_list<ui::Overlay*>{&shade_, &plane_, &crop_, &pick_, &lasso_})
    window.addOverlay(*overlay);
  buildMenu();
  connectPanel();
  connectOverlays();
  connect(&window, &ui::MainWindow::cancelWanted, this, [this] {
    cancelWait();
    task_.cancel();
    saver_.cancel();
  });
  connect(&window, &ui::MainWindow::saveEditedWanted, this, &EditController::save);
  // Escape is force off above all, and ends what the mouse is busy with
  connect(new ui::EscapeFilter(this), &ui::EscapeFilter::pressed, this, &EditController::endTool);
  untouched_.start();
}

void EditController::buildMenu() {
  QMenu& menu = window_.editMenu();
  undo_ = menu.addAction(tr("&Undo"), this, [this] { want({Step::Undo}); });
  undo_->setObjectName("undo");
  undo_->setShortcut(QKeySequence(tr("Ctrl+Z")));
  redo_ = menu.addAction(tr("&Redo"), this, [this] { want({Step::Redo}); });
  redo_->setObjectName("redo");
  redo_->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  reset_ = menu.addAction(tr("Take &all edits back"), this, [this] { want({Step::Reset}); });
  reset_->setObjectName("reset");
  window_.bar().add(ui::BarGroup::File, *undo_, "undo");
  window_.bar().add(ui::BarGroup::File, *redo_, "redo");
  menu.addSeparator();
  addTool(tr("&Crop box"), EditTool::Crop);
  addTool(tr("Clip &plane"), EditTool::Plane);
  addTool(tr("P&ieces"), EditTool::Pieces);
  addTool(tr("Table and &holder"), EditTool::Holder);
  addTool(tr("&Scalpel"), EditTool::Scalpel);
}

void EditController::addTool(const QString& text, EditTool tool) {
  QAction* action = window_.editMenu().addAction(text, this, [this, tool] {
    window_.reveal(panel_);
    panel_->setTool(tool);
    panel_->setFocus();
  });
  if (tool != EditTool::Crop) return;
  action->setObjectName("cropBox");
  window_.bar().add(ui::BarGroup::Tools, *action, "crop");
}

void EditController::connectPanel() {
  using Panel = ui::EditPanel;
  connect(panel_, &Panel::toolChosen, this, &EditController::changeTool);
  connect(panel_, &Panel::cropNumberChanged, this, &EditController::moveCropFace);
  connect(panel_, &Panel::cropToViewWanted, this, &EditController::cropToView);
  connect(panel_, &Panel::cropResetWanted, this, [this] {
    if (!scan_) return;
    crop_.show(scan_->grid, {{}, scan_->grid.dims});
    applyCrop();
  });
  connect(panel_, &Panel::cropApplyWanted, this, &EditController::applyCrop);
  connect(panel_, &Panel::planeFromSliceWanted, this, &EditController::placePlane);
  connect(panel_, &Panel::planeAgainWanted, this, [this] { changeTool(EditTool::Plane); });
  connect(panel_, &Panel::planeFlipWanted, this, [this] {
    plane_.place(plane_.point_mm(), -plane_.normal());
    showPlane();
  });
  connect(panel_, &Panel::planeNumbersChanged, this, &EditController::turnPlane);
  connect(panel_, &Panel::planeApplyWanted, this, &EditController::cutPlane);
  connect(panel_, &Panel::smallWanted, this, [this](double least_cm3) {
    preview(haptics::RemoveSmallPieces{.isovalue = shared_.settings.isovalue,
                                       .least_volume = least_cm3 / kCm3PerM3},
            ui::EditConfirm::Removal,
            tr("All pieces smaller than %1: together %2.").arg(cm3Of(least_cm3 / kCm3PerM3)));
  });
  connect(panel_, &Panel::holderWanted, this, [this] {
    preview(haptics::RemoveHolder{.isovalue = shared_.settings.isovalue}, ui::EditConfirm::Removal,
            tr("Table and holder: %1 would go."));
  });
  connect(panel_, &Panel::keepPieceWanted, this, [this] { confirmPiece(true); });
  connect(panel_, &Panel::removePieceWanted, this, [this] { confirmPiece(false); });
  connect(panel_, &Panel::removalWanted, this, [this] {
    if (previewed_) apply(*previewed_);
  });
  connect(panel_, &Panel::previewCancelled, this, &EditController::endPreview);
  connect(panel_, &Panel::undoWanted, this, [this] { want({Step::Undo}); });
  connect(panel_, &Panel::redoWanted, this, [this] { want({Step::Redo}); });
  connect(panel_, &Panel::resetWanted, this, [this] { want({Step::Reset}); });
  connect(panel_, &Panel::waitCancelled, this, &EditController::cancelWait);
}

void EditController::connectOverlays() {
  connect(&crop_, &ui::CropBox::moved, this, &EditController::showCrop);
  connect(&crop_, &ui::CropBox::released, this, &EditController::applyCrop);
  connect(&plane_, &ui::ClipPlane::moved, this, &EditController::showPlane);
  connect(&plane_, &ui::ClipPlane::refused, this, [this](const QString& why) {
    showPlane();
    window_.showMessage(why);
  });
  connect(&lasso_, &ui::Lasso::drawn, this, &EditController::cutOutline);
  connect(&pick_, &ui::PlacePick::picked, this, [this](const Eigen::Vector3d& place_W_mm) {
    preview(haptics::RemovePiece{place_W_mm / kMmPerM, shared_.settings.isovalue},
            ui::EditConfirm::Piece, tr("This piece: %1."));
  });
}

void EditController::showScene() {
  if (!shared_.shown) return;
  const auto scan = scanOf(shared_.shown->volume());
  if (scan != scan_) {
    // another volume: what was meant for the old one is dropped
    if (running_) {
      task_.abandon();
      window_.endLoading();
    }
    painter_.abandon();
    running_.reset();
    held_.reset();
    queue_.clear();
    history_.reset();
    scan_ = scan;
    endWait();
    panel_->setTool(EditTool::None);
  }
  panel_->setReady(!replaying_);
  endPreview();
  showSteps();
  if (crop_.isShown() && !crop_.isHeld() && queue_.empty()) changeTool(EditTool::Crop);
}

void EditController::setReplaying(bool replaying) {
  replaying_ = replaying;
  if (replaying) endTool();
  panel_->setReady(!replaying && shared_.shown.has_value());
  showSteps();
}

std::vector<Edit> EditController::edits() const {
  if (!shared_.shown || !shared_.shown->volume()->edited) return {};
  return shared_.shown->volume()->edited->edits;
}

void EditController::restore(std::vector<Edit> edits) { want({Step::Restore, std::move(edits)}); }

void EditController::apply(Edit edit) {
  endPreview();
  want({Step::Apply, {std::move(edit)}});
}

void EditController::want(Job job) {
  if (!shared_.shown || replaying_) return;
  window_.clearMessage();
  queue_.push_back(std::move(job));
  startNext();
}

bool EditController::raises(const Job& job) const {
  if (job.step != Step::Apply) return true;
  const auto* crop = std::get_if<haptics::Crop>(&job.edits.front());
  if (crop == nullptr) return false;
  const haptics::VoxelBox now = shared_.shown->volume()->bounds();
  for (std::size_t a = 0; a < 3; ++a)
    if (crop->kept.first[a] < now.first[a] || crop->kept.end[a] > now.end[a]) return true;
  return false;
}

bool EditController::touches() const {
  return shared_.snapshot.contacts > 0 || shared_.snapshot.scene != shared_.shown->scene->id;
}

bool EditController::isClear() const {
  // the time alone does not tell: it goes on while a busy window looks at no snapshot
  return !shared_.session.isOpen() || (!touches() && untouched_.elapsed() >= kUntouchedMs);
}

void EditController::refresh() {
  if (!shared_.shown) return;
  if (touches()) untouched_.restart();
  if (held_)
    adopt();
  else
    startNext();
}

void EditController::showWait(Step step) {
  const QString words = step == Step::Undo   ? tr("Undo waits until the tool no longer touches.")
                        : step == Step::Redo ? tr("Redo waits until the tool no longer touches.")
                        : step == Step::Reset
                            ? tr("Taking all edits back waits until the tool no longer touches.")
                            : tr("This edit puts material back, and waits until the tool no "
                                 "longer touches.");
  if (words == wait_shown_) return;
  wait_shown_ = words;
  panel_->showWait(words);
  window_.showLoading(words);
}

void EditController::endWait() {
  wait_shown_.clear();
  panel_->showWait({});
}

void EditController::cancelWait() {
  if (held_) {
    task_.start(
        [history = held_->history, step = running_->step](const Watch&) -> haptics::Expected<Made> {
          rollBack(*history, step);
          return tl::unexpected(haptics::Error{haptics::Error::Kind::Cancelled, {}, "cancelled"});
        },
        [this](haptics::Expected<Made> made) { deliver(std::move(made)); });
    held_.reset();
    endWait();
    return;
  }
  if (running_ || queue_.empty()) return;
  queue_.pop_front();
  endWait();
  window_.endLoading();
}

void EditController::startNext() {
  if (running_ || held_ || queue_.empty() || !shared_.shown) return;
  if (raises(queue_.front()) && !isClear()) return showWait(queue_.front().step);
  endWait();
  running_ = std::move(queue_.front());
  queue_.pop_front();
  start(*running_);
}

void EditController::start(const Job& job) {
  if (!history_) history_ = std::make_shared<haptics::EditHistory>(scan_);
  window_.showLoading(tr("Editing"));
  task_.start(
      [history = history_, job, shown = *shared_.shown, options = shared_.options,
       isovalue = shared_.settings.isovalue](const Watch& watch) {
        return worked(history, job, shown, options, isovalue, watch);
      },
      [this](haptics::Expected<Made> made) { deliver(std::move(made)); });
}

void EditController::rollBack(haptics::EditHistory& history, Step step) {
  if (step == Step::Apply || step == Step::Redo) {
    (void)history.undo();
  } else if (step == Step::Undo) {
    (void)history.redo();
  } else if (step == Step::Reset) {
    while (history.canRedo() && history.redo()) {
    }
  }  // a list of edits had a history of its own
}

haptics::Expected<EditController::Made> EditController::worked(
    std::shared_ptr<haptics::EditHistory> history, const Job& job, const Loaded& shown,
    haptics::SceneOptions options, double isovalue, const Watch& watch) {
  // a list of edits gets a history of its own, so that the present one stays if it fails
  if (job.step == Step::Restore) history = std::make_shared<haptics::EditHistory>(history->scan());
  const haptics::EditWatch edit_watch{.cancel = &watch.cancel,
                                      .advanced = [&](double done) { watch.advanced(0.6 * done); }};
  haptics::Expected<std::shared_ptr<const haptics::Volume>> volume = history->present();
  switch (job.step) {
    case Step::Undo:
      volume = history->undo(edit_watch);
      break;
    case Step::Redo:
      volume = history->redo(edit_watch);
      break;
    case Step::Reset:
      volume = history->reset(edit_watch);
      break;
    case Step::Apply:
    case Step::Restore:
      for (const Edit& edit : job.edits)
        if (volume) volume = history->apply(edit, edit_watch);
      break;
  }
  if (!volume) return tl::unexpected(volume.error());
  Made made;
  made.history = history;
  if (auto ready = built(made, shown, options, isovalue, watch); !ready) {
    rollBack(*history, job.step);
    return tl::unexpected(ready.error());
  }
  return made;
}

haptics::Expected<void> EditController::built(Made& made, const Loaded& shown,
                                              haptics::SceneOptions options, double isovalue,
                                              const Watch& watch) {
  const auto& volume = made.history->present();
  options.field = shown.scene->field.kind();
  auto scene = haptics::makeScene(volume, shown.scene->tool, options, shown.scene.get());
  if (!scene) return tl::unexpected(scene.error());
  made.scene = std::move(*scene);
  made.base = shown.scene;
  watch.advanced(0.9);
  if (auto near = haptics::legalPoseNear(*made.scene, isovalue, shown.start))
    made.start = *near;
  else
    made.start = startPose(*made.scene, isovalue).value_or(shown.start);
  return {};
}

void EditController::deliver(haptics::Expected<Made> made) {
  if (!made) {
    running_.reset();
    window_.endLoading();
    haptics::Error& error = made.error();
    if (error.reason == background::kNoMemory)
      error.message =
          tr("There is not enough memory for this edit; nothing was changed.").toStdString();
    else if (error.reason == background::kThrew)
      error.message = tr("The edit could not be made: %1").arg(sentenceOf(error)).toStdString();
    if (error.kind != haptics::Error::Kind::Cancelled) window_.showMessage(sentenceOf(error));
    showSteps();
    // the box shows what is there
    if (crop_.isShown()) changeTool(EditTool::Crop);
    return startNext();
  }
  held_ = std::move(*made);
  // what puts material back is adopted by refresh(), on what the tool touches then
  if (!raises(*running_)) adopt();
}

void EditController::adopt() {
  if (held_->base != shared_.shown->scene) {
    // another tool or field came meanwhile: the same volume with it
    Made again;
    again.history = held_->history;
    held_.reset();
    task_.start(
        [again, step = running_->step, shown = *shared_.shown, options = shared_.options,
         isovalue = shared_.settings.isovalue](const Watch& watch) -> haptics::Expected<Made> {
          Made made = again;
          if (auto ready = built(made, shown, options, isovalue, watch); !ready) {
            rollBack(*made.history, step);
            return tl::unexpected(ready.error());
          }
          return made;
        },
        [this](haptics::Expected<Made> made) { deliver(std::move(made)); });
    return;
  }
  if (raises(*running_) && !isClear()) return showWait(running_->step);
  const Job job = *std::exchange(running_, std::nullopt);
  Made made = *std::exchange(held_, std::nullopt);
  endWait();
  window_.endLoading();
  history_ = std::move(made.history);
  Loaded loaded = *shared_.shown;
  loaded.scene = std::move(made.scene);
  loaded.start = made.start;
  loaded.note.clear();
  const char* const words[] = {"", "undo", "redo", "reset", "restore"};
  if (job.step == Step::Apply)
    emit noted(QString::fromStdString(haptics::textOf(job.edits.front())));
  else
    emit noted(words[static_cast<int>(job.step)]);
  emit edited(loaded);
  paint();
  startNext();
}

/// The picture follows: the touch does not wait for it.
void EditController::paint() {
  painter_.start(
      [volume = shared_.shown->volume(),
       before = shared_.shown->picture](const Watch& watch) -> haptics::Expected<ui::Picture> {
        const haptics::Edited* edit = haptics::editBetween(volume, before.volume);
        return edit != nullptr ? ui::pictureOf(volume, before, edit->changed)
                               : ui::pictureOf(volume, &watch.cancel);
      },
      [this](const haptics::Expected<ui::Picture>& picture) {
        if (picture) return emit pictured(*picture);
        window_.showMessage(
            tr("The picture of the edited volume could not be made: it shows the volume before the "
               "edit, and is not what is touched. Close other programs and undo the edit."));
      });
}

void EditController::showSteps() {
  const int in_force = static_cast<int>(edits().size());
  // while a job runs, its thread has the history
  const bool idle = history_ && !running_;
  const ui::EditSteps steps{.in_force = in_force,
                            .undo = idle ? history_->canUndo() : in_force > 0,
                            .redo = idle && history_->canRedo()};
  panel_->show(steps);
  undo_->setEnabled(steps.undo && !replaying_);
  redo_->setEnabled(steps.redo && !replaying_);
  reset_->setEnabled(in_force > 0 && !replaying_);
  window_.setEdited(in_force > 0);
}

void EditController::changeTool(EditTool tool) {
  endPreview();
  crop_.hide();
  plane_.hide();
  lasso_.setActive(tool == EditTool::Scalpel);
  pick_.setActive(tool == EditTool::Pieces);
  if (!scan_ || !shared_.shown) return;
  const haptics::VoxelBox bounds = shared_.shown->volume()->bounds();
  if (tool == EditTool::Crop) {
    crop_.show(scan_->grid, bounds);
    showCrop();
  } else if (tool == EditTool::Plane) {
    plane_.begin(scan_->grid, bounds);
    showPlane();
  }
}

void EditController::endTool() {
  cancelWait();
  previewer_.abandon();
  panel_->setTool(EditTool::None);
}

void EditController::showCrop() {
  const haptics::Volume& volume = *shared_.shown->volume();
  const bool letters = lettersApply(volume);
  std::array<ui::CropRange, 3> ranges;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    AxisNumbers numbers = numbersOf(volume, axis);
    if (!letters) numbers = {.per_voxel_mm = volume.grid.spacing[axis] * kMmPerM};
    const auto [least, most] = std::minmax({numbers.mmOf(0), numbers.mmOf(volume.grid.dims[a])});
    const auto [from, to] =
        std::minmax({numbers.mmOf(crop_.box().first[a]), numbers.mmOf(crop_.box().end[a])});
    const QString axis_name(QChar('i' + axis));
    ranges[a] = {
        .low = letters ? kLowLetters[static_cast<std::size_t>(numbers.letters)]
                       : tr("%1 from").arg(axis_name),
        .high = letters ? kHighLetters[static_cast<std::size_t>(numbers.letters)] : tr("to"),
        .negative = letters ? kLowLetters[static_cast<std::size_t>(numbers.letters)] : "",
        .positive = letters ? kHighLetters[static_cast<std::size_t>(numbers.letters)] : "",
        .least = least,
        .most = most,
        .step = std::abs(numbers.per_voxel_mm),
        .from = from,
        .to = to};
  }
  panel_->show(ranges, letters ? tr("Millimetres along the patient's axes, from the scan's origin")
                               : tr("Millimetres along the scan's own axes, from its first voxel"));
}

void EditController::moveCropFace(int axis, bool high, double mm) {
  if (!crop_.isShown()) return;
  const haptics::Volume& volume = *shared_.shown->volume();
  const auto a = static_cast<std::size_t>(axis);
  AxisNumbers numbers = numbersOf(volume, axis);
  if (!lettersApply(volume)) numbers = {.per_voxel_mm = volume.grid.spacing[axis] * kMmPerM};
  haptics::VoxelBox box = crop_.box();
  const bool far_side = high == (numbers.per_voxel_mm > 0.0);
  const std::int64_t edge = numbers.edgeAt(mm);
  if (far_side)
    box.end[a] = std::clamp(edge, box.first[a] + 1, volume.grid.dims[a]);
  else
    box.first[a] = std::clamp<std::int64_t>(edge, 0, box.end[a] - 1);
  crop_.show(volume.grid, box);
  showCrop();
}

void EditController::cropToView() {
  if (!crop_.isShown()) return;
  const haptics::Grid& grid = scan_->grid;
  // along each axis of W, what every slice that is in view shows of it
  const double far_mm = 1e5;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-far_mm), high = -low;
  bool any = false;
  for (const ui::Plane plane : {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal}) {
    const ui::SliceView& slice = window_.slice(plane);
    if (!slice.isVisible()) continue;
    any = true;
    const ui::PlaneAxes axes = ui::axesOf(plane);
    const QPointF origin = slice.projected(Eigen::Vector3d::Zero());
    const QRectF seen = slice.pictureRect();
    const auto narrow = [&](const Eigen::Vector3d& along, double at_zero, double per_mm,
                            double begin, double end) {
      int a = 0;
      along.cwiseAbs().maxCoeff(&a);
      const auto [from, to] =
          std::minmax({(begin - at_zero) / per_mm * along[a], (end - at_zero) / per_mm * along[a]});
      low[a] = std::max(low[a], from);
      high[a] = std::min(high[a], to);
    };
    narrow(axes.right, origin.x(), slice.projected(axes.right).x() - origin.x(), seen.left(),
           seen.right());
    narrow(axes.up, origin.y(), slice.projected(axes.up).y() - origin.y(), seen.top(),
           seen.bottom());
  }
  if (!any)
    return window_.showMessage(
        tr("No slice is in view to crop to; show the slices, or set the box by its numbers."));
  haptics::Vec3 first = haptics::Vec3::Constant(far_mm), last = -first;
  for (int corner = 0; corner < 8; ++corner) {
    haptics::Vec3 p_mm;
    for (int a = 0; a < 3; ++a) p_mm[a] = (corner >> a) & 1 ? high[a] : low[a];
    const haptics::Vec3 index = grid.indexOf(p_mm / kMmPerM);
    first = first.cwiseMin(index);
    last = last.cwiseMax(index);
  }
  haptics::VoxelBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    box.first[a] = std::clamp<std::int64_t>(std::llround(first[axis] + 0.5), 0, grid.dims[a] - 1);
    const std::int64_t end = std::llround(last[axis] + 0.5);
    box.end[a] = std::clamp(end, box.first[a] + 1, grid.dims[a]);
  }
  crop_.show(grid, box);
  showCrop();
}

void EditController::applyCrop() {
  if (!crop_.isShown() || crop_.box() == shared_.shown->volume()->bounds()) return showCrop();
  showCrop();
  apply(haptics::Crop{crop_.box()});
}

void EditController::showPlane() {
  if (!plane_.isPlaced()) return panel_->show(std::nullopt, plane_.clicks());
  const Eigen::Vector3d& n = plane_.normal();
  const Eigen::Vector3d middle = ui::boxOf_mm(scan_->grid).center();
  panel_->show(
      ui::EditPanel::PlaneNumbers{.position_mm = n.dot(plane_.point_mm() - middle),
                                  // 0 straight up and down: adding 0 makes -0 a 0
                                  .towards_deg = std::atan2(n.y() + 0.0, n.x() + 0.0) * kDegrees,
                                  .raised_deg = std::asin(std::clamp(n.z(), -1.0, 1.0)) * kDegrees},
      0);
}

void EditController::placePlane(ui::Plane plane) {
  if (!plane_.isShown()) return;
  plane_.place(window_.slice(plane).through_mm(), ui::axesOf(plane).normal);
  showPlane();
}

void EditController::turnPlane(double position_mm, double towards_deg, double raised_deg) {
  if (!plane_.isPlaced()) return;
  const double towards = towards_deg / kDegrees, raised = raised_deg / kDegrees;
  const Eigen::Vector3d n{std::cos(raised) * std::cos(towards),
                          std::cos(raised) * std::sin(towards), std::sin(raised)};
  const Eigen::Vector3d middle = ui::boxOf_mm(scan_->grid).center();
  const double was = plane_.normal().dot(plane_.point_mm() - middle);
  // turned about its point; shifted by what was typed
  Eigen::Vector3d point = plane_.point_mm();
  if (plane_.normal().dot(n) > 1.0 - 1e-9) point += plane_.normal() * (position_mm - was);
  plane_.place(point, n);
  showPlane();
}

void EditController::cutPlane() {
  if (!plane_.isPlaced()) return;
  const haptics::PlaneCut cut{plane_.point_mm() / kMmPerM, plane_.normal(),
                              shared_.settings.isovalue};
  changeTool(EditTool::Plane);
  apply(cut);
}

void EditController::cutOutline(const ui::DrawnOutline& outline) {
  if (!shared_.shown) return;
  const ui::Projection& camera = outline.camera;
  const double reach_mm = ui::boxOf_mm(scan_->grid).diagonal().norm() + 1.0;
  const std::optional<double> depth_mm = panel_->depth_mm();
  haptics::LassoCut cut;
  cut.parallel = camera.parallel;
  cut.inside = panel_->cutsInside();
  cut.isovalue = shared_.settings.isovalue;
  cut.outline = outline.corners;
  if (camera.parallel)
    for (auto& corner : cut.outline)
      for (double& c : corner) c /= kMmPerM;
  Eigen::Vector3d eye = camera.eye;
  double from_mm = 0.0, until_mm = 0.0;
  if (outline.in_slice) {
    // to both sides of the slice
    const double half = std::min(depth_mm.value_or(reach_mm), reach_mm);
    eye += camera.axes.col(2) * reach_mm;
    from_mm = reach_mm - half;
    until_mm = reach_mm + half;
  } else {
    const double middle = camera.depthOf(ui::boxOf_mm(scan_->grid).center());
    until_mm = middle + reach_mm;
    if (depth_mm) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Eigen::Vector3d& place : outline.seen)
        nearest = std::min(nearest, camera.depthOf(place));
      if (!std::isfinite(nearest))
        return window_.showMessage(
            tr("There is no surface inside the outline to measure the depth from; draw it over "
               "the surface, or cut through everything."));
      until_mm = nearest + *depth_mm;
    }
  }
  cut.X_WC.linear() = camera.axes;
  cut.X_WC.translation() = eye / kMmPerM;
  cut.from = from_mm / kMmPerM;
  cut.until = until_mm / kMmPerM;
  apply(cut);
}

void EditController::preview(Edit edit, ui::EditConfirm confirm, const QString& words) {
  if (!shared_.shown || replaying_) return;
  endPreview();
  window_.clearMessage();
  previewer_.start(
      [edit, volume = shared_.shown->volume(),
       isovalue = shared_.settings.isovalue](const Watch& watch) -> haptics::Expected<Preview> {
        const auto removal = haptics::removalOf(*volume, edit, isovalue, {.cancel = &watch.cancel});
        if (!removal) return tl::unexpected(removal.error());
        // of a piece what is solid; it takes its rim with it, which nobody sees. A holder is foam,
        // too
        const bool solid = !std::holds_alternative<haptics::RemoveHolder>(edit);
        return Preview{removal->volume,
                       marked(*volume, *removal, solid ? isovalue : -kAnyIntensity)};
      },
      [this, edit, confirm, words](const haptics::Expected<Preview>& made) {
        if (!made) {
          if (made.error().kind != haptics::Error::Kind::Cancelled)
            window_.showMessage(made.error().reason == background::kNoMemory
                                    ? tr("There is not enough memory to show this.")
                                    : sentenceOf(made.error()));
          return;
        }
        previewed_ = edit;
        shade_.show(made->voxels);
        panel_->showPreview(words.arg(cm3Of(made->volume)), confirm);
      });
}

void EditController::endPreview() {
  previewer_.abandon();
  previewed_.reset();
  shade_.show(nullptr);
  panel_->hidePreview();
}

void EditController::confirmPiece(bool keep) {
  if (!previewed_) return;
  const auto* piece = std::get_if<haptics::RemovePiece>(&*previewed_);
  if (piece == nullptr) return;
  const haptics::RemovePiece wanted = *piece;
  if (keep)
    apply(haptics::KeepPiece{wanted.seed_W, wanted.isovalue});
  else
    apply(wanted);
}

void EditController::save(const QString& path) {
  if (!shared_.shown) return;
  if (saver_.isRunning())
    return window_.showMessage(tr("A volume is being saved; wait for it, or cancel it first."));
  std::filesystem::path out = path.toStdString();
  if (out.extension() != ".nrrd") out += ".nrrd";
  window_.clearMessage();
  window_.showLoading(tr("Saving"));
  saver_.start(
      [out, volume = shared_.shown->volume(),
       place = shared_.shown->place](const Watch& watch) -> haptics::Expected<QString> {
        const auto written = writeEdited(
            *volume, out, place, [&](double done) { watch.advanced(done); }, watch.cancel);
        if (!written) return tl::unexpected(written.error());
        return QString::fromStdString(out.filename().string());
      },
      [this, folder = QString::fromStdString(out.parent_path().string())](
          const haptics::Expected<QString>& name) {
        window_.endLoading();
        if (name) return window_.showDone(tr("\"%1\" was saved.").arg(*name), folder);
        if (name.error().kind != haptics::Error::Kind::Cancelled)
          window_.showMessage(name.error().reason == background::kNoMemory
                                  ? tr("There is not enough memory to save this volume.")
                                  : sentenceOf(name.error()));
      });
}

}  // namespace app
