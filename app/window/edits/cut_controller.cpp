// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/edits/cut_controller.h"

#include <QAction>
#include <QThread>
#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <utility>
#include <variant>

#include "app/recording/cut_words.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "datasets/edits/edited.h"
#include "datasets/edits/walls.h"
#include "haptics/scene/carved_scene.h"
#include "resources/named_tools.h"
#include "ui/controls/bindings.h"
#include "ui/views/volume_view.h"
#include "ui/window/messages.h"
#include "ui/window/views.h"

namespace app {
namespace {

constexpr std::size_t kCutsAtOnce = 256;
constexpr double kMm3PerM3 = 1e9;
constexpr double kVibration = 0.1;  // of the normal force

const resources::NamedTool* burrOf(const ToolSource& tool) {
  const resources::NamedTool* named = tool.file ? nullptr : resources::findNamedTool(tool.name);
  return named != nullptr && named->cuts() ? named : nullptr;
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
  QAction& before_after = window.views().beforeAfter();
  connect(panel_, &Panel::beforeAfterChosen, &before_after, &QAction::setChecked);
  connect(&before_after, &QAction::changed, panel_, [this, &before_after] {
    panel_->setBeforeAfter(before_after.isChecked(), before_after.isEnabled());
  });
  connect(panel_, &Panel::tintChosen, &window.views().volume(), &ui::VolumeView::setTint);
  panel_->setSoundPossible(BurrPlayer::isPossible());
  connect(panel_, &Panel::soundChosen, this, [this](bool on) { sound_.setOn(on); });
  connect(&window.views().volume(), &ui::VolumeView::cutHeld, this, [this](bool held) {
    key_ = held;
    shared_.session.holdCut(key_ && !replaying_);
  });
  showState();
}

CutController::~CutController() = default;

const resources::NamedTool* CutController::burr() const {
  if (!shared_.shown) return nullptr;
  // walls of a solid structure are voxels like any others
  if (datasets::walledOf(*shared_.shown->scene->volume) != nullptr) return nullptr;
  return burrOf(shared_.shown->tool);
}

haptics::CutLaw CutController::lawOf(const resources::NamedTool& burr) const {
  haptics::CutLaw law;
  const ui::BurrNumbers numbers = panel_->numbers();
  law.burr = haptics::ballAtTip(shared_.shown->scene->tool.shell, 0.5 * burr.tip);
  law.speed = numbers.speed_rpm * 2.0 * std::numbers::pi / 60.0;
  if (numbers.vibrates) law.vibration = kVibration;
  haptics::Material& material = law.material;
  material.bands[0].energy = numbers.energy_J_mm3 * kMm3PerM3;
  for (const ui::BurrBand& band : numbers.bands)
    material.bands[material.count++] = {band.from, band.energy_J_mm3 * kMm3PerM3};
  std::ranges::sort(std::span{material.bands}.first(material.count).subspan(1), {},
                    &haptics::Material::Band::from);
  return law;
}

void CutController::showScene(const std::vector<datasets::Edit>& edits) {
  told_ = {};
  for (const datasets::Edit& edit : edits)
    if (const auto* stroke = std::get_if<datasets::Stroke>(&edit))
      told_.strokes_mm3.append(stroke->removed() * kMm3PerM3);
  showTissues();
  panel_->showTool(shared_.shown ? QString::fromStdString(shared_.shown->tool.name) : QString{});
  showRemoved();
  if (!shared_.shown || shared_.shown->scene->id == scene_) return;
  takeCuts();  // of the scene before
  if (live_ && scanOf(live_->uncut()) != scanOf(shared_.shown->volume())) {
    stroke_ = {};
    removed_ = {};
    forgetWaiting();
  }
  endStroke();
  prepare();
}

void CutController::rest(bool on) {
  asks_ = on;
  goOn();
  if (!on) return;
  key_ = false;  // until it is pressed anew
  shared_.session.holdCut(false);
}

bool CutController::hasCut() {
  takeCuts();
  return removed_.voxels > 0;
}

void CutController::showTissues() {
  if (!shared_.shown) return;
  const haptics::Volume& volume = *shared_.shown->volume();
  panel_->setValues(volume.least, volume.greatest, QString::fromStdString(volume.unit));
  const datasets::TissueTable* table = datasets::tissuesIn(volume);
  const auto parts = table != nullptr ? static_cast<int>(table->parts().size()) : 0;
  const auto never =
      parts == 0 ? 0
                 : static_cast<int>(std::ranges::count(table->parts(), haptics::Tissues::kNever,
                                                       &datasets::TissueTable::Part::energy));
  panel_->showTissues(never, parts - never);
}

void CutController::prepare() {
  maker_.abandon();
  if (shared_.shown->scene->id != scene_) {
    live_.reset();
    law_.clear();
    cut_ = false;
    way_.clear();
    scene_ = shared_.shown->scene->id;
  }
  const resources::NamedTool* tool = burr();
  if (tool == nullptr) {
    callWaiting();
    return showState();
  }
  maker_.start(
      [scene = shared_.shown->scene,
       law = lawOf(*tool)](const background::Watch&) -> haptics::Expected<Made> {
        auto carved = haptics::CarvedScene::of(*scene);
        if (!carved) return tl::unexpected(carved.error());
        Made made{std::make_unique<haptics::Cutting>(std::move(*carved), law),
                  CarvedCopy{scene->volume}};
        made.cutting->lookAhead();
        if (auto opened = made.live.open(); !opened) return tl::unexpected(opened.error());
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
  // the law before may cut until now: what was cut is kept, and the new law begins with a scene
  const bool known = stop();
  if (live_ && (cut_ || !known)) {
    emit freshWanted();
  } else {
    live_ = std::move(made->live);
    law_ = QString::fromStdString(wordsOf(made->cutting->law()));
    tellLaw();
    shared_.session.cut(std::move(made->cutting));
    showLive();
    callWaiting();
  }
  goOn();
}

bool CutController::stop() {
  shared_.session.restCut(true);
  for (int n = 0; n < 20 && !shared_.session.cutRests(); ++n) QThread::msleep(1);
  const bool known = shared_.session.cutRests();
  takeCuts();
  return known;
}

void CutController::tellLaw() {
  if (!law_.isEmpty()) emit lawChosen(law_, static_cast<double>(scene_));
}

void CutController::showLive() {
  if (!live_ || replaying_) return;
  std::vector<haptics::VoxelBox> cut_before = datasets::boxesOfStrokes(*live_->uncut());
  cut_before.insert(cut_before.end(), way_.begin(), way_.end());
  window_.views().showLive(live_->volume(), scanOf(live_->uncut()), cut_before);
  window_.views().volume().setTint(panel_->tint());
}

void CutController::refresh() {
  if (key_ && !replaying_) shared_.session.holdCut(true);
  takeCuts();
  // a slow window lets the key lapse for a moment: that is no other stroke
  if (!shared_.snapshot.cuts && !key_) endStroke();
  showState();
  tellSound();
}

void CutController::tellSound() {
  const haptics::Snapshot& now = shared_.snapshot;
  if (now.tick == std::exchange(heard_, now.tick))
    return;  // of a loop that stands nothing is heard
  sound_.show(
      {.turns = now.cuts, .speed_rpm = panel_->numbers().speed_rpm, .force = now.burr_force});
}

void CutController::takeCuts() {
  // first, as more come while these are carried out
  std::vector<haptics::BurrCut> cuts;
  std::array<haptics::BurrCut, kCutsAtOnce> some;
  while (const std::size_t count = shared_.session.cuts(some))
    cuts.insert(cuts.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  if (!live_) return;  // of a scene that is gone with all that was cut in it
  std::vector<haptics::VoxelBox> changed;
  for (const haptics::BurrCut& cut : cuts) {
    const auto done = live_->carve(cut).value();  // its view is open: nothing is refused
    haptics::add(done.box, changed);
    removed_.add(done.removed);
    stroke_.push_back(cut);
    cut_ = true;
    if (stroke_.size() == datasets::kMostCuts) endStroke();
  }
  if (changed.empty()) return;
  for (const haptics::VoxelBox& box : changed) {
    haptics::add(box, way_);
    if (!replaying_) window_.views().carve(box);
  }
  showRemoved();
}

void CutController::endStroke() {
  if (stroke_.empty()) return;
  const haptics::Removed removed = std::exchange(removed_, {});
  const datasets::Stroke stroke{std::exchange(stroke_, {}), std::max(0.0, removed.volume)};
  if (removed.voxels > 0) emit strokeMade(stroke, scene_);
}

void CutController::changeLaw() {
  if (replaying_ || burr() == nullptr) return;
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
  const bool known = stop();
  endStroke();
  if (known && !cut_) {
    then();
  } else {
    waiting_ = std::move(then);
    emit freshWanted();
  }
  goOn();
}

void CutController::callWaiting() {
  if (const auto waiting = std::exchange(waiting_, {})) waiting();
}

void CutController::showState() {
  using State = ui::CutPanel::State;
  if (shared_.snapshot.cuts) return panel_->showState(State::Turning, shared_.snapshot.burr_force);
  if (!shared_.shown || burrOf(shared_.shown->tool) == nullptr)
    return panel_->showState(State::NoBurr);
  if (burr() == nullptr) return panel_->showState(State::Solid);
  panel_->showState(live_ ? State::Ready : State::Preparing);
}

void CutController::showRemoved() {
  ui::CutTold told = told_;
  if (removed_.volume > 0.0) told.strokes_mm3.append(removed_.volume * kMm3PerM3);
  panel_->show(told);
}

}  // namespace app
