// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/closed_loop.h"

#include "haptics/coupling/passivity.h"

namespace haptics {

Expected<void> ClosedLoop::run(const Hand& hand, std::int64_t ticks,
                               const std::function<bool(const TraceRow&)>& each) {
  // what a run changes is its own, so that the next is the same
  Grip device = grip;
  Linkage link = linkage;
  device.X_WD = link.handleAt(hand.at(0.0));
  Pose X_WD = link.read(device.X_WD);
  const std::optional<Pose> start = legalPoseNear(*scene, isovalue, X_WD);
  if (!start)
    return tl::unexpected(Error{Error::Kind::Unsupported,
                                "The tool starts inside the solid and there is no room for it "
                                "within 50 mm; start the hand outside or raise the isovalue."});
  if (on_start) on_start(*start);
  Proxy proxy{*scene, *start};
  Safety safety{limits};
  PassivityController controller{passivity_damping, device.gyration, link.torque};
  PassivityObserver observer;  // at the handle, of what really acts there
  Wrench held;
  for (std::int64_t n = 0; n < ticks; ++n) {
    const double time = double(n) * period;
    const Pose X_WH_before = device.X_WD, X_WD_before = X_WD;
    // the hand moves the device against the force that was sent last, which is held between ticks
    if (hand_is_device)
      device.X_WD = hand.at(time);
    else if (n > 0)
      device.advance(link.handleAt(hand.at(time)), held, period);
    observer.add(held, motionBetween(X_WH_before, device.X_WD));
    X_WD = link.read(device.X_WD);

    Budget budget = Budget::counted(kTickWork);
    const std::int64_t begun = Budget::threadTime();
    safety.begin({.armed = true, .ready = true});
    safety.moved(X_WD, 1.0, period);
    VirtualCoupling felt = coupling;
    felt.stiffness *= safety.stiffnessShare();
    felt.angular_stiffness *= safety.stiffnessShare();
    const TickResult result = tick(*scene, isovalue, felt, X_WD, proxy, budget, period);
    Wrench wanted = result.wrench_W;
    if (damping > 0.0 || passivity_damping > 0.0) {
      const Twist motion = motionBetween(X_WD_before, X_WD);
      if (damping > 0.0) wanted = damped(wanted, motion, period, damping, device.gyration);
      if (passivity_damping > 0.0) wanted = controller.pass(wanted, motion, period);
    }
    const Wrench sent = safety.pass(wanted, result.outside, period);
    controller.sent(sent);
    const std::int64_t ended = Budget::threadTime();
    held = link.carry(sent, device.X_WD);
    if (!each({time, X_WD, proxy.X_WP, sent, result.wrench_W, result.contacts, ended - begun,
               device.X_WD, observer.energy(), budget.cutAt(), proxy.bearing, safety.state(),
               safety.stiffnessShare()}))
      break;
  }
  return {};
}

}  // namespace haptics
