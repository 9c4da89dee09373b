// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/collision/motion_rows.h"
#include "haptics/collision/second_look.h"
#include "haptics/collision/sweep.h"
#include "haptics/core/geometry.h"
#include "haptics/proxy/catch_up.h"
#include "haptics/proxy/pose_filter.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// State of the search for a legal pose, after a moved isovalue left the proxy inside the solid.
/// The proxy does not move while the search moves an invisible trial pose. The proxy takes only a
/// legal pose, so it never goes deeper.
struct Recovery {
  bool active = false;
  double time = 0.0;             ///< s since the proxy was found inside
  int candidate = 0;             ///< next pose of the search around the proxy
  Pose X_WT = Pose::Identity();  ///< the trial pose
};

/// A search under way: sub-steps from the proxy's pose on. If a tick ends in the middle of it, the
/// next tick continues it. The proofs about a motion are kept, so a tool with very many points in
/// contact moves too, though not in every tick. The proxy stays at the last accepted pose.
struct Search {
  enum class Stage : std::uint8_t {
    Done,   ///< no sub-step under way
    Look,   ///< finds the points near the surface at X, and the next motion
    Reach,  ///< finds the points that the motion could bring to the surface
    Sweep   ///< finds how far the tool can go along the motion
  };
  Stage stage = Stage::Done;
  Pose X = Pose::Identity();  ///< pose reached by the sub-steps; the way to it is proven free
  bool fresh = true;          ///< X has not been checked yet

  Twist motion;         ///< motion of the sub-step, in unit time
  double length = 0.0;  ///< m: way of the farthest point
  bool whole = false;   ///< the motion ends at X_goal
  bool bears = false;   ///< contacts shaped the motion
  Pose X_goal = Pose::Identity();

  // the step that led to X, which is halved if X is inside
  Pose X_before = Pose::Identity();
  double advance = 0.0;
  int halvings = 0;

  double trust = INFINITY;  ///< m: longest step to try in this search
  int tries = 0;            ///< motions in this search that contacts shaped or stopped

  // since the last accepted pose
  double way = 0.0, turned = 0.0;  ///< m, rad
  Contacts contacts_taken;         ///< the contacts at that pose
  bool atTaken() const HAPTICS_RT { return way == 0.0 && turned == 0.0; }
  /// The proxy takes X, with these contacts.
  void take(const Contacts& contacts) HAPTICS_RT {
    way = turned = 0.0;
    contacts_taken = contacts;
  }

  template <class P>
  void begin(const P& proxy) HAPTICS_RT {
    stage = Stage::Look;
    X = proxy.X_WP;
    fresh = true;
    advance = 0.0;
    trust = INFINITY;
    tries = 0;
    take(proxy.contacts);
  }
};

/// A contact that bears force on the tool.
struct BearingContact {
  Vec3 r_W = Vec3::Zero();  ///< the point about the tool's origin, in W [m]
  Vec3 n_W = Vec3::Zero();  ///< unit normal, out of the solid
  double push = 0.0;        ///< N, force along the normal, from the coupling's stiffness
};
using Bearing = FixedVector<BearingContact, 6>;

/// What Following remembers between ticks.
struct FollowingState {
  PoseFilter filter;
  /// m^2: of the metric in the last tick, by which the filter measures: angular stiffness over
  /// stiffness; 0: the tool's own
  double squared_gyration = 0.0;
  /// True from contact until the proxy is at the device again. While true, the proxy approaches the
  /// device at a limited speed.
  bool held = false;
  CatchUp catch_up;  ///< while held
};

/// The proxy and its memory between ticks. The constructor allocates all memory.
struct Proxy {
  Proxy(const Scene& scene, const Pose& X_start)
      : X_WP{X_start},
        clearance{scene.tree, scene.lengths.band},
        sweep{scene.tool.shell.points.size()} {}

  Pose X_WP;
  Vec3 turn = Vec3::Zero();  ///< unwrapped rotation from proxy to device [rad]
  Contacts contacts;         ///< found by Sweep; they constrain the next motion
  Bearing bearing;           ///< contacts that bear force on it at X_WP
  Clearance clearance;
  SurfaceRows surface;  ///< rows of the points near the surface
  Sweep sweep;
  Search search;
  FollowingState following;
  Recovery recovery;
  double isovalue = std::numeric_limits<double>::quiet_NaN();  ///< isovalue of the last tick
  /// Does the work that ticks leave out; null except in studies and tests.
  SecondLook* second_look = nullptr;

  /// Keeps the pose and the unwrapped turn, and resets the rest to the state of a new proxy.
  void forget() HAPTICS_RT {
    contacts.clear();
    bearing.clear();
    clearance.forget();
    search = {};
    following.filter = {};
    following.held = false;
    following.catch_up = {};
    recovery = {};
    isovalue = std::numeric_limits<double>::quiet_NaN();
  }
  /// The same for another isovalue, but what the hand feels stays what it is until the proxy has
  /// caught up.
  void meet(double other_isovalue) HAPTICS_RT {
    const bool held = following.held;
    const CatchUp catch_up = following.catch_up;
    forget();
    isovalue = other_isovalue;
    following.held = held;
    following.catch_up = catch_up;
    following.catch_up.forget();
  }
};

}  // namespace haptics
