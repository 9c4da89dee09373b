// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/proxy/proxy.h"
#include "haptics/solver/constrained_motion.h"

namespace haptics {

/// What is given in a tick, and what follows from it at once.
struct TickInput {
  TickInput(const Scene& scene, double isovalue, const VirtualCoupling& coupling, const Pose& X_WD,
            double period) HAPTICS_RT;

  const Scene& scene;
  const Isosurface solid;
  const VirtualCoupling& coupling;
  const Pose& X_WD;
  const double period;  ///< s
  /// What is near: by the energy of the coupling over its stiffness. A proxy that were near by
  /// another measure would give way to a contact against the spring, and so give energy to the
  /// hand.
  const MassMetric metric;
  /// m: of the farthest point of the tool.
  double radius() const HAPTICS_RT { return scene.tool.shell.radius; }
  const Tolerances& lengths() const HAPTICS_RT { return scene.lengths; }
  /// How far the farthest point of the tool travels at most [m].
  double reachOf(const Twist& motion) const HAPTICS_RT {
    return motion.linear.norm() + motion.angular.norm() * radius();
  }
};

/// The pose that the search has got to, and the motions from it.
struct Arrival {
  Twist lag;                               ///< to the device, nothing in the way
  Vec3 turn = Vec3::Zero();                ///< unwrapped, of the lag [rad]
  Vector6 whitened_lag = Vector6::Zero();  ///< by the metric
  ConstrainedMotion allowed;               ///< towards the device, as contacts allow
};

/// How the proxy follows the device in a tick: which of the poses that the search gets to it takes,
/// and how far it may go. A filter decides whether a pose is better than those before. A proxy that
/// a surface held catches up with the device at a limited speed, and where the force would change
/// too fast on the way, it waits at a place between.
class Following {
 public:
  /// `under_way`: the search goes on from an earlier tick, at a pose that the proxy has not taken.
  Following(const TickInput& given, Proxy& proxy, bool under_way) HAPTICS_RT;

  /// Considers the pose that the search has got to.
  enum class Course {
    On,    ///< the search goes on from here
    Back,  ///< the proxy has to wait on the way: the search goes to place() first
    Over   ///< the search has ended
  };
  Course consider(const Arrival& here, const MotionRows& rows) HAPTICS_RT;
  /// Where to wait: so far along a leg of the way since the pose that was taken last.
  const CatchUp::Place& place() const HAPTICS_RT { return place_; }

  /// How far to go from the pose considered.
  struct Limit {
    double share = 1.0;             ///< of the allowed motion
    bool arrives = false;           ///< at the device: neither contacts nor the speed limit the way
    std::optional<Twist> way = {};  ///< instead of the allowed motion
  };
  Limit limit(const Arrival& here) const HAPTICS_RT;

  /// Takes the device's pose, to which the whole way is free.
  void arrive(const Twist& way) HAPTICS_RT;
  /// The search goes along a motion from the pose considered.
  void go(const Twist& motion, double advance, bool bears) HAPTICS_RT;
  /// The motion went no further than this.
  void shorten(double advance) HAPTICS_RT;

  /// Ends the tick, with the motion that is left to the device. Returns TickResult::followed.
  static bool end(FollowingState& state, const Twist& lag, bool in_contact,
                  bool followed) HAPTICS_RT;

 private:
  double distanceFrom(const Pose& X, Vec3 turn) const HAPTICS_RT;
  std::optional<Course> wait(double distance, double step) HAPTICS_RT;
  void judge(const Arrival& here, double distance, double step) HAPTICS_RT;
  void bear(const ConstrainedMotion& allowed, const MotionRows& rows) HAPTICS_RT;

  const TickInput& given_;
  Proxy& proxy_;
  FollowingState& state_;
  Search& search_;
  CatchUp::Place place_;
  bool waits_ = false;  ///< the pose is a place to wait, on the way to a better one
};

}  // namespace haptics
