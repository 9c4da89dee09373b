// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/tick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/collision/motion.h"
#include "haptics/collision/motion_rows.h"
#include "haptics/collision/prune.h"
#include "haptics/collision/sweep.h"
#include "haptics/servo/recovery.h"
#include "haptics/solver/constrained_motion.h"
#include "haptics/solver/unconstrained_motion.h"

namespace haptics {
namespace {

constexpr int kSubSteps = 5;           // moves, and blocked tries, in one tick
constexpr double kLargestTurn = 0.3;   // rad in one sub-step
constexpr std::size_t kManyNear = 96;  // points near the path: then the step is kept short

/// How far the farthest point of the tool travels at most [m].
double reachOf(const Twist& motion, double radius) HAPTICS_RT {
  return motion.linear.norm() + motion.angular.norm() * radius;
}

Twist scaled(const Twist& motion, double factor) HAPTICS_RT {
  return {motion.linear * factor, motion.angular * factor};
}

/// One tick at work. The members are what its sub-steps share.
class Tick {
 public:
  Tick(const Scene& scene, double isovalue, const Pose& X_WD, Proxy& proxy,
       Budget& budget) HAPTICS_RT : scene_{scene},
                                    solid_{scene.field, isovalue},
                                    X_WD_{X_WD},
                                    proxy_{proxy},
                                    budget_{budget},
                                    X_{proxy.X_WP},
                                    taken_turn_{proxy.turn},
                                    radius_{scene.tool.shell.radius} {}

  /// Takes sub-steps until the proxy has arrived, is held, or the budget is used up.
  void run(TickResult& result) HAPTICS_RT {
    proxy_.acceptance.begin(X_WD_, radius_, 0.5 * lengths().epsilon);
    double trust = INFINITY;  // m: the longest step worth trying
    bool fresh = true;        // X_ has not been judged yet
    for (int tries = 0; tries <= kSubSteps; ++tries) {
      // 1  where the proxy would go if nothing were in the way
      Vec3 turn = proxy_.turn;
      const Twist free = unconstrainedMotion(X_, X_WD_, turn);
      const double distance = scene_.metric.whitened(free, X_.linear()).norm();
      const Twist aimed = limited(free);

      // 2  which of its contacts still stand in that way, and which points are near the surface
      if (fresh)
        prune(solid_, scene_.tool.shell, X_, free, lengths().epsilon, proxy_.contacts, budget_);
      const Clearance::Verdict verdict =
          proxy_.clearance.collect(solid_, scene_.tool.shell, X_, lengths().band, budget_);
      if (verdict == Clearance::Verdict::Inside) result.outside = false;
      if (verdict != Clearance::Verdict::Legal) break;
      gatherRows(solid_, proxy_.clearance, proxy_.contacts, lengths(), rows_, budget_);

      // 3  the nearest motion that leaves every contact its room
      ConstrainedMotion allowed =
          constrainedMotion(aimed, {rows_.begin(), rows_.size()}, scene_.metric, X_.linear());
      const double step = allowed.whitened.norm();
      if (fresh) judge(tries == 0, distance, step, turn);
      fresh = false;
      if (atTaken()) result.contacts = allowed.active;
      if (tries == kSubSteps || !budget_.left()) break;
      double length = reachOf(allowed.twist, radius_);
      // in free space even the last billionth of a metre is gone
      if (length == 0.0 || (allowed.active > 0 && length < 0.02 * lengths().epsilon)) break;
      const bool unhindered = allowed.active == 0 && aimed.linear == free.linear &&
                              aimed.angular == free.angular && length <= trust;

      // 4  how far along it the tool gets
      Twist motion = length > trust ? scaled(allowed.twist, trust / length) : allowed.twist;
      length = std::min(length, trust);
      if (!findNear(motion, length)) break;
      const bool whole =
          unhindered && motion.linear == free.linear && motion.angular == free.angular;
      const Impact impact = sweep(solid_, proxy_.clearance, X_, motion, lengths(), budget_);
      double advance = impact.time;
      if (impact.time < 1.0)
        advance = std::max(0.0, impact.time - 0.02 * lengths().epsilon / length);

      // 5  go there, and keep what stood in the way
      Pose X_next = whole && advance == 1.0 ? X_WD_ : moved(X_, motion, advance);
      for (int halving = 0; advance > 0.0 && !verified(X_next); ++halving) {
        advance = halving < 5 ? 0.5 * advance : 0.0;
        X_next = moved(X_, motion, advance);
      }
      if (advance * length < 0.05 * lengths().rest_gap && advance < 1.0) {
        // blocked: the exact normal of what blocks becomes a contact, or the step gets shorter
        if (!impact.met || !keep(impact.contact)) trust = 0.25 * length;
        if (trust < 0.02 * lengths().epsilon) break;
        continue;
      }
      travel(motion, advance);
      X_ = X_next;
      trust = advance < 1.0 ? 3.0 * advance * length : 2.0 * trust;
      fresh = true;
    }
    settle();
    if (budget_.cut()) result.cut = true;
  }

 private:
  const Tolerances& lengths() const HAPTICS_RT { return scene_.lengths; }

