// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/edits/edit_controller.h"

#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "app/window/edits/crop_numbers.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "datasets/edits/edited.h"
#include "ui/controls/bindings.h"
#include "ui/views/volume_view.h"
#include "ui/window/escape_filter.h"

namespace app {
namespace {

using datasets::Edit;
using Step = EditQueue::Step;
using ui::EditTool;
using ui::kMmPerM;

constexpr double kCm3PerM3 = 1e6;
constexpr double kLeastOffered = 5e-6;  // m^3: less of a holder is in nobody's way
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Three significant figures, and cm³.
QString cm3Of(double volume) {
  const double cm3 = volume * kCm3PerM3;
  const double magnitude = cm3 > 0.0 ? std::floor(std::log10(cm3)) : 0.0;
  const int decimals = std::clamp(2 - static_cast<int>(magnitude), 0, 6);
  return EditController::tr("%1 cm³").arg(QLocale().toString(cm3, 'f', decimals));
}

std::shared_ptr<const ui::MarkedVoxels> marked(const haptics::Grid& grid,
                                               const datasets::Removal& removal) {
  auto voxels = std::make_shared<ui::MarkedVoxels>(grid);
  for (const haptics::VoxelRun& run : removal.runs) voxels->add(run.i, run.j, run.k, run.count);
  voxels->finish();
  return voxels;
}

}  // namespace

haptics::Expected<EditController::Preview> EditController::previewOf(
    const Edit& edit, const haptics::Volume& volume, double isovalue,
    const background::Watch& watch) {
  const auto removal = datasets::removalOf(volume, edit, isovalue, {.cancel = &watch.cancel});
  if (!removal) return tl::unexpected(removal.error());
  return Preview{removal->volume, marked(volume.grid, *removal)};
}

EditController::EditController(ui::MainWindow& window, SharedState& shared)
    : window_(window),
      views_(window.views()),
      messages_(window.messages()),
      loading_(window.loading()),
      menus_(window.menus()),
      panels_(window.panels()),
      bar_(window.bar()),
      shared_(shared),
      panel_(new ui::EditPanel),
      jobs_(messages_, loading_, shared),
      waits_(new ui::Banner(ui::Banner::Kind::Question, "editWaits")),
      found_(new ui::Banner(ui::Banner::Kind::Question, "holderFound")),
      // with its words: a load that ended meanwhile has put the bar away
      saver_([this](double fraction) {
        loading_.begin(tr("Saving"));
        loading_.advance(fraction);
      }) {
  window.panels().add(panel_, tr("Remove parts"), tr("Remove parts"), "editSection",
                      ui::Tab::Touch);
  for (ui::Overlay* overlay :
       std::initializer_list<ui::Overlay*>{&shade_, &plane_, &crop_, &pick_, &lasso_})
    window.views().addOverlay(*overlay);
  buildMenu();
  connectJobs();
  connectPanel();
  connectOverlays();
  offerLift();
  offerHolder();
  connect(&window.loading(), &ui::Loading::cancelWanted, this, [this] {
    jobs_.cancel();
    saver_.cancel();
  });
  connect(&window.menus(), &ui::Menus::saveEditedWanted, this, &EditController::save);
  window.escape().addEnder(*this, [this] { return endTool(); });
}

void EditController::connectJobs() {
  connect(&jobs_, &EditQueue::edited, this, &EditController::edited);
  connect(&jobs_, &EditQueue::renewed, this, &EditController::renewed);
  connect(&jobs_, &EditQueue::pictured, this, &EditController::pictured);
  connect(&jobs_, &EditQueue::noted, this, &EditController::noted);
  connect(&jobs_, &EditQueue::waitChanged, this, &EditController::showWait);
  connect(&jobs_, &EditQueue::failed, this, &EditController::failed);
  connect(&jobs_, &EditQueue::failed, this, [this] {
    showSteps();
    // the box shows what is there
    if (crop_.isShown()) changeTool(EditTool::Crop);
  });
}

void EditController::buildMenu() {
  QMenu& menu = menus_.edit();
  undo_ = menu.addAction(tr("&Undo"), this, [this] { want({Step::Undo}); });
  undo_->setObjectName("undo");
  ui::giveKeys(*undo_, ui::Action::Undo, tr("Takes the last edit back"));
  redo_ = menu.addAction(tr("&Redo"), this, [this] { want({Step::Redo}); });
  redo_->setObjectName("redo");
  ui::giveKeys(*redo_, ui::Action::Redo, tr("Makes the edit again that was taken back"));
  reset_ = menu.addAction(tr("Take &all edits back"), this, [this] { want({Step::Reset}); });
  reset_->setObjectName("reset");
  bar_.add(ui::BarGroup::File, *undo_, "undo");
  bar_.add(ui::BarGroup::File, *redo_, "redo");
  menu.addSeparator();
  addTool(tr("&Crop box"), EditTool::Crop);
  addTool(tr("Clip &plane"), EditTool::Plane);
  addTool(tr("P&ieces"), EditTool::Pieces);
  addTool(tr("Table and &holder"), EditTool::Holder);
  addTool(tr("&Scalpel"), EditTool::Scalpel);
  showSteps();
}

void EditController::addTool(const QString& text, EditTool tool) {
  QAction* action = menus_.edit().addAction(text, this, [this, tool] {
    panels_.reveal(panel_);
    panel_->setTool(tool);
    panel_->setFocus();
  });
  tools_.push_back(action);
  if (tool != EditTool::Crop) return;
  action->setObjectName("cropBox");
  bar_.add(ui::BarGroup::Tools, *action, "crop");
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
    preview(datasets::RemoveSmallPieces{.isovalue = shared_.settings.isovalue,
                                        .least_volume = least_cm3 / kCm3PerM3},
            ui::EditConfirm::Removal,
            tr("All pieces smaller than %1: together %2.").arg(cm3Of(least_cm3 / kCm3PerM3)));
  });
  connect(panel_, &Panel::holderWanted, this, [this] {
    preview(datasets::RemoveHolder{.isovalue = shared_.settings.isovalue}, ui::EditConfirm::Removal,
            tr("Table and holder: %1 would go."));
  });
  connect(panel_, &Panel::keepPieceWanted, this, [this] { confirmPiece(true); });
  connect(panel_, &Panel::removePieceWanted, this, [this] { confirmPiece(false); });
  connect(panel_, &Panel::fateShown, this, [this](bool keep) {
    if (marked_) shade_.show(marked_, keep ? ui::Fate::Stays : ui::Fate::Goes);
  });
  connect(panel_, &Panel::scalpelChanged, this, &EditController::showCut);
  connect(panel_, &Panel::removalWanted, this, [this] {
    if (previewed_) apply(*previewed_);
  });
  connect(panel_, &Panel::previewCancelled, this, &EditController::endPreview);
  connect(panel_, &Panel::undoWanted, this, [this] { want({Step::Undo}); });
  connect(panel_, &Panel::redoWanted, this, [this] { want({Step::Redo}); });
  connect(panel_, &Panel::resetWanted, this, [this] { want({Step::Reset}); });
  connect(panel_, &Panel::waitCancelled, &jobs_, &EditQueue::cancelWait);
}

