// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/device/device_controller.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/log/log.h"
#include "app/window/scan/sentence.h"
#include "ui/panels/force_words.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

using haptics::ForceState;

constexpr std::size_t kTransitionsAtOnce = 64;

// as recordings keep it, in every language the same
constexpr std::array kStates{"off", "ready", "armed", "ramping", "on", "fault"};
constexpr std::array kReasons{"none",       "user",     "no-reading", "not-homed", "scene",
                              "inside",     "clutched", "not-held",   "gap",       "too-fast",
                              "not-finite", "stale",    "lost",       "jump",      "stalled"};

QString wordsOf(const haptics::ForceTransition& transition) {
  return QStringLiteral("%1 -> %2, %3")
      .arg(kStates.at(static_cast<std::size_t>(transition.from)),
           kStates.at(static_cast<std::size_t>(transition.to)),
           kReasons.at(static_cast<std::size_t>(transition.reason)));
}
static_assert(kStates.size() == static_cast<std::size_t>(ForceState::Fault) + 1);
static_assert(kReasons.size() == static_cast<std::size_t>(haptics::ForceReason::Stalled) + 1);

}  // namespace

DeviceController::DeviceController(ui::Views& views, ui::Messages& messages, ui::SidePanel& panels,
                                   ui::TouchState& touch, ui::StartPage& start, SharedState& shared,
                                   PreferencesController& preferences, DeviceCatalogue catalogue)
    : views_(views),
      messages_(messages),
      panels_(panels),
      touch_(touch),
      shared_(shared),
      panel_(new ui::HapticDevicePanel),
      watch_(std::move(catalogue)) {
  panels.add(panel_, tr("Haptic device"), tr("Haptic device"), "deviceSection", ui::Tab::Device);
  connect(&start, &ui::StartPage::deviceWanted, this, [this] { panels_.reveal(panel_); });
  connectPanel();
  map(preferences.present().mapping);
  panel_->show(mapping_);
  connect(&preferences, &PreferencesController::saving, this, [this](Preferences& saved) {
    saved.stiffness = own_stiffness_.value_or(shared_.settings.stiffness);
    saved.mapping = mapping_;
  });
}

void DeviceController::connectPanel() {
  connect(panel_, &ui::HapticDevicePanel::seen, this, [this](bool visible) {
    seen_ = visible;
    watchDevices();
  });
  connect(panel_, &ui::HapticDevicePanel::surveyWanted, &watch_, &DeviceWatch::surveyNow);
  connect(panel_, &ui::HapticDevicePanel::connectWanted, this, &DeviceController::open);
  connect(panel_, &ui::HapticDevicePanel::disconnectWanted, this, [this] {
    waiting_.reset();
    watch_.cancel();
    if (connected_) return letGo();
    panel_->showDisconnected({});
  });
  connect(panel_, &ui::HapticDevicePanel::mappingChanged, this, [this](const ui::Mapping& mapping) {
    map(mapping);
    shared_.apply();
  });
  connect(panel_, &ui::HapticDevicePanel::stiffnessLifted, this,
          [this](bool lifted) { shared_.session.liftStiffness(lifted); });
  connect(&watch_, &DeviceWatch::surveyed, this, [this](const QList<ui::DeviceLine>& devices) {
    devices_ = devices;
    panel_->show(devices);
  });
  connect(&watch_, &DeviceWatch::opened, this, &DeviceController::take);
  connect(&watch_, &DeviceWatch::refused, this,
          [this](const ui::DeviceWish& wish, haptics::Trouble trouble, const QString& sentence) {
            log::write(log::Level::Warning, "device-refused",
                       {{"kind", log::nameOfProgram(wish.id.section(':', 0, 0).toStdString())},
                        {"trouble", log::nameOfProgram(haptics::wordOf(trouble))}});
            panel_->showRefused(wish.id, trouble, sentence);
            messages_.showMessage(sentence);
          });
  connect(panel_, &ui::HapticDevicePanel::armWanted, &touch_, &ui::TouchState::forceOnWanted);
  ui::VolumeView& view = views_.volume();
  connect(&view, &ui::VolumeView::clutchHeld, this, [this](bool held) {
    handling_.clutch = held;
    shared_.session.handle(handling_);
  });
  connect(&view, &ui::VolumeView::forceHeld, this, [this](bool held) {
    handling_.held = held;
    shared_.session.handle(handling_);
  });
}

