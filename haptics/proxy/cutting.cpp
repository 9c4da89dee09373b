// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/cutting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace haptics {
namespace {

// Units in a tick, some 25 us: what is left of a cut waits for the next ticks.
constexpr std::int64_t kCutWork = 2'200;
constexpr std::int64_t kRefreshWork = 400;  // of a block
// Voxels that the ball goes beyond the proxy's, or stays behind it, in one cut.
constexpr double kMostAhead = 0.25;
// The same of what may be owed: what the law gives and nothing takes is forgotten.
constexpr double kMostOwed = 1.0;
// Of what is owed, by which the stand-off grows in a tick.
constexpr double kLearning = 0.05;
constexpr double kOnBurr = 2e-6;      // m: a shell's point so far beyond the ball is not on it
constexpr double kSmoothing = 0.005;  // s, of the device's velocity, the drag, the vibration
constexpr double kNoForce = 1e-9;     // N
constexpr double kLifted = 5e-3;      // s without force: no bounce, the way has ended
constexpr double kFullDrag = 0.1;     // m/s along the surface from which the drag is whole
constexpr double kMostFelt = 250.0;   // Hz: of a vibration
constexpr double kOfRate = 0.25;      // of the rate of ticks: the highest that they render

}  // namespace

Burr ballAtTip(const PointShell& shell, double radius) {
  const Vec3 end = *std::ranges::min_element(shell.points, {}, [](const Vec3& p) { return p.z(); });
  return {{-shell.origin.x(), -shell.origin.y(), end.z() + radius}, radius};
}

double vibrationFrequency(double speed, double period) HAPTICS_RT {
  const double passing = kBurrTeeth * speed / (2.0 * std::numbers::pi);
  const double most = std::min(kMostFelt, kOfRate / period);
  return passing / std::max(1.0, std::ceil(passing / most));
}

void Cutting::lookAhead() {
  constexpr double kVoxels = 6.0;  // the wall's reach, and more
  const double reach = law_.burr.radius + kVoxels * scene()->volume->grid.spacing.maxCoeff();
  ahead_ = std::make_unique<PagesAhead>(scene()->volume, reach);
}

void Cutting::forget() HAPTICS_RT {
  begun_.reset();
  removed_ = {};
  owed_ = standoff_ = untouched_ = 0.0;
  last_W_.reset();
  forgetHand();
}

void Cutting::forgetHand() HAPTICS_RT {
  burr_WD_.reset();
  velocity_W_.setZero();
  drag_W_.setZero();
  shake_ = passed_ = 0.0;
}

void Cutting::make(const BurrCut& cut) {
  carved_->begin(cut);
  finish();
}

void Cutting::finish() {
  while (!carved_->isDone()) {
    Budget budget = Budget::counted(1'000'000);
    carved_->advance(law_.material, 1'000'000, budget);
  }
}

Vec3 Cutting::pressOn(const Proxy& proxy) const HAPTICS_RT {
  const Vec3 c_W = proxy.X_WP.linear() * law_.burr.centre_P;
  const double reach = law_.burr.radius + kOnBurr;
  Vec3 press = Vec3::Zero();
  for (const BearingContact& contact : proxy.bearing)
    if ((contact.r_W - c_W).squaredNorm() <= reach * reach) press += contact.push * contact.n_W;
  return press;
}

void Cutting::settle() {
  finish();
  carved_->rest();
  carved_->refresh(SIZE_MAX);
}

// The ball that is cut lies ahead of the proxy's: by the stand-off, as the tool rests a little
// before the surface and touches it with points only, and by the energy that is owed, over what a
// disk of the burr's size takes for each metre. A smaller area takes less, so what is owed grows
// until it is taken; the sum is exact whatever the surface looks like.
void Cutting::begin(const Vec3& press_W, const Vec3& centre_W, double isovalue) HAPTICS_RT {
  const Burr& burr = law_.burr;
  const double voxel = scene()->field.voxel(), most = kMostAhead * voxel;
  const double each = std::numbers::pi * burr.radius * burr.radius *
                      (removed_.volume > 0.0 ? removed_.energy / removed_.volume
                                             : law_.material.energyAt(isovalue));
  owed_ = std::min(owed_, kMostOwed * voxel * each);
  standoff_ = std::clamp(standoff_ + kLearning * owed_ / each, 0.0, most);
  const double ahead = std::min(standoff_ + owed_ / each, most);
  if (!(ahead > -most)) {
    last_W_.reset();
    return;
  }
  const Vec3 to = centre_W - ahead * press_W.normalized();
  const bool goes_on = last_W_ && (to - *last_W_).norm() < burr.radius;
  // so much wider that the tool fits into what it cut, with the gap at which it rests on all sides
  const double radius = burr.radius + scene()->lengths.epsilon;
  begun_ = BurrCut{goes_on ? *last_W_ : to, to, radius, isovalue};
  last_W_ = to;
  carved_->begin(*begun_);
}