void EditController::connectOverlays() {
  connect(&crop_, &ui::CropBox::moved, this, &EditController::showCrop);
  connect(&crop_, &ui::CropBox::released, this, &EditController::applyCrop);
  connect(&plane_, &ui::ClipPlane::moved, this, &EditController::showPlane);
  connect(&plane_, &ui::ClipPlane::refused, this, [this](const QString& why) {
    showPlane();
    messages_.showMessage(why);
  });
  connect(&lasso_, &ui::Lasso::drawn, this, [this](const ui::DrawnOutline& outline) {
    endPreview();
    drawn_ = outline;
    showCut();
  });
  connect(&lasso_, &ui::Lasso::confirmed, panel_, &ui::EditPanel::removalWanted);
  connect(&pick_, &ui::PlacePick::picked, this, [this](const Eigen::Vector3d& place_W_mm) {
    preview(datasets::RemovePiece{place_W_mm / kMmPerM, shared_.settings.isovalue},
            ui::EditConfirm::Piece, tr("This piece: %1."));
  });
}

void EditController::showScene() {
  if (!shared_.shown) return;
  const auto scan = scanOf(shared_.shown->volume());
  if (scan != scan_) {
    scan_ = scan;
    jobs_.begin(scan);
    panel_->setTool(EditTool::None);
    lookForHolder();
  }
  panel_->setReady(!replaying_);
  endPreview();
  showSteps();
  if (crop_.isShown() && !crop_.isHeld() && !jobs_.hasMore()) changeTool(EditTool::Crop);
}

