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

/// The row of a near point. A wide gradient smooths the facets of the field; where it
/// vanishes, or points elsewhere than the cell's own gradient, that is taken (thin plates).
MotionRow rowOf(const Isosurface& solid, const RowCandidate& point,
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

/// Central differences for some of the chosen candidates, sixteen at most.
void widen(const ScalarField& field, std::span<const int> chosen, SurfaceRows& surface,
           Budget& budget) HAPTICS_RT {
  const auto n = static_cast<int>(chosen.size());
  const auto point = [&](int l) HAPTICS_RT -> RowCandidate& {
    return surface.candidates[static_cast<std::size_t>(chosen[static_cast<std::size_t>(l)])];
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

/// Makes rows, and continues with what a cut left. Every stage returns false if cut.
class Gathering {
 public:
  Gathering(const NearTool& tool, const Tolerances& lengths, NormalKind normal, const Plan& plan,
            SurfaceRows& surface, Budget& budget) HAPTICS_RT
      : tool_{tool},
        field_{tool.solid.field},
        lengths_{lengths},
        normal_{normal},
        // differences of a spline are dear, so they wait until the points are chosen
        later_{normal == NormalKind::Central && field_.kind() == FieldKind::CubicSpline},
        central_{!later_ && (normal == NormalKind::Central || !plan.central_differences)},
        surface_{surface},
        budget_{budget} {}

  /// The nearest points of each patch of the shell whose first-order gap lies in the band.
  bool look() HAPTICS_RT {
    const Clearance& near = tool_.near;
    const std::size_t end = near.nearestCount(surface_.near);
    const auto isFar = [&](std::size_t i) HAPTICS_RT {
      return near.nearest(surface_.near, i).free > lengths_.band;
    };
    const auto pass = [&](std::size_t i) HAPTICS_RT {
      while (i < end && isFar(i)) ++i;
      return i;
    };
    const auto some = [&](std::size_t i) HAPTICS_RT {
      Sixteen sixteen;
      for (; i < end && sixteen.count < lanes::kLanes; ++i) {
        if (isFar(i)) continue;
        const auto place = static_cast<std::size_t>(near.nearest(surface_.near, i).place);
        sixteen.x[sixteen.count] = tool_.tree.x[place];
        sixteen.y[sixteen.count] = tool_.tree.y[place];
        sixteen.z[sixteen.count] = tool_.tree.z[place];
        ++sixteen.count;
      }
      lookAt(sixteen);
      return i;
    };
    return surface_.looked.through(end, budget_, pass, some);
  }

  /// Of too many candidates, those with the least gaps and the outermost.
  bool choose() HAPTICS_RT {
    const auto& candidates = surface_.candidates;
    const std::size_t count = candidates.size();
    FixedVector<int, kMostSurfaceRows>& chosen = surface_.chosen;
    if (count <= kMostSurfaceRows) {
      for (std::size_t i = 0; i < count; ++i) chosen.push(static_cast<int>(i));
      return true;
    }
    // the outermost along the thirteen axes of a cube, either way
    std::array<double, Clearance::kFew> along;
    const auto eitherWay = [&](std::size_t direction) HAPTICS_RT {
      budget_.spend(static_cast<std::int64_t>(count) / kCandidatesOfAUnit);
      const std::size_t d = direction / 2;
      const double ax = double(d % 3) - 1, ay = double(d / 3 % 3) - 1, az = double(d / 9) - 1;
      for (std::size_t i = 0; i < count; ++i)
        along[i] =
            ax * candidates[i].r_W.x() + ay * candidates[i].r_W.y() + az * candidates[i].r_W.z();
      const auto [low, high] =
          std::minmax_element(along.begin(), along.begin() + std::ptrdiff_t(count));
      surface_.outermost[direction] = static_cast<int>(low - along.begin());
      surface_.outermost[direction + 1] = static_cast<int>(high - along.begin());
      return direction + 2;
    };
    if (!surface_.directions.through(surface_.outermost.size(), budget_, eitherWay)) return false;
    if (!budget_.left()) return false;
    budget_.spend(static_cast<std::int64_t>(count) / kCandidatesOfAUnit);
    struct Slot {
      double measure = std::numeric_limits<double>::infinity();
      int index = -1;
    };
    std::array<Slot, kNearest> nearest;
    for (std::size_t i = 0; i < count; ++i) {
      const double gap = candidates[i].gap;
      if (gap >= nearest.back().measure) continue;
      auto slot = nearest.end() - 1;
      for (; slot != nearest.begin() && (slot - 1)->measure > gap; --slot) *slot = *(slot - 1);
      *slot = {gap, static_cast<int>(i)};
    }
    const auto take = [&](int i) HAPTICS_RT {
      if (std::find(chosen.begin(), chosen.end(), i) == chosen.end()) chosen.push(i);
    };
    for (const Slot& slot : nearest) take(slot.index);
    for (const int i : surface_.outermost) take(i);
    return true;
  }

  /// The rows of the chosen, sixteen at a time.
  bool write() HAPTICS_RT {
    const std::span<const int> chosen{surface_.chosen.begin(), surface_.chosen.size()};
    const auto write = [&](std::size_t first) HAPTICS_RT {
      const auto some =
          chosen.subspan(first, std::min<std::size_t>(lanes::kLanes, chosen.size() - first));
      if (later_) widen(field_, some, surface_, budget_);
      for (const int i : some) {
        RowCandidate& point = surface_.candidates[static_cast<std::size_t>(i)];
        if (normal_ == NormalKind::Spline) {
          budget_.spend(ScalarField::kSplineWork);
          ++budget_.counts.gradients;
          point.wide_W = field_.splineGradient(point.u);
        }
        surface_.rows.push(rowOf(tool_.solid, point, lengths_));
      }
      return first + some.size();
    };
    return surface_.written.through(chosen.size(), budget_, write);
  }

 private:
  /// Some near points, sixteen at most, by coordinate.
  struct Sixteen {
    lanes::Numbers x{}, y{}, z{};
    int count = 0;
  };

  void lookAt(const Sixteen& some) HAPTICS_RT {
    const int n = some.count;
    const ScalarField::LanesWork work = field_.lanesWork();
    budget_.spend(n * (central_ ? work.central_slopes : work.slopes));
    budget_.counts.samples += n * (central_ ? 7 : 1);
    budget_.counts.gradients += n * (central_ ? 2 : 1);
    lanes::Places u;
    lanes::place(field_.affine(tool_.X_WP), some.x.lane, some.y.lane, some.z.lane, n, u);
    lanes::Slopes found;
    field_.slopes(u, n, central_, found);
    for (int l = 0; l < n; ++l) {
      const Vec3 exact{found.exact.x[l], found.exact.y[l], found.exact.z[l]};
      const double slope = exact.norm();
      const double gap = slope > 0.0 ? (tool_.solid.ceiling() - found.value[l]) / slope
                                     : std::numeric_limits<double>::infinity();
      if (gap > lengths_.band) continue;
      surface_.candidates.push(
          {tool_.X_WP.linear() * Vec3{some.x[l], some.y[l], some.z[l]},
           Vec3{u.x[l], u.y[l], u.z[l]}, gap, found.value[l], exact,
           normal_ == NormalKind::Central && central_
               ? Vec3{found.central.x[l], found.central.y[l], found.central.z[l]}
               : exact});
    }
  }

  /// A unit of work is that many candidates, looked at along a direction.
  static constexpr std::int64_t kCandidatesOfAUnit = 4;

  const NearTool& tool_;
  const ScalarField& field_;
  const Tolerances& lengths_;
  const NormalKind normal_;
  const bool later_, central_;
  SurfaceRows& surface_;
  Budget& budget_;
};

}  // namespace

bool gatherRows(const NearTool& tool, const Tolerances& lengths, NormalKind normal,
                const Plan& plan, SurfaceRows& surface, Budget& budget) HAPTICS_RT {
  using Stage = SurfaceRows::Stage;
  const bool still = surface.search == tool.near.search();
  if (!still || surface.stage == Stage::Done) {
    if (still && plan.still_rows) return true;
    if (!still) surface.near = tool.near.size();
    surface.search = tool.near.search();
    surface.stage = Stage::Look;
    surface.looked = surface.directions = surface.written = {};
    surface.rows.clear();
    surface.candidates.clear();
    surface.chosen.clear();
  }
  Gathering gathering{tool, lengths, normal, plan, surface, budget};
  if (surface.stage == Stage::Look) {
    if (!gathering.look()) return false;
    surface.stage = Stage::Choose;
  }
  if (surface.stage == Stage::Choose) {
    if (!gathering.choose()) return false;
    surface.stage = Stage::Write;
  }
  if (!gathering.write()) return false;
  surface.stage = Stage::Done;
  return true;
}

void joinRows(const Contacts& contacts, const SurfaceRows& surface, const Tolerances& lengths,
              MotionRows& rows) HAPTICS_RT {
  rows.clear();
  for (const Contact& contact : contacts)
    rows.push({contact.n_W, contact.r_W, room(contact.gap, lengths)});
  for (const MotionRow& row : surface.rows) rows.push(row);
}

}  // namespace haptics
