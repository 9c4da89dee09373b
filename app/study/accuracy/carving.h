// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "haptics/carving/burr.h"
#include "haptics/core/volume.h"
#include "haptics/proxy/cutting.h"

namespace study::accuracy {

/// A way to remove the material that a ball sweeps.
struct Carver {
  std::string method;
  /// Carries out a cut in `voxels`, which are those of the volume but for the cuts before. Returns
  /// the volume removed [m3].
  std::function<double(const haptics::Volume& volume, void* voxels, const haptics::BurrCut& cut)>
      cut;
};
/// The burr; a ball with an edge of one voxel, each voxel in part by its distance to the wall; and
/// whole voxels, each removed if its centre is in the ball, as other programs do.
const std::vector<Carver>& carvers();

/// ball, groove, cavity: what a ball leaves at rest, along a line, and over a square.
const std::vector<std::string>& carvedShapes();

/// How much is carved.
struct CarvingEffort {
  std::vector<double> radii = {1.5, 2.0, 3.0, 4.0, 6.0, 10.0, 15.0};  ///< voxels
  int trials = 10;                                                    ///< places of each shape
  int rays = 600;                                                     ///< to each wall
};

/// Place, normal and volume of what each carver leaves of a solid, against the ideal shape, and the
/// time of a cut. The first carver is held to bounds, in every material; the others cut the first
/// material only.
Outcome carvings(const std::vector<Carver>& all, const std::string& shape,
                 const CarvingEffort& effort, unsigned seed);

/// Where the wall of a ball lies at another isovalue than that at which it was cut.
Outcome carvedAtOtherIsovalues(const Carver& carver, const CarvingEffort& effort, unsigned seed);

/// The law of removal of the studied presses.
haptics::CutLaw pressedLaw();

/// Presses of a burr into a half-space.
struct RateEffort {
  std::vector<double> forces = {0.5, 1.0, 2.0, 5.0, 10.0};  ///< N
  std::vector<int> rates = {500, 1000, 4000};               ///< Hz
};
/// The volume that a burr of this law removes in the tick, against that of pressedLaw() at the
/// force of the device, and the depth of the hole.
Outcome carvingRates(const haptics::CutLaw& law, const RateEffort& effort);

}  // namespace study::accuracy
