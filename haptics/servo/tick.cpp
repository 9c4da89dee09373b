// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/tick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "haptics/collision/free_way.h"
#include "haptics/collision/motion.h"
#include "haptics/collision/motion_rows.h"
#include "haptics/collision/prune.h"
#include "haptics/collision/sweep.h"
#include "haptics/servo/recovery.h"
#include "haptics/solver/constrained_motion.h"
#include "haptics/solver/friction.h"
#include "haptics/solver/unconstrained_motion.h"

namespace haptics {
namespace {

constexpr double kLargestTurnOfSubStep = 0.3;  // rad, where rows or the field say what is free

/// How far the farthest point of the tool travels at most [m].
double reachOf(const Twist& motion, double radius) HAPTICS_RT {
  return motion.linear.norm() + motion.angular.norm() * radius;
}

Twist scaled(const Twist& motion, double factor) HAPTICS_RT {
  return {motion.linear * factor, motion.angular * factor};
}

/// m^2: squared radius of gyration that the coupling's own angular stiffness stands for; 0: it has
/// none, and the tool's inertia counts.
double squaredGyrationOf(const VirtualCoupling& coupling) HAPTICS_RT {
  const bool own = coupling.angular_stiffness > 0.0 && coupling.stiffness > 0.0;
  return own ? coupling.angular_stiffness / coupling.stiffness : 0.0;
}

/// What is near: by the energy of the coupling over its stiffness. A proxy that were near by
/// another measure would give way to a contact against the spring, and so give energy to the hand.
MassMetric metricOf(const Scene& scene, const VirtualCoupling& coupling) HAPTICS_RT {
  const double squared_gyration = squaredGyrationOf(coupling);
  if (squared_gyration == 0.0) return scene.metric;
  // as well conditioned as the tool's own, however soft the spring
  const double radius = scene.tool.shell.radius;
  const double least = std::max(1e-6 * radius * radius, 1e-12);  // m^2
  return MassMetric{Mat3::Identity() * std::max(squared_gyration, least)};
}

/// One tick at work. What a cut may interrupt lives in proxy.search; the rest is the tick's own.
class Tick {
 public:
  Tick(const Scene& scene, double isovalue, const VirtualCoupling& coupling, const Pose& X_WD,
       double period, Proxy& proxy, Budget& budget) HAPTICS_RT : scene_{scene},
                                                                 solid_{scene.field, isovalue},
                                                                 metric_{metricOf(scene, coupling)},
                                                                 coupling_{coupling},
                                                                 X_WD_{X_WD},
                                                                 proxy_{proxy},
                                                                 at_{proxy.search},
                                                                 budget_{budget},
                                                                 radius_{scene.tool.shell.radius},
                                                                 most_tries_{triesIn(period)} {
    // the filter compares distances by one metric
    const double squared_gyration = squaredGyrationOf(coupling);
    if (!(std::abs(squared_gyration - proxy.squared_gyration) <= 1e-9 * squared_gyration))
      proxy.acceptance = {};
    proxy.squared_gyration = squared_gyration;
    if (!proxy.held) return;
    Vec3 turn = proxy.turn;
    proxy.release.begin(unconstrainedMotion(proxy.X_WP, X_WD, turn), metric_, proxy.X_WP.linear(),
                        X_WD.translation(), coupling.stiffness, period);
  }

