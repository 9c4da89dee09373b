// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/motion_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace haptics {
namespace {

constexpr std::size_t kNearest = 22;  // points with the least gaps; 26 more are the outermost

/// How much a contact with this gap leaves to the motion; from inside it must leave, in reason.
double room(double gap, const Tolerances& lengths) HAPTICS_RT {
  const double h = lengths.step_near;
  return gap >= 0.0 ? gap - lengths.rest_gap : -std::min(lengths.rest_gap - gap, 2.0 * h);
}

/// The row of a near point. The central difference smooths the facets of the field; where it
/// vanishes, or points elsewhere than the cell's own gradient, that is taken (thin plates).
bool rowOf(const Isosurface& solid, const NearPoint& near, const Tolerances& lengths,
           MotionRow& row, Budget& budget) HAPTICS_RT {
  budget.spend(6);
  const double slope = near.gradient_W.norm();
  if (!(slope > 0.0)) return false;
  const Vec3 central = solid.field.centralGradient(near.u);
  const double central_slope = central.norm();
  const double along = central_slope > 0.0 ? central.dot(near.gradient_W) / central_slope : 0.0;
  constexpr double kCos30 = 0.8660254037844386;
  row.r_W = near.r_W;
  if (central_slope < 0.3 * slope || along < kCos30 * slope) {
    row.n_W = -near.gradient_W / slope;
    row.room = room((solid.ceiling() - near.value) / slope, lengths);
  } else {
    row.n_W = -central / central_slope;
    row.room = room((solid.ceiling() - near.value) / std::max(central_slope, along), lengths);
  }
  return true;
}

}  // namespace

void gatherRows(const Isosurface& solid, const Clearance& near, const Contacts& contacts,
                const Tolerances& lengths, MotionRows& rows, Budget& budget) HAPTICS_RT {
  rows.clear();
  for (const Contact& contact : contacts)
    rows.push({contact.n_W, contact.r_W, room(contact.gap, lengths)});

  // a point counts when its first-order gap lies in the band
  const auto gapOf = [&](const NearPoint& p) {
    const double slope = p.gradient_W.norm();
    return slope > 0.0 ? (solid.ceiling() - p.value) / slope
                       : std::numeric_limits<double>::infinity();
  };
  FixedVector<int, kMostMotionRows> chosen;
  const auto choose = [&](int i) {
    if (std::find(chosen.begin(), chosen.end(), i) == chosen.end()) chosen.push(i);
  };
  struct Candidate {
    double gap = std::numeric_limits<double>::infinity();
    int index = -1;
  };
  std::array<Candidate, kNearest> nearest;
  std::array<Candidate, 26> outermost;  // `gap` holds minus the extent
  int count = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const NearPoint& p = near.near(i);
    const double gap = gapOf(p);
    if (gap > lengths.band) continue;
    ++count;
    const int index = static_cast<int>(i);
    if (gap < nearest.back().gap) {
      auto slot = nearest.end() - 1;
      for (; slot != nearest.begin() && (slot - 1)->gap > gap; --slot) *slot = *(slot - 1);
      *slot = {gap, index};
    }
    if (near.size() <= kNearest) continue;
    for (int d = 0; d < 26; ++d) {
      const int way = d + (d >= 13 ? 1 : 0);
      const double extent =
          p.r_W.dot(Vec3{double(way % 3 - 1), double(way / 3 % 3 - 1), double(way / 9 - 1)});
      if (-extent < outermost[static_cast<std::size_t>(d)].gap)
        outermost[static_cast<std::size_t>(d)] = {-extent, index};
    }
  }
  for (const Candidate& c : nearest)
    if (c.index >= 0) choose(c.index);
  if (count > static_cast<int>(kNearest))
    for (const Candidate& c : outermost)
      if (c.index >= 0) choose(c.index);
  for (const int i : chosen) {
    MotionRow row;
    if (rowOf(solid, near.near(static_cast<std::size_t>(i)), lengths, row, budget) &&
        !rows.push(row))
      break;
  }
}

}  // namespace haptics
