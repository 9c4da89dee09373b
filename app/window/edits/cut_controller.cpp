// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/edits/cut_controller.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>
#include <utility>
#include <variant>

#include "app/recording/cut_words.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "datasets/edits/walls.h"
#include "haptics/scene/carved_scene.h"
#include "resources/named_tools.h"
#include "ui/controls/bindings.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

constexpr std::size_t kCutsAtOnce = 256;
constexpr int kRestMs = 500;
constexpr double kMm3PerM3 = 1e9;

const resources::NamedTool* burrOf(const ToolSource& tool) {
  const resources::NamedTool* named = tool.file ? nullptr : resources::findNamedTool(tool.name);
  return named != nullptr && named->cuts() ? named : nullptr;
}

haptics::VoxelBox joined(const haptics::VoxelBox& one, const haptics::VoxelBox& other) {
  if (one == haptics::VoxelBox{}) return other;
  haptics::VoxelBox both;
  for (std::size_t a = 0; a < 3; ++a) {
    both.first[a] = std::min(one.first[a], other.first[a]);
    both.end[a] = std::max(one.end[a], other.end[a]);
  }
  return both;
}

}  // namespace

CutController::CutController(ui::MainWindow& window, SharedState& shared)
    : window_(window), shared_(shared), panel_(new ui::CutPanel) {
  window.panels().add(panel_, tr("Cut"), tr("Cut"), "cutSection", ui::Tab::Touch);
  QList<ui::BurrChoice> burrs;
  for (const resources::NamedTool& tool : resources::namedTools()) {
    if (!tool.cuts()) continue;
    const QString name = QString::fromStdString(tool.name);
    const QString size = tr("%L1 mm").arg(tool.tip * 1e3, 0, 'g', 2);
    const bool plain = name.startsWith(QLatin1String("burr-"));
    const QString title = labelOf(ToolSource{.name = tool.name});
    burrs.append({name, plain ? size : title, plain ? tr("Burr, %1").arg(size) : title});
  }
  panel_->setBurrs(burrs);
  using Panel = ui::CutPanel;
  connect(panel_, &Panel::burrChosen, this, [this](const QString& name) {
    const resources::NamedTool* now = shared_.shown ? burrOf(shared_.shown->tool) : nullptr;
    if (now == nullptr || now->name != name.toStdString()) emit toolWanted(name);
  });
  connect(panel_, &Panel::numbersChanged, this, &CutController::changeLaw);
  connect(panel_, &Panel::undoWanted, this, &CutController::undoWanted);
  connect(panel_, &Panel::redoWanted, this, &CutController::redoWanted);
  connect(panel_, &Panel::tintChosen, &window.views().volume(), &ui::VolumeView::setTint);
  connect(&window.views().volume(), &ui::VolumeView::cutHeld, this, [this](bool held) {
    key_ = held;
    shared_.session.holdCut(held && !replaying_);
  });
  showState();
}

CutController::~CutController() = default;

std::optional<haptics::CutLaw> CutController::law() const {
  if (!shared_.shown) return {};
  const resources::NamedTool* tool = burrOf(shared_.shown->tool);
  const haptics::Scene& scene = *shared_.shown->scene;
  // walls of a solid structure are voxels like any others
  if (tool == nullptr || datasets::walledOf(*scene.volume) != nullptr) return {};
  haptics::CutLaw law;
  const ui::BurrNumbers numbers = panel_->numbers();
  law.burr = haptics::ballAtTip(scene.tool.shell, 0.5 * tool->tip);
  law.speed = numbers.speed_rpm * 2.0 * std::numbers::pi / 60.0;
  law.material.bands[0].energy = numbers.energy_J_mm3 * kMm3PerM3;
  return law;
}

void CutController::showScene(const std::vector<datasets::Edit>& edits) {
  strokes_ = static_cast<std::size_t>(std::ranges::count_if(
      edits, [](const auto& edit) { return std::holds_alternative<datasets::Stroke>(edit); }));
  if (removed_by_.size() < strokes_) removed_by_.resize(strokes_, 0.0);
  panel_->showTool(shared_.shown ? QString::fromStdString(shared_.shown->tool.name) : QString{});
  showRemoved();
  if (!shared_.shown || shared_.shown->scene->id == scene_) return;
  takeCuts();  // of the scene before
  if (live_ && scanOf(live_->uncut) != scanOf(shared_.shown->volume())) {
    stroke_ = {};
    removed_ = 0.0;
    lowered_ = false;
    removed_by_.assign(strokes_, 0.0);
  }
  endStroke();
  prepare();
}

void CutController::prepare() {
  maker_.abandon();
  live_.reset();
  law_.clear();
  cut_ = false;
  scene_ = shared_.shown->scene->id;
  const auto chosen = law();
  if (!chosen) {
    callWaiting();
    return showState();
  }
  maker_.start(
      [scene = shared_.shown->scene,
       law = *chosen](const background::Watch&) -> haptics::Expected<Made> {
        auto carved = haptics::CarvedScene::of(*scene);
        if (!carved) return tl::unexpected(carved.error());
        auto voxels = haptics::viewLike(*scene->volume);
        if (!voxels) return tl::unexpected(voxels.error());
        Made made{std::make_unique<haptics::Cutting>(std::move(*carved), law), *scene->volume,
                  *voxels};
        made.cutting->lookAhead();
        made.live.voxels = *voxels;
        return made;
      },
      [this, scene = scene_](haptics::Expected<Made> made) { deliver(scene, std::move(made)); });
  showState();
}

