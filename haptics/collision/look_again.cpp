// SPDX-License-Identifier: BSD-3-Clause
// What a plan would leave out of collision detection, where it is switched off: looked at beside
// the rest, so that the rest does not change unless something is found.
#include <algorithm>
#include <limits>

#include "haptics/collision/clearance.h"
#include "haptics/collision/sweep.h"

namespace haptics {
namespace {

/// Points on their way to be looked at together.
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

/// The values at places, whatever the pyramid knows of them.
void sampled(const ScalarField& field, const lanes::Places& u, int n,
             lanes::Survey& found) HAPTICS_RT {
  std::uint32_t alone = ~0U;
  if (field.kind() == FieldKind::Trilinear) {
    // no block is below a level that none can be below
    lanes::survey(field.lattice(), u, n, -std::numeric_limits<double>::infinity(), found);
    alone = found.edge;
  }
  for (int l = 0; l < n; ++l)
    if (alone >> l & 1) found.value[l] = field.value({u.x[l], u.y[l], u.z[l]});
}

}  // namespace

/// Once near() is complete: every point that is not in it. False if one is inside.
bool Clearance::lookAgain(const Isosurface& solid, const ShellTree& tree, const Pose& X_WP,
                          double reach, Budget& budget) HAPTICS_RT {
  if (again_complete_ >= reach) return true;
  const ScalarField& field = solid.field;
  const lanes::Affine map = field.affine(X_WP);
  Sixteen sixteen;
  const auto look = [&]() HAPTICS_RT {
    const int n = sixteen.count;
    sixteen.count = 0;
    budget.spend(field.kind() == FieldKind::Trilinear ? n : n * field.work());
    lanes::Places u;
    lanes::place(map, sixteen.x.lane, sixteen.y.lane, sixteen.z.lane, n, u);
    lanes::Survey found;
    if (plan_.empty_space)
      solid.survey(u, n, found);
    else
      sampled(field, u, n, found);
    budget.counts.samples += plan_.empty_space ? found.lookedUp(n) : n;
    for (int l = 0; l < n; ++l) {
      if (found.value[l] >= solid.ceiling()) return false;
      if (!plan_.empty_space || found.free[l] >= reach) continue;
      again_[again_count_++] = sixteen.place[l];
      again_in_[sixteen.place[l]] = search_;
    }
    return true;
  };
  const int end = static_cast<int>(tree.nodes.size());
  for (int n = 0; n < end;) {
    const ShellTree::Node& node = tree.nodes[static_cast<std::size_t>(n)];
    if (plan_.empty_space && !node.leaf) {
      budget.spend(2);
      const MaxPyramid::Bound bound =
          field.pyramid().bound(field.indexOf(X_WP * node.centre), solid.ceiling());
      if (bound.lipschitz == 0.0 && bound.radius - node.radius >= reach) {
        n = node.next;
        continue;
      }
    }
    ++n;
    if (!node.leaf) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      const auto place = static_cast<std::size_t>(i);
      if (found_in_[place] == search_ || again_in_[place] == search_) continue;
      if (sixteen.add(tree, place) && !look()) {
        restart();
        return false;
      }
    }
  }
  if (sixteen.count > 0 && !look()) {
    restart();
    return false;
  }
  // without the pyramid all of them were looked at, however far they reach
  again_complete_ = plan_.empty_space ? reach : std::numeric_limits<double>::infinity();
  return true;
}

/// What the slab leaves out, up to the earliest impact so far. The level is that of a crossing
/// that rounding cannot have made, without the guard against the sagitta: a chord between two
/// places that are proven free is free.
void Sweep::lookAgain(const Isosurface& solid, const ShellTree& tree, const Clearance& near,
                      const Slab& slab, const Tolerances& lengths, Budget& budget) HAPTICS_RT {
  const ScalarField& field = solid.field;
  Sixteen sixteen;
  const auto look = [&]() HAPTICS_RT {
    const int n = sixteen.count;
    sixteen.count = 0;
    lanes::Chords chords;
    lanes::place(slab.at_begin, sixteen.x.lane, sixteen.y.lane, sixteen.z.lane, n, chords.a);
    lanes::place(slab.at_end, sixteen.x.lane, sixteen.y.lane, sixteen.z.lane, n, chords.b);
    double share[lanes::kLanes], path[lanes::kLanes];
    for (int l = 0; l < n; ++l) {
      path[l] = (speed_ + turn_ * tree.arm[sixteen.place[l]]) * (slab.end - slab.begin);
      // an impact is known to be as late as its root is fine: what is later does not count
      share[l] = 1.0;
      if (time_ < slab.end)
        share[l] = std::max(0.0, (time_ - slab.begin) / (slab.end - slab.begin) -
                                     lengths.root / std::max(path[l], lengths.root));
      chords.b.x[l] = chords.a.x[l] + share[l] * (chords.b.x[l] - chords.a.x[l]);
      chords.b.y[l] = chords.a.y[l] + share[l] * (chords.b.y[l] - chords.a.y[l]);
      chords.b.z[l] = chords.a.z[l] + share[l] * (chords.b.z[l] - chords.a.z[l]);
      chords.from[l] = 0.0;
      chords.level[l] = solid.isovalue;
    }
    lanes::Numbers until;
    std::int64_t cells = 0;
    field.clear(chords, n, until, cells);
    budget.spend(n + 2 * cells);
    budget.counts.samples += cells;
    for (int l = 0; l < n; ++l) {
      if (until[l] >= 1.0) continue;
      const Vec3 a{chords.a.x[l], chords.a.y[l], chords.a.z[l]},
          b{chords.b.x[l], chords.b.y[l], chords.b.z[l]};
      const double reach = field.firstReach(a + until[l] * (b - a), b, solid.isovalue,
                                            lengths.root / std::max(path[l], lengths.root), budget);
      if (reach > 1.0) continue;
      const double time =
          slab.begin + (until[l] + reach * (1.0 - until[l])) * share[l] * (slab.end - slab.begin);
      if (time >= time_) continue;
      time_ = time;
      met_ = static_cast<int>(sixteen.place[l]);
    }
  };
  near.eachAgain([&](std::size_t place) HAPTICS_RT {
    if (sixteen.add(tree, place)) look();
  });
  if (sixteen.count > 0) look();
}

}  // namespace haptics
