// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/touch_state.h"

#include <QLocale>
#include <QPushButton>
#include <cmath>

#include "ui/controls/state_chip.h"
#include "ui/panels/status_line.h"
#include "ui/window/banner.h"
#include "ui/window/top_bar.h"

namespace ui {
namespace {

constexpr int kWordsMs = 100;  // between two changes of force and status in words

}  // namespace

TouchState::TouchState(TopBar& bar, Banner& stopped, StatusLine& status)
    : bar_(bar), stopped_(stopped), status_(status), resume_(stopped.addButton("forceOn")) {
  connect(&bar_, &TopBar::stopWanted, this, [this] { stop(tr("Force stopped")); });
  connect(resume_, &QPushButton::clicked, this, &TouchState::forceOnWanted);
  resume_->setToolTip(tr("The force may come back: hold the handle"));
  connect(this, &TouchState::forceOnWanted, this, [this] { stopped_by_.clear(); });
  words_.setSingleShot(true);
  words_.setInterval(kWordsMs);
  connect(&words_, &QTimer::timeout, this, &TouchState::displayWords);
  bar_.force().show(Mark::Off, tr("Nothing to touch yet"));
}

void TouchState::display(const haptics::Snapshot& snapshot) {
  unsaid_ = snapshot;
  if (!words_.isActive()) displayWords();
  sayForce(snapshot);
}

void TouchState::sayForce(const haptics::Snapshot& snapshot) {
  using haptics::ForceState;
  const ForceSaid said = stateOf(snapshot, feel_);
  bar_.force().show(said.mark, said.words);
  is_force_ = isForce(snapshot);
  bar_.stop().setForce(is_force_);
  // what the user can do about it: one button, in one place
  const bool live = snapshot.policy != haptics::SchedulingPolicy::NotStarted;
  const bool fault = snapshot.force_state == ForceState::Fault;
  const bool can = live && feel_ != Feel::Nothing &&
                   (snapshot.force_state == ForceState::Ready ||
                    (fault && snapshot.reason != haptics::ForceReason::Lost));
  if (can) {
    const bool stopped = !fault && !stopped_by_.isEmpty();
    stopped_.setSentence(stopped ? stopped_by_
                         : fault ? tr("The force is off after a fault")
                         : feel_ == Feel::Felt
                             ? tr("The device is ready: no force until you arm it")
                             : tr("The force is off"));
    resume_->setText(fault                             ? tr("Arm again")
                     : feel_ == Feel::Felt && !stopped ? tr("Arm")
                                                       : tr("Resume"));
  }
  stopped_.setVisible(can);
}

void TouchState::stop(const QString& by) {
  if (is_force_) stopped_by_ = by;
  emit forceOffWanted();
}

void TouchState::displayWords() {
  if (!unsaid_) return;
  emit worded(*unsaid_);
  status_.display(*unsaid_);
  showDetail(*unsaid_);
  unsaid_.reset();
  words_.start();
}

void TouchState::setHand(const QString& label, Feel feel) {
  feel_ = feel;
  stopped_by_.clear();
  status_.setHand(label);
  hand_ = label;
  detail(label);
}

void TouchState::showNear(const std::vector<StructureNear>& near, const NearLimits& limits) {
  status_.showNear(near, limits);
}

void TouchState::showDetail(const haptics::Snapshot& snapshot) {
  // of the loop that runs: a rate that it has but for a busy moment, else to a tenth
  const double measured = snapshot.servo_rate * 1e-3, whole = std::round(measured);
  const double kHz = std::abs(measured - whole) < 0.25 ? whole : std::round(10.0 * measured) / 10.0;
  const bool known = snapshot.policy != haptics::SchedulingPolicy::NotStarted && kHz > 0.0;
  detail(known ? tr("%1 · %2 kHz").arg(hand_, QLocale().toString(kHz)) : hand_);
}

void TouchState::detail(const QString& words) {
  bar_.force().setDetail(words);
  emit handNamed(words);
}

}  // namespace ui
