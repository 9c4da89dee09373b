// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/sweep.h"

#include <algorithm>
#include <cmath>

namespace haptics {

void Sweep::begin(const ScalarField& field, const Clearance& near, const Pose& X_WP,
                  const Twist& motion, const Tolerances& lengths) HAPTICS_RT {
  X_ = X_WP;
  motion_ = motion;
  speed_ = motion.linear.norm();
  turn_ = motion.angular.norm();
  slab_ = 0.0;
  cursor_.set(0);
  time_ = 1.0;
  met_ = -1;
  const double arm = near.farthestArm(), speed = speed_ + turn_ * arm;
  const double bend = sagitta(arm, turn_);  // a chord over dt is bend · dt² away
  duration_ = 1.0;
  // a survey reaches four voxels: a chord stays well within it
  if (speed > 0.0) duration_ = std::min(duration_, kSlab * field.voxel() / speed);
  if (bend > 0.0) duration_ = std::min(duration_, std::sqrt(lengths.sagitta / bend));
}

bool Sweep::advance(const Isosurface& solid, const ShellTree& tree, const Clearance& near,
                    const Tolerances& lengths, Budget& budget) HAPTICS_RT {
  constexpr std::size_t kStride = 256;  // points passed over between two looks at the budget
  while (slab_ < time_) {
    const Slab slab{slab_, std::min(1.0, slab_ + duration_),
                    solid.field.affine(moved(X_, motion_, slab_)),
                    solid.field.affine(moved(X_, motion_, std::min(1.0, slab_ + duration_)))};
    const auto some = [&](std::size_t i) HAPTICS_RT {
      Group group;
      const std::size_t stop = std::min(near.size(), i + kStride);
      for (; i < stop && group.count < lanes::kLanes; ++i) {
        const NearPoint& point = near.near(i);
        double& clear = clear_until_[i];
        if (slab_ == 0.0) {
          const double speed = speed_ + turn_ * tree.arm[static_cast<std::size_t>(point.place)];
          clear = speed > 0.0 ? point.free / speed : 2.0;
        }
        if (clear < std::min(slab.end, time_)) group.points[group.count++] = static_cast<int>(i);
      }
      if (group.count > 0) look(solid, tree, near, slab, group, lengths, budget);
      return i;
    };
    if (!cursor_.through(near.size(), budget, some)) return false;
    cursor_.set(0);
    slab_ = slab.end;
    if (slab_ >= 1.0) break;
  }
  return true;
}

void Sweep::look(const Isosurface& solid, const ShellTree& tree, const Clearance& near,
                 const Slab& slab, const Group& group, const Tolerances& lengths,
                 Budget& budget) HAPTICS_RT {
  const ScalarField& field = solid.field;
  const int count = group.count;
  const int* points = group.points;
  const double ceiling = solid.ceiling(), h = field.voxel(), dt = slab.end - slab.begin;
  budget.spend(count);

  // the chords, from where each point is no longer proven free
  lanes::Numbers px{}, py{}, pz{};
  for (int l = 0; l < count; ++l) {
    const auto place =
        static_cast<std::size_t>(near.near(static_cast<std::size_t>(points[l])).place);
    px[l] = tree.x[place];
    py[l] = tree.y[place];
    pz[l] = tree.z[place];
  }
  lanes::Chords chords;
  lanes::place(slab.at_begin, px.lane, py.lane, pz.lane, count, chords.a);
  lanes::place(slab.at_end, px.lane, py.lane, pz.lane, count, chords.b);
  lanes::Places start;
  for (int l = 0; l < count; ++l) {
    const double clear = clear_until_[static_cast<std::size_t>(points[l])];
    const double from = std::max(0.0, (clear - slab.begin) / dt);
    chords.from[l] = from;
    start.x[l] = chords.a.x[l] + from * (chords.b.x[l] - chords.a.x[l]);
    start.y[l] = chords.a.y[l] + from * (chords.b.y[l] - chords.a.y[l]);
    start.z[l] = chords.a.z[l] + from * (chords.b.z[l] - chords.a.z[l]);
  }
  // in the first slab what is near was surveyed already, at its start
  const bool first = slab.begin == 0.0;
  lanes::Survey found;
  if (!first) {
    solid.survey(start, count, found);
    budget.spend(count * field.lanesWork().value);
    budget.counts.samples += found.lookedUp(count);
  }

  // those that their surroundings do not carry to the end of the slab, moved together
  int left = 0, lane_of[lanes::kLanes];
  double speed_of[lanes::kLanes];
  for (int l = 0; l < count; ++l) {
    const auto i = static_cast<std::size_t>(points[l]);
    const NearPoint& point = near.near(i);
    const double arm = tree.arm[static_cast<std::size_t>(point.place)];
    const double speed = speed_ + turn_ * arm;
    const double bulge = sagitta(arm, turn_ * dt);
    const bool empty = first ? point.lipschitz == 0.0 : found.empty >> l & 1;
    // a path stays within the sagitta of its chord, and F within this much of the chord's; a
    // point that already stands there may slide or leave, but go no deeper
    const double lipschitz = first ? point.lipschitz : found.lipschitz[l];
    const double guard = empty ? 0.0 : lipschitz * bulge;
    const double level =
        std::min(ceiling, std::max(ceiling - guard, point.value + field.roundingMargin()));
    if (!first) {
      const double ahead =
          empty ? found.free[l]
                : std::min(found.free[l], (level - guard - found.value[l]) / lipschitz);
      if (ahead - 2.0 * bulge > 0.25 * h) {
        double& clear = clear_until_[i];
        clear = slab.begin + chords.from[l] * dt + (ahead - 2.0 * bulge) / speed;
        if (clear >= slab.end) continue;
        chords.from[l] = (clear - slab.begin) / dt;
      }
    }
    const auto shift = [&](lanes::Numbers& numbers) HAPTICS_RT { numbers[left] = numbers[l]; };
    shift(chords.a.x);
    shift(chords.a.y);
    shift(chords.a.z);
    shift(chords.b.x);
    shift(chords.b.y);
    shift(chords.b.z);
    shift(chords.from);
    chords.level[left] = level;
    speed_of[left] = speed;
    lane_of[left++] = points[l];
  }
  if (left == 0) return;
  lanes::Numbers until;
  std::int64_t cells = 0;
  field.clear(chords, left, until, cells);
  budget.spend(field.lanesWork().cell * cells);
  budget.counts.samples += cells;

  // the rest of each chord, exactly
  for (int l = 0; l < left; ++l) {
    const auto i = static_cast<std::size_t>(lane_of[l]);
    double& clear = clear_until_[i];
    if (until[l] >= 1.0) {
      clear = slab.end;
      continue;
    }
    const double from = until[l];
    clear = slab.begin + from * dt;
    if (clear >= time_) continue;
    const Vec3 a{chords.a.x[l], chords.a.y[l], chords.a.z[l]},
        b{chords.b.x[l], chords.b.y[l], chords.b.z[l]};
    const double path = speed_of[l] * (1.0 - from) * dt;
    const double reach = field.firstReach(a + from * (b - a), b, chords.level[l],
                                          lengths.root / std::max(path, lengths.root), budget);
    clear = slab.end;
    if (reach > 1.0) continue;
    const double time = slab.begin + (from + reach * (1.0 - from)) * dt;
    if (time >= time_) continue;
    time_ = time;
    met_ = near.near(i).place;
  }
}

Impact Sweep::impact(const Isosurface& solid, const ShellTree& tree, const Tolerances& lengths,
                     Budget& budget) const HAPTICS_RT {
  Impact impact;
  impact.time = time_;
  impact.met = met_ >= 0;
  if (!impact.met) return impact;
  Contact& contact = impact.contact;
  const auto place = static_cast<std::size_t>(met_);
  contact.point = tree.index[place];
  contact.r_W = X_.linear() * Vec3{tree.x[place], tree.y[place], tree.z[place]};
  contact.met_W = X_.translation() + contact.r_W;
  // just beyond the crossing, so that a crossing on a face belongs to the cell behind it
  const PointPath path{X_.translation(), contact.r_W, motion_};
  const Vec3 beyond = path.at(time_ + lengths.root / path.speed());
  const FieldSample sample = solid.field.sample(solid.field.indexOf(beyond));
  ++budget.counts.samples;
  ++budget.counts.gradients;
  const double slope = sample.gradient_W.norm();
  if (slope > 0.0) {
    contact.n_W = -sample.gradient_W / slope;
    contact.gap = contact.met_gap =
        (solid.ceiling() - sample.value) / slope + contact.n_W.dot(contact.met_W - beyond);
  }
  return impact;
}

}  // namespace haptics
