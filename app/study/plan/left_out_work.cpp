// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/plan/left_out_work.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/collision/motion.h"
#include "haptics/field/spline_lanes.h"

namespace study::plan {
namespace {

using haptics::Budget;
using haptics::FieldKind;
using haptics::Isosurface;
using haptics::NearTool;
using haptics::ScalarField;
using haptics::ShellTree;
using haptics::Sweep;
using haptics::Tolerances;
using haptics::Twist;
using haptics::Vec3;
namespace lanes = haptics::lanes;

/// Points that are looked at together.
struct Sixteen {
  int count = 0;
  std::size_t place[lanes::kLanes];
  lanes::Numbers x{}, y{}, z{};

  /// True once it is full.
  bool add(const ShellTree& tree, std::size_t at) HAPTICS_RT {
    place[count] = at;
    x[count] = tree.x[at];
    y[count] = tree.y[at];
    z[count] = tree.z[at];
    return ++count == lanes::kLanes;
  }
};

/// The values at places, whatever the pyramid says of them.
void sampled(const ScalarField& field, const lanes::Places& u, int n,
             lanes::Survey& found) HAPTICS_RT {
  const auto survey = field.kind() == FieldKind::Trilinear ? lanes::survey : lanes::spline::survey;
  // no block is below a level that none can be below
  survey(field.lattice(), u, n, -std::numeric_limits<double>::infinity(), found);
  for (int l = 0; l < n; ++l)
    if (found.edge >> l & 1) found.value[l] = field.value({u.x[l], u.y[l], u.z[l]});
}

/// A slice of a motion's time, and the tool at its two ends.
struct Slab {
  double begin, end;
  lanes::Affine at_begin, at_end;  // tool frame to index coordinates
};

/// The points of the group along the slab, up to the earliest impact so far. The level is the
/// isovalue itself, without the guard against the sagitta: a crossing that rounding cannot have
/// made, on a chord between two places that are proven free.
void follow(const NearTool& tool, const Slab& slab, const Twist& motion, const Sixteen& group,
            const Tolerances& lengths, Sweep& sweep, Budget& budget) HAPTICS_RT {
  const ScalarField& field = tool.solid.field;
  const double speed = motion.linear.norm(), turn = motion.angular.norm();
  const int n = group.count;
  lanes::Chords chords;
  lanes::place(slab.at_begin, group.x.lane, group.y.lane, group.z.lane, n, chords.a);
  lanes::place(slab.at_end, group.x.lane, group.y.lane, group.z.lane, n, chords.b);
  double share[lanes::kLanes], root[lanes::kLanes];
  for (int l = 0; l < n; ++l) {
    const double path = (speed + turn * tool.tree.arm[group.place[l]]) * (slab.end - slab.begin);
    // an impact is known to be as late as its root is fine: what is later does not count
    root[l] = lengths.root / std::max(path, lengths.root);
    share[l] = 1.0;
    if (sweep.time() < slab.end)
      share[l] = std::max(0.0, (sweep.time() - slab.begin) / (slab.end - slab.begin) - root[l]);
    chords.b.x[l] = chords.a.x[l] + share[l] * (chords.b.x[l] - chords.a.x[l]);
    chords.b.y[l] = chords.a.y[l] + share[l] * (chords.b.y[l] - chords.a.y[l]);
    chords.b.z[l] = chords.a.z[l] + share[l] * (chords.b.z[l] - chords.a.z[l]);
    chords.from[l] = 0.0;
    chords.level[l] = tool.solid.isovalue;
  }
  lanes::Numbers until;
  std::int64_t cells = 0;
  field.clear(chords, n, until, cells);
  budget.spend(n + field.lanesWork().cell * cells);
  budget.counts.samples += cells;
  for (int l = 0; l < n; ++l) {
    if (until[l] >= 1.0) continue;
    const Vec3 a{chords.a.x[l], chords.a.y[l], chords.a.z[l]},
        b{chords.b.x[l], chords.b.y[l], chords.b.z[l]};
    const double reach =
        field.firstReach(a + until[l] * (b - a), b, tool.solid.isovalue, root[l], budget);
    if (reach > 1.0) continue;
    const double time =
        slab.begin + (until[l] + reach * (1.0 - until[l])) * share[l] * (slab.end - slab.begin);
    if (time < sweep.time()) sweep.meet(time, group.place[l]);
  }
}

}  // namespace

LeftOutWork::LeftOutWork(const haptics::Plan& plan, const ShellTree& tree)
    : plan_{plan}, follow_(static_cast<std::size_t>(tree.size())) {
  if (plan.empty_space) return;
  follow_count_ = follow_.size();
  for (std::size_t place = 0; place < follow_.size(); ++place) follow_[place] = place;
}

bool LeftOutWork::collected(const NearTool& tool, double reach, Budget& budget) HAPTICS_RT {
  if (!plan_.looksAgain()) return true;
  if (search_ == tool.near.search() && reach <= reach_) return true;
  if (plan_.empty_space) follow_count_ = 0;
  const ScalarField& field = tool.solid.field;
  const lanes::Affine map = field.affine(tool.X_WP);
  Sixteen sixteen;
  const auto look = [&]() HAPTICS_RT {
    const int n = sixteen.count;
    sixteen.count = 0;
    budget.spend(n * field.lanesWork().value);
    lanes::Places u;
    lanes::place(map, sixteen.x.lane, sixteen.y.lane, sixteen.z.lane, n, u);
    lanes::Survey found;
    if (plan_.empty_space)
      tool.solid.survey(u, n, found);
    else
      sampled(field, u, n, found);
    budget.counts.samples += plan_.empty_space ? found.lookedUp(n) : n;
    for (int l = 0; l < n; ++l) {
      if (found.value[l] >= tool.solid.ceiling()) return false;
      if (plan_.empty_space && found.free[l] < reach) follow_[follow_count_++] = sixteen.place[l];
    }
    return true;
  };
  for (std::size_t place = 0; place < follow_.size(); ++place)
    if (!tool.near.holds(place) && sixteen.add(tool.tree, place) && !look()) return false;
  if (sixteen.count > 0 && !look()) return false;
  search_ = tool.near.search();
  // without the pyramid every point is followed, however far it reaches
  reach_ = plan_.empty_space ? reach : std::numeric_limits<double>::infinity();
  return true;
}

void LeftOutWork::gathered(const NearTool& tool, const Tolerances& lengths,
                           haptics::SurfaceRows& surface, Budget& budget) HAPTICS_RT {
  if (plan_.far_gradients || (gathered_ == tool.near.search() && plan_.still_rows)) return;
  gathered_ = tool.near.search();
  const ScalarField& field = tool.solid.field;
  const lanes::Affine map = field.affine(tool.X_WP);
  Sixteen sixteen;
  const auto look = [&]() HAPTICS_RT {
    const int n = sixteen.count;
    sixteen.count = 0;
    budget.spend(n * field.lanesWork().slopes);
    budget.counts.samples += n;
    budget.counts.gradients += n;
    lanes::Places u;
    lanes::place(map, sixteen.x.lane, sixteen.y.lane, sixteen.z.lane, n, u);
    lanes::Slopes found;
    field.slopes(u, n, false, found);
    for (int l = 0; l < n; ++l) {
      const Vec3 gradient{found.exact.x[l], found.exact.y[l], found.exact.z[l]};
      const double slope = gradient.norm();
      const double gap = (tool.solid.ceiling() - found.value[l]) / slope;
      if (!(gap <= lengths.band)) continue;
      // the gap may promise a surface that never comes
      ++budget.counts.samples;
      const Vec3 n_W = -gradient / slope;
      if (field.value(Vec3{u.x[l], u.y[l], u.z[l]} + field.indexStepOf(-n_W * lengths.band)) <
          tool.solid.isovalue)
        continue;
      surface.rows.push({n_W, tool.X_WP.linear() * Vec3{sixteen.x[l], sixteen.y[l], sixteen.z[l]},
                         gap - lengths.rest_gap});
    }
  };
  const auto add = [&](std::size_t place) HAPTICS_RT {
    if (sixteen.add(tool.tree, place)) look();
  };
  for (std::size_t i = 0; i < surface.near; ++i)
    if (tool.near.near(i).free > lengths.band)
      add(static_cast<std::size_t>(tool.near.near(i).place));
  for (std::size_t place = 0; place < follow_.size(); ++place)
    if (!tool.near.holds(place) && !tool.near.carries(tool.tree, place)) add(place);
  if (sixteen.count > 0) look();
}

void LeftOutWork::swept(const NearTool& tool, const Twist& motion, const Tolerances& lengths,
                        Sweep& sweep, Budget& budget) HAPTICS_RT {
  if (!plan_.looksAgain()) return;
  const ScalarField& field = tool.solid.field;
  // slabs as the sweep's: a chord of at most two voxels, and paths within the sagitta of theirs
  const double arm = *std::max_element(tool.tree.arm.begin(), tool.tree.arm.end());
  const double speed = motion.linear.norm() + motion.angular.norm() * arm;
  const double bend = haptics::sagitta(arm, motion.angular.norm());
  double duration = 1.0;
  if (speed > 0.0) duration = std::min(duration, Sweep::kSlab * field.voxel() / speed);
  if (bend > 0.0) duration = std::min(duration, std::sqrt(lengths.sagitta / bend));
  for (double begin = 0.0; begin < sweep.time();) {
    const double end = std::min(1.0, begin + duration);
    const Slab slab{begin, end, field.affine(haptics::moved(tool.X_WP, motion, begin)),
                    field.affine(haptics::moved(tool.X_WP, motion, end))};
    Sixteen sixteen;
    for (std::size_t i = 0; i < follow_count_; ++i)
      if (sixteen.add(tool.tree, follow_[i])) {
        follow(tool, slab, motion, sixteen, lengths, sweep, budget);
        sixteen.count = 0;
      }
    if (sixteen.count > 0) follow(tool, slab, motion, sixteen, lengths, sweep, budget);
    if (end >= 1.0) return;
    begin = end;
  }
}

}  // namespace study::plan
