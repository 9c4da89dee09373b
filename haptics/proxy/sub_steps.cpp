// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/sub_steps.h"

#include <algorithm>
#include <cmath>

#include "haptics/collision/free_way.h"
#include "haptics/collision/motion.h"
#include "haptics/collision/motion_rows.h"
#include "haptics/collision/prune.h"
#include "haptics/collision/sweep.h"
#include "haptics/proxy/touch_constants.h"
#include "haptics/solver/friction.h"
#include "haptics/solver/unconstrained_motion.h"

namespace haptics {
namespace {

using C = TouchConstants;
using Stage = Search::Stage;

Twist scaled(const Twist& motion, double factor) HAPTICS_RT {
  return {motion.linear * factor, motion.angular * factor};
}

/// Tries in a tick: as many in a second at every rate.
int triesIn(const TickInput& given) HAPTICS_RT {
  return std::max(1, int(std::lround(given.scene.fineness.sub_steps * given.period * 1e3)));
}

/// Whether a search goes on at a pose that the proxy has not taken.
bool isUnderWay(const Search& search) HAPTICS_RT {
  return search.stage != Stage::Done && !(search.atTaken() && search.fresh);
}

}  // namespace

SubSteps::SubSteps(const TickInput& given, Proxy& proxy, Budget& budget) HAPTICS_RT
    : given_{given},
      proxy_{proxy},
      search_{proxy.search},
      budget_{budget},
      following_{given, proxy, isUnderWay(proxy.search)},
      most_tries_{triesIn(given)} {
  if (search_.stage == Stage::Done) search_.begin(proxy);
  if (unhindered()) endSearch();
}

// What ends a sub-step; all return false.

/// The budget is used up.
bool SubSteps::stop() HAPTICS_RT {
  stopped_ = true;
  return false;
}
/// The tick's tries are used up. The next tick goes on, and for it the pose is a new one.
bool SubSteps::pause() HAPTICS_RT {
  search_.fresh = true;
  paused_ = true;
  return stop();
}
bool SubSteps::endSearch() HAPTICS_RT {
  search_.stage = Stage::Done;
  return false;
}

/// Goes to the device if the whole tool has more room than the way there asks for, in one sub-step:
/// no point could meet the surface, none is near enough for a row, before or after.
bool SubSteps::unhindered() HAPTICS_RT {
  if (!given_.scene.plan.free_space) return false;
  if (search_.stage != Stage::Look || !search_.atTaken() || !search_.fresh) return false;
  if (!proxy_.contacts.empty() || proxy_.following.held) return false;
  Vec3 turn = proxy_.turn;
  const Twist way = unconstrainedMotion(proxy_.X_WP, given_.X_WD, turn);
  const double length = given_.reachOf(way);
  if (length == 0.0) return false;
  // where nothing reaches the isovalue there is room without end
  const bool nothing = given_.scene.volume->greatest < given_.solid.ceiling();
  if (!nothing && proxy_.clearance.room(given_.scene.tree) < length + lengths().band) return false;
  ++budget_.counts.sub_steps;
  following_.arrive(way);
  proxy_.clearance.moved(way.linear.norm(), way.angular.norm());
  return true;
}

void SubSteps::aim() HAPTICS_RT {
  here_.turn = proxy_.turn;
  here_.lag = unconstrainedMotion(search_.X, given_.X_WD, here_.turn);
  here_.whitened_lag = given_.metric.whitened(here_.lag, search_.X.linear());
}

bool SubSteps::findContacts() HAPTICS_RT {
  if (search_.fresh)
    prune(given_.solid, given_.scene.tool.shell, search_.X, here_.lag, lengths(), proxy_.contacts,
          budget_);
  if (!collect(lengths().band)) {
    if (found_ == Clearance::Verdict::Cut) return stop();
    // in double, at the pose itself
    if (search_.advance > 0.0) {
      retreat();
    } else {
      outside_ = false;
      endSearch();
    }
    return false;
  }
  if (!gatherRows(tool(), lengths(), given_.scene.normal, given_.scene.plan, proxy_.surface,
                  budget_))
    return stop();
  if (proxy_.second_look != nullptr)
    proxy_.second_look->gathered(tool(), lengths(), proxy_.surface, budget_);
  joinRows(proxy_.contacts, proxy_.surface, lengths(), rows_);
  return true;
}

/// Finds all points with less room than `reach`; false if cut or inside, which found_ says.
bool SubSteps::collect(double reach) HAPTICS_RT {
  found_ = proxy_.clearance.collect(given_.solid, given_.scene.tree, search_.X, reach, budget_);
  if (found_ == Clearance::Verdict::Legal && proxy_.second_look != nullptr &&
      !proxy_.second_look->collected(tool(), reach, budget_))
    found_ = Clearance::Verdict::Inside;
  return found_ == Clearance::Verdict::Legal;
}

/// A projection is not cut once begun, and what it finds is used in this tick, so that a small
/// budget gets on.
bool SubSteps::constrain() HAPTICS_RT {
  if (!budget_.left()) return stop();
  const Twist aimed = limited(here_.lag);
  const Mat3 R = search_.X.linear();
  here_.allowed = constrainedMotion(aimed, {rows_.begin(), rows_.size()}, given_.metric, R);
  budget_.counts.pivots += here_.allowed.pivots;
  budget_.spend(here_.allowed.work);
  if (given_.coupling.friction > 0.0 && here_.allowed.active > 0)
    here_.allowed = withFriction(aimed, {rows_.begin(), rows_.size()}, given_.metric, R,
                                 given_.coupling.friction, here_.allowed, budget_);
  return true;
}

bool SubSteps::follow() HAPTICS_RT {
  switch (following_.consider(here_, rows_)) {
    case Following::Course::On:
      break;
    case Following::Course::Back:
      wait();
      return false;
    case Following::Course::Over:
      return endSearch();
  }
  const Twist& lag = here_.lag;
  const Following::Limit limit = following_.limit(here_);
  const Twist way = limit.way ? limited(*limit.way) : here_.allowed.twist;
  search_.bears = here_.allowed.active > 0;
  // even the last billionth of a metre of free space is gone
  const double length = given_.reachOf(way), least = limit.arrives ? 0.0 : lengths().least_way;
  const bool there = limit.share * length <= least, tried = triedEnough();
  if (!there && tried) followed_ = inOneStep(lag) || gone_ < lengths().step_free;
  if (there || search_.tries >= C::kLongestSearch * given_.scene.fineness.sub_steps)
    return endSearch();
  if (tried) return pause();
  // what friction does is not known to the end
  if (budget_.cut()) return stop();
  search_.X_goal = given_.X_WD;
  if (limit.arrives && !inOneStep(lag) && crossFreeSpace()) return false;
  search_.length = std::min(limit.share * length, search_.trust);
  search_.motion = search_.length < length ? scaled(way, search_.length / length) : way;
  search_.whole = limit.arrives && search_.length == length && inOneStep(lag);
  search_.stage = Stage::Reach;
  proxy_.clearance.aim();
  return true;
}

/// A tick has its share of tries, and tries on, up to what a millisecond has, while little of its
/// budget is spent.
bool SubSteps::triedEnough() const HAPTICS_RT {
  if (tries_ < most_tries_) return false;
  return tries_ >= given_.scene.fineness.sub_steps || budget_.spent() >= C::kLittleWork;
}

/// Goes back to the place at which the proxy has to wait. The way back is motion, too.
void SubSteps::wait() HAPTICS_RT {
  const CatchUp::Place& place = following_.place();
  const Legs& legs = proxy_.following.catch_up.legs();
  const Leg& leg = legs[place.leg];
  const double advance = place.share * leg.advance;
  double back = 0.0, turned_back = 0.0;
  for (std::size_t n = place.leg; n < legs.size(); ++n) {
    const double part = legs[n].advance - (n == place.leg ? advance : 0.0);
    back += part * legs[n].motion.linear.norm();
    turned_back += part * legs[n].motion.angular.norm();
  }
  travel(back, turned_back);
  search_.X_before = leg.X;
  search_.motion = leg.motion;
  search_.advance = advance;
  search_.halvings = 0;
  search_.X = moved(leg.X, leg.motion, advance);
  search_.whole = false;
}

/// Goes towards the device as far as the pyramid proves the way free, in stretches longer than a
/// sub-step; false if that is less than Sweep would prove.
bool SubSteps::crossFreeSpace() HAPTICS_RT {
  const Twist& lag = here_.lag;
  const double share = freeShareOf(given_.solid, given_.scene.tree, search_.X, lag,
                                   C::kLeastStretch * lengths().voxel, budget_);
  if (share == 0.0) return false;
  search_.motion = share < 1.0 ? scaled(lag, share) : lag;
  search_.length = given_.reachOf(search_.motion);
  search_.whole = share == 1.0;
  if (given_.scene.plan.looksAgain()) {
    search_.stage = Stage::Reach;
    proxy_.clearance.aim();
  } else {
    arrive(1.0);
  }
  return true;
}

bool SubSteps::sweep() HAPTICS_RT {
  if (search_.stage == Stage::Reach && !reach()) return stop();
  ++budget_.counts.sub_steps;
  if (!proxy_.sweep.advance(given_.solid, given_.scene.tree, proxy_.clearance, lengths(), budget_))
    return stop();
  if (proxy_.second_look != nullptr)
    proxy_.second_look->swept(tool(), search_.motion, lengths(), proxy_.sweep, budget_);
  return true;
}

/// Collects the points that the motion could bring to the surface; shortens it where they are so
/// many that to prove all of it would take too many ticks. False if cut.
bool SubSteps::reach() HAPTICS_RT {
  const double slab = Sweep::kSlab * lengths().voxel;
  const double close = std::max(std::min(search_.length, 2.0 * slab), lengths().band);
  if (!collect(close)) return false;
  const auto many = double(proxy_.clearance.size());
  if (search_.length > close && many <= C::kManyPoints) {
    if (!collect(search_.length)) return false;
  } else {
    const double slabs = std::max(1.0, (C::kProofWork / std::max(1.0, many) - 1.0) / 3.0);
    shorten(std::min(close, slabs * slab));
  }
  if (proxy_.clearance.carriesAny()) {
    shorten(C::kCarriedWay * lengths().voxel);
    if (proxy_.clearance.carry(given_.solid, given_.scene.tree, search_.X, search_.motion,
                               budget_) != Clearance::Verdict::Legal)
      return false;
  }
  proxy_.sweep.begin(given_.scene.field, proxy_.clearance, search_.X, search_.motion, lengths());
  search_.stage = Stage::Sweep;
  return true;
}

void SubSteps::shorten(double length) HAPTICS_RT {
  if (length >= search_.length) return;
  search_.motion = scaled(search_.motion, length / search_.length);
  search_.length = length;
  search_.whole = false;
}

void SubSteps::go() HAPTICS_RT {
  const Impact impact = proxy_.sweep.impact(given_.solid, given_.scene.tree, lengths(), budget_);
  const double length = search_.length;
  double advance = impact.time;
  if (impact.time < 1.0) advance = std::max(0.0, impact.time - lengths().least_way / length);
  search_.stage = Stage::Look;
  if (search_.bears || advance < 1.0) {
    ++tries_;
    ++search_.tries;
  }
  if (advance * length < lengths().blocked && advance < 1.0) {
    // blocked: the exact normal of what blocks becomes a contact, or the step gets shorter
    if (!impact.met || !keep(impact.contact)) search_.trust = C::kShorter * length;
    if (search_.trust < lengths().least_way) endSearch();
    return;
  }
  arrive(advance);
  search_.trust = advance < 1.0 ? C::kBeyondImpact * advance * length : C::kLonger * search_.trust;
}

/// Moves on by this share of the motion.
void SubSteps::arrive(double advance) HAPTICS_RT {
  following_.go(search_.motion, advance, search_.bears);
  search_.X_before = search_.X;
  search_.advance = advance;
  search_.halvings = 0;
  search_.X =
      search_.whole && advance == 1.0 ? search_.X_goal : moved(search_.X, search_.motion, advance);
  travel(search_.motion.linear.norm() * advance, search_.motion.angular.norm() * advance);
  gone_ += advance * search_.length;
  search_.fresh = true;
}

/// Halves the step that led to a pose that is inside after all, or undoes it.
void SubSteps::retreat() HAPTICS_RT {
  const double advance = search_.halvings < C::kHalvings ? 0.5 * search_.advance : 0.0;
  const double back = search_.advance - advance;
  travel(search_.motion.linear.norm() * back, search_.motion.angular.norm() * back);
  following_.shorten(advance);
  search_.advance = advance;
  ++search_.halvings;
  search_.X = advance > 0.0 ? moved(search_.X_before, search_.motion, advance) : search_.X_before;
  if (advance == 0.0) endSearch();
}

void SubSteps::travel(double way, double turned) HAPTICS_RT {
  proxy_.clearance.moved(way, turned);
  search_.way += way;
  search_.turned += turned;
}

/// Adds a contact; false if its point is one already, or it has no normal.
bool SubSteps::keep(const Contact& contact) HAPTICS_RT {
  if (contact.n_W.isZero()) return false;
  // a normal that differs by milliradians counts: a rest gap over a step's length is no more
  for (const Contact& known : proxy_.contacts)
    if (known.point == contact.point && known.n_W.dot(contact.n_W) > 1.0 - 1e-8) return false;
  return proxy_.contacts.push(contact);
}

/// The share of a motion that rows are true of and that Sweep proves in one sub-step.
double SubSteps::shareOfOneStep(const Twist& motion) const HAPTICS_RT {
  double share = 1.0;
  const double length = given_.reachOf(motion), angle = motion.angular.norm();
  if (length > lengths().step_free) share = lengths().step_free / length;
  if (angle * share > C::kLargestTurn) share = C::kLargestTurn / angle;
  return share;
}
Twist SubSteps::limited(const Twist& motion) const HAPTICS_RT {
  const double share = shareOfOneStep(motion);
  return share < 1.0 ? scaled(motion, share) : motion;
}

void SubSteps::end(TickResult& result) HAPTICS_RT {
  result.outside = outside_;
  result.followed = followed_;
  result.cut = budget_.cut();
  if (stopped_) {
    result.cut = result.cut || !paused_;
    if (!paused_) result.followed = gone_ > 0.0;
  } else if (!search_.atTaken()) {
    // with the contacts with which it was; the way back is motion too
    proxy_.clearance.moved(search_.way, search_.turned);
    proxy_.contacts = search_.contacts_taken;
  }
}

}  // namespace haptics
