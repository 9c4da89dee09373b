// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/motion_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace haptics {
namespace {

constexpr std::size_t kNearest = 22;  // points with the least gaps; 26 more are the outermost

/// How much a contact with this gap leaves to the motion; from inside it must leave, in reason.
double room(double gap, const Tolerances& lengths) HAPTICS_RT {
  const double h = lengths.voxel;
  return gap >= 0.0 ? gap - lengths.rest_gap : -std::min(lengths.rest_gap - gap, 2.0 * h);
}

/// A near point within the band.
struct Candidate {
  Vec3 r_W;
  Vec3 u;      // index coordinates
  double gap;  // to first order [m]
  double value;
  Vec3 exact_W, wide_W;  // gradients, per metre
};

/// The row of a near point. A wide gradient smooths the facets of the field; where it
/// vanishes, or points elsewhere than the cell's own gradient, that is taken (thin plates).
MotionRow rowOf(const Isosurface& solid, const Candidate& point,
                const Tolerances& lengths) HAPTICS_RT {
  const double slope = point.exact_W.norm(), wide_slope = point.wide_W.norm();
  const double along = wide_slope > 0.0 ? point.wide_W.dot(point.exact_W) / wide_slope : 0.0;
  constexpr double kCos30 = 0.8660254037844386;
  const double below = solid.ceiling() - point.value;
  if (wide_slope < 0.3 * slope || along < kCos30 * slope)
    return {-point.exact_W / slope, point.r_W, room(below / slope, lengths)};
  return {-point.wide_W / wide_slope, point.r_W,
          room(below / std::max(wide_slope, along), lengths)};
}

/// Central differences for those of the candidates that are chosen, sixteen at a time.
template <class Chosen>
void widen(const ScalarField& field, const Chosen& chosen, std::span<Candidate> within,
           Budget& budget) HAPTICS_RT {
  for (std::size_t first = 0; first < chosen.size(); first += lanes::kLanes) {
    const auto n = static_cast<int>(std::min<std::size_t>(lanes::kLanes, chosen.size() - first));
    const auto point = [&](int l) HAPTICS_RT -> Candidate& {
      return within[static_cast<std::size_t>(chosen[first + static_cast<std::size_t>(l)])];
    };
    lanes::Places u;
    for (int l = 0; l < n; ++l) {
      u.x[l] = point(l).u.x();
      u.y[l] = point(l).u.y();
      u.z[l] = point(l).u.z();
    }
    lanes::Slopes found;
    field.slopes(u, n, true, found);
    budget.spend(n * field.lanesWork().central_slopes);
    budget.counts.samples += 6 * n;
    budget.counts.gradients += n;
    for (int l = 0; l < n; ++l)
      point(l).wide_W = {found.central.x[l], found.central.y[l], found.central.z[l]};
  }
}

}  // namespace