  /// Takes sub-steps until the proxy has arrived, is held, or the tick's tries or its budget are
  /// used up.
  void run(TickResult& result) HAPTICS_RT {
    proxy_.acceptance.begin(X_WD_, proxy_.X_WP, metric_, radius_, lengths().epsilon);
    if (at_.stage == Search::Stage::Done) {
      at_.begin(proxy_);
    } else if (!at_.atTaken() || !at_.fresh) {
      // a sub-step is under way: what it will come to is compared with the pose it left
      const double distance = distanceFrom(proxy_.X_WP, proxy_.turn);
      proxy_.acceptance.start(distance, distance);
    }
    if (unhindered()) return;
    while (at_.stage != Search::Stage::Done) {
      bool through = true;
      switch (at_.stage) {
        case Search::Stage::Look:
          through = look(result);
          break;
        case Search::Stage::Reach:
          through = reach();
          break;
        case Search::Stage::Sweep:
          through = go();
          ++budget_.counts.sub_steps;
          break;
        case Search::Stage::Done:
          break;
      }
      if (!through) {
        // the search goes on in the next tick
        result.cut = budget_.cut() || !paused_;
        if (!paused_) result.followed = gone_ > 0.0;
        return;
      }
    }
    settle();
    result.cut = budget_.cut();
  }

 private:
  const Tolerances& lengths() const HAPTICS_RT { return scene_.lengths; }
  /// The tool at the pose that the sub-steps have got to.
  NearTool tool() const HAPTICS_RT { return {solid_, scene_.tree, at_.X, proxy_.clearance}; }

  double distanceFrom(const Pose& X, Vec3 turn) const HAPTICS_RT {
    return metric_.whitened(unconstrainedMotion(X, X_WD_, turn), X.linear()).norm();
  }

  /// Stops short on the way to a pose that the filter would take, if the force changes too fast
  /// there. The next look takes the place to wait. False if the pose may be taken, or if the energy
  /// allows no such place.
  bool easeTo(double distance, double step) HAPTICS_RT {
    if (!proxy_.held || eased_ || at_.atTaken()) return false;
    if (!proxy_.acceptance.wouldTake(distance, step)) return false;
    const std::optional<Release::Place> place = proxy_.release.placeToWait();
    if (!place) return false;
    const Legs& legs = proxy_.release.legs();
    const Leg& leg = legs[place->leg];
    const double advance = place->share * leg.advance;
    if (place->leg == 0 && advance * reachOf(leg.motion, radius_) < lengths().least_way) {
      // the force has changed enough in this tick: what was taken stays
      at_.stage = Search::Stage::Done;
      return true;
    }
    const Pose X = moved(leg.X, leg.motion, advance);
    if (!proxy_.acceptance.mayWait(distanceFrom(X, proxy_.turn))) return false;
    // the way back is motion, too
    double back = 0.0, turned_back = 0.0;
    for (std::size_t n = place->leg; n < legs.size(); ++n) {
      const double part = legs[n].advance - (n == place->leg ? advance : 0.0);
      back += part * legs[n].motion.linear.norm();
      turned_back += part * legs[n].motion.angular.norm();
    }
    proxy_.clearance.moved(back, turned_back);
    at_.way += back;
    at_.turned += turned_back;
    at_.X_before = leg.X;
    at_.motion = leg.motion;
    at_.advance = advance;
    at_.halvings = 0;
    at_.X = X;
    at_.whole = false;
    eased_ = true;
    return true;
  }

  /// Goes to the device if the whole tool has more room than the way there asks for, in one
  /// sub-step: no point could meet the surface, none is near enough for a row, before or after.
  bool unhindered() HAPTICS_RT {
    if (!scene_.plan.free_space) return false;
    if (at_.stage != Search::Stage::Look || !at_.atTaken() || !at_.fresh) return false;
    if (!proxy_.contacts.empty() || proxy_.held) return false;
    Vec3 turn = proxy_.turn;
    const Twist way = unconstrainedMotion(proxy_.X_WP, X_WD_, turn);
    const double length = reachOf(way, radius_);
    if (length == 0.0) return false;
    // where nothing reaches the isovalue there is room without end
    const bool nothing = scene_.volume->greatest < solid_.ceiling();
    if (!nothing && proxy_.clearance.room(scene_.tree) < length + lengths().band) return false;
    ++budget_.counts.sub_steps;
    const double distance = metric_.whitened(way, proxy_.X_WP.linear()).norm();
    proxy_.acceptance.start(distance, distance);
    proxy_.acceptance.take(0.0, 0.0);
    proxy_.clearance.moved(way.linear.norm(), way.angular.norm());
    proxy_.X_WP = X_WD_;
    proxy_.turn.setZero();
    proxy_.bearing.clear();
    at_.stage = Search::Stage::Done;
    return true;
  }

