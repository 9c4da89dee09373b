// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/coupling/safety.h"

#include <algorithm>

#include "haptics/coupling/virtual_coupling.h"

namespace haptics {
namespace {

constexpr double kFadeTime = 0.05;  // s from full to zero when the proxy was left inside

/// `last` moved towards `wanted` by at most `step`; `reached` becomes false if that was not enough.
Vec3 approached(const Vec3& last, const Vec3& wanted, double step, bool& reached) HAPTICS_RT {
  const Vec3 change = wanted - last;
  const double size = change.norm();
  if (size <= step) return wanted;
  reached = false;
  return last + change * (step / size);
}

}  // namespace

void Safety::arm() HAPTICS_RT {
  if (at_.state != ForceState::Off) return;
  at_.gain = 0.0;
  at_.state = ForceState::Ramping;
}

void Safety::restart() HAPTICS_RT {
  if (at_.state == ForceState::Off) return;
  at_.gain = 0.0;
  at_.slewing = false;
  at_.sent = {};
  at_.state = ForceState::Ramping;
}

Wrench Safety::pass(const Wrench& wanted, bool outside, double period) HAPTICS_RT {
  if (at_.state == ForceState::Off) {
    at_.gain = 0.0;
    at_.sent = {};
    return {};
  }
  // any doubt ends in zero, and in a new ramp
  if (!wanted.force.allFinite() || !wanted.torque.allFinite()) {
    restart();
    return {};
  }
  if (!outside) at_.state = ForceState::Recovering;
  switch (at_.state) {
    case ForceState::Recovering:
      at_.gain = std::max(0.0, at_.gain - period / kFadeTime);
      if (outside && at_.gain == 0.0) at_.state = ForceState::Ramping;
      break;
    case ForceState::Ramping:
      at_.gain =
          limits_.ramp_time > 0.0 ? std::min(1.0, at_.gain + period / limits_.ramp_time) : 1.0;
      if (at_.gain == 1.0) at_.state = ForceState::On;
      break;
    case ForceState::On:
    case ForceState::Off:
      break;
  }

  Wrench wrench = saturated(wanted, limits_.force, limits_.torque);
  wrench.force *= at_.gain;
  wrench.torque *= at_.gain;
  if (at_.slewing) {
    bool reached = true;
    const double share = period / limits_.slew_time;
    wrench.force = approached(at_.sent.force, wrench.force, share * limits_.force, reached);
    wrench.torque = approached(at_.sent.torque, wrench.torque, share * limits_.torque, reached);
    // a proxy that the budget held back follows ticks later, and one that is brought out is set
    // down elsewhere: the wish may yet jump
    at_.slew_left -= period;
    at_.slewing = at_.slew_left > 0.0 || !reached || at_.state == ForceState::Recovering;
  }
  at_.sent = wrench;
  return wrench;
}

}  // namespace haptics
