// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/study/rivals/near_points.h"

namespace rivals {

/// What [Ortega 2007] and [Wan 2003] leave to whoever uses them. The defaults are the best that the
/// sweep of README.md found.
struct GodObjectSettings {
  /// Stiffness of a point that is inside over that of the coupling.
  double penalty = 300.0;
  double skin = 0.2;     ///< voxels that points are kept outside the surface
  int sub_steps = 8;     ///< motions in a tick
  double stride = 0.25;  ///< voxels that a point goes in a motion, at most
};

/// What one tick leaves to the next.
struct GodObjectState {
  Pose X_WP = Pose::Identity();
  int contacts = 0;         ///< rows that held it back, or points inside, in the last motion
  std::int64_t pivots = 0;  ///< of all projections so far
  int sub_steps = 0;        ///< motions of the last tick
  std::vector<NearPoint> near = {};
};

/// A tick of a god object without mass. While every point is outside it makes the motion nearest to
/// that to the device which the points near the surface allow, by Gauss' principle of least
/// constraint [Ortega 2007]. Once a point is inside, it moves to the static equilibrium of the
/// coupling and of springs at the points inside, linearised at its pose [Wan 2003]. No point
/// goes farther than `stride` at a time, and collisions are looked for at the ends of motions.
Wrench godObjectTick(const reference::Scene& scene, const GodObjectSettings& settings,
                     const Pose& X_WD, GodObjectState& state);

}  // namespace rivals
