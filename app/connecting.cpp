// SPDX-License-Identifier: BSD-3-Clause
// The part of the application that connects a haptic device, and says what becomes of its force.
#include <algorithm>
#include <array>
#include <utility>

#include "app/application.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/force_words.h"
#include "ui/volume_view.h"

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

void Application::connectDevices() {
  ui::HapticDevicePanel& panel = window_.hapticDevicePanel();
  connect(&panel, &ui::HapticDevicePanel::seen, this, [this](bool visible) {
    devices_seen_ = visible;
    watchDevices();
  });
  connect(&panel, &ui::HapticDevicePanel::surveyWanted, &watch_, &DeviceWatch::surveyNow);
  connect(&panel, &ui::HapticDevicePanel::connectWanted, this, [this](const ui::DeviceWish& wish) {
    window_.hapticDevicePanel().showConnecting(nameOfDevice(wish.id));
    watch_.open(wish);
  });
  connect(&panel, &ui::HapticDevicePanel::disconnectWanted, this, [this] {
    watch_.cancel();
    if (connected_) return letGoOfDevice({});
    window_.hapticDevicePanel().showDisconnected({});
  });
  connect(&panel, &ui::HapticDevicePanel::mappingChanged, this, [this](const ui::Mapping& mapping) {
    mapping_ = mapping;
    scaleAsMapped();
    session_.set(settings_);
  });
  connect(&panel, &ui::HapticDevicePanel::stiffnessLifted, this,
          [this](bool lifted) { session_.liftStiffness(lifted); });
  connect(&watch_, &DeviceWatch::surveyed, this, [this](const QList<ui::DeviceLine>& devices) {
    devices_ = devices;
    window_.hapticDevicePanel().show(devices);
  });
  connect(&watch_, &DeviceWatch::opened, this, &Application::takeDevice);
  connect(&watch_, &DeviceWatch::refused, this,
          [this](const ui::DeviceWish& wish, haptics::Trouble trouble, const QString& sentence) {
            window_.hapticDevicePanel().showRefused(wish.id, trouble, sentence);
            window_.showMessage(sentence);
          });
  ui::VolumeView& view = window_.view();
  connect(&view, &ui::VolumeView::clutchHeld, this, [this](bool held) {
    handling_.clutch = held;
    session_.handle(handling_);
  });
  connect(&view, &ui::VolumeView::forceHeld, this, [this](bool held) {
    handling_.held = held;
    session_.handle(handling_);
  });
  mapping_ = preferences_.mapping;
  scaleAsMapped();
  panel.show(mapping_);
}

void Application::scaleAsMapped() {
  settings_.position_scale = mapping_.position_scale;
  settings_.force_scale = mapping_.force_scale;
}

QString Application::nameOfDevice(const QString& id) const {
  for (const ui::DeviceLine& device : devices_)
    if (device.id == id) return device.name;
  return id;
}

void Application::watchDevices() { watch_.watch(devices_seen_ || connected_.has_value()); }

void Application::takeDevice(const ui::DeviceWish& wish, const DeviceWatch::Opened& device) {
  closeReplay();
  handleDevice();
  // half of what it is rated for at the hand, to begin with: what was set was for another hand
  if (const double rated = (*device)->rating().stiffness; rated > 0.0) {
    if (!own_stiffness_) own_stiffness_ = settings_.stiffness;
    setStiffness(0.5 * rated / (settings_.position_scale * settings_.force_scale));
  }
  const auto opened = session_.open(std::move(*device));
  if (!opened) {
    restoreStiffness();
    const QString why = QString::fromStdString(opened.error().what);
    window_.hapticDevicePanel().showDisconnected(why);
    return window_.showMessage(why);
  }
  connected_ = wish;
  connected_name_ = nameOfDevice(wish.id);
  window_.hapticDevicePanel().showConnected(wish.id);
  watchDevices();
  showHand(wish.id.toStdString(), connected_name_, false);
}

void Application::setStiffness(double stiffness) {
  settings_.stiffness = stiffness;
  window_.devicePanel().showStiffness(stiffness);
  session_.set(settings_);
}

/// What was set before a device brought its own.
void Application::restoreStiffness() {
  if (own_stiffness_) setStiffness(*std::exchange(own_stiffness_, std::nullopt));
}

void Application::letGoOfDevice(const QString& why) {
  session_.close();
  forgetDevice(why);
  if (shown_ && !replay_) openHand(hand_);
}

void Application::forgetDevice(const QString& why) {
  if (!connected_) return;
  connected_.reset();
  restoreStiffness();
  hand_ = "mouse";
  window_.hapticDevicePanel().showDisconnected(why);
  watchDevices();
}

/// The camera turns the hand's directions, unless they are to stay.
void Application::handleDevice() {
  haptics::Handling now = handling_;
  if (mapping_.follow_camera) now.R_WB = window_.view().viewAxes();
  now.clutch_button = mapping_.clutch_button;
  now.hold_to_run = mapping_.hold_to_run;
  now.hold_button = mapping_.hold_button;
  // a camera that has not been set up yet has no directions
  if (!now.R_WB.allFinite()) now.R_WB = handling_.R_WB;
  handling_ = now;
  session_.handle(handling_);
}

void Application::tellOfForce() {
  handleDevice();
  window_.hapticDevicePanel().showStiffness(
      settings_, connected_ ? std::optional{session_.inForce()} : std::nullopt);
  std::array<haptics::ForceTransition, kTransitionsAtOnce> transitions;
  while (const std::size_t count = session_.transitions(transitions)) {
    for (const haptics::ForceTransition& transition : std::span{transitions}.first(count)) {
      recording_.note("force", wordsOf(transition));
      if (transition.to == ForceState::Fault && connected_) tellOfFault(transition.reason);
    }
    if (count < transitions.size()) break;
  }
}

void Application::tellOfFault(haptics::ForceReason why) {
  window_.showFault(
      tr("%1: the force was taken away. %2")
          .arg(connected_name_, ui::sentenceFor(ForceState::Fault, why, snapshot_.trouble)));
}

}  // namespace app
