// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/core/geometry.h"
#include "haptics/scene.h"
#include "haptics/servo/acceptance.h"

namespace haptics {

/// How the proxy is brought outside after the isovalue left it inside: the proxy stays where it is
/// while a trial pose, invisible, looks for a way out; only a legal pose is taken. So what is seen
/// and felt of it never gets deeper.
struct Recovery {
  bool active = false;
  int ticks = 0;                 ///< since the proxy was found inside
  int candidate = 0;             ///< of the search around
  Pose X_WT = Pose::Identity();  ///< the trial pose
};

/// The proxy and what it remembers from tick to tick. Everything is allocated when it is made.
struct Proxy {
  Proxy(const Scene& scene, const Pose& X_start)
      : X_WP{X_start}, clearance{scene.tool.shell.points.size()} {}

  Pose X_WP;
  Vec3 turn = Vec3::Zero();  ///< unwrapped rotation from proxy to device [rad]
  Contacts contacts;         ///< met by sweep; constrain the next motion
  Clearance clearance;
  Acceptance acceptance;
  Recovery recovery;
  double isovalue = std::numeric_limits<double>::quiet_NaN();  ///< of the last tick
};

}  // namespace haptics
