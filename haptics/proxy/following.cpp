// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/following.h"

#include <algorithm>
#include <cmath>

#include "haptics/collision/motion.h"
#include "haptics/solver/unconstrained_motion.h"

namespace haptics {
namespace {

/// m^2: squared radius of gyration that the coupling's own angular stiffness stands for; 0: it has
/// none, and the tool's inertia counts.
double squaredGyrationOf(const VirtualCoupling& coupling) HAPTICS_RT {
  const bool own = coupling.angular_stiffness > 0.0 && coupling.stiffness > 0.0;
  return own ? coupling.angular_stiffness / coupling.stiffness : 0.0;
}

MassMetric metricOf(const Scene& scene, const VirtualCoupling& coupling) HAPTICS_RT {
  const double squared_gyration = squaredGyrationOf(coupling);
  if (squared_gyration == 0.0) return scene.metric;
  // as well conditioned as the tool's own, however soft the spring
  const double radius = scene.tool.shell.radius;
  const double least = std::max(1e-6 * radius * radius, 1e-12);  // m^2
  return MassMetric{Mat3::Identity() * std::max(squared_gyration, least)};
}

}  // namespace

TickInput::TickInput(const Scene& in, double isovalue, const VirtualCoupling& spring,
                     const Pose& X_device, double seconds) HAPTICS_RT
    : scene{in},
      solid{in.field, isovalue},
      coupling{spring},
      X_WD{X_device},
      period{seconds},
      metric{metricOf(in, spring)} {}

Following::Following(const TickInput& given, Proxy& proxy, bool under_way) HAPTICS_RT
    : given_{given},
      proxy_{proxy},
      state_{proxy.following},
      search_{proxy.search} {
  // the filter compares distances by one metric
  const double squared_gyration = squaredGyrationOf(given.coupling);
  if (!(std::abs(squared_gyration - state_.squared_gyration) <= 1e-9 * squared_gyration))
    state_.filter = {};
  state_.squared_gyration = squared_gyration;
  if (state_.held) {
    Vec3 turn = proxy.turn;
    state_.catch_up.begin(unconstrainedMotion(proxy.X_WP, given.X_WD, turn), given.metric,
                          proxy.X_WP.linear(), given.X_WD.translation(), given.coupling.stiffness,
                          given.period);
  }
  state_.filter.begin(given.X_WD, proxy.X_WP, given.metric, given.radius(),
                      given.lengths().epsilon);
  if (!under_way) return;
  // what the search will come to is compared with the pose it left
  const double distance = distanceFrom(proxy.X_WP, proxy.turn);
  state_.filter.start(distance, distance);
}

double Following::distanceFrom(const Pose& X, Vec3 turn) const HAPTICS_RT {
  return given_.metric.whitened(unconstrainedMotion(X, given_.X_WD, turn), X.linear()).norm();
}

Following::Course Following::consider(const Arrival& here, const MotionRows& rows) HAPTICS_RT {
  if (state_.held) state_.catch_up.look(here.lag, here.whitened_lag);
  if (search_.fresh) {
    const double distance = here.whitened_lag.norm(), step = here.allowed.whitened.norm();
    if (const std::optional<Course> course = wait(distance, step)) return *course;
    judge(here, distance, step);
    search_.fresh = false;
  }
  if (search_.atTaken()) bear(here.allowed, rows);
  return waits_ ? Course::Over : Course::On;
}

/// Where to go if the filter would take the pose, and the force changes too fast on the way to it.
/// None if the proxy may take the pose, or if the energy allows no place to wait.
std::optional<Following::Course> Following::wait(double distance, double step) HAPTICS_RT {
  if (!state_.held || waits_ || search_.atTaken()) return {};
  if (!state_.filter.wouldTake(distance, step)) return {};
  const std::optional<CatchUp::Place> place = state_.catch_up.placeToWait();
  if (!place) return {};
  const Leg& leg = state_.catch_up.legs()[place->leg];
  const double advance = place->share * leg.advance;
  // the force has changed enough in this tick: what was taken stays
  if (place->leg == 0 && advance * given_.reachOf(leg.motion) < given_.lengths().least_way)
    return Course::Over;
  if (!state_.filter.mayWait(distanceFrom(moved(leg.X, leg.motion, advance), proxy_.turn)))
    return {};
  place_ = *place;
  waits_ = true;
  return Course::Back;
}

/// Takes the pose reached for the proxy if the filter lets it.
void Following::judge(const Arrival& here, double distance, double step) HAPTICS_RT {
  if (search_.atTaken())
    state_.filter.start(distance, step);
  else if (waits_ ? !state_.filter.takeOnTheWay(distance, step)
                  : !state_.filter.take(distance, step))
    return;
  if (state_.held) state_.catch_up.take();
  proxy_.X_WP = search_.X;
  proxy_.turn = here.turn;
  search_.take(proxy_.contacts);
}

/// Remembers what bears on the proxy at its pose.
void Following::bear(const ConstrainedMotion& allowed, const MotionRows& rows) HAPTICS_RT {
  proxy_.bearing.clear();
  for (std::size_t j = 0; j < static_cast<std::size_t>(allowed.active); ++j) {
    const MotionRow& row = rows[static_cast<std::size_t>(allowed.bearing[j])];
    // the metric is that of a mass of 1, so a reaction times the stiffness is a force
    proxy_.bearing.push({row.r_W, row.n_W, allowed.reaction[j] * given_.coupling.stiffness});
  }
}

Following::Limit Following::limit(const Arrival& here) const HAPTICS_RT {
  const bool bears = here.allowed.active > 0;
  if (!state_.held) return {.arrives = !bears};
  if (bears) return {.share = state_.catch_up.shareOf(here.allowed.whitened)};
  const Vector6& left = state_.catch_up.left();
  const bool arrives = left.isZero(0.0);
  return {.arrives = arrives,
          .way = arrives ? here.lag
                         : given_.metric.twist(here.whitened_lag - left, search_.X.linear())};
}

void Following::arrive(const Twist& way) HAPTICS_RT {
  const double distance = given_.metric.whitened(way, proxy_.X_WP.linear()).norm();
  state_.filter.start(distance, distance);
  state_.filter.take(0.0, 0.0);
  proxy_.X_WP = given_.X_WD;
  proxy_.turn.setZero();
  proxy_.bearing.clear();
}

void Following::go(const Twist& motion, double advance, bool bears) HAPTICS_RT {
  if (!state_.held) return;
  state_.catch_up.go({.X = search_.X, .motion = motion, .advance = advance, .bears = bears},
                     advance * given_.metric.whitened(motion, search_.X.linear()),
                     search_.atTaken());
}

void Following::shorten(double advance) HAPTICS_RT {
  if (state_.held && !waits_) state_.catch_up.shorten(advance);
}

bool Following::end(FollowingState& state, const Twist& lag, bool in_contact,
                    bool followed) HAPTICS_RT {
  if (state.held) {
    state.catch_up.end(lag, followed);
  } else if (in_contact) {
    state.held = followed = true;
    state.catch_up.hold(lag);
  }
  return followed;
}

}  // namespace haptics
