// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/touch/hand_controller.h"

#include <array>
#include <utility>

#include "app/window/scan/sentence.h"
#include "haptics/scene/legal_pose.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

using haptics::HandKind;

struct Hand {
  const char* id;
  HandKind kind;
  const char* label;
};
constexpr std::array<Hand, 8> kHands{{
    {"mouse", HandKind::Mouse, QT_TRANSLATE_NOOP("app::HandController", "Mouse")},
    {"tap", HandKind::Tap, QT_TRANSLATE_NOOP("app::HandController", "Simulated: tap")},
    {"slide", HandKind::Slide, QT_TRANSLATE_NOOP("app::HandController", "Simulated: slide")},
    {"wedge", HandKind::Wedge, QT_TRANSLATE_NOOP("app::HandController", "Simulated: wedge")},
    {"pry", HandKind::Pry, QT_TRANSLATE_NOOP("app::HandController", "Simulated: pry")},
    {"hook", HandKind::Hook, QT_TRANSLATE_NOOP("app::HandController", "Simulated: hook")},
    {"jerk", HandKind::Jerk, QT_TRANSLATE_NOOP("app::HandController", "Simulated: jerk")},
    {"twist", HandKind::Twist, QT_TRANSLATE_NOOP("app::HandController", "Simulated: twist")},
}};

const Hand* handOf(const std::string& name) {
  for (const Hand& hand : kHands)
    if (name == hand.id) return &hand;
  return nullptr;
}

}  // namespace

HandController::HandController(ui::Views& views, ui::Messages& messages, ui::SidePanel& panels,
                               ui::TouchState& touch, SharedState& shared, std::string hand,
                               double stiffness)
    : views_(views),
      messages_(messages),
      touch_(touch),
      shared_(shared),
      panel_(new ui::DevicePanel),
      hand_(std::move(hand)) {
  shared.settings.stiffness = stiffness;
  panels.add(panel_, tr("Hand and tool"), tr("Hand and tool"), "toolSection", ui::Tab::Touch);
  QList<ui::Choice> hands;
  for (const Hand& one : kHands) hands.append({one.id, tr(one.label)});
  panel_->setHands(hands);
  panel_->showStiffness(stiffness);
  connect(panel_, &ui::DevicePanel::handChosen, this, &HandController::choose);
  connect(panel_, &ui::DevicePanel::stiffnessChanged, this, [this](double wanted) {
    shared_.settings.stiffness = wanted;
    shared_.apply();
  });
  connect(panel_, &ui::DevicePanel::frictionChanged, this, [this](double coefficient) {
    shared_.settings.friction = coefficient;
    shared_.apply();
  });
  connect(&touch, &ui::TouchState::forceOffWanted, this, [this] { shared_.session.forceOff(); });
  connect(&touch, &ui::TouchState::forceOnWanted, this, [this] { shared_.session.arm(); });
  connect(&views.volume(), &ui::VolumeView::handPulled, this,
          [this](const haptics::Pose& X_WH) { shared_.session.pull(X_WH); });
}

void HandController::choose(const QString& id) {
  const std::string name = id.toStdString();
  if (shared_.shown && !shared_.replaying) return void(open(name));
  hand_ = name;  // opened with the first scene, or when the replay has ended
  if (shared_.replaying) emit replayEndWanted();
}

bool HandController::open(std::string name, const std::optional<haptics::Pose>& from) {
  const Hand* hand = handOf(name);
  if (hand == nullptr) return false;
  const auto opened = shared_.session.open(hand->kind, from);
  if (!opened) {
    messages_.showMessage(sentenceOf(opened.error()));
    panel_->showHand(QString::fromStdString(hand_), label_);
    return false;
  }
  emit this->opened();
  show(name, tr(hand->label), hand->kind == HandKind::Mouse, ui::Feel::Shown);
  // a simulated hand aims where it likes: show where
  emit lookWanted(hand->kind != HandKind::Mouse && !from);
  return true;
}

void HandController::show(const std::string& id, const QString& label, bool is_mouse,
                          ui::Feel feel) {
  const QString name = QString::fromStdString(id);
  hand_ = id;
  label_ = label;
  emit changed(name);
  shared_.snapshot = {};  // of the new loop nothing is known yet, and its counts begin at zero
  views_.volume().setMouseHand(is_mouse);
  panel_->showHand(name, label);
  touch_.setHand(label, feel);
}

void HandController::setStiffness(double stiffness) {
  shared_.settings.stiffness = stiffness;
  panel_->showStiffness(stiffness);
  shared_.apply();
}

void HandController::takeDevice(const QString& id, const QString& label, bool motors) {
  show(id.toStdString(), label, false, motors ? ui::Feel::Felt : ui::Feel::Nothing);
}

void HandController::forgetDevice() { hand_ = "mouse"; }

/// A stop ends with its scan, unless motors push the hand.
void HandController::adopt(bool new_volume, bool placed) {
  const Loaded& shown = *shared_.shown;
  haptics::Session& session = shared_.session;
  // a simulated hand aims at its scene, so a new one needs a new hand; what the user holds goes on
  const Hand* hand = handOf(hand_);
  const bool mouse = hand != nullptr && hand->kind == HandKind::Mouse;
  const bool device = hand == nullptr;
  if (!session.isOpen() || !(mouse || device)) {
    session.close();
    shared_.apply();
    session.adopt(shown.scene, shown.start);
    if (new_volume && !device) emit touch_.forceOnWanted();
    return;
  }
  std::optional<haptics::Pose> start;
  if (!new_volume && placed)
    start = haptics::legalPoseNear(*shown.scene, shared_.settings.isovalue, shared_.snapshot.X_WP);
  // the hand comes along where the tool starts elsewhere, and not before: it would pull the tool
  // through the surface that is still felt
  const bool along = !start && mouse;
  if (along) {
    views_.volume().setMouseHand(true);
    views_.volume().placeHand(shown.start);
  }
  session.adopt(shown.scene, start.value_or(shown.start), along);
  if (new_volume && !device) emit touch_.forceOnWanted();
  // not before the scene: in the old volume this isovalue may make everything solid
  shared_.apply();
}

void HandController::bring(const haptics::Pose& X_WT, const haptics::Pose& X_WH) {
  if (!shared_.shown || shared_.replaying) return;
  const Hand* hand = handOf(hand_);
  if (hand != nullptr && hand->kind != HandKind::Mouse) return void(open(hand_, X_WT));
  shared_.session.bring(X_WT, X_WH);
  views_.volume().placeHand(X_WH);
}

void HandController::lift(const haptics::Pose& X_WT) {
  if (!shared_.shown || shared_.replaying || holdsDevice()) return;
  if (hand_ == "mouse" || open("mouse", X_WT)) bring(X_WT, X_WT);
}

bool HandController::holdsDevice() const { return handOf(hand_) == nullptr; }

void HandController::reopen() {
  if (shared_.shown && !shared_.replaying) open(hand_);
}

void HandController::resume() {
  if (shared_.replaying || shared_.session.isOpen()) return;
  if (!open(hand_) && hand_ != "mouse") open("mouse");
}

}  // namespace app