void CutController::deliver(std::uint64_t scene, haptics::Expected<Made> made) {
  if (!shared_.shown || shared_.shown->scene->id != scene) return;
  if (!made) {
    if (made.error().kind != haptics::Error::Kind::Cancelled)
      window_.messages().showMessage(sentenceOf(made.error()));
    return callWaiting();
  }
  takeCuts();  // of the scene before: they are gone with it
  live_ = Live{shared_.shown->volume(), std::move(made->live), std::move(made->voxels)};
  law_ = QString::fromStdString(wordsOf(made->cutting->law()));
  tellLaw();
  shared_.session.cut(std::move(made->cutting));
  showLive();
  callWaiting();
}

void CutController::tellLaw() {
  if (!law_.isEmpty()) emit lawChosen(law_, static_cast<double>(scene_));
}

void CutController::showLive() {
  if (!live_ || replaying_) return;
  window_.views().showLive(live_->volume, scanOf(live_->uncut));
  window_.views().volume().setTint(panel_->tint());
}

void CutController::refresh() {
  if (key_ && !replaying_) shared_.session.holdCut(true);
  takeCuts();
  // a slow window lets the key lapse for a moment: that is no other stroke
  const bool rests = !key_ || !since_cut_.isValid() || since_cut_.hasExpired(kRestMs);
  if (!shared_.snapshot.cuts && rests) endStroke();
  showState();
}

void CutController::takeCuts() {
  std::array<haptics::BurrCut, kCutsAtOnce> cuts;
  haptics::VoxelBox changed;
  while (const std::size_t count = shared_.session.cuts(cuts)) {
    if (!live_) continue;  // of a scene that is gone with all that was cut in it
    for (std::size_t n = 0; n < count; ++n) {
      haptics::BurrCarving carving{live_->volume, cuts[n]};
      haptics::Removed removed;
      while (!carving.isDone())
        removed.add(
            carving.lowerRow(live_->voxels.get(), live_->uncut->voxels.get(), haptics::Material{}));
      if (removed.voxels > 0) changed = joined(changed, carving.box());
      removed_ += removed.volume;
      lowered_ = lowered_ || removed.voxels > 0;
      stroke_.push_back(cuts[n]);
      cut_ = true;
      since_cut_.start();
      if (stroke_.size() == datasets::kMostCuts) endStroke();
    }
  }
  if (changed == haptics::VoxelBox{}) return;
  if (!replaying_) window_.views().carve(changed);
  showRemoved();
}

void CutController::endStroke() {
  if (stroke_.empty()) return;
  const datasets::Stroke stroke{std::exchange(stroke_, {})};
  const double removed = std::exchange(removed_, 0.0);
  if (!std::exchange(lowered_, false)) return;  // it met nothing
  removed_by_.resize(strokes_);
  removed_by_.push_back(removed);
  emit strokeMade(stroke, scene_);
}

void CutController::changeLaw() {
  if (!shared_.shown || replaying_ || !law()) return;
  takeCuts();
  if (cut_ || shared_.snapshot.cuts)
    emit freshWanted();
  else
    prepare();
}

void CutController::setReplaying(bool replaying) {
  replaying_ = replaying;
  panel_->setEnabled(!replaying);
  if (!replaying) showLive();
}

void CutController::whenUncut(std::function<void()> then) {
  takeCuts();
  endStroke();
  if (!cut_) return then();
  waiting_ = std::move(then);
  emit freshWanted();
}

void CutController::callWaiting() {
  if (const auto waiting = std::exchange(waiting_, {})) waiting();
}

void CutController::showState() {
  using State = ui::CutPanel::State;
  if (shared_.snapshot.cuts) return panel_->showState(State::Turning, shared_.snapshot.burr_force);
  if (!shared_.shown || burrOf(shared_.shown->tool) == nullptr)
    return panel_->showState(State::NoBurr);
  if (!law()) return panel_->showState(State::Solid);
  panel_->showState(live_ ? State::Ready : State::Preparing);
}

void CutController::showRemoved() {
  const bool under_way = removed_ > 0.0;
  const double before = std::accumulate(
      removed_by_.begin(), removed_by_.begin() + static_cast<std::ptrdiff_t>(strokes_), 0.0);
  const double last = under_way ? removed_ : strokes_ > 0 ? removed_by_[strokes_ - 1] : 0.0;
  panel_->show({.strokes = static_cast<int>(strokes_) + (under_way ? 1 : 0),
                .all_mm3 = (before + removed_) * kMm3PerM3,
                .last_mm3 = last * kMm3PerM3});
}

}  // namespace app
