// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "haptics/field/isosurface.h"
#include "haptics/field/scalar_field.h"
#include "haptics/field/spline_lanes.h"

namespace haptics {
namespace {

Vec3 placeIn(const lanes::Places& u, int l) HAPTICS_RT { return {u.x[l], u.y[l], u.z[l]}; }

void put(const Vec3& v, int l, lanes::Places& to) HAPTICS_RT {
  to.x[l] = v.x();
  to.y[l] = v.y();
  to.z[l] = v.z();
}

}  // namespace

lanes::Affine ScalarField::affine(const Pose& X_WP) const HAPTICS_RT {
  const Mat3 A = A_VW_ * X_WP.linear();
  const Vec3 b = indexOf(X_WP.translation());
  lanes::Affine map;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) map.A[row][column] = A(row, column);
    map.b[row] = b[row];
  }
  return map;
}

void ScalarField::clear(const lanes::Chords& chords, int n, lanes::Numbers& until,
                        std::int64_t& cells) const HAPTICS_RT {
  const auto clear = kind_ == FieldKind::Trilinear ? lanes::clear : lanes::spline::clear;
  clear(lattice_, chords, n, until, cells);
}

void ScalarField::slopes(const lanes::Places& u, int n, bool central,
                         lanes::Slopes& found) const HAPTICS_RT {
  const auto slopes = kind_ == FieldKind::Trilinear ? lanes::slopes : lanes::spline::slopes;
  slopes(lattice_, u, n, central, found);
  for (int l = 0; l < n; ++l) {
    if (!(found.edge >> l & 1)) {
      put(worldGradient(placeIn(found.exact, l)), l, found.exact);
      if (central) put(worldGradient(placeIn(found.central, l)), l, found.central);
      continue;
    }
    const FieldSample here = sample(placeIn(u, l));
    found.value[l] = here.value;
    put(here.gradient_W, l, found.exact);
    if (central) put(centralGradient(placeIn(u, l)), l, found.central);
  }
}

void Isosurface::survey(const lanes::Places& u, int n, lanes::Survey& found) const HAPTICS_RT {
  const auto survey = field.kind() == FieldKind::Trilinear ? lanes::survey : lanes::spline::survey;
  survey(field.lattice(), u, n, ceiling(), found);
  for (int l = 0; l < n; ++l) {
    const bool empty = found.empty >> l & 1;
    if (!empty && !(found.edge >> l & 1)) continue;
    // the coarser levels, and what the lanes leave out
    const Vec3 place = placeIn(u, l);
    const MaxPyramid::Bound bound = field.pyramid().bound(place, ceiling());
    found.free[l] = bound.radius;
    found.lipschitz[l] = bound.lipschitz;
    if (bound.lipschitz == 0.0) {
      found.empty |= 1U << l;
      found.value[l] = -std::numeric_limits<double>::infinity();
      continue;
    }
    found.value[l] = field.value(place);
    found.free[l] = std::clamp((ceiling() - found.value[l]) / bound.lipschitz, 0.0, bound.radius);
  }
}

}  // namespace haptics
