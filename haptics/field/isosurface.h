// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/scalar_field.h"

namespace haptics {

/// The level set { p : F(p) = s } of a field, seen as a solid: inside is F >= s.
///
/// s - F is *not* a distance. Dividing by |grad F| gives one only to first order, and only near
/// the surface, so contact is decided by sign and located by root finding, never by value alone.
struct Isosurface {
  const ScalarField& field;
  double isovalue;

  /// A pose is legal if F is below this at every point: the isovalue less a rounding margin, so
  /// that another evaluator of F agrees.
  double ceiling() const HAPTICS_RT { return isovalue - field.roundingMargin(); }
  /// The surroundings of `n` places in index coordinates. Places at the faces of the grid or its
  /// crop are included.
  void survey(const lanes::Places& u, int n, lanes::Survey& found) const HAPTICS_RT;
  bool inside(const Vec3& p_W) const HAPTICS_RT {
    return field.value(field.indexOf(p_W)) >= ceiling();
  }
};

}  // namespace haptics