void DeviceController::open(const ui::DeviceWish& wish) {
  if (!shared_.shown) {
    waiting_ = wish;
    return panel_->showDisconnected(
        tr("%1 will be connected when there is something to touch: open a scan, or try the demo "
           "skull.")
            .arg(nameOf(wish.id)));
  }
  panel_->showConnecting(nameOf(wish.id));
  watch_.open(wish);
}

void DeviceController::openWaiting() {
  if (waiting_) open(*std::exchange(waiting_, std::nullopt));
}

void DeviceController::map(const ui::Mapping& mapping) {
  mapping_ = mapping;
  shared_.settings.position_scale = mapping.position_scale;
  shared_.settings.force_scale = mapping.force_scale;
}

QString DeviceController::nameOf(const QString& id) const {
  for (const ui::DeviceLine& device : devices_)
    if (device.id == id) return device.name;
  return id;
}

bool DeviceController::hasMotors(const QString& id) const {
  for (const ui::DeviceLine& device : devices_)
    if (device.id == id) return device.actuated > 0;
  return true;
}

void DeviceController::watchDevices() { watch_.watch(seen_ || connected_.has_value()); }

void DeviceController::take(const ui::DeviceWish& wish, const DeviceWatch::Opened& device) {
  emit taking();
  handle();
  // half of what it is rated for at the hand, to begin with: what was set was for another hand
  if (const double rated = (*device)->rating().stiffness; rated > 0.0) {
    if (!own_stiffness_) own_stiffness_ = shared_.settings.stiffness;
    emit stiffnessWanted(0.5 * rated /
                         (shared_.settings.position_scale * shared_.settings.force_scale));
  }
  const auto opened = shared_.session.open(std::move(*device));
  if (!opened) {
    restoreStiffness();
    const QString why = sentenceOf(opened.error());
    panel_->showDisconnected(why);
    return messages_.showMessage(why);
  }
  connected_ = wish;
  connected_name_ = nameOf(wish.id);
  panel_->showConnected(wish.id);
  watchDevices();
  emit taken(wish.id, connected_name_, hasMotors(wish.id));
}

/// What was set before a device brought its own.
void DeviceController::restoreStiffness() {
  if (own_stiffness_) emit stiffnessWanted(*std::exchange(own_stiffness_, std::nullopt));
}

void DeviceController::setStiffness(double stiffness) {
  if (own_stiffness_)
    own_stiffness_ = stiffness;
  else
    emit stiffnessWanted(stiffness);
}

void DeviceController::letGo() {
  shared_.session.close();
  forget({});
  emit released();
}

void DeviceController::forget(const QString& why) {
  if (!connected_) return;
  connected_.reset();
  restoreStiffness();
  emit forgotten();
  panel_->showDisconnected(why);
  watchDevices();
}

/// The camera turns the hand's directions, unless they are to stay.
void DeviceController::handle() {
  haptics::Handling now = handling_;
  if (mapping_.follow_camera) now.R_WB = views_.volume().viewAxes();
  now.clutch_button = mapping_.clutch_button;
  now.hold_to_run = mapping_.hold_to_run;
  now.hold_button = mapping_.hold_button;
  now.cut_button = mapping_.cut_button;
  // a camera that has not been set up yet has no directions
  if (!now.R_WB.allFinite()) now.R_WB = handling_.R_WB;
  handling_ = now;
  shared_.session.handle(handling_);
}

void DeviceController::refresh() {
  handle();
  panel_->showStiffness(shared_.settings,
                        connected_ ? std::optional{shared_.session.inForce()} : std::nullopt);
  std::array<haptics::ForceTransition, kTransitionsAtOnce> transitions;
  while (const std::size_t count = shared_.session.transitions(transitions)) {
    for (const haptics::ForceTransition& transition : std::span{transitions}.first(count)) {
      emit forceChanged(wordsOf(transition));
      if (transition.to == ForceState::Fault && connected_) tellOfFault(transition.reason);
    }
    if (count < transitions.size()) break;
  }
}

void DeviceController::tellOfFault(haptics::ForceReason why) {
  messages_.showFault(
      tr("%1: the force was taken away. %2")
          .arg(connected_name_, ui::sentenceFor(ForceState::Fault, why, shared_.snapshot.trouble)));
}

}  // namespace app
