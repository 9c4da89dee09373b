// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/study/reference/collision.h"
#include "app/study/reference/projection.h"
#include "app/study/reference/solid.h"

namespace reference {

/// What is touched, with what, and through which spring.
struct Scene {
  Solid solid;
  haptics::PointShell shell;
  double stiffness = 1000.0;       ///< N/m: the scalar k of (5), for m = 1
  double angular_stiffness = 0.0;  ///< N·m/rad; 0 takes k times the tool's inertia, as (5) does
};

/// What one tick leaves to the next.
struct State {
  Pose X_WP = Pose::Identity();
  std::vector<Contact> contacts;
  std::int64_t pivots = 0;  ///< of all projections so far
};

/// The rows of (4) for these contacts; with Charitable, biased back to half of epsilon.
std::vector<Row> rowsOf(const std::vector<Contact>& contacts, const Choices& choices);

/// Step 6, (5): the wrench on the hand, which pulls the device towards the proxy. The paper's a
/// is twice the motion; k takes the factor in.
Wrench pull(const Scene& scene, const Pose& X_WP, const Pose& X_WD);

/// One haptic update: the six steps of [Chan 2011], 2.1, in their order. A hit at t = 0 leaves the
/// pose as it is, to the bit.
Wrench tick(const Scene& scene, const Pose& X_WD, State& state);

}  // namespace reference