  /// Steps 1 to 3 at the pose reached: judges it, and says where to go next. False if cut, or if
  /// the next tick tries further.
  bool look(TickResult& result) HAPTICS_RT {
    // 1  where the proxy would go if nothing were in the way
    Vec3 turn = proxy_.turn;
    const Twist free = unconstrainedMotion(at_.X, X_WD_, turn);
    const double distance = metric_.whitened(free, at_.X.linear()).norm();
    const Twist aimed = limited(free);

    // 2  which of its contacts still stand in that way, and which points are near the surface
    if (at_.fresh)
      prune(solid_, scene_.tool.shell, at_.X, free, lengths(), proxy_.contacts, budget_);
    switch (collect(lengths().band)) {
      case Clearance::Verdict::Cut:
        return false;
      case Clearance::Verdict::Inside:
        // in double, at the pose itself: a step that ends inside is halved
        if (retreat()) return true;
        result.outside = false;
        at_.stage = Search::Stage::Done;
        return true;
      case Clearance::Verdict::Legal:
        break;
    }
    if (!gatherRows(tool(), lengths(), scene_.normal, scene_.plan, proxy_.surface, budget_))
      return false;
    if (proxy_.second_look != nullptr)
      proxy_.second_look->gathered(tool(), lengths(), proxy_.surface, budget_);
    joinRows(proxy_.contacts, proxy_.surface, lengths(), rows_);

    // 3  the nearest motion that leaves every contact its room; not cut once begun, and what it
    // finds is used in this tick, so that a small budget gets on
    if (!budget_.left()) return false;
    ConstrainedMotion allowed =
        constrainedMotion(aimed, {rows_.begin(), rows_.size()}, metric_, at_.X.linear());
    budget_.counts.pivots += allowed.pivots;
    budget_.spend(allowed.work);
    if (coupling_.friction > 0.0 && allowed.active > 0)
      allowed = withFriction(aimed, {rows_.begin(), rows_.size()}, metric_, at_.X.linear(),
                             coupling_.friction, allowed, budget_);
    const double step = allowed.whitened.norm();
    Vector6 whole = Vector6::Zero();
    if (proxy_.held) {
      whole = metric_.whitened(free, at_.X.linear());
      proxy_.release.look(free, whole);
    }
    if (at_.fresh && easeTo(distance, step)) return true;
    if (at_.fresh) judge(distance, step, turn);
    at_.fresh = false;
    if (at_.atTaken()) bear(allowed);
    if (eased_) {
      at_.stage = Search::Stage::Done;
      return true;
    }
    at_.bears = allowed.active > 0;
    Twist way = allowed.twist;
    double most = 1.0;  // of it
    bool arrives = !at_.bears;
    if (proxy_.held) {
      const Vector6& left = proxy_.release.left();
      arrives = arrives && left.isZero(0.0);
      if (at_.bears)
        most = proxy_.release.shareOf(allowed.whitened);
      else
        way = limited(arrives ? free : metric_.twist(whole - left, at_.X.linear()));
    }
    // even the last billionth of a metre of free space is gone
    const double length = reachOf(way, radius_), least = arrives ? 0.0 : lengths().least_way;
    const bool there = most * length <= least, tried = triedEnough();
    if (!there && tried) result.followed = inOneStep(free) || gone_ < lengths().step_free;
    if (there || at_.tries >= kMilliseconds * scene_.fineness.sub_steps) {
      at_.stage = Search::Stage::Done;
      return true;
    }
    if (tried) {
      // from there on in the next tick, for which the pose is a new one
      at_.fresh = true;
      paused_ = true;
      return false;
    }
    // what friction does is not known to the end
    if (budget_.cut()) return false;
    at_.X_goal = X_WD_;
    if (arrives && !inOneStep(free) && advance(free)) return true;
    at_.length = std::min(most * length, at_.trust);
    at_.motion = at_.length < length ? scaled(way, at_.length / length) : way;
    at_.whole = arrives && at_.length == length && inOneStep(free);
    at_.stage = Search::Stage::Reach;
    proxy_.clearance.aim();
    return true;
  }

