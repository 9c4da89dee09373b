// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/coupling/safety.h"

#include <algorithm>
#include <cmath>

#include "haptics/coupling/virtual_coupling.h"

namespace haptics {
namespace {

/// What is left of the gain after another tick of fading.
double faded(double gain, double period) HAPTICS_RT {
  constexpr double kNothing = 1e-9;
  const double left = gain - period / Safety::kFade;
  return left > kNothing ? left : 0.0;
}

constexpr double kWarm = 0.8;  // of what the motors stand for ever: from here on they are spared

/// `last` moved towards `wanted` by at most `step`; `reached` becomes false if that was not enough.
Vec3 approached(const Vec3& last, const Vec3& wanted, double step, bool& reached) HAPTICS_RT {
  const Vec3 change = wanted - last;
  const double size = change.norm();
  if (size <= step) return wanted;
  reached = false;
  return last + change * (step / size);
}

/// Whether the tool is taken from the hand without any doubt about what is felt.
bool fades(ForceReason withheld) HAPTICS_RT {
  return withheld == ForceReason::Inside || withheld == ForceReason::Clutched ||
         withheld == ForceReason::NotHeld;
}

}  // namespace

bool Safety::mayBeFelt() const HAPTICS_RT {
  return at_.state == ForceState::Armed || at_.state == ForceState::Ramping ||
         at_.state == ForceState::On;
}

void Safety::enter(ForceState state, ForceReason reason) HAPTICS_RT {
  if (state != at_.state) transitions_.push({0.0, at_.state, state, reason});
  at_.state = state;
  at_.reason = reason;
  if (mayBeFelt()) return;
  at_.gain = 0.0;
  at_.slewing = false;
  at_.sent = {};
}

void Safety::begin(const Circumstances& now) HAPTICS_RT {
  transitions_.clear();
  at_.withheld = now.withheld;
  if (now.fault != ForceReason::None) {
    at_.let_go = false;
    return enter(ForceState::Fault, now.fault);
  }
  if (at_.state == ForceState::Fault) {
    at_.let_go = at_.let_go || !now.armed;
    if (!at_.let_go || !now.armed) return;
    enter(ForceState::Ready, ForceReason::User);
  }
  // what the device did meanwhile was no work of the force
  if (now.adopted || !now.ready) {
    const double share = at_.passivity.share;
    at_.passivity = {};
    at_.passivity.share = share;
  }
  if (!now.ready) return enter(ForceState::Off, now.unready);
  if (!now.armed) return enter(ForceState::Ready, ForceReason::User);
  if (at_.state == ForceState::Off) enter(ForceState::Ready, ForceReason::User);
  if (at_.state == ForceState::Ready) {
    at_.passivity.share = 1.0;
    enter(ForceState::Armed, ForceReason::User);
  }
  const bool doubted = at_.withheld != ForceReason::None && !fades(at_.withheld);
  if (now.adopted || doubted) {
    at_.gain = 0.0;
    at_.slewing = false;
    at_.sent = {};
    enter(ForceState::Armed, doubted ? at_.withheld : ForceReason::Scene);
  }
}

void Safety::settingMoved(bool stiffness) HAPTICS_RT {
  at_.slewing = limits_.slew_time > 0.0;
  at_.slew_left = limits_.slew_time;
  if (stiffness) at_.passivity.share = 1.0;
}

void Safety::moved(const Pose& X_WD, double scale, double period) HAPTICS_RT {
  if (!limits_.guard_passivity) return;
  PassivityGuard guard{at_.passivity};
  guard.add(at_.sent, X_WD, scale, period);
  at_.passivity = guard.memory();
}

double Safety::strongest() const HAPTICS_RT {
  if (!(limits_.continuous_force < limits_.force) || at_.heat <= kWarm) return limits_.force;
  const double spared = std::min(1.0, (at_.heat - kWarm) / (1.0 - kWarm));
  return limits_.force + spared * (limits_.continuous_force - limits_.force);
}

Wrench Safety::pass(const Wrench& wanted, bool outside, double period) HAPTICS_RT {
  const double load = at_.sent.force.norm() / limits_.continuous_force;
  at_.heat += (load * load - at_.heat) * period / ForceLimits::kWarmUp;
  if (!mayBeFelt()) return {};
  // any doubt ends in zero, and in a new ramp
  if (!wanted.force.allFinite() || !wanted.torque.allFinite())
    at_.withheld = ForceReason::NotFinite;
  else if (!outside && at_.withheld == ForceReason::None)
    at_.withheld = ForceReason::Inside;
  if (at_.withheld != ForceReason::None && !fades(at_.withheld)) {
    enter(ForceState::Armed, at_.withheld);
    at_.gain = 0.0;
    at_.slewing = false;
    at_.sent = {};
    return {};
  }
  if (at_.withheld != ForceReason::None) enter(ForceState::Armed, at_.withheld);
  if (at_.state == ForceState::Armed && (at_.gain > 0.0 || at_.withheld != ForceReason::None)) {
    // what was felt dies away, whatever is wished for meanwhile
    const double left = at_.gain > 0.0 ? faded(at_.gain, period) / at_.gain : 0.0;
    at_.gain *= left;
    at_.sent.force *= left;
    at_.sent.torque *= left;
    at_.slewing = false;
    return at_.sent;
  }
  if (at_.state != ForceState::On) {
    enter(ForceState::Ramping, at_.reason);
    at_.gain = limits_.ramp_time > 0.0 ? std::min(1.0, at_.gain + period / limits_.ramp_time) : 1.0;
    if (at_.gain == 1.0) enter(ForceState::On, at_.reason);
  }

  Wrench wrench = saturated(wanted, strongest(), limits_.torque);
  wrench.force *= at_.gain;
  wrench.torque *= at_.gain;
  const double time = at_.slewing ? limits_.slew_time : limits_.rise_time;
  if (time > 0.0) {
    bool reached = true;
    const double share = period / time;
    wrench.force = approached(at_.sent.force, wrench.force, share * limits_.force, reached);
    wrench.torque = approached(at_.sent.torque, wrench.torque, share * limits_.torque, reached);
    // a proxy that the budget held back follows ticks later, and one that is brought out is set
    // down elsewhere: the wish may yet jump
    at_.slew_left -= period;
    at_.slewing = at_.slewing && (at_.slew_left > 0.0 || !reached);
  }
  at_.sent = wrench;
  return wrench;
}

}  // namespace haptics