  /// The motion, shortened to what one sub-step may cover.
  Twist limited(const Twist& free) const HAPTICS_RT {
    double factor = 1.0;
    const double length = reachOf(free, radius_), angle = free.angular.norm();
    if (length > lengths().step_free) factor = lengths().step_free / length;
    if (angle * factor > kLargestTurn) factor = kLargestTurn / angle;
    return factor < 1.0 ? scaled(free, factor) : free;
  }

  /// Collects the points the motion could bring to the surface; shortens it where they are many.
  bool findNear(Twist& motion, double& length) HAPTICS_RT {
    if (length <= lengths().band) return true;  // collected already
    auto verdict = proxy_.clearance.collect(solid_, scene_.tool.shell, X_, length, budget_);
    if (verdict == Clearance::Verdict::Legal && proxy_.clearance.size() > kManyNear &&
        length > lengths().step_near) {
      motion = scaled(motion, lengths().step_near / length);
      length = lengths().step_near;
      verdict = proxy_.clearance.collect(solid_, scene_.tool.shell, X_, length, budget_);
    }
    return verdict == Clearance::Verdict::Legal;
  }

  /// Every point that could have reached the surface is outside, in double.
  bool verified(const Pose& X) HAPTICS_RT {
    for (std::size_t i = 0; i < proxy_.clearance.size(); ++i) {
      budget_.spend();
      const auto point = static_cast<std::size_t>(proxy_.clearance.near(i).point);
      if (solid_.inside(X * scene_.tool.shell.points[point])) return false;
    }
    return true;
  }

  /// Adds a contact; false if its point is one already, or it has no normal.
  bool keep(const Contact& contact) HAPTICS_RT {
    if (contact.n_W.isZero()) return false;
    for (const Contact& known : proxy_.contacts)
      if (known.point == contact.point && known.n_W.dot(contact.n_W) > 0.9999) return false;
    return proxy_.contacts.push(contact);
  }

  void travel(const Twist& motion, double share) HAPTICS_RT {
    const double way = motion.linear.norm() * share, turned = motion.angular.norm() * share;
    proxy_.clearance.moved(way, turned);
    way_since_taken_ += way;
    turn_since_taken_ += turned;
  }

  /// Takes the pose X_ for the proxy if the filter lets it.
  void judge(bool start, double distance, double step, const Vec3& turn) HAPTICS_RT {
    if (start)
      proxy_.acceptance.start(distance, step);
    else if (!proxy_.acceptance.take(distance, step, 0.002 * lengths().epsilon))
      return;
    proxy_.X_WP = X_;
    taken_turn_ = turn;
    way_since_taken_ = turn_since_taken_ = 0.0;
    taken_contacts_ = proxy_.contacts;
  }
  bool atTaken() const HAPTICS_RT { return way_since_taken_ == 0.0 && turn_since_taken_ == 0.0; }

  /// Goes back to the pose that was taken last; the way back is motion too.
  void settle() HAPTICS_RT {
    proxy_.turn = taken_turn_;
    if (atTaken()) return;
    proxy_.clearance.moved(way_since_taken_, turn_since_taken_);
    proxy_.contacts = taken_contacts_;
  }

  const Scene& scene_;
  const Isosurface solid_;
  const Pose& X_WD_;
  Proxy& proxy_;
  Budget& budget_;
  MotionRows rows_;
  Pose X_;           ///< where the sub-steps have got to
  Vec3 taken_turn_;  ///< unwrapped rotation to the device from the pose taken
  Contacts taken_contacts_;
  double radius_;
  double way_since_taken_ = 0.0, turn_since_taken_ = 0.0;
};

}  // namespace

TickResult tick(const Scene& scene, double isovalue, const VirtualCoupling& coupling,
                const Pose& X_WD, Proxy& proxy, Budget& budget) HAPTICS_RT {
  TickResult result;
  if (!X_WD.matrix().allFinite()) {
    // nothing is known of the hand: no number, which safety turns into no force
    result.wrench_W.force.setConstant(std::numeric_limits<double>::quiet_NaN());
    result.outside = !proxy.recovery.active;
    return result;
  }
  if (isovalue != proxy.isovalue) {
    proxy.isovalue = isovalue;
    proxy.contacts.clear();
    proxy.clearance.forget();
    proxy.acceptance.forget();
    proxy.recovery.active = false;
  }
  if (!proxy.recovery.active) Tick{scene, isovalue, X_WD, proxy, budget}.run(result);
  if (!result.outside || proxy.recovery.active) {
    // even when it succeeds at once: the force fades before it follows the proxy elsewhere
    result.outside = false;
    recover(scene, {scene.field, isovalue}, proxy, budget);
  }

  // 6  what the hand feels; in free space exactly nothing
  if (proxy.X_WP.matrix() == X_WD.matrix()) {
    proxy.turn.setZero();
    return result;
  }
  proxy.turn = unwrappedTurn(proxy.X_WP, X_WD, proxy.turn);
  const Mat3 R = proxy.X_WP.linear();
  result.wrench_W =
      coupling.pull(proxy.X_WP, X_WD, -proxy.turn, R * scene.metric.inertia() * R.transpose());
  return result;
}

}  // namespace haptics