Vec3 Cutting::dragFor(const Vec3& press_W, const Pose& X_WD, double period) HAPTICS_RT {
  const double part = period / (kSmoothing + period);
  const Vec3 c_W = X_WD * law_.burr.centre_P;
  if (burr_WD_) velocity_W_ += part * ((c_W - *burr_WD_) / period - velocity_W_);
  burr_WD_ = c_W;
  const double force = press_W.norm();
  Vec3 drag = Vec3::Zero();
  if (force > 0.0) {
    const Vec3 n = press_W / force;
    const Vec3 along = velocity_W_ - velocity_W_.dot(n) * n;
    drag = -law_.share * force / std::max(kFullDrag, along.norm()) * along;
  }
  drag_W_ += part * (drag - drag_W_);
  // smoothed, it must not push on after the hand has turned
  const double with = drag_W_.dot(velocity_W_);
  if (with > 0.0) drag_W_ -= with / velocity_W_.squaredNorm() * velocity_W_;
  return drag_W_;
}

Vec3 Cutting::vibrationFor(const Vec3& press_W, double period) HAPTICS_RT {
  const double force = press_W.norm();
  if (!(force > 0.0)) {
    shake_ = passed_ = 0.0;
    return Vec3::Zero();
  }
  const double wanted = std::min(law_.vibration * force, kMostVibration);
  shake_ += period / (kSmoothing + period) * (wanted - shake_);
  shake_ = std::min(shake_, force);  // smoothed, it must not pull when the push grows less
  passed_ += vibrationFrequency(law_.speed, period) * period;
  passed_ -= std::floor(passed_);
  return shake_ * std::sin(2.0 * std::numbers::pi * passed_) / force * press_W;
}

Wrench Cutting::go(bool held, Proxy& proxy, const Pose& X_WD, double isovalue, double period,
                   Budget& budget) HAPTICS_RT {
  begun_.reset();
  if (!X_WD.matrix().allFinite()) {
    forget();  // a number that is none would stay in what is smoothed
    return {};
  }
  if (ahead_) ahead_->at(proxy.X_WP * law_.burr.centre_P);
  const Vec3 press = held && !proxy.recovery.active ? pressOn(proxy) : Vec3::Zero();
  force_ = press.norm();
  // between strokes exactly nothing is left of it: a tick does not tell since when it could cut
  if (!held && drag_W_.norm() < kNoForce) forgetHand();
  const bool drags = held || !drag_W_.isZero(0.0);
  Vec3 felt = drags ? dragFor(press, X_WD, period) : Vec3::Zero();
  if (law_.vibration > 0.0) felt += vibrationFor(press, period);
  untouched_ = force_ > 0.0 ? 0.0 : untouched_ + period;
  if (!held || untouched_ > kLifted) last_W_.reset();
  if (!held) owed_ = std::min(owed_, 0.0);
  owed_ += law_.share * force_ * law_.speed * law_.burr.radius * period;
  if (carved_->isDone() && force_ > 0.0) begin(press, proxy.X_WP * law_.burr.centre_P, isovalue);
  const Removed now = carved_->advance(law_.material, kCutWork, budget);
  if (now.voxels > 0) {
    proxy.clearance.lowered();
    // of a search under way, and those that it may return to
    const Search& search = proxy.search;
    const bool under_way = search.stage != Search::Stage::Done;
    carved_->drop(proxy.contacts, (under_way ? search.X : proxy.X_WP).translation());
    carved_->drop(proxy.search.contacts_taken, proxy.X_WP.translation());
  }
  removed_.add(now);
  owed_ -= now.energy;
  if (!held && carved_->isDone()) carved_->rest();
  if (carved_->refresh(0) > 0 && budget.left()) {
    budget.spend(kRefreshWork);
    carved_->refresh(1);
  }
  return {.force = felt, .torque = (X_WD.linear() * law_.burr.centre_P).cross(felt)};
}

}  // namespace haptics
