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
  if (state_ != ForceState::Off) return;
  gain_ = 0.0;
  state_ = ForceState::Ramping;
}

void Safety::restart() HAPTICS_RT {
  if (state_ == ForceState::Off) return;
  gain_ = 0.0;
  slewing_ = false;
  sent_ = {};
  state_ = ForceState::Ramping;
}

Wrench Safety::pass(const Wrench& wanted, bool outside, double period) HAPTICS_RT {
  if (state_ == ForceState::Off) {
    gain_ = 0.0;
    sent_ = {};
    return {};
  }
  // any doubt ends in zero, and in a new ramp
  if (!wanted.force.allFinite() || !wanted.torque.allFinite()) {
    restart();
    return {};
  }
  if (!outside) state_ = ForceState::Recovering;
  switch (state_) {
    case ForceState::Recovering:
      gain_ = std::max(0.0, gain_ - period / kFadeTime);
      if (outside && gain_ == 0.0) state_ = ForceState::Ramping;
      break;
    case ForceState::Ramping:
      gain_ = limits_.ramp_time > 0.0 ? std::min(1.0, gain_ + period / limits_.ramp_time) : 1.0;
      if (gain_ == 1.0) state_ = ForceState::On;
      break;
    case ForceState::On:
    case ForceState::Off:
      break;
  }

  Wrench wrench = saturated(wanted, limits_.force, limits_.torque);
  wrench.force *= gain_;
  wrench.torque *= gain_;
  if (slewing_) {
    bool reached = true;
    const double share = period / limits_.slew_time;
    wrench.force = approached(sent_.force, wrench.force, share * limits_.force, reached);
    wrench.torque = approached(sent_.torque, wrench.torque, share * limits_.torque, reached);
    // a proxy that the budget held back follows ticks later, and one that is brought out is set
    // down elsewhere: the wish may yet jump
    slew_left_ -= period;
    slewing_ = slew_left_ > 0.0 || !reached || state_ == ForceState::Recovering;
  }
  sent_ = wrench;
  return wrench;
}

}  // namespace haptics
