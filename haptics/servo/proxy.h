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
#include "haptics/scene/scene.h"
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

/// A sub-step under way. When the budget cuts a tick in the middle of one, it goes on in the next:
/// what has been proven about a motion is not thrown away, so that a tool with very many points in
/// contact gets on, if not in every tick. The proxy stays at the last pose that was taken.
struct Search {
  enum class Stage : std::uint8_t {
    Done,   ///< none under way
    Look,   ///< at a pose reached: what is near it, and where to go
    Reach,  ///< what could the motion bring to the surface
    Sweep   ///< how far along the motion the tool gets
  };
  Stage stage = Stage::Done;
  Pose X = Pose::Identity();  ///< where the sub-steps have got to; proven along the way there
  bool fresh = true;          ///< X has not been judged yet

  Twist motion;         ///< of the sub-step, in unit time
  double length = 0.0;  ///< m: of its farthest point
  bool whole = false;   ///< it leads to X_goal without a bend
  bool bears = false;   ///< contacts shaped it
  Pose X_goal = Pose::Identity();

  // the step that led to X, to be halved if X is inside after all
  Pose X_before = Pose::Identity();
  double advance = 0.0;
  int halvings = 0;

  double trust = INFINITY;  ///< m: the longest step worth trying in this search

  // since the pose that was taken last
  double way = 0.0, turned = 0.0;  ///< m, rad
  Contacts contacts_taken;         ///< the contacts when it was taken
  bool atTaken() const HAPTICS_RT { return way == 0.0 && turned == 0.0; }

  template <class P>
  void begin(const P& proxy) HAPTICS_RT {
    stage = Stage::Look;
    X = proxy.X_WP;
    fresh = true;
    advance = 0.0;
    trust = INFINITY;
    way = turned = 0.0;
    contacts_taken = proxy.contacts;
  }
};

/// A row that bears on the tool: a contact as the hand feels it.
struct BearingContact {
  Vec3 r_W = Vec3::Zero();  ///< the point about the tool's origin, in W [m]
  Vec3 n_W = Vec3::Zero();  ///< unit normal, out of the solid
  double push = 0.0;        ///< N, along the normal, by the coupling's stiffness
};
using Bearing = FixedVector<BearingContact, 6>;

/// The proxy and what it remembers from tick to tick. Everything is allocated when it is made.
struct Proxy {
  Proxy(const Scene& scene, const Pose& X_start)
      : X_WP{X_start}, clearance{scene.tree}, sweep{scene.tool.shell.points.size()} {}

  Pose X_WP;
  Vec3 turn = Vec3::Zero();  ///< unwrapped rotation from proxy to device [rad]
  Contacts contacts;         ///< met by sweep; constrain the next motion
  Bearing bearing;           ///< rows that bear on it at X_WP
  Clearance clearance;
  SurfaceRows surface;  ///< of the points near the surface
  Sweep sweep;
  Search search;
  Acceptance acceptance;
  Recovery recovery;
  double isovalue = std::numeric_limits<double>::quiet_NaN();  ///< of the last tick
  /// The surface bore on it since it was last at the device: until it is there again, it follows
  /// no faster than tick() lets it.
  bool held = false;
  Twist behind;  ///< while held: the motion to the device after the last tick in which it followed
  int ticks_behind = 0;  ///< since then
  /// Looks at what this proxy's ticks leave out; null but in studies and tests.
  SecondLook* second_look = nullptr;

  /// Keeps where it is and how it is turned, and nothing else: as if it were made there.
  void forget() HAPTICS_RT {
    contacts.clear();
    bearing.clear();
    clearance.forget();
    search = {};
    acceptance = {};
    recovery = {};
    isovalue = std::numeric_limits<double>::quiet_NaN();
    held = false;
    ticks_behind = 0;
  }
};

}  // namespace haptics