  /// A tick has its share of tries, and tries on, up to what a millisecond has, while little of its
  /// budget is spent.
  bool triedEnough() const HAPTICS_RT {
    if (tries_ < most_tries_) return false;
    return tries_ >= scene_.fineness.sub_steps || budget_.spent() >= kLittleWork;
  }
  /// As many in a second at every rate.
  int triesIn(double period) const HAPTICS_RT {
    return std::max(1, int(std::lround(scene_.fineness.sub_steps * period * 1e3)));
  }

  /// Goes as far towards the device as the pyramid proves the way free; false if that is less than
  /// Sweep would prove.
  bool advance(const Twist& free) HAPTICS_RT {
    const double share =
        freeShareOf(solid_, scene_.tree, at_.X, free, kLeastStretch * lengths().voxel, budget_);
    if (share == 0.0) return false;
    at_.motion = share < 1.0 ? scaled(free, share) : free;
    at_.length = reachOf(at_.motion, radius_);
    at_.whole = share == 1.0;
    if (scene_.plan.looksAgain()) {
      at_.stage = Search::Stage::Reach;
      proxy_.clearance.aim();
    } else {
      arrive(1.0);
    }
    return true;
  }

  /// Collects the points that the motion could bring to the surface; shortens it where they are so
  /// many that to prove all of it would take too many ticks. False if cut.
  bool reach() HAPTICS_RT {
    const double slab = Sweep::kSlab * lengths().voxel;
    const double close = std::max(std::min(at_.length, 2.0 * slab), lengths().band);
    if (collect(close) != Clearance::Verdict::Legal) return false;
    const auto many = double(proxy_.clearance.size());
    if (at_.length > close && many <= kMany) {
      if (collect(at_.length) != Clearance::Verdict::Legal) return false;
    } else {
      const double slabs = std::max(1.0, (kProofWork / std::max(1.0, many) - 1.0) / 3.0);
      shorten(std::min(close, slabs * slab));
    }
    if (proxy_.clearance.carriesAny()) {
      shorten(kCarriedWay * lengths().voxel);
      if (proxy_.clearance.carry(solid_, scene_.tree, at_.X, at_.motion, budget_) !=
          Clearance::Verdict::Legal)
        return false;
    }
    proxy_.sweep.begin(scene_.field, proxy_.clearance, at_.X, at_.motion, lengths());
    at_.stage = Search::Stage::Sweep;
    return true;
  }
  Clearance::Verdict collect(double reach) HAPTICS_RT {
    const Clearance::Verdict verdict =
        proxy_.clearance.collect(solid_, scene_.tree, at_.X, reach, budget_);
    if (verdict == Clearance::Verdict::Legal && proxy_.second_look != nullptr &&
        !proxy_.second_look->collected(tool(), reach, budget_))
      return Clearance::Verdict::Inside;
    return verdict;
  }
  void shorten(double length) HAPTICS_RT {
    if (length >= at_.length) return;
    at_.motion = scaled(at_.motion, length / at_.length);
    at_.length = length;
    at_.whole = false;
  }