void EditController::setReplaying(bool replaying) {
  replaying_ = replaying;
  if (replaying) {
    endTool();
    found_->hide();
  }
  panel_->setReady(!replaying && shared_.shown.has_value());
  showSteps();
}

std::vector<Edit> EditController::edits() const {
  const datasets::Edited* edited =
      shared_.shown ? datasets::editedOf(*shared_.shown->volume()) : nullptr;
  return edited != nullptr ? edited->edits : std::vector<datasets::Edit>{};
}

void EditController::restore(std::vector<Edit> edits) { want({Step::Restore, std::move(edits)}); }

void EditController::addStroke(const datasets::Stroke& stroke, std::uint64_t scene) {
  // what was cut stays cut, also where a replay has begun meanwhile
  if (shared_.shown) jobs_.want({Step::Apply, {stroke}, scene});
}

void EditController::apply(Edit edit) {
  endPreview();
  want({Step::Apply, {std::move(edit)}});
}

void EditController::want(EditQueue::Job job) {
  if (!shared_.shown || replaying_) return;
  messages_.clear();
  jobs_.want(std::move(job));
}

void EditController::showSteps() {
  const int in_force = static_cast<int>(edits().size());
  // while a job runs, its thread has the history
  const datasets::EditHistory* history = jobs_.historyAtRest();
  const ui::EditSteps steps{.in_force = in_force,
                            .undo = history != nullptr ? history->canUndo() : in_force > 0,
                            .redo = history != nullptr && history->canRedo()};
  panel_->show(steps);
  undo_->setEnabled(steps.undo && !replaying_);
  redo_->setEnabled(steps.redo && !replaying_);
  emit stepsChanged(steps.undo && !replaying_, steps.redo && !replaying_);
  reset_->setEnabled(in_force > 0 && !replaying_);
  for (QAction* tool : tools_) tool->setEnabled(shared_.shown.has_value() && !replaying_);
  const bool taken = std::ranges::any_of(edits(), datasets::takesAway);
  window_.setEdited(taken);
  if (taken) found_->hide();
}

