// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/tick.h"

#include <limits>

#include "haptics/proxy/following.h"
#include "haptics/proxy/recovery.h"
#include "haptics/proxy/sub_steps.h"
#include "haptics/solver/unconstrained_motion.h"

namespace haptics {
namespace {

/// Moves the proxy towards the device as far as the solid allows.
void moveProxy(const TickInput& given, Proxy& proxy, Budget& budget,
               TickResult& result) HAPTICS_RT {
  SubSteps sub_step{given, proxy, budget};
  // a step that is not done has ended the sub-step, or is cut
  while (sub_step.next()) {
    if (sub_step.begins()) {
      // 1  where the proxy would go if nothing were in the way
      sub_step.aim();
      // 2  which of its contacts still stand in that way, and which points are near the surface
      if (!sub_step.findContacts()) continue;
      // 3  the nearest motion that they allow
      if (!sub_step.constrain()) continue;
      //    whether the proxy takes the pose that it has got to, and how far it goes from there
      if (!sub_step.follow()) continue;
    }
    // 4  how far along it the tool gets
    if (!sub_step.sweep()) continue;
    // 5  go there, and keep what was met
    sub_step.go();
  }
  sub_step.end(result);
}

/// 6  what the hand feels; in free space exactly nothing
void pull(const TickInput& given, Proxy& proxy, TickResult& result) HAPTICS_RT {
  if (proxy.X_WP.matrix() == given.X_WD.matrix()) {
    proxy.following.held = false;
    proxy.turn.setZero();
    return;
  }
  proxy.turn = unwrappedTurn(proxy.X_WP, given.X_WD, proxy.turn);
  const Twist lag{given.X_WD.translation() - proxy.X_WP.translation(), proxy.turn};
  result.followed = Following::end(proxy.following, lag, result.contacts > 0, result.followed);
  const Mat3 R = proxy.X_WP.linear();
  result.wrench_W = given.coupling.pull(proxy.X_WP, given.X_WD, -proxy.turn,
                                        R * given.scene.metric.inertia() * R.transpose());
}

}  // namespace

TickResult tick(const Scene& scene, double isovalue, const VirtualCoupling& coupling,
                const Pose& X_WD, Proxy& proxy, Budget& budget, double period) HAPTICS_RT {
  TickResult result;
  if (!X_WD.matrix().allFinite()) {
    // nothing is known of the hand: no number, which safety turns into no force
    result.wrench_W.force.setConstant(std::numeric_limits<double>::quiet_NaN());
    result.outside = !proxy.recovery.active;
    return result;
  }
  if (isovalue != proxy.isovalue) proxy.meet(isovalue);
  const TickInput given{scene, isovalue, coupling, X_WD, period};
  if (!proxy.recovery.active) moveProxy(given, proxy, budget, result);
  result.contacts = static_cast<int>(proxy.bearing.size());
  if (!result.outside || proxy.recovery.active) {
    // even when it succeeds at once: the force fades before it follows the proxy elsewhere
    result.outside = false;
    recover(scene, given.solid, proxy, period, budget);
  }
  pull(given, proxy, result);
  return result;
}

}  // namespace haptics