  /// Steps 4 and 5: how far along the motion the tool gets; goes there, and keeps what stood in the
  /// way. False if cut.
  bool go() HAPTICS_RT {
    if (!proxy_.sweep.advance(solid_, scene_.tree, proxy_.clearance, lengths(), budget_))
      return false;
    if (proxy_.second_look != nullptr)
      proxy_.second_look->swept(tool(), at_.motion, lengths(), proxy_.sweep, budget_);
    const Impact impact = proxy_.sweep.impact(solid_, scene_.tree, lengths(), budget_);
    const double length = at_.length;
    double advance = impact.time;
    if (impact.time < 1.0) advance = std::max(0.0, impact.time - lengths().least_way / length);
    at_.stage = Search::Stage::Look;
    if (at_.bears || advance < 1.0) {
      ++tries_;
      ++at_.tries;
    }
    if (advance * length < lengths().blocked && advance < 1.0) {
      // blocked: the exact normal of what blocks becomes a contact, or the step gets shorter
      if (!impact.met || !keep(impact.contact)) at_.trust = kShorter * length;
      if (at_.trust < lengths().least_way) at_.stage = Search::Stage::Done;
      return true;
    }
    arrive(advance);
    at_.trust = advance < 1.0 ? kBeyondImpact * advance * length : kLonger * at_.trust;
    return true;
  }

  /// Moves on by this share of the motion.
  void arrive(double advance) HAPTICS_RT {
    if (proxy_.held)
      proxy_.release.go({.X = at_.X, .motion = at_.motion, .advance = advance, .bears = at_.bears},
                        advance * metric_.whitened(at_.motion, at_.X.linear()), at_.atTaken());
    at_.X_before = at_.X;
    at_.advance = advance;
    at_.halvings = 0;
    at_.X = at_.whole && advance == 1.0 ? at_.X_goal : moved(at_.X, at_.motion, advance);
    travel(advance);
    gone_ += advance * at_.length;
    at_.fresh = true;
  }

  /// Halves the step that led to a pose that is inside after all; false if there is none.
  bool retreat() HAPTICS_RT {
    if (at_.advance == 0.0) return false;
    const double advance = at_.halvings < 5 ? 0.5 * at_.advance : 0.0;
    travel(at_.advance - advance);
    if (proxy_.held && !eased_) proxy_.release.shorten(advance);
    at_.advance = advance;
    ++at_.halvings;
    at_.X = advance > 0.0 ? moved(at_.X_before, at_.motion, advance) : at_.X_before;
    if (advance == 0.0) at_.stage = Search::Stage::Done;
    return true;
  }

  /// The motion, shortened to what rows are true of and what Sweep proves in one sub-step.
  Twist limited(const Twist& free) const HAPTICS_RT {
    const double factor = shareOf(free);
    return factor < 1.0 ? scaled(free, factor) : free;
  }
  bool inOneStep(const Twist& free) const HAPTICS_RT { return shareOf(free) == 1.0; }
  double shareOf(const Twist& free) const HAPTICS_RT {
    double factor = 1.0;
    const double length = reachOf(free, radius_), angle = free.angular.norm();
    if (length > lengths().step_free) factor = lengths().step_free / length;
    if (angle * factor > kLargestTurnOfSubStep) factor = kLargestTurnOfSubStep / angle;
    return factor;
  }

  /// Adds a contact; false if its point is one already, or it has no normal.
  bool keep(const Contact& contact) HAPTICS_RT {
    if (contact.n_W.isZero()) return false;
    // a normal that differs by milliradians counts: a rest gap over a step's length is no more
    for (const Contact& known : proxy_.contacts)
      if (known.point == contact.point && known.n_W.dot(contact.n_W) > 1.0 - 1e-8) return false;
    return proxy_.contacts.push(contact);
  }

  /// Remembers what bears on the proxy at its pose.
  void bear(const ConstrainedMotion& allowed) HAPTICS_RT {
    proxy_.bearing.clear();
    for (std::size_t j = 0; j < static_cast<std::size_t>(allowed.active); ++j) {
      const MotionRow& row = rows_[static_cast<std::size_t>(allowed.bearing[j])];
      // the metric is that of a mass of 1, so a reaction times the stiffness is a force
      proxy_.bearing.push({row.r_W, row.n_W, allowed.reaction[j] * coupling_.stiffness});
    }
  }

  void travel(double share) HAPTICS_RT {
    const double way = at_.motion.linear.norm() * share;
    const double turned = at_.motion.angular.norm() * share;
    proxy_.clearance.moved(way, turned);
    at_.way += way;
    at_.turned += turned;
  }

