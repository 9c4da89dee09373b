// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/tick.h"

#include <algorithm>

#include "app/study/reference/motion.h"

namespace reference {
namespace {

/// The contacts after a tick that met nothing: survivors, seen from the new pose.
std::vector<Contact> renewed(const Scene& scene, const Pose& X_WP,
                             const std::vector<Contact>& contacts) {
  std::vector<Contact> result;
  for (const Contact& contact : contacts) {
    const Contact now = contactOf(scene.solid, scene.shell, X_WP, contact.point);
    if (!now.n_W.isZero()) result.push_back(now);
  }
  return result;
}

}  // namespace

std::vector<Row> rowsOf(const std::vector<Contact>& contacts, const Choices& choices) {
  std::vector<Row> rows;
  for (const Contact& contact : contacts) {
    Row row{.n_W = contact.n_W, .r_W = contact.r_W};
    if (choices.variant == Variant::Charitable)
      row.bias = std::clamp(choices.epsilon / 2.0 - contact.gap, 0.0, choices.feature);
    rows.push_back(row);
  }
  return rows;
}

Wrench pull(const Scene& scene, const Pose& X_WP, const Pose& X_WD) {
  const Twist left = unconstrainedMotion(X_WP, X_WD);
  const Mat3 K_angular =
      scene.angular_stiffness > 0.0
          ? Mat3{Mat3::Identity() * scene.angular_stiffness}
          : Mat3{massMetric(X_WP, scene.shell.inertia).inertia_W * scene.stiffness};
  return {.force = -scene.stiffness * left.linear, .torque = -K_angular * left.angular};
}

Wrench tick(const Scene& scene, const Pose& X_WD, State& state) {
  const Solid& solid = scene.solid;
  // 1  where the proxy would go if nothing were in the way
  const Twist free = unconstrainedMotion(state.X_WP, X_WD);
  // 2  which of its contacts still stand in that way
  state.contacts = prune(solid, scene.shell, state.contacts, state.X_WP, free);
  // 3  the nearest motion that they allow
  const Twist allowed =
      constrainedMotion(free, rowsOf(state.contacts, solid.choices()),
                        massMetric(state.X_WP, scene.shell.inertia), &state.pivots);
  // 4  how far along it the tool gets
  const FirstHit hit = firstHit(solid, scene.shell, state.X_WP, allowed);
  // 5  go there, and keep what was met
  state.X_WP = moved(state.X_WP, allowed, hit.t);
  if (hit.met)
    state.contacts = contactsAt(solid, scene.shell, state.X_WP, hit.point);
  else if (solid.choices().keep_survivors)
    state.contacts = renewed(scene, state.X_WP, state.contacts);
  else
    state.contacts.clear();
  // 6  what the hand feels
  return pull(scene, state.X_WP, X_WD);
}

}  // namespace reference
