// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/force_words.h"

#include <QCoreApplication>

namespace ui {
namespace {

using haptics::ForceReason;
using haptics::ForceState;
using haptics::Trouble;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ForceWords)
};

// why there is no force, without what to do about it
QString whatHappened(ForceReason reason) {
  switch (reason) {
    case ForceReason::None:
    case ForceReason::User:
      return {};
    case ForceReason::NoReading:
      return Words::tr("The device has not reported its position yet.");
    case ForceReason::NotHomed:
      return Words::tr("The device does not know yet where it is.");
    case ForceReason::Scene:
      return Words::tr("There is something new to touch, or nothing yet.");
    case ForceReason::Inside:
      return Words::tr("The isovalue left the tool inside the solid; it is being brought out.");
    case ForceReason::Clutched:
      return Words::tr("The clutch is held.");
    case ForceReason::NotHeld:
      return Words::tr("The button or key that has to be held for a force is not down.");
    case ForceReason::Gap:
      return Words::tr("There was a gap in the servo loop.");
    case ForceReason::TooFast:
      return Words::tr("The handle moved faster than a hand does.");
    case ForceReason::NotFinite:
      return Words::tr("The computed force was not a number.");
    case ForceReason::Stale:
      return Words::tr("The device's readings came too late.");
    case ForceReason::Lost:
      return Words::tr("The device is disconnected, or does not answer.");
    case ForceReason::Jump:
      return Words::tr("The device's position jumped.");
    case ForceReason::Stalled:
      return Words::tr("The servo loop stood still.");
  }
  return {};
}

// what the device itself asks of the user
QString whatToDo(Trouble trouble) {
  switch (trouble) {
    case Trouble::NotHomed:
      return Words::tr("Move its handle to its stops: all the way out, then all the way in.");
    case Trouble::NeedsCalibration:
      return Words::tr(
          "Put its stylus into the cradle. Or put its arm to rest and press its zero button, or "
          "hold down the button of its stylus.");
    case Trouble::NotStarted:
      return Words::tr("See that it has power, and wait until it has started.");
    case Trouble::MotorsHot:
      return Words::tr("Its motors are hot: let it rest for some minutes.");
    case Trouble::ForceOff:
      return Words::tr("It switched its force off: press its force button, or see its lamp.");
    default:
      return {};
  }
}

}  // namespace

QString nameOf(ForceState state) {
  switch (state) {
    case ForceState::Off:
      return Words::tr("Off");
    case ForceState::Ready:
      return Words::tr("Ready");
    case ForceState::Armed:
      return Words::tr("Armed");
    case ForceState::Ramping:
      return Words::tr("Rising");
    case ForceState::On:
      return Words::tr("On");
    case ForceState::Fault:
      return Words::tr("Fault");
  }
  return {};
}

QString sentenceFor(ForceState state, ForceReason reason, Trouble trouble) {
  QStringList parts{state == ForceState::On ? QString{} : whatHappened(reason), whatToDo(trouble)};
  if (state == ForceState::Ready) parts << Words::tr("Arm the device to feel a force.");
  if (state == ForceState::Fault)
    parts << (reason == ForceReason::Lost
                  ? Words::tr("Plug it in, then disconnect it here and connect it again.")
                  : Words::tr("Let the handle rest, then arm the device again."));
  parts.removeAll(QString{});
  return parts.join(' ');
}

ForceSaid stateOf(const haptics::Snapshot& snapshot, Feel feel) {
  // no loop runs: what is shown is of another time
  if (snapshot.policy == haptics::SchedulingPolicy::NotStarted)
    return {Mark::Replay, Words::tr("Replay")};
  return stateOf(snapshot.force_state, feel);
}

ForceSaid stateOf(ForceState state, Feel feel) {
  if (feel == Feel::Nothing) return {Mark::Off, Words::tr("No motors, no force")};
  const bool felt = feel == Feel::Felt;
  switch (state) {
    case ForceState::Off:
      return {Mark::Off, felt ? Words::tr("No force yet") : Words::tr("Nothing to touch yet")};
    case ForceState::Ready:
      return {Mark::Ready, felt ? Words::tr("Force off") : Words::tr("Force stopped")};
    case ForceState::Armed:
      return {Mark::Held, Words::tr("Force withheld")};
    case ForceState::Ramping:
      return {Mark::Rising, Words::tr("Force rising")};
    case ForceState::On:
      if (felt) return {Mark::On, Words::tr("Force on")};
      return {Mark::Shown, Words::tr("Force shown, not felt")};
    case ForceState::Fault:
      return {Mark::Fault, Words::tr("Fault: no force")};
  }
  return {};
}

bool isForce(const haptics::Snapshot& snapshot) {
  return snapshot.policy != haptics::SchedulingPolicy::NotStarted &&
         (snapshot.force_state == ForceState::Armed ||
          snapshot.force_state == ForceState::Ramping || snapshot.force_state == ForceState::On);
}

}  // namespace ui