  /// Takes the pose reached for the proxy if the filter lets it.
  void judge(double distance, double step, const Vec3& turn) HAPTICS_RT {
    if (at_.atTaken())
      proxy_.acceptance.start(distance, step);
    else if (eased_ ? !proxy_.acceptance.takeOnTheWay(distance, step)
                    : !proxy_.acceptance.take(distance, step))
      return;
    if (proxy_.held) proxy_.release.take();
    proxy_.X_WP = at_.X;
    proxy_.turn = turn;
    at_.way = at_.turned = 0.0;
    at_.contacts_taken = proxy_.contacts;
  }

  /// Goes back to the pose that was taken last, and to the contacts with which it was; the way back
  /// is motion too.
  void settle() HAPTICS_RT {
    if (at_.atTaken()) return;
    proxy_.clearance.moved(at_.way, at_.turned);
    proxy_.contacts = at_.contacts_taken;
  }

  static constexpr double kMany = 4096;  // near points: then a motion is proven bit by bit
  static constexpr double kProofWork = 32.0 * double(kTickWork);  // of one sub-step at most
  static constexpr double kCarriedWay = 0.5;  // voxels: of a sub-step with carried nodes at most
  static constexpr std::int64_t kLittleWork = kTickWork / 8;  // some 25 us
  static constexpr int kMilliseconds = 3;                     // of a search at most
  // How long a sub-step is tried: a quarter where one was blocked and nothing new was learned;
  // three times what an impact left of it, so that a slide along a wavy surface does not creep;
  // twice as long where nothing was met.
  static constexpr double kShorter = 0.25, kBeyondImpact = 3.0, kLonger = 2.0;
  static constexpr double kLeastStretch = 4.0;  // voxels: the pyramid's finest blocks prove no less

  const Scene& scene_;
  const Isosurface solid_;
  const MassMetric metric_;
  const VirtualCoupling& coupling_;
  const Pose& X_WD_;
  Proxy& proxy_;
  Search& at_;
  Budget& budget_;
  MotionRows rows_;
  double radius_;
  bool eased_ = false;   // the pose is a place to wait, on the way to a better one
  bool paused_ = false;  // the search goes on, although the budget is not used up
  const int most_tries_;
  int tries_ = 0;      // motions that a contact shaped or stopped, in this tick
  double gone_ = 0.0;  // m: the farthest point, in it
};

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
  if (isovalue != proxy.isovalue) {
    const bool held = proxy.held;
    proxy.forget();
    proxy.isovalue = isovalue;
    proxy.held = held;  // what the hand feels stays what it is until the proxy has caught up
  }
  if (!proxy.recovery.active)
    Tick{scene, isovalue, coupling, X_WD, period, proxy, budget}.run(result);
  result.contacts = static_cast<int>(proxy.bearing.size());
  if (!result.outside || proxy.recovery.active) {
    // even when it succeeds at once: the force fades before it follows the proxy elsewhere
    result.outside = false;
    recover(scene, {scene.field, isovalue}, proxy, period, budget);
  }

  // 6  what the hand feels; in free space exactly nothing
  if (proxy.X_WP.matrix() == X_WD.matrix()) {
    proxy.held = false;
    proxy.turn.setZero();
    return result;
  }
  proxy.turn = unwrappedTurn(proxy.X_WP, X_WD, proxy.turn);
  const Twist lag{X_WD.translation() - proxy.X_WP.translation(), proxy.turn};
  if (proxy.held) {
    proxy.release.end(lag, result.followed);
  } else if (result.contacts > 0) {
    proxy.held = true;
    result.followed = true;
    proxy.release.hold(lag);
  }
  const Mat3 R = proxy.X_WP.linear();
  result.wrench_W =
      coupling.pull(proxy.X_WP, X_WD, -proxy.turn, R * scene.metric.inertia() * R.transpose());
  return result;
}

}  // namespace haptics