void EditController::changeTool(EditTool tool) {
  endPreview();
  if (tool == EditTool::Holder) found_->hide();
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

bool EditController::endTool() {
  // what is shown of a cut first
  if (drawn_ && !jobs_.isWaiting()) {
    endPreview();
    return true;
  }
  const bool busy = panel_->tool() != EditTool::None || jobs_.isWaiting();
  jobs_.cancelWait();
  previewer_.abandon();
  panel_->setTool(EditTool::None);
  return busy;
}

void EditController::showCrop() {
  const haptics::Volume& volume = *shared_.shown->volume();
  panel_->show(cropRangesOf(volume, crop_.box()),
               cropsAlongPatient(volume)
                   ? tr("LPS, millimetres from the scan's origin")
                   : tr("Millimetres along the scan's own axes, from its first voxel"));
}

void EditController::moveCropFace(int axis, bool high, double mm) {
  if (!crop_.isShown()) return;
  const haptics::Volume& volume = *shared_.shown->volume();
  crop_.show(volume.grid, withFace(volume, crop_.box(), axis, high, mm));
  showCrop();
}

void EditController::cropToView() {
  if (!crop_.isShown()) return;
  const auto box = boxInSlices(views_, scan_->grid);
  if (!box)
    return messages_.showMessage(
        tr("No slice is in view to crop to; show the slices, or set the box by its numbers."));
  crop_.show(scan_->grid, *box);
  showCrop();
}

void EditController::applyCrop() {
  if (!crop_.isShown() || crop_.box() == shared_.shown->volume()->bounds()) return showCrop();
  showCrop();
  apply(datasets::Crop{crop_.box()});
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
  plane_.place(views_.slice(plane).through_mm(), ui::axesOf(plane).normal);
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
  const datasets::PlaneCut cut{plane_.point_mm() / kMmPerM, plane_.normal(),
                               shared_.settings.isovalue};
  changeTool(EditTool::Plane);
  apply(cut);
}

void EditController::showCut() {
  if (!shared_.shown || !drawn_) return;
  const ui::DrawnOutline outline = *drawn_;
  const ui::Projection& camera = outline.camera;
  const double reach_mm = ui::boxOf_mm(scan_->grid).diagonal().norm() + 1.0;
  const std::optional<double> depth_mm = panel_->depth_mm();
  datasets::LassoCut cut;
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
      if (!std::isfinite(nearest)) {
        endPreview();
        return messages_.showMessage(
            tr("There is no surface inside the outline to measure the depth from; draw it over "
               "the surface, or cut through everything."));
      }
      until_mm = nearest + *depth_mm;
    }
  }
  cut.X_WC.linear() = camera.axes;
  cut.X_WC.translation() = eye / kMmPerM;
  cut.from = from_mm / kMmPerM;
  cut.until = until_mm / kMmPerM;
  preview(cut, ui::EditConfirm::Cut,
          tr("All that is hatched goes, for the eye and the touch, soft tissue too: %1 of it is "
             "solid at "
             "the isovalue."));
  drawn_ = outline;
}

void EditController::preview(Edit edit, ui::EditConfirm confirm, const QString& words) {
  if (!shared_.shown || replaying_) return;
  endPreview();
  messages_.clear();
  previewer_.start(
      [edit, volume = shared_.shown->volume(), isovalue = shared_.settings.isovalue](
          const background::Watch& watch) { return previewOf(edit, *volume, isovalue, watch); },
      [this, edit, confirm, words](const haptics::Expected<Preview>& made) {
        if (!made) {
          drawn_.reset();
          if (made.error().kind != haptics::Error::Kind::Cancelled)
            messages_.showMessage(made.error().reason == background::kNoMemory
                                      ? tr("There is not enough memory to show this.")
                                      : sentenceOf(made.error()));
          return;
        }
        previewed_ = edit;
        marked_ = made->voxels;
        shade_.show(marked_, confirm == ui::EditConfirm::Piece ? ui::Fate::Chosen : ui::Fate::Goes);
        lasso_.setAsks(confirm == ui::EditConfirm::Cut);
        panel_->showPreview(words.arg(cm3Of(made->volume)), confirm);
      });
}

void EditController::endPreview() {
  previewer_.abandon();
  previewed_.reset();
  marked_.reset();
  drawn_.reset();
  lasso_.setAsks(false);
  shade_.show(nullptr);
  panel_->hidePreview();
}

void EditController::confirmPiece(bool keep) {
  if (!previewed_) return;
  const auto* piece = std::get_if<datasets::RemovePiece>(&*previewed_);
  if (piece == nullptr) return;
  const datasets::RemovePiece wanted = *piece;
  if (keep)
    apply(datasets::KeepPiece{wanted.seed_W, wanted.isovalue});
  else
    apply(wanted);
}