void gatherRows(const NearTool& tool, const Tolerances& lengths, NormalKind normal,
                const Plan& plan, SurfaceRows& surface, Budget& budget) HAPTICS_RT {
  const Isosurface& solid = tool.solid;
  const ShellTree& tree = tool.tree;
  const Clearance& near = tool.near;
  const bool still = surface.search == near.search();
  if (still && plan.still_rows) return;
  if (!still) surface.near = near.size();
  surface.search = near.search();
  surface.rows.clear();

  // the nearest point of each patch of the shell, if its first-order gap lies in the band
  std::array<Candidate, Clearance::kFew> within;
  std::size_t within_count = 0;
  lanes::Numbers x{}, y{}, z{};
  int count = 0;
  const lanes::Affine map = solid.field.affine(tool.X_WP);
  // differences of a spline are dear, so they wait until the points are chosen
  const bool later = normal == NormalKind::Central && solid.field.kind() == FieldKind::CubicSpline;
  const bool central = !later && (normal == NormalKind::Central || !plan.central_differences);
  const auto look = [&]() HAPTICS_RT {
    const ScalarField::LanesWork work = solid.field.lanesWork();
    budget.spend(count * (central ? work.central_slopes : work.slopes));
    budget.counts.samples += count * (central ? 7 : 1);
    budget.counts.gradients += count * (central ? 2 : 1);
    lanes::Places u;
    lanes::place(map, x.lane, y.lane, z.lane, count, u);
    lanes::Slopes found;
    solid.field.slopes(u, count, central, found);
    for (int l = 0; l < count; ++l) {
      const Vec3 exact{found.exact.x[l], found.exact.y[l], found.exact.z[l]};
      const double slope = exact.norm();
      const double gap = slope > 0.0 ? (solid.ceiling() - found.value[l]) / slope
                                     : std::numeric_limits<double>::infinity();
      if (gap > lengths.band || within_count == within.size()) continue;
      within[within_count++] = {
          tool.X_WP.linear() * Vec3{x[l], y[l], z[l]},
          Vec3{u.x[l], u.y[l], u.z[l]},
          gap,
          found.value[l],
          exact,
          normal == NormalKind::Central && central
              ? Vec3{found.central.x[l], found.central.y[l], found.central.z[l]}
              : exact};
    }
    count = 0;
  };
  near.eachNearest(surface.near, [&](const NearPoint& point) HAPTICS_RT {
    if (point.free > lengths.band) return;
    const auto place = static_cast<std::size_t>(point.place);
    x[count] = tree.x[place];
    y[count] = tree.y[place];
    z[count] = tree.z[place];
    if (++count == lanes::kLanes) look();
  });
  if (count > 0) look();

  // of too many, those with the least gaps and the outermost
  FixedVector<int, kMostSurfaceRows> chosen;
  const auto choose = [&](int i) HAPTICS_RT {
    if (std::find(chosen.begin(), chosen.end(), i) == chosen.end()) chosen.push(i);
  };
  if (within_count <= kNearest + 26) {
    for (std::size_t i = 0; i < within_count; ++i) chosen.push(static_cast<int>(i));
  } else {
    struct Slot {
      double measure = std::numeric_limits<double>::infinity();
      int index = -1;
    };
    std::array<Slot, kNearest> nearest;
    for (std::size_t i = 0; i < within_count; ++i) {
      const double gap = within[i].gap;
      if (gap >= nearest.back().measure) continue;
      auto slot = nearest.end() - 1;
      for (; slot != nearest.begin() && (slot - 1)->measure > gap; --slot) *slot = *(slot - 1);
      *slot = {gap, static_cast<int>(i)};
    }
    // the outermost along the thirteen axes of a cube, either way
    std::array<double, Clearance::kFew> along;
    std::array<int, 26> outermost;
    for (int d = 0; d < 13; ++d) {
      const double ax = d % 3 - 1, ay = d / 3 % 3 - 1, az = d / 9 - 1;
      for (std::size_t i = 0; i < within_count; ++i)
        along[i] = ax * within[i].r_W.x() + ay * within[i].r_W.y() + az * within[i].r_W.z();
      const auto [low, high] =
          std::minmax_element(along.begin(), along.begin() + std::ptrdiff_t(within_count));
      outermost[static_cast<std::size_t>(2 * d)] = static_cast<int>(low - along.begin());
      outermost[static_cast<std::size_t>(2 * d + 1)] = static_cast<int>(high - along.begin());
    }
    for (const Slot& slot : nearest) choose(slot.index);
    for (const int i : outermost) choose(i);
  }
  if (later) widen(solid.field, chosen, within, budget);
  for (const int i : chosen) {
    Candidate& point = within[static_cast<std::size_t>(i)];
    if (normal == NormalKind::Spline) {
      budget.spend(ScalarField::kSplineWork);
      ++budget.counts.gradients;
      point.wide_W = solid.field.splineGradient(point.u);
    }
    surface.rows.push(rowOf(solid, point, lengths));
  }
}

void joinRows(const Contacts& contacts, const SurfaceRows& surface, const Tolerances& lengths,
              MotionRows& rows) HAPTICS_RT {
  rows.clear();
  for (const Contact& contact : contacts)
    rows.push({contact.n_W, contact.r_W, room(contact.gap, lengths)});
  for (const MotionRow& row : surface.rows) rows.push(row);
}

}  // namespace haptics
