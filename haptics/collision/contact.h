// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"

namespace haptics {

/// The normal in the row of a point near the surface. The row of a contact that blocked always has
/// the exact normal of its cell (haptics/README.md, "Normals").
enum class NormalKind {
  Central,  ///< central difference over one voxel, [Chan 2011], (1)
  Cell,     ///< the field's own gradient
  Spline    ///< gradient of the cubic B-spline with the voxels as coefficients
};

/// A shell point and the surface that it met.
struct Contact {
  int point = 0;            ///< index into the shell
  Vec3 r_W = Vec3::Zero();  ///< vector from the tool's origin to the point, in W [m]
  /// Unit normal of the cell in which the point met the surface, outwards.
  Vec3 n_W = Vec3::Zero();
  double gap = 0.0;  ///< m, distance to the surface along n, to first order; negative inside
  /// Position of the point at the start of the motion that met the surface.
  Vec3 met_W = Vec3::Zero();
  double met_gap = 0.0;  ///< the gap at met_W
};

/// Contacts that Sweep found and that stood in the way. They are kept until prune() drops them.
using Contacts = FixedVector<Contact, 24>;

/// Lengths of the algorithm, all derived from the voxel h [m]; `epsilon` in voxels.
struct Tolerances {
  explicit Tolerances(double h, double epsilon_voxels = 0.05)
      : voxel{h},
        epsilon{epsilon_voxels * h},
        rest_gap{0.5 * epsilon},
        band{2.0 * epsilon},
        least_way{0.02 * epsilon},
        blocked{0.05 * rest_gap},
        sagitta{3e-4 * h},
        root{1e-5 * h},
        step_free{24.0 * h} {}
  double voxel;     ///< h
  double epsilon;   ///< distance that counts as contact; the paper's epsilon
  double rest_gap;  ///< gap that a contact keeps between point and surface: half of epsilon
  double band;      ///< points nearer than this constrain the motion
  /// A motion that contacts shape ends when no more than this remains. A sub-step ends this far
  /// before an impact, so that rounding puts no point inside.
  double least_way;
  /// A sub-step that an impact ends within this way counts as not moved: it is blocked, and its
  /// impact becomes a contact.
  double blocked;
  double sagitta;    ///< largest distance of a path from its chord in collision detection
  double root;       ///< tolerance of a first crossing
  double step_free;  ///< longest sub-step
};

}  // namespace haptics
