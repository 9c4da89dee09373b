// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"

namespace haptics {

/// Which normal the row of a point near the surface has. The row of a contact that blocked has the
/// exact one of its cell whatever this says (README, "Normals").
enum class NormalKind {
  Central,  ///< central difference over one voxel, [Chan 2011], (1)
  Cell,     ///< the field's own gradient
  Spline    ///< gradient of the cubic B-spline with the voxels as coefficients
};

/// One shell point and the surface it met.
struct Contact {
  int point = 0;              ///< index into the shell
  Vec3 r_W = Vec3::Zero();    ///< the point about the tool's origin, in W [m]
  Vec3 n_W = Vec3::Zero();    ///< unit normal of the cell in which it met the surface, outwards
  double gap = 0.0;           ///< m along n left to the surface, to first order; negative inside
  Vec3 met_W = Vec3::Zero();  ///< where the point set off when it met it
  double met_gap = 0.0;       ///< the gap there
};

/// Contacts that sweep met and that stood in the way; kept from tick to tick until prune lets go
/// of them.
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
  double epsilon;   ///< how near counts as contact; the paper's epsilon
  double rest_gap;  ///< what a contact keeps between point and surface: half of epsilon
  double band;      ///< points nearer than this constrain the motion
  /// A motion that contacts shape is over when what is left of it is no more than this; as far
  /// before an impact a sub-step ends, so that rounding does not put a point inside.
  double least_way;
  /// A sub-step that an impact ends before this has not moved: what it met becomes a contact.
  double blocked;
  double sagitta;    ///< how far a path may leave its chord in collision detection
  double root;       ///< how finely a first crossing is found
  double step_free;  ///< longest sub-step
};

}  // namespace haptics