void EditController::offerLift() {
  window_.addOverView(*waits_);
  lift_ = waits_->addButton("liftTool");
  lift_->setText(tr("Lift the tool"));
  lift_->setToolTip(tr("Takes the tool off the surface; a simulated hand gives it to the mouse"));
  connect(lift_, &QPushButton::clicked, this, &EditController::liftWanted);
}

void EditController::showWait(const QString& words) {
  panel_->showWait(words);
  if (words.isEmpty()) return waits_->hide();
  waits_->setSentence(device_held_ ? words + ' ' + tr("Lift the handle of the device.") : words);
  lift_->setVisible(!device_held_);
  waits_->show();
}

void EditController::offerHolder() {
  window_.addOverView(*found_);
  found_->setSentence(tr("Table and head holder found"));
  const auto button = [&](const char* name, const QString& text, const QString& tip,
                          const std::function<void()>& take) {
    QPushButton* one = found_->addButton(name);
    one->setText(text);
    one->setToolTip(tip);
    connect(one, &QPushButton::clicked, this, take);
  };
  button("holderRemove", tr("Remove"), tr("Takes them away; Undo brings them back"), [this] {
    found_->hide();
    apply(holder_->edit);
  });
  button("holderShow", tr("Show"), tr("Shows in amber what would be removed"),
         [this] { shade_.show(holder_->preview.voxels); });
  button("holderKeep", tr("Keep"), tr("Leaves the scan as it is"), [this] {
    found_->hide();
    endPreview();
  });
}

/// Of a scan from a file, and only where intensities say what is air.
void EditController::lookForHolder() {
  found_->hide();
  holder_.reset();
  looker_.abandon();
  const auto volume = shared_.shown->volume();
  if (shared_.shown->place.empty() || volume->unit != "HU") return;
  const double isovalue = shared_.settings.isovalue;
  const Edit edit = datasets::RemoveHolder{.isovalue = isovalue};
  looker_.start(
      [edit, volume, isovalue](const background::Watch& watch) {
        background::goLast();
        return previewOf(edit, *volume, isovalue, watch);
      },
      [this, edit](const haptics::Expected<Preview>& made) {
        if (!made || made->volume < kLeastOffered || !edits().empty() || replaying_) return;
        holder_ = Found{edit, *made};
        found_->show();
      });
}

void EditController::save(const QString& path) {
  if (!shared_.shown) return;
  if (saver_.isRunning())
    return messages_.showMessage(tr("A volume is being saved; wait for it, or cancel it first."));
  const auto chosen = ui::withEnding(messages_, path, ".nrrd");
  if (!chosen) return;
  const std::filesystem::path out = chosen->toStdString();
  messages_.clear();
  loading_.begin(tr("Saving"));
  saver_.start(
      [out, volume = shared_.shown->volume(),
       place = shared_.shown->place](const background::Watch& watch) -> haptics::Expected<QString> {
        const auto written = writeEdited(
            *volume, out, place, [&](double done) { watch.advanced(done); }, watch.cancel);
        if (!written) return tl::unexpected(written.error());
        return QString::fromStdString(out.filename().string());
      },
      [this, folder = QString::fromStdString(out.parent_path().string())](
          const haptics::Expected<QString>& name) {
        loading_.end();
        QString why;
        if (name)
          messages_.showDone(tr("\"%1\" was saved.").arg(*name), folder);
        else if (name.error().kind != haptics::Error::Kind::Cancelled)
          why = name.error().reason == background::kNoMemory
                    ? tr("There is not enough memory to save this volume.")
                    : sentenceOf(name.error());
        if (!why.isEmpty()) messages_.showMessage(why);
        emit saved(name.has_value(), why);
      });
}

}  // namespace app
